//! Fast bodies without an impact keep their path.

use super::{RADIUS, add_ball};
use crate::dim::grounds::GROUNDS;
use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::{G, weightless, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A box slides at 100 m/s over grounds of many pieces, and begins a contact with one after the
/// other. Its height and speed are constant.
#[test]
fn fast_sliding_bodies_keep_their_speed() {
    let mut table =
        Table::new("a box that slides at 100 m/s", &["ground", "bump (mm)", "slowest (m/s)"]);
    // Closed meshes are excluded: the box is half a metre deep in their sides, which accelerate it at this
    // speed.
    for (name, lay) in GROUNDS.into_iter().filter(|(name, _)| *name != "closed meshes") {
        let mut world = world(240);
        world.gravity = vec(0.0, -G);
        lay(&mut world, Pose::IDENTITY, 0.0);
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.25)).linvel(vec(100.0, 0.0));
        let (slider, _) = world.insert(body, cuboid(0.25, 0.25).friction(0.0));
        let (mut bump, mut slowest): (Real, Real) = (0.0, 100.0);
        // The number of steps is the length of the grounds.
        for _ in 0..100 {
            world.step();
            let body = &world.bodies[slider];
            bump = bump.max((body.translation().y - 0.25).abs());
            slowest = slowest.min(body.linvel().x);
        }
        let way = world.bodies[slider].translation().x;
        table.row([name.to_owned(), format!("{:.2}", 1000.0 * bump), format!("{slowest:.3}")]);
        // The duration is 100 steps of 1/240 s.
        table.check("the way", way, 100.0 * 100.0 / 240.0, 0.05);
        table.require(bump < 0.002, "it bumped");
    }
}

#[test]
fn near_misses_are_misses() {
    for gap in [0.001, 0.01, 0.1] {
        let mut world = weightless(60);
        world.insert_collider(cuboid(1.0, 1.0), None);
        let ball = add_ball(&mut world, vec(-10.0, 1.0 + RADIUS + gap), vec(900.0, 0.0));
        for step in 1..=4 {
            world.step();
            let x = -10.0 + 900.0 * step as Real / 60.0;
            let at = world.bodies[ball].translation();
            assert!(
                (at.x - x).abs() < 1.0e-3,
                "a ball that passes at {gap} is at {} not {x}",
                at.x
            );
        }
    }
}

/// A body on a thin floor stays there after an impact from above.
#[test]
fn a_hit_stack_stays_above_the_floor() {
    let mut world = world(60);
    world.insert_collider(cuboid(5.0, 0.01).translation(vec(0.0, -0.01)), None);
    let mut boxes = Vec::new();
    for level in 0..4 {
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.25 + 0.5 * level as Real));
        boxes.push(world.insert(body, cuboid(0.25, 0.25)).0);
    }
    let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 20.0)).linvel(vec(0.0, -100.0));
    boxes.push(world.insert(body, cuboid(0.25, 0.25).density(10.0)).0);
    for _ in 0..300 {
        world.step();
        for &body in &boxes {
            let at = world.bodies[body].translation();
            assert!(at.y > 0.0 || at.x.abs() > 5.0, "a box is at {at}");
        }
    }
}
