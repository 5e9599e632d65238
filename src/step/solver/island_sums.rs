//! Sums over islands that do not depend on the rest of the world.
//!
//! A removed constraint leaves its place to the last one of its colour, wherever that is in the world. The
//! order of an island's constraints therefore depends on other islands, and a floating-point sum depends on
//! the order of its terms. Sorted terms have the same sum in any order of arrival. The sort costs less than
//! the iteration that finds the terms; a sum in wider numbers would differ less often, not never.

use crate::dim::math::Real;
use core::cmp::Ordering;

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

    /// Calls `add` with the terms of all islands. The order is the same for the same terms.
    pub fn for_each(&mut self, mut add: impl FnMut(u32, [Real; N])) {
        let by_value = |one: &[Real; N], two: &[Real; N]| {
            let pairs = one.iter().zip(two);
            pairs.fold(Ordering::Equal, |order, (one, two)| order.then(one.total_cmp(two)))
        };
        self.terms
            .sort_unstable_by(|one, two| one.0.cmp(&two.0).then_with(|| by_value(&one.1, &two.1)));
        self.terms.iter().for_each(|&(island, terms)| add(island, terms));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;

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
