//! Floors in 3D: surfaces over the plane of x and z.

use rapier::parry::utils::Array2;
use rapier::prelude::*;

/// Part of a velocity that leads along stairs.
pub const DIAGONAL: Vector = Vector::new(0.0, 0.0, 1.5);

/// Returns shapes with flat bottoms and round edges, and other flat bottoms, 1.8 m high.
pub fn bottoms() -> Vec<(&'static str, ColliderBuilder)> {
    vec![
        ("round box, border 0.2", ColliderBuilder::round_cuboid(0.1, 0.7, 0.1, 0.2)),
        ("round box, border 0.1", ColliderBuilder::round_cuboid(0.2, 0.8, 0.2, 0.1)),
        ("round box, border 0.05", ColliderBuilder::round_cuboid(0.3, 0.85, 0.3, 0.05)),
        ("round cylinder, border 0.1", ColliderBuilder::round_cylinder(0.8, 0.2, 0.1)),
        ("round cylinder, border 0.02", ColliderBuilder::round_cylinder(0.88, 0.3, 0.02)),
        ("cylinder", ColliderBuilder::cylinder(0.9, 0.3)),
        ("cone", ColliderBuilder::cone(0.9, 0.3)),
        ("box", ColliderBuilder::cuboid(0.3, 0.9, 0.3)),
    ]
}

/// Returns a surface along a line from left to right, of quads across.
pub fn surface(line: &[(Real, Real)]) -> ColliderBuilder {
    let across = |&(x, y): &(Real, Real)| [-30.0, 30.0].map(|z| Vector::new(x, y, z));
    let points = line.iter().flat_map(across).collect();
    let quads = (0..line.len() as u32 - 1).map(|k| 2 * k);
    let triangles = quads.flat_map(|k| [[k, k + 1, k + 2], [k + 1, k + 3, k + 2]]).collect();
    ColliderBuilder::trimesh(points, triangles).expect("a sound mesh")
}

fn sample(half_side: Real, cells: usize, i: usize) -> Real {
    half_side * (2.0 * i as Real / cells as Real - 1.0)
}

/// Returns a mesh of triangles with heights as a function of x.
pub fn mesh(half_side: Real, cells: usize, height: impl Fn(Real) -> Real) -> ColliderBuilder {
    let at = |i| sample(half_side, cells, i);
    let count = cells as u32 + 1;
    let points = (0..=cells).flat_map(|i| (0..=cells).map(move |j| (i, j)));
    let points = points.map(|(i, j)| Vector::new(at(i), height(at(i)), 0.13 + at(j))).collect();
    let mut triangles = Vec::new();
    for corner in (0..count - 1).flat_map(|i| (0..count - 1).map(move |j| i * count + j)) {
        triangles.push([corner, corner + 1, corner + count]);
        triangles.push([corner + 1, corner + count + 1, corner + count]);
    }
    ColliderBuilder::trimesh(points, triangles).expect("a sound mesh")
}

/// Returns a height field with heights as a function of x.
pub fn heights(half_side: Real, cells: usize, height: impl Fn(Real) -> Real) -> ColliderBuilder {
    let mut field = Array2::zeros(cells + 1, cells + 1);
    for (i, j) in (0..=cells).flat_map(|i| (0..=cells).map(move |j| (i, j))) {
        field[(i, j)] = height(sample(half_side, cells, j));
    }
    ColliderBuilder::heightfield(field, Vector::new(2.0 * half_side, 1.0, 2.0 * half_side))
}
