//! The order in which constraints without a colour are solved: one after the other, but side by side where
//! that is the same.
//!
//! Constraints without a common body are independent, so any number of them may fill the lanes of one block.
//! Each goes into the first block with a free lane behind all that hold one of its bodies. The constraints of
//! one body keep their order, and every number equals that of a sequential solution, bit for bit. Where
//! thousands of bodies overlap, this takes an eighth of the memory of one block per constraint.

use crate::base::wide::LANES;
use crate::model::island::NONE;

/// Puts constraints into blocks. Reused from step to step.
#[derive(Default)]
pub(in crate::step::solver) struct OverflowOrder {
    /// By body slot: the first block behind all that hold one of its constraints.
    behind: Vec<u32>,
    /// By block: itself while it has a free lane, else one that is nearer to the next that has.
    open: Vec<u32>,
    /// By block: constraints in it.
    filled: Vec<usize>,
    /// By constraint: its block.
    block_of: Vec<u32>,
}

impl OverflowOrder {
    /// Starts with nothing.
    pub fn clear(&mut self) {
        self.behind.clear();
        self.open.clear();
        self.filled.clear();
        self.block_of.clear();
    }

    /// Adds the next constraint, between bodies in these slots ([`NONE`]: no body).
    pub fn push(&mut self, slots: [u32; 2]) {
        let slots = slots.into_iter().filter(|&slot| slot != NONE);
        let behind = |slot: u32| self.behind.get(slot as usize).copied().unwrap_or(0);
        let earliest = slots.clone().map(behind).max().unwrap_or(0);
        let block = self.first_open(earliest);
        debug_assert!(block >= earliest && self.filled[block as usize] < LANES);
        self.filled[block as usize] += 1;
        if self.filled[block as usize] == LANES {
            self.open[block as usize] = block + 1;
        }
        for slot in slots {
            let slot = slot as usize;
            if slot >= self.behind.len() {
                self.behind.resize(slot + 1, 0);
            }
            self.behind[slot] = block + 1;
        }
        self.block_of.push(block);
    }

    /// The first block with a free lane from this one on.
    fn first_open(&mut self, from: u32) -> u32 {
        let mut block = from;
        loop {
            if block as usize == self.open.len() {
                self.open.push(block);
                self.filled.push(0);
                return block;
            }
            let next = self.open[block as usize];
            if next == block {
                return block;
            }
            // Paths are halved, so that full blocks are not traversed repeatedly.
            let after = self.open.get(next as usize).copied().unwrap_or(next);
            self.open[block as usize] = after;
            block = after;
        }
    }

    /// The number of constraints in each block.
    pub fn sizes(&self) -> &[usize] {
        &self.filled
    }

    /// The block of each constraint, in the order of insertion.
    pub fn blocks(&self) -> &[u32] {
        &self.block_of
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;

    #[test]
    fn constraints_of_a_body_keep_their_order_and_share_no_block() {
        let mut random = Random(3);
        let pairs: Vec<[u32; 2]> = (0..3000)
            .map(|_| {
                let body = random.below(60) as u32;
                [body, (body + 1 + random.below(59) as u32) % 60]
            })
            .collect();
        let mut order = OverflowOrder::default();
        for round in 0..2 {
            order.clear();
            pairs.iter().for_each(|&pair| order.push(pair));
            let blocks = order.blocks();
            for body in 0..60 {
                let of_body = || (0..pairs.len()).filter(|&k| pairs[k].contains(&body));
                let mut follow = of_body().zip(of_body().skip(1));
                assert!(follow.all(|(a, b)| blocks[a] < blocks[b]), "{body} in round {round}");
            }
            for (block, &size) in order.sizes().iter().enumerate() {
                let members = blocks.iter().filter(|&&of| of as usize == block).count();
                assert!(members == size && (1..=LANES).contains(&size), "{size} in block {block}");
            }
            // No body has more than a hundred constraints or so: the blocks must be nearly full.
            assert!(
                order.sizes().len() * LANES < 2 * pairs.len(),
                "{} blocks",
                order.sizes().len()
            );
        }
    }

    #[test]
    fn constraints_of_one_body_stand_alone() {
        let mut order = OverflowOrder::default();
        (1..100).for_each(|other| order.push([0, other]));
        assert_eq!(order.blocks(), (0..99).collect::<Vec<_>>());
    }
}
