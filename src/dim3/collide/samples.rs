//! Shapes and poses to test contact generation with.

use crate::base::random::Random;
use crate::dim::math::{AngVector, Pose, Real, Rotation, Vector};
use parry::shape::{HeightFieldFlags, Shape, SharedShape, TriMeshFlags, Triangle, Voxels};
use parry::utils::Array2;

/// Number of kinds of shapes that [`shape`] makes.
pub const KINDS: usize = 17;
/// The number of convex and bounded ones; they come first.
pub const CONVEX_KINDS: usize = 11;
/// The kind that is a mesh.
pub const MESH: usize = 12;
/// The kind that is a box with round edges.
pub const ROUND_BOX: usize = 9;
/// The kind that is a convex hull.
pub const HULL: usize = 6;

/// A vector with components in `-range..range`.
pub fn vector(random: &mut Random, range: f64) -> Vector {
    let mut next = || random.within(-range, range);
    Vector::new(next(), next(), next())
}

/// Any rotation.
pub fn rotation(random: &mut Random) -> Rotation {
    let mut next = || random.within(-1.0, 1.0);
    let raw = Rotation::from_xyzw(next(), next(), next(), next());
    if raw.length_squared() < 0.01 { Rotation::IDENTITY } else { raw.normalize() }
}

/// An angular vector with components in `-range..range`.
pub fn angle(random: &mut Random, range: f64) -> AngVector {
    vector(random, range)
}

/// The corners of a box.
pub fn corners(half: Vector) -> Vec<Vector> {
    [-1.0, 1.0]
        .into_iter()
        .flat_map(|x| {
            [-1.0, 1.0]
                .into_iter()
                .flat_map(move |y| [-1.0, 1.0].map(move |z| Vector::new(x, y, z) * half))
        })
        .collect()
}

/// The rotation by `angle` radians in the plane of the first two axes.
pub fn planar_rotation(angle: Real) -> Rotation {
    Rotation::from_rotation_z(angle)
}

/// The rotation by `angle` radians about the second axis.
pub fn about_y(angle: Real) -> Rotation {
    Rotation::from_rotation_y(angle)
}

/// Any rotation, and a translation with components in `-range..range`.
pub fn pose(random: &mut Random, range: f64) -> Pose {
    Pose::from_parts(vector(random, range), rotation(random))
}

/// A box with the half extents of a vector.
pub fn cuboid(half: Vector) -> SharedShape {
    SharedShape::cuboid(half.x, half.y, half.z)
}

/// A shape of the given kind, its size in the order of `size`.
pub fn shape(kind: usize, random: &mut Random, size: f64) -> SharedShape {
    let mut length = || random.within(0.2 * size, size);
    let (a, b, c) = (length(), length(), length());
    match kind {
        0 => SharedShape::ball(a),
        1 | 2 => SharedShape::cuboid(a, b, c),
        3 => SharedShape::capsule(vector(random, size), vector(random, size), a),
        4 => SharedShape::cylinder(a, b),
        5 => SharedShape::cone(a, b),
        6 => hull(random, size).unwrap_or_else(|| SharedShape::ball(a)),
        7 => {
            let [p, q, r] = core::array::from_fn(|_| vector(random, size));
            SharedShape::triangle(p, q, r)
        }
        8 => SharedShape::segment(vector(random, size), vector(random, size)),
        9 => SharedShape::round_cuboid(a, b, c, 0.2 * a),
        10 => SharedShape::round_cylinder(a, b, 0.2 * a),
        11 => SharedShape::halfspace(rotation(random) * Vector::Y),
        12 => mesh(random, size, TriMeshFlags::empty()),
        13 => mesh(random, size, TriMeshFlags::FIX_INTERNAL_EDGES),
        14 => field(random, size),
        15 => SharedShape::compound(vec![
            (pose(random, size), SharedShape::cuboid(a, b, c)),
            (pose(random, size), SharedShape::ball(a)),
        ]),
        _ => {
            let points: Vec<_> = (0..9).map(|_| vector(random, size)).collect();
            SharedShape::new(Voxels::from_points(Vector::splat(0.5 * a), &points))
        }
    }
}

/// A flat surface of squares of the given size, in the plane through the first and the third axis. It has
/// `count` in a row, each of two triangles, one of which has the opposite winding. Only those whose middle is
/// to be kept.
pub fn carpet(
    count: u32,
    size: Real,
    height: fn(Vector) -> Real,
    keep: fn(Vector) -> bool,
) -> SharedShape {
    let corner = |i: u32, j: u32| {
        let middle = 0.5 * count as Real;
        let at = Vector::new(i as Real - middle, 0.0, j as Real - middle) * size;
        at + Vector::Y * height(at)
    };
    let squares = (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
    let number = |i: u32, j: u32| i * (count + 1) + j;
    let is_kept = |(i, j): &(u32, u32)| keep(corner(*i, *j).midpoint(corner(i + 1, j + 1)));
    let triangles = squares.filter(is_kept).flat_map(|(i, j)| {
        let (a, b) = (number(i, j), number(i, j + 1));
        let (c, d) = (number(i + 1, j), number(i + 1, j + 1));
        [[a, b, d], [a, c, d]]
    });
    let points = (0..=count).flat_map(|i| (0..=count).map(move |j| (i, j)));
    let points = points.map(|(i, j)| corner(i, j)).collect();
    SharedShape::trimesh(points, triangles.collect()).expect("these indices are in range")
}

/// A surface, twice, with a long slanted edge: a box on it, and the separation over the edge, which contains
/// the origin.
pub fn long_edge(length: Real) -> (SharedShape, Rotation, Vector) {
    let [a, b] = [Vector::new(length, 0.0, -length), Vector::new(-length, 0.0, length)];
    let points = vec![a, b, Vector::new(-length, 0.0, -length)];
    let mesh = SharedShape::trimesh(points, vec![[0, 1, 2], [0, 2, 1]]);
    let out = Vector::new(1.0, 0.0, 1.0).normalize();
    (mesh.expect("these indices are in range"), Rotation::IDENTITY, out)
}

/// The triangles that a hull is made of.
pub fn surface(hull: &dyn Shape) -> Vec<Triangle> {
    let (points, triangles) = hull.as_convex_polyhedron().expect("is a hull").to_trimesh();
    let corner = |index: u32| points[index as usize];
    triangles.iter().map(|[a, b, c]| Triangle::new(corner(*a), corner(*b), corner(*c))).collect()
}

/// The hull of random points; `None` if it has no inside.
pub fn hull(random: &mut Random, size: f64) -> Option<SharedShape> {
    let points: Vec<_> = (0..12).map(|_| vector(random, size)).collect();
    SharedShape::convex_hull(&points)
}

fn mesh(random: &mut Random, size: f64, flags: TriMeshFlags) -> SharedShape {
    let points = (0..8).map(|_| vector(random, size)).collect();
    let triangles = (0..6).map(|i| [i, i + 1, i + 2]).collect();
    SharedShape::trimesh_with_flags(points, triangles, flags).expect("these indices are in range")
}

fn field(random: &mut Random, size: f64) -> SharedShape {
    let heights = (0..16).map(|_| random.within(-0.3, 0.3)).collect();
    let scale = Vector::splat(random.within(size, 3.0 * size));
    let flags = HeightFieldFlags::FIX_INTERNAL_EDGES;
    SharedShape::heightfield_with_flags(Array2::new(4, 4, heights), scale, flags)
}
