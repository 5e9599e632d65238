//! Tests of the trees.

use super::{BoxMargin, BroadPhaseBvh, ColliderProxy, TreeKind, shape_box};
use crate::base::random::Random;
use crate::dim::collide::samples;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::ColliderHandle;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::shape::{HalfSpace, Shape};

fn handle(slot: u32) -> ColliderHandle {
    ColliderHandle::from_raw_parts(slot, 0)
}

/// The margin of a collider that stays where it is.
fn at_rest(reach: Real) -> BoxMargin {
    BoxMargin { reach, travel: Vector::ZERO }
}

fn cube(center: Vector) -> Aabb {
    Aabb::from_half_extents(center, Vector::splat(0.5))
}

/// The slots whose boxes overlap a box, in order.
fn overlapping(tree: &BroadPhaseBvh, kind: TreeKind, aabb: &Aabb) -> Vec<u32> {
    let mut found = Vec::new();
    tree.for_each_overlapping(kind, aabb, |slot| found.push(slot));
    found.sort_unstable();
    found
}

#[test]
fn boxes_of_shapes_agree_with_parry() {
    let mut random = Random(1);
    for round in 0..200 {
        let shape = samples::shape(round % samples::KINDS, &mut random, 1.0);
        let pose = samples::pose(&mut random, 10.0);
        let (ours, theirs) = (shape_box(&*shape, &pose), shape.compute_aabb(&pose));
        assert!(
            (ours.mins - theirs.mins).length() <= 1.0e-4,
            "round {round}: {ours:?}, {theirs:?}"
        );
        assert!(
            (ours.maxs - theirs.maxs).length() <= 1.0e-4,
            "round {round}: {ours:?}, {theirs:?}"
        );
    }
}

#[test]
fn a_small_motion_changes_nothing_and_a_large_one_does() {
    let (mut tree, mut proxy) = (BroadPhaseBvh::new(), ColliderProxy::default());
    let margin = at_rest(0.01);
    assert!(tree.place(handle(3), &mut proxy, TreeKind::Dynamic, &cube(Vector::ZERO), &margin));
    assert_eq!(tree.moved(), [3]);
    tree.clear_moved();

    let clearance = proxy.clearance;
    assert!(clearance > 0.0);
    let near = cube(Vector::splat(0.9 * clearance));
    assert!(!tree.place(handle(3), &mut proxy, TreeKind::Dynamic, &near, &margin));
    assert!(proxy.clearance < clearance && tree.moved().is_empty());

    let far = cube(Vector::splat(2.0));
    assert!(tree.place(handle(3), &mut proxy, TreeKind::Dynamic, &far, &margin));
    assert!(tree.is_moved(3) && !tree.is_moved(2) && !tree.is_moved(1_000));
    assert_eq!(overlapping(&tree, TreeKind::Dynamic, &cube(Vector::ZERO)), []);
    assert_eq!(overlapping(&tree, TreeKind::Dynamic, &far), [3]);
}

#[test]
fn motion_makes_room_ahead() {
    let margin = BoxMargin { reach: 0.0, travel: Vector::X * 0.1 };
    let fat = margin.enlarged(&cube(Vector::ZERO), TreeKind::Dynamic);
    assert!(fat.maxs.x > 0.5 + 0.2 && fat.mins.x > -0.6, "no room for two steps: {fat:?}");
    let fast = BoxMargin { reach: 0.0, travel: Vector::X * 1.0e6 };
    let fat = fast.enlarged(&cube(Vector::ZERO), TreeKind::Dynamic);
    assert!(fat.maxs.x < 2.0, "a fast collider sweeps up to {}", fat.maxs.x);
}

#[test]
fn a_collider_stands_in_one_tree() {
    let (mut tree, mut proxy) = (BroadPhaseBvh::new(), ColliderProxy::default());
    let (margin, tight) = (at_rest(0.01), cube(Vector::ZERO));
    for kind in [TreeKind::Dynamic, TreeKind::Fixed, TreeKind::Kinematic, TreeKind::Dynamic] {
        assert!(tree.place(handle(0), &mut proxy, kind, &tight, &margin));
        let counts = TreeKind::ALL.map(|kind| tree.boxes(kind).len());
        assert_eq!(counts, TreeKind::ALL.map(|of| usize::from(of == kind)));
    }
    assert!(tree.remove(0, &mut proxy) && !tree.remove(0, &mut proxy));
    assert!(tree.boxes(TreeKind::Dynamic).is_empty());
}

#[test]
fn boxes_that_are_not_finite_or_too_far_are_left_out() {
    let (mut tree, mut proxy) = (BroadPhaseBvh::new(), ColliderProxy::default());
    let margin = at_rest(0.01);
    for bad in [Real::NAN, Real::INFINITY, 1.0e12] {
        tree.place(handle(0), &mut proxy, TreeKind::Dynamic, &cube(Vector::ZERO), &margin);
        assert!(proxy.tree.is_some());
        tree.place(handle(0), &mut proxy, TreeKind::Dynamic, &cube(Vector::splat(bad)), &margin);
        assert!(
            proxy.is_refused && proxy.tree.is_none() && tree.boxes(TreeKind::Dynamic).is_empty()
        );
    }
}

#[test]
fn half_spaces_and_far_colliders_work() {
    let mut tree = BroadPhaseBvh::new();
    let margin = at_rest(0.01);
    let ground = HalfSpace::new(Vector::Y).compute_aabb(&Pose::IDENTITY);
    let mut proxies = [ColliderProxy::default(); 200];
    tree.place(handle(0), &mut proxies[0], TreeKind::Fixed, &ground, &margin);
    let mut random = Random(5);
    for slot in 1..200 {
        let tight = cube(samples::vector(&mut random, if slot < 100 { 10.0 } else { 1.0e9 }));
        let kind = if slot % 2 == 0 { TreeKind::Fixed } else { TreeKind::Dynamic };
        tree.place(handle(slot), &mut proxies[slot as usize], kind, &tight, &margin);
    }
    tree.tidy();
    for (slot, proxy) in proxies.iter().enumerate().skip(1) {
        let found = overlapping(&tree, TreeKind::Fixed, &proxy.fat_aabb);
        assert!(found.contains(&0), "collider {slot} does not find the ground");
    }
}

#[test]
fn trees_find_the_pairs_of_comparing_all_boxes() {
    let (mut tree, mut random) = (BroadPhaseBvh::new(), Random(9));
    let mut proxies = vec![ColliderProxy::default(); 300];
    for round in 0..5 {
        for slot in 0..300_u32 {
            let tight = cube(samples::vector(&mut random, 6.0));
            let margin = BoxMargin { reach: 0.01, travel: samples::vector(&mut random, 0.2) };
            let proxy = &mut proxies[slot as usize];
            if random.below(3) == 0 {
                tree.remove(slot, proxy);
            } else {
                tree.place(handle(slot), proxy, TreeKind::Dynamic, &tight, &margin);
            }
        }
        tree.tidy();
        for proxy in proxies.iter().filter(|proxy| proxy.tree.is_some()) {
            let found = overlapping(&tree, TreeKind::Dynamic, &proxy.fat_aabb);
            let overlaps = |slot: &u32| {
                let other = &proxies[*slot as usize];
                other.tree.is_some() && other.fat_aabb.intersects(&proxy.fat_aabb)
            };
            let expected: Vec<_> = (0..300).filter(overlaps).collect();
            assert_eq!(found, expected, "round {round}");
        }
    }
}
