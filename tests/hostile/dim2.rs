//! Dimension-specific parts of the hostile tests, in 2D.

use rapier::prelude::*;

/// Returns invalid rotations.
pub fn broken_rotations() -> [Rotation; 5] {
    let rotation = |re, im| Rotation { re, im };
    [
        rotation(Real::NAN, 1.0),
        rotation(1.0, Real::INFINITY),
        rotation(0.0, 0.0),
        rotation(1.0, 1.0),
        rotation(Real::MAX, 0.0),
    ]
}

/// Returns solid and hollow shapes of every kind, of about this size.
pub fn shapes(size: Real) -> Vec<ColliderBuilder> {
    let s = size;
    let corners = vec![point![-s, -s], point![s, -s], point![s, s], point![-s, s]];
    let square = vec![[0, 1, 2], [0, 2, 3]];
    let ring = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    let part = SharedShape::cuboid(s * 0.5, s * 0.25);
    let mut shapes = vec![
        ColliderBuilder::ball(s),
        ColliderBuilder::cuboid(s, s * 0.5),
        ColliderBuilder::round_cuboid(s, s * 0.5, s * 0.1),
        ColliderBuilder::capsule_x(s, s * 0.3),
        ColliderBuilder::capsule_y(s, s * 0.3),
        ColliderBuilder::segment(corners[0], corners[1]),
        ColliderBuilder::triangle(corners[0], corners[1], corners[2]),
        ColliderBuilder::round_triangle(corners[0], corners[1], corners[2], s * 0.1),
        ColliderBuilder::compound(vec![
            (Pose::translation(-s, 0.0), part.clone()),
            (Pose::translation(s, 0.0), part),
        ]),
        ColliderBuilder::polyline(corners.clone(), Some(ring)),
        ColliderBuilder::voxels(Vector::splat(s), &[[0, 0].into(), [1, 0].into()]),
        ColliderBuilder::heightfield(vec![0.0, s, 0.0, -s], Vector::splat(2.0 * s)),
    ];
    shapes.extend(ColliderBuilder::trimesh(corners.clone(), square));
    shapes.extend(ColliderBuilder::convex_hull(&corners));
    shapes.extend(ColliderBuilder::round_convex_hull(&corners, s * 0.1));
    shapes
}

/// Returns all bits of a pose.
pub fn pose_bits(pose: &Pose) -> [u64; 4] {
    let (r, t) = (pose.rotation, pose.translation);
    [t.x, t.y, r.re, r.im].map(|number| f64::from(number).to_bits())
}

/// Name of a shape made from one number, and its constructor.
pub type ShapeOfNumber = (&'static str, fn(Real) -> Option<ColliderBuilder>);

/// Returns every shape constructor, with the number in each of its arguments.
pub fn shapes_of_number() -> Vec<ShapeOfNumber> {
    vec![
        ("ball", |v| Some(ColliderBuilder::ball(v))),
        ("half-space", |v| Some(ColliderBuilder::halfspace(vector![0.0, v]))),
        ("cuboid", |v| Some(ColliderBuilder::cuboid(v, 1.0))),
        ("cuboid, other side", |v| Some(ColliderBuilder::cuboid(1.0, v))),
        ("round cuboid", |v| Some(ColliderBuilder::round_cuboid(1.0, v, 0.1))),
        ("border of a cuboid", |v| Some(ColliderBuilder::round_cuboid(1.0, 1.0, v))),
        ("capsule", |v| Some(ColliderBuilder::capsule_x(v, 0.5))),
        ("radius of a capsule", |v| Some(ColliderBuilder::capsule_y(0.5, v))),
        ("end of a capsule", |v| {
            Some(ColliderBuilder::capsule_from_endpoints(Vector::X, vector![0.0, v], 0.5))
        }),
        ("segment", |v| Some(ColliderBuilder::segment(Vector::ONE, vector![0.5, v]))),
        ("triangle", |v| Some(ColliderBuilder::triangle(Vector::X, Vector::Y, vector![0.5, v]))),
        ("round triangle", |v| {
            Some(ColliderBuilder::round_triangle(Vector::X, Vector::Y, -Vector::X, v))
        }),
        ("polyline", |v| {
            Some(ColliderBuilder::polyline(vec![Vector::X, vector![0.0, v], -Vector::X], None))
        }),
        ("oriented polyline", |v| {
            let corners = vec![Vector::X, vector![0.0, v], -Vector::X];
            Some(ColliderBuilder::oriented_polyline(corners, None))
        }),
        ("mesh", |v| mesh(v).ok()),
        ("hull", |v| ColliderBuilder::convex_hull(&corners(v))),
        ("round hull", |v| ColliderBuilder::round_convex_hull(&corners(1.0), v)),
        ("convex polygon", |v| ColliderBuilder::convex_polyline(corners(v))),
        ("round convex polygon", |v| ColliderBuilder::round_convex_polyline(corners(1.0), v)),
        ("heights", |v| Some(ColliderBuilder::heightfield(vec![0.0, v, 0.5], Vector::ONE))),
        ("scale of heights", |v| {
            Some(ColliderBuilder::heightfield(vec![0.0, 1.0, 0.5], vector![1.0, v]))
        }),
        ("voxels", |v| Some(ColliderBuilder::voxels(vector![1.0, v], &[[0, 0].into()]))),
        ("voxels of points", |v| {
            Some(ColliderBuilder::voxels_from_points(Vector::ONE, &[Vector::X, Vector::Y * v]))
        }),
        ("part of a compound", |v| {
            Some(ColliderBuilder::compound(vec![(Pose::IDENTITY, SharedShape::ball(v))]))
        }),
        ("place of a part", |v| {
            let part = SharedShape::ball(0.5);
            Some(ColliderBuilder::compound(vec![(Pose::translation(v, 0.0), part)]))
        }),
    ]
}

fn corners(v: Real) -> Vec<Vector> {
    vec![-Vector::X, -Vector::Y, Vector::X, vector![0.0, v]]
}

fn mesh(v: Real) -> Result<ColliderBuilder, InvalidCollider> {
    ColliderBuilder::trimesh(corners(v), vec![[0, 1, 2], [0, 2, 3]])
}

/// A degenerate shape: its name, the message of the rejection (if there is one), and its construction.
pub type Degenerate =
    (&'static str, &'static str, fn() -> Result<Option<ColliderBuilder>, InvalidCollider>);

/// Returns degenerate shapes.
pub fn degenerate_shapes() -> Vec<Degenerate> {
    let mut shapes = degenerate_areas();
    shapes.extend(degenerate_chains());
    shapes
}

fn degenerate_areas() -> Vec<Degenerate> {
    vec![
        ("hull of nothing", "", || Ok(ColliderBuilder::convex_hull(&[]))),
        ("hull of a point", "", || Ok(ColliderBuilder::convex_hull(&[Vector::X]))),
        ("hull of one point often", "", || Ok(ColliderBuilder::convex_hull(&[Vector::X; 9]))),
        ("hull of NaN", "", || Ok(ColliderBuilder::convex_hull(&[Vector::NAN; 4]))),
        ("polygon of nothing", "", || Ok(ColliderBuilder::convex_polyline(vec![]))),
        ("polygon of one point often", "", || {
            Ok(ColliderBuilder::convex_polyline(vec![Vector::X; 5]))
        }),
        ("empty mesh", "triangle", || ColliderBuilder::trimesh(vec![], vec![]).map(Some)),
        ("mesh of no triangles", "triangle", || ColliderBuilder::trimesh(line(), vec![]).map(Some)),
        ("mesh beyond its corners", "4", || {
            ColliderBuilder::trimesh(corners(1.0), vec![[0, 1, 4]]).map(Some)
        }),
        ("mesh far beyond its corners", "4294967295", || {
            ColliderBuilder::trimesh(corners(1.0), vec![[0, 1, u32::MAX]]).map(Some)
        }),
        ("empty compound", "shapes", || Ok(Some(ColliderBuilder::compound(vec![])))),
        ("compound of compounds", "part 0", || {
            let part = ColliderBuilder::compound(vec![(Pose::IDENTITY, SharedShape::ball(1.0))]);
            Ok(Some(ColliderBuilder::compound(vec![(Pose::IDENTITY, part.shape)])))
        }),
        ("no voxels", "voxels", || Ok(Some(ColliderBuilder::voxels(Vector::ONE, &[])))),
        ("voxels without size", "voxel_size", || {
            Ok(Some(ColliderBuilder::voxels(Vector::ZERO, &[[0, 0].into()])))
        }),
        ("voxels too far out", "grid", || {
            Ok(Some(ColliderBuilder::voxels(Vector::ONE, &[[Int::MAX, 0].into()])))
        }),
        ("voxels of a mesh too fine", "cells", || {
            let ring = [[0, 1], [1, 2], [2, 3], [3, 0]];
            let fill = parry::transformation::voxelization::FillMode::SurfaceOnly;
            Ok(Some(ColliderBuilder::voxelized_mesh(&corners(1.0), &ring, 1.0e-9, fill)))
        }),
        ("decomposition of nothing", "indices", || {
            Ok(Some(ColliderBuilder::convex_decomposition(&[], &[])))
        }),
        ("decomposition beyond its corners", "9", || {
            Ok(Some(ColliderBuilder::convex_decomposition(&corners(1.0), &[[0, 9]])))
        }),
        ("half-space without a direction", "outward_normal", || {
            Ok(Some(ColliderBuilder::halfspace(Vector::ZERO)))
        }),
    ]
}

fn degenerate_chains() -> Vec<Degenerate> {
    vec![
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
        ("no heights", "heights", || Ok(Some(ColliderBuilder::heightfield(vec![], Vector::ONE)))),
        ("one height", "heights", || {
            Ok(Some(ColliderBuilder::heightfield(vec![1.0], Vector::ONE)))
        }),
        ("heights over nothing", "scale", || {
            Ok(Some(ColliderBuilder::heightfield(vec![1.0, 2.0], Vector::ZERO)))
        }),
    ]
}

fn line() -> Vec<Vector> {
    (0..4_u8).map(|i| Vector::ONE * Real::from(i)).collect()
}

/// Returns shapes with very many parts, and very large ones.
pub fn huge_shapes() -> Vec<ColliderBuilder> {
    let count = 200_000;
    let height = |i: usize| ((i % 17) as Real) * 0.01;
    let heights: Vec<Real> = (0..count).map(height).collect();
    let chain = (0..count).map(|i| vector![i as Real * 0.1 - 10.0, height(i)]).collect();
    vec![
        ColliderBuilder::heightfield(heights, vector![count as Real * 0.1, 1.0]),
        ColliderBuilder::polyline(chain, None),
        ColliderBuilder::cuboid(1.0e15, 0.1),
        ColliderBuilder::ball(1.0e7).translation(vector![0.0, -1.0e7]),
    ]
}

/// A shape without area: its name, the shape, and its length.
pub type Weightless = (&'static str, ColliderBuilder, Real);

/// Returns shapes that get no mass from a density, of about this size, rotated by `angle`.
pub fn weightless_shapes(size: Real, angle: Real) -> Vec<Weightless> {
    let turn = Rotation::new(angle);
    let place = |x: Real, y: Real| turn * (vector![x, y] * size);
    let corner = vec![place(-1.0, 0.0), place(0.0, 1.0), place(1.0, 0.0)];
    let diagonal = Real::sqrt(2.0) * size;
    vec![
        ("segment", ColliderBuilder::segment(corner[0], corner[2]), 2.0 * size),
        ("polyline", ColliderBuilder::polyline(corner.clone(), None), 2.0 * diagonal),
        (
            "closed polyline",
            ColliderBuilder::polyline(corner.clone(), Some(vec![[0, 1], [1, 2], [2, 0]])),
            2.0 * diagonal + 2.0 * size,
        ),
        (
            "compound of segments",
            ColliderBuilder::compound(vec![
                (Pose::IDENTITY, SharedShape::segment(corner[0], corner[1])),
                (Pose::IDENTITY, SharedShape::segment(corner[1], corner[2])),
            ]),
            2.0 * diagonal,
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

/// Returns a ground of this number of segments, `width` long, with heights from 0 to `rise`.
pub fn rough_ground(segments: usize, width: Real, rise: Real) -> ColliderBuilder {
    let points = (0..=segments).map(|k| {
        let height = rise * Real::from((k * 7919 % 101) as u8) / 100.0;
        Vector::new(width * (k as Real / segments as Real - 0.5), height)
    });
    ColliderBuilder::polyline(points.collect(), None)
}

/// The lower side of a tower is dented by 1 cm, as outlines may be. The tower stands on its two lowest
/// corners.
#[test]
fn dented_outlines_stand_on_their_lowest_corners() {
    let corners = [[-1.0, 0.0], [-0.5, 0.01], [0.5, 0.01], [1.0, 0.0], [1.0, 8.0], [-1.0, 8.0]];
    let tower = ColliderBuilder::convex_polyline(corners.map(Vector::from_array).to_vec());
    let mut world = PhysicsWorld::new();
    let floor = ColliderBuilder::cuboid(50.0, 50.0).translation(Vector::Y * -50.0);
    world.insert_collider(floor, None);
    let tower = tower.expect("the dent is less than a thousandth of the area");
    let (tower, _) = world.insert(RigidBodyBuilder::dynamic(), tower);
    (0..120).for_each(|_| world.step());
    let body = &world.bodies[tower];
    assert!(body.translation().length() < 5.0e-3, "it is at {}", body.translation());
    assert!(body.rotation().angle().abs() < 5.0e-3, "it leans by {}", body.rotation().angle());
}
