//! Events of strong contact forces.

use super::{ColliderHandle, ContactPair};
use crate::math::{Real, Vector};

/// Contact forces of two colliders during a step.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactForceEvent {
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// Sum of all forces.
    pub total_force: Vector,
    /// Sum of the magnitudes of all forces.
    pub total_force_magnitude: Real,
    /// Unit direction of the largest force at a contact point.
    pub max_force_direction: Vector,
    /// Magnitude of the largest force at a contact point.
    pub max_force_magnitude: Real,
    /// Whether the force was below the threshold in the step before.
    #[cfg(rapier036)]
    pub started: bool,
}

impl ContactForceEvent {
    /// The forces of a pair in a step of `dt` seconds, by the formula of the engine's event. A force beyond
    /// the range of numbers is replaced by the largest number.
    pub fn from_contact_pair(dt: Real, pair: &ContactPair, total_force_magnitude: Real) -> Self {
        let inv_dt = if dt > 0.0 { 1.0 / dt } else { 0.0 };
        let largest = Vector::splat(Real::MAX);
        let impulses = pair.manifolds().iter().flat_map(|manifold| {
            manifold.points.iter().map(|point| (point.data.impulse, manifold.data.normal))
        });
        let none = (0.0, Vector::ZERO);
        let (max_impulse, max_force_direction) =
            impulses.fold(none, |largest, next| if next.0 > largest.0 { next } else { largest });
        Self {
            collider1: pair.collider1,
            collider2: pair.collider2,
            total_force: (pair.total_impulse() * inv_dt).clamp(-largest, largest),
            total_force_magnitude: total_force_magnitude.min(Real::MAX),
            max_force_direction,
            max_force_magnitude: (max_impulse * inv_dt).min(Real::MAX),
            #[cfg(rapier036)]
            started: pair.force_started,
        }
    }
}

impl From<&engine::geometry::ContactForceEvent> for ContactForceEvent {
    fn from(event: &engine::geometry::ContactForceEvent) -> Self {
        Self {
            collider1: event.collider1,
            collider2: event.collider2,
            total_force: event.total_force,
            total_force_magnitude: event.total_force_magnitude,
            max_force_direction: event.max_force_direction,
            max_force_magnitude: event.max_force_magnitude,
            #[cfg(rapier036)]
            started: event.started,
        }
    }
}
