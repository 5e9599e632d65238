//! Definitions of the tests of queries in 2D.

use rapier::parry::shape::HeightField;
use rapier::prelude::*;

/// Returns a height field of this length along x.
pub fn field(heights: &[Real], length: Real) -> SharedShape {
    SharedShape::new(HeightField::new(heights.to_vec(), Vector::new(length, 1.0)))
}

/// Returns the corners of a convex hull.
pub fn hull_corners(hull: &SharedShape) -> Option<&[Vector]> {
    hull.as_convex_polygon().map(|hull| hull.points())
}

/// Returns a height field of this length with `count` cells and random heights.
pub fn rough_field(count: usize, length: Real, mut height: impl FnMut() -> Real) -> SharedShape {
    field(&(0..=count).map(|_| height()).collect::<Vec<_>>(), length)
}

/// Returns the segments of a height field.
pub fn pieces(field: &SharedShape) -> Vec<SharedShape> {
    let field = field.as_heightfield().expect("is a height field");
    field.segments().map(SharedShape::new).collect()
}

/// Returns the outline of a square with a solid inside.
pub fn solid_box(half: Real) -> SharedShape {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|[x, y]| Vector::new(x, y) * half).to_vec();
    let line =
        ColliderBuilder::oriented_polyline(corners, Some(vec![[0, 1], [1, 2], [2, 3], [3, 0]]));
    line.build().shared_shape().clone()
}

/// Returns a segment along x, or the reason why there is none.
pub fn wide_ground(half: Real) -> Result<Collider, InvalidCollider> {
    ColliderBuilder::segment(-Vector::X * half, Vector::X * half).try_build()
}

/// Returns voxels of size 1 that fill columns of these heights, side by side along x.
pub fn columns(count: i32, mut height: impl FnMut() -> i32) -> SharedShape {
    let cells: Vec<_> =
        (0..count).flat_map(|x| (0..=height()).map(move |y| [x as Int, y as Int].into())).collect();
    SharedShape::voxels(Vector::ONE, &cells)
}

/// Returns a shape of each kind, about a metre in size.
pub fn every_shape() -> Vec<(&'static str, SharedShape)> {
    let corners = || vec![Vector::X, Vector::Y, Vector::new(-0.6, -0.4), -Vector::Y];
    let mut height = [0.2, -0.3, 0.4, 0.0, 0.1, -0.1, 0.5].into_iter().cycle();
    let mut column = [0, 1, 0, 2].into_iter().cycle();
    let mesh = SharedShape::trimesh(corners(), vec![[0, 1, 2], [0, 2, 3]]).expect("a mesh");
    vec![
        ("ball", SharedShape::ball(0.5)),
        ("cuboid", SharedShape::cuboid(0.5, 0.3)),
        ("capsule", SharedShape::capsule_x(0.5, 0.3)),
        ("hull", SharedShape::convex_hull(&corners()).expect("a hull")),
        ("triangle", SharedShape::triangle(Vector::X, Vector::Y, -Vector::Y)),
        ("segment", SharedShape::segment(Vector::X, -Vector::Y)),
        ("round cuboid", SharedShape::round_cuboid(0.4, 0.3, 0.1)),
        ("half-space", SharedShape::halfspace(Vector::new(0.6, 0.8))),
        ("mesh", mesh),
        ("polyline", SharedShape::polyline(corners(), None)),
        ("solid polyline", solid_box(0.4)),
        ("height field", rough_field(5, 3.0, || height.next().unwrap_or(0.0))),
        ("voxels", columns(3, || column.next().unwrap_or(0))),
        (
            "compound",
            SharedShape::compound(vec![
                (Pose::from_translation(Vector::X), SharedShape::ball(0.4)),
                (Pose::from_translation(-Vector::X * 0.5), SharedShape::cuboid(0.3, 0.4)),
            ]),
        ),
    ]
}

/// Returns the directions normal to some edges.
pub fn axes(edges: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let axis = |&[x, y]: &[f64; 2]| (x != 0.0 || y != 0.0).then(|| [-y, x].map(|v| v / x.hypot(y)));
    edges.iter().filter_map(axis).collect()
}

/// Returns shapes with straight sides and their corners.
pub fn corner_shapes() -> Vec<(&'static str, SharedShape, Vec<Vector>)> {
    let corners = vec![Vector::X, Vector::Y, Vector::new(-0.6, -0.4), -Vector::Y];
    let rectangle = |x: Real, y: Real| {
        [[x, y], [-x, y], [x, -y], [-x, -y]].map(|[x, y]| Vector::new(x, y)).to_vec()
    };
    let [a, b, c] = [Vector::X, Vector::Y * 0.8, -Vector::Y];
    vec![
        ("box", SharedShape::cuboid(0.5, 0.3), rectangle(0.5, 0.3)),
        ("plate", SharedShape::cuboid(0.5, 0.0), rectangle(0.5, 0.0)),
        ("hull", SharedShape::convex_hull(&corners).expect("a hull"), corners),
        ("triangle", SharedShape::triangle(a, b, c), vec![a, b, c]),
        ("segment", SharedShape::segment(a, c), vec![a, c]),
    ]
}
