//! Deterministic random numbers: equal on every run and every machine.

use crate::rapier::prelude::Real;

/// Random number generator (PCG: O'Neill 2014, the 32-bit output of a 64-bit state).
#[derive(Clone, Debug)]
pub struct Dice {
    state: u64,
}

impl Dice {
    /// Creates a generator. Different seeds give different sequences.
    pub fn new(seed: u64) -> Self {
        let mut dice = Self { state: seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) };
        dice.roll();
        dice
    }

    fn roll(&mut self) -> u32 {
        let old = self.state;
        self.state =
            old.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (((old >> 18) ^ old) >> 27) as u32;
        mixed.rotate_right((old >> 59) as u32)
    }

    /// Returns a number from `low` to `high`.
    pub fn between(&mut self, low: Real, high: Real) -> Real {
        let unit = (self.roll() >> 8) as Real / (1 << 24) as Real;
        low + (high - low) * unit
    }

    /// Returns a whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        ((u64::from(self.roll()) * end as u64) >> 32) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::Dice;

    #[test]
    fn rolls_stay_in_range_and_differ() {
        let mut dice = Dice::new(1);
        let mut counts = [0; 6];
        for _ in 0..6000 {
            counts[dice.below(6)] += 1;
            assert!((-2.0..=3.0).contains(&dice.between(-2.0, 3.0)));
        }
        assert!(counts.iter().all(|&count| (900..1100).contains(&count)), "{counts:?}");
        assert_ne!(Dice::new(1).below(1 << 30), Dice::new(2).below(1 << 30));
    }
}
