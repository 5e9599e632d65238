//! Poses of the wheels, and the ground below them.

use super::check::{Directions, directions};
use super::wheel::{Below, RayCastInfo, Wheel};
use crate::dim::math::{Pose, Real, Vector, rotation_from_angle};
use crate::model::body::{RigidBody, RigidBodyHandle};
use crate::model::collider::{Collider, ColliderHandle};
use crate::query::{QueryFilter, QueryPredicate, QueryView};
use parry::query::Ray;

impl Wheel {
    /// A wheel that was not placed yet.
    pub(super) fn nowhere() -> RayCastInfo {
        RayCastInfo {
            contact_normal_ws: Vector::ZERO,
            contact_point_ws: Vector::ZERO,
            suspension_length: 0.0,
            hard_point_ws: Vector::ZERO,
            is_in_contact: false,
            ground_object: None,
        }
    }

    /// Moves the wheel with the chassis, and casts its ray to the ground that it may reach within `dt`
    /// seconds. `queries` do not contain the chassis.
    pub(super) fn place(&mut self, chassis: &RigidBody, dt: Real, queries: &QueryView<'_>) {
        self.below = None;
        match directions(self) {
            Ok(directions) => {
                self.is_reported = false;
                self.hang(chassis.position(), &directions);
                self.cast_ray_to_ground(chassis, dt, queries);
            }
            Err(problem) => {
                if !self.is_reported {
                    log::warn!("a wheel is inactive: it has an invalid {problem}");
                    self.is_reported = true;
                }
                self.raycast_info.is_in_contact = false;
                self.raycast_info.ground_object = None;
            }
        }
        (self.forward_impulse, self.side_impulse, self.wheel_suspension_force) = (0.0, 0.0, 0.0);
        self.is_sliding = false;
    }

    /// Returns whether the pose is usable.
    pub(super) fn is_usable(&self) -> bool {
        !self.is_reported
    }

    /// The wheel in the air.
    fn hang(&mut self, chassis: &Pose, directions: &Directions) {
        let Directions { suspension, axle } = *directions;
        let steering = rotation_from_angle(suspension * -self.steering);
        self.suspension_ws = chassis.rotation * suspension;
        self.axle_ws = chassis.rotation * (steering * axle);
        let hard_point = chassis * self.chassis_connection_point_cs;
        let reach = self.suspension_rest_length + self.radius;
        self.raycast_info = RayCastInfo {
            contact_normal_ws: -self.suspension_ws,
            contact_point_ws: hard_point + self.suspension_ws * reach,
            suspension_length: self.suspension_rest_length,
            hard_point_ws: hard_point,
            is_in_contact: false,
            ground_object: None,
        };
    }

    fn cast_ray_to_ground(&mut self, chassis: &RigidBody, dt: Real, queries: &QueryView<'_>) {
        let (from, along) = (self.raycast_info.hard_point_ws, self.suspension_ws);
        let reach = self.suspension_rest_length + self.radius;
        let approach = chassis.velocity_at_point(from).dot(along).max(0.0) * dt;
        let ray = Ray::new(from, along);
        // Half a radius more covers ground that moves towards the wheel.
        let far = reach + approach + 0.5 * self.radius;
        let Some((collider, hit)) = queries.cast_ray_and_get_normal(&ray, far, true) else {
            return;
        };
        let normal = normal_against(hit.normal, along);
        let point = from + along * hit.time_of_impact;
        let compression = (reach - hit.time_of_impact)
            .min(self.max_suspension_travel)
            .min(self.suspension_rest_length);
        self.below = Some(Below { collider, normal, point, compression });
        if compression >= 0.0 {
            self.raycast_info = RayCastInfo {
                contact_normal_ws: normal,
                contact_point_ws: point,
                suspension_length: self.suspension_rest_length - compression,
                hard_point_ws: from,
                is_in_contact: true,
                ground_object: Some(collider),
            };
        }
    }
}

/// The normal of the side that the ray came to. A ray that begins inside a solid shape has none: the shape is
/// pushed out along the ray.
fn normal_against(normal: Vector, along: Vector) -> Vector {
    match normal.try_normalize() {
        Some(unit) if unit.dot(along) > 0.0 => -unit,
        Some(unit) => unit,
        None => -along,
    }
}

/// A query with the filter for wheels: the user's filter, without the chassis itself and without sensors.
pub(super) fn with_ground_alone<R>(
    filter: QueryFilter<'_>,
    chassis: RigidBodyHandle,
    run_query: impl FnOnce(QueryFilter<'_>) -> R,
) -> R {
    // A filter excludes one body, which may be the user's: the chassis needs a second exclusion.
    let users = filter.predicate;
    let predicate = |handle: ColliderHandle, collider: &Collider| {
        collider.parent() != Some(chassis)
            && users.is_none_or(|predicate| predicate(handle, collider))
    };
    let predicate: QueryPredicate<'_> = &predicate;
    run_query(
        QueryFilter {
            flags: filter.flags,
            groups: filter.groups,
            exclude_collider: filter.exclude_collider,
            exclude_rigid_body: filter.exclude_rigid_body,
            predicate: Some(predicate),
        }
        .exclude_sensors(),
    )
}

/// The predicted velocities (linear, angular) of a body in the next step.
pub(super) fn velocities_ahead(body: &RigidBody, dt: Real) -> (Vector, Vector) {
    if body.is_kinematic() && body.next_position() != body.position() {
        let ahead = body.velocity_to_next_position(1.0 / dt);
        return (ahead.linvel, ahead.angvel);
    }
    (body.linvel(), body.angvel())
}
