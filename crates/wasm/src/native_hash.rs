//! Prints the hash of a scene of piles after steps on this machine: `native-hash STEPS`. The test
//! `hash.test.mjs` builds the same scene in JavaScript.

#[cfg(feature = "dim2")]
use rapier2d as rapier;
#[cfg(all(feature = "dim3", not(feature = "dim2")))]
use rapier3d as rapier;

use rapier::prelude::*;

/// Layers of the piles.
const LAYERS: usize = 12;

/// A position of the scene. 2D omits z.
#[cfg(feature = "dim2")]
fn at(x: Real, y: Real, _z: Real) -> Vector {
    Vector::new(x, y)
}

/// A position of the scene. 2D omits z.
#[cfg(not(feature = "dim2"))]
fn at(x: Real, y: Real, z: Real) -> Vector {
    Vector::new(x, y, z)
}

/// The ground.
#[cfg(feature = "dim2")]
fn ground() -> ColliderBuilder {
    ColliderBuilder::cuboid(50.0, 1.0)
}

/// The ground.
#[cfg(not(feature = "dim2"))]
fn ground() -> ColliderBuilder {
    ColliderBuilder::cuboid(50.0, 1.0, 50.0)
}

/// Shapes of the scene, in turn.
fn shape(number: usize) -> ColliderBuilder {
    match number % 3 {
        #[cfg(feature = "dim2")]
        0 => ColliderBuilder::cuboid(0.5, 0.25),
        #[cfg(not(feature = "dim2"))]
        0 => ColliderBuilder::cuboid(0.5, 0.25, 0.375),
        1 => ColliderBuilder::ball(0.375),
        _ => ColliderBuilder::capsule_y(0.25, 0.25),
    }
}

fn main() {
    let steps = std::env::args().nth(1).and_then(|steps| steps.parse().ok()).unwrap_or(1000);
    let mut world = PhysicsWorld::new();
    world.insert(RigidBodyBuilder::fixed().translation(at(0.0, -1.0, 0.0)), ground());
    let mut number = 0;
    for layer in 0..LAYERS {
        for row in 0..3 {
            for column in 0..3 {
                let (x, y, z) = (column as Real * 1.25, layer as Real + 1.0, row as Real * 1.25);
                let body = RigidBodyBuilder::dynamic().translation(at(x + y * 0.03125, y, z));
                world.insert(body, shape(number));
                number += 1;
            }
        }
    }
    for _ in 0..steps {
        world.step();
    }
    println!("{:016x}", world.hash());
}
