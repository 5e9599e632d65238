//! Steps of changing length: programs whose steps last as long as their frames.

use super::stage::{add_ground, run, world};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// Lengths of steps (s) by the number of the step.
type Lengths = fn(usize) -> Real;

/// Frames that alternate, that get shorter and longer, and of a display whose rate is not that of the
/// program, with the distance (m) that boxes may move in ten seconds.
///
/// It is the allowed overlap: no rounding error of 32 bits adds up to it. In scattered steps over a range of
/// eight, the longest of the last fifth of a second changes, and with it the overlap of rest.
const SEQUENCES: [(&str, Lengths, Real); 7] = [
    ("1/60, 1/61", |step| [1.0 / 60.0, 1.0 / 61.0][step % 2], 1e-3),
    ("1/60, 1/120", |step| [1.0 / 60.0, 1.0 / 120.0][step % 2], 1e-3),
    ("1/30, 1/144", |step| [1.0 / 30.0, 1.0 / 144.0][step % 2], 1e-3),
    ("1/10, 1/240", |step| [1.0 / 10.0, 1.0 / 240.0][step % 2], 1e-3),
    (
        "1/30, then 1/144 nine times",
        |step| if step.is_multiple_of(10) { 1.0 / 30.0 } else { 1.0 / 144.0 },
        1e-3,
    ),
    ("1/75 to 1/50", |step| 1.0 / (75.0 - 25.0 * scattered(step)), 1e-3),
    ("1/240 to 1/30", |step| 1.0 / (240.0 - 210.0 * scattered(step)), 5e-3),
];

/// Numbers from 0 to 1 in no order.
fn scattered(step: usize) -> Real {
    (step as Real * 0.618_034).fract()
}

/// Steps for this time.
fn advance(world: &mut PhysicsWorld, lengths: Lengths, seconds: Real) {
    let (mut time, mut step) = (0.0, 0);
    while time < seconds {
        world.integration_parameters.dt = lengths(step);
        time += lengths(step);
        step += 1;
        world.step();
    }
}

/// Boxes on the ground, alone and on others, stay where they are once they have settled.
#[test]
fn boxes_stay_where_they_rest() {
    for (name, lengths, tolerance) in SEQUENCES {
        for (count, half) in [(1, 0.5), (1, 0.1), (2, 0.5), (2, 0.1), (3, 0.5), (3, 0.1), (8, 0.5)]
        {
            let mut world = world(60);
            add_ground(&mut world, 0.5);
            let boxes: Vec<_> = (0..count)
                .map(|k| {
                    let body = RigidBodyBuilder::dynamic().can_sleep(false);
                    let body = body.translation(vec(0.0, half * (2 * k + 1) as Real));
                    world.insert(body, cuboid(half, half)).0
                })
                .collect();
            let places = |world: &PhysicsWorld| -> Vec<_> {
                boxes.iter().map(|&handle| world.bodies[handle].translation()).collect()
            };
            advance(&mut world, lengths, 4.0);
            let settled = places(&world);
            advance(&mut world, lengths, 10.0);
            for (now, then) in places(&world).into_iter().zip(settled) {
                let moved = (now - then).length();
                assert!(moved < tolerance, "{count} boxes of {half} m, steps of {name}: {moved} m");
            }
        }
    }
}

/// Two boxes stay where they rest beside a stack that gets more substeps, so that islands are solved in
/// groups, and if a program edits their contacts before each step, so that these are computed again.
#[test]
fn boxes_stay_beside_others_and_with_edits() {
    for (has_stack, is_edited) in [(true, false), (false, true), (true, true)] {
        let mut world = world(60);
        add_ground(&mut world, 0.5);
        let plates = if has_stack { 12 } else { 0 };
        for k in 0..plates {
            let body = RigidBodyBuilder::dynamic().can_sleep(false);
            world.insert(body.translation(vec(5.0, 0.02 * (2 * k + 1) as Real)), cuboid(0.2, 0.02));
        }
        let boxes = [0.5, 1.5].map(|y| {
            let body = RigidBodyBuilder::dynamic().can_sleep(false).translation(vec(0.0, y));
            world.insert(body, cuboid(0.5, 0.5))
        });
        let mut settled = None;
        for step in 0..800 {
            world.integration_parameters.dt = [1.0 / 30.0, 1.0 / 144.0][step % 2];
            if is_edited {
                boxes.iter().for_each(|&(_, collider)| {
                    world.colliders[collider].set_friction([0.5, 0.6][step % 2]);
                });
            }
            world.step();
            if step < 200 {
                continue;
            }
            let places = boxes.map(|(body, _)| world.bodies[body].translation());
            for (now, then) in places.into_iter().zip(*settled.get_or_insert(places)) {
                let moved = (now - then).length();
                let what = format!("stack {has_stack}, edits {is_edited}, step {step}");
                assert!(moved < 1e-3, "{what}: {moved} m");
            }
        }
    }
}

/// A pile that settled in long steps falls asleep in short ones, and the other way round.
#[test]
fn piles_fall_asleep_after_a_change() {
    for [first, second] in [[1.0 / 30.0, 1.0 / 240.0], [1.0 / 240.0, 1.0 / 30.0]] {
        let mut world = world(60);
        add_ground(&mut world, 0.5);
        let handle =
            world.insert(RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5)), cuboid(0.5, 0.5));
        world.integration_parameters.dt = first;
        run(&mut world, 0.25);
        assert!(!world.bodies[handle.0].is_sleeping());
        world.integration_parameters.dt = second;
        run(&mut world, 3.0);
        assert!(world.bodies[handle.0].is_sleeping(), "steps of {first} s, then {second} s");
    }
}
