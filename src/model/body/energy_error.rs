//! The energy that the solver's errors have added to an island.

use crate::dim::math::Real;

/// An island's kinetic energy by errors of the solver. Each of its bodies stores it, because islands merge
/// and split. See `step/solver/ledger/`.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct EnergyError {
    /// The energy (J). It is negative if the errors took energy away.
    pub added: Real,
    /// Whether the last step took back impulses that added energy.
    pub is_exceeded: bool,
}

impl EnergyError {
    /// No error.
    pub const NONE: Self = Self { added: 0.0, is_exceeded: false };
}
