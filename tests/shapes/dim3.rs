//! Shapes of the shared tests of this folder, in 3D.

use crate::suite::shapes::outlines::{area, outlines};
use core::f64::consts::{FRAC_PI_2, TAU};
use parry::shape::{
    ConvexPolyhedron, Cuboid, HeightField, HeightFieldFlags, RoundShape, TriMesh, TriMeshFlags,
};
use parry::utils::Array2;
use rapier::prelude::*;

/// Corners of a square in the plane of x and z.
fn square(half: Real) -> Vec<Vector> {
    [[-half, -half], [half, -half], [half, half], [-half, half]]
        .map(|[x, z]| Vector::new(x, 0.0, z))
        .to_vec()
}

/// Returns floors without thickness whose top is at height 0.
pub fn flat_floors() -> Vec<(&'static str, ColliderBuilder)> {
    let quarter = FRAC_PI_2 as Real;
    let octagon: Vec<Vector> = (0..8)
        .map(|k| {
            let (sine, cosine) = (Real::from(k as i8) * TAU as Real / 8.0).sin_cos();
            Vector::new(5.0 * cosine, 0.0, 5.0 * sine)
        })
        .collect();
    let tilt = Rotation::from_scaled_axis(Vector::new(0.5, 0.2, 0.7));
    let tilted: Vec<Vector> = square(5.0).into_iter().map(|corner| tilt * corner).collect();
    let level = Pose::from_parts(Vector::ZERO, tilt.inverse());
    let hull = |points: &[Vector]| ColliderBuilder::convex_hull(points).expect("a plate");
    let round = ColliderBuilder::round_convex_hull(&square(5.0), 0.1).expect("a plate");
    let below = Vector::new(0.0, -0.1, 0.0);
    let triangles = vec![[0, 2, 1], [0, 3, 2], [0, 0, 1], [1, 1, 1]];
    vec![
        ("box without height", ColliderBuilder::cuboid(5.0, 0.0, 5.0)),
        ("box without depth", {
            ColliderBuilder::cuboid(5.0, 5.0, 0.0).rotation(Vector::X * quarter)
        }),
        ("round box without height", ColliderBuilder::round_cuboid(5.0, 0.0, 5.0, 0.0)),
        ("round box", ColliderBuilder::round_cuboid(5.0, 0.0, 5.0, 0.1).translation(below)),
        ("cylinder", ColliderBuilder::cylinder(0.0, 5.0)),
        ("cone", ColliderBuilder::cone(0.0, 5.0)),
        ("hull of a square", hull(&square(5.0))),
        ("hull of an octagon", hull(&octagon)),
        ("hull of a tilted square", hull(&tilted).position(level)),
        ("round hull", round.translation(below)),
        (
            "mesh with degenerate triangles",
            ColliderBuilder::trimesh(square(5.0), triangles).expect("a square"),
        ),
    ]
}

/// Returns bodies and their heights at rest.
pub fn bodies() -> Vec<(&'static str, ColliderBuilder, Real)> {
    let corners: Vec<Vector> = (0..8)
        .map(|i| {
            let side = |bit: i32| if i & bit == 0 { -0.5 } else { 0.5 };
            Vector::new(side(1), side(2), side(4))
        })
        .collect();
    vec![
        ("box", ColliderBuilder::cuboid(0.5, 0.5, 0.5), 0.5),
        ("ball", ColliderBuilder::ball(0.3), 0.3),
        ("capsule", ColliderBuilder::capsule_x(0.3, 0.3), 0.3),
        ("hull", ColliderBuilder::convex_hull(&corners).expect("a box"), 0.5),
        ("round box", ColliderBuilder::round_cuboid(0.4, 0.4, 0.4, 0.1), 0.5),
    ]
}

/// Returns bodies without thickness, their heights at rest, and their areas or lengths.
pub fn flat_bodies() -> Vec<(&'static str, ColliderBuilder, Real, Real)> {
    let end = Vector::new(0.5, 0.0, 0.0);
    let lie = |builder: ColliderBuilder| builder.rotation(Vector::Z * FRAC_PI_2 as Real);
    let disc = 0.125 * TAU as Real;
    let third = Vector::new(0.1, 0.0, 0.0);
    let line = ColliderBuilder::trimesh(vec![-end, end, third], vec![[0, 1, 2]]);
    vec![
        ("plate", ColliderBuilder::cuboid(0.5, 0.0, 0.5), 0.0, 1.0),
        ("rod", ColliderBuilder::cuboid(0.5, 0.0, 0.0), 0.0, 1.0),
        ("capsule", ColliderBuilder::capsule_x(0.5, 0.0), 0.0, 1.0),
        ("capsule without length", ColliderBuilder::capsule_x(0.0, 0.5), 0.5, disc * 2.0 / 3.0),
        ("disc", ColliderBuilder::cylinder(0.0, 0.5), 0.0, disc),
        ("cylinder without radius", lie(ColliderBuilder::cylinder(0.5, 0.0)), 0.0, 1.0),
        ("flat cone", ColliderBuilder::cone(0.0, 0.5), 0.0, disc),
        ("cone without radius", lie(ColliderBuilder::cone(0.5, 0.0)), 0.0, 1.0),
        ("flat hull", ColliderBuilder::convex_hull(&square(0.5)).expect("a plate"), 0.0, 1.0),
        (
            "round flat hull",
            ColliderBuilder::round_convex_hull(&square(0.5), 0.1).expect("a plate"),
            0.1,
            1.0,
        ),
        ("round plate", ColliderBuilder::round_cuboid(0.5, 0.0, 0.5, 0.1), 0.1, 1.0),
        ("triangle in a line", ColliderBuilder::triangle(-end, end, third), 0.0, 1.0),
        ("round line", ColliderBuilder::round_triangle(-end, end, third, 0.1), 0.1, 1.0),
        ("mesh in a line", line.expect("one triangle"), 0.0, 1.0),
    ]
}

/// Returns points of grids, in planes of many rotations.
pub fn flat_clouds() -> Vec<(String, Vec<Vector>)> {
    let cases = (2..8_usize).flat_map(|count| (0..8).map(move |turn| (count, turn)));
    let cloud = |(count, turn): (usize, usize)| {
        let angle = 0.37 * turn as Real;
        let tilt = Rotation::from_scaled_axis(Vector::new(angle, 0.4 * angle, -0.7 * angle));
        let at =
            |i: usize| Vector::new((i % count) as Real * 0.37, 0.0, (i / count) as Real * 0.21);
        let points = (0..count * count).map(|i| tilt * at(i) + Vector::Y * angle).collect();
        (format!("{count} by {count}, tilted by {angle:.2}"), points)
    };
    cases.map(cloud).collect()
}

/// Returns shapes that are points.
pub fn points_without_size() -> Vec<(&'static str, ColliderBuilder)> {
    let zero = Vector::ZERO;
    vec![
        ("ball", ColliderBuilder::ball(0.0)),
        ("box", ColliderBuilder::cuboid(0.0, 0.0, 0.0)),
        ("capsule", ColliderBuilder::capsule_x(0.0, 0.0)),
        ("cylinder", ColliderBuilder::cylinder(0.0, 0.0)),
        ("cone", ColliderBuilder::cone(0.0, 0.0)),
        ("segment", ColliderBuilder::segment(zero, zero)),
        ("triangle", ColliderBuilder::triangle(zero, zero, zero)),
        ("polyline", ColliderBuilder::polyline(vec![zero; 3], None)),
    ]
}

/// Returns shapes with one size, and the name of the size.
pub fn of_size(size: Real) -> Vec<(&'static str, ColliderBuilder)> {
    vec![
        ("radius", ColliderBuilder::ball(size)),
        ("half_extents", ColliderBuilder::cuboid(1.0, size, 1.0)),
        ("half_extents", ColliderBuilder::round_cuboid(1.0, 1.0, size, 0.1)),
        ("radius", ColliderBuilder::capsule_y(1.0, size)),
        ("half_height", ColliderBuilder::capsule_y(size, 1.0)),
        ("half_height", ColliderBuilder::cylinder(size, 1.0)),
        ("radius", ColliderBuilder::cylinder(1.0, size)),
        ("half_height", ColliderBuilder::cone(size, 1.0)),
        ("radius", ColliderBuilder::round_cone(1.0, size, 0.1)),
    ]
}

/// Returns scales, most of them mirrors.
pub fn scales() -> Vec<Vector> {
    [
        [1.0, 1.0, 1.0],
        [-1.0, 1.0, 1.0],
        [1.0, -1.0, 1.0],
        [1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
        [-1.0, -1.0, -1.0],
        [1.0, 0.4, 1.5],
        [-2.0, 0.4, 1.5],
        [2.0, -0.4, -1.5],
    ]
    .map(Vector::from_array)
    .to_vec()
}

/// A shape that parry has scaled: its shape, the height of its top, and the mass of its volume.
pub struct Scaled {
    pub name: &'static str,
    pub shape: SharedShape,
    pub top: Real,
    pub mass: Real,
}

/// A slanted frustum, symmetric about the plane of x and z, so that it lies level however it is mirrored.
fn gem() -> Vec<Vector> {
    let ring = |y: Real, reach: Real| {
        (0..7).map(move |k| {
            let (sine, cosine) = (Real::from(k as i8) * TAU as Real / 7.0).sin_cos();
            Vector::new(reach * cosine + 0.2, y, 0.9 * reach * sine)
        })
    };
    ring(-0.5, 2.0).chain(ring(0.0, 2.6)).chain(ring(0.5, 2.0)).collect()
}

/// Returns the shapes of this dimension, scaled by parry.
pub fn scaled_shapes(scale: Vector) -> Vec<Scaled> {
    let top = 0.5 * scale.y.abs();
    let by_points = |points: &[Vector]| {
        let points: Vec<Vector> = points.iter().map(|point| *point * scale).collect();
        ColliderBuilder::convex_hull(&points).expect("a solid").build().mass()
    };
    let scaled = |name, shape: &dyn Shape, top, mass| {
        let shape = SharedShape(shape.scale_dyn(scale, 16).expect("a shape").into());
        Scaled { name, shape, top, mass }
    };
    let hull = ConvexPolyhedron::from_convex_hull(&gem()).expect("a solid");
    let mass = by_points(hull.points());
    let round = RoundShape { inner_shape: hull.clone(), border_radius: 0.1 };
    let plate = ConvexPolyhedron::from_convex_hull(&square(3.0)).expect("a plate");
    let (corners, triangles) = Cuboid::new(Vector::new(3.0, 0.5, 3.0)).to_trimesh();
    let volume = 36.0 * (scale.x * scale.y * scale.z).abs();
    let mut shapes = vec![
        scaled("hull", &hull, top, mass),
        scaled("round hull", &round, top + 0.1, mass),
        scaled("flat hull", &plate, 0.0, 0.0),
    ];
    for (name, flags) in [
        ("mesh", TriMeshFlags::empty()),
        ("oriented mesh", TriMeshFlags::ORIENTED),
        ("one-sided mesh", TriMeshFlags::FIX_INTERNAL_EDGES),
        ("solid mesh", TriMeshFlags::FIX_INTERNAL_EDGES | TriMeshFlags::ORIENTED),
    ] {
        let mesh = TriMesh::with_flags(corners.clone(), triangles.clone(), flags).expect("a box");
        shapes.push(scaled(name, &mesh, top, volume));
    }
    for (name, flags) in [
        ("height field", HeightFieldFlags::empty()),
        ("one-sided field", HeightFieldFlags::FIX_INTERNAL_EDGES),
    ] {
        let is_middle = |i: usize| (3..=5).contains(&i);
        let slope = |i: usize, j: usize| -0.4 - 0.1 * ((3 * i + 5 * j) % 4) as Real;
        // Below the middle on either side, so that the middle carries the box under any mirror.
        let height = |i, j| if is_middle(i) && is_middle(j) { 0.0 } else { slope(i, j) };
        let up = |i, j| height(i, j) * scale.y.signum();
        let field = HeightField::with_flags(Array2::from_fn(9, 9, up), Vector::splat(16.0), flags);
        shapes.push(scaled(name, &field, 0.0, 0.0));
    }
    shapes
}

/// Returns floors with their backs up, and the same with their fronts up.
pub fn one_sided_floors() -> Vec<(&'static str, ColliderBuilder, ColliderBuilder)> {
    let count = 9_u32;
    let at = |k: u32| 2.0 * k as Real - 8.0;
    let corners = (0..count * count).map(|k| Vector::new(at(k / count), 0.0, at(k % count)));
    let corners: Vec<Vector> = corners.collect();
    let cells = (0..count - 1).flat_map(|i| (0..count - 1).map(move |j| i * count + j));
    let up: Vec<[u32; 3]> =
        cells.flat_map(|a| [[a, a + 1, a + count], [a + count, a + 1, a + count + 1]]).collect();
    let down = up.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let mesh = |triangles, flags| {
        ColliderBuilder::trimesh_with_flags(corners.clone(), triangles, flags).expect("a mesh")
    };
    let fix = TriMeshFlags::FIX_INTERNAL_EDGES;
    let heights = Array2::from_fn(9, 9, |_, _| 0.0);
    let field_flags = HeightFieldFlags::FIX_INTERNAL_EDGES;
    let scale = Vector::splat(16.0);
    let field = ColliderBuilder::heightfield_with_flags(heights, scale, field_flags);
    let over = Vector::X * core::f64::consts::PI as Real;
    vec![
        ("mesh", mesh(down, fix), mesh(up, fix)),
        ("height field", field.clone().rotation(over), field),
    ]
}

/// Number of bodies without thickness, of 40, that may pass ridges.
pub const PASSED_MAX: usize = 1;

/// Returns bodies without thickness.
pub fn slender_bodies() -> Vec<(&'static str, ColliderBuilder)> {
    let end = Vector::new(0.3, 0.0, 0.0);
    let side = Vector::new(0.0, 0.0, 0.3);
    vec![
        ("triangle", ColliderBuilder::triangle(-end, end, side)),
        ("plate", ColliderBuilder::cuboid(0.3, 0.0, 0.3)),
        ("flat hull", ColliderBuilder::convex_hull(&square(0.3)).expect("a plate")),
    ]
}

/// Returns a floor of ridges.
pub fn ridges() -> ColliderBuilder {
    let count = 41_u32;
    let ridge = |k: u32| if k.is_multiple_of(2) { 0.0 } else { 0.3 };
    let corners = (0..count).flat_map(|k| {
        let x = 0.4 * k as Real - 8.0;
        [-4.0, 4.0].map(|z| Vector::new(x, ridge(k), z))
    });
    let triangles = (0..count - 1).map(|k| 2 * k);
    let triangles = triangles.flat_map(|a| [[a, a + 1, a + 2], [a + 2, a + 1, a + 3]]).collect();
    ColliderBuilder::trimesh(corners.collect(), triangles).expect("a mesh")
}

/// A shape's name, the points and elements of its surface, and its volume.
type Notched = (&'static str, Vec<Vector>, Vec<[u32; 3]>, Real);

/// Triangles of a counter-clockwise outline: corners without another corner in their triangle are cut off.
fn cut_ears(outline: &[[Real; 2]]) -> Vec<[u32; 3]> {
    let turn = |[a, b, c]: [usize; 3]| {
        let [a, b, c] = [outline[a], outline[b], outline[c]];
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let mut left: Vec<usize> = (0..outline.len()).collect();
    let mut triangles = Vec::new();
    while left.len() > 2 {
        let count = left.len();
        let corners = |k: usize| [(k + count - 1) % count, k, (k + 1) % count].map(|at| left[at]);
        let is_ear = |k: &usize| {
            let [a, b, c] = corners(*k);
            let is_in = |p: usize| {
                [[a, b, p], [b, c, p], [c, a, p]].into_iter().all(|side| turn(side) >= 0.0)
            };
            turn([a, b, c]) > 1.0e-6 && left.iter().all(|&p| [a, b, c].contains(&p) || !is_in(p))
        };
        let ear = (0..count).find(is_ear).expect("a simple outline");
        triangles.push(corners(ear).map(|corner| corner as u32));
        left.remove(ear);
    }
    triangles
}

/// The surface of an outline that is extruded along the third axis to a depth.
fn extruded(outline: &[[Real; 2]], depth: Real) -> (Vec<Vector>, Vec<[u32; 3]>) {
    let at = |z: Real| outline.iter().map(move |p| Vector::new(p[0], p[1], z));
    let count = outline.len() as u32;
    let mut triangles = Vec::new();
    for [a, b, c] in cut_ears(outline) {
        triangles.extend([[a, c, b], [a + count, b + count, c + count]]);
    }
    for a in 0..count {
        let b = (a + 1) % count;
        triangles.extend([[a, b, b + count], [a, b + count, a + count]]);
    }
    (at(-0.5 * depth).chain(at(0.5 * depth)).collect(), triangles)
}

/// A torus of these numbers of segments around its axis and around its tube.
fn torus(around: u32, across: u32) -> (Vec<Vector>, Vec<[u32; 3]>) {
    let angle = |k: u32, count: u32| k as Real / count as Real * TAU as Real;
    let points = (0..around * across).map(|k| {
        let (a, b) = (angle(k / across, around), angle(k % across, across));
        let reach = 2.0 + 0.6 * b.cos();
        Vector::new(reach * a.cos(), reach * a.sin(), 0.6 * b.sin())
    });
    let at = |i: u32, j: u32| (i % around) * across + j % across;
    let cells = (0..around).flat_map(|i| (0..across).map(move |j| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[corners[0], corners[1], corners[2]], [corners[0], corners[2], corners[3]]]
    });
    (points.collect(), triangles.collect())
}

/// Volume inside triangles that are counter-clockwise from outside.
fn volume(points: &[Vector], triangles: &[[u32; 3]]) -> Real {
    let parts = triangles.iter().map(|triangle| {
        let [a, b, c] = triangle.map(|i| points[i as usize]);
        a.dot(b.cross(c)) / 6.0
    });
    parts.sum()
}

/// Returns shapes with notches and a hole.
pub fn notched() -> Vec<Notched> {
    let mut shapes: Vec<Notched> = Vec::new();
    for (name, outline) in outlines() {
        let (points, triangles) = extruded(&outline, 1.0);
        shapes.push((name, points, triangles, area(&outline)));
    }
    let (points, triangles) = torus(32, 16);
    let torus_volume = volume(&points, &triangles);
    shapes.push(("torus", points, triangles, torus_volume));
    shapes
}

/// Returns the surface of a comb, the height of its notches, and the size of a voxel.
pub fn combs() -> (Vec<Vector>, Vec<[u32; 3]>, Real, Real) {
    let (_, points, triangles, _) = notched().swap_remove(0);
    (points, triangles, 0.5, 9.0 / 64.0)
}
