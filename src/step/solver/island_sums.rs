//! Sums that do not depend on the order of their terms.
//!
//! A removed constraint or body leaves its place to the last one of its list, wherever that is in the world.
//! The order of an island's terms therefore depends on other islands, and a floating-point sum depends on
//! the order of its terms. An [`UnorderedSum`] rounds each term to a multiple of a fraction of the largest
//! one, and sums of integers are exact. Alternative: sorted terms, which cost more than the terms of a ledger
//! of energy.

use crate::dim::math::Real;

/// A unit of sums as a fraction of the largest term: 2²² terms fit into a sum.
const UNIT: f64 = 1.0 / (1_u64 << 40) as f64;

/// A sum of terms that are visited twice: first to find the largest term.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct UnorderedSum {
    largest: f64,
    /// The sum in units of [`UNIT`] of the largest term.
    units: i64,
}

impl UnorderedSum {
    /// Includes a term that will be added.
    pub fn include(&mut self, term: f64) {
        self.largest = self.largest.max(term.abs());
    }

    /// Adds a term that is included.
    pub fn add(&mut self, term: f64) {
        let unit = self.unit();
        debug_assert!(term.is_nan() || term.abs() <= self.largest, "only included terms are added");
        // The unit of numbers close to the smallest one is zero, and that of infinities is infinite.
        if unit.is_normal() {
            self.units += (term / unit).round() as i64;
        }
    }

    /// The sum of all terms that were added.
    pub fn value(self) -> f64 {
        self.units as f64 * self.unit()
    }

    fn unit(self) -> f64 {
        self.largest * UNIT
    }
}

/// Collects the terms of `N` sums for each island, and adds them up.
#[derive(Default)]
pub(super) struct IslandSums<const N: usize> {
    terms: Vec<(u32, [Real; N])>,
}

impl<const N: usize> IslandSums<N> {
    /// Removes all terms.
    pub fn clear(&mut self) {
        self.terms.clear();
    }

    /// Adds one term to each sum of an island.
    pub fn push(&mut self, island: u32, terms: [Real; N]) {
        if terms.iter().any(|&term| term != 0.0) {
            self.terms.push((island, terms));
        }
    }

    /// Calls `read` with the sums of each island.
    pub fn for_each(&mut self, mut read: impl FnMut(u32, [Real; N])) {
        self.terms.sort_unstable_by_key(|&(island, _)| island);
        for terms in self.terms.chunk_by(|one, two| one.0 == two.0) {
            let mut sums = [UnorderedSum::default(); N];
            for visit in [UnorderedSum::include as fn(&mut _, _), UnorderedSum::add] {
                for (_, terms) in terms {
                    sums.iter_mut().zip(terms).for_each(|(sum, term)| visit(sum, f64::from(*term)));
                }
            }
            read(terms[0].0, sums.map(|sum| sum.value() as Real));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;

    #[test]
    fn sums_of_extreme_terms_do_not_overflow() {
        let sum = |terms: &[f64]| {
            let mut sum = UnorderedSum::default();
            terms.iter().for_each(|&term| sum.include(term));
            terms.iter().for_each(|&term| sum.add(term));
            sum.value()
        };
        assert_eq!(sum(&[5e-324; 3]), 0.0);
        assert_eq!(sum(&[1e-290; 3]), 3.0 * 1e-290);
        assert_eq!(sum(&[1e300, -1e300, 1e300]), 1e300);
        assert!(!sum(&[f64::INFINITY, f64::INFINITY]).is_finite());
        assert!(sum(&[f64::NAN, 1.0]).is_finite());
    }

    /// Terms of very different sizes, whose sum depends on their order.
    #[test]
    fn sums_do_not_depend_on_the_order_of_arrival() {
        let mut random = Random(7);
        let size = |k: u32| (10.0 as Real).powi((k % 17) as i32);
        let mut terms: Vec<_> =
            (0..300_u32).map(|k| (k % 3, [random.within(-1.0, 1.0) * size(k), 1.0])).collect();
        let sum = |terms: &[(u32, [Real; 2])]| {
            let (mut sums, mut totals) = (IslandSums::default(), [0.0; 3]);
            terms.iter().for_each(|&(island, values)| sums.push(island, values));
            sums.for_each(|island, [term, _]| totals[island as usize] += term);
            totals.map(Real::to_bits)
        };
        let expected = sum(&terms);
        for turn in [1, 50, 222] {
            terms.rotate_left(turn);
            terms.swap(3, 200);
            assert_eq!(sum(&terms), expected);
        }
    }
}
