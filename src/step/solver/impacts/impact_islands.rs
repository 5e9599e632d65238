//! Iterations and energy of an island in an impact.

use crate::dim::math::Real;

/// Iterations over all contacts that hit, per substep, in an island with a contact of restitution 1.
const ITERATIONS_MAX: usize = 128;
/// Largest number of contacts of an island that gets all iterations for any restitution.
const CONTACTS_ALL_ITERATIONS_MAX: usize = 32;

/// The contacts of an island that have restitution: their number, and the largest restitution. The number of
/// iterations follows from both.
#[derive(Copy, Clone, Default)]
pub(super) struct IslandRestitution {
    pub contacts: usize,
    pub restitution: Real,
}

impl IslandRestitution {
    /// Number of iterations per substep.
    pub fn iterations(&self) -> usize {
        let smallness = CONTACTS_ALL_ITERATIONS_MAX as Real / self.contacts as Real;
        let fraction = self.restitution.max(smallness).min(1.0);
        (ITERATIONS_MAX as Real * fraction).ceil() as usize
    }
}

/// Progress of an island in an impact. Islands are independent: other islands do not change a bit of the
/// results.
#[derive(Copy, Clone, Default)]
pub(super) struct ImpactIsland {
    /// Remaining iterations of this substep.
    pub iterations: usize,
    /// Whether the current round includes the island, and the island has not converged.
    pub is_active: bool,
    /// Whether the last iteration changed the island.
    pub is_moving: bool,
    /// Sums over the contacts of the round: the energy of their approach, and the energy gain.
    pub dissipated: Real,
    pub energy_gain: Real,
}

impl ImpactIsland {
    /// The fraction of a round that keeps the energy at or below its initial value.
    pub fn fraction(&self) -> Real {
        let fraction = self.dissipated / (self.dissipated - self.energy_gain);
        let fraction = match self.energy_gain > 0.0 {
            true if self.dissipated < 0.0 => fraction.max(0.0),
            true => 0.0,
            false => 1.0,
        };
        debug_assert!((0.0..=1.0).contains(&fraction));
        fraction
    }
}
