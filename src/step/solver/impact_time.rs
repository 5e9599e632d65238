//! Times of impacts within a substep: impacts record them, and bodies and joints read them.

use crate::dim::math::Real;
use core::ops::AddAssign;

/// The time of several impacts in a round: two sums, and the mean time is their quotient. Impacts of a body
/// are weighted by their impulses. Those of a multibody count equally.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct ImpactTime {
    /// The sum of impulses, or the number of impacts.
    pub weight: Real,
    /// The sum of weight times time since the beginning of the substep (s).
    pub moment: Real,
}

impl ImpactTime {
    /// One impact.
    pub fn new(weight: Real, time: Real) -> Self {
        debug_assert!(weight >= 0.0 || weight.is_nan(), "weights are impulses of contacts");
        Self { weight, moment: weight * time }
    }

    /// The mean time (s); `None` without an impact.
    pub fn mean(&self) -> Option<Real> {
        (self.weight > 0.0).then(|| self.moment / self.weight)
    }
}

impl AddAssign for ImpactTime {
    fn add_assign(&mut self, other: Self) {
        self.weight += other.weight;
        self.moment += other.moment;
    }
}
