//! Recording of a pile, which the tests of the Python package replay.
//!
//! ```text
//! cargo run --release -p replay --example recording -- python/tests/data/pile.recording
//! ```
//!
//! The boxes fall onto a plane, a push hits the lowest one, and the gravity turns. The output is the hash of
//! the last step.

use rapier3d::prelude::*;
use std::error::Error;

/// Boxes of the pile.
const COUNT: usize = 6;
/// Steps of the recording.
const STEPS: usize = 90;
/// Steps before the push and before the turn of the gravity.
const PUSH: usize = 30;
const TURN: usize = 60;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("the argument is the path of the recording")?;
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let boxes = (0..COUNT).map(|layer| place_box(&mut world, layer)).collect::<Vec<_>>();
    let mut recorder = Recorder::new(&world, "a pile, a push and a turn of the gravity")?;
    for step in 0..STEPS {
        match step {
            PUSH => world.bodies[boxes[0]].apply_impulse(Vector::X, true),
            TURN => world.gravity = Vector::new(3.0, -9.0, 0.0),
            _ => {}
        }
        recorder.step(&mut world)?;
    }
    std::fs::write(&path, recorder.bytes())?;
    println!("{path}: {} bytes, hash {:#018x}", recorder.bytes().len(), world.hash());
    Ok(())
}

/// Inserts a box of a layer.
fn place_box(world: &mut PhysicsWorld, layer: usize) -> RigidBodyHandle {
    let place = Vector::new(0.0625 * layer as Real, 0.5 + 0.75 * layer as Real, 0.0);
    let body = RigidBodyBuilder::dynamic().translation(place);
    world.insert(body, ColliderBuilder::cuboid(0.5, 0.25, 0.375)).0
}
