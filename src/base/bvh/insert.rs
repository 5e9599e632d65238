//! Insertion, removal and update of one box.
//!
//! A box descends to the node whose boxes it enlarges least, and is inserted into a node without child nodes.
//! A full node is split in two, and its parent gets one more child. New levels therefore begin at the root
//! alone, as in a B-tree, and no order of insertions makes the tree deep. (The R-tree works likewise:
//! Guttman, "R-Trees: A Dynamic Index Structure for Spatial Searching", 1984.)

use super::node::{Child, Entry, Node, Place, Planes, Target};
use super::{BoxTree, measure, measure_of};
use crate::base::wide::{Kernel, LANES, Lane, Simd, Wide};
use core::cmp::Ordering;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::math::{DIM, Real};

/// Weight of a box's growth relative to its size at the insertion of a new box. With growth, more searches
/// visit the existing contents without a hit; with size, more searches visit the new box.
const GROWTH_WEIGHT: Real = 4.0;
/// Limit on the box of a node before a growing child is moved elsewhere: this fraction of the sum of its
/// children's measures. Eight squares side by side are a third, as many cubes a half.
const MEASURE_FRACTION_MAX: Real = 0.8;

/// The children of a full node, and one more.
type Overfull = [Entry; LANES + 1];

impl BoxTree {
    /// Gives a slot its box, whether or not it had one.
    pub fn insert(&mut self, aabb: &Aabb, slot: u32) {
        if let Some(place) = self.place(slot) {
            self.nodes[place.node()].set_box(place.lane(), aabb);
            if self.stay(place) {
                return;
            }
            self.detach(place);
            self.len -= 1;
        }
        if self.nodes.is_empty() {
            self.nodes.push(Node::empty());
        }
        if slot as usize >= self.places.len() {
            self.places.resize(slot as usize + 1, None);
        }
        let node = self.descend(aabb);
        self.add(node, Entry { aabb: *aabb, child: Child::of_slot(slot) });
        self.len += 1;
        self.wear = self.wear.saturating_add(1);
    }

    /// Takes the box of a slot out, if it has one.
    pub fn remove(&mut self, slot: u32) {
        if let Some(place) = self.place(slot) {
            self.places[slot as usize] = None;
            self.detach(place);
            self.len -= 1;
        }
    }

    /// Keeps a changed box in its place, if no box above must grow, or only small ones. Returns whether it
    /// did. Boxes that move together thus stay together, and a new search would be ten times the work. (Lee
    /// et al., "Supporting Frequent Updates in R-Trees: A Bottom-Up Approach", 2003.)
    ///
    /// All boxes above are tested: a group that leaves would otherwise enlarge them across the world.
    fn stay(&mut self, place: Place) -> bool {
        let node = &self.nodes[place.node()];
        let own = node.around();
        let (mut around, mut sum, mut up) = (own, node.measure_of_children(), node.parent);
        let mut grows = false;
        while let Some(place) = up {
            let above = &self.nodes[place.node()];
            let old = above.lane_box(place.lane());
            if old.contains(&around) {
                break;
            }
            if measure(&around) > MEASURE_FRACTION_MAX * sum {
                return false;
            }
            grows = true;
            sum = above.measure_of_children() - measure(&old) + measure(&around);
            around.merge(&above.around());
            up = above.parent;
        }
        self.wear = self.wear.saturating_add(usize::from(grows));
        self.fit(place.node(), own);
        true
    }

    /// The node that a box should go into. The boxes on the path there grow.
    fn descend(&mut self, aabb: &Aabb) -> usize {
        Simd::detect().run(Descend { nodes: &mut self.nodes, aabb })
    }

    /// Adds a child to a node whose box contains it.
    fn add(&mut self, mut node: usize, mut entry: Entry) {
        while self.nodes[node].len() == LANES {
            let (mut all, kept) = self.overfull(node, entry);
            let first = divide(&mut all);
            let Some(parent) = kept else {
                let [left, right] = [&all[..first], &all[first..]].map(|half| self.new_node(half));
                self.fill(0, &[left, right]);
                return;
            };
            self.fill(node, &all[..first]);
            let around = self.nodes[node].around();
            self.nodes[parent.node()].set_box(parent.lane(), &around);
            entry = self.new_node(&all[first..]);
            node = parent.node();
        }
        let lane = self.nodes[node].len();
        self.nodes[node].count += 1;
        self.put(Place::new(node, lane), &entry);
    }

    fn overfull(&self, node: usize, entry: Entry) -> (Overfull, Option<Place>) {
        let full = &self.nodes[node];
        let all = core::array::from_fn(|lane| if lane < LANES { full.entry(lane) } else { entry });
        (all, full.parent)
    }

    /// A node with these children, to be put somewhere.
    fn new_node(&mut self, entries: &[Entry]) -> Entry {
        let node = match self.free.pop() {
            Some(node) => node as usize,
            None => {
                self.nodes.push(Node::empty());
                self.nodes.len() - 1
            }
        };
        self.fill(node, entries);
        Entry { aabb: self.nodes[node].around(), child: Child::of_node(node) }
    }

    /// Gives a node these children and no others.
    fn fill(&mut self, node: usize, entries: &[Entry]) {
        self.nodes[node].set_len(entries.len());
        for (lane, entry) in entries.iter().enumerate() {
            self.put(Place::new(node, lane), entry);
        }
    }

    /// Sets a child of a lane, and the child's parent.
    pub(super) fn put(&mut self, place: Place, entry: &Entry) {
        self.nodes[place.node()].set_entry(place.lane(), entry);
        match entry.child.target() {
            Target::Node(node) => self.nodes[node].parent = Some(place),
            Target::Slot(slot) => self.places[slot as usize] = Some(place),
        }
    }

    /// Takes a child out of its lane. Nodes that have no child left go, and those with a single one give it
    /// to their parent.
    fn detach(&mut self, place: Place) {
        let (node, lane) = (place.node(), place.lane());
        let last = self.nodes[node].len() - 1;
        if lane != last {
            let moved = self.nodes[node].entry(last);
            self.put(place, &moved);
        }
        self.nodes[node].set_len(last);
        match (last, self.nodes[node].parent) {
            (0, Some(parent)) => {
                self.free.push(node as u32);
                self.detach(parent);
            }
            (1, Some(parent)) => {
                let only = self.nodes[node].entry(0);
                self.free.push(node as u32);
                self.put(parent, &only);
                self.tighten(parent.node());
            }
            (1, None) => self.lower_the_root(),
            _ => self.tighten(node),
        }
    }

    /// A root whose only child is a node takes that node's place.
    fn lower_the_root(&mut self) {
        if let Target::Node(below) = self.nodes[0].children[0].target() {
            let entries: [Entry; LANES] =
                core::array::from_fn(|lane| self.nodes[below].entry(lane));
            let count = self.nodes[below].len();
            self.free.push(below as u32);
            self.fill(0, &entries[..count]);
        }
    }

    /// Fits the boxes around a node, from it to the root.
    fn tighten(&mut self, node: usize) {
        self.fit(node, self.nodes[node].around());
    }

    /// The same, given the box around the node's children.
    fn fit(&mut self, mut node: usize, mut around: Aabb) {
        while let Some(parent) = self.nodes[node].parent {
            if self.nodes[parent.node()].lane_box(parent.lane()) == around {
                return;
            }
            self.nodes[parent.node()].set_box(parent.lane(), &around);
            node = parent.node();
            around = self.nodes[node].around();
        }
    }
}

/// The path of a box down to its node.
struct Descend<'a> {
    nodes: &'a mut [Node],
    aabb: &'a Aabb,
}

impl Kernel for Descend<'_> {
    type Output = usize;

    #[inline(always)]
    fn run<W: Wide>(self) -> usize {
        let mut at = 0;
        loop {
            let node = &mut self.nodes[at];
            let mut costs = Lane::ZERO;
            cost_of_growth::<W>(&node.planes, self.aabb).store(&mut costs);
            let mut best: Option<(Real, usize, usize)> = None;
            for lane in 0..node.len() {
                let Target::Node(below) = node.children[lane].target() else { continue };
                if best.is_none_or(|(least, ..)| costs.0[lane] < least) {
                    best = Some((costs.0[lane], lane, below));
                }
            }
            // The descent ends if all children are leaves.
            let Some((_, lane, below)) = best else { return at };
            node.set_box(lane, &node.lane_box(lane).merged(self.aabb));
            at = below;
        }
    }
}

/// The cost of a box in each child: the size after insertion, and the growth.
#[inline(always)]
fn cost_of_growth<W: Wide>(planes: &Planes, aabb: &Aabb) -> W {
    let (mut before, mut after) = ([W::zero(); DIM], [W::zero(); DIM]);
    for axis in 0..DIM {
        let (mins, maxs) = (W::load(&planes[axis]), W::load(&planes[DIM + axis]));
        before[axis] = maxs - mins;
        after[axis] = maxs.max(W::splat(aabb.maxs[axis])) - mins.min(W::splat(aabb.mins[axis]));
    }
    let (before, after) = (measure_of(before), measure_of(after));
    after + W::splat(GROWTH_WEIGHT) * (after - before)
}

/// Sorts the children of an overfull node, and returns the index of the first child behind the best cut.
///
/// Tests all axes and all splits that leave two on each side. The sum of the measures times the numbers
/// decides (the surface area heuristic: Goldsmith, Salmon, "Automatic Creation of Object Hierarchies for Ray
/// Tracing", 1987).
fn divide(all: &mut Overfull) -> usize {
    let mut best = (Real::INFINITY, 0, 2);
    for axis in 0..DIM {
        sort(all, axis);
        for (first, cost) in costs(all).into_iter().enumerate().take(all.len() - 1).skip(2) {
            if cost < best.0 {
                best = (cost, axis, first);
            }
        }
    }
    let (_, axis, first) = best;
    sort(all, axis);
    first
}

fn sort(all: &mut Overfull, axis: usize) {
    let middle = |entry: &Entry| entry.aabb.mins[axis] + entry.aabb.maxs[axis];
    all.sort_by(|a, b| middle(a).partial_cmp(&middle(b)).unwrap_or(Ordering::Equal));
}

/// The cost of a split before each child.
fn costs(all: &Overfull) -> [Real; LANES + 1] {
    let (mut costs, mut around) = ([0.0; LANES + 1], all[0].aabb);
    for first in 1..all.len() {
        costs[first] = first as Real * measure(&around);
        around.merge(&all[first].aabb);
    }
    around = all[LANES].aabb;
    for first in (1..all.len()).rev() {
        around.merge(&all[first].aabb);
        costs[first] += (all.len() - first) as Real * measure(&around);
    }
    costs
}
