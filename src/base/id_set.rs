//! A set of small numbers that is walked in their order.
//!
//! One bit per number, and one bit per non-zero word above it. Iteration visits the members, and otherwise a
//! few bits per 512 numbers. The alternative, a list with swap-removal, has another order after each change,
//! and its memory access is random.

use super::in_place::clone_in_place;
use core::ops::Range;

const BITS: u32 = u64::BITS;
/// Words on a page. Divides the bits of a word.
const PAGE: usize = 8;

/// A set of `u32`s. It occupies an eighth of a byte for each number up to its largest member so far.
///
/// Saved as its words alone: which of them are filled follows from them.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(from = "Vec<u64>", into = "Vec<u64>"))]
pub struct IdSet {
    words: Vec<u64>,
    /// One bit per word, set if the word is not zero.
    filled: Vec<u64>,
}

clone_in_place!(IdSet { words, filled });

impl From<Vec<u64>> for IdSet {
    fn from(words: Vec<u64>) -> Self {
        let mut filled = vec![0; words.len().div_ceil(BITS as usize)];
        for (index, _) in words.iter().enumerate().filter(|(_, word)| **word != 0) {
            let (above, bit) = place(index as u32);
            filled[above] |= bit;
        }
        Self { words, filled }
    }
}

impl From<IdSet> for Vec<u64> {
    fn from(set: IdSet) -> Self {
        set.words
    }
}

fn place(number: u32) -> (usize, u64) {
    ((number / BITS) as usize, 1 << (number % BITS))
}

/// The bits that are set, lowest first.
fn ones(mut word: u64) -> impl Iterator<Item = u32> {
    core::iter::from_fn(move || {
        let lowest = (word != 0).then(|| word.trailing_zeros());
        word &= word.wrapping_sub(1);
        lowest
    })
}

impl IdSet {
    /// Returns whether the set contains the number.
    pub fn contains(&self, number: u32) -> bool {
        let (word, bit) = place(number);
        self.words.get(word).is_some_and(|word| word & bit != 0)
    }

    /// Puts a number in. Returns whether it was not there.
    pub fn insert(&mut self, number: u32) -> bool {
        let (index, bit) = place(number);
        let is_new = !self.contains(number);
        self.fill(index, bit);
        is_new
    }

    /// Inserts numbers, faster for contiguous ones.
    pub fn extend(&mut self, numbers: impl Iterator<Item = u32>) {
        let (mut last, mut bits) = (0, 0);
        for number in numbers {
            let (index, bit) = place(number);
            if index != last {
                self.fill(last, bits);
                (last, bits) = (index, 0);
            }
            bits |= bit;
        }
        self.fill(last, bits);
    }

    /// Sets the summary bits of these bits of a word.
    fn fill(&mut self, index: usize, bits: u64) {
        if bits == 0 {
            return;
        }
        if index >= self.words.len() {
            self.words.resize(index + 1, 0);
            self.filled.resize(index / BITS as usize + 1, 0);
        }
        self.words[index] |= bits;
        let (above, bit) = place(index as u32);
        self.filled[above] |= bit;
    }

    /// Takes a number out. Returns whether it was there.
    pub fn remove(&mut self, number: u32) -> bool {
        let (index, bit) = place(number);
        let Some(word) = self.words.get_mut(index) else { return false };
        let was_there = *word & bit != 0;
        *word &= !bit;
        if *word == 0 {
            let (above, bit) = place(index as u32);
            self.filled[above] &= !bit;
        }
        was_there
    }

    /// Takes all numbers out.
    pub fn clear(&mut self) {
        let filled = self.filled.iter().enumerate();
        for index in
            filled.flat_map(|(above, &word)| ones(word).map(move |bit| above as u32 * BITS + bit))
        {
            self.words[index as usize] = 0;
        }
        self.filled.fill(0);
    }

    /// The numbers, smallest first.
    pub fn iter(&self) -> impl Iterator<Item = u32> {
        self.iter_in(0..self.page_count())
    }

    /// Returns whether the set never contained a number of `bound` or above: it has words for smaller numbers
    /// only. A loaded set with more than 2²⁶ words would yield numbers modulo 2³².
    pub fn is_below(&self, bound: usize) -> bool {
        self.words.len() <= bound.div_ceil(BITS as usize)
    }

    /// Numbers stand on pages of 512, in their order.
    pub fn page_count(&self) -> usize {
        self.words.len().div_ceil(PAGE)
    }

    /// The numbers on some pages, smallest first.
    pub fn iter_in(&self, pages: Range<usize>) -> impl Iterator<Item = u32> {
        let words = |page: usize| {
            let first = page * PAGE;
            let filled = self.filled[first / BITS as usize] >> (first % BITS as usize);
            ones(filled & ((1 << PAGE) - 1)).map(move |bit| first as u32 + bit)
        };
        let filled = pages.flat_map(words);
        filled.flat_map(|index| ones(self.words[index as usize]).map(move |bit| index * BITS + bit))
    }
}

#[cfg(test)]
mod tests {
    use super::IdSet;
    use crate::base::random::Random;
    use std::collections::BTreeSet;

    /// It has the elements of a set of the standard library after the same changes, and is iterated in the
    /// same order.
    #[test]
    fn it_is_a_set() {
        let mut random = Random(53);
        let (mut set, mut expected) = (IdSet::default(), BTreeSet::new());
        for turn in 0..20_000 {
            // Now dense, now thinly spread over many words.
            let number = random.below(if turn % 2 == 0 { 300 } else { 100_000 }) as u32;
            if random.below(3) > 0 {
                assert_eq!(set.insert(number), expected.insert(number));
            } else {
                assert_eq!(set.remove(number), expected.remove(&number));
            }
            assert_eq!(set.contains(number), expected.contains(&number));
        }
        let several = [7, 5, 64, 65, 66, 200_000, 3];
        set.extend(several.into_iter());
        expected.extend(several);
        assert!(set.iter().eq(expected.iter().copied()));
        assert!(!set.contains(u32::MAX) && !set.remove(u32::MAX));
        assert!(set.is_below(200_001) && !set.is_below(199_936));
        let loaded = IdSet::from(Vec::from(set.clone()));
        assert_eq!((&loaded.words, &loaded.filled), (&set.words, &set.filled));
        let mut cleared = set.clone();
        cleared.clear();
        expected.into_iter().for_each(|number| assert!(set.remove(number)));
        assert_eq!(set.iter().next(), None);
        assert_eq!((cleared.words, cleared.filled), (set.words, set.filled));
    }
}
