//! The pieces of a mesh around a body, kept from step to step.
//!
//! A body that slides over a mesh meets nearly the same triangles in each step, but they and their tree are
//! spread over memory. Finding them took longer than all further work on them. They are therefore searched
//! in a box that contains the body for some steps, and stored contiguously. The cache affects no result: it
//! is filtered by the current box, in the order of the tree.

use crate::base::in_place::clone_in_place;
use crate::base::wide::{LANES, prefetch};
use crate::dim::collide::{FlatBlock, FlatShape, flat_lane, set_flat_lane};
use parry::bounding_volume::{Aabb, BoundingVolume};

/// More pieces than this are not worth the memory. A large shape on a fine mesh searches the tree in each
/// step.
const PIECES_MAX: usize = 1024;

/// Flat pieces of a shape, in blocks of as many as a register has lanes.
#[derive(Debug)]
pub(crate) struct TriangleCache {
    /// The box, in the frame of the shape, that none are missing from.
    region: Aabb,
    /// Their numbers, block after block.
    ids: Vec<u32>,
    blocks: Vec<FlatBlock>,
    /// Whether there were too many to keep.
    is_crowded: bool,
}

clone_in_place!(TriangleCache { region, ids, blocks, is_crowded });

impl Default for TriangleCache {
    fn default() -> Self {
        let region = Aabb::new_invalid();
        Self { region, ids: Vec::new(), blocks: Vec::new(), is_crowded: false }
    }
}

impl TriangleCache {
    /// Returns whether the cache contains all pieces that reach into a box.
    pub fn covers(&self, region: &Aabb) -> bool {
        self.region.contains(region)
    }

    /// Number of pieces.
    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// Removes all pieces.
    pub fn clear(&mut self) {
        self.region = Aabb::new_invalid();
        self.ids.clear();
        self.blocks.clear();
    }

    /// Adds a piece.
    #[inline]
    pub fn add(&mut self, id: u32, flat: &FlatShape) {
        let lane = self.ids.len() % LANES;
        if lane == 0 {
            self.blocks.push(FlatBlock::default());
        }
        if let Some(block) = self.blocks.last_mut() {
            set_flat_lane(block, lane, flat);
        }
        self.ids.push(id);
    }

    /// Marks the cache as complete: it contains all pieces that reach into a box.
    pub fn keep(&mut self, region: Aabb) {
        self.region = region;
        self.is_crowded = self.ids.len() > PIECES_MAX;
    }

    /// Returns whether the last search found so many pieces that a larger region does not pay.
    pub fn is_crowded(&self) -> bool {
        self.is_crowded
    }

    /// Gives the memory back if there are too many pieces to keep.
    pub fn shrink(&mut self) {
        if self.is_crowded {
            *self = Self { is_crowded: true, ..Self::default() };
        }
    }

    /// Prefetches the pieces.
    pub fn prefetch(&self) {
        self.blocks.iter().for_each(prefetch);
    }

    pub fn blocks(&self) -> &[FlatBlock] {
        &self.blocks
    }

    /// A bit for each lane of a block that holds a piece.
    pub fn used(&self, block: usize) -> u32 {
        let used = (self.ids.len() - LANES * block).min(LANES);
        (1 << used) - 1
    }

    /// A piece's number and shape.
    pub fn piece(&self, block: usize, lane: usize) -> (u32, FlatShape) {
        (self.ids[LANES * block + lane], flat_lane(&self.blocks[block], lane))
    }
}
