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
}

impl ContactForceEvent {
    /// The forces of a pair in a step of `dt` seconds.
    pub fn from_contact_pair(dt: Real, pair: &ContactPair, total_force_magnitude: Real) -> Self {
        let impulses = pair.manifolds.iter().flat_map(|manifold| {
            manifold.points.iter().map(|point| (manifold.data.normal, point.data.impulse))
        });
        let event = Self::from_impulses(dt, impulses, total_force_magnitude);
        Self { collider1: pair.collider1, collider2: pair.collider2, ..event }
    }

    /// [`Self::from_contact_pair`] for a pair of the engine, without its conversion.
    pub(crate) fn from_engine_pair(
        dt: Real,
        pair: &engine::geometry::ContactPair,
        total_force_magnitude: Real,
    ) -> Self {
        let impulses = pair.manifolds.iter().flat_map(|manifold| {
            manifold.data.points.iter().map(|point| (manifold.data.normal, point.impulse))
        });
        let event = Self::from_impulses(dt, impulses, total_force_magnitude);
        Self { collider1: pair.collider1, collider2: pair.collider2, ..event }
    }

    /// The event of contact points, each given by its normal and its normal impulse.
    fn from_impulses(
        dt: Real,
        impulses: impl Iterator<Item = (Vector, Real)>,
        total_force_magnitude: Real,
    ) -> Self {
        let inv_dt = if dt == 0.0 { 0.0 } else { 1.0 / dt };
        let mut event = Self { total_force_magnitude, ..Self::default() };
        for (normal, impulse) in impulses {
            let force = impulse * inv_dt;
            event.total_force += normal * force;
            if force > event.max_force_magnitude {
                (event.max_force_magnitude, event.max_force_direction) = (force, normal);
            }
        }
        event
    }
}
