//! The velocities of the degrees of freedom.

use crate::dim::math::Real;
use core::ops::{Deref, DerefMut};

/// Numbers of the degrees of freedom that record whether they were changed. What is computed from them is
/// stale then.
#[derive(Clone, Debug, Default)]
pub struct Rates {
    numbers: Vec<Real>,
    is_changed: bool,
}

impl Rates {
    /// Replaces all numbers.
    pub fn assign(&mut self, numbers: impl Iterator<Item = Real>) {
        self.numbers.clear();
        self.numbers.extend(numbers);
        self.is_changed = true;
    }

    /// What is computed from the numbers is stale for another reason.
    pub fn touch(&mut self) {
        self.is_changed = true;
    }

    /// Returns whether the numbers have changed since the last call.
    pub fn take_change(&mut self) -> bool {
        core::mem::take(&mut self.is_changed)
    }
}

impl Deref for Rates {
    type Target = [Real];

    fn deref(&self) -> &[Real] {
        &self.numbers
    }
}

impl DerefMut for Rates {
    fn deref_mut(&mut self) -> &mut [Real] {
        self.is_changed = true;
        &mut self.numbers
    }
}
