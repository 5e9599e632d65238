//! Operations on whole sets, and on the world as a whole.
//!
//! The sets belong together, as `PhysicsPipeline::step` documents. Most exchanges include all sets, some only
//! one.

use super::play::Play;
use super::rapier::prelude::*;
use super::world_copy::WorldCopy;

/// Copies, exchanges, wakes or discards sets.
pub fn edit_sets(play: &mut Play<'_>) {
    let handle = play.body();
    let variant = play.choices.below(13);
    play.choices.print(|| format!("    variant {variant}"));
    match variant {
        0 | 1 => play.copy = Some(WorldCopy::of(&play.world)),
        2 | 3 => {
            if let Some(copy) = &mut play.copy {
                copy.exchange(&mut play.world);
                play.event_checker.mark_missed_events();
            }
        }
        4 => {
            let PhysicsWorld { gravity, integration_parameters, .. } = play.world;
            play.world = PhysicsWorld { gravity, integration_parameters, ..PhysicsWorld::new() };
            play.event_checker.mark_missed_events();
        }
        5 => play.world.wake_up_all(play.choices.coin()),
        6 => {
            let colliders = &mut play.world.colliders;
            play.world.bodies.propagate_modified_body_positions_to_colliders(colliders);
        }
        7 => {
            let PhysicsWorld { bodies, colliders, .. } = &mut play.world;
            if let Some(body) = bodies.get_mut(handle) {
                body.recompute_mass_properties_from_colliders(colliders);
            }
        }
        8 => {
            let which = play.choices.below(7);
            let mut empty = WorldCopy::of(&PhysicsWorld::new());
            let old = play.copy.as_mut().filter(|_| play.choices.coin());
            old.unwrap_or(&mut empty).exchange_one(&mut play.world, which);
            play.event_checker.mark_missed_events();
        }
        9 | 10 => restore_records(play, handle),
        _ => play.world.wake_up(handle, play.choices.coin()),
    }
}

/// Restores earlier records of a body and a collider. One of them may be removed before the next step.
fn restore_records(play: &mut Play<'_>, handle: RigidBodyHandle) {
    let collider = play.collider();
    let Play { choices, copy: Some(copy), world, .. } = play else { return };
    if let (Some(old), Some(body)) = (copy.bodies.get(handle), world.bodies.get_mut(handle)) {
        *body = old.clone();
    }
    let (is_restored, is_edited) = (choices.coin(), choices.coin());
    if let Some(old) = copy.colliders.get(collider).filter(|_| is_restored)
        && let Some(collider) = world.colliders.get_mut(collider)
    {
        *collider = old.clone();
    }
    if let Some(body) = world.bodies.get_mut(handle).filter(|_| is_edited) {
        body.wake_up(true);
    }
    match choices.below(4) {
        0 => drop(world.remove_body(handle)),
        1 => drop(world.remove_collider(collider)),
        _ => {}
    }
}

/// Replaces any sets, or a record, by those of a twin. A twin is a copy with one displaced body, or a copy
/// that has advanced by some steps.
pub fn mix_with_twin(play: &mut Play<'_>) {
    let (handle, along) = (play.body(), play.choices.below(DIM));
    let mut twin = PhysicsWorld {
        gravity: play.world.gravity,
        integration_parameters: play.world.integration_parameters,
        ..PhysicsWorld::new()
    };
    let mut copy = WorldCopy::of(&play.world);
    copy.exchange(&mut twin);
    if let Some(body) = twin.bodies.get_mut(handle) {
        let place = body.translation() + Vector::AXES[along] * 1.0e-3;
        body.set_translation(place, play.choices.coin());
    }
    for _ in 0..play.choices.below(3) {
        twin.step();
    }
    let (sets, records) = (play.choices.below(128), play.choices.coin());
    play.choices.print(|| format!("    sets {sets:07b}, {handle:?} along {along}, {records}"));
    if records {
        exchange_records(play, &mut twin, handle);
    }
    let mut twin = WorldCopy::of(&twin);
    for which in (0..7).filter(|which| sets & (1 << which) != 0) {
        twin.exchange_one(&mut play.world, which);
    }
    play.event_checker.mark_missed_events();
}

/// Exchanges a body with the twin's body of the same handle. The twin's colliders may be attached to other
/// bodies.
fn exchange_records(play: &mut Play<'_>, twin: &mut PhysicsWorld, handle: RigidBodyHandle) {
    let collider = play.collider();
    if twin.bodies.contains(handle) {
        twin.colliders.set_parent(collider, Some(handle), &mut twin.bodies);
    }
    if let (Some(own), Some(other)) =
        (play.world.bodies.get_mut(handle), twin.bodies.get_mut(handle))
    {
        core::mem::swap(own, other);
    }
    if let (Some(own), Some(other)) =
        (play.world.colliders.get_mut(collider), twin.colliders.get_mut(collider))
    {
        core::mem::swap(own, other);
    }
}
