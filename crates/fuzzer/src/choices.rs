//! Decisions read from a string of bytes.
//!
//! A decision takes as few bytes as possible, so that a change of one byte changes one decision. After the
//! last byte, every further choice is the first one.

/// String of bytes, read from its beginning.
pub struct Choices<'a> {
    rest: &'a [u8],
    /// Whether operations are printed.
    is_verbose: bool,
}

impl<'a> Choices<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, is_verbose: std::env::var_os("FUZZ_VERBOSE").is_some() }
    }

    /// Prints a description of an operation if `FUZZ_VERBOSE` is set, for the analysis of a finding.
    pub fn print(&self, what: impl FnOnce() -> String) {
        if self.is_verbose {
            eprintln!("{}", what());
        }
    }

    /// Returns whether all bytes are used up.
    pub fn is_over(&self) -> bool {
        self.rest.is_empty()
    }

    fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.rest.split_first() else { return 0 };
        self.rest = rest;
        first
    }

    /// Returns a number from 0 to `count - 1`, with `count` at most 256.
    pub fn below(&mut self, count: usize) -> usize {
        debug_assert!((1..=256).contains(&count), "one of {count}");
        usize::from(self.byte()) % count
    }

    /// Returns whether the next byte modulo `times` is `times - 1`. A zero byte gives false, so rare
    /// operations end with the bytes.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == times - 1
    }

    /// Returns whether the next byte is odd.
    pub fn coin(&mut self) -> bool {
        self.once_in(2)
    }

    /// Returns a number from `low` to `high`.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        let number = u16::from_le_bytes([self.byte(), self.byte()]);
        low + (high - low) * f64::from(number) / f64::from(u16::MAX)
    }

    /// Returns one of several values.
    pub fn pick<T: Clone>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())].clone()
    }
}

/// Returns this many pseudorandom bytes. Equal seeds give equal bytes.
///
/// The generator is Marsaglia's 64-bit xorshift ("Xorshift RNGs", 2003) with a multiplication at the end.
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
