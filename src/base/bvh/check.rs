//! Invariants of a tree after any edits, and of a loaded tree.

use super::BoxTree;
use super::node::{Node, Place, Target};
use crate::base::fault::{Fault, ensure};
use crate::base::loading::{Loaded, check_when_loaded};
use crate::base::wide::LANES;
use parry::bounding_volume::{Aabb, BoundingVolume};

check_when_loaded!(BoxTree);

/// Each node except the root is the child of one other, or free. Each box is at the place that its slot
/// stores. The box of a child contains the boxes below.
impl Loaded for BoxTree {
    fn check_loaded(&self) -> Result<(), Fault> {
        let mut is_seen = vec![false; self.nodes.len()];
        for &node in &self.free {
            let is_first =
                is_seen.get_mut(node as usize).is_some_and(|seen| !core::mem::replace(seen, true));
            ensure!(is_first, "node {node} of a tree is in the free list twice, or does not exist");
        }
        let mut leaf_count = 0;
        let mut open: Vec<(usize, Option<(Place, Aabb)>)> = Vec::new();
        open.extend((!self.nodes.is_empty()).then_some((0, None)));
        while let Some((at, above)) = open.pop() {
            let is_first = is_seen.get_mut(at).is_some_and(|seen| !core::mem::replace(seen, true));
            ensure!(is_first, "node {at} of a tree is there twice, or not at all");
            let node = &self.nodes[at];
            self.check_node(at, node, above)?;
            for lane in 0..node.len() {
                let place = Place::new(at, lane);
                match node.children[lane].target() {
                    Target::Node(below) => open.push((below, Some((place, node.lane_box(lane))))),
                    Target::Slot(slot) => {
                        ensure!(self.place(slot) == Some(place), "box {slot} is not at {place:?}");
                        leaf_count += 1;
                    }
                }
            }
        }
        let lost = is_seen.iter().position(|seen| !seen);
        ensure!(lost.is_none(), "node {lost:?} of a tree is neither used nor free");
        let placed = self.places.iter().flatten().count();
        ensure!(
            [leaf_count, placed] == [self.len; 2],
            "{placed} of {} boxes have {leaf_count} places",
            self.len
        );
        Ok(())
    }
}

impl BoxTree {
    fn check_node(
        &self,
        at: usize,
        node: &Node,
        above: Option<(Place, Aabb)>,
    ) -> Result<(), Fault> {
        let place = above.map(|(place, _)| place);
        ensure!(node.parent == place, "node {at} is at {place:?} and not {:?}", node.parent);
        // A node with a single child gives it to its parent.
        let least = if above.is_some() { 2 } else { 0 };
        ensure!((least..=LANES).contains(&node.len()), "node {at} has {} children", node.len());
        for lane in 0..LANES {
            let aabb = node.lane_box(lane);
            if lane < node.len() {
                let is_box = aabb.mins.is_finite() && aabb.maxs.is_finite();
                let is_box = is_box && aabb.mins.cmple(aabb.maxs).all();
                ensure!(is_box, "a box of node {at} is {aabb:?}");
            } else {
                ensure!(aabb == Aabb::new_invalid(), "an empty lane of node {at} is {aabb:?}");
            }
        }
        if let Some((place, aabb)) = above {
            let around = node.around();
            ensure!(aabb.contains(&around), "{aabb:?} at {place:?} does not contain {around:?}");
        }
        Ok(())
    }
}
