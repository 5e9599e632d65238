//! Sleep of vehicles, and causes of waking.
//!
//! A ray is no contact: the step has neither the support of a vehicle nor the state of its pedals. A sleeping
//! vehicle therefore still casts its rays at each update, and wakes when the ground has changed.

use super::wheel::Wheel;
use crate::dim::math::Real;
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::collider::{ColliderHandle, ColliderSet};

/// Fraction of the radius up to which a displacement of the ground below a sleeping vehicle is rounding.
const GROUND_MOTION_FRACTION_MAX: Real = 1.0e-3;

/// A wheel as it was when the vehicle was awake.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct WheelState {
    brake: Real,
    steering: Real,
    ground: Option<ColliderHandle>,
    length: Real,
}

impl WheelState {
    pub fn of(wheel: &Wheel) -> Self {
        let info = wheel.raycast_info();
        Self {
            brake: wheel.brake,
            steering: wheel.steering,
            ground: info.ground_object,
            length: info.suspension_length,
        }
    }

    /// Returns whether the wheel is unchanged, apart from rounding.
    fn is_still(&self, wheel: &Wheel) -> bool {
        let now = Self::of(wheel);
        let moved = (now.length - self.length).abs();
        Self { length: self.length, ..now } == *self
            && moved <= GROUND_MOTION_FRACTION_MAX * wheel.radius
    }
}

/// Returns whether there is a reason to wake a sleeping vehicle.
pub(super) fn is_disturbed(
    wheels: &[Wheel],
    seen: &[WheelState],
    bodies: &RigidBodySet,
    colliders: &ColliderSet,
) -> bool {
    if wheels.len() != seen.len() {
        return true;
    }
    wheels.iter().zip(seen).filter(|(wheel, _)| wheel.is_usable()).any(|(wheel, seen)| {
        let ground = wheel.raycast_info.ground_object.and_then(|handle| colliders.get(handle));
        let body = ground.and_then(|ground| bodies.get(ground.parent()?));
        let is_active = |body: &RigidBody| {
            body.is_moving()
                || body.next_position() != body.position()
                || (body.is_dynamic() && !body.is_sleeping())
        };
        wheel.engine_force != 0.0 || !seen.is_still(wheel) || body.is_some_and(is_active)
    })
}

/// Returns whether an engine drives a vehicle. A coasting vehicle falls asleep like any other body.
pub(super) fn is_driven(wheels: &[Wheel]) -> bool {
    wheels.iter().any(|wheel| wheel.is_usable() && wheel.engine_force != 0.0)
}
