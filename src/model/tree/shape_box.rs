//! The tight box of a shape.

use crate::dim::math::{Pose, Vector};
use parry::bounding_volume::Aabb;
use parry::shape::{Shape, TypedShape};

/// The box of a shape in world space, for which the commonest shapes need no call through a table.
pub(crate) fn shape_box(shape: &dyn Shape, pose: &Pose) -> Aabb {
    match shape.as_typed_shape() {
        TypedShape::Ball(ball) => {
            Aabb::from_half_extents(pose.translation, Vector::splat(ball.radius))
        }
        TypedShape::Cuboid(cuboid) => cuboid.aabb(pose),
        TypedShape::Capsule(capsule) => {
            let (a, b) = (*pose * capsule.segment.a, *pose * capsule.segment.b);
            let radius = Vector::splat(capsule.radius);
            Aabb::new(a.min(b) - radius, a.max(b) + radius)
        }
        _ => shape.compute_aabb(pose),
    }
}
