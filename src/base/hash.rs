//! A hash map for keys of a few machine words, equal on every machine and run.
//!
//! The standard map's SipHash resists hostile keys at five times the cost, and its random seed would make the
//! (unused) iteration order differ between runs. The keys are slot numbers that the engine assigns.

use core::hash::{BuildHasherDefault, Hasher};
use std::collections::HashMap;

/// A map whose hash depends on the keys alone. It is never iterated; order comes from elsewhere.
pub(crate) type FastHashMap<K, V> = HashMap<K, V, BuildHasherDefault<MixHasher>>;

/// Folds each word in by a 64 × 64 → 128-bit multiplication (the mixing step of wyhash).
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct MixHasher(u64);

impl MixHasher {
    #[inline]
    fn mix(&mut self, word: u64) {
        let product = u128::from(self.0 ^ word ^ 0x9e37_79b9_7f4a_7c15) * 0xa076_1d64_78bd_642f;
        self.0 = (product as u64) ^ ((product >> 64) as u64);
    }
}

impl Hasher for MixHasher {
    #[inline]
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.mix(u64::from_le_bytes(word));
        }
    }

    #[inline]
    fn write_u32(&mut self, word: u32) {
        self.mix(u64::from(word));
    }

    #[inline]
    fn write_u64(&mut self, word: u64) {
        self.mix(word);
    }
}
