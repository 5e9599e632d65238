//! Continuous collision detection: bodies that move through a wall's thickness in one step still hit it.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add_fixed, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "bullets",
    description: "Balls at 50 to 1000 m/s and rotating bars against walls of 2 cm: none tunnels through.",
    category: Category::Robustness,
    steps: 300,
    law: Law { overlap_max: 0.02, ..Law::NONE },
    source: file!(),
    build,
};

/// Distance of neighbouring lanes (m).
const SPACING: Real = 3.4;
/// Speeds of the lanes (m/s).
const SPEEDS: [Real; 4] = [50.0, 100.0, 400.0, 1000.0];
/// Steps between two volleys.
const VOLLEY: usize = 12;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    for lane in 0..SPEEDS.len() {
        let place = Vector::new(0.0, 1.5, z_of(lane));
        let wall = match lane % 2 {
            0 => ColliderBuilder::cuboid(0.01, 1.5, 1.5),
            _ => plate(),
        };
        add_fixed(&mut world, place, wall);
        // Side walls keep the heap in its lane.
        for side in [-1.6, 1.6] {
            let board = ColliderBuilder::cuboid(2.0, 0.4, 0.01);
            add_fixed(&mut world, Vector::new(-2.0, 0.4, place.z + side), board);
        }
    }
    Scene::new(world, View::orbit(-62.0, 30.0))
        .focusing(Vector::new(-2.6, 0.0, z_of(0) - 1.2), Vector::new(0.0, 1.6, z_of(3) + 1.2))
        .script(|world, step| {
            if step % VOLLEY == 0 && step < 180 {
                fire(world, step / VOLLEY);
            }
        })
}

/// Returns a wall of triangles, one sheet without thickness.
fn plate() -> ColliderBuilder {
    let corners = [(-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5)];
    let corners = corners.map(|(y, z)| Vector::new(0.0, y, z)).to_vec();
    ColliderBuilder::trimesh(corners, vec![[0, 1, 2], [0, 2, 3]]).expect("it has two triangles")
}

fn z_of(lane: usize) -> Real {
    SPACING * (lane as Real - 1.5)
}

/// Fires a volley in each lane: six balls, and in some volleys a bar.
fn fire(world: &mut PhysicsWorld, volley: usize) {
    for (lane, speed) in SPEEDS.into_iter().enumerate() {
        // Start points differ, because a step is up to 17 m long.
        let x = -20.0 - speed / 60.0 * (volley % 7) as Real / 7.0;
        for k in 0..6 {
            let [row, column] = [k / 3, k % 3].map(|n| n as Real);
            let z = z_of(lane) + 0.7 * (column - 1.0) + 0.03 * (volley % 5) as Real;
            let body = RigidBodyBuilder::dynamic()
                .translation(Vector::new(x, 1.0 + 0.8 * row + 0.05 * (volley % 3) as Real, z))
                .linvel(Vector::X * speed);
            world.insert(body, ColliderBuilder::ball(0.09).restitution(0.1));
        }
        if matches!(volley % 5, 1 | 3) {
            fire_bar(world, Vector::new(x, 1.4, z_of(lane)), speed);
        }
    }
}

/// Fires a thin bar that rotates in flight.
fn fire_bar(world: &mut PhysicsWorld, place: Vector, speed: Real) {
    let body = RigidBodyBuilder::dynamic()
        .translation(place)
        .rotation(Vector::X * (0.3 * HALF_TURN))
        .linvel(Vector::X * speed)
        .angvel(Vector::new(0.0, 60.0, 20.0));
    world.insert(body, ColliderBuilder::cuboid(0.02, 0.4, 0.04));
}
