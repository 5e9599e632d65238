//! Cost of a multibody by its size: chains of hinges that swing from a post, timed step by step. Variants
//! have a limit at each joint that is not reached, a motor with a force limit at each joint, or lie on
//! ground.
//!
//! The time per link of the first variant should not depend on their number: all passes over a chain go from
//! link to link. An impulse on one link moves all others. Each contact, limit or motor therefore costs time
//! in proportion to the number of links, and one per link costs the square of it.
//!
//! ```text
//! cargo run --release -p rapier3d --example chains
//! ```

use rapier3d::prelude::*;
use std::time::Instant;

/// Number of timed steps, after some steps for the growth of buffers.
const STEPS: usize = 200;
/// Number of rounds. The fastest one counts, because a busy machine slows others down.
const ROUNDS: usize = 5;

fn main() {
    println!("{:>8} {:>6} {:>12} {:>16}", "chain", "links", "µs a step", "ns a link, step");
    for kind in [Kind::Swings, Kind::Limits, Kind::Motors, Kind::Lies] {
        for count in [10, 30, 100, 300] {
            let fastest = (0..ROUNDS).map(|_| time(kind, count)).fold(f64::INFINITY, f64::min);
            let (kind, per_link) = (format!("{kind:?}"), fastest * 1.0e9 / count as f64);
            println!("{kind:>8} {count:>6} {:>12.1} {per_link:>16.0}", fastest * 1.0e6);
        }
    }
}

/// Variant of the chain.
#[derive(Copy, Clone, Debug)]
enum Kind {
    Swings,
    Limits,
    Motors,
    Lies,
}

/// Returns the seconds per step of a chain of this many links.
fn time(kind: Kind, count: usize) -> f64 {
    let mut world = chain(kind, count);
    for _ in 0..10 {
        world.step();
    }
    let start = Instant::now();
    for _ in 0..STEPS {
        world.step();
    }
    start.elapsed().as_secs_f64() / STEPS as f64
}

/// Builds a chain of rods of length 1 that is released sideways, or lies on ground. Successive hinges are
/// perpendicular, as in a real chain.
fn chain(kind: Kind, count: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let mut parent = world.insert_body(RigidBodyBuilder::fixed());
    if let Kind::Lies = kind {
        let ground = ColliderBuilder::cuboid(1000.0, 1.0, 1000.0);
        world.insert_collider(ground.translation(vector![0.0, -1.1, 0.0]), None);
    }
    let rod = MassProperties::from_cuboid(1.0, vector![0.5, 0.1, 0.1]);
    for k in 0..count {
        let at = vector![k as Real + 0.5, 0.0, 0.0];
        let body = RigidBodyBuilder::dynamic().translation(at).additional_mass_properties(rod);
        let body = world.insert_body(body.can_sleep(false));
        if let Kind::Lies = kind {
            let rod = ColliderBuilder::cuboid(0.45, 0.1, 0.1).density(0.0);
            world.insert_collider(rod, Some(body));
        }
        let axis = if k % 2 == 0 { Vector::Z } else { Vector::Y };
        let end = if k == 0 { 0.0 } else { 0.5 };
        let hinge = RevoluteJointBuilder::new(axis)
            .local_anchor1(vector![end, 0.0, 0.0])
            .local_anchor2(vector![-0.5, 0.0, 0.0]);
        let hinge = match kind {
            Kind::Limits => hinge.limits([-3.0, 3.0]),
            Kind::Motors => hinge.motor_velocity(0.0, 1.0e3).motor_max_force(10.0),
            Kind::Swings | Kind::Lies => hinge,
        };
        world.multibody_joints.insert(parent, body, hinge, true).expect("a chain is a tree");
        parent = body;
    }
    world
}
