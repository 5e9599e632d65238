//! The dispatcher of queries of two shapes.

use super::pair_query::{Found, PairQuery};
use super::turning::first_touch;
use crate::base::parry_version::{
    ShapeDistance, ShapeIntersection, contact_of_parts, shape_cast_hit, shape_distance,
    shape_intersection,
};
use crate::collide::manifolds::pose_is_usable;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::contact::NarrowPhase;
use parry::query::{
    ClosestPoints, Contact, NonlinearRigidMotion, QueryDispatcher, ShapeCastHit, ShapeCastOptions,
    Unsupported,
};
use parry::shape::Shape;

impl NarrowPhase {
    /// The algorithms for pairs of shapes in queries. They support every pair: no method returns
    /// `Unsupported`.
    pub fn query_dispatcher(&self) -> &dyn QueryDispatcher {
        &Dispatcher
    }
}

/// Queries of any two shapes.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Dispatcher;

/// Returns whether the two shapes intersect. `pose12` is the pose of the second in the frame of the first.
pub(crate) fn shapes_intersect(pose12: &Pose, shape1: &dyn Shape, shape2: &dyn Shape) -> bool {
    pose_is_usable(pose12) && PairQuery::Intersection.least(pose12, [shape1, shape2], 0.0).is_some()
}

impl Dispatcher {
    /// The points where two shapes are closest or deepest, if they are within `prediction`.
    pub fn contact_of(
        self,
        pose12: &Pose,
        shapes: [&dyn Shape; 2],
        prediction: Real,
    ) -> Option<Contact> {
        let found = PairQuery::Contact.least(pose12, shapes, prediction.min(Real::MAX))?;
        let Found { cost, points: [point1, point2], normals: [normal1, normal2], ids, .. } = found;
        Some(contact_of_parts(Contact::new(point1, point2, normal1, normal2, cost), ids))
    }
}

impl QueryDispatcher for Dispatcher {
    fn intersection_test(
        &self,
        pose12: &Pose,
        shape1: &dyn Shape,
        shape2: &dyn Shape,
    ) -> Result<ShapeIntersection, Unsupported> {
        let found = PairQuery::Intersection.least(pose12, [shape1, shape2], 0.0);
        Ok(shape_intersection(found.is_some(), found.map_or([0; 2], |found| found.ids)))
    }

    fn distance(
        &self,
        pose12: &Pose,
        shape1: &dyn Shape,
        shape2: &dyn Shape,
    ) -> Result<ShapeDistance, Unsupported> {
        let found = PairQuery::Distance.least(pose12, [shape1, shape2], Real::MAX);
        let found = found.unwrap_or(Found::at(Real::MAX));
        Ok(shape_distance(found.cost.max(0.0), found.ids))
    }

    fn contact(
        &self,
        pose12: &Pose,
        shape1: &dyn Shape,
        shape2: &dyn Shape,
        prediction: Real,
    ) -> Result<Option<Contact>, Unsupported> {
        Ok(self.contact_of(pose12, [shape1, shape2], prediction))
    }

    fn closest_points(
        &self,
        pose12: &Pose,
        shape1: &dyn Shape,
        shape2: &dyn Shape,
        max_distance: Real,
    ) -> Result<ClosestPoints, Unsupported> {
        Ok(match self.contact_of(pose12, [shape1, shape2], max_distance) {
            None => ClosestPoints::Disjoint,
            Some(contact) if contact.dist <= 0.0 => ClosestPoints::Intersecting,
            Some(contact) => ClosestPoints::WithinMargin(contact.point1, contact.point2),
        })
    }

    fn cast_shapes(
        &self,
        pose12: &Pose,
        velocity12: Vector,
        shape1: &dyn Shape,
        shape2: &dyn Shape,
        options: ShapeCastOptions,
    ) -> Result<Option<ShapeCastHit>, Unsupported> {
        let query = PairQuery::Cast { velocity: velocity12, options };
        let limit = options.max_time_of_impact.min(Real::MAX);
        let found = query.least(pose12, [shape1, shape2], limit);
        Ok(found.map(|found| {
            shape_cast_hit(found.cost, found.points, found.normals, found.status, found.ids)
        }))
    }

    fn cast_shapes_nonlinear(
        &self,
        motion1: &NonlinearRigidMotion,
        shape1: &dyn Shape,
        motion2: &NonlinearRigidMotion,
        shape2: &dyn Shape,
        start_time: Real,
        end_time: Real,
        stop_at_penetration: bool,
    ) -> Result<Option<ShapeCastHit>, Unsupported> {
        let times = [start_time, end_time];
        Ok(first_touch([motion1, motion2], [shape1, shape2], times, stop_at_penetration))
    }
}
