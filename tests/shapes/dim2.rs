//! Shapes of the shared tests of this folder, in 2D.

use crate::suite::shapes::outlines::{area, outlines};
use parry::shape::{ConvexPolygon, HeightField, Polyline, RoundShape, TriMesh, TriMeshFlags};
use rapier::prelude::*;

/// Points on a line.
fn line(half: Real) -> Vec<Vector> {
    [-1.0, 0.3, 1.0, -0.2].map(|x| Vector::new(x * half, 0.0)).to_vec()
}

/// Returns floors without thickness whose top is at height 0.
pub fn flat_floors() -> Vec<(&'static str, ColliderBuilder)> {
    let quarter = core::f64::consts::FRAC_PI_2 as Real;
    let below = Vector::new(0.0, -0.1);
    let tilt = Rotation::new(0.7);
    let tilted: Vec<Vector> = line(5.0).into_iter().map(|corner| tilt * corner).collect();
    let round = ColliderBuilder::round_convex_hull(&line(5.0), 0.1).expect("a line");
    vec![
        ("box without height", ColliderBuilder::cuboid(5.0, 0.0)),
        ("box without width", ColliderBuilder::cuboid(0.0, 5.0).rotation(quarter)),
        ("round box without height", ColliderBuilder::round_cuboid(5.0, 0.0, 0.0)),
        ("round box", ColliderBuilder::round_cuboid(5.0, 0.0, 0.1).translation(below)),
        ("capsule", ColliderBuilder::capsule_x(5.0, 0.0)),
        ("hull of a line", ColliderBuilder::convex_hull(&line(5.0)).expect("a line")),
        ("hull of a tilted line", {
            ColliderBuilder::convex_hull(&tilted).expect("a line").rotation(-0.7)
        }),
        ("polygon of a line", ColliderBuilder::convex_polyline(line(5.0)).expect("a line")),
        ("round hull", round.translation(below)),
        (
            "polyline with equal points",
            ColliderBuilder::polyline(vec![line(5.0)[0], line(5.0)[0], line(5.0)[2]], None),
        ),
    ]
}

/// Returns bodies and their heights at rest.
pub fn bodies() -> Vec<(&'static str, ColliderBuilder, Real)> {
    let corners: Vec<Vector> =
        [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(Vector::from_array).to_vec();
    vec![
        ("box", ColliderBuilder::cuboid(0.5, 0.5), 0.5),
        ("ball", ColliderBuilder::ball(0.3), 0.3),
        ("capsule", ColliderBuilder::capsule_x(0.3, 0.3), 0.3),
        ("hull", ColliderBuilder::convex_hull(&corners).expect("a box"), 0.5),
        ("round box", ColliderBuilder::round_cuboid(0.4, 0.4, 0.1), 0.5),
    ]
}

/// Returns bodies without thickness, their heights at rest, and their areas or lengths.
pub fn flat_bodies() -> Vec<(&'static str, ColliderBuilder, Real, Real)> {
    let end = Vector::new(0.5, 0.0);
    let third = Vector::new(0.1, 0.0);
    let quarter_circle = 0.25 * core::f64::consts::PI as Real;
    vec![
        ("rod", ColliderBuilder::cuboid(0.5, 0.0), 0.0, 1.0),
        ("capsule", ColliderBuilder::capsule_x(0.5, 0.0), 0.0, 1.0),
        ("capsule without length", ColliderBuilder::capsule_x(0.0, 0.5), 0.5, quarter_circle),
        ("flat hull", ColliderBuilder::convex_hull(&line(0.5)).expect("a line"), 0.0, 1.0),
        ("round rod", ColliderBuilder::round_cuboid(0.5, 0.0, 0.1), 0.1, 1.0),
        ("triangle in a line", ColliderBuilder::triangle(-end, end, third), 0.0, 1.0),
        ("round line", ColliderBuilder::round_triangle(-end, end, third, 0.1), 0.1, 1.0),
    ]
}

/// Returns points on lines of many slopes.
pub fn flat_clouds() -> Vec<(String, Vec<Vector>)> {
    let cases = (2..8_usize).flat_map(|count| (0..8).map(move |turn| (count, turn)));
    let cloud = |(count, turn): (usize, usize)| {
        let angle = 0.37 * turn as Real;
        let along = Vector::new(angle.cos(), angle.sin()) * 0.37;
        let points = (0..count).map(|i| along * i as Real + Vector::Y * angle).collect();
        (format!("{count} points at {angle:.2}"), points)
    };
    cases.map(cloud).collect()
}

/// Returns shapes that are points.
pub fn points_without_size() -> Vec<(&'static str, ColliderBuilder)> {
    let zero = Vector::ZERO;
    vec![
        ("ball", ColliderBuilder::ball(0.0)),
        ("box", ColliderBuilder::cuboid(0.0, 0.0)),
        ("capsule", ColliderBuilder::capsule_x(0.0, 0.0)),
        ("segment", ColliderBuilder::segment(zero, zero)),
        ("triangle", ColliderBuilder::triangle(zero, zero, zero)),
        ("polyline", ColliderBuilder::polyline(vec![zero; 3], None)),
    ]
}

/// Returns shapes with one size, and the name of the size.
pub fn of_size(size: Real) -> Vec<(&'static str, ColliderBuilder)> {
    vec![
        ("radius", ColliderBuilder::ball(size)),
        ("half_extents", ColliderBuilder::cuboid(1.0, size)),
        ("half_extents", ColliderBuilder::round_cuboid(size, 1.0, 0.1)),
        ("radius", ColliderBuilder::capsule_y(1.0, size)),
        ("half_height", ColliderBuilder::capsule_y(size, 1.0)),
    ]
}

/// Returns scales, most of them mirrors.
pub fn scales() -> Vec<Vector> {
    [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [1.0, 0.4], [-2.0, 0.4], [2.0, -0.4]]
        .map(Vector::from_array)
        .to_vec()
}

/// A shape that parry has scaled: its shape, the height of its top, and the mass of its area.
pub struct Scaled {
    pub name: &'static str,
    pub shape: SharedShape,
    pub top: Real,
    pub mass: Real,
}

/// Returns the shapes of this dimension, scaled by parry.
pub fn scaled_shapes(scale: Vector) -> Vec<Scaled> {
    let top = 0.5 * scale.y.abs();
    let scaled = |name, shape: &dyn Shape, top, mass| {
        let shape = SharedShape(shape.scale_dyn(scale, 16).expect("a shape").into());
        Scaled { name, shape, top, mass }
    };
    let gem = [[-2.0, -0.5], [2.3, -0.5], [2.9, 0.1], [2.3, 0.5], [-2.0, 0.5], [-2.6, 0.1]];
    let gem = gem.map(Vector::from_array).to_vec();
    let polygon = ConvexPolygon::from_convex_polyline(gem.clone()).expect("a polygon");
    let points: Vec<Vector> = gem.iter().map(|point| *point * scale).collect();
    let mass = ColliderBuilder::convex_hull(&points).expect("a polygon").build().mass();
    let round = RoundShape { inner_shape: polygon.clone(), border_radius: 0.1 };
    let corners = [[-3.0, -0.5], [3.0, -0.5], [3.0, 0.5], [-3.0, 0.5]].map(Vector::from_array);
    let mesh =
        TriMesh::with_flags(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]], TriMeshFlags::empty());
    let chain = Polyline::new(corners.to_vec(), Some(vec![[0, 1], [1, 2], [2, 3], [3, 0]]));
    let heights = [-0.8, -0.5, -0.6, 0.0, 0.0, 0.0, -0.7, -0.4, -0.9];
    let heights = heights.map(|height| height * scale.y.signum()).to_vec();
    let field = HeightField::new(heights, Vector::splat(16.0));
    vec![
        scaled("polygon", &polygon, top, mass),
        scaled("round polygon", &round, top + 0.1, mass),
        scaled("mesh", &mesh.expect("a box"), top, 6.0 * (scale.x * scale.y).abs()),
        scaled("polyline", &chain, top, 0.0),
        scaled("height field", &field, 0.0, 0.0),
    ]
}

/// Returns floors with their backs up, and the same with their fronts up.
pub fn one_sided_floors() -> Vec<(&'static str, ColliderBuilder, ColliderBuilder)> {
    let points: Vec<Vector> =
        (0..9_u8).map(|k| Vector::new(2.0 * Real::from(k) - 8.0, 0.0)).collect();
    // Solid on the left of the direction.
    let up: Vec<Vector> = points.iter().rev().copied().collect();
    let chain = |points| ColliderBuilder::oriented_polyline(points, None);
    vec![("polyline", chain(points), chain(up))]
}

/// Number of bodies without thickness, of 40, that may pass ridges.
pub const PASSED_MAX: usize = 8;

/// Returns bodies without thickness.
pub fn slender_bodies() -> Vec<(&'static str, ColliderBuilder)> {
    let end = Vector::new(0.3, 0.0);
    vec![
        ("segment", ColliderBuilder::segment(-end, end)),
        ("rod", ColliderBuilder::cuboid(0.3, 0.0)),
        ("capsule", ColliderBuilder::capsule_x(0.3, 0.0)),
        ("polyline", ColliderBuilder::polyline(vec![-end, Vector::ZERO, end], None)),
    ]
}

/// Returns a floor of ridges.
pub fn ridges() -> ColliderBuilder {
    let ridge = |k: i8| if k % 2 == 0 { 0.0 } else { 0.3 };
    let points = (-20..=20_i8).map(|k| Vector::new(0.4 * Real::from(k), ridge(k)));
    ColliderBuilder::polyline(points.collect(), None)
}

/// A shape's name, the points and elements of its surface, and its volume.
type Notched = (&'static str, Vec<Vector>, Vec<[u32; 2]>, Real);

/// Segments around an outline, with indices from `first`.
fn closed(count: u32, first: u32) -> impl Iterator<Item = [u32; 2]> {
    (0..count).map(move |k| [first + k, first + (k + 1) % count])
}

/// Returns shapes with notches and a hole.
pub fn notched() -> Vec<Notched> {
    let mut shapes: Vec<Notched> = Vec::new();
    for (name, outline) in outlines() {
        let points = outline.iter().copied().map(Vector::from_array).collect();
        shapes.push((name, points, closed(outline.len() as u32, 0).collect(), area(&outline)));
    }
    let circle = |reach: Real, sign: Real| {
        (0..32_u8).map(move |k| {
            let angle = core::f64::consts::TAU as Real / 32.0 * sign * Real::from(k);
            [reach * angle.cos(), reach * angle.sin()]
        })
    };
    let (outer, inner): (Vec<_>, Vec<_>) =
        (circle(2.0, 1.0).collect(), circle(1.5, -1.0).collect());
    let ring_area = area(&outer) + area(&inner);
    let points = outer.into_iter().chain(inner).map(Vector::from_array).collect();
    shapes.push(("ring", points, closed(32, 0).chain(closed(32, 32)).collect(), ring_area));
    shapes
}

/// Returns the surface of a comb, the height of its notches, and the size of a voxel.
pub fn combs() -> (Vec<Vector>, Vec<[u32; 2]>, Real, Real) {
    let (_, points, indices, _) = notched().swap_remove(0);
    (points, indices, 0.5, 9.0 / 256.0)
}
