//! Tests of pair finding.

use super::{BroadPhaseScratch, Crowded, KnownPairs, NeighborLimits, find_pairs};
use crate::base::random::Random;
use crate::base::tasks::Tasks;
use crate::dim::collide::samples;
use crate::dim::math::{Pose, Vector};
use crate::model::body::{RigidBodyBuilder, RigidBodyHandle, RigidBodySet, RigidBodyType};
use crate::model::collider::{
    ActiveCollisionTypes, ColliderBuilder, ColliderHandle, ColliderSet, InteractionGroups,
    may_interact,
};
use crate::model::island::IslandManager;
use crate::model::params::IntegrationParameters;
use crate::model::tree::BroadPhaseBvh;
use parry::bounding_volume::BoundingVolume;
use std::collections::{BTreeMap, BTreeSet};

type Pair = (ColliderHandle, ColliderHandle);

/// A world that is nothing but boxes.
#[derive(Default)]
struct Boxes {
    bodies: RigidBodySet,
    colliders: ColliderSet,
    tree: BroadPhaseBvh,
    params: IntegrationParameters,
    known: BTreeSet<(u32, u32)>,
    /// Number of colliders with too many neighbours.
    crowded: Crowded,
}

/// By slot: the partners.
#[derive(Default)]
struct Partners(BTreeMap<u32, Vec<u32>>);

impl Partners {
    fn of(known: &BTreeSet<(u32, u32)>) -> Self {
        let mut partners = Self::default();
        for &(low, high) in known {
            partners.0.entry(low).or_default().push(high);
            partners.0.entry(high).or_default().push(low);
        }
        partners
    }
}

impl KnownPairs for Partners {
    fn partners(&self, slot: u32) -> &[u32] {
        self.0.get(&slot).map_or(&[], Vec::as_slice)
    }

    fn sensed(&self, _slot: u32) -> &[u32] {
        &[]
    }
}

impl Boxes {
    fn body(&mut self, body_type: RigidBodyType) -> RigidBodyHandle {
        self.bodies.insert(RigidBodyBuilder::new(body_type))
    }

    fn cube(&mut self, place: Vector, body: Option<RigidBodyHandle>) -> ColliderHandle {
        let shape = samples::cuboid(Vector::splat(0.5));
        let builder = ColliderBuilder::new(shape).position(Pose::from_translation(place));
        let handle = match body {
            Some(body) => self.colliders.insert_with_parent(builder, body, &mut self.bodies),
            None => self.colliders.insert(builder),
        };
        self.put(handle, place);
        handle
    }

    fn put(&mut self, handle: ColliderHandle, place: Vector) {
        let collider = self.colliders.get_unnoted_mut(handle).unwrap();
        collider.pose = Pose::from_translation(place);
        let body = collider.parent().and_then(|body| self.bodies.get(body));
        self.tree.follow(handle, collider, body, &self.params);
    }

    /// Edits of the step for a collider whose groups or partner types changed.
    fn search_again(&mut self, handle: ColliderHandle) {
        let collider = self.colliders.get_mut(handle).unwrap();
        let body = collider.parent().and_then(|body| self.bodies.get(body));
        self.tree.note_filters(collider, body);
        self.tree.mark_moved(handle.into_raw_parts().0);
    }

    fn remove(&mut self, handle: ColliderHandle) {
        let (slot, _) = handle.into_raw_parts();
        self.tree.remove_slot(slot);
        self.colliders.take(handle, false);
        self.known.retain(|&(low, high)| low != slot && high != slot);
    }

    /// The new pairs, which are known from then on.
    fn find(&mut self) -> Vec<Pair> {
        let (known, mut scratch) = (&Partners::of(&self.known), BroadPhaseScratch::default());
        let (tree, limits) = (&mut self.tree, NeighborLimits::of(&self.params));
        let islands = IslandManager::new();
        self.crowded = Tasks::open(|tasks| {
            find_pairs(tasks, tree, limits, &self.colliders, known, &islands, &mut scratch)
        });
        let found = scratch.pairs;
        self.known.extend(found.iter().map(|&(a, b)| (a.into_raw_parts().0, b.into_raw_parts().0)));
        found
    }
}

#[test]
fn movable_colliders_find_each_other_and_the_fixed() {
    let mut boxes = Boxes::default();
    let (body, other) = (boxes.body(RigidBodyType::Dynamic), boxes.body(RigidBodyType::Dynamic));
    let ground = boxes.cube(Vector::ZERO, None);
    let wall = boxes.cube(Vector::ZERO, None);
    let first = boxes.cube(Vector::splat(0.9), Some(body));
    let second = boxes.cube(Vector::splat(0.9), Some(body));
    let third = boxes.cube(Vector::splat(1.5), Some(other));
    let expected = [
        (ground, first),
        (ground, second),
        (wall, first),
        (wall, second),
        (first, third),
        (second, third),
    ];
    assert_eq!(boxes.find(), expected);
    assert_eq!(boxes.find(), [], "no body moved");
    boxes.put(third, Vector::splat(0.5));
    assert_eq!(boxes.find(), [(ground, third), (wall, third)], "the others are known");
}

#[test]
fn colliders_that_cannot_interact_form_no_pair() {
    let mut boxes = Boxes::default();
    let body = boxes.body(RigidBodyType::Dynamic);
    let kinematic = boxes.body(RigidBodyType::KinematicVelocityBased);
    let ground = boxes.cube(Vector::ZERO, None);
    let first = boxes.cube(Vector::ZERO, Some(body));
    let second = boxes.cube(Vector::ZERO, Some(kinematic));
    let collider = boxes.colliders.get_mut(first).unwrap();
    collider.set_collision_groups(InteractionGroups::none());
    assert_eq!(boxes.find(), [], "groups do not meet, and kinematic meets fixed only on request");

    boxes.colliders.get_mut(first).unwrap().set_collision_groups(InteractionGroups::all());
    boxes.search_again(first);
    assert_eq!(boxes.find(), [(ground, first), (first, second)]);

    let collider = boxes.colliders.get_mut(ground).unwrap();
    collider.set_active_collision_types(ActiveCollisionTypes::all());
    boxes.search_again(ground);
    assert_eq!(boxes.find(), [(ground, second)]);
}

#[test]
fn fixed_colliders_meet_on_request() {
    let mut boxes = Boxes::default();
    let first = boxes.cube(Vector::ZERO, None);
    let second = boxes.cube(Vector::ZERO, None);
    assert_eq!(boxes.find(), []);
    let collider = boxes.colliders.get_mut(second).unwrap();
    collider.set_active_collision_types(ActiveCollisionTypes::all());
    boxes.search_again(second);
    assert_eq!(boxes.find(), [(first, second)]);
    let third = boxes.cube(Vector::ZERO, None);
    assert_eq!(
        boxes.find(),
        [(second, third)],
        "the new collider finds the one that allows the pair"
    );
}

#[test]
fn the_disabled_and_the_removed_are_not_found() {
    let mut boxes = Boxes::default();
    let body = boxes.body(RigidBodyType::Dynamic);
    let ground = boxes.cube(Vector::ZERO, None);
    let first = boxes.cube(Vector::ZERO, Some(body));
    boxes.colliders.get_mut(first).unwrap().set_enabled(false);
    boxes.put(first, Vector::ZERO);
    assert_eq!(boxes.find(), []);
    boxes.colliders.get_mut(first).unwrap().set_enabled(true);
    boxes.put(first, Vector::ZERO);
    boxes.colliders.take(ground, true);
    boxes.tree.remove_slot(ground.into_raw_parts().0);
    assert_eq!(boxes.find(), []);
    let tenant = boxes.cube(Vector::ZERO, None);
    assert_eq!(boxes.find(), [(tenant, first)], "a new collider in the old slot");
}

#[test]
fn a_slow_motion_is_noticed_when_it_adds_up() {
    let mut boxes = Boxes::default();
    let body = boxes.body(RigidBodyType::Dynamic);
    let ground = boxes.cube(Vector::ZERO, None);
    let first = boxes.cube(Vector::X * 3.0, Some(body));
    assert_eq!(boxes.find(), []);
    boxes.bodies.get_mut(body).unwrap().set_linvel(Vector::X * -0.6, true);
    let (mut x, mut updates) = (3.0, 0);
    while boxes.known.is_empty() {
        x -= 0.01;
        assert!(x > 0.9, "the boxes overlap and no pair was found");
        let collider = boxes.colliders.get_unnoted_mut(first).unwrap();
        collider.pose = Pose::from_translation(Vector::X * x);
        collider.proxy.clearance -= 0.01;
        if collider.proxy.clearance < 0.0 {
            boxes.tree.follow(first, collider, boxes.bodies.get(body), &boxes.params);
            updates += 1;
        }
        boxes.find();
    }
    assert!(boxes.known.contains(&(ground.into_raw_parts().0, first.into_raw_parts().0)));
    assert!(x > 1.02 && updates < 60, "found at {x} after {updates} updates of the box");
}

#[test]
fn found_pairs_are_those_of_comparing_all() {
    let (mut boxes, mut random) = (Boxes::default(), Random(11));
    let mut handles = Vec::new();
    for index in 0..150 {
        let place = samples::vector(&mut random, 4.0);
        let body = match index % 3 {
            0 => None,
            1 => Some(boxes.body(RigidBodyType::Dynamic)),
            _ => Some(boxes.body(RigidBodyType::KinematicPositionBased)),
        };
        handles.push(boxes.cube(place, body));
    }
    for _ in 0..10 {
        let found = boxes.find();
        assert!(found.windows(2).all(|pair| pair[0] < pair[1]), "not sorted, or twice the same");
        let overlapping = |a: &ColliderHandle, b: &ColliderHandle| {
            let (a, b) = (&boxes.colliders[*a], &boxes.colliders[*b]);
            may_interact(a, b) && a.proxy.fat_aabb.intersects(&b.proxy.fat_aabb)
        };
        for (index, a) in handles.iter().enumerate() {
            for b in handles[index + 1..].iter().filter(|b| overlapping(a, b)) {
                let slots = (a.into_raw_parts().0, b.into_raw_parts().0);
                assert!(boxes.known.contains(&slots), "{slots:?} was not found");
            }
        }
        for _ in 0..40 {
            let handle = handles[random.below(handles.len())];
            let place = boxes.colliders[handle].pose.translation;
            boxes.put(handle, place + samples::vector(&mut random, 0.5));
        }
    }
}

/// Each of several cubes at one point owns the maximum of pairs, the nearest slots first, and searches again
/// in the next step.
#[test]
fn a_crowd_has_as_many_pairs_as_it_may() {
    const PAIRS_MAX: usize = 10;
    let mut boxes = Boxes::default();
    boxes.params.max_neighbors_per_collider = PAIRS_MAX;
    let ground = boxes.cube(Vector::ZERO, None);
    let cubes: Vec<_> = (0..100)
        .map(|_| {
            let body = boxes.body(RigidBodyType::Dynamic);
            boxes.cube(Vector::splat(0.9), Some(body))
        })
        .collect();
    let found = boxes.find();
    assert_eq!(boxes.crowded.solids, 100 - 1 - PAIRS_MAX);
    for (k, &cube) in cubes.iter().enumerate() {
        assert!(found.contains(&(ground, cube)), "the ground is not counted");
        let owned = found.iter().filter(|&&(low, high)| high == cube && low != ground);
        assert!(owned.clone().count() == k.min(PAIRS_MAX), "cube {k}: {found:?}");
        assert!(owned.clone().all(|(low, _)| cubes[k.saturating_sub(PAIRS_MAX)..k].contains(low)));
    }
    assert_eq!(boxes.find(), [], "nothing new");
    assert_eq!(boxes.crowded.solids, 100 - 1 - PAIRS_MAX, "the search still counts them");
    // Two owned pairs are gone: the next nearest replace them.
    let last = cubes[99];
    for gone in [cubes[98], cubes[97]] {
        boxes.remove(gone);
    }
    let of_last: Vec<_> = boxes.find().into_iter().filter(|pair| pair.1 == last).collect();
    assert_eq!(of_last, [(cubes[87], last), (cubes[88], last)]);
}

/// Pairs with larger colliders are never dropped in favour of smaller ones, independent of the moving side.
#[test]
fn small_colliders_own_pairs_with_large_ones() {
    let mut boxes = Boxes::default();
    boxes.params.max_neighbors_per_collider = 3;
    let small = samples::cuboid(Vector::splat(0.1));
    let mut smalls = Vec::new();
    let mut larges = Vec::new();
    for k in 0..30 {
        let body = boxes.body(RigidBodyType::Dynamic);
        let builder = ColliderBuilder::new(small.clone());
        smalls.push(boxes.colliders.insert_with_parent(builder, body, &mut boxes.bodies));
        boxes.put(smalls[k], Vector::ZERO);
        if k % 15 == 0 {
            let body = boxes.body(RigidBodyType::Dynamic);
            larges.push(boxes.cube(Vector::ZERO, Some(body)));
        }
    }
    let ordered = |a: ColliderHandle, b: ColliderHandle| if a < b { (a, b) } else { (b, a) };
    let found = boxes.find();
    for &large in &larges {
        assert!(smalls.iter().all(|&small| found.contains(&ordered(small, large))), "{found:?}");
    }
    assert!(found.contains(&(larges[0], larges[1])), "{found:?}");
    // A third large collider overlaps small ones at rest that own the maximum of small pairs.
    let body = boxes.body(RigidBodyType::Dynamic);
    let third = boxes.cube(Vector::ZERO, Some(body));
    let expected: BTreeSet<_> =
        smalls.iter().chain(&larges).map(|&other| ordered(other, third)).collect();
    let found: BTreeSet<_> = boxes.find().into_iter().collect();
    assert!(found.is_superset(&expected), "{found:?}");
    // A fourth large collider exceeds the limit.
    let body = boxes.body(RigidBodyType::Dynamic);
    let fourth = boxes.cube(Vector::ZERO, Some(body));
    assert_eq!(boxes.find(), [larges[0], larges[1], third].map(|large| ordered(large, fourth)));
}
