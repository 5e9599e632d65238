//! Elimination order of the joints of loops.
//!
//! The elimination of a joint couples all its neighbours. The next joint is therefore one with the fewest
//! remaining couplings: the order of minimum degree. (Tinney and Walkup, "Direct solutions of sparse network
//! equations by optimally ordered triangular factorization", 1967. George and Liu, "The evolution of the
//! minimum degree ordering algorithm", 1989.) The joints of a limb precede the joints that connect a dozen
//! limbs to their hub. The given order decides between equals, so the result is independent of hashes and
//! addresses.
//!
//! Components are small, so the remaining graph is stored directly, as a sorted list for each joint.

use std::collections::BTreeSet;

/// Buffers of the search for an order.
#[derive(Default)]
pub(super) struct Ordering {
    /// By joint: those that are left and coupled with it, ascending.
    adjacent: Vec<Vec<u32>>,
    /// The number of couplings, and the joint.
    left: BTreeSet<(usize, u32)>,
    merged: Vec<u32>,
    /// The joints in the order of their elimination.
    pub order: Vec<u32>,
}

impl Ordering {
    /// Finds an order for `count` joints with these neighbours (in any order, with repetitions, and
    /// themselves). Returns whether elimination takes at most `work` products of blocks.
    pub fn find(
        &mut self,
        count: usize,
        neighbours: impl Fn(usize, &mut Vec<u32>),
        work: usize,
    ) -> bool {
        self.start(count, neighbours);
        let mut done = 0;
        while let Some((degree, joint)) = self.left.pop_first() {
            done += products(degree);
            if done > work {
                return false;
            }
            self.eliminate(joint);
        }
        true
    }

    fn start(&mut self, count: usize, neighbours: impl Fn(usize, &mut Vec<u32>)) {
        self.order.clear();
        self.left.clear();
        if self.adjacent.len() < count {
            self.adjacent.resize_with(count, Vec::new);
        }
        for (joint, adjacent) in self.adjacent[..count].iter_mut().enumerate() {
            adjacent.clear();
            neighbours(joint, adjacent);
            adjacent.retain(|&other| other as usize != joint);
            adjacent.sort_unstable();
            adjacent.dedup();
            self.left.insert((adjacent.len(), joint as u32));
        }
    }

    /// Couples all neighbours of a joint.
    fn eliminate(&mut self, joint: u32) {
        let column = core::mem::take(&mut self.adjacent[joint as usize]);
        for &other in &column {
            let adjacent = &mut self.adjacent[other as usize];
            self.left.remove(&(adjacent.len(), other));
            merge(adjacent, &column, &mut self.merged);
            self.merged.retain(|&next| next != joint && next != other);
            core::mem::swap(adjacent, &mut self.merged);
            self.left.insert((adjacent.len(), other));
        }
        self.adjacent[joint as usize] = column;
        self.order.push(joint);
    }
}

/// The number of block products to eliminate a joint with this number of couplings.
pub(super) fn products(others: usize) -> usize {
    (others + 1) * (others + 2) / 2
}

/// All numbers of two ascending lists, ascending.
fn merge(first: &[u32], second: &[u32], into: &mut Vec<u32>) {
    into.clear();
    let (mut first, mut second) = (first.iter().peekable(), second.iter().peekable());
    while let (Some(&&a), Some(&&b)) = (first.peek(), second.peek()) {
        into.push(a.min(b));
        first.next_if(|_| a <= b);
        second.next_if(|_| b <= a);
    }
    into.extend(first);
    into.extend(second);
}
