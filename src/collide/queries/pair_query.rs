//! Queries of two shapes, reduced to their parts.
//!
//! A query has a *cost*: a distance, or a time. Its result is the pair of plain parts of least cost. The
//! parts are visited best-first, with lower bounds for the boxes of parts.

use super::inside::way_out;
use super::plain;
use super::surroundings::Surroundings;
use crate::collide::part::Part;
use crate::collide::parts::Parts;
use crate::dim::collide::has_inside;
use crate::dim::math::{Pose, Real, Vector};
use parry::bounding_volume::Aabb;
use parry::query::{ShapeCastOptions, ShapeCastStatus};
use parry::shape::Shape;

/// A query of two shapes.
#[derive(Copy, Clone, Debug)]
pub(super) enum PairQuery {
    /// Whether they intersect: the cost is zero.
    Intersection,
    /// Their distance: zero if they overlap.
    Distance,
    /// Their closest or deepest points. The cost is the distance, negative if they overlap.
    Contact,
    /// The time at which the second, moving at a velocity relative to the first, touches the first.
    Cast { velocity: Vector, options: ShapeCastOptions },
}

/// The result of a query, each side in the frame of its shape.
#[derive(Copy, Clone, Debug)]
pub(super) struct Found {
    pub cost: Real,
    pub points: [Vector; 2],
    /// Unit outward normals.
    pub normals: [Vector; 2],
    /// The parts.
    pub ids: [u32; 2],
    pub status: ShapeCastStatus,
}

impl Found {
    /// A result without points.
    pub fn at(cost: Real) -> Self {
        let zero = [Vector::ZERO; 2];
        Self { cost, points: zero, normals: zero, ids: [0; 2], status: ShapeCastStatus::Converged }
    }

    /// The same with the first side in the frame of the shape that contains the part.
    fn of_part(mut self, part: &Part<'_>) -> Self {
        if let Some(pose) = part.pose {
            self.points[0] = *pose * self.points[0];
            self.normals[0] = pose.rotation * self.normals[0];
        }
        self.ids[0] = part.id;
        self
    }

    /// The same with the sides exchanged.
    pub fn swapped(mut self) -> Self {
        self.points.swap(0, 1);
        self.normals.swap(0, 1);
        self.ids.swap(0, 1);
        self
    }
}

impl PairQuery {
    /// The same for a first shape that is a part at a pose.
    pub fn for_part(self, pose: Option<&Pose>) -> Self {
        match (self, pose) {
            (Self::Cast { velocity, options }, Some(pose)) => {
                Self::Cast { velocity: pose.rotation.inverse() * velocity, options }
            }
            _ => self,
        }
    }

    /// The same with the shapes exchanged.
    fn swapped(self, pose12: &Pose) -> Self {
        match self {
            Self::Cast { velocity, options } => {
                Self::Cast { velocity: pose12.rotation.inverse() * -velocity, options }
            }
            _ => self,
        }
    }

    /// Finds the pair of parts of least cost, up to the limit. `pose12` is the pose of the second shape in
    /// the frame of the first.
    pub fn least(self, pose12: &Pose, shapes: [&dyn Shape; 2], limit: Real) -> Option<Found> {
        let parts = shapes.map(Parts::of);
        let [is_composite1, is_composite2] = parts.map(|parts| !parts.is_convex());
        let [is_solid1, is_solid2] = shapes.map(has_inside);
        // Parts are inside or outside of a solid one by one, so a solid stays whole for the other's parts.
        let splits = [
            is_composite1 && (!is_composite2 || !is_solid1 || is_solid2),
            is_composite2 && (!is_composite1 || is_solid1),
        ];
        if splits == [false; 2] {
            return plain::least(self, pose12, shapes, limit);
        }
        let (mut least, mut limit) = (None, limit);
        for side in [0, 1].into_iter().filter(|&side| splits[side]) {
            let found = match side {
                0 => self.least_of_parts(pose12, &parts[0], shapes[1], limit),
                _ => {
                    let (query, pose21) = (self.swapped(pose12), pose12.inverse());
                    let found = query.least_of_parts(&pose21, &parts[1], shapes[0], limit);
                    found.map(Found::swapped)
                }
            };
            if let Some(found) = found {
                (least, limit) = (Some(found), found.cost);
            }
        }
        least
    }

    /// The same for a first shape of several parts.
    fn least_of_parts(
        self,
        pose12: &Pose,
        parts: &Parts<'_>,
        other: &dyn Shape,
        limit: Real,
    ) -> Option<Found> {
        if let Some(found) = self.of_inside(pose12, parts.shape(), other) {
            return Some(found).filter(|found| found.cost <= limit);
        }
        let surroundings = self.surroundings(pose12, parts.shape(), other);
        let lower = |aabb: &Aabb| self.lower_bound(&surroundings, aabb);
        let mut least = None;
        parts.search(limit.next_up(), &lower, &mut |part, limit| {
            let pose = part.pose.map(|pose| pose.inv_mul(pose12));
            let pose = pose.as_ref().unwrap_or(pose12);
            let query = self.for_part(part.pose);
            match query.least(pose, [part.shape, other], limit.min(Real::MAX)) {
                Some(found) if found.cost < limit => {
                    least = Some(found.of_part(&part));
                    found.cost
                }
                _ => limit,
            }
        });
        least
    }

    /// The result for a shape inside a solid whose surface is the first shape.
    fn of_inside(self, pose12: &Pose, solid: &dyn Shape, other: &dyn Shape) -> Option<Found> {
        let found = way_out(pose12, solid, other)?;
        match self {
            Self::Intersection | Self::Distance => Some(Found { cost: 0.0, ..found }),
            Self::Contact => Some(found),
            Self::Cast { velocity, options } => {
                let goes_out = velocity.dot(found.normals[0]) >= 0.0;
                let is_hit = options.stop_at_penetration || !goes_out;
                is_hit.then_some(Found { cost: 0.0, ..found })
            }
        }
    }

    fn surroundings(self, pose12: &Pose, composite: &dyn Shape, other: &dyn Shape) -> Surroundings {
        let (velocity, margin) = match self {
            Self::Cast { velocity, options } => (velocity, options.target_distance),
            _ => (Vector::ZERO, 0.0),
        };
        Surroundings::of(other, pose12, velocity, margin, composite)
    }

    fn lower_bound(self, surroundings: &Surroundings, aabb: &Aabb) -> Real {
        match self {
            Self::Intersection if surroundings.gap(aabb) > 0.0 => Real::INFINITY,
            Self::Intersection => 0.0,
            Self::Distance => surroundings.gap(aabb).max(0.0),
            // The depth of overlapping boxes is unknown.
            Self::Contact => match surroundings.gap(aabb) {
                gap if gap > 0.0 => gap,
                _ => Real::NEG_INFINITY,
            },
            Self::Cast { .. } => surroundings.time(aabb),
        }
    }
}
