//! One body of every shape that can move, dropped from a little above the floor.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, stone, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "all_shapes",
    description: "One body of every shape: round and edged, convex and not, with and without area.",
    category: Category::Shapes,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: -1.0, reach_max: 13.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let shapes = shapes();
    let center = (shapes.len() - 1) as Real / 2.0;
    for (i, shape) in shapes.into_iter().enumerate() {
        let place = Vector::new(2.1 * (i as Real - center), 1.6 + 0.8 * (i % 2) as Real);
        add(&mut world, place, shape);
    }
    Scene::new(world, View::flat())
}

fn shapes() -> Vec<ColliderBuilder> {
    let corners = stone(&mut Dice::new(3), 0.75, 7);
    let (a, b, c) = (Vector::new(-0.7, -0.4), Vector::new(0.7, -0.4), Vector::new(0.1, 0.7));
    let cross = [Vector::X, Vector::Y]
        .map(|axis| (Pose::IDENTITY, SharedShape::capsule(axis * -0.7, axis * 0.7, 0.18)));
    let steps: Vec<Vector> = (0..4)
        .flat_map(|i| (0..=i).map(move |j| Vector::new(i as Real, j as Real) * 0.35))
        .collect();
    let star = [(0.0, 0.0), (0.8, 0.1), (0.3, 0.4), (0.1, 0.9), (-0.3, 0.4), (-0.8, 0.1)];
    let star = star.map(|(x, y)| Vector::new(x, y)).to_vec();
    let fan = vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
    vec![
        ColliderBuilder::ball(0.6),
        ColliderBuilder::cuboid(0.7, 0.4),
        ColliderBuilder::round_cuboid(0.55, 0.3, 0.2),
        ColliderBuilder::capsule_x(0.5, 0.35),
        ColliderBuilder::triangle(a, b, c),
        ColliderBuilder::round_triangle(a, b, c, 0.15),
        ColliderBuilder::convex_hull(&corners).expect("the corners are not in one line"),
        ColliderBuilder::round_convex_hull(&corners, 0.15)
            .expect("the corners are not in one line"),
        ColliderBuilder::compound(cross.to_vec()),
        ColliderBuilder::voxels_from_points(Vector::splat(0.35), &steps),
        ColliderBuilder::trimesh(star, fan).expect("has triangles"),
        // Shapes without area need an explicit mass.
        ColliderBuilder::segment(Vector::new(-0.8, 0.0), Vector::new(0.8, 0.3)).mass(1.0),
    ]
}
