//! Bodies: creation, removal, settings and state.

use crate::fault::{Fault, finite, non_negative};
use crate::handle::Handle;
use crate::memory::{self, put_list};
use crate::rapier::dynamics::{
    LockedAxes, RigidBody, RigidBodyAdditionalMassProps, RigidBodyBuilder, RigidBodyHandle,
    RigidBodyType,
};
use crate::rapier::geometry::ColliderHandle;
use crate::rapier::math::Real;
use crate::rapier::prelude::MassProperties;
use crate::registry::{bodies, body, body_mut, read, write};

/// Bits of the `flags` of [`body_create`].
mod flag {
    pub const ENABLED: u32 = 1;
    pub const CAN_SLEEP: u32 = 1 << 1;
    pub const SLEEPING: u32 = 1 << 2;
    pub const CCD: u32 = 1 << 3;
    pub const MASS: u32 = 1 << 4;
    pub const MASS_PROPERTIES: u32 = 1 << 5;
}

/// The types in the order of the numbers of `RigidBodyType` in TypeScript.
const TYPES: [RigidBodyType; 4] = [
    RigidBodyType::Dynamic,
    RigidBodyType::Fixed,
    RigidBodyType::KinematicPositionBased,
    RigidBodyType::KinematicVelocityBased,
];

fn body_kind(number: u32) -> Result<RigidBodyType, Fault> {
    let kind = TYPES.get(number as usize).copied();
    kind.ok_or_else(|| Fault::number("the body type", number.into(), "a RigidBodyType"))
}

/// Mass properties from the scratch block: centre of mass, principal inertia and its frame in three places.
#[cfg(feature = "dim2")]
pub fn mass_properties(mass: Real, place: usize) -> Result<MassProperties, Fault> {
    let center = memory::vector(place, "centerOfMass")?;
    let inertia = memory::angular(place + 1, "principalAngularInertia")?;
    Ok(MassProperties::new(
        center,
        non_negative("mass", mass)?,
        non_negative("principalAngularInertia", inertia)?,
    ))
}

/// Mass properties from the scratch block: centre of mass, principal inertia and its frame in three places.
#[cfg(not(feature = "dim2"))]
pub fn mass_properties(mass: Real, place: usize) -> Result<MassProperties, Fault> {
    let center = memory::vector(place, "centerOfMass")?;
    let inertia = memory::angular(place + 1, "principalAngularInertia")?;
    for value in inertia.to_array() {
        non_negative("principalAngularInertia", value)?;
    }
    let frame = memory::rotation(place + 2, "angularInertiaLocalFrame")?;
    let mass = non_negative("mass", mass)?;
    Ok(MassProperties::with_principal_inertia_frame(center, mass, inertia, frame))
}

fn axes(bits: u32) -> LockedAxes {
    LockedAxes::from_bits_truncate(bits as u8)
}

fn dominance(group: i32) -> Result<i8, Fault> {
    i8::try_from(group)
        .map_err(|_| Fault::number("the dominance group", group.into(), "from -128 to 127"))
}

exports! {
    /// Creates a body from the scratch block: translation, rotation, linear and angular velocity, centre of
    /// mass, principal inertia and its frame. Gravity scale, dampings, the prediction of soft CCD and the
    /// additional mass follow.
    fn body_create(world: u32, kind: u32, flags: u32, locked: u32, group: i32, iterations: u32) -> f64 {
        let world = write(world)?;
        let has = |bit| flags & bit != 0;
        let mut builder = RigidBodyBuilder::new(body_kind(kind)?);
        builder.position = memory::pose(0)?;
        builder.linvel = memory::vector(2, "linvel")?;
        builder.angvel = memory::angular(3, "angvel")?;
        builder.gravity_scale = finite("gravityScale", memory::number(7, 0))?;
        builder.linear_damping = non_negative("linearDamping", memory::number(7, 1))?;
        builder.angular_damping = non_negative("angularDamping", memory::number(7, 2))?;
        builder.soft_ccd_prediction = non_negative("softCcdPrediction", memory::number(7, 3))?;
        builder.locked_axes = axes(locked);
        builder.enabled = has(flag::ENABLED);
        builder.can_sleep = has(flag::CAN_SLEEP);
        builder.sleeping = has(flag::SLEEPING);
        builder.ccd_enabled = has(flag::CCD);
        builder.dominance_group = dominance(group)?;
        builder.additional_solver_iterations = iterations as usize;
        let mass = memory::number(8, 0);
        builder.additional_mass_properties = if has(flag::MASS_PROPERTIES) {
            Some(RigidBodyAdditionalMassProps::MassProps(mass_properties(mass, 4)?))
        } else if has(flag::MASS) {
            Some(RigidBodyAdditionalMassProps::Mass(non_negative("mass", mass)?))
        } else {
            None
        };
        let body = builder.try_build().map_err(Fault::invalid)?;
        world.bodies.insert(body).to_number()
    }

    /// Removes a body with its colliders and joints. The list holds three groups: colliders, impulse joints,
    /// multibody joints, each after its length. A stale handle has no effect, and the list is empty.
    fn body_remove(world: u32, handle: f64) -> u32 {
        let world = write(world)?;
        let body = RigidBodyHandle::of_number(handle);
        let Some(removed) = world.bodies.get(body) else { return Ok(put_list([])) };
        let colliders: Vec<ColliderHandle> = removed.colliders().to_vec();
        let impulse: Vec<f64> = world.impulse_joints.attached_joints(body).map(|(_, _, joint, _)| joint.to_number()).collect();
        let multibody: Vec<f64> = world.multibody_joints.attached_joints(body).map(|(_, _, joint)| joint.to_number()).collect();
        world.impulse_joints.remove_joints_attached_to_rigid_body(body);
        world.multibody_joints.remove_joints_attached_to_rigid_body(body);
        for collider in &colliders {
            world.colliders.remove(*collider, &mut world.islands, &mut world.bodies, true);
        }
        world.bodies.remove(body);
        let colliders: Vec<f64> = colliders.into_iter().map(Handle::to_number).collect();
        let groups = [colliders, impulse, multibody];
        put_list(groups.into_iter().flat_map(|group| core::iter::once(group.len() as f64).chain(group)))
    }

    /// The number of bodies.
    fn bodies_len(world: u32) -> usize {
        bodies(world)?.len()
    }

    /// Returns whether a handle finds a body.
    fn bodies_contain(world: u32, handle: f64) -> bool {
        bodies(world)?.contains(RigidBodyHandle::of_number(handle))
    }

    /// Lists all bodies.
    fn bodies_list(world: u32) -> u32 {
        put_list(bodies(world)?.iter().map(|(handle, _)| handle.to_number()))
    }

    /// Lists the bodies that are awake and not fixed.
    fn bodies_list_active(world: u32) -> u32 {
        put_list(read(world)?.active_bodies().iter().map(|handle| handle.to_number()))
    }

    /// The type of a body.
    fn body_type(world: u32, handle: f64) -> u32 {
        let kind = body(world, handle)?.body_type();
        TYPES.iter().position(|other| *other == kind).unwrap_or(0) as u32
    }

    /// Changes the type of a body.
    fn body_set_type(world: u32, handle: f64, kind: u32, wake: u32) {
        body_mut(world, handle)?.set_body_type(body_kind(kind)?, wake != 0);
    }

    /// The yes-or-no properties of a body, one bit each.
    fn body_flags(world: u32, handle: f64) -> u32 {
        let body = body(world, handle)?;
        u32::from(body.is_enabled())
            | u32::from(body.is_sleeping()) << 1
            | u32::from(body.is_moving()) << 2
            | u32::from(body.is_ccd_enabled()) << 3
            | u32::from(body.quarantine().is_some()) << 4
    }

    /// The locked axes of a body, as bits.
    fn body_locked_axes(world: u32, handle: f64) -> u32 {
        body(world, handle)?.locked_axes().bits().into()
    }

    /// Changes some of the locked axes: those of the mask become those of the bits.
    fn body_set_locked_axes(world: u32, handle: f64, mask: u32, bits: u32, wake: u32) {
        let body = body_mut(world, handle)?;
        let locked = (body.locked_axes() - axes(mask)) | axes(bits & mask);
        body.set_locked_axes(locked, wake != 0);
    }

    /// Switches a body on or off.
    fn body_set_enabled(world: u32, handle: f64, enabled: u32) {
        body_mut(world, handle)?.set_enabled(enabled != 0);
    }

    /// Switches continuous collision detection on or off.
    fn body_set_ccd(world: u32, handle: f64, enabled: u32) {
        body_mut(world, handle)?.enable_ccd(enabled != 0);
    }

    /// Puts a body to sleep.
    fn body_sleep(world: u32, handle: f64) {
        body_mut(world, handle)?.sleep();
    }

    /// Wakes a body.
    fn body_wake_up(world: u32, handle: f64) {
        body_mut(world, handle)?.wake_up(true);
    }

    /// A setting of a body: see `SETTING` in TypeScript.
    fn body_setting(world: u32, handle: f64, setting: u32) -> f64 {
        setting_of(body(world, handle)?, setting)
    }

    /// Changes a setting of a body.
    fn body_set_setting(world: u32, handle: f64, setting: u32, value: f64, wake: u32) {
        change_setting(body_mut(world, handle)?, setting, value, wake != 0)?;
    }

    /// The number of colliders of a body.
    fn body_collider_count(world: u32, handle: f64) -> usize {
        body(world, handle)?.colliders().len()
    }

    /// A collider of a body, or NaN.
    fn body_collider(world: u32, handle: f64, index: usize) -> f64 {
        crate::handle::optional(body(world, handle)?.colliders().get(index).copied())
    }
}

/// The settings, in the order of `BodySetting` in TypeScript.
mod setting {
    pub const GRAVITY_SCALE: u32 = 0;
    pub const LINEAR_DAMPING: u32 = 1;
    pub const ANGULAR_DAMPING: u32 = 2;
    pub const SOFT_CCD_PREDICTION: u32 = 3;
    pub const DOMINANCE_GROUP: u32 = 4;
}

fn setting_of(body: &RigidBody, number: u32) -> f64 {
    match number {
        setting::GRAVITY_SCALE => body.gravity_scale().into(),
        setting::LINEAR_DAMPING => body.linear_damping().into(),
        setting::ANGULAR_DAMPING => body.angular_damping().into(),
        setting::SOFT_CCD_PREDICTION => body.soft_ccd_prediction().into(),
        setting::DOMINANCE_GROUP => body.dominance_group().into(),
        _ => body.additional_solver_iterations() as f64,
    }
}

fn change_setting(body: &mut RigidBody, number: u32, value: f64, wake: bool) -> Result<(), Fault> {
    match number {
        setting::GRAVITY_SCALE => {
            body.set_gravity_scale(finite("gravityScale", value)? as Real, wake)
        }
        setting::LINEAR_DAMPING => {
            body.set_linear_damping(non_negative("linearDamping", value)? as Real)
        }
        setting::ANGULAR_DAMPING => {
            body.set_angular_damping(non_negative("angularDamping", value)? as Real)
        }
        setting::SOFT_CCD_PREDICTION => {
            body.set_soft_ccd_prediction(non_negative("softCcdPrediction", value)? as Real);
        }
        setting::DOMINANCE_GROUP => {
            body.set_dominance_group(dominance(finite("the dominance group", value)? as i32)?)
        }
        _ => body
            .set_additional_solver_iterations(
                non_negative("additionalSolverIterations", value)? as usize
            ),
    }
    Ok(())
}
