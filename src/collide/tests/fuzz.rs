//! Random pairs of all shapes: no panic, no infinite number, and distances that are true.

use super::{Scene, assert_sound, manifolds};
use crate::base::random::Random;
use crate::collide::queries::shapes_intersect;
use crate::dim::collide::samples::{self, CONVEX_KINDS, KINDS};
use crate::dim::math::{Pose, Real, Vector};

#[test]
fn random_pairs_give_sound_manifolds() {
    let mut random = Random(1);
    for round in 0..10_000 {
        let kinds = [random.below(KINDS), random.below(KINDS)];
        let [shape1, shape2] = kinds.map(|kind| samples::shape(kind, &mut random, 1.0));
        let pos12 = samples::pose(&mut random, 1.5);
        let (found, bound) = manifolds(&pos12, &*shape1, &*shape2, 0.1);
        assert_sound(&found, &pos12, 0.1, &format!("round {round}, shapes {kinds:?}"));
        assert!(bound >= 0.0 && (found.is_empty() || bound == 0.0));
        shapes_intersect(&pos12, &*shape1, &*shape2);
    }
}

#[test]
fn extreme_sizes_and_places_do_no_harm() {
    let mut random = Random(2);
    for round in 0..10_000 {
        let kinds = [random.below(KINDS), random.below(KINDS)];
        let mut size =
            |smallest: i32| 10.0_f64.powi(random.below((11 - smallest) as usize) as i32 + smallest);
        // Hulls of nearly equal points are refused long before.
        let [size1, size2] = kinds.map(|kind| size(if kind < samples::HULL { -25 } else { -6 }));
        let range = size(-25);
        let shape1 = samples::shape(kinds[0], &mut random, size1);
        let shape2 = samples::shape(kinds[1], &mut random, size2);
        let pos12 = samples::pose(&mut random, range);
        let what = format!("round {round}: {kinds:?}, sizes {size1}, {size2}, range {range}");
        shapes_intersect(&pos12, &*shape1, &*shape2);
        let mut scene = Scene::new(shape1, shape2);
        for step in 0..3 {
            let moved = Pose::from_translation(Vector::splat(0.01 * step as Real));
            scene.place(pos12 * moved);
            assert_sound(&scene.found, &(pos12 * moved), 0.02, &what);
        }
    }
}

#[test]
fn poses_that_are_not_finite_give_nothing() {
    let mut random = Random(3);
    for kind in 0..KINDS {
        let shape1 = samples::shape(kind, &mut random, 1.0);
        let shape2 = samples::shape(1, &mut random, 1.0);
        for bad in [Real::NAN, Real::INFINITY, Real::MAX] {
            let pos12 = Pose::from_translation(Vector::splat(bad));
            assert!(manifolds(&pos12, &*shape1, &*shape2, 0.1).0.is_empty());
            assert!(!shapes_intersect(&pos12, &*shape1, &*shape2));
        }
    }
}

#[test]
fn the_bound_of_the_distance_is_a_lower_bound() {
    let mut random = Random(4);
    let mut compared = 0;
    for round in 0..4_000 {
        let kinds = [random.below(CONVEX_KINDS), random.below(CONVEX_KINDS)];
        let [shape1, shape2] = kinds.map(|kind| samples::shape(kind, &mut random, 1.0));
        let pos12 = samples::pose(&mut random, 3.0);
        let (found, bound) = manifolds(&pos12, &*shape1, &*shape2, 0.01);
        let distance = parry::query::distance(&Pose::IDENTITY, &*shape1, &pos12, &*shape2);
        let Ok(distance) = distance.map(|found| found.distance) else { continue };
        assert!(bound <= distance + 1.0e-3, "round {round}: {kinds:?}: {bound} > {distance}");
        if found.is_empty() && distance > 0.02 {
            assert!(bound > 0.0, "round {round}: {kinds:?} have no bound");
            compared += 1;
        }
    }
    assert!(compared > 1_000, "only {compared} pairs were apart");
}
