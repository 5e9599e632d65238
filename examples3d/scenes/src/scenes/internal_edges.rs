//! Internal edges: ground of many pieces acts like one surface.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_fixed, cube};
use crate::rapier::parry::utils::Array2;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "seams",
    description: "Boxes, balls and capsules glide over lanes of a mesh, a height field, tiles and hulls.",
    category: Category::PastBugs,
    steps: 210,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 39.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Length of a lane (m).
const LENGTH: usize = 36;
/// Distance of neighbouring lanes.
const SPACING: Real = 3.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let lanes = [mesh_lane, field_lane, tile_lane, hull_lane, compound_lane];
    for (index, lane) in lanes.into_iter().enumerate() {
        let z = SPACING * (index as Real - 2.0);
        lane(&mut world, Vector::new(0.0, 0.0, z));
        for (x, shape) in [
            (5.0, cube(0.5)),
            (3.0, ColliderBuilder::ball(0.5)),
            (1.0, ColliderBuilder::capsule_x(0.4, 0.5)),
        ] {
            let body = RigidBodyBuilder::dynamic()
                .translation(Vector::new(x, 0.5, z + 0.2))
                .linvel(Vector::X * 8.0);
            world.insert(body, shape.friction(0.0));
        }
        // A step at the end stops the bodies.
        add_fixed(&mut world, Vector::new(LENGTH as Real, 0.0, z), cube(0.8));
    }
    Scene::new(world, View::orbit(32.0, 30.0))
        .focusing(Vector::new(10.0, 0.0, -7.0), Vector::new(36.0, 1.0, 7.0))
}

/// Returns the middles of square tiles of 1 m, two side by side.
fn tiles() -> impl Iterator<Item = Vector> {
    let row = |i: usize| [-0.5, 0.5].map(|z| Vector::new(i as Real + 0.5, -0.5, z));
    (0..LENGTH).flat_map(row)
}

fn mesh_lane(world: &mut PhysicsWorld, place: Vector) {
    let vertices = (0..=LENGTH).flat_map(|i| [-1.0, 1.0].map(|z| Vector::new(i as Real, 0.0, z)));
    let square = |i: u32| [[2 * i, 2 * i + 1, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 2]];
    let triangles = (0..LENGTH as u32).flat_map(square).collect();
    let mesh = ColliderBuilder::trimesh(vertices.collect(), triangles).expect("it has triangles");
    add_fixed(world, place, mesh.friction(0.0));
}

fn field_lane(world: &mut PhysicsWorld, place: Vector) {
    let heights = Array2::zeros(3, LENGTH + 1);
    let scale = Vector::new(LENGTH as Real, 1.0, 2.0);
    let field = ColliderBuilder::heightfield(heights, scale).friction(0.0);
    add_fixed(world, place + Vector::X * (0.5 * LENGTH as Real), field);
}

fn tile_lane(world: &mut PhysicsWorld, place: Vector) {
    for tile in tiles() {
        add_fixed(world, place + tile, cube(0.5).friction(0.0));
    }
}

fn hull_lane(world: &mut PhysicsWorld, place: Vector) {
    let corner = |x: Real| [-0.5, 0.5].map(|y| [-0.5, 0.5].map(|z| Vector::new(x, y, z)));
    let corners: Vec<_> = [-0.5, 0.5].into_iter().flat_map(corner).flatten().collect();
    let lane = world.insert_body(RigidBodyBuilder::fixed().translation(place));
    for tile in tiles() {
        let hull = ColliderBuilder::convex_hull(&corners).expect("a cube has a hull");
        world.insert_collider(hull.translation(tile).friction(0.0), Some(lane));
    }
}

fn compound_lane(world: &mut PhysicsWorld, place: Vector) {
    let part = |tile| (Pose::from_translation(tile), SharedShape::cuboid(0.5, 0.5, 0.5));
    let lane = ColliderBuilder::compound(tiles().map(part).collect());
    add_fixed(world, place, lane.friction(0.0));
}
