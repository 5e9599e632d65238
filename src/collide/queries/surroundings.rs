//! The region of a shape, at rest or in motion, with lower bounds for boxes around the parts of another.

use crate::base::bvh::SlabProbe;
use crate::dim::math::{Pose, Real, Vector};
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::shape::Shape;

/// Relative margin of boxes: more than the rounding error of a transformed box.
const ROUNDING: Real = 16.0 * Real::EPSILON;

/// A region that contains a shape, in the frame of the shape whose parts are searched.
pub(super) enum Surroundings {
    /// A box, and its path.
    Box { aabb: Aabb, path: SlabProbe },
    /// All below a plane: where `normal · x ≤ offset`.
    Below { normal: Vector, offset: Real, speed: Real },
}

impl Surroundings {
    /// The region of `other` at `pose`, enlarged by `margin`. It moves at `velocity`. `composite` is the
    /// shape whose parts are searched.
    pub fn of(
        other: &dyn Shape,
        pose: &Pose,
        velocity: Vector,
        margin: Real,
        composite: &dyn Shape,
    ) -> Self {
        let size = |aabb: &Aabb| aabb.mins.abs().max(aabb.maxs.abs()).max_element();
        let own = size(&composite.compute_local_aabb());
        match other.as_halfspace() {
            Some(half_space) => {
                let normal = pose.rotation * half_space.normal;
                let rounding = ROUNDING * own.max(pose.translation.abs().max_element());
                let offset = normal.dot(pose.translation) + margin + rounding;
                Self::Below { normal, offset, speed: normal.dot(velocity) }
            }
            None => {
                let aabb = other.compute_aabb(pose);
                let aabb = aabb.loosened(margin + ROUNDING * own.max(size(&aabb)));
                let path = SlabProbe::new(aabb.center(), velocity, aabb.half_extents());
                Self::Box { aabb, path }
            }
        }
    }

    /// A lower bound of the distance from anything in a box; at most zero if they overlap.
    pub fn gap(&self, part: &Aabb) -> Real {
        match self {
            Self::Box { aabb, .. } => {
                let apart = (part.mins - aabb.maxs).max(aabb.mins - part.maxs);
                apart.max(Vector::ZERO).length() * (1.0 - 4.0 * Real::EPSILON)
            }
            Self::Below { normal, offset, .. } => {
                let lowest = normal.dot(part.center()) - normal.abs().dot(part.half_extents());
                lowest - offset
            }
        }
    }

    /// A lower bound of the time at which the moving region meets anything in a box; infinity if it never
    /// does.
    pub fn time(&self, part: &Aabb) -> Real {
        match self {
            Self::Box { path, .. } => {
                let [start, end] = path.span(part);
                // The exit of a box behind the region is at time zero.
                let is_ahead = start <= end && (end > 0.0 || self.gap(part) <= 0.0);
                if is_ahead { start } else { Real::INFINITY }
            }
            Self::Below { speed, .. } => {
                let gap = self.gap(part);
                match gap > 0.0 {
                    true if *speed > 0.0 => gap / speed * (1.0 - 4.0 * Real::EPSILON),
                    true => Real::INFINITY,
                    false => 0.0,
                }
            }
        }
    }
}
