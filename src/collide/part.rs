//! A convex part of a shape.

use super::normals::FACE_NORMAL_COSINE_MIN;
use crate::dim::collide::{Flat, as_flat, flat_corners};
use crate::dim::math::{Pose, Real, Vector};
use parry::query::details::NormalConstraints;
use parry::shape::{Shape, TypedShape};

/// One convex part of a shape.
#[derive(Copy, Clone)]
pub(super) struct Part<'a> {
    /// Its number within the shape.
    pub id: u32,
    /// Its place in the frame of the shape; `None` if the frames are the same.
    pub pose: Option<&'a Pose>,
    /// The part itself.
    pub shape: &'a dyn Shape,
    /// The directions in which a contact normal may leave the part, where neighbours restrict them.
    pub constraints: Option<&'a dyn NormalConstraints>,
}

impl<'a> Part<'a> {
    /// A convex shape as its own only part.
    pub fn whole(shape: &'a dyn Shape) -> Self {
        Self { id: 0, pose: None, shape, constraints: None }
    }

    /// Returns whether the search of this part may start from the normal of a manifold of its plane. Balls,
    /// boxes and capsules need no such start, unless they have no thickness.
    pub fn uses_plane_normal(&self) -> bool {
        match self.shape.as_typed_shape() {
            TypedShape::Ball(ball) => ball.radius == 0.0,
            TypedShape::Cuboid(cuboid) => cuboid.half_extents.min_element() == 0.0,
            TypedShape::Capsule(capsule) => capsule.radius == 0.0,
            _ => true,
        }
    }

    /// Returns whether the part is flat and lies in a plane of its shape's frame.
    pub fn is_flat_in(&self, point: Vector, normal: Vector, tolerance: Real) -> bool {
        let is_near = |corner: Vector| {
            let corner = self.pose.map_or(corner, |pose| *pose * corner);
            (corner - point).dot(normal).abs() < tolerance
        };
        as_flat(self.shape).is_some_and(|flat| flat_corners(flat).into_iter().all(is_near))
    }

    /// Returns whether the part is flat and its normal differs from a direction in its shape's frame.
    pub fn has_other_normal(&self, direction: Vector) -> bool {
        let Some(flat) = as_flat(self.shape).and_then(Flat::new) else { return false };
        let normal = self.pose.map_or(flat.normal(), |pose| pose.rotation * flat.normal());
        normal.dot(direction).abs() < FACE_NORMAL_COSINE_MIN
    }

    /// Place of the part in the frame of its shape.
    pub fn pose(&self) -> Pose {
        self.pose.copied().unwrap_or(Pose::IDENTITY)
    }
}
