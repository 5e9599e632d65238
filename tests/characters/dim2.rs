//! Floors in 2D: lines over the x axis.

use rapier::prelude::*;

/// Part of a velocity that leads along stairs: there is none in 2D.
pub const DIAGONAL: Vector = Vector::ZERO;

/// Returns shapes with flat bottoms and round edges, and other flat bottoms, 1.8 m high.
pub fn bottoms() -> Vec<(&'static str, ColliderBuilder)> {
    vec![
        ("round box, border 0.2", ColliderBuilder::round_cuboid(0.1, 0.7, 0.2)),
        ("round box, border 0.1", ColliderBuilder::round_cuboid(0.2, 0.8, 0.1)),
        ("round box, border 0.05", ColliderBuilder::round_cuboid(0.3, 0.85, 0.05)),
        ("box", ColliderBuilder::cuboid(0.3, 0.9)),
    ]
}

/// Returns a surface along a line from left to right.
pub fn surface(line: &[(Real, Real)]) -> ColliderBuilder {
    let points = line.iter().map(|&(x, y)| Vector::new(x, y)).collect();
    ColliderBuilder::polyline(points, None)
}

fn sample(half_side: Real, cells: usize, i: usize) -> Real {
    half_side * (2.0 * i as Real / cells as Real - 1.0)
}

/// Returns a polyline with heights as a function of x.
pub fn mesh(half_side: Real, cells: usize, height: impl Fn(Real) -> Real) -> ColliderBuilder {
    let at = |i| sample(half_side, cells, i);
    let points = (0..=cells).map(|i| Vector::new(at(i), height(at(i)))).collect();
    ColliderBuilder::polyline(points, None)
}

/// Returns a height field with heights as a function of x.
pub fn heights(half_side: Real, cells: usize, height: impl Fn(Real) -> Real) -> ColliderBuilder {
    let heights = (0..=cells).map(|i| height(sample(half_side, cells, i))).collect();
    ColliderBuilder::heightfield(heights, Vector::new(2.0 * half_side, 1.0))
}
