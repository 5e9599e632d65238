//! Joints: impulse joints and multibody joints.

use crate::fault::{Fault, finite, non_negative};
use crate::handle::Handle;
use crate::memory::{self, number, put_list, put_number, put_rotation, put_vector, vector};
#[cfg(not(feature = "dim2"))]
use crate::rapier::dynamics::SphericalJoint;
use crate::rapier::dynamics::{
    FixedJoint, GenericJoint, ImpulseJointHandle, JointAxesMask, JointAxis, MotorModel,
    MultibodyJointHandle, PrismaticJoint, RevoluteJoint, RigidBodyHandle, RopeJoint, SpringJoint,
};
use crate::rapier::math::{Pose, Real};
use crate::rapier::pipeline::PhysicsWorld;
use crate::registry::{body, read, write};
use crate::transmission;

/// The kinds of joints: the numbers of `JointType` in TypeScript.
pub mod kind {
    pub const REVOLUTE: u32 = 0;
    pub const FIXED: u32 = 1;
    pub const PRISMATIC: u32 = 2;
    pub const ROPE: u32 = 3;
    pub const SPRING: u32 = 4;
    pub const SPHERICAL: u32 = 5;
    pub const GENERIC: u32 = 6;
    pub const GEAR: u32 = 7;
    pub const RACK: u32 = 8;
    pub const PULLEY: u32 = 9;
}

/// The axes in the order of `JointAxis` in TypeScript.
#[cfg(feature = "dim2")]
const AXES: [JointAxis; 3] = [JointAxis::LinX, JointAxis::LinY, JointAxis::AngX];
/// The axes in the order of `JointAxis` in TypeScript.
#[cfg(not(feature = "dim2"))]
const AXES: [JointAxis; 6] = [
    JointAxis::LinX,
    JointAxis::LinY,
    JointAxis::LinZ,
    JointAxis::AngX,
    JointAxis::AngY,
    JointAxis::AngZ,
];

fn axis(number: u32) -> Result<JointAxis, Fault> {
    let axis = AXES.get(number as usize).copied();
    axis.ok_or_else(|| Fault::number("the joint axis", number.into(), "a JointAxis"))
}

/// The mask of TypeScript, which has the values of 3D in both dimensions.
fn axes(bits: u32) -> JointAxesMask {
    let bits = if cfg!(feature = "dim2") { (bits & 0b11) | ((bits >> 3) & 1) << 2 } else { bits };
    JointAxesMask::from_bits_truncate(bits as u8)
}

/// A hinge. In 3D its axes are in places 2 and 3.
#[cfg(feature = "dim2")]
fn revolute() -> Result<GenericJoint, Fault> {
    Ok(RevoluteJoint::new().data)
}

/// A hinge. In 3D its axes are in places 2 and 3.
#[cfg(not(feature = "dim2"))]
fn revolute() -> Result<GenericJoint, Fault> {
    let mut joint = RevoluteJoint::new(memory::direction(2, "axis1")?).data;
    joint.try_set_local_axis2(memory::direction(3, "axis2")?).map_err(Fault::invalid)?;
    Ok(joint)
}

/// A ball joint.
#[cfg(feature = "dim2")]
fn spherical() -> Result<GenericJoint, Fault> {
    Err(Fault::invalid("two dimensions have no spherical joints"))
}

/// A ball joint.
#[cfg(not(feature = "dim2"))]
fn spherical() -> Result<GenericJoint, Fault> {
    Ok(SphericalJoint::new().data)
}

/// A joint from the scratch block: anchors, axes or frames, then length, stiffness, damping and ratio, then
/// limits and radius, then points of the world.
fn description(kind_number: u32, mask: u32, has_limits: u32) -> Result<GenericJoint, Fault> {
    let (anchor1, anchor2) = (vector(0, "anchor1")?, vector(1, "anchor2")?);
    let [length, stiffness, damping] = [0, 1, 2].map(|component| number(4, component));
    let mut joint = match kind_number {
        kind::REVOLUTE => revolute()?,
        kind::FIXED => {
            let mut joint = FixedJoint::new().data;
            let (frame1, frame2) = (memory::rotation(2, "frame1")?, memory::rotation(3, "frame2")?);
            joint.set_local_frame1(Pose::from_parts(anchor1, frame1));
            joint.set_local_frame2(Pose::from_parts(anchor2, frame2));
            return Ok(joint);
        }
        kind::PRISMATIC => PrismaticJoint::new(memory::direction(2, "axis")?).data,
        kind::ROPE => RopeJoint::new(non_negative("length", length)?).data,
        kind::SPRING => {
            let (length, stiffness) =
                (non_negative("rest_length", length)?, non_negative("stiffness", stiffness)?);
            let mut spring = SpringJoint::new(anchor1, anchor2, length, stiffness);
            spring.set_damping(non_negative("damping", damping)?);
            spring.data
        }
        kind::SPHERICAL => spherical()?,
        kind::GENERIC => {
            let axis = memory::direction(2, "axis")?;
            let mut joint = GenericJoint::new(axes(mask));
            joint.set_local_axis1(axis).set_local_axis2(axis);
            joint
        }
        _ => transmission::description(kind_number, length)?
            .ok_or_else(|| Fault::number("the joint type", kind_number.into(), "a JointType"))?,
    };
    joint.try_set_local_anchor1(anchor1).map_err(Fault::invalid)?;
    joint.try_set_local_anchor2(anchor2).map_err(Fault::invalid)?;
    let limited = match kind_number {
        kind::REVOLUTE => Some(JointAxis::AngX),
        kind::PRISMATIC => Some(JointAxis::LinX),
        _ => None,
    };
    if let (Some(axis), true) = (limited, has_limits != 0) {
        set_limits(&mut joint, axis, number(5, 0), number(5, 1))?;
    }
    Ok(joint)
}

fn set_limits(
    joint: &mut GenericJoint,
    axis: JointAxis,
    min: Real,
    max: Real,
) -> Result<(), Fault> {
    joint.try_set_limits(axis, [min, max]).map_err(Fault::invalid)?;
    Ok(())
}

/// The kind of a joint, from its transmission or its locked axes.
fn kind_of(joint: &GenericJoint) -> u32 {
    if let Some(transmission) = joint.transmission() {
        transmission::kind_of(transmission)
    } else if joint.as_fixed().is_some() {
        kind::FIXED
    } else if joint.as_revolute().is_some() {
        kind::REVOLUTE
    } else if joint.as_prismatic().is_some() {
        kind::PRISMATIC
    } else if is_spherical(joint) {
        kind::SPHERICAL
    } else if joint.locked_axes.is_empty() && !joint.coupled_axes.is_empty() {
        if joint.motor_axes.is_empty() { kind::ROPE } else { kind::SPRING }
    } else {
        kind::GENERIC
    }
}

#[cfg(feature = "dim2")]
fn is_spherical(_: &GenericJoint) -> bool {
    false
}

#[cfg(not(feature = "dim2"))]
fn is_spherical(joint: &GenericJoint) -> bool {
    joint.as_spherical().is_some()
}

/// The sets of joints: 0 for impulse joints, 1 for multibody joints.
pub const IMPULSE: u32 = 0;

#[cold]
fn stale(set: u32, handle: f64) -> Fault {
    Fault::stale(if set == IMPULSE { "impulse joint" } else { "multibody joint" }, handle)
}

/// The joint of a world.
pub fn data(world: u32, set: u32, handle: f64) -> Result<&'static GenericJoint, Fault> {
    let world = read(world)?;
    let data = if set == IMPULSE {
        world.impulse_joints.get(ImpulseJointHandle::of_number(handle)).map(|joint| &joint.data)
    } else {
        world
            .multibody_joints
            .get_link(MultibodyJointHandle::of_number(handle))
            .map(|link| &link.joint.data)
    };
    data.ok_or_else(|| stale(set, handle))
}

/// The joint of a world, for changes.
fn find_mut(world: &mut PhysicsWorld, set: u32, handle: f64) -> Option<&mut GenericJoint> {
    if set == IMPULSE {
        let joint = world.impulse_joints.get_mut(ImpulseJointHandle::of_number(handle))?;
        return Some(&mut joint.data);
    }
    let (multibody, link) =
        world.multibody_joints.get_mut(MultibodyJointHandle::of_number(handle))?;
    Some(&mut multibody.link_mut(link)?.joint.data)
}

/// Changes a joint. An invalid change leaves it as it was.
pub fn change(
    world: u32,
    set: u32,
    handle: f64,
    change: impl FnOnce(&mut GenericJoint) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let mut changed = *data(world, set, handle)?;
    change(&mut changed)?;
    changed.validate().map_err(Fault::invalid)?;
    if let Some(joint) = find_mut(write(world)?, set, handle) {
        *joint = changed;
    }
    Ok(())
}

fn bodies(world: u32, set: u32, handle: f64) -> Result<[RigidBodyHandle; 2], Fault> {
    let world = read(world)?;
    if set == IMPULSE {
        let joint = world.impulse_joints.get(ImpulseJointHandle::of_number(handle));
        return joint.map(|joint| [joint.body1(), joint.body2()]).ok_or_else(|| stale(set, handle));
    }
    let found = world.multibody_joints.get(MultibodyJointHandle::of_number(handle));
    let (multibody, id) = found.ok_or_else(|| stale(set, handle))?;
    let child = multibody.link(id).ok_or_else(|| stale(set, handle))?;
    let parent = child.parent_id().and_then(|parent| multibody.link(parent)).unwrap_or(child);
    Ok([parent.rigid_body_handle(), child.rigid_body_handle()])
}

exports! {
    /// Joins two bodies by an impulse joint or a multibody joint.
    fn joint_create(world: u32, set: u32, kind: u32, mask: u32, has_limits: u32, body1: f64, body2: f64, wake: u32) -> f64 {
        let joint = description(kind, mask, has_limits)?;
        for handle in [body1, body2] {
            body(world, handle)?;
        }
        let world = write(world)?;
        let [body1, body2] = [body1, body2].map(RigidBodyHandle::of_number);
        if set == IMPULSE {
            world.impulse_joints.try_insert(body1, body2, joint, wake != 0).map_err(Fault::invalid)?.to_number()
        } else {
            world.multibody_joints.try_insert(body1, body2, joint, wake != 0).map_err(Fault::invalid)?.to_number()
        }
    }

    /// Removes a joint. A stale handle has no effect.
    fn joint_remove(world: u32, set: u32, handle: f64, wake: u32) {
        let world = write(world)?;
        if set == IMPULSE {
            world.impulse_joints.remove(ImpulseJointHandle::of_number(handle), wake != 0);
        } else {
            world.multibody_joints.remove(MultibodyJointHandle::of_number(handle), wake != 0);
        }
    }

    /// Returns whether a handle finds a joint.
    fn joint_exists(world: u32, set: u32, handle: f64) -> bool {
        data(world, set, handle).is_ok()
    }

    /// Lists all joints.
    fn joints_list(world: u32, set: u32) -> u32 {
        let world = read(world)?;
        if set == IMPULSE {
            put_list(world.impulse_joints.iter().map(|(handle, _)| handle.to_number()))
        } else {
            put_list(world.multibody_joints.iter().map(|(handle, ..)| handle.to_number()))
        }
    }

    /// Lists the joints of a body.
    fn joints_of_body(world: u32, set: u32, handle: f64) -> u32 {
        body(world, handle)?;
        let (world, body) = (read(world)?, RigidBodyHandle::of_number(handle));
        if set == IMPULSE {
            put_list(world.impulse_joints.attached_joints(body).map(|(_, _, joint, _)| joint.to_number()))
        } else {
            put_list(world.multibody_joints.attached_joints(body).map(|(_, _, joint)| joint.to_number()))
        }
    }

    /// The kind of a joint.
    fn joint_kind(world: u32, set: u32, handle: f64) -> u32 {
        kind_of(data(world, set, handle)?)
    }

    /// The first (0) or second (1) body of a joint.
    fn joint_body(world: u32, set: u32, handle: f64, side: usize) -> f64 {
        bodies(world, set, handle)?[side & 1].to_number()
    }

    /// Writes the frame of a joint on the first (0) or second (1) body.
    fn joint_frame(world: u32, set: u32, handle: f64, side: u32) {
        let joint = data(world, set, handle)?;
        let frame = if side == 0 { joint.local_frame1 } else { joint.local_frame2 };
        put_vector(0, frame.translation);
        put_rotation(1, frame.rotation);
    }

    /// Sets the frame of a joint on the first (0) or second (1) body: translation and rotation, of which the
    /// bits say which are given.
    fn joint_set_frame(world: u32, set: u32, handle: f64, side: u32, given: u32) {
        change(world, set, handle, |joint| {
            let frame = if side == 0 { &mut joint.local_frame1 } else { &mut joint.local_frame2 };
            if given & 1 != 0 {
                frame.translation = vector(0, "anchor")?;
            }
            if given & 2 != 0 {
                frame.rotation = memory::rotation(1, "frame")?;
            }
            Ok(())
        })?;
    }

    /// Returns whether the two bodies of a joint collide.
    fn joint_contacts_enabled(world: u32, set: u32, handle: f64) -> bool {
        data(world, set, handle)?.contacts_enabled()
    }

    /// Sets whether the two bodies of a joint collide.
    fn joint_set_contacts_enabled(world: u32, set: u32, handle: f64, enabled: u32) {
        change(world, set, handle, |joint| {
            joint.set_contacts_enabled(enabled != 0);
            Ok(())
        })?;
    }

    /// Writes the limits along an axis. Returns whether there are any.
    fn joint_limits(world: u32, set: u32, handle: f64, axis_number: u32) -> bool {
        let limits = data(world, set, handle)?.limits(axis(axis_number)?);
        if let Some(limits) = limits {
            put_number(0, 0, limits.min);
            put_number(0, 1, limits.max);
        }
        limits.is_some()
    }

    /// Sets the limits along an axis.
    fn joint_set_limits(world: u32, set: u32, handle: f64, axis_number: u32, min: f64, max: f64) {
        change(world, set, handle, |joint| set_limits(joint, axis(axis_number)?, min as Real, max as Real))?;
    }

    /// Sets the model of a motor.
    fn joint_set_motor_model(world: u32, set: u32, handle: f64, axis_number: u32, model: u32) {
        let model = if model == 0 { MotorModel::AccelerationBased } else { MotorModel::ForceBased };
        change(world, set, handle, |joint| {
            joint.set_motor_model(axis(axis_number)?, model);
            Ok(())
        })?;
    }

    /// Sets the largest force of a motor.
    fn joint_set_motor_max_force(world: u32, set: u32, handle: f64, axis_number: u32, force: f64) {
        let force = match force >= 0.0 {
            true => (force as Real).min(Real::MAX),
            false => return Err(Fault::number("maxForce", force, "at least 0")),
        };
        change(world, set, handle, |joint| {
            joint.set_motor_max_force(axis(axis_number)?, force);
            Ok(())
        })?;
    }

    /// Sets target position, target velocity, stiffness and damping of a motor.
    fn joint_set_motor(world: u32, set: u32, handle: f64, axis_number: u32, position: f64, velocity: f64, stiffness: f64, damping: f64) {
        let (position, velocity) = (finite("targetPos", position)? as Real, finite("targetVel", velocity)? as Real);
        let (stiffness, damping) = (non_negative("stiffness", stiffness)? as Real, non_negative("damping", damping)? as Real);
        change(world, set, handle, |joint| {
            joint.set_motor(axis(axis_number)?, position, velocity, stiffness, damping);
            Ok(())
        })?;
    }

    /// Sets the target velocity of a motor. The target position stays.
    fn joint_set_motor_velocity(world: u32, set: u32, handle: f64, axis_number: u32, velocity: f64, factor: f64) {
        let (velocity, factor) = (finite("targetVel", velocity)? as Real, non_negative("factor", factor)? as Real);
        change(world, set, handle, |joint| {
            joint.set_motor_velocity(axis(axis_number)?, velocity, factor);
            Ok(())
        })?;
    }

    /// Sets the target position of a motor.
    fn joint_set_motor_position(world: u32, set: u32, handle: f64, axis_number: u32, position: f64, stiffness: f64, damping: f64) {
        let position = finite("targetPos", position)? as Real;
        let (stiffness, damping) = (non_negative("stiffness", stiffness)? as Real, non_negative("damping", damping)? as Real);
        change(world, set, handle, |joint| {
            joint.set_motor_position(axis(axis_number)?, position, stiffness, damping);
            Ok(())
        })?;
    }

    /// Writes the mean force and torque of an impulse joint in the last step, on the second body.
    fn joint_reaction(world: u32, handle: f64) {
        let joint = read(world)?.impulse_joints.get(ImpulseJointHandle::of_number(handle));
        let joint = joint.ok_or_else(|| stale(IMPULSE, handle))?;
        put_vector(0, joint.force());
        memory::put_angular(1, joint.torque());
    }
}
