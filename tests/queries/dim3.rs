//! Definitions of the tests of queries in 3D.

use rapier::parry::query::NonlinearRigidMotion;
use rapier::parry::shape::{HalfSpace, HeightField, TriMeshFlags};
use rapier::parry::utils::Array2;
use rapier::prelude::*;

/// Returns a height field of this length along x and z, as high at each x for all z.
pub fn field(heights: &[Real], length: Real) -> SharedShape {
    let count = heights.len();
    let heights = Array2::from_fn(count, count, |_, j| heights[j]);
    SharedShape::new(HeightField::new(heights, Vector::new(length, 1.0, length)))
}

/// Returns the corners of a convex hull.
pub fn hull_corners(hull: &SharedShape) -> Option<&[Vector]> {
    hull.as_convex_polyhedron().map(|hull| hull.points())
}

/// Returns a height field of this length with `count` cells along x and z, and random heights.
pub fn rough_field(count: usize, length: Real, mut height: impl FnMut() -> Real) -> SharedShape {
    let heights = (0..(count + 1) * (count + 1)).map(|_| height()).collect();
    let heights = Array2::new(count + 1, count + 1, heights);
    SharedShape::new(HeightField::new(heights, Vector::new(length, 1.0, length)))
}

/// Returns the triangles of a height field.
pub fn pieces(field: &SharedShape) -> Vec<SharedShape> {
    let field = field.as_heightfield().expect("is a height field");
    field.triangles().map(SharedShape::new).collect()
}

/// Returns the surface of a cube with a solid inside.
pub fn solid_box(half: Real) -> SharedShape {
    let cube = ColliderBuilder::cuboid(half, half, half).build();
    let (corners, triangles) = cube.shape().as_cuboid().expect("is a cuboid").to_trimesh();
    let mesh = SharedShape::trimesh_with_flags(corners, triangles, TriMeshFlags::ORIENTED);
    mesh.expect("a cube has a surface")
}

/// Returns a level square of two triangles, or the reason why there is none.
pub fn wide_ground(half: Real) -> Result<Collider, InvalidCollider> {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|[x, z]| Vector::new(x, 0.0, z) * half).to_vec();
    ColliderBuilder::trimesh(corners, vec![[0, 2, 1], [0, 3, 2]])?.try_build()
}

/// Returns voxels of size 1 that fill columns of these heights, side by side along x and z.
pub fn columns(count: i32, mut height: impl FnMut() -> i32) -> SharedShape {
    let grid = (0..count).flat_map(|x| (0..count).map(move |z| (x, z)));
    let cells: Vec<_> = grid
        .flat_map(|(x, z)| (0..=height()).map(move |y| [x as Int, y as Int, z as Int].into()))
        .collect();
    SharedShape::voxels(Vector::ONE, &cells)
}

/// Returns a shape of each kind, about a metre in size.
pub fn every_shape() -> Vec<(&'static str, SharedShape)> {
    let corners = || vec![Vector::X, Vector::Y, Vector::Z, -Vector::ONE * 0.4];
    let triangles = || vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let mut height = [0.2, -0.3, 0.4, 0.0, 0.1, -0.1, 0.5].into_iter().cycle();
    let mut column = [0, 1, 0, 2].into_iter().cycle();
    vec![
        ("ball", SharedShape::ball(0.5)),
        ("cuboid", SharedShape::cuboid(0.5, 0.3, 0.4)),
        ("capsule", SharedShape::capsule_x(0.5, 0.3)),
        ("cylinder", SharedShape::cylinder(0.4, 0.3)),
        ("cone", SharedShape::cone(0.4, 0.5)),
        ("hull", SharedShape::convex_hull(&corners()).expect("a hull")),
        ("triangle", SharedShape::triangle(Vector::X, Vector::Y, -Vector::Z)),
        ("segment", SharedShape::segment(Vector::X, -Vector::Y)),
        ("round cuboid", SharedShape::round_cuboid(0.4, 0.3, 0.2, 0.1)),
        ("half-space", SharedShape::halfspace(Vector::new(0.6, 0.8, 0.0))),
        ("mesh", SharedShape::trimesh(corners(), triangles()).expect("a mesh")),
        ("polyline", SharedShape::polyline(corners(), None)),
        ("solid mesh", solid_box(0.4)),
        ("height field", rough_field(4, 3.0, || height.next().unwrap_or(0.0))),
        ("voxels", columns(2, || column.next().unwrap_or(0))),
        (
            "compound",
            SharedShape::compound(vec![
                (Pose::from_translation(Vector::X), SharedShape::ball(0.4)),
                (Pose::from_translation(-Vector::X * 0.5), SharedShape::cuboid(0.3, 0.4, 0.5)),
            ]),
        ),
    ]
}

/// Returns the directions normal to any two of some edges.
pub fn axes(edges: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut axes: Vec<[f64; 3]> = Vec::new();
    for (k, [a, b, c]) in edges.iter().enumerate() {
        for [x, y, z] in &edges[k + 1..] {
            let axis = [b * z - c * y, c * x - a * z, a * y - b * x];
            let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            if length > 1.0e-6 {
                axes.push(axis.map(|x| x / length));
            }
        }
    }
    axes
}

/// Returns shapes with flat faces and their corners.
pub fn corner_shapes() -> Vec<(&'static str, SharedShape, Vec<Vector>)> {
    let corners = vec![Vector::X, Vector::Y, Vector::Z, -Vector::ONE * 0.4];
    let cuboid = |x: Real, y: Real, z: Real| -> Vec<Vector> {
        let signs = [-1.0, 1.0];
        let all =
            signs.iter().flat_map(|a| signs.iter().flat_map(move |b| signs.map(|c| [*a, *b, c])));
        all.map(|[a, b, c]| Vector::new(a * x, b * y, c * z)).collect()
    };
    let [a, b, c] = [Vector::X, Vector::new(0.1, 0.8, 0.3), -Vector::Y];
    let tips = [Vector::X * 0.4, Vector::Y * 0.6, Vector::Z * 0.4];
    let tips: Vec<Vector> = tips.into_iter().flat_map(|tip| [tip, -tip]).collect();
    vec![
        ("octahedron", SharedShape::convex_hull(&tips).expect("a hull"), tips),
        ("box", SharedShape::cuboid(0.5, 0.3, 0.4), cuboid(0.5, 0.3, 0.4)),
        ("plate", SharedShape::cuboid(0.5, 0.0, 0.4), cuboid(0.5, 0.0, 0.4)),
        ("hull", SharedShape::convex_hull(&corners).expect("a hull"), corners),
        ("triangle", SharedShape::triangle(a, b, c), vec![a, b, c]),
        ("segment", SharedShape::segment(a, c), vec![a, c]),
    ]
}

/// A rotation about its normal leaves a half-space where it is.
#[test]
fn a_half_space_that_spins_about_its_normal_touches_nothing() {
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let motion = |at: Vector, angvel| {
        NonlinearRigidMotion::new(Pose::from_translation(at), Vector::ZERO, Vector::ZERO, angvel)
    };
    let (plane, ball) = (HalfSpace::new(Vector::Y), SharedShape::ball(0.4));
    for (x, spin) in [(5.0, 6.0), (20.0, 6.0), (100.0, 6.0), (3.0, 60.0)] {
        let turning = motion(Vector::ZERO, Vector::Y * spin);
        let still = motion(Vector::new(x, 1.5, 0.0), Vector::ZERO);
        let hit = query.cast_shapes_nonlinear(&turning, &plane, &still, &*ball, 0.0, 10.0, true);
        assert_eq!(hit.expect("supports every pair").map(|hit| hit.time_of_impact), None, "{x}");
    }
}
