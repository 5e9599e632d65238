//! Character controllers, and bodies that follow a target.

use super::colliders::OTHERS;
use super::play::Play;
use super::queries::some_shape;
use super::rapier::prelude::*;
use super::values::{some_pose, some_positive, some_real, some_vector};
use crate::choices::Choices;

/// Moves a character, or a body that follows a target.
pub fn walk(play: &mut Play<'_>) {
    if play.choices.coin() { walk_as_character(play) } else { follow(play) }
}

fn walk_as_character(play: &mut Play<'_>) {
    let (character, collider) = (play.body(), play.collider());
    let Play { choices, world, .. } = play;
    let controller = some_controller(choices);
    let Some(shape) = some_shape(choices) else { return };
    let pose = match world.bodies.get(character) {
        Some(body) if choices.coin() => *body.position(),
        _ => some_pose(choices, 3.0),
    };
    let dt = if choices.once_in(8) { some_real(choices) } else { 1.0 / 60.0 };
    let desired = some_vector(choices, 1.0);
    let filter = QueryFilter::default().groups(OTHERS).exclude_rigid_body(character);
    let mut collisions = Vec::new();
    let view = world.query_pipeline_with_filter(filter);
    let note = |collision| collisions.push(collision);
    let moved = if choices.once_in(4) {
        let mut contacts = CharacterContacts::new();
        let hooks = CharacterHooks {
            hooks: &(),
            bodies: &world.bodies,
            character: collider,
            contacts: &mut contacts,
        };
        controller.move_shape_with_hooks(dt, &view, &*shape, &pose, desired, hooks, note)
    } else {
        controller.move_shape(dt, &view, &*shape, &pose, desired, note)
    };
    assert!(moved.translation.is_finite(), "a character walks {:?}", moved.translation);
    let mass = some_positive(choices);
    let mut queries = world.query_pipeline_mut(filter);
    controller.solve_character_collision_impulses(dt, &mut queries, &*shape, mass, &collisions);
    if let Some(body) = world.bodies.get_mut(character) {
        body.set_next_kinematic_translation(body.translation() + moved.translation);
    }
}

fn some_controller(choices: &mut Choices<'_>) -> KinematicCharacterController {
    let mut controller = KinematicCharacterController::default();
    for _ in 0..choices.below(4) {
        let value = some_real(choices);
        let lengths = [CharacterLength::Absolute(value), CharacterLength::Relative(value)];
        let length = choices.pick(&lengths);
        match choices.below(9) {
            0 => controller.up = some_vector(choices, 1.0),
            1 => controller.offset = length,
            2 => controller.slide = choices.coin(),
            3 => {
                let (max_height, min_width) = (length, choices.pick(&lengths));
                let include_dynamic_bodies = choices.coin();
                controller.autostep =
                    Some(CharacterAutostep { max_height, min_width, include_dynamic_bodies });
            }
            4 => controller.max_slope_climb_angle = value,
            5 => controller.min_slope_slide_angle = value,
            6 => controller.snap_to_ground = Some(length),
            7 => controller.normal_nudge_factor = value,
            _ => controller.slope_speed = CharacterSlopeSpeed::Horizontal,
        }
    }
    controller
}

fn follow(play: &mut Play<'_>) {
    let handle = play.body();
    let Play { choices, world, pid, .. } = play;
    let Some(body) = world.bodies.get_mut(handle) else { return };
    if choices.once_in(4) {
        let (kp, ki, kd) = (some_real(choices), some_real(choices), some_real(choices));
        *pid = PidController::new(kp, ki, kd, AxesMask::all());
    }
    let (target, dt) =
        (some_pose(choices, 3.0), if choices.coin() { 1.0 / 60.0 } else { some_real(choices) });
    let correction = pid.rigid_body_correction(dt, body, target, RigidBodyVelocity::zero());
    body.set_vels(body.vels() + correction, choices.coin());
}
