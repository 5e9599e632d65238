//! # BVH: a tree of boxes with one child per lane
//!
//! A dynamic set of numbered boxes, queried by ray, point and box. A node contains the boxes of its children
//! plane by plane, a child per lane. A few instructions therefore test all of them (Wald, Benthin, Boulos,
//! "Getting Rid of Packets", 2008). Children are nodes or leaves, in any mixture: a large box among many
//! small ones is near the root.
//!
//! | file | content |
//! |---|---|
//! | `node.rs` | a node |
//! | `insert.rs` | insertion, removal and update of one box: the tree grows at its root, as a B-tree does |
//! | `build.rs` | the whole tree at once, from the surface area heuristic |
//! | `probe.rs` | tests of all boxes of a node |
//! | `nearest.rs` | the search for the nearest, near children first |
//! | `leaves.rs` | all leaves that a probe finds |
//! | `check.rs` | invariants |
//!
//! The shape of the tree follows from the history of calls, and from nothing else. The set of results does
//! not depend on it; the order may.

mod build;
mod check;
mod insert;
mod leaves;
mod nearest;
mod node;
mod probe;
mod stack;
#[cfg(test)]
mod tests;

pub use build::BuildScratch;
pub use nearest::nearest;
pub use probe::{BoxProbe, PointProbe, Probe, SlabProbe};

use crate::base::in_place::clone_in_place;
use crate::base::wide::prefetch;
use core::ops::{Add, Mul};
use node::{Node, Place};
use parry::bounding_volume::Aabb;
use parry::math::{DIM, Real};

/// Numbered boxes, in a tree.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
pub struct BoxTree {
    /// The root comes first. `free` contains the unused nodes.
    nodes: Vec<Node>,
    free: Vec<u32>,
    /// The place of each slot's box.
    places: Vec<Option<Place>>,
    len: usize,
    /// Number of boxes that were inserted or moved, or whose ancestors grew, since the tree was built as a
    /// whole.
    wear: usize,
}

clone_in_place!(BoxTree { nodes, free, places, len, wear });

impl BoxTree {
    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Returns whether the tree is empty.
    #[cfg(test)]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Takes all boxes out.
    pub fn clear(&mut self) {
        self.nodes.clear();
        self.free.clear();
        self.places.clear();
        (self.len, self.wear) = (0, 0);
    }

    /// The number of insertions, moves and growths since the last complete build.
    pub fn wear(&self) -> usize {
        self.wear
    }

    /// The box of a slot.
    pub fn get(&self, slot: u32) -> Option<Aabb> {
        let place = self.place(slot)?;
        Some(self.nodes[place.node()].lane_box(place.lane()))
    }

    /// Prefetches the node with the box of a slot.
    pub fn prefetch(&self, slot: u32) {
        if let Some(node) = self.place(slot).and_then(|place| self.nodes.get(place.node())) {
            prefetch(node);
        }
    }

    fn place(&self, slot: u32) -> Option<Place> {
        self.places.get(slot as usize).copied().flatten()
    }
}

/// Measure proportional to the probability that a random line meets a box: half the surface, or half the
/// outline.
fn measure(aabb: &Aabb) -> Real {
    let extents = aabb.extents();
    measure_of(core::array::from_fn(|axis| extents[axis]))
}

/// The same for extents of boxes, one per lane or a single one.
#[inline(always)]
fn measure_of<T: Copy + Add<Output = T> + Mul<Output = T>>(extents: [T; DIM]) -> T {
    let [first, second] = [extents[0], extents[1]];
    if DIM == 2 {
        return first + second;
    }
    let third = extents[DIM - 1];
    first * second + second * third + third * first
}
