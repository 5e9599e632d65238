//! Budgets of an island in the rounds of an impact: iterations and energy.

use crate::dim::math::Real;

/// Iterations over all contacts that hit, per substep, in an island with a contact of restitution 1.
const ITERATIONS_MAX: usize = 128;
/// Islands with at most this number of contacts get all iterations for any restitution.
const SMALL_ISLAND: usize = 32;

/// The iterations of an island follow from the number of its contacts with restitution, and from their
/// largest restitution.
#[derive(Copy, Clone, Default)]
pub(super) struct IterationBudget {
    pub contacts: usize,
    pub restitution: Real,
}

impl IterationBudget {
    pub fn iterations(&self) -> usize {
        let smallness = SMALL_ISLAND as Real / self.contacts as Real;
        let worth = self.restitution.max(smallness).min(1.0);
        (ITERATIONS_MAX as Real * worth).ceil() as usize
    }
}

/// Progress of an island. Islands are independent: their results have the same bits with any others beside
/// them.
#[derive(Copy, Clone, Default)]
pub(super) struct EnergyBudget {
    /// Remaining iterations of this substep.
    pub iterations: usize,
    pub is_active: bool,
    pub is_moving: bool,
    /// Sums over the contacts, see `ActiveBlock`.
    pub dissipated: Real,
    pub energy_gain: Real,
}

impl EnergyBudget {
    /// The fraction of a round of an island: at most up to the initial energy.
    pub fn fraction(&self) -> Real {
        let fraction = self.dissipated / (self.dissipated - self.energy_gain);
        match self.energy_gain > 0.0 {
            true if self.dissipated < 0.0 => fraction.max(0.0),
            true => 0.0,
            false => 1.0,
        }
    }
}
