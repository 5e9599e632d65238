//! Dimension-specific parts of the hostile tests, in 3D.

use rapier::prelude::*;

/// Returns invalid rotations.
pub fn broken_rotations() -> [Rotation; 5] {
    let rotation = Rotation::from_xyzw;
    [
        rotation(0.0, Real::NAN, 0.0, 1.0),
        rotation(Real::INFINITY, 0.0, 0.0, 1.0),
        rotation(0.0, 0.0, 0.0, 0.0),
        rotation(1.0, 1.0, 1.0, 1.0),
        rotation(0.0, 0.0, 0.0, Real::MAX),
    ]
}

/// Returns solid and hollow shapes of every kind, of about this size.
pub fn shapes(size: Real) -> Vec<ColliderBuilder> {
    let s = size;
    let corners =
        vec![point![-s, -s, -s], point![s, -s, -s], point![0.0, s, -s], point![0.0, 0.0, s]];
    let tetrahedron = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let part = SharedShape::cuboid(s * 0.5, s * 0.25, s * 0.5);
    let heights = parry::utils::Array2::new(2, 3, vec![0.0, s, 0.0, -s, s, 0.0]);
    let mut shapes = vec![
        ColliderBuilder::ball(s),
        ColliderBuilder::cuboid(s, s * 0.5, s),
        ColliderBuilder::round_cuboid(s, s * 0.5, s, s * 0.1),
        ColliderBuilder::capsule_x(s, s * 0.3),
        ColliderBuilder::capsule_z(s, s * 0.3),
        ColliderBuilder::cylinder(s, s * 0.5),
        ColliderBuilder::round_cylinder(s, s * 0.5, s * 0.1),
        ColliderBuilder::cone(s, s * 0.5),
        ColliderBuilder::round_cone(s, s * 0.5, s * 0.1),
        ColliderBuilder::segment(corners[0], corners[1]),
        ColliderBuilder::triangle(corners[0], corners[1], corners[2]),
        ColliderBuilder::round_triangle(corners[0], corners[1], corners[2], s * 0.1),
        ColliderBuilder::compound(vec![
            (Pose::translation(-s, 0.0, 0.0), part.clone()),
            (Pose::translation(s, 0.0, 0.0), part),
        ]),
        ColliderBuilder::polyline(corners.clone(), None),
        ColliderBuilder::voxels(Vector::splat(s), &[[0, 0, 0].into(), [1, 0, 0].into()]),
        ColliderBuilder::heightfield(heights, Vector::splat(2.0 * s)),
    ];
    shapes.extend(ColliderBuilder::trimesh(corners.clone(), tetrahedron.clone()));
    shapes.extend(ColliderBuilder::convex_hull(&corners));
    shapes.extend(ColliderBuilder::round_convex_hull(&corners, s * 0.1));
    shapes.extend(ColliderBuilder::convex_mesh(corners, &tetrahedron));
    shapes
}

/// Returns all bits of a pose.
pub fn pose_bits(pose: &Pose) -> [u64; 7] {
    let (r, t) = (pose.rotation, pose.translation);
    [t.x, t.y, t.z, r.x, r.y, r.z, r.w].map(|number| f64::from(number).to_bits())
}

/// Name of a shape made from one number, and its constructor.
pub type ShapeOfNumber = (&'static str, fn(Real) -> Option<ColliderBuilder>);

/// Returns every shape constructor, with the number in each of its arguments.
pub fn shapes_of_number() -> Vec<ShapeOfNumber> {
    let mut shapes = convex_shapes_of_number();
    shapes.extend(composite_shapes_of_number());
    shapes
}

fn convex_shapes_of_number() -> Vec<ShapeOfNumber> {
    vec![
        ("ball", |v| Some(ColliderBuilder::ball(v))),
        ("half-space", |v| Some(ColliderBuilder::halfspace(vector![0.0, v, 0.0]))),
        ("cuboid", |v| Some(ColliderBuilder::cuboid(v, 1.0, 1.0))),
        ("cuboid, other side", |v| Some(ColliderBuilder::cuboid(1.0, 1.0, v))),
        ("round cuboid", |v| Some(ColliderBuilder::round_cuboid(1.0, v, 1.0, 0.1))),
        ("border of a cuboid", |v| Some(ColliderBuilder::round_cuboid(1.0, 1.0, 1.0, v))),
        ("capsule", |v| Some(ColliderBuilder::capsule_z(v, 0.5))),
        ("radius of a capsule", |v| Some(ColliderBuilder::capsule_y(0.5, v))),
        ("end of a capsule", |v| {
            Some(ColliderBuilder::capsule_from_endpoints(Vector::X, vector![0.0, v, 0.0], 0.5))
        }),
        ("cylinder", |v| Some(ColliderBuilder::cylinder(v, 0.5))),
        ("radius of a cylinder", |v| Some(ColliderBuilder::cylinder(0.5, v))),
        ("round cylinder", |v| Some(ColliderBuilder::round_cylinder(0.5, 0.5, v))),
        ("cone", |v| Some(ColliderBuilder::cone(v, 0.5))),
        ("radius of a cone", |v| Some(ColliderBuilder::cone(0.5, v))),
        ("round cone", |v| Some(ColliderBuilder::round_cone(0.5, 0.5, v))),
        ("segment", |v| Some(ColliderBuilder::segment(Vector::ONE, vector![0.5, v, 0.0]))),
        ("triangle", |v| {
            Some(ColliderBuilder::triangle(Vector::X, Vector::Y, vector![0.5, v, 0.0]))
        }),
        ("round triangle", |v| {
            Some(ColliderBuilder::round_triangle(Vector::X, Vector::Y, -Vector::X, v))
        }),
        ("hull", |v| ColliderBuilder::convex_hull(&corners(v))),
        ("round hull", |v| ColliderBuilder::round_convex_hull(&corners(1.0), v)),
        ("convex mesh", |v| ColliderBuilder::convex_mesh(corners(v), &TETRAHEDRON)),
        ("round convex mesh", |v| {
            ColliderBuilder::round_convex_mesh(corners(1.0), &TETRAHEDRON, v)
        }),
    ]
}

fn composite_shapes_of_number() -> Vec<ShapeOfNumber> {
    vec![
        ("polyline", |v| {
            let corners = vec![Vector::X, vector![0.0, v, 0.0], -Vector::X];
            Some(ColliderBuilder::polyline(corners, None))
        }),
        ("mesh", |v| ColliderBuilder::trimesh(corners(v), TETRAHEDRON.to_vec()).ok()),
        ("oriented mesh", |v| {
            let flags = TriMeshFlags::all();
            ColliderBuilder::trimesh_with_flags(corners(v), TETRAHEDRON.to_vec(), flags).ok()
        }),
        ("heights", |v| Some(heights(v, 1.0))),
        ("scale of heights", |v| Some(heights(1.0, v))),
        ("voxels", |v| Some(ColliderBuilder::voxels(vector![1.0, v, 1.0], &[[0, 0, 0].into()]))),
        ("voxels of points", |v| {
            Some(ColliderBuilder::voxels_from_points(Vector::ONE, &[Vector::X, Vector::Y * v]))
        }),
        ("part of a compound", |v| {
            Some(ColliderBuilder::compound(vec![(Pose::IDENTITY, SharedShape::ball(v))]))
        }),
        ("place of a part", |v| {
            let part = SharedShape::ball(0.5);
            Some(ColliderBuilder::compound(vec![(Pose::translation(v, 0.0, 0.0), part)]))
        }),
    ]
}

const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

fn corners(v: Real) -> Vec<Vector> {
    vec![-Vector::ONE, vector![1.0, -1.0, -1.0], vector![0.0, 1.0, -1.0], vector![0.0, 0.0, v]]
}

fn heights(height: Real, scale: Real) -> ColliderBuilder {
    let heights = parry::utils::Array2::new(2, 2, vec![0.0, height, 0.5, 0.0]);
    ColliderBuilder::heightfield(heights, vector![1.0, scale, 1.0])
}

/// A degenerate shape: its name, the message of the rejection (if there is one), and its construction.
pub type Degenerate =
    (&'static str, &'static str, fn() -> Result<Option<ColliderBuilder>, InvalidCollider>);

/// Returns degenerate shapes.
pub fn degenerate_shapes() -> Vec<Degenerate> {
    let mut shapes = degenerate_solids();
    shapes.extend(degenerate_surfaces());
    shapes
}

fn degenerate_solids() -> Vec<Degenerate> {
    vec![
        ("hull of nothing", "", || Ok(ColliderBuilder::convex_hull(&[]))),
        ("hull of a point", "", || Ok(ColliderBuilder::convex_hull(&[Vector::X]))),
        ("hull of one point often", "", || Ok(ColliderBuilder::convex_hull(&[Vector::X; 9]))),
        ("hull of a line", "", || Ok(ColliderBuilder::convex_hull(&line()))),
        ("hull of NaN", "", || Ok(ColliderBuilder::convex_hull(&[Vector::NAN; 5]))),
        ("solid of nothing", "", || Ok(ColliderBuilder::convex_mesh(vec![], &[]))),
        ("solid without triangles", "", || Ok(ColliderBuilder::convex_mesh(corners(1.0), &[]))),
        ("open solid", "", || Ok(ColliderBuilder::convex_mesh(corners(1.0), &TETRAHEDRON[1..]))),
        ("solid beyond its corners", "", || {
            Ok(ColliderBuilder::convex_mesh(corners(1.0), &[[0, 1, u32::MAX]]))
        }),
        ("empty compound", "shapes", || Ok(Some(ColliderBuilder::compound(vec![])))),
        ("compound of compounds", "part 0", || {
            let part = ColliderBuilder::compound(vec![(Pose::IDENTITY, SharedShape::ball(1.0))]);
            Ok(Some(ColliderBuilder::compound(vec![(Pose::IDENTITY, part.shape)])))
        }),
        ("decomposition of nothing", "indices", || {
            Ok(Some(ColliderBuilder::convex_decomposition(&[], &[])))
        }),
        ("decomposition beyond its corners", "9", || {
            Ok(Some(ColliderBuilder::convex_decomposition(&corners(1.0), &[[0, 1, 9]])))
        }),
        ("half-space without a direction", "outward_normal", || {
            Ok(Some(ColliderBuilder::halfspace(Vector::ZERO)))
        }),
    ]
}

fn degenerate_surfaces() -> Vec<Degenerate> {
    vec![
        ("empty mesh", "triangle", || ColliderBuilder::trimesh(vec![], vec![]).map(Some)),
        ("mesh of no triangles", "triangle", || {
            ColliderBuilder::trimesh(corners(1.0), vec![]).map(Some)
        }),
        ("mesh beyond its corners", "4", || {
            ColliderBuilder::trimesh(corners(1.0), vec![[0, 1, 4]]).map(Some)
        }),
        ("mesh far beyond its corners", "4294967295", || {
            ColliderBuilder::trimesh(corners(1.0), vec![[0, 1, u32::MAX]]).map(Some)
        }),
        ("empty polyline", "vertices", || Ok(Some(ColliderBuilder::polyline(vec![], None)))),
        ("polyline of a point", "vertices", || {
            Ok(Some(ColliderBuilder::polyline(vec![Vector::X], None)))
        }),
        ("polyline of no segments", "indices", || {
            Ok(Some(ColliderBuilder::polyline(line(), Some(vec![]))))
        }),
        ("polyline beyond its corners", "7", || {
            Ok(Some(ColliderBuilder::polyline(line(), Some(vec![[0, 7]]))))
        }),
        ("one row of heights", "heights", || Ok(Some(field(1, 5, Vector::ONE)))),
        ("one column of heights", "heights", || Ok(Some(field(5, 1, Vector::ONE)))),
        ("no heights", "heights", || Ok(Some(field(0, 0, Vector::ONE)))),
        ("heights over nothing", "scale", || Ok(Some(field(3, 3, Vector::ZERO)))),
        ("no voxels", "voxels", || Ok(Some(ColliderBuilder::voxels(Vector::ONE, &[])))),
        ("voxels without size", "voxel_size", || {
            Ok(Some(ColliderBuilder::voxels(Vector::ZERO, &[[0, 0, 0].into()])))
        }),
        ("voxels too far out", "grid", || {
            Ok(Some(ColliderBuilder::voxels(Vector::ONE, &[[Int::MAX, 0, 0].into()])))
        }),
        ("voxels of a mesh too fine", "cells", || {
            let fill = parry::transformation::voxelization::FillMode::SurfaceOnly;
            let (corners, triangles) = (corners(1.0), TETRAHEDRON);
            Ok(Some(ColliderBuilder::voxelized_mesh(&corners, &triangles, 1.0e-9, fill)))
        }),
    ]
}

fn line() -> Vec<Vector> {
    (0..5_u8).map(|i| Vector::ONE * Real::from(i)).collect()
}

fn field(rows: usize, columns: usize, scale: Vector) -> ColliderBuilder {
    let heights = parry::utils::Array2::new(rows, columns, vec![0.0; rows * columns]);
    ColliderBuilder::heightfield(heights, scale)
}

/// Returns shapes with very many parts, and very large ones.
pub fn huge_shapes() -> Vec<ColliderBuilder> {
    let count = 400;
    let height = |i: usize| ((i % 17) as Real) * 0.01;
    let heights: Vec<Real> = (0..count * count).map(height).collect();
    let heights = parry::utils::Array2::new(count, count, heights);
    let chain =
        (0..count * count).map(|i| vector![i as Real * 0.1 - 10.0, height(i), 0.0]).collect();
    vec![
        ColliderBuilder::heightfield(heights, vector![100.0, 1.0, 100.0]),
        ColliderBuilder::polyline(chain, None),
        ColliderBuilder::cuboid(1.0e15, 0.1, 1.0e15),
        ColliderBuilder::ball(1.0e7).translation(vector![0.0, -1.0e7, 0.0]),
    ]
}

/// A shape without volume: its name, the shape, and its area or length.
pub type Weightless = (&'static str, ColliderBuilder, Real);

/// Returns shapes that get no mass from a density, of about this size, rotated by `angle`.
pub fn weightless_shapes(size: Real, angle: Real) -> Vec<Weightless> {
    let turn = Rotation::from_scaled_axis(vector![angle, 0.3 * angle, -angle]);
    let place = |x: Real, z: Real| turn * (vector![x, 0.0, z] * size);
    let square = vec![place(-1.0, -1.0), place(-1.0, 1.0), place(1.0, 1.0), place(1.0, -1.0)];
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    let area = 4.0 * size * size;
    let mesh = SharedShape::trimesh(square.clone(), triangles).expect("a square");
    let hull = |count: usize| SharedShape::convex_hull(&square[..count]).expect("a flat hull");
    let rim: Vec<Vector> = (0..12_u8)
        .map(|i| {
            let (sin, cos) = (Real::from(i) / 6.0 * std::f64::consts::PI as Real).sin_cos();
            place(cos, sin)
        })
        .collect();
    let disc = SharedShape::convex_hull(&rim).expect("a flat hull");
    let heights = parry::utils::Array2::new(2, 2, vec![0.0; 4]);
    let parts = vec![(Pose::translation(0.0, 0.0, 0.0), hull(4))];
    vec![
        ("segment", ColliderBuilder::segment(square[0], square[1]), 2.0 * size),
        ("polyline", ColliderBuilder::polyline(square.clone(), None), 6.0 * size),
        ("triangle", ColliderBuilder::triangle(square[0], square[1], square[2]), 0.5 * area),
        ("open mesh", ColliderBuilder::new(mesh), area),
        ("flat hull of 3 points", ColliderBuilder::new(hull(3)), 0.5 * area),
        ("flat hull of 4 points", ColliderBuilder::new(hull(4)), area),
        ("flat hull of 12 points", ColliderBuilder::new(disc), 3.0 * size * size),
        ("compound of flat hulls", ColliderBuilder::compound(parts), area),
        (
            "height field",
            ColliderBuilder::heightfield(heights, vector![2.0, 1.0, 2.0] * size),
            area,
        ),
    ]
}

/// Returns shapes of parry's constructors that cannot collide, and a word of the reason.
pub fn unsound_shapes() -> Vec<(&'static str, &'static str, Option<SharedShape>)> {
    let line = Segment::new(Vector::X, Vector::ONE);
    let triangle =
        RoundShape { inner_shape: Triangle::new(line.a, line.b, line.a), border_radius: -0.1 };
    vec![
        ("negative ball", "radius", Some(SharedShape::ball(-1.0))),
        ("triangle with a negative border", "border_radius", Some(SharedShape::new(triangle))),
    ]
}

/// Returns a ground of about this number of triangles, `width` long and wide, with heights from 0 to `rise`.
pub fn rough_ground(triangles: usize, width: Real, rise: Real) -> ColliderBuilder {
    let side = (0..).find(|side| 2 * side * side >= triangles).unwrap_or(1) + 1;
    let at = |k: usize| width * (k as Real / (side - 1) as Real - 0.5);
    let points = (0..side * side).map(|k| {
        let height = rise * Real::from((k * 7919 % 101) as u8) / 100.0;
        Vector::new(at(k % side), height, at(k / side))
    });
    let corner = |column: usize, row: usize| (row * side + column) as u32;
    let cells = (0..(side - 1) * (side - 1)).map(|k| (k % (side - 1), k / (side - 1)));
    let halves = cells.flat_map(|(x, z)| {
        let [a, b] = [corner(x, z), corner(x + 1, z)];
        let [c, d] = [corner(x, z + 1), corner(x + 1, z + 1)];
        [[a, c, b], [b, c, d]]
    });
    let indices = halves.collect();
    ColliderBuilder::trimesh(points.collect(), indices).expect("the ground is a mesh")
}
