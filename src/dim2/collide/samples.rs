//! Shapes and poses to test contact generation with.

use crate::base::random::Random;
use crate::dim::math::{AngVector, Pose, Real, Rotation, Vector};
use parry::shape::{Segment, Shape, SharedShape, TriMeshFlags, Voxels};

/// Number of kinds of shapes that [`shape`] makes.
pub const KINDS: usize = 15;
/// The number of convex and bounded ones; they come first.
pub const CONVEX_KINDS: usize = 9;
/// The kind that is a mesh.
pub const MESH: usize = 10;
/// The kind that is a box with round edges.
pub const ROUND_BOX: usize = 7;
/// The kind that is a convex hull.
pub const HULL: usize = 4;

/// A vector with components in `-range..range`.
pub fn vector(random: &mut Random, range: f64) -> Vector {
    let mut next = || random.within(-range, range);
    Vector::new(next(), next())
}

/// Any rotation.
pub fn rotation(random: &mut Random) -> Rotation {
    Rotation::new(random.within(-3.2, 3.2))
}

/// An angular vector with components in `-range..range`.
pub fn angle(random: &mut Random, range: f64) -> AngVector {
    random.within(-range, range)
}

/// The corners of a box.
pub fn corners(half: Vector) -> Vec<Vector> {
    [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
        .map(|[x, y]| Vector::new(x, y) * half)
        .to_vec()
}

/// The rotation by `angle` radians in the plane of the first two axes.
pub fn planar_rotation(angle: Real) -> Rotation {
    Rotation::new(angle)
}

/// No rotation: there is none about an axis in the plane.
pub fn about_y(_angle: Real) -> Rotation {
    Rotation::IDENTITY
}

/// Any rotation, and a translation with components in `-range..range`.
pub fn pose(random: &mut Random, range: f64) -> Pose {
    Pose::from_parts(vector(random, range), rotation(random))
}

/// A box with the half extents of a vector.
pub fn cuboid(half: Vector) -> SharedShape {
    SharedShape::cuboid(half.x, half.y)
}

/// A shape of the given kind, its size in the order of `size`.
pub fn shape(kind: usize, random: &mut Random, size: f64) -> SharedShape {
    let mut length = || random.within(0.2 * size, size);
    let (a, b) = (length(), length());
    match kind {
        0 => SharedShape::ball(a),
        1 | 2 => SharedShape::cuboid(a, b),
        3 => SharedShape::capsule(vector(random, size), vector(random, size), a),
        4 => hull(random, size).unwrap_or_else(|| SharedShape::ball(a)),
        5 => {
            let [p, q, r] = core::array::from_fn(|_| vector(random, size));
            SharedShape::triangle(p, q, r)
        }
        6 => SharedShape::segment(vector(random, size), vector(random, size)),
        7 => SharedShape::round_cuboid(a, b, 0.2 * a),
        8 => SharedShape::ball(b),
        9 => SharedShape::halfspace(rotation(random) * Vector::Y),
        10 => mesh(random, size),
        11 => SharedShape::polyline((0..6).map(|_| vector(random, size)).collect(), None),
        12 => field(random, size),
        13 => SharedShape::compound(vec![
            (pose(random, size), SharedShape::cuboid(a, b)),
            (pose(random, size), SharedShape::ball(a)),
        ]),
        _ => {
            let points: Vec<_> = (0..9).map(|_| vector(random, size)).collect();
            SharedShape::new(Voxels::from_points(Vector::splat(0.5 * a), &points))
        }
    }
}

/// The segments that a hull is made of.
pub fn surface(hull: &dyn Shape) -> Vec<Segment> {
    let points = hull.as_convex_polygon().expect("is a hull").points();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(start, end)| Segment::new(*start, *end)).collect()
}

/// A long slanted line, twice: a box on it, and the separation over its end, which is the origin.
pub fn long_edge(length: Real) -> (SharedShape, Rotation, Vector) {
    let points = vec![Vector::splat(-length), Vector::ZERO];
    let line = SharedShape::polyline(points, Some(vec![[0, 1], [1, 0]]));
    (line, planar_rotation(Real::atan(1.0)), Vector::ONE.normalize())
}

/// A flat line of segments of the given size along the first axis: `count` in a row. Only those whose middle
/// is to be kept.
pub fn carpet(
    count: u32,
    size: Real,
    height: fn(Vector) -> Real,
    keep: fn(Vector) -> bool,
) -> SharedShape {
    let end = |i: u32| {
        let at = Vector::new(i as Real - 0.5 * count as Real, 0.0) * size;
        at + Vector::Y * height(at)
    };
    let segments = (0..count).filter(|i| keep(end(*i).midpoint(end(i + 1)))).map(|i| [i, i + 1]);
    SharedShape::polyline((0..=count).map(end).collect(), Some(segments.collect()))
}

/// The hull of random points; `None` if it has no inside.
pub fn hull(random: &mut Random, size: f64) -> Option<SharedShape> {
    let points: Vec<_> = (0..8).map(|_| vector(random, size)).collect();
    SharedShape::convex_hull(&points)
}

fn mesh(random: &mut Random, size: f64) -> SharedShape {
    let points = (0..8).map(|_| vector(random, size)).collect();
    let triangles = (0..6).map(|i| [i, i + 1, i + 2]).collect();
    SharedShape::trimesh_with_flags(points, triangles, TriMeshFlags::empty())
        .expect("these indices are in range")
}

fn field(random: &mut Random, size: f64) -> SharedShape {
    let heights = (0..8).map(|_| random.within(-0.3, 0.3)).collect();
    SharedShape::heightfield(heights, Vector::splat(random.within(size, 3.0 * size)))
}
