//! The whole tree at once.
//!
//! The build is top-down. The boxes of a node are split in two, then the larger part again. That ends with a
//! part for each lane, or when no split pays. The surface area heuristic over a few bins per axis selects the
//! splits (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).

use super::node::{Child, Entry, Node, Place};
use super::{BoxTree, measure};
use crate::base::wide::LANES;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::math::{DIM, Real};

/// Bins per axis. The gain over 8 is a few percent at best.
const BINS: usize = 16;

/// Buffers that are reused from one tree to the next. Copies of a world exclude them.
#[derive(Debug, Default)]
pub struct BuildScratch {
    leaves: Vec<Entry>,
    /// Nodes without children yet, each with the range of the boxes below it.
    open: Vec<(usize, usize, usize)>,
}

impl Clone for BuildScratch {
    fn clone(&self) -> Self {
        Self::default()
    }

    fn clone_from(&mut self, _: &Self) {}
}

/// A range of boxes in the list, and the box around them.
#[derive(Copy, Clone)]
struct Part {
    start: usize,
    end: usize,
    size: Real,
}

impl Part {
    fn of(leaves: &[Entry], start: usize, end: usize) -> Self {
        Self { start, end, size: measure(&around(&leaves[start..end])) }
    }

    fn len(&self) -> usize {
        self.end - self.start
    }
}

fn around(entries: &[Entry]) -> Aabb {
    let mut around = Aabb::new_invalid();
    entries.iter().for_each(|entry| around.merge(&entry.aabb));
    around
}

impl BoxTree {
    /// Builds the tree as a whole, from the boxes that are in it.
    pub fn rebuild(&mut self, BuildScratch { leaves, open }: &mut BuildScratch) {
        leaves.clear();
        leaves.reserve_exact(self.len);
        for (slot, place) in (0..).zip(&self.places) {
            if let Some(place) = place {
                let aabb = self.nodes[place.node()].lane_box(place.lane());
                leaves.push(Entry { aabb, child: Child::of_slot(slot) });
            }
        }
        self.nodes.clear();
        self.free.clear();
        self.wear = 0;
        self.nodes.push(Node::empty());
        open.push((0, 0, leaves.len()));
        while let Some((node, start, end)) = open.pop() {
            let (parts, count) = parts(leaves, start, end);
            self.nodes[node].count = count as u32;
            for (lane, part) in parts[..count].iter().enumerate() {
                let place = Place::new(node, lane);
                if part.len() == 1 {
                    self.put(place, &leaves[part.start]);
                    continue;
                }
                let below = self.nodes.len();
                self.nodes.push(Node::empty());
                let aabb = around(&leaves[part.start..part.end]);
                self.put(place, &Entry { aabb, child: Child::of_node(below) });
                open.push((below, part.start, part.end));
            }
        }
    }
}

/// Cuts boxes into parts, one for each child of a node. Sorts them by part.
fn parts(leaves: &mut [Entry], start: usize, end: usize) -> ([Part; LANES], usize) {
    let mut parts = [Part::of(leaves, start, end); LANES];
    let mut count = usize::from(end > start);
    // Parts that fit into one node are left for it: a node with few children is tested for little.
    while count < LANES
        && let Some(largest) = largest(&parts[..count])
    {
        let Part { start, end, .. } = parts[largest];
        let middle = start + cut(&mut leaves[start..end]);
        parts[largest] = Part::of(leaves, start, middle);
        parts[count] = Part::of(leaves, middle, end);
        count += 1;
    }
    // Lanes that are left over save whole nodes.
    while let Some(small) = dissoluble(&parts[..count]) {
        let Part { start, end, .. } = parts[small];
        parts[small] = Part::of(leaves, start, start + 1);
        for single in start + 1..end {
            parts[count] = Part::of(leaves, single, single + 1);
            count += 1;
        }
    }
    (parts, count)
}

/// The largest part that does not fit into a node.
fn largest(parts: &[Part]) -> Option<usize> {
    let open = (0..parts.len()).filter(|&index| parts[index].len() > LANES);
    open.max_by(|&a, &b| parts[a].size.total_cmp(&parts[b].size))
}

/// The smallest part whose boxes fit into the lanes that are left, one by one.
fn dissoluble(parts: &[Part]) -> Option<usize> {
    let open = (0..parts.len())
        .filter(|&index| parts[index].len() > 1 && parts.len() - 1 + parts[index].len() <= LANES);
    open.min_by_key(|&index| parts[index].len())
}

/// Sorts the boxes, and returns the index of the first box behind the best cut. At least two boxes.
fn cut(leaves: &mut [Entry]) -> usize {
    let middle = leaves.len() / 2;
    let Some(plane) = best_plane(leaves) else { return middle };
    let mut first = 0;
    for index in 0..leaves.len() {
        if plane.bin(&leaves[index]) < plane.first {
            leaves.swap(first, index);
            first += 1;
        }
    }
    if first == 0 || first == leaves.len() { middle } else { first }
}

/// Bins along an axis, and the plane of the cut.
#[derive(Copy, Clone)]
struct Plane {
    axis: usize,
    /// Twice the coordinate at which the first bin begins, and bins per twice the length.
    origin: Real,
    scale: Real,
    /// The first bin beyond the cut.
    first: usize,
}

impl Plane {
    fn bin(&self, entry: &Entry) -> usize {
        let middle = entry.aabb.mins[self.axis] + entry.aabb.maxs[self.axis];
        (((middle - self.origin) * self.scale) as usize).min(BINS - 1)
    }
}

/// The best cut between bins along any axis; `None` if all boxes have the same middle.
fn best_plane(leaves: &[Entry]) -> Option<Plane> {
    let mut best: Option<(Real, Plane)> = None;
    for axis in 0..DIM {
        let (mut low, mut high) = (Real::INFINITY, Real::NEG_INFINITY);
        for entry in leaves {
            let middle = entry.aabb.mins[axis] + entry.aabb.maxs[axis];
            (low, high) = (low.min(middle), high.max(middle));
        }
        let scale = BINS as Real / (high - low);
        if !(high > low && scale.is_finite()) {
            continue;
        }
        let plane = Plane { axis, origin: low, scale, first: 0 };
        let (cost, first) = best_bin(leaves, &plane);
        if first > 0 && best.is_none_or(|(least, _)| cost < least) {
            best = Some((cost, Plane { first, ..plane }));
        }
    }
    best.map(|(_, plane)| plane)
}

/// The best bin for a split, and its cost. The first bin if no cut leaves boxes on both sides.
fn best_bin(leaves: &[Entry], plane: &Plane) -> (Real, usize) {
    let mut bins = [(0_usize, Aabb::new_invalid()); BINS];
    for entry in leaves {
        let (count, aabb) = &mut bins[plane.bin(entry)];
        *count += 1;
        aabb.merge(&entry.aabb);
    }
    let (mut costs, mut before) = ([0.0; BINS], (0, Aabb::new_invalid()));
    for (bin, (count, aabb)) in bins.iter().enumerate() {
        costs[bin] = cost(&before);
        before = (before.0 + count, before.1.merged(aabb));
    }
    let (mut best, mut after) = ((Real::INFINITY, 0), (0, Aabb::new_invalid()));
    for bin in (1..BINS).rev() {
        after = (after.0 + bins[bin].0, after.1.merged(&bins[bin].1));
        let total = costs[bin] + cost(&after);
        if after.0 > 0 && after.0 < leaves.len() && total < best.0 {
            best = (total, bin);
        }
    }
    best
}

fn cost((count, aabb): &(usize, Aabb)) -> Real {
    if *count == 0 { 0.0 } else { *count as Real * measure(aabb) }
}
