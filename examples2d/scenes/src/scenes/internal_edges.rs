//! Internal edges: ground of many pieces acts like one surface.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_fixed, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "seams",
    description: "Boxes, balls and capsules glide over storeys of a polyline, a height field, tiles and hulls.",
    category: Category::PastBugs,
    steps: 210,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 39.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Length of a storey (m).
const LENGTH: usize = 36;
/// Distance of neighbouring storeys.
const SPACING: Real = 3.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let storeys = [polyline, height_field, tiles, hulls, compound];
    for (index, lay) in storeys.into_iter().enumerate() {
        let place = Vector::Y * (SPACING * index as Real);
        lay(&mut world, place);
        for (x, shape) in [
            (5.0, square(0.5)),
            (3.0, ColliderBuilder::ball(0.5)),
            (1.0, ColliderBuilder::capsule_x(0.4, 0.5)),
        ] {
            let body = RigidBodyBuilder::dynamic()
                .translation(place + Vector::new(x, 0.5))
                .linvel(Vector::X * 8.0);
            world.insert(body, shape.friction(0.0));
        }
        // A step at the end stops the bodies.
        add_fixed(&mut world, place + Vector::X * LENGTH as Real, square(0.8));
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-1.0, -2.0), Vector::new(38.0, 14.0))
}

/// Returns the middles of square tiles of 1 m.
fn middles() -> impl Iterator<Item = Vector> {
    (0..LENGTH).map(|i| Vector::new(i as Real + 0.5, -0.5))
}

fn polyline(world: &mut PhysicsWorld, place: Vector) {
    let vertices = (0..=LENGTH).map(|i| Vector::X * i as Real).collect();
    add_fixed(world, place, ColliderBuilder::polyline(vertices, None).friction(0.0));
}

fn height_field(world: &mut PhysicsWorld, place: Vector) {
    let length = LENGTH as Real;
    let field = ColliderBuilder::heightfield(vec![0.0; LENGTH + 1], Vector::new(length, 1.0));
    add_fixed(world, place + Vector::X * (0.5 * length), field.friction(0.0));
}

fn tiles(world: &mut PhysicsWorld, place: Vector) {
    for middle in middles() {
        add_fixed(world, place + middle, square(0.5).friction(0.0));
    }
}

fn hulls(world: &mut PhysicsWorld, place: Vector) {
    let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(Vector::from_array);
    let storey = world.insert_body(RigidBodyBuilder::fixed().translation(place));
    for middle in middles() {
        let hull = ColliderBuilder::convex_hull(&corners).expect("a square has a hull");
        world.insert_collider(hull.translation(middle).friction(0.0), Some(storey));
    }
}

fn compound(world: &mut PhysicsWorld, place: Vector) {
    let part = |middle| (Pose::from_translation(middle), SharedShape::cuboid(0.5, 0.5));
    let storey = ColliderBuilder::compound(middles().map(part).collect());
    add_fixed(world, place, storey.friction(0.0));
}
