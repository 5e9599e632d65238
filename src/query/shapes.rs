//! Shape casts and overlap tests.

use super::view::QueryView;
use crate::base::bvh::{BoxProbe, SlabProbe};
use crate::base::parry_version::is_intersecting;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::{Collider, ColliderHandle};
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::query::{NonlinearRigidMotion, ShapeCastHit, ShapeCastOptions};
use parry::shape::Shape;

fn is_finite(pose: &Pose) -> bool {
    crate::model::check::checked_pose(*pose).is_some()
}

/// The box around a shape in motion.
fn sweep(shape: &dyn Shape, pose: &Pose, velocity: Vector, target_distance: Real) -> SlabProbe {
    let aabb = shape.compute_aabb(pose);
    // Rounding must not let two boxes miss each other that touch.
    let size = aabb.mins.abs().max(aabb.maxs.abs()).max_element();
    let margin = target_distance.max(0.0) + 16.0 * Real::EPSILON * size;
    SlabProbe::new(aabb.center(), velocity, aabb.half_extents() + Vector::splat(margin))
}

impl<'a> QueryView<'a> {
    /// All colliders whose boxes in the trees overlap a box, in no particular order. These boxes are larger
    /// than the colliders, so the result includes colliders that do not touch the box.
    pub fn intersect_aabb_conservative(
        self,
        aabb: Aabb,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> {
        self.candidates(BoxProbe(aabb), Real::MAX)
    }

    /// All colliders that a shape intersects, in no particular order.
    pub fn intersect_shape(
        self,
        shape_pos: Pose,
        shape: &'a dyn Shape,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> {
        let posed = is_finite(&shape_pos).then_some(shape_pos);
        posed.into_iter().flat_map(move |pose| {
            let size = pose.translation.abs().max_element();
            let aabb = shape.compute_aabb(&pose).loosened(16.0 * Real::EPSILON * size);
            self.intersect_aabb_conservative(aabb).filter(move |(_, collider)| {
                let pose12 = pose.inv_mul(collider.position());
                let other = collider.shape();
                self.ask(|dispatcher| dispatcher.intersection_test(&pose12, shape, other))
                    .is_some_and(is_intersecting)
            })
        })
    }

    /// The first collider that a shape hits at constant velocity, without rotation.
    ///
    /// A shape without velocity hits nothing: use [`Self::intersect_shape`] for the colliders that it
    /// touches. Times are in units of `shape_vel`. `options` contains the largest time, the distance at which
    /// the shape stops, and whether a shape hits a collider in which it starts.
    ///
    /// Side 1 of the hit is the collider, in world space: `witness1` is the point on it, `normal1` its
    /// outward normal. Side 2 is the cast shape, in its own frame.
    pub fn cast_shape(
        &self,
        shape_pos: &Pose,
        shape_vel: Vector,
        shape: &dyn Shape,
        options: ShapeCastOptions,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        let limit = options.max_time_of_impact;
        let is_sound = is_finite(shape_pos)
            && shape_vel.is_finite()
            && shape_vel != Vector::ZERO
            && (0.0..Real::INFINITY).contains(&options.target_distance)
            && limit >= 0.0;
        if !is_sound {
            return None;
        }
        let sweep = sweep(shape, shape_pos, shape_vel, options.target_distance);
        self.nearest([0.0, limit], &sweep, |collider| {
            let pose12 = shape_pos.inv_mul(collider.position());
            let velocity12 = shape_pos.rotation.inverse() * -shape_vel;
            let other = collider.shape();
            let hit = self.ask(|dispatcher| {
                dispatcher.cast_shapes(&pose12, velocity12, shape, other, options)
            })??;
            Some((hit.time_of_impact, collider_first(hit, collider)))
        })
    }

    /// The first collider that a shape hits between two times of a motion with rotation.
    ///
    /// With `stop_at_penetration`, a shape that starts inside a collider hits it at once. Otherwise it hits
    /// only if it moves deeper. The sides of the hit are those of [`Self::cast_shape`]; side 2 is in the
    /// frame that the shape has at the time of impact.
    pub fn cast_shape_nonlinear(
        &self,
        shape_motion: &NonlinearRigidMotion,
        shape: &dyn Shape,
        start_time: Real,
        end_time: Real,
        stop_at_penetration: bool,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        let around = swept_box(shape_motion, shape, start_time, end_time)?;
        self.nearest([start_time, end_time], &BoxProbe(around), |collider| {
            let still = NonlinearRigidMotion::constant_position(*collider.position());
            let hit = self.ask(|dispatcher| {
                dispatcher.cast_shapes_nonlinear(
                    shape_motion,
                    shape,
                    &still,
                    collider.shape(),
                    start_time,
                    end_time,
                    stop_at_penetration,
                )
            })??;
            Some((hit.time_of_impact, collider_first(hit, collider)))
        })
    }
}

/// The hit of a cast shape (side 1) on a collider (side 2, in its frame) with the collider as side 1, in
/// world space.
fn collider_first(hit: ShapeCastHit, collider: &Collider) -> ShapeCastHit {
    hit.swapped().transform1_by(collider.position())
}

/// A box that contains the shape between the two times; `None` for an invalid motion.
///
/// The centre moves straight, and rotation does not change the distance of any point from the centre.
fn swept_box(
    motion: &NonlinearRigidMotion,
    shape: &dyn Shape,
    start_time: Real,
    end_time: Real,
) -> Option<Aabb> {
    let poses = [motion.position_at_time(start_time), motion.position_at_time(end_time)];
    let is_sound = start_time <= end_time && poses.iter().all(is_finite);
    if !is_sound {
        return None;
    }
    let local = shape.compute_local_aabb();
    let center = motion.local_center;
    let corner = (local.mins - center).abs().max((local.maxs - center).abs());
    let reach = Vector::splat(corner.length());
    let centers = poses.map(|pose| pose * center);
    Some(Aabb::new(centers[0].min(centers[1]) - reach, centers[0].max(centers[1]) + reach))
}
