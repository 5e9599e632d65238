//! What the fuzzer does to bodies.

use super::super::random::Dice;
use super::super::values::{some_real, some_vector};
use super::Victim;
use crate::dim::{
    about_z,
    hostile::{broken_rotations, shapes},
};
use rapier::prelude::*;

const TYPES: [RigidBodyType; 5] = [
    RigidBodyType::Dynamic,
    RigidBodyType::Dynamic,
    RigidBodyType::Fixed,
    RigidBodyType::KinematicPositionBased,
    RigidBodyType::KinematicVelocityBased,
];

/// A pose that is usable most of the time.
pub fn some_pose(dice: &mut Dice) -> Pose {
    let mut pose =
        *RigidBodyBuilder::dynamic().rotation(about_z(dice.within(-3.0, 3.0))).build().position();
    pose.translation = some_vector(dice, 3.0);
    if dice.once_in(30) {
        pose.rotation = dice.pick(&broken_rotations());
    }
    pose
}

/// A collider of any kind.
pub fn some_collider(dice: &mut Dice) -> ColliderBuilder {
    let size = if dice.once_in(30) { some_real(dice) } else { dice.within(0.2, 0.8) };
    let events = if dice.coin() { ActiveEvents::all() } else { ActiveEvents::empty() };
    let mut collider =
        if dice.once_in(8) { dice.pick(&shapes(size)) } else { ColliderBuilder::ball(size) };
    if dice.once_in(4) {
        collider = collider.restitution(some_real(dice)).friction(some_real(dice));
    }
    if dice.once_in(20) {
        collider = collider.position(some_pose(dice)).contact_skin(some_real(dice));
    }
    collider.active_events(events).sensor(dice.once_in(8)).enabled(!dice.once_in(20))
}

/// A body with no, one or several colliders.
pub fn insert(victim: &mut Victim) {
    let dice = &mut victim.dice;
    let body = match victim.morgue.pop() {
        Some(body) if dice.coin() => body,
        _ => RigidBodyBuilder::new(dice.pick(&TYPES))
            .pose(some_pose(dice))
            .linvel(some_vector(dice, 5.0))
            .enabled(!dice.once_in(20))
            .sleeping(dice.once_in(10))
            .can_sleep(!dice.once_in(10))
            .build(),
    };
    let handle = victim.world.insert_body(body);
    victim.bodies.push(handle);
    for _ in 0..victim.dice.below(4).saturating_sub(1).max(1) {
        let collider = some_collider(&mut victim.dice);
        victim.colliders.push(victim.world.insert_collider(collider, Some(handle)));
    }
}

/// One body, or all of them.
pub fn remove(victim: &mut Victim) {
    if victim.dice.once_in(100) {
        for handle in victim.bodies.clone() {
            victim.world.remove_body(handle);
        }
    }
    let handle = victim.body();
    let existed = victim.world.bodies.contains(handle);
    let removed = victim.world.remove_body(handle);
    assert_eq!(removed.is_some(), existed);
    assert!(victim.world.remove_body(handle).is_none(), "{handle:?} was removed twice");
    victim.morgue.extend(removed);
    victim.morgue.truncate(4);
    if victim.dice.coin() {
        insert(victim); // into the same slot, before the next step
    }
}

/// Changes something about one body.
pub fn edit(victim: &mut Victim) {
    let (handle, other) = (victim.body(), victim.body());
    let dice = &mut victim.dice;
    if dice.once_in(20) {
        let copy = victim.world.bodies.get(other).cloned();
        if let (Some(copy), Some(body)) = (copy, victim.world.bodies.get_mut(handle)) {
            body.copy_from(&copy);
        }
        return;
    }
    if dice.once_in(40) {
        for (_, body) in victim.world.bodies.iter_mut() {
            push(body, dice);
        }
    }
    let Some(body) = victim.world.bodies.get_mut(handle) else { return };
    match dice.below(4) {
        0 => place(body, dice),
        1 => push(body, dice),
        2 => configure(body, dice),
        _ => reclassify(body, dice),
    }
}

fn place(body: &mut RigidBody, dice: &mut Dice) {
    let (pose, wake_up) = (some_pose(dice), dice.coin());
    match dice.below(6) {
        0 => body.set_position(pose, wake_up),
        1 => body.set_translation(pose.translation, wake_up),
        2 => body.set_rotation(pose.rotation, wake_up),
        3 => body.set_next_kinematic_position(pose),
        4 => body.set_next_kinematic_translation(pose.translation),
        _ => body.set_next_kinematic_rotation(pose.rotation),
    }
}

fn push(body: &mut RigidBody, dice: &mut Dice) {
    let (vector, point) = (some_vector(dice, 10.0), some_vector(dice, 3.0));
    let (turn, wake_up) = (about_z(some_real(dice)), dice.coin());
    match dice.below(12) {
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
        _ => body.reset_forces(wake_up),
    }
}

fn configure(body: &mut RigidBody, dice: &mut Dice) {
    let (value, wake_up) = (some_real(dice), dice.coin());
    match dice.below(12) {
        0 => body.set_linear_damping(value),
        1 => body.set_angular_damping(value),
        2 => body.set_gravity_scale(value, wake_up),
        3 => body.set_dominance_group(dice.within(-3.0, 3.0) as i8),
        4 => body.lock_rotations(dice.coin(), wake_up),
        5 => body.lock_translations(dice.once_in(3), wake_up),
        6 => body.set_soft_ccd_prediction(value),
        7 => body.set_additional_mass(value, wake_up),
        8 => {
            let mass = ColliderBuilder::ball(some_real(dice)).build().mass_properties();
            body.set_additional_mass_properties(mass, wake_up);
        }
        9 => body.enable_ccd(dice.coin()),
        10 => body.set_additional_solver_iterations(dice.below(3)),
        _ => {
            let activation = body.activation_mut();
            activation.normalized_linear_threshold = some_real(dice);
            activation.angular_threshold = some_real(dice);
            activation.time_until_sleep = some_real(dice);
        }
    }
}

fn reclassify(body: &mut RigidBody, dice: &mut Dice) {
    match dice.below(6) {
        0 => body.set_body_type(dice.pick(&TYPES), dice.coin()),
        1 => body.set_enabled(!dice.once_in(3)),
        2 => body.sleep(),
        3 => body.wake_up(dice.coin()),
        4 => body.activation_mut().sleeping = dice.coin(),
        _ => body.set_body_type(RigidBodyType::Dynamic, true),
    }
}
