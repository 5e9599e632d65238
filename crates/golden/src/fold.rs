//! The hash of a run: words folded one after the other.

/// FNV-1a over words of 64 bits. The high half is folded back, because the multiplication alone never changes
/// lower bits by higher ones.
#[derive(Copy, Clone, Debug)]
pub struct Fold(u64);

impl Default for Fold {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fold {
    /// Folds a word in.
    pub fn word(&mut self, word: u64) {
        let product = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01b3);
        self.0 = product ^ (product >> 32);
    }

    /// Folds in the bits of a number. A double keeps all bits of a single.
    pub fn number(&mut self, number: f64) {
        self.word(number.to_bits());
    }

    /// The hash so far.
    pub fn value(self) -> u64 {
        self.0
    }
}
