//! A node: the boxes of its children, a child per lane.

use super::measure;
use crate::base::wide::{LANES, Lane};
use parry::bounding_volume::Aabb;
use parry::math::{DIM, Real, Vector};

/// Lower bounds of all children per axis, then upper bounds per axis.
pub type Planes = [Lane; 2 * DIM];

/// The child of a lane: another node, or the slot of a box.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Child(u32);

/// The child, to be matched.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Target {
    Node(usize),
    Slot(u32),
}

impl Child {
    const LEAF: u32 = 1 << 31;
    /// Marks an empty lane; it is never read.
    pub const NONE: Self = Self(u32::MAX);

    pub fn of_slot(slot: u32) -> Self {
        debug_assert!(slot < Self::LEAF, "more colliders than memory holds");
        Self(slot | Self::LEAF)
    }

    pub fn of_node(node: usize) -> Self {
        Self(node as u32)
    }

    #[inline(always)]
    pub fn target(self) -> Target {
        if self.0 & Self::LEAF == 0 {
            Target::Node(self.0 as usize)
        } else {
            Target::Slot(self.0 & !Self::LEAF)
        }
    }
}

/// A lane of a node.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Place(u32);

impl Place {
    pub fn new(node: usize, lane: usize) -> Self {
        Self((node * LANES + lane) as u32)
    }

    pub fn node(self) -> usize {
        self.0 as usize / LANES
    }

    pub fn lane(self) -> usize {
        self.0 as usize % LANES
    }
}

/// A child and its box.
#[derive(Copy, Clone, Debug)]
pub struct Entry {
    pub aabb: Aabb,
    pub child: Child,
}

/// Up to [`LANES`] children and their boxes. Children are in the first lanes.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Node {
    pub planes: Planes,
    pub children: [Child; LANES],
    /// The parent and lane of the node; `None` for the root.
    pub parent: Option<Place>,
    pub count: u32,
}

impl Node {
    pub fn empty() -> Self {
        let planes = [Lane::ZERO; 2 * DIM];
        let mut node = Self { planes, children: [Child::NONE; LANES], parent: None, count: 0 };
        node.set_len(0);
        node
    }

    /// One bit for each child.
    #[inline(always)]
    pub fn taken(&self) -> u32 {
        (1 << self.count) - 1
    }

    pub fn len(&self) -> usize {
        self.count as usize
    }

    pub fn lane_box(&self, lane: usize) -> Aabb {
        let (mut mins, mut maxs) = (Vector::ZERO, Vector::ZERO);
        for axis in 0..DIM {
            mins[axis] = self.planes[axis].0[lane];
            maxs[axis] = self.planes[DIM + axis].0[lane];
        }
        Aabb::new(mins, maxs)
    }

    pub fn set_box(&mut self, lane: usize, aabb: &Aabb) {
        for axis in 0..DIM {
            self.planes[axis].0[lane] = aabb.mins[axis];
            self.planes[DIM + axis].0[lane] = aabb.maxs[axis];
        }
    }

    pub fn entry(&self, lane: usize) -> Entry {
        Entry { aabb: self.lane_box(lane), child: self.children[lane] }
    }

    pub fn set_entry(&mut self, lane: usize, entry: &Entry) {
        self.set_box(lane, &entry.aabb);
        self.children[lane] = entry.child;
    }

    /// Sets the number of children. The bounds of other lanes do not contribute to the bounds of the node.
    pub fn set_len(&mut self, len: usize) {
        self.count = len as u32;
        for lane in len..LANES {
            self.set_box(lane, &Aabb::new_invalid());
        }
    }

    /// The box around all children.
    pub fn around(&self) -> Aabb {
        let (mut mins, mut maxs) = (Vector::ZERO, Vector::ZERO);
        for axis in 0..DIM {
            mins[axis] = extreme(&self.planes[axis], |a, b| if a < b { a } else { b });
            maxs[axis] = extreme(&self.planes[DIM + axis], |a, b| if a > b { a } else { b });
        }
        Aabb::new(mins, maxs)
    }

    /// The [measures](measure) of all children, together.
    pub fn measure_of_children(&self) -> Real {
        (0..self.len()).map(|lane| measure(&self.lane_box(lane))).sum()
    }
}

/// The least or greatest number of a lane, by `of`. Halves are compared with halves, side by side, which
/// is a few instructions.
#[inline(always)]
fn extreme(lane: &Lane, of: impl Fn(Real, Real) -> Real) -> Real {
    let mut left = lane.0;
    let mut count = LANES;
    while count > 1 {
        count /= 2;
        for index in 0..count {
            left[index] = of(left[index], left[index + count]);
        }
    }
    left[0]
}
