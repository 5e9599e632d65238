//! Contact forces of two colliders during a step.

use crate::dim::math::{Real, Vector};
use crate::model::collider::ColliderHandle;
use crate::model::contact::ContactPair;

/// Contact forces between two colliders, averaged over one step.
///
/// Forces act along the contact normals, from the first collider onto the second. Friction is excluded.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactForceEvent {
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// Sum of all contact forces, in world space (mass · length / s²).
    pub total_force: Vector,
    /// Sum of the magnitudes of all contact forces (mass · length / s²). Larger than the magnitude of
    /// the sum where a body is squeezed: forces of opposite directions do not cancel.
    pub total_force_magnitude: Real,
    /// Unit direction of the largest force of one contact, in world space; zero if there is none.
    pub max_force_direction: Vector,
    /// Magnitude of the largest force of one contact (mass · length / s²).
    pub max_force_magnitude: Real,
    /// Whether this is the first step in which the force reaches the threshold. In the step before, it was
    /// smaller, or the two did not touch.
    pub started: bool,
}

impl ContactForceEvent {
    /// The forces of a pair in a step of `dt` seconds. `total_force_magnitude` is taken as given, because the
    /// stage that sends the event has computed it. In a step of no length the force is zero. A force beyond
    /// the range of numbers is replaced by the largest number. [`Self::started`] is `false`; the step sets
    /// it.
    pub fn from_contact_pair(dt: Real, pair: &ContactPair, total_force_magnitude: Real) -> Self {
        let inv_dt = if dt > 0.0 { 1.0 / dt } else { 0.0 };
        let largest = Vector::splat(Real::MAX);
        let (max_impulse, max_force_direction) = pair.max_impulse();
        Self {
            collider1: pair.collider1,
            collider2: pair.collider2,
            total_force: (pair.total_impulse() * inv_dt).clamp(-largest, largest),
            total_force_magnitude: total_force_magnitude.min(Real::MAX),
            max_force_direction,
            max_force_magnitude: (max_impulse * inv_dt).min(Real::MAX),
            started: false,
        }
    }
}
