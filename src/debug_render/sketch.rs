//! Sketches of shapes: the lines that represent a shape in a picture.

use crate::base::outline::{Detail, Outline};
use crate::dim::math::{Pose, Vector};
use crate::dim::outline::{add_shape, ball, capsule, cuboid, plane};
use parry::shape::{Compound, Cuboid, Shape, TypedShape};

/// The sketch of a shape, in the shape's frame. Custom shapes, and kinds without a sketch, are drawn as their
/// box.
pub(super) fn outline(shape: &dyn Shape, detail: Detail) -> Outline {
    let mut out = Outline::default();
    match &shape.as_typed_shape() {
        TypedShape::Ball(s) => ball(&mut out, s.radius, detail.subdivisions),
        TypedShape::Cuboid(s) => cuboid(&mut out, s, Vector::ZERO),
        TypedShape::Capsule(s) => capsule(&mut out, s, detail.subdivisions),
        TypedShape::Segment(s) => out.segment(s.a, s.b),
        TypedShape::Triangle(s) => out.ring(&[s.a, s.b, s.c]),
        TypedShape::TriMesh(s) => return mesh(s.vertices(), s.indices()),
        TypedShape::Polyline(s) => {
            return (s.vertices().to_vec(), s.indices().to_vec()).into();
        }
        TypedShape::HalfSpace(s) => plane(&mut out, s.normal),
        TypedShape::Compound(s) => compound(&mut out, s, detail),
        typed if add_shape(&mut out, typed, detail) => {}
        _ => {
            let aabb = shape.compute_local_aabb();
            cuboid(&mut out, &Cuboid::new(aabb.half_extents()), aabb.center());
        }
    }
    out
}

fn mesh(vertices: &[Vector], triangles: &[[u32; 3]]) -> Outline {
    let lines = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    Outline { points: vertices.to_vec(), lines }.without_repeats()
}

fn compound(out: &mut Outline, shape: &Compound, detail: Detail) {
    for (pose, part) in shape.shapes() {
        out.append(&outline(&**part, detail), pose);
    }
}

/// The edges of a box with the given half extents and pose.
pub(super) fn box_outline(half_extents: Vector, pose: &Pose) -> Outline {
    let (mut local, mut out) = (Outline::default(), Outline::default());
    cuboid(&mut local, &Cuboid::new(half_extents), Vector::ZERO);
    out.append(&local, pose);
    out
}
