//! Colliders: creation, removal, settings and state.

use crate::body::mass_properties;
use crate::fault::{Fault, finite, non_negative};
use crate::handle::{Handle, optional};
use crate::memory::{self, put_list, put_rotation, put_vector};
use crate::rapier::dynamics::{CoefficientCombineRule, RigidBodyHandle};
use crate::rapier::geometry::{
    ActiveCollisionTypes, Collider, ColliderBuilder, ColliderHandle, Group, InteractionGroups,
};
use crate::rapier::math::{Pose, Real};
use crate::rapier::pipeline::{ActiveEvents, ActiveHooks};
use crate::registry::{body, collider, collider_mut, colliders, write};
use crate::shape::{describe, shape};

/// The rules in the order of the numbers of `CoefficientCombineRule` in TypeScript.
const RULES: [CoefficientCombineRule; 6] = [
    CoefficientCombineRule::Average,
    CoefficientCombineRule::Min,
    CoefficientCombineRule::Multiply,
    CoefficientCombineRule::Max,
    CoefficientCombineRule::ClampedSum,
    CoefficientCombineRule::GeometricMean,
];

fn combine_rule(number: u32) -> Result<CoefficientCombineRule, Fault> {
    let rule = RULES.get(number as usize).copied();
    rule.ok_or_else(|| Fault::number("the combine rule", number.into(), "a CoefficientCombineRule"))
}

fn rule_number(rule: CoefficientCombineRule) -> f64 {
    RULES.iter().position(|other| *other == rule).unwrap_or(0) as f64
}

/// Groups of 16 bits each: the memberships above the filter. The engine's groups have 32 bits: the upper ones
/// stay clear.
pub fn groups(bits: u32) -> InteractionGroups {
    let group = |bits| Group::from_bits_truncate(bits);
    InteractionGroups::new(group(bits >> 16), group(bits & 0xffff))
}

fn groups_number(groups: InteractionGroups) -> f64 {
    let (memberships, filter) = (groups.memberships.bits() & 0xffff, groups.filter.bits() & 0xffff);
    f64::from((memberships << 16) | filter)
}

/// The settings, in the order of `ColliderSetting` in TypeScript.
mod setting {
    pub const FRICTION: u32 = 0;
    pub const RESTITUTION: u32 = 1;
    pub const FRICTION_RULE: u32 = 2;
    pub const RESTITUTION_RULE: u32 = 3;
    pub const COLLISION_GROUPS: u32 = 4;
    pub const SOLVER_GROUPS: u32 = 5;
    pub const ACTIVE_EVENTS: u32 = 6;
    pub const ACTIVE_HOOKS: u32 = 7;
    pub const ACTIVE_COLLISION_TYPES: u32 = 8;
    pub const FORCE_THRESHOLD: u32 = 9;
    pub const CONTACT_SKIN: u32 = 10;
    pub const SENSOR: u32 = 11;
    pub const ENABLED: u32 = 12;
    pub const DENSITY: u32 = 13;
    pub const MASS: u32 = 14;
    pub const VOLUME: u32 = 15;

    /// The names in TypeScript.
    pub const NAMES: [&str; 16] = [
        "friction",
        "restitution",
        "frictionCombineRule",
        "restitutionCombineRule",
        "collisionGroups",
        "solverGroups",
        "activeEvents",
        "activeHooks",
        "activeCollisionTypes",
        "contactForceEventThreshold",
        "contactSkin",
        "isSensor",
        "enabled",
        "density",
        "mass",
        "volume",
    ];
}

fn setting_of(collider: &Collider, number: u32) -> f64 {
    match number {
        setting::FRICTION => collider.friction().into(),
        setting::RESTITUTION => collider.restitution().into(),
        setting::FRICTION_RULE => rule_number(collider.friction_combine_rule()),
        setting::RESTITUTION_RULE => rule_number(collider.restitution_combine_rule()),
        setting::COLLISION_GROUPS => groups_number(collider.collision_groups()),
        setting::SOLVER_GROUPS => groups_number(collider.solver_groups()),
        setting::ACTIVE_EVENTS => collider.active_events().bits().into(),
        setting::ACTIVE_HOOKS => collider.active_hooks().bits().into(),
        setting::ACTIVE_COLLISION_TYPES => collider.active_collision_types().bits().into(),
        setting::FORCE_THRESHOLD => collider.contact_force_event_threshold().into(),
        setting::CONTACT_SKIN => collider.contact_skin().into(),
        setting::SENSOR => collider.is_sensor().into(),
        setting::ENABLED => collider.is_enabled().into(),
        setting::DENSITY => collider.density().into(),
        setting::MASS => collider.mass().into(),
        _ => collider.volume().into(),
    }
}

fn change_setting(collider: &mut Collider, number: u32, value: f64) -> Result<(), Fault> {
    let (real, bits) = (value as Real, value as u32);
    match number {
        setting::FRICTION => collider.set_friction(non_negative("friction", real)?),
        setting::RESTITUTION => collider.set_restitution(non_negative("restitution", real)?),
        setting::FRICTION_RULE => collider.set_friction_combine_rule(combine_rule(bits)?),
        setting::RESTITUTION_RULE => collider.set_restitution_combine_rule(combine_rule(bits)?),
        setting::COLLISION_GROUPS => collider.set_collision_groups(groups(bits)),
        setting::SOLVER_GROUPS => collider.set_solver_groups(groups(bits)),
        setting::ACTIVE_EVENTS => {
            collider.set_active_events(ActiveEvents::from_bits_truncate(bits))
        }
        setting::ACTIVE_HOOKS => collider.set_active_hooks(ActiveHooks::from_bits_truncate(bits)),
        setting::ACTIVE_COLLISION_TYPES => {
            collider
                .set_active_collision_types(ActiveCollisionTypes::from_bits_truncate(bits as u16));
        }
        setting::FORCE_THRESHOLD => {
            collider.set_contact_force_event_threshold(non_negative(
                "contactForceEventThreshold",
                real,
            )?);
        }
        setting::CONTACT_SKIN => collider.set_contact_skin(non_negative("contactSkin", real)?),
        setting::SENSOR => collider.set_sensor(value != 0.0),
        setting::ENABLED => collider.set_enabled(value != 0.0),
        setting::DENSITY => collider.set_density(non_negative("density", real)?),
        setting::MASS => collider.set_mass(non_negative("mass", real)?),
        setting::VOLUME => {
            return Err(Fault::invalid("the volume of a collider follows from its shape"));
        }
        _ => return Err(Fault::number("the setting", number.into(), "a setting of colliders")),
    }
    Ok(())
}

/// The pose of a collider in the frame of its body, or in the world without one.
fn set_local_pose(collider: &mut Collider, change: impl FnOnce(Pose) -> Pose) {
    match collider.position_wrt_parent().copied() {
        Some(pose) => collider.set_position_wrt_parent(change(pose)),
        None => collider.set_position(change(*collider.position())),
    }
}

/// Modes of a new collider's mass: `MassPropsMode` in TypeScript.
mod mass_mode {
    pub const DENSITY: u32 = 0;
    pub const MASS: u32 = 1;
}

exports! {
    /// Creates a collider from a shape and the scratch block: translation, rotation, centre of mass,
    /// principal inertia and its frame. Friction, restitution, force threshold, contact skin, density and
    /// mass follow. The integers are rules, groups, events, hooks and collision types.
    fn collider_create(world: u32, number: u32, parent: f64, mode: u32, sensor: u32, enabled: u32) -> f64 {
        let settings = memory::integers();
        let bits = |at: usize| settings.get(at).copied().unwrap_or(0);
        let mut builder = ColliderBuilder::new(shape(number)?);
        builder.position = memory::pose(0)?;
        builder.friction = non_negative("friction", memory::number(5, 0))?;
        builder.restitution = non_negative("restitution", memory::number(5, 1))?;
        builder.contact_force_event_threshold = non_negative("contactForceEventThreshold", memory::number(5, 2))?;
        builder.contact_skin = non_negative("contactSkin", memory::number(5, 3))?;
        builder.friction_combine_rule = combine_rule(bits(0))?;
        builder.restitution_combine_rule = combine_rule(bits(1))?;
        builder.collision_groups = groups(bits(2));
        builder.solver_groups = groups(bits(3));
        builder.active_events = ActiveEvents::from_bits_truncate(bits(4));
        builder.active_hooks = ActiveHooks::from_bits_truncate(bits(5));
        builder.active_collision_types = ActiveCollisionTypes::from_bits_truncate(bits(6) as u16);
        builder.is_sensor = sensor != 0;
        builder.enabled = enabled != 0;
        builder = match mode {
            mass_mode::DENSITY => builder.density(non_negative("density", memory::number(6, 0))?),
            mass_mode::MASS => builder.mass(non_negative("mass", memory::number(6, 1))?),
            _ => builder.mass_properties(mass_properties(memory::number(6, 1), 2)?),
        };
        let collider = builder.try_build().map_err(Fault::invalid)?;
        let has_parent = !parent.is_nan();
        if has_parent {
            body(world, parent)?;
        }
        let world = write(world)?;
        let parent = has_parent.then(|| RigidBodyHandle::of_number(parent));
        world.insert_collider(collider, parent).to_number()
    }

    /// Removes a collider. A stale handle has no effect.
    fn collider_remove(world: u32, handle: f64, wake: u32) {
        let world = write(world)?;
        let removed = ColliderHandle::of_number(handle);
        world.colliders.remove(removed, &mut world.islands, &mut world.bodies, wake != 0);
    }

    /// The number of colliders.
    fn colliders_len(world: u32) -> usize {
        colliders(world)?.len()
    }

    /// Returns whether a handle finds a collider.
    fn colliders_contain(world: u32, handle: f64) -> bool {
        colliders(world)?.contains(ColliderHandle::of_number(handle))
    }

    /// Lists all colliders.
    fn colliders_list(world: u32) -> u32 {
        put_list(colliders(world)?.iter().map(|(handle, _)| handle.to_number()))
    }

    /// The body of a collider, or NaN.
    fn collider_parent(world: u32, handle: f64) -> f64 {
        optional(collider(world, handle)?.parent())
    }

    /// Writes the translation in world space.
    fn collider_translation(world: u32, handle: f64) {
        put_vector(0, collider(world, handle)?.translation());
    }

    /// Writes the rotation in world space.
    fn collider_rotation(world: u32, handle: f64) {
        put_rotation(0, collider(world, handle)?.rotation());
    }

    /// Writes the pose in the frame of the body. Returns whether there is one.
    fn collider_local_pose(world: u32, handle: f64) -> bool {
        let pose = collider(world, handle)?.position_wrt_parent().copied();
        if let Some(pose) = pose {
            put_vector(0, pose.translation);
            put_rotation(1, pose.rotation);
        }
        pose.is_some()
    }

    /// Sets the translation in world space.
    fn collider_set_translation(world: u32, handle: f64) {
        let collider = collider_mut(world, handle)?;
        collider.set_translation(memory::vector(0, "translation")?);
    }

    /// Sets the rotation in world space.
    fn collider_set_rotation(world: u32, handle: f64) {
        let collider = collider_mut(world, handle)?;
        collider.set_rotation(memory::rotation(0, "rotation")?);
    }

    /// Sets the translation in the frame of the body.
    fn collider_set_local_translation(world: u32, handle: f64) {
        let collider = collider_mut(world, handle)?;
        let translation = memory::vector(0, "translation")?;
        set_local_pose(collider, |pose| Pose::from_parts(translation, pose.rotation));
    }

    /// Sets the rotation in the frame of the body.
    fn collider_set_local_rotation(world: u32, handle: f64) {
        let collider = collider_mut(world, handle)?;
        let rotation = memory::rotation(0, "rotation")?;
        set_local_pose(collider, |pose| Pose::from_parts(pose.translation, rotation));
    }

    /// A setting of a collider: see `ColliderSetting` in TypeScript.
    fn collider_setting(world: u32, handle: f64, setting: u32) -> f64 {
        setting_of(collider(world, handle)?, setting)
    }

    /// Changes a setting of a collider.
    fn collider_set_setting(world: u32, handle: f64, setting: u32, value: f64) {
        let collider = collider_mut(world, handle)?;
        let name = setting::NAMES.get(setting as usize).copied().unwrap_or("the setting");
        change_setting(collider, setting, finite(name, value)?)?;
    }

    /// Sets the mass properties, whatever the shape.
    fn collider_set_mass_properties(world: u32, handle: f64, mass: f64) {
        let collider = collider_mut(world, handle)?;
        collider.set_mass_properties(mass_properties(mass as Real, 0)?);
    }

    /// Writes the numbers and lists of the shape. Returns its kind.
    fn collider_describe(world: u32, handle: f64) -> u32 {
        describe(collider(world, handle)?.shared_shape())
    }

    /// Replaces the shape.
    fn collider_set_shape(world: u32, handle: f64, number: u32) {
        let collider = collider_mut(world, handle)?;
        collider.set_shape(shape(number)?);
    }

    /// Moves colliders of bodies that were moved since the last step, so that queries find them.
    fn colliders_propagate(world: u32) {
        let world = write(world)?;
        world.bodies.propagate_modified_body_positions_to_colliders(&mut world.colliders);
    }
}
