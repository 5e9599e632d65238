//! Controllers: characters and feedback.

use crate::fault::{Fault, finite, non_negative};
use crate::handle::Handle;
use crate::memory::{self, Single, put_angular, put_number, put_vector, vector};
use crate::query::filter;
use crate::rapier::control::{
    CharacterAutostep, CharacterCollision, CharacterLength, EffectiveCharacterMovement,
    KinematicCharacterController, PidController,
};
use crate::rapier::geometry::ColliderHandle;
use crate::rapier::math::{Real, Vector};
use crate::rapier::pipeline::QueryFilter;
use crate::rapier::prelude::AxesMask;
use crate::registry::{
    Registry, body, body_mut, collider, controlled, queried, read, update_queries,
};

/// A character, and its last movement.
#[derive(Default)]
struct Character {
    controller: KinematicCharacterController,
    movement: EffectiveCharacterMovement,
    collisions: Vec<CharacterCollision>,
}

static CHARACTERS: Single<Registry<Character>> = Single::new(Registry::new());
static PIDS: Single<Registry<PidController>> = Single::new(Registry::new());

fn character(number: u32) -> Result<&'static mut Character, Fault> {
    // SAFETY: an exported function gets one controller, once.
    unsafe { CHARACTERS.get().get(number) }.ok_or_else(|| Fault::freed("character controller"))
}

fn pid(number: u32) -> Result<&'static mut PidController, Fault> {
    // SAFETY: an exported function gets one controller, once.
    unsafe { PIDS.get().get(number) }.ok_or_else(|| Fault::freed("PID controller"))
}

/// Settings of a character, in the order of `CharacterSetting` in TypeScript. NaN is an absent value.
mod setting {
    pub const OFFSET: u32 = 0;
    pub const SLIDE: u32 = 1;
    pub const AUTOSTEP_HEIGHT: u32 = 2;
    pub const AUTOSTEP_WIDTH: u32 = 3;
    pub const AUTOSTEP_DYNAMIC: u32 = 4;
    pub const CLIMB_ANGLE: u32 = 5;
    pub const SLIDE_ANGLE: u32 = 6;
    pub const SNAP: u32 = 7;
    pub const NUDGE: u32 = 8;
}

fn length(length: CharacterLength) -> f64 {
    match length {
        CharacterLength::Relative(value) | CharacterLength::Absolute(value) => value.into(),
    }
}

fn character_setting_of(controller: &KinematicCharacterController, number: u32) -> f64 {
    let autostep =
        |read: fn(&CharacterAutostep) -> f64| controller.autostep.as_ref().map_or(f64::NAN, read);
    match number {
        setting::OFFSET => length(controller.offset),
        setting::SLIDE => controller.slide.into(),
        setting::AUTOSTEP_HEIGHT => autostep(|step| length(step.max_height)),
        setting::AUTOSTEP_WIDTH => autostep(|step| length(step.min_width)),
        setting::AUTOSTEP_DYNAMIC => autostep(|step| step.include_dynamic_bodies.into()),
        setting::CLIMB_ANGLE => controller.max_slope_climb_angle.into(),
        setting::SLIDE_ANGLE => controller.min_slope_slide_angle.into(),
        setting::SNAP => controller.snap_to_ground.map_or(f64::NAN, length),
        _ => controller.normal_nudge_factor.into(),
    }
}

fn change_character(
    controller: &mut KinematicCharacterController,
    number: u32,
    value: f64,
) -> Result<(), Fault> {
    let positive = |name: &str| non_negative(name, value).map(|value| value as Real);
    match number {
        setting::OFFSET => controller.offset = CharacterLength::Absolute(positive("offset")?),
        setting::SLIDE => controller.slide = value != 0.0,
        setting::CLIMB_ANGLE => {
            controller.max_slope_climb_angle = finite("maxSlopeClimbAngle", value)? as Real
        }
        setting::SLIDE_ANGLE => {
            controller.min_slope_slide_angle = finite("minSlopeSlideAngle", value)? as Real
        }
        setting::SNAP => {
            controller.snap_to_ground = Some(CharacterLength::Absolute(positive("distance")?))
        }
        setting::NUDGE => controller.normal_nudge_factor = positive("normalNudgeFactor")?,
        _ => {
            return Err(Fault::number(
                "the setting",
                number.into(),
                "a setting of characters that can be set",
            ));
        }
    }
    Ok(())
}

exports! {
    /// Creates a character controller.
    fn character_new(offset: f64) -> u32 {
        let controller = KinematicCharacterController {
            offset: CharacterLength::Absolute(non_negative("offset", offset)? as Real),
            snap_to_ground: None,
            ..KinematicCharacterController::default()
        };
        // SAFETY: the reference ends with the statement.
        unsafe { CHARACTERS.get().insert(Character { controller, ..Character::default() }) }
    }

    /// Frees a character controller.
    fn character_free(number: u32) {
        // SAFETY: the reference ends with the statement.
        drop(unsafe { CHARACTERS.get().remove(number) });
    }

    /// Writes the direction up.
    fn character_up(number: u32) {
        put_vector(0, character(number)?.controller.up);
    }

    /// Sets the direction up.
    fn character_set_up(number: u32) {
        character(number)?.controller.up = memory::direction(0, "up")?;
    }

    /// A setting of a character.
    fn character_setting(number: u32, setting: u32) -> f64 {
        character_setting_of(&character(number)?.controller, setting)
    }

    /// Changes a setting of a character.
    fn character_set_setting(number: u32, setting: u32, value: f64) {
        change_character(&mut character(number)?.controller, setting, value)?;
    }

    /// Sets the steps that a character climbs.
    fn character_set_autostep(number: u32, height: f64, width: f64, include_dynamic: u32) {
        let autostep = CharacterAutostep {
            max_height: CharacterLength::Absolute(non_negative("maxHeight", height)? as Real),
            min_width: CharacterLength::Absolute(non_negative("minWidth", width)? as Real),
            include_dynamic_bodies: include_dynamic != 0,
        };
        character(number)?.controller.autostep = Some(autostep);
    }

    /// Disables snapping to the ground.
    fn character_clear_snap(number: u32) {
        character(number)?.controller.snap_to_ground = None;
    }

    /// Disables steps.
    fn character_clear_autostep(number: u32) {
        character(number)?.controller.autostep = None;
    }

    /// Computes the movement of a collider. The scratch block holds the desired translation. A mass that is
    /// not NaN pushes dynamic bodies.
    fn character_move(number: u32, world: u32, handle: f64, mass: f64) {
        let desired = vector(0, "desiredTranslationDelta")?;
        update_queries(world)?;
        let character_collider = collider(world, handle)?;
        let (shape, pose) = (character_collider.shared_shape().clone(), *character_collider.position());
        let parent = character_collider.parent();
        let own = ColliderHandle::of_number(handle);
        let controller = character(number)?.controller;
        let mut selection = filter();
        selection.exclude_collider = Some(own);
        selection.exclude_rigid_body = selection.exclude_rigid_body.or(parent);
        let mut collisions = Vec::new();
        let movement = queried(world, |world, queries| {
            let dt = world.integration_parameters.dt;
            let queries = queries.view(&world.colliders, selection);
            controller.move_shape(dt, &queries, &*shape, &pose, desired, |collision| collisions.push(collision))
        })?;
        if mass > 0.0 {
            let (world, queries) = controlled(world)?;
            let dt = world.integration_parameters.dt;
            let obstacles = QueryFilter { flags: selection.flags, groups: selection.groups, ..QueryFilter::default() };
            let mut queries = queries.view_mut(&mut world.bodies, &world.colliders, obstacles);
            controller.solve_character_collision_impulses(dt, &mut queries, &*shape, mass as Real, &collisions);
        }
        // A predicate may have freed the controller, so it is looked up again.
        let character = character(number)?;
        (character.movement, character.collisions) = (movement, collisions);
    }

    /// Writes the computed movement. Returns whether the character is grounded.
    fn character_movement(number: u32) -> bool {
        let movement = &character(number)?.movement;
        put_vector(0, movement.translation);
        movement.grounded
    }

    /// The number of collisions of the computed movement.
    fn character_collisions(number: u32) -> usize {
        character(number)?.collisions.len()
    }

    /// Writes a collision: movements applied and remaining, contact points, normals, time. Returns the
    /// collider, or NaN if there is no such collision.
    fn character_collision(number: u32, index: usize) -> f64 {
        let Some(collision) = character(number)?.collisions.get(index) else { return Ok(f64::NAN) };
        put_vector(0, collision.translation_applied);
        put_vector(1, collision.translation_remaining);
        put_vector(2, collision.hit.witness1);
        put_vector(3, collision.hit.witness2);
        put_vector(4, collision.hit.normal1);
        put_vector(5, collision.hit.normal2);
        put_number(6, 0, collision.hit.time_of_impact);
        collision.handle.to_number()
    }
}

/// Returns axes from the bits of TypeScript, which are those of the engine.
fn axes(bits: u32) -> AxesMask {
    AxesMask::from_bits_truncate(bits as u8)
}

/// Returns the vector with some components replaced: bit 0 is x.
fn with_components(vector: Vector, bits: u32, value: Real) -> Vector {
    let mut components = vector.to_array();
    for (at, component) in components.iter_mut().enumerate() {
        if bits & (1 << at) != 0 {
            *component = value;
        }
    }
    Vector::from_array(components)
}

/// A linear and an angular gain, with those of the axes replaced.
#[cfg(feature = "dim2")]
fn set_gain((linear, angular): (&mut Vector, &mut Real), axes: AxesMask, value: Real) {
    *linear = with_components(*linear, axes.bits().into(), value);
    if axes.contains(AxesMask::ANG_Z) {
        *angular = value;
    }
}

/// A linear and an angular gain, with those of the axes replaced.
#[cfg(not(feature = "dim2"))]
fn set_gain((linear, angular): (&mut Vector, &mut Vector), axes: AxesMask, value: Real) {
    *linear = with_components(*linear, axes.bits().into(), value);
    *angular = with_components(*angular, u32::from(axes.bits()) >> 3, value);
}

exports! {
    /// Creates a PID controller.
    fn pid_new(kp: f64, ki: f64, kd: f64, mask: u32) -> u32 {
        let [kp, ki, kd] = [finite("kp", kp)?, finite("ki", ki)?, finite("kd", kd)?].map(|gain| gain as Real);
        // SAFETY: the reference ends with the statement.
        unsafe { PIDS.get().insert(PidController::new(kp, ki, kd, axes(mask))) }
    }

    /// Frees a PID controller.
    fn pid_free(number: u32) {
        // SAFETY: the reference ends with the statement.
        drop(unsafe { PIDS.get().remove(number) });
    }

    /// Sets the proportional (0), integral (1) or derivative (2) gain of some axes.
    fn pid_set_gain(number: u32, kind: u32, value: f64, mask: u32) {
        let value = finite(["kp", "ki", "kd"][kind.min(2) as usize], value)? as Real;
        let controller = pid(number)?;
        let gain = match kind {
            0 => (&mut controller.pd.lin_kp, &mut controller.pd.ang_kp),
            1 => (&mut controller.lin_ki, &mut controller.ang_ki),
            _ => (&mut controller.pd.lin_kd, &mut controller.pd.ang_kd),
        };
        set_gain(gain, axes(mask), value);
    }

    /// Sets the axes that are corrected.
    fn pid_set_axes(number: u32, mask: u32) {
        pid(number)?.set_axes(axes(mask));
    }

    /// Resets the integrals.
    fn pid_reset(number: u32) {
        pid(number)?.reset_integrals();
    }

    /// Writes the correction of the linear velocity, and applies it on request: target position and velocity
    /// in places 0 and 1.
    fn pid_linear(number: u32, world: u32, handle: f64, apply: u32) {
        let (position, velocity) = (vector(0, "targetPosition")?, vector(1, "targetLinvel")?);
        let dt = read(world)?.integration_parameters.dt;
        let correction = pid(number)?.linear_rigid_body_correction(dt, body(world, handle)?, position, velocity);
        if apply != 0 {
            let body = body_mut(world, handle)?;
            body.set_linvel(body.linvel() + correction, true);
        }
        put_vector(0, correction);
    }

    /// Writes the correction of the angular velocity, and applies it on request: target rotation and velocity
    /// in places 0 and 1.
    fn pid_angular(number: u32, world: u32, handle: f64, apply: u32) {
        let (rotation, velocity) = (memory::rotation(0, "targetRotation")?, memory::angular(1, "targetAngVel")?);
        let dt = read(world)?.integration_parameters.dt;
        let correction = pid(number)?.angular_rigid_body_correction(dt, body(world, handle)?, rotation, velocity);
        if apply != 0 {
            let body = body_mut(world, handle)?;
            body.set_angvel(body.angvel() + correction, true);
        }
        put_angular(0, correction);
    }
}
