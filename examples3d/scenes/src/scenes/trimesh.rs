//! Bodies on a triangle mesh.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, cube};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "trimesh",
    description: "Balls, boxes and capsules roll down a bowl with ripples, made of 7,200 triangles.",
    category: Category::Shapes,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 6.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of rings of the bowl, and of sectors per ring.
const RINGS: u32 = 40;
const SECTORS: u32 = 90;
/// Radius of the bowl.
const RADIUS: Real = 9.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let (vertices, triangles) = bowl();
    let shape = ColliderBuilder::trimesh(vertices, triangles);
    world.insert(RigidBodyBuilder::fixed(), shape.expect("the bowl has triangles"));
    for i in 0..120 {
        let angle = 0.6 * i as Real;
        let distance = 2.5 + 0.04 * i as Real;
        let place =
            Vector::new(distance * angle.cos(), 4.0 + 0.05 * i as Real, distance * angle.sin());
        let shape = match i % 3 {
            0 => ColliderBuilder::ball(0.35),
            1 => cube(0.3),
            _ => ColliderBuilder::capsule_y(0.3, 0.25),
        };
        add(&mut world, place, shape);
    }
    Scene::new(world, View::orbit(25.0, 42.0))
        .focusing(Vector::new(-6.0, 0.5, -4.0), Vector::new(6.0, 3.5, 4.0))
}

/// Returns the height of the bowl at a distance from its axis.
fn height(distance: Real, angle: Real) -> Real {
    let t = distance / RADIUS;
    4.5 * t * t + 0.25 * t * (6.0 * angle).cos()
}

/// Returns rings around a middle vertex, divided into sectors.
fn bowl() -> (Vec<Vector>, Vec<[u32; 3]>) {
    let mut vertices = vec![Vector::ZERO];
    for ring in 1..=RINGS {
        let distance = RADIUS * ring as Real / RINGS as Real;
        for sector in 0..SECTORS {
            let angle = 2.0 * HALF_TURN * sector as Real / SECTORS as Real;
            vertices.push(Vector::new(
                distance * angle.cos(),
                height(distance, angle),
                distance * angle.sin(),
            ));
        }
    }
    let id = |ring: u32, sector: u32| 1 + (ring - 1) * SECTORS + sector % SECTORS;
    let mut triangles: Vec<[u32; 3]> = (0..SECTORS).map(|s| [0, id(1, s + 1), id(1, s)]).collect();
    for ring in 1..RINGS {
        for s in 0..SECTORS {
            triangles.push([id(ring, s), id(ring, s + 1), id(ring + 1, s)]);
            triangles.push([id(ring, s + 1), id(ring + 1, s + 1), id(ring + 1, s)]);
        }
    }
    (vertices, triangles)
}
