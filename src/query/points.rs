//! Point projections and point containment.

use super::view::QueryView;
use crate::base::bvh::PointProbe;
use crate::dim::math::{Real, Vector};
use crate::model::collider::{Collider, ColliderHandle};
use parry::query::PointProjection;
use parry::shape::FeatureId;

impl<'a> QueryView<'a> {
    /// The collider that is nearest to a point, no farther away than `max_distance`, and its nearest point.
    ///
    /// A point inside a collider is its own projection if `solid` is `true`; otherwise the projection is the
    /// nearest point on the surface. The distance is in length units, points are in world space.
    pub fn project_point(
        &self,
        point: Vector,
        max_distance: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, PointProjection)> {
        if !(point.is_finite() && max_distance >= 0.0) {
            return None;
        }
        self.nearest([0.0, max_distance], &PointProbe(point), |collider| {
            let found = collider.shape().project_point(collider.position(), point, solid);
            Some((found.point.distance(point), found))
        })
    }

    /// The collider whose surface is nearest to a point, the nearest point on it, and the feature (vertex,
    /// edge, face) of the shape there. No farther away than `max_distance`.
    pub fn project_point_and_get_feature(
        &self,
        point: Vector,
        max_distance: Real,
    ) -> Option<(ColliderHandle, PointProjection, FeatureId)> {
        if !(point.is_finite() && max_distance >= 0.0) {
            return None;
        }
        let found = self.nearest([0.0, max_distance], &PointProbe(point), |collider| {
            let (found, feature) =
                collider.shape().project_point_and_get_feature(collider.position(), point);
            Some((found.point.distance(point), (found, feature)))
        });
        found.map(|(handle, (projection, feature))| (handle, projection, feature))
    }

    /// All colliders that contain a point, inside or on the surface, in no particular order.
    pub fn intersect_point(
        self,
        point: Vector,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> {
        let sound = point.is_finite().then_some(point);
        sound.into_iter().flat_map(move |point| {
            let around = self.candidates(PointProbe(point), 0.0);
            around.filter(move |(_, collider)| {
                collider.shape().contains_point(collider.position(), point)
            })
        })
    }
}
