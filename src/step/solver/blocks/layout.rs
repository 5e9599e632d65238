//! Layout of constraints in blocks: whole lanes of a colour, and single or independent constraints of the
//! overflow.

use super::overflow::OverflowOrder;
use crate::base::wide::LANES;
use crate::model::constraint_graph::OVERFLOW;
use core::ops::Range;

/// Largest capacity of a colour beyond four times its used blocks.
const SPARE_BLOCKS_MAX: usize = 2;

/// The constraints (as `T` names them) of all blocks.
pub(in crate::step::solver) struct Layout<T> {
    /// Constraints block by block, and the start of each block in that list.
    members: Vec<T>,
    starts: Vec<usize>,
    /// The blocks of each colour in solving order; each block of the overflow is a colour of its own.
    colors: Vec<Range<usize>>,
}

impl<T> Default for Layout<T> {
    fn default() -> Self {
        Self { members: Vec::new(), starts: Vec::new(), colors: Vec::new() }
    }
}

impl<T: Copy> Layout<T> {
    /// Adds blocks for constraints without a colour, each between bodies in two slots, in this order.
    pub fn add_side_by_side(
        &mut self,
        members: impl IntoIterator<Item = (T, [u32; 2])>,
        order: &mut OverflowOrder,
    ) {
        let (first, start) = (self.starts.len(), self.members.len());
        order.clear();
        self.members.extend(members.into_iter().map(|(member, slots)| {
            order.push(slots);
            member
        }));
        let mut next = start;
        self.starts.extend(order.sizes().iter().map(|size| {
            let begin = next;
            next += size;
            begin
        }));
        let in_order = self.members[start..].to_vec();
        let mut free = self.starts[first..].to_vec();
        for (member, &block) in in_order.into_iter().zip(order.blocks()) {
            let place = &mut free[block as usize];
            self.members[*place] = member;
            *place += 1;
        }
        self.colors.extend((first..self.starts.len()).map(|block| block..block + 1));
        debug_assert_eq!(next, self.members.len(), "each constraint has a lane");
    }
}

impl<T> Layout<T> {
    pub fn clear(&mut self) {
        self.members.clear();
        self.starts.clear();
        self.colors.clear();
    }

    /// Adds blocks for the constraints of the next colour.
    pub fn add(&mut self, color: u32, members: impl IntoIterator<Item = T>) {
        let (first, start) = (self.starts.len(), self.members.len());
        self.members.extend(members);
        let size = if color == OVERFLOW { 1 } else { LANES };
        self.starts.extend((start..self.members.len()).step_by(size));
        let blocks = first..self.starts.len();
        if color == OVERFLOW {
            self.colors.extend(blocks.map(|block| block..block + 1));
        } else if !blocks.is_empty() {
            self.colors.push(blocks);
        }
    }

    /// Adds empty blocks to the last added colour up to its count of earlier steps, so that the next colours
    /// keep their positions.
    ///
    /// Its blocks begin with the `first`. A colour that needs more than its `capacity` gets an eighth more
    /// than it needs, so the capacity seldom changes.
    pub fn reserve_capacity(&mut self, first: usize, capacity: &mut usize) {
        let used = self.starts.len() - first;
        if used > *capacity || 4 * used + SPARE_BLOCKS_MAX < *capacity {
            *capacity = used + used / 8;
        }
        debug_assert!(used <= *capacity, "the reserve takes no block away");
        self.starts.resize(first + *capacity, self.members.len());
    }

    /// Number of constraints.
    pub fn len(&self) -> usize {
        self.members.len()
    }

    /// Number of blocks.
    pub fn block_count(&self) -> usize {
        self.starts.len()
    }

    /// The constraints of one block, a lane for each.
    pub fn block(&self, index: usize) -> &[T] {
        let end = self.starts.get(index + 1).copied().unwrap_or(self.members.len());
        &self.members[self.starts[index]..end]
    }

    /// The same; none if there is no such block.
    pub fn block_or_none(&self, index: usize) -> &[T] {
        if index < self.block_count() { self.block(index) } else { &[] }
    }

    /// All constraints in the order of the blocks.
    pub fn iter(&self) -> core::slice::Iter<'_, T> {
        self.members.iter()
    }

    /// The constraints of each block.
    pub fn blocks(&self) -> impl Iterator<Item = &[T]> {
        (0..self.block_count()).map(|index| self.block(index))
    }

    /// The blocks of each colour in solving order.
    pub fn colors(&self) -> &[Range<usize>] {
        &self.colors
    }
}
