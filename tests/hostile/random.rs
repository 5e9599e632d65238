//! Reproducible random numbers.

use rapier::prelude::*;

/// The generator is Marsaglia's 64-bit xorshift ("Xorshift RNGs", 2003) with a multiplication at the end.
pub struct Dice(u64);

impl Dice {
    /// Creates a generator. Equal seeds give equal sequences.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// Returns 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// Returns a number from 0 to `count - 1`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() >> 33) as usize % count
    }

    /// Returns true once in `times` calls, on average.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    /// Returns a number from `low` to `high`.
    pub fn within(&mut self, low: f64, high: f64) -> Real {
        let unit = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        (low + (high - low) * unit) as Real
    }

    /// Returns one of several values.
    pub fn pick<T: Clone>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())].clone()
    }
}
