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
    /// Unit direction of the largest force of a manifold.
    pub max_force_direction: Vector,
    /// Magnitude of the largest force of a manifold.
    pub max_force_magnitude: Real,
}

impl ContactForceEvent {
    /// The forces of a pair in a step of `dt` seconds.
    pub fn from_contact_pair(dt: Real, pair: &ContactPair, total_force_magnitude: Real) -> Self {
        let inv_dt = if dt == 0.0 { 0.0 } else { 1.0 / dt };
        let (max_impulse, max_force_direction) = pair.max_impulse();
        Self {
            collider1: pair.collider1,
            collider2: pair.collider2,
            total_force: pair.total_impulse() * inv_dt,
            total_force_magnitude,
            max_force_direction,
            max_force_magnitude: max_impulse * inv_dt,
        }
    }
}
