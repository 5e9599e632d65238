//! Joints.

use super::garbage::traverse;
use super::identity::identify;
use super::numbers::{finite, non_negative, vector};
use super::options::Options;
use super::rapier::dynamics::{
    FixedJointBuilder, GenericJoint, ImpulseJointHandle, JointAxesMask, JointAxis, MotorModel,
    MultibodyJointHandle, PrismaticJointBuilder, RigidBodyHandle, RopeJointBuilder,
    SpringJointBuilder,
};
use super::rapier::math::{Real, Vector};
use super::rapier::pipeline::PhysicsWorld;
use super::space;
use super::transmission;
use super::world::World;
use crate::errors::{invalid, stale};
use pyo3::prelude::*;

/// The place of a joint: in the set of those that impulses hold, or of those between the links of
/// multibodies.
#[derive(Copy, Clone, PartialEq, Eq, Hash)]
pub enum Key {
    Impulse(ImpulseJointHandle),
    Multibody(MultibodyJointHandle),
}

/// A joint of the arguments of `add_joint`, and its free axis, if there is one.
pub fn describe(kind: &str, options: &Options<'_>) -> PyResult<(GenericJoint, Option<JointAxis>)> {
    let axis = options.any("axis")?.map(|axis| vector("axis", &axis)).transpose()?;
    let length = |options: &Options<'_>| -> PyResult<Real> {
        let length = options
            .take("length")?
            .ok_or_else(|| invalid(format!("a {kind} joint needs a length")))?;
        non_negative("length", length)
    };
    let (mut joint, free): (GenericJoint, _) = match kind {
        "fixed" => (FixedJointBuilder::new().build().into(), None),
        "revolute" => (space::revolute(axis)?, Some(JointAxis::AngX)),
        "prismatic" => (
            along(PrismaticJointBuilder::new(Vector::X).build().into(), axis)?,
            Some(JointAxis::LinX),
        ),
        "spherical" => (space::spherical()?, None),
        "rope" => (RopeJointBuilder::new(length(options)?).build().into(), None),
        "spring" => {
            let stiffness = non_negative("stiffness", options.take("stiffness")?.unwrap_or(1.0e3))?;
            let damping = non_negative("damping", options.take("damping")?.unwrap_or(10.0))?;
            (
                SpringJointBuilder::new(Vector::ZERO, Vector::ZERO, length(options)?, stiffness)
                    .damping(damping)
                    .build()
                    .into(),
                None,
            )
        }
        _ => {
            let unknown = || {
                invalid(format!(
                    "kind is {kind:?}, but must be fixed, revolute, prismatic, spherical, rope, \
                     spring, gear, rack or pulley"
                ))
            };
            (transmission::describe(kind, options)?.ok_or_else(unknown)?, None)
        }
    };
    if axis.is_some() && free.is_none() {
        return Err(invalid(format!("a {kind} joint has no axis")));
    }
    if let Some(anchor) = options.any("anchor1")? {
        joint.try_set_local_anchor1(vector("anchor1", &anchor)?).map_err(invalid)?;
    }
    if let Some(anchor) = options.any("anchor2")? {
        joint.try_set_local_anchor2(vector("anchor2", &anchor)?).map_err(invalid)?;
    }
    if let Some((lower, upper)) = options.take::<(f64, f64)>("limits")? {
        let free = free.ok_or_else(|| invalid(format!("a {kind} joint has no limits")))?;
        joint
            .try_set_limits(free, [finite("limits", lower)?, finite("limits", upper)?])
            .map_err(invalid)?;
    }
    if let Some(contacts) = options.take("contacts")? {
        joint.set_contacts_enabled(contacts);
    }
    Ok((joint, free))
}

/// A joint with an axis in the frames of both bodies.
pub fn along(mut joint: GenericJoint, axis: Option<Vector>) -> PyResult<GenericJoint> {
    if let Some(axis) = axis {
        joint.try_set_local_axis1(axis).map_err(invalid)?;
        joint.try_set_local_axis2(axis).map_err(invalid)?;
    }
    Ok(joint)
}

/// Inserts a joint between two bodies.
pub fn insert(
    world: &mut PhysicsWorld,
    reduced: bool,
    bodies: [RigidBodyHandle; 2],
    joint: GenericJoint,
) -> PyResult<Key> {
    match reduced {
        true => world.try_insert_multibody_joint(bodies[0], bodies[1], joint).map(Key::Multibody),
        false => world.try_insert_impulse_joint(bodies[0], bodies[1], joint).map(Key::Impulse),
    }
    .map_err(invalid)
}

/// Returns whether a world contains a joint.
pub fn contains(world: &PhysicsWorld, key: Key) -> bool {
    match key {
        Key::Impulse(handle) => world.impulse_joints.get(handle).is_some(),
        Key::Multibody(handle) => world.multibody_joints.get(handle).is_some(),
    }
}

/// The parts of a joint that parameters do not change: its key, its bodies and its locked axes.
pub type Structure = (Key, [RigidBodyHandle; 2], JointAxesMask);

/// The structures of all joints of a world.
pub fn structures(world: &PhysicsWorld) -> Vec<Structure> {
    let impulse = world.impulse_joints.iter().map(|(handle, _)| Key::Impulse(handle));
    let multibody = world.multibody_joints.iter().map(|(handle, ..)| Key::Multibody(handle));
    let structure = |key| {
        let (bodies, data) = parts(world, key)?;
        Some((key, bodies, data.locked_axes))
    };
    impulse.chain(multibody).filter_map(structure).collect()
}

/// The two bodies of a joint, and its data.
pub fn parts(world: &PhysicsWorld, key: Key) -> Option<([RigidBodyHandle; 2], &GenericJoint)> {
    match key {
        Key::Impulse(handle) => {
            let joint = world.impulse_joints.get(handle)?;
            Some(([joint.body1(), joint.body2()], &joint.data))
        }
        Key::Multibody(handle) => {
            let (multibody, id) = world.multibody_joints.get(handle)?;
            let link = multibody.link(id)?;
            let parent = multibody.link(link.parent_id()?)?;
            Some(([parent.rigid_body_handle(), link.rigid_body_handle()], &link.joint().data))
        }
    }
}

/// The data of a joint, to change it.
pub fn data_mut(world: &mut PhysicsWorld, key: Key) -> Option<&mut GenericJoint> {
    match key {
        Key::Impulse(handle) => world.impulse_joints.get_mut(handle).map(|joint| &mut joint.data),
        Key::Multibody(handle) => {
            let (multibody, link) = world.multibody_joints.get_mut(handle)?;
            multibody.link_mut(link).map(|link| &mut link.joint.data)
        }
    }
}

/// A joint of a world. After its removal, every use raises `StaleHandleError`.
#[pyclass(frozen, module = "rapier", eq, hash)]
pub struct Joint {
    pub world: Py<World>,
    pub key: Key,
    /// The axis of motors and limits.
    pub axis: Option<JointAxis>,
}

identify!(Joint by key);
traverse!(Joint, joint => joint.world);

impl Joint {
    /// The axis of motors and limits.
    pub fn free_axis(&self) -> PyResult<JointAxis> {
        self.axis
            .ok_or_else(|| invalid("only revolute and prismatic joints have motors and limits"))
    }

    fn change<R>(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut GenericJoint) -> R,
    ) -> PyResult<R> {
        data_mut(&mut self.world.get().lock(py)?.simulation.world, self.key)
            .map(change)
            .ok_or_else(|| stale("joint"))
    }
}

#[pymethods]
impl Joint {
    /// Drives the coordinate of the joint to a position (rad or m) like a spring. The stiffness
    /// (1/s²) and the damping (1/s) are independent of the masses.
    fn set_motor_position(
        &self,
        py: Python<'_>,
        target: f64,
        stiffness: f64,
        damping: f64,
    ) -> PyResult<()> {
        let (axis, target) = (self.free_axis()?, finite("target", target)?);
        let (stiffness, damping) =
            (non_negative("stiffness", stiffness)?, non_negative("damping", damping)?);
        self.change(py, |joint| {
            joint.set_motor_position(axis, target, stiffness, damping);
        })
    }

    /// Drives the coordinate of the joint at a velocity (rad/s or m/s). A larger factor (1/s) holds
    /// it more stiffly.
    fn set_motor_velocity(&self, py: Python<'_>, target: f64, factor: f64) -> PyResult<()> {
        let (axis, target, factor) =
            (self.free_axis()?, finite("target", target)?, non_negative("factor", factor)?);
        self.change(py, |joint| {
            joint.set_motor_velocity(axis, target, factor);
        })
    }

    /// Limits the force (N) or torque (N·m) of the motor.
    fn set_motor_max_force(&self, py: Python<'_>, force: f64) -> PyResult<()> {
        let (axis, force) = (self.free_axis()?, non_negative("force", force)?);
        self.change(py, |joint| {
            joint.set_motor_max_force(axis, force);
        })
    }

    /// Whether stiffness and damping of the motor are forces (N/m, N·m/rad) instead of
    /// accelerations.
    fn set_motor_force_based(&self, py: Python<'_>, force_based: bool) -> PyResult<()> {
        let model =
            if force_based { MotorModel::ForceBased } else { MotorModel::AccelerationBased };
        let axis = self.free_axis()?;
        self.change(py, |joint| {
            joint.set_motor_model(axis, model);
        })
    }

    /// Limits the coordinate of the joint (rad or m).
    fn set_limits(&self, py: Python<'_>, lower: f64, upper: f64) -> PyResult<()> {
        let (axis, limits) =
            (self.free_axis()?, [finite("lower", lower)?, finite("upper", upper)?]);
        self.change(py, |joint| joint.try_set_limits(axis, limits))?.map_err(invalid)
    }

    /// Removes the joint.
    fn remove(&self, py: Python<'_>) -> PyResult<()> {
        let world = &mut self.world.get().lock(py)?.simulation.world;
        let removed = match self.key {
            Key::Impulse(handle) => world.remove_impulse_joint(handle).is_some(),
            Key::Multibody(handle) => world.remove_multibody_joint(handle).is_some(),
        };
        if removed { Ok(()) } else { Err(stale("joint")) }
    }
}
