//! Decisions read from a string of bytes.
//!
//! Each takes as few bytes as it can, so that a fuzzer that changes one byte changes one decision. When the bytes
//! are used up, every further choice is the first one.

/// A string of bytes, read from its beginning.
pub struct Choices<'a> {
    rest: &'a [u8],
    /// Is everything printed that is done?
    is_loud: bool,
}

impl<'a> Choices<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, is_loud: std::env::var_os("FUZZ_TELL").is_some() }
    }

    /// Prints what is done, if `FUZZ_TELL` is set: how a finding is understood.
    pub fn tell(&self, what: impl FnOnce() -> String) {
        if self.is_loud {
            eprintln!("{}", what());
        }
    }

    /// Are all bytes used up?
    pub fn is_over(&self) -> bool {
        self.rest.is_empty()
    }

    fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.rest.split_first() else { return 0 };
        self.rest = rest;
        first
    }

    /// A number from 0 to `count - 1`, of at most 256.
    pub fn below(&mut self, count: usize) -> usize {
        debug_assert!((1..=256).contains(&count), "one of {count}");
        usize::from(self.byte()) % count
    }

    /// True for one in `times` bytes; not for zero, so that nothing rare happens once the bytes are used up.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == times - 1
    }

    /// Heads or tails.
    pub fn coin(&mut self) -> bool {
        self.once_in(2)
    }

    /// A number from `low` to `high`.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        let number = u16::from_le_bytes([self.byte(), self.byte()]);
        low + (high - low) * f64::from(number) / f64::from(u16::MAX)
    }

    /// One of several.
    pub fn pick<T: Clone>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())].clone()
    }
}

/// This many random bytes; the same ones for the same seed.
///
/// Marsaglia's xorshift of 64 bits ("Xorshift RNGs", 2003), multiplied at the end.
pub fn random_bytes(seed: u64, count: usize) -> Vec<u8> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut next = || {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        (state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 56) as u8
    };
    (0..count).map(|_| next()).collect()
}

#[cfg(test)]
mod tests {
    use super::{Choices, random_bytes};

    #[test]
    fn a_byte_is_a_decision() {
        let mut choices = Choices::new(&[3, 5, 0xff, 0xff, 1]);
        assert_eq!(choices.below(10), 3);
        assert_eq!(choices.pick(&["a", "b", "c"]), "c");
        assert_eq!(choices.within(-1.0, 2.0), 2.0);
        assert!(choices.coin() && choices.is_over());
        assert!(!choices.coin() && choices.below(7) == 0);
    }

    #[test]
    fn seeds_differ_and_repeat() {
        assert_eq!(random_bytes(1, 99), random_bytes(1, 99));
        assert_ne!(random_bytes(1, 99), random_bytes(2, 99));
    }
}
