//! One body of every shape that can move, dropped from a little above the floor.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, cube, rock, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "all_shapes",
    description: "One body of every shape: round and edged, convex and not, with and without volume.",
    category: Category::Shapes,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: -1.0, reach_max: 9.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Shapes per row.
const COLUMNS: usize = 6;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    for (i, shape) in shapes().into_iter().enumerate() {
        let (row, column) = (i / COLUMNS, i % COLUMNS);
        let x = 2.6 * (column as Real - (COLUMNS - 1) as Real / 2.0);
        let z = 2.6 * (row as Real - 1.0);
        add(&mut world, Vector::new(x, 1.5, z), shape);
    }
    Scene::new(world, View::orbit(20.0, 32.0))
}

fn shapes() -> Vec<ColliderBuilder> {
    let corners = rock(&mut Dice::new(3), 0.75, 14);
    let (a, b, c) = (Vector::X * 0.8, Vector::Y * 0.2 - Vector::X * 0.6, Vector::Z * 0.9);
    let jack = [Vector::X, Vector::Y, Vector::Z]
        .map(|axis| (Pose::IDENTITY, SharedShape::capsule(axis * -0.6, axis * 0.6, 0.16)));
    let steps: Vec<Vector> = (0..4)
        .flat_map(|i| (0..=i).map(move |j| Vector::new(i as Real, j as Real, 0.0) * 0.35))
        .collect();
    // Shapes without volume need an explicit mass.
    let thin = |shape: ColliderBuilder| shape.mass(1.0);
    vec![
        ColliderBuilder::ball(0.6),
        ColliderBuilder::cuboid(0.7, 0.4, 0.5),
        ColliderBuilder::round_cuboid(0.55, 0.3, 0.4, 0.15),
        ColliderBuilder::capsule_x(0.5, 0.35),
        ColliderBuilder::capsule_from_endpoints(a, b, 0.2),
        cube(0.5).rotation(Vector::new(0.6, 0.0, 0.6)),
        ColliderBuilder::cylinder(0.5, 0.5),
        ColliderBuilder::round_cylinder(0.35, 0.45, 0.15),
        ColliderBuilder::cone(0.6, 0.6),
        ColliderBuilder::round_cone(0.45, 0.45, 0.15),
        ColliderBuilder::convex_hull(&corners).expect("the corners are not in one plane"),
        ColliderBuilder::round_convex_hull(&corners, 0.12)
            .expect("the corners are not in one plane"),
        ColliderBuilder::compound(jack.to_vec()),
        ColliderBuilder::voxels_from_points(Vector::splat(0.35), &steps),
        ColliderBuilder::trimesh(tetrahedron().0, tetrahedron().1)
            .expect("has triangles")
            .density(1.0),
        thin(ColliderBuilder::triangle(a, b, c)),
        ColliderBuilder::round_triangle(a, b, c, 0.1).mass(1.0),
        thin(ColliderBuilder::segment(-a, a)),
    ]
}

/// Returns a closed mesh.
fn tetrahedron() -> (Vec<Vector>, Vec<[u32; 3]>) {
    let corner = |x: Real, y: Real, z: Real| Vector::new(x, y, z) * 0.6;
    let corners = [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)];
    let vertices = corners.map(|(x, y, z)| corner(x, y, z)).to_vec();
    (vertices, vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
}
