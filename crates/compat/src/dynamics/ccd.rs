//! Continuous collision detection.

/// The solver of continuous collision detection. It is stateless: the engine's pipeline owns the work.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct CCDSolver;

impl CCDSolver {
    /// The solver.
    pub fn new() -> Self {
        Self
    }
}
