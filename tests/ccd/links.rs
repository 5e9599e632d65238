//! Links of multibodies do not pass through bodies. The stop of one link stops the multibody.

use super::{PHASES, RADIUS, SPEEDS, wall};
use crate::dim::{about_z, ang_length, cuboid, hinge, vec};
use crate::suite::multibody::stage::{angular_momentum, kinetic_energy, momentum};
use crate::suite::physics::stage::{G, weightless};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Adds a chain of balls, side by side across the x axis at `at`, with hinges at the middles between them.
/// The first ball is a free root.
fn add_chain(
    world: &mut PhysicsWorld,
    at: Vector,
    aslant: Real,
    count: usize,
    [velocity, spin]: [Real; 2],
) -> Vec<RigidBodyHandle> {
    let (step, mut bodies) = (vec(aslant, 1.0).normalize() * (4.0 * RADIUS), Vec::new());
    let center = step * (0.5 * (count - 1) as Real);
    for k in 0..count {
        let place = step * k as Real;
        let arm = place - center;
        let v = vec(velocity, 0.0) + vec(-arm.y, arm.x) * spin;
        let body = RigidBodyBuilder::dynamic().translation(at + place).linvel(v);
        let body = body.angvel(about_z(spin)).can_sleep(false);
        let (body, _) = world.insert(body, ColliderBuilder::ball(RADIUS).friction(0.0));
        if let Some(&parent) = bodies.last() {
            let joint = hinge().local_anchor1(step * 0.5).local_anchor2(step * -0.5);
            let joint = world.insert_multibody_joint(parent, body, joint);
            joint.expect("the joint fits");
        }
        bodies.push(body);
    }
    bodies
}

fn add_wall(world: &mut PhysicsWorld) {
    world.insert_collider(wall(), None);
}

/// At 1000 m/s chains that do not hit with all links at once rotate by dozens of radians in a step. One link
/// in twenty passes: docs/guide/fast-bodies.md.
#[test]
fn chains_do_not_pass_walls() {
    let columns = ["speed", "upright", "aslant", "turning"];
    let mut table = Table::new("chains of links of which one passes a wall, of 20", &columns);
    for speed in SPEEDS {
        let passed = |aslant: Real, spin: Real| {
            let passes = |phase: usize| {
                let mut world = weightless(60);
                add_wall(&mut world);
                let way = speed / 60.0 * (2.0 + phase as Real / PHASES as Real) + 1.0;
                let chain = add_chain(&mut world, vec(-way, 0.0), aslant, 5, [speed, spin]);
                (0..20).any(|_| {
                    world.step();
                    chain.iter().any(|&link| world.bodies[link].translation().x > 0.0)
                })
            };
            (0..PHASES).filter(|&phase| passes(phase)).count()
        };
        let counts = [passed(0.0, 0.0), passed(0.5, 0.0), passed(0.0, 50.0)];
        let [a, b, c] = counts.map(|count| count.to_string());
        table.row([format!("{speed}"), a, b, c]);
        let whips = if speed < 1000.0 { counts[1] + counts[2] } else { 0 };
        table.require(counts[0] + whips == 0, "chains passed");
    }
}

/// An arm on a fixed hinge stops at a post that it would skip without CCD. Its joint does not separate.
#[test]
fn arms_do_not_skip_posts() {
    for speed in [20.0, 60.0, 200.0, 1000.0] {
        for phase in 0..8 {
            let mut world = weightless(60);
            world.insert_collider(cuboid(0.02, 0.02).translation(vec(0.0, 0.9)), None);
            let post = world.insert_body(RigidBodyBuilder::fixed());
            // The arm starts before the post, within the quarter revolution that leads to it.
            let start = 0.3 + 0.12 * phase as Real;
            let arm = vec(0.5 * start.cos(), 0.5 * start.sin());
            let body = RigidBodyBuilder::dynamic().translation(arm).rotation(about_z(start));
            let body = body.linvel(vec(-arm.y, arm.x) * speed).angvel(about_z(speed));
            let (arm, _) = world.insert(body, cuboid(0.5, 0.02).friction(0.0));
            let joint = hinge().local_anchor2(vec(-0.5, 0.0));
            world.insert_multibody_joint(post, arm, joint).expect("the joint fits");
            for _ in 0..20 {
                world.step();
                let tip = world.bodies[arm].position() * vec(0.5, 0.0);
                assert!(tip.x > -0.1, "{speed} rad/s from {start}: passed the post to {tip}");
                let root = world.bodies[arm].position() * vec(-0.5, 0.0);
                assert!(root.length() < 1.0e-4, "the hinge is at {root}");
            }
        }
    }
}

/// In the step of the stop no contact has pushed the chain yet: momentum and energy have their values before
/// the stop.
#[test]
fn stopped_chains_keep_momentum_and_energy() {
    for spin in [0.0, 5.0, 20.0] {
        let mut world = weightless(60);
        add_wall(&mut world);
        let chain = add_chain(&mut world, vec(-4.0, 0.0), 0.3, 4, [60.0, spin]);
        let state = |world: &PhysicsWorld| {
            let (p, l) = (momentum(world, &chain), angular_momentum(world, &chain));
            (p, l, kinetic_energy(world, &chain))
        };
        let (p, l, energy) = state(&world);
        let mut stopped = 0;
        while stopped == 0 {
            world.step();
            stopped = world.physics_pipeline.counters.ccd.num_substeps;
        }
        assert_eq!(stopped, chain.len(), "all links are stopped together");
        let (p2, l2, energy2) = state(&world);
        // The error of the return to the time of impact is of third order in the angle of a segment (half a
        // radian at most): (0.5)³/12.
        let close = 0.01;
        assert!((p2 - p).length() < close * p.length(), "{spin}: momentum {p} became {p2}");
        let angular = ang_length(l2 - l);
        assert!(
            angular < close * (ang_length(l) + 1.0),
            "{spin}: angular momentum off by {angular}"
        );
        assert!((energy2 / energy - 1.0).abs() < close, "{spin}: energy {energy} became {energy2}");
    }
}

/// A chain that falls on a thin floor at 100 m/s stays above it, and never exceeds its initial energy.
#[test]
fn fallen_chains_gain_no_energy() {
    let mut world = weightless(60);
    world.gravity = vec(0.0, -G);
    world.insert_collider(cuboid(50.0, 0.01), None);
    let chain = add_chain(&mut world, vec(0.0, 10.0), 0.7, 5, [0.0, 0.0]);
    for &link in &chain {
        world.bodies[link].set_linvel(vec(0.0, -100.0), true);
    }
    let energy = |world: &PhysicsWorld| -> Real {
        let of = |&link: &RigidBodyHandle| {
            let body = &world.bodies[link];
            body.kinetic_energy() + body.mass() * G * body.translation().y
        };
        chain.iter().map(of).sum()
    };
    let start = energy(&world);
    for _ in 0..120 {
        world.step();
        for &link in &chain {
            let at = world.bodies[link].translation();
            assert!(at.y > 0.0, "a link is at {at}");
        }
        // Gravity is integrated in substeps. Half a substep of it at this speed is 100 · 9.81/480 of 5000 per
        // mass.
        assert!(energy(&world) < start * 1.002, "energy {start} became {}", energy(&world));
    }
}
