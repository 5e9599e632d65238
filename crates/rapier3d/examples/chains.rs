//! What a multibody costs as it grows: chains of hinges that swing from a post, timed step by step.
//!
//! The time per link should not depend on their number: all passes over a chain go from link to link.
//!
//! ```text
//! cargo run --release -p rapier3d --example chains
//! ```

use rapier3d::prelude::*;
use std::time::Instant;

/// Steps that are timed, after a few that fill the buffers.
const STEPS: usize = 200;
/// Rounds; the fastest one counts, since a busy machine makes others slower.
const ROUNDS: usize = 5;

fn main() {
    println!("{:>6} {:>12} {:>16}", "links", "µs a step", "ns a link, step");
    for count in [10, 25, 50, 100, 200, 400] {
        let fastest = (0..ROUNDS).map(|_| time(count)).fold(f64::INFINITY, f64::min);
        let per_link = fastest * 1.0e9 / count as f64;
        println!("{count:>6} {:>12.1} {per_link:>16.0}", fastest * 1.0e6);
    }
}

/// Seconds per step of a chain of this many links.
fn time(count: usize) -> f64 {
    let mut world = chain(count);
    for _ in 0..10 {
        world.step();
    }
    let start = Instant::now();
    for _ in 0..STEPS {
        world.step();
    }
    start.elapsed().as_secs_f64() / STEPS as f64
}

/// A chain of rods of length 1 that is let go sideways. Its hinges stand across each other, as those of a real chain.
fn chain(count: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let mut parent = world.insert_body(RigidBodyBuilder::fixed());
    let rod = MassProperties::from_cuboid(1.0, vector![0.5, 0.1, 0.1]);
    for k in 0..count {
        let at = vector![k as Real + 0.5, 0.0, 0.0];
        let body = RigidBodyBuilder::dynamic().translation(at).additional_mass_properties(rod);
        let body = world.insert_body(body.can_sleep(false));
        let axis = if k % 2 == 0 { Vector::Z } else { Vector::Y };
        let end = if k == 0 { 0.0 } else { 0.5 };
        let hinge = RevoluteJointBuilder::new(axis)
            .local_anchor1(vector![end, 0.0, 0.0])
            .local_anchor2(vector![-0.5, 0.0, 0.0]);
        world.multibody_joints.insert(parent, body, hinge, true).expect("a chain is a tree");
        parent = body;
    }
    world
}
