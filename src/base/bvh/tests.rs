//! Compares the tree with a search of all boxes after arbitrary edits.

use super::node::{Node, Planes, Target};
use super::{BoxProbe, BoxTree, BuildScratch, PointProbe, Probe, SlabProbe, nearest};
use crate::base::random::Random;
use crate::base::wide::{LANES, Wide};
use core::cell::Cell;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::math::{DIM, Real, Vector};

fn vector(random: &mut Random, size: f64) -> Vector {
    let mut vector = Vector::ZERO;
    (0..DIM).for_each(|axis| vector[axis] = random.within(-size, size));
    vector
}

/// Boxes of all sizes, some flat, some of no size, some on top of each other.
fn random_box(random: &mut Random, region: f64) -> Aabb {
    let size = [0.0, 0.1, 1.0, 10.0][random.below(4)];
    let mut center = vector(random, region);
    if random.below(4) == 0 {
        center = center.round();
    }
    let mut half = vector(random, size).abs();
    if random.below(4) == 0 {
        half[random.below(DIM)] = 0.0;
    }
    Aabb::from_half_extents(center, half)
}

/// The tree, and the same boxes in a list.
#[derive(Default)]
struct Twins {
    tree: BoxTree,
    list: Vec<Option<Aabb>>,
}

impl Twins {
    fn insert(&mut self, aabb: Aabb, slot: u32) {
        self.tree.insert(&aabb, slot);
        if slot as usize >= self.list.len() {
            self.list.resize(slot as usize + 1, None);
        }
        self.list[slot as usize] = Some(aabb);
    }

    fn remove(&mut self, slot: u32) {
        self.tree.remove(slot);
        self.list[slot as usize] = None;
    }

    fn edit(&mut self, random: &mut Random, slots: usize) {
        let slot = random.below(slots) as u32;
        match random.below(6) {
            0 => self.remove(slot),
            1 => self.insert(random_box(random, 20.0), slot),
            _ => {
                // A small step, as bodies make them.
                let old = self.list[slot as usize].unwrap_or(Aabb::new_invalid());
                if old.mins.x <= old.maxs.x {
                    let step = vector(random, 0.3);
                    self.insert(Aabb::new(old.mins + step, old.maxs + step), slot);
                }
            }
        }
    }

    fn slots(&self, is_found: impl Fn(&Aabb) -> bool) -> Vec<u32> {
        let boxes = (0..).zip(&self.list);
        boxes.filter(|(_, aabb)| aabb.is_some_and(|aabb| is_found(&aabb))).map(|(s, _)| s).collect()
    }

    fn found(&self, probe: impl Probe, reach: Real) -> Vec<u32> {
        let mut found: Vec<_> = self.tree.leaves(probe, reach).collect();
        found.sort_unstable();
        found
    }

    /// Invariants of the tree after any edits: boxes contain their descendants, and every place is stored.
    fn validate(&self) {
        let mut depths = vec![0];
        let (mut open, mut leaves) = (vec![(0, 1)], 0);
        while let Some((at, depth)) = open.pop() {
            let node = &self.tree.nodes[at];
            depths.push(depth);
            for lane in 0..node.len() {
                let entry = node.entry(lane);
                match entry.child.target() {
                    Target::Slot(slot) => {
                        leaves += 1;
                        assert_eq!(self.list[slot as usize], Some(entry.aabb));
                        assert_eq!(self.tree.get(slot), Some(entry.aabb));
                    }
                    Target::Node(below) => {
                        let parent = self.tree.nodes[below].parent.expect("it is not the root");
                        assert_eq!((parent.node(), parent.lane()), (at, lane));
                        assert!(entry.aabb.contains(&self.tree.nodes[below].around()));
                        assert!(self.tree.nodes[below].len() > 1, "a node for a single child");
                        open.push((below, depth + 1));
                    }
                }
            }
        }
        assert_eq!(leaves, self.tree.len());
        assert_eq!(leaves, self.slots(|_| true).len());
        let used = depths.len() - 1 + self.tree.free.len();
        assert!(used == self.tree.nodes.len() || leaves == 0);
    }
}

fn check_boxes(twins: &Twins, random: &mut Random) {
    let around = random_box(random, 25.0);
    let expected = twins.slots(|aabb| aabb.intersects(&around));
    assert_eq!(twins.found(BoxProbe(around), 0.0), expected);
    let mut visited = Vec::new();
    twins.tree.for_each_leaf(&BoxProbe(around), |slot| visited.push(slot));
    visited.sort_unstable();
    assert_eq!(visited, expected);
    assert_eq!(twins.tree.get(0), twins.list[0]);
}

fn distance(aabb: &Aabb, point: Vector) -> Real {
    (aabb.mins - point).max(point - aabb.maxs).max(Vector::ZERO).length()
}

fn check_points(twins: &Twins, random: &mut Random) {
    let (point, reach) = (vector(random, 25.0), random.within(0.0, 8.0));
    let probe = PointProbe(point);
    let found = twins.found(probe, reach);
    for slot in twins.slots(|aabb| distance(aabb, point) <= reach) {
        assert!(found.contains(&slot), "{slot} is within {reach} of {point}");
    }
    for slot in found {
        let aabb = twins.list[slot as usize].unwrap();
        assert!(distance(&aabb, point) <= reach * (1.0 + 16.0 * Real::EPSILON) + Real::EPSILON);
    }
    let mut least = (Real::INFINITY, u32::MAX);
    nearest(
        &twins.tree,
        &probe,
        Real::MAX,
        |_| {},
        |slot| {
            let distance = distance(&twins.list[slot as usize].unwrap(), point);
            least = if (distance, slot) < least { (distance, slot) } else { least };
            least.0
        },
    );
    let all = twins.slots(|_| true).into_iter();
    let all = all.map(|slot| (distance(&twins.list[slot as usize].unwrap(), point), slot));
    let expected = all.min_by(|a, b| a.partial_cmp(b).unwrap());
    assert_eq!(least, expected.unwrap_or((Real::INFINITY, u32::MAX)), "{point}");
}

/// Whether a swept box meets another: sampled along the path, which has no false positives.
fn check_sweeps(twins: &Twins, random: &mut Random) {
    let (origin, mut dir, half) =
        (vector(random, 25.0), vector(random, 1.0), vector(random, 0.5).abs());
    if random.below(3) == 0 {
        dir[random.below(DIM)] = 0.0;
    }
    let probe = SlabProbe::new(origin, dir, half);
    let reach = random.within(0.0, 40.0);
    let found = twins.found(probe, reach);
    for sample in 0..100 {
        let center = origin + dir * (reach * sample as Real / 100.0);
        let moved = Aabb::from_half_extents(center, half * 0.999);
        for slot in twins.slots(|aabb| aabb.intersects(&moved)) {
            assert!(found.contains(&slot), "{slot} is met at {center}, {origin} {dir}");
            let aabb = twins.list[slot as usize].unwrap();
            let (time, [start, end]) = (reach * sample as Real / 100.0, probe.span(&aabb));
            assert!(start <= time && time * 0.999 <= end, "{time} is not in {start}..{end}");
        }
    }
    // The search has no false positives: no axis keeps the two boxes apart.
    for slot in found {
        let aabb = twins.list[slot as usize].unwrap();
        let path = Aabb::new(origin.min(origin + dir * reach), origin.max(origin + dir * reach));
        assert!(path.loosened(half.max_element() + 1.0e-3).intersects(&aabb));
    }
}

fn check(twins: &Twins, random: &mut Random) {
    twins.validate();
    for _ in 0..20 {
        check_boxes(twins, random);
        check_points(twins, random);
        check_sweeps(twins, random);
    }
}

#[test]
fn it_finds_the_same_as_a_test_of_all_boxes() {
    for (seed, slots) in [(1, 3), (2, LANES), (3, LANES + 1), (4, 60), (5, 700)] {
        let (mut twins, mut random) = (Twins::default(), Random(seed));
        for slot in 0..slots as u32 {
            twins.insert(random_box(&mut random, 20.0), slot);
        }
        check(&twins, &mut random);
        for round in 0..8 {
            for _ in 0..slots {
                twins.edit(&mut random, slots);
            }
            check(&twins, &mut random);
            if round == 3 {
                twins.tree.rebuild(&mut BuildScratch::default());
                check(&twins, &mut random);
            }
        }
        for slot in 0..slots as u32 {
            twins.remove(slot);
        }
        assert!(
            twins.tree.is_empty() && twins.found(BoxProbe(Aabb::new_invalid()), 0.0).is_empty()
        );
        twins.insert(random_box(&mut random, 1.0), 0);
        check(&twins, &mut random);
    }
}

/// Orders of insertion that make a plain tree a list.
#[test]
fn no_order_makes_it_deep() {
    let along = |at: usize| Vector::X * at as Real;
    let nested = |at: usize| Aabb::from_half_extents(Vector::ZERO, Vector::splat(at as Real));
    let orders: [&dyn Fn(usize) -> Aabb; 4] = [
        &|at| Aabb::from_half_extents(along(at), Vector::splat(0.4)),
        &|_| Aabb::from_half_extents(Vector::ZERO, Vector::splat(0.4)),
        &|at| nested(at + 1),
        &|at| nested(5000 - at),
    ];
    for order in orders {
        let mut twins = Twins::default();
        (0..4000).for_each(|at| twins.insert(order(at), at as u32));
        twins.validate();
        let depth = |tree: &BoxTree| {
            let depth_of = |slot: u32| {
                let mut at = tree.place(slot).map(|place| place.node());
                core::iter::from_fn(move || {
                    let node = at?;
                    at = tree.nodes[node].parent.map(|place| place.node());
                    Some(node)
                })
                .count()
            };
            (0..4000).map(depth_of).max().unwrap()
        };
        // At least two children per node, and far more as a rule.
        assert!(depth(&twins.tree) <= 12, "{}", depth(&twins.tree));
        twins.tree.rebuild(&mut BuildScratch::default());
        twins.validate();
        assert!(depth(&twins.tree) <= 12, "{} when built", depth(&twins.tree));
    }
}

/// A probe that counts the nodes that it tests.
#[derive(Copy, Clone)]
struct Counting<'a>(SlabProbe, &'a Cell<usize>);

impl Probe for Counting<'_> {
    #[inline(always)]
    fn test<W: Wide>(&self, planes: &Planes, reach: Real) -> (W, W::Mask) {
        self.1.set(self.1.get() + 1);
        self.0.test::<W>(planes, reach)
    }
}

/// A large box does not affect searches for small ones, nor do moved boxes.
#[test]
fn few_nodes_are_visited() {
    let (mut twins, mut random) = (Twins::default(), Random(8));
    twins.insert(Aabb::from_half_extents(Vector::ZERO, Vector::splat(1.0e3)), 0);
    let small = |center| Aabb::from_half_extents(center, Vector::splat(0.2));
    for slot in 1..3000 {
        twins.insert(small(vector(&mut random, 50.0)), slot);
    }
    for when in ["grown", "built", "moved"] {
        if when == "moved" {
            (1..3000).for_each(|slot| twins.insert(small(vector(&mut random, 50.0)), slot));
        }
        let visits = Cell::new(0);
        for _ in 0..100 {
            let (origin, dir) = (vector(&mut random, 50.0), vector(&mut random, 1.0));
            let probe = Counting(SlabProbe::new(origin, dir, Vector::ZERO), &visits);
            let found = twins.tree.leaves(probe, 1.0).count();
            assert!(found > 0, "the large box is everywhere");
        }
        println!("{when}: {} visits for 100 short rays", visits.get());
        // The fewer lanes, the more nodes.
        assert!(
            visits.get() < 100 * 240 / LANES,
            "{} visits for 100 short rays, when {when}",
            visits.get()
        );
        twins.tree.rebuild(&mut BuildScratch::default());
    }
}

/// Eight boxes at each place leave for the other end of the world. They must not enlarge each other's
/// parents: at their new place, they are grouped again.
#[test]
fn leaving_boxes_enlarge_no_parent() {
    let at = |x: Real, y: Real| {
        let mut center = Vector::ZERO;
        (center[0], center[1]) = (x, y);
        Aabb::from_half_extents(center, Vector::splat(0.5))
    };
    let mut tree = BoxTree::default();
    let place = |slot: u32| (2.0 * (slot % 20) as Real, 2.0 * (slot / 20) as Real);
    let leavers = |step: u32| {
        (400..560).map(move |slot| {
            let (x, y) = place((slot - 400) / 8 * 21);
            (slot, at(x + 0.3 * step as Real, y))
        })
    };
    (0..400).for_each(|slot| tree.insert(&at(place(slot).0, place(slot).1), slot));
    leavers(0).for_each(|(slot, aabb)| tree.insert(&aabb, slot));
    // Now each eight of them have a common node.
    tree.rebuild(&mut BuildScratch::default());
    for step in 1..3000 {
        leavers(step).for_each(|(slot, aabb)| tree.insert(&aabb, slot));
    }
    let mut between = at(450.0, 0.0);
    (between.mins[1], between.maxs[1]) = (-100.0, 100.0);
    let crosses = |node: &Node| (0..node.len()).any(|k| node.lane_box(k).intersects(&between));
    let crossing = tree.nodes.iter().filter(|node| crosses(node)).count();
    let all = tree.nodes.len();
    assert!(25 * crossing <= all, "{crossing} of {all} nodes reach from one end to the other");
}
