//! Scaled shapes. Negative factors mirror a shape, as the flip of a sprite does.
//!
//! Convex shapes and meshes are built anew from their scaled points: normals do not scale like points.

use crate::dim;
use crate::precision::Scalar;
use rapier::math as engine;
use rapier::parry::shape::{Capsule, Compound, RoundShape, Shape, TypedShape};
use rapier::prelude::{ColliderBuilder, InvalidCollider, SharedShape};

/// parry's number of subdivisions for a circle which becomes an ellipse.
const SUBDIVISIONS: u32 = 8;

type Scaled = Result<SharedShape, InvalidCollider>;

/// The shape in another size. Uneven scales make polyhedra of round shapes.
///
/// # Errors
/// If a factor is 0 or not finite, or if no shape of the engine is the scaled one.
pub(crate) fn scaled(shape: &SharedShape, scale: engine::Vector) -> Scaled {
    if scale == engine::Vector::ONE {
        return Ok(shape.clone());
    }
    let factors = scale.to_array();
    if let Some(&factor) = factors.iter().find(|factor| !factor.is_finite() || **factor == 0.0) {
        return Err(refused(factor, "finite and not 0"));
    }
    if let Some(points) = dim::convex_points(shape) {
        return hull(points, scale);
    }
    if let Some((inner, border)) = without_border(shape) {
        let factor = even_factor(scale, "even, for a shape with a border")?;
        return with_border(&scaled(&inner, scale)?, border * factor);
    }
    match shape.as_typed_shape() {
        TypedShape::Ball(_) | TypedShape::Cuboid(_) => by_parry(shape, scale.abs()),
        TypedShape::Capsule(capsule) => {
            let signs = scale.signum();
            let [a, b] = [capsule.segment.a, capsule.segment.b].map(|end| end * signs);
            by_parry(&SharedShape::new(Capsule::new(a, b, capsule.radius)), scale.abs())
        }
        TypedShape::HalfSpace(space) => {
            let normal = (space.normal / scale).normalize();
            ColliderBuilder::halfspace(normal).try_shape()
        }
        TypedShape::Segment(segment) => {
            ColliderBuilder::segment(segment.a * scale, segment.b * scale).try_shape()
        }
        TypedShape::Triangle(triangle) => {
            let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| corner * scale);
            let [b, c] = if is_mirrored(scale) { [c, b] } else { [b, c] };
            ColliderBuilder::triangle(a, b, c).try_shape()
        }
        TypedShape::TriMesh(mesh) => {
            let flip = |[a, b, c]: [u32; 3]| if is_mirrored(scale) { [a, c, b] } else { [a, b, c] };
            let vertices = mesh.vertices().iter().map(|vertex| *vertex * scale).collect();
            let indices = mesh.indices().iter().copied().map(flip).collect();
            ColliderBuilder::trimesh_with_flags(vertices, indices, mesh.flags())?.try_shape()
        }
        TypedShape::Polyline(line) => {
            let flip = |[a, b]: [u32; 2]| if is_mirrored(scale) { [b, a] } else { [a, b] };
            let vertices = line.vertices().iter().map(|vertex| *vertex * scale).collect();
            let indices = line.indices().iter().copied().map(flip).collect();
            ColliderBuilder::polyline_with_flags(vertices, Some(indices), line.flags()).try_shape()
        }
        TypedShape::Compound(compound) => scaled_compound(compound, scale),
        _ => dim::scaled(shape, scale),
    }
}

/// Returns whether the scale mirrors: a turn does not undo an odd number of negative factors.
fn is_mirrored(scale: engine::Vector) -> bool {
    scale.to_array().into_iter().product::<Scalar>() < 0.0
}

/// The magnitude of all factors.
///
/// # Errors
/// If the factors have several magnitudes.
fn even_factor(scale: engine::Vector, expected: &'static str) -> Result<Scalar, InvalidCollider> {
    let [first, rest @ ..] = scale.to_array();
    match rest.into_iter().find(|factor| factor.abs() != first.abs()) {
        Some(factor) => Err(refused(factor, expected)),
        None => Ok(first.abs()),
    }
}

/// Scales by parry, which is right for positive factors. The engine repairs mirrored height fields.
pub(crate) fn by_parry(shape: &SharedShape, scale: engine::Vector) -> Scaled {
    let negative = scale.to_array().into_iter().find(|factor| *factor < 0.0);
    if let Some(factor) = negative.filter(|_| shape.as_heightfield().is_none()) {
        return Err(refused(factor, "positive, for this shape"));
    }
    let scaled = shape.scale_dyn(scale, SUBDIVISIONS).ok_or(InvalidCollider::Degenerate {
        shape: "scaled shape",
        reason: "its convex hull has no volume",
    })?;
    ColliderBuilder::new(SharedShape(scaled.into())).try_shape()
}

/// The convex hull of scaled points.
pub(crate) fn hull(points: &[engine::Vector], scale: engine::Vector) -> Scaled {
    let points: Vec<_> = points.iter().map(|point| *point * scale).collect();
    ColliderBuilder::try_convex_hull(&points)?.try_shape()
}

/// A shape with a round border.
pub(crate) fn rounded<S>(inner_shape: S, border_radius: Scalar) -> SharedShape
where
    RoundShape<S>: Shape,
{
    SharedShape::new(RoundShape { inner_shape, border_radius })
}

/// The inner shape and the border of a shape with one.
fn without_border(shape: &SharedShape) -> Option<(SharedShape, Scalar)> {
    match shape.as_typed_shape() {
        TypedShape::RoundCuboid(round) => {
            Some((SharedShape::new(round.inner_shape), round.border_radius))
        }
        TypedShape::RoundTriangle(round) => {
            Some((SharedShape::new(round.inner_shape), round.border_radius))
        }
        other => dim::without_border(other),
    }
}

/// Adds a border to an inner shape.
fn with_border(inner: &SharedShape, border_radius: Scalar) -> Scaled {
    let shape = match inner.as_typed_shape() {
        TypedShape::Cuboid(cuboid) => rounded(*cuboid, border_radius),
        TypedShape::Triangle(triangle) => rounded(*triangle, border_radius),
        other => dim::with_border(other, border_radius).ok_or(InvalidCollider::Degenerate {
            shape: "scaled shape",
            reason: "its inner shape has no border",
        })?,
    };
    ColliderBuilder::new(shape).try_shape()
}

/// Scales each part in its own axes: a mirror turns its rotation, and an uneven scale would shear it.
fn scaled_compound(compound: &Compound, scale: engine::Vector) -> Scaled {
    let is_turned = |pose: &engine::Pose| pose.rotation != engine::Rotation::IDENTITY;
    if compound.shapes().iter().any(|(pose, _)| is_turned(pose)) {
        even_factor(scale, "even, for a compound with rotated parts")?;
    }
    let parts = compound.shapes().iter().map(|(pose, shape)| {
        let rotation = dim::mirrored_rotation(pose.rotation, scale);
        let pose = engine::Pose::from_parts(pose.translation * scale, rotation);
        Ok((pose, scaled(shape, scale)?))
    });
    ColliderBuilder::compound(parts.collect::<Result<_, InvalidCollider>>()?).try_shape()
}

/// The error of a scale.
fn refused(value: Scalar, expected: &'static str) -> InvalidCollider {
    InvalidCollider::Number { parameter: "scale", value, expected }
}
