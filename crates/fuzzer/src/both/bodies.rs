//! Operations on bodies.

use super::colliders::some_collider;
use super::dim::about_z;
use super::play::{BODIES_MAX, COLLIDERS_MAX, Play};
use super::rapier::prelude::*;
use super::values::choose;
use super::values::{some_pose, some_positive, some_real, some_vector, within};
use crate::choices::Choices;

const TYPES: [RigidBodyType; 6] = [
    RigidBodyType::Dynamic,
    RigidBodyType::Dynamic,
    RigidBodyType::Dynamic,
    RigidBodyType::Fixed,
    RigidBodyType::KinematicPositionBased,
    RigidBodyType::KinematicVelocityBased,
];

/// Inserts a body with no, one or several colliders.
pub fn insert(play: &mut Play<'_>) {
    if play.world.bodies.len() >= BODIES_MAX {
        return remove(play);
    }
    let choices = &mut play.choices;
    let body = match play.removed.pop() {
        Some(body) if choices.coin() => body,
        _ => some_body(choices),
    };
    let handle = play.world.insert_body(body);
    play.bodies.push(handle);
    for _ in 0..[1, 1, 1, 0, 2, 3][play.choices.below(6)] {
        if play.world.colliders.len() < COLLIDERS_MAX {
            let collider = some_collider(&mut play.choices);
            play.colliders.push(play.world.insert_collider(collider, Some(handle)));
        }
    }
}

fn some_body(choices: &mut Choices<'_>) -> RigidBody {
    let body = RigidBodyBuilder::new(choices.pick(&TYPES)).pose(some_pose(choices, 3.0));
    if choices.coin() {
        return body.build();
    }
    body.linvel(some_vector(choices, 5.0))
        .angvel(about_z(some_real(choices)))
        .enabled(!choices.once_in(16))
        .sleeping(choices.once_in(8))
        .can_sleep(!choices.once_in(8))
        .ccd_enabled(choices.once_in(3))
        .soft_ccd_prediction(some_positive(choices))
        .additional_solver_iterations(choices.below(3))
        .build()
}

/// Removes one body, or all bodies.
pub fn remove(play: &mut Play<'_>) {
    if play.choices.once_in(100) {
        for handle in play.bodies.clone() {
            play.world.remove_body(handle);
        }
    }
    let handle = play.body();
    let existed = play.world.bodies.contains(handle);
    let removed = play.world.remove_body(handle);
    assert_eq!(removed.is_some(), existed);
    assert!(play.world.remove_body(handle).is_none(), "{handle:?} was removed twice");
    play.removed.extend(removed);
    play.removed.truncate(4);
    if play.choices.coin() && play.world.bodies.len() < BODIES_MAX {
        insert(play); // into the same slot, before the next step
    }
}

/// Edits one body, or all bodies.
pub fn edit(play: &mut Play<'_>) {
    let (handle, other) = (play.body(), play.body());
    let Play { choices, world, isolated_bodies, .. } = play;
    match choose(choices, 32) {
        0 => {
            let copy = world.bodies.get(other).cloned();
            if let (Some(copy), Some(body)) = (copy, world.bodies.get_mut(handle)) {
                body.copy_from(&copy);
            }
        }
        1 => {
            // A record replaces another. The position in the world belongs to the slot.
            let copy = world.bodies.get(other).cloned();
            if let (Some(copy), Some(body)) = (copy, world.bodies.get_mut(handle)) {
                *body = copy;
            }
        }
        2 => {
            if let (Some(body1), Some(body2)) = world.bodies.get_pair_mut(handle, other) {
                core::mem::swap(body1, body2);
            }
        }
        3 => {
            let others = world
                .bodies
                .iter_mut()
                .filter(|(handle, _)| !isolated_bodies.bodies.contains(handle));
            others.for_each(|(_, body)| push(body, choices));
        }
        choice => {
            let Some(body) = world.bodies.get_mut(handle) else { return };
            match choice % 4 {
                0 => place(body, choices),
                1 => push(body, choices),
                2 => configure(body, choices),
                _ => reclassify(body, choices),
            }
        }
    }
}

fn place(body: &mut RigidBody, choices: &mut Choices<'_>) {
    let (pose, wake_up) = (some_pose(choices, 3.0), choices.coin());
    match choose(choices, 6) {
        0 => body.set_position(pose, wake_up),
        1 => body.set_translation(pose.translation, wake_up),
        2 => body.set_rotation(pose.rotation, wake_up),
        3 => body.set_next_kinematic_position(pose),
        4 => body.set_next_kinematic_translation(pose.translation),
        _ => body.set_next_kinematic_rotation(pose.rotation),
    }
}

fn push(body: &mut RigidBody, choices: &mut Choices<'_>) {
    let (vector, point) = (some_vector(choices, 10.0), some_vector(choices, 3.0));
    let (turn, wake_up) = (about_z(some_real(choices)), choices.coin());
    match choose(choices, 12) {
        0 => body.set_linvel(vector, wake_up),
        1 => body.set_angvel(turn, wake_up),
        2 => body.set_vels(RigidBodyVelocity::new(vector, turn), wake_up),
        3 => body.add_force(vector, wake_up),
        4 => body.add_torque(turn, wake_up),
        5 => body.add_force_at_point(vector, point, wake_up),
        6 => body.apply_impulse(vector, wake_up),
        7 => body.apply_torque_impulse(turn, wake_up),
        8 => body.apply_impulse_at_point(vector, point, wake_up),
        9 => body.reset_torques(wake_up),
        10 => body.set_linvel(vector * 50.0, wake_up), // fast enough to pass through things
        _ => body.reset_forces(wake_up),
    }
}

fn configure(body: &mut RigidBody, choices: &mut Choices<'_>) {
    let (value, wake_up) = (some_real(choices), choices.coin());
    match choose(choices, 13) {
        0 => body.set_linear_damping(value),
        1 => body.set_angular_damping(value),
        2 => body.set_gravity_scale(value, wake_up),
        3 => body.set_dominance_group(within(choices, -3.0, 3.0) as i8),
        4 => body.lock_rotations(choices.coin(), wake_up),
        5 => body.lock_translations(choices.once_in(3), wake_up),
        6 => body.set_soft_ccd_prediction(value),
        7 => body.set_additional_mass(value, wake_up),
        8 => {
            let mass = ColliderBuilder::ball(some_positive(choices)).build().mass_properties();
            body.set_additional_mass_properties(mass, wake_up);
        }
        9 => body.enable_ccd(choices.coin()),
        10 => body.set_additional_solver_iterations(choices.below(3)),
        11 => {
            body.set_locked_axes(LockedAxes::from_bits_truncate(choices.below(64) as u8), wake_up)
        }
        _ => {
            let activation = body.activation_mut();
            activation.normalized_linear_threshold = value;
            activation.angular_threshold = some_real(choices);
            activation.time_until_sleep = some_real(choices);
        }
    }
}

fn reclassify(body: &mut RigidBody, choices: &mut Choices<'_>) {
    match choose(choices, 6) {
        0 => body.set_body_type(choices.pick(&TYPES), choices.coin()),
        1 => body.set_enabled(!choices.once_in(3)),
        2 => body.sleep(),
        3 => body.wake_up(choices.coin()),
        4 => body.activation_mut().sleeping = choices.coin(),
        _ => body.set_body_type(RigidBodyType::Dynamic, true),
    }
}
