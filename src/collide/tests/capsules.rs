//! Round shapes against each other and against boxes.

use super::{assert_sound, just_touching, manifolds};
use crate::base::random::Random;
use crate::dim::collide::samples;
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::SharedShape;

/// A ball, a capsule, a box or a box with round edges.
fn random_shape(kind: usize, random: &mut Random) -> SharedShape {
    samples::shape([0, 1, 3, samples::ROUND_BOX][kind], random, 0.6)
}

#[test]
fn round_shapes_are_as_deep_as_in_parry() {
    let mut random = Random(1);
    let (mut compared, mut agreed) = (0, 0);
    for round in 0..3_000 {
        let kinds = [random.below(4), random.below(4)];
        let [shape1, shape2] = kinds.map(|kind| random_shape(kind, &mut random));
        let depth = random.within(-0.015, 0.02);
        let pos12 = just_touching(&*shape1, &*shape2, depth, &mut random);
        let (found, _) = manifolds(&pos12, &*shape1, &*shape2, 0.02);
        let what = format!("round {round}, {kinds:?}");
        assert_sound(&found, &pos12, 0.02, &what);
        let theirs = parry::query::contact(&Pose::IDENTITY, &*shape1, &pos12, &*shape2, 0.018);
        let Ok(Some(theirs)) = theirs else { continue };
        assert!(!found.is_empty(), "{what}: a contact at {} is missed", theirs.dist);
        let ours = found[0].deepest_dist();
        // A box prefers its faces to edges that are a little better, by a hundredth of its size.
        assert!((ours - theirs.dist).abs() < 0.012, "{what}: {ours}, {}", theirs.dist);
        compared += 1;
        agreed += u32::from((ours - theirs.dist).abs() < 1.0e-3);
    }
    assert!(compared > 2_500 && agreed * 100 > compared * 98, "{agreed} of {compared}");
}

#[test]
fn capsules_that_lie_along_each_other_touch_at_both_ends() {
    let capsule = SharedShape::capsule(Vector::X * -1.0, Vector::X, 0.3);
    let pos12 = Pose::from_translation(Vector::Y * 0.59 + Vector::X * 0.5);
    let (found, _) = manifolds(&pos12, &*capsule, &*capsule, 0.02);
    let ends: Vec<_> = found[0].contacts().iter().map(|contact| contact.local_p1.x).collect();
    assert_eq!(ends.len(), 2);
    assert!((ends[0] + 0.5).abs() < 1.0e-5 && (ends[1] - 1.0).abs() < 1.0e-5, "{ends:?}");
    assert!(found[0].contacts().iter().all(|contact| (contact.dist + 0.01).abs() < 1.0e-5));
    assert!((found[0].local_n1 - Vector::Y).length() < 1.0e-5);
}

#[test]
fn a_capsule_lies_on_a_box_at_both_ends() {
    let capsule = SharedShape::capsule(Vector::X * -1.0, Vector::X, 0.3);
    let floor = samples::cuboid(Vector::splat(2.0));
    let pos12 = Pose::from_translation(Vector::Y * 2.29);
    for (shape1, shape2, pos12) in [(&floor, &capsule, pos12), (&capsule, &floor, pos12.inverse())]
    {
        let (found, _) = manifolds(&pos12, &**shape1, &**shape2, 0.02);
        assert_eq!(found[0].contacts().len(), 2);
        assert!((found[0].local_n1.y.abs() - 1.0).abs() < 1.0e-5);
        for contact in found[0].contacts() {
            assert!((contact.dist + 0.01).abs() < 1.0e-4, "{}", contact.dist);
        }
    }
}

#[test]
fn balls_touch_where_they_are_closest() {
    let mut random = Random(2);
    for _ in 0..200 {
        let radii = [random.within(0.1, 1.0), random.within(0.1, 1.0)];
        let [ball1, ball2] = radii.map(SharedShape::ball);
        let direction = samples::rotation(&mut random) * Vector::X;
        let gap = random.within(-0.05, 0.05);
        let pos12 = Pose::from_translation(direction * (radii[0] + radii[1] + gap));
        let (found, bound) = manifolds(&pos12, &*ball1, &*ball2, 0.1);
        let contact = found[0].contacts()[0];
        assert!((found[0].local_n1 - direction).length() < 1.0e-4 && bound == 0.0);
        assert!((contact.dist - gap).abs() < 1.0e-5);
        assert!((contact.local_p1 - direction * radii[0]).length() < 1.0e-4);
    }
}

#[test]
fn things_in_the_same_place_are_pushed_somewhere() {
    let mut random = Random(3);
    for kinds in (0..16).map(|index| [index / 4, index % 4]) {
        let [shape1, shape2] = kinds.map(|kind| random_shape(kind, &mut random));
        let (found, _) = manifolds(&Pose::IDENTITY, &*shape1, &*shape2, 0.02);
        assert_sound(&found, &Pose::IDENTITY, 0.02, &format!("{kinds:?}"));
        let depth: Real = found.iter().map(|manifold| manifold.deepest_dist()).sum();
        assert!(depth < 0.0, "{kinds:?}: {depth}");
    }
}

#[test]
fn at_the_corner_of_a_box_no_contact_is_deeper_than_the_shapes() {
    let mut random = Random(12);
    let (cube, capsule) = (samples::cuboid(Vector::splat(2.0)), SharedShape::capsule_y(0.6, 0.3));
    let mut compared = 0;
    for round in 0..20_000 {
        let aside = samples::vector(&mut random, 0.2);
        let place = Vector::splat(2.0) + Vector::Y * 0.8 + aside;
        let pos12 = Pose::from_parts(place, samples::rotation(&mut random));
        let Ok(true_dist) = parry::query::distance(&Pose::IDENTITY, &*cube, &pos12, &*capsule)
        else {
            continue;
        };
        let (found, _) = manifolds(&pos12, &*cube, &*capsule, 0.03);
        let Some(manifold) = found.first().filter(|_| true_dist.distance > 0.0) else { continue };
        // A face is taken to reach a hundredth of its size beyond its edges.
        let (ours, dist) = (manifold.deepest_dist(), true_dist.distance);
        assert!(ours > dist - 0.01, "round {round}: {ours}, {dist}");
        compared += 1;
    }
    assert!(compared > 50, "only {compared} were close");
}

#[test]
fn capsules_are_as_far_from_triangles_as_in_parry() {
    let mut random = Random(7);
    let mut compared = 0;
    for round in 0..20_000 {
        let mut corner = || samples::vector(&mut random, 1.0);
        let triangle = SharedShape::triangle(corner(), corner(), corner());
        let capsule = SharedShape::capsule_y(0.4, 0.2);
        let pos12 = samples::pose(&mut random, 0.8);
        let Ok(theirs) = parry::query::distance(&Pose::IDENTITY, &*triangle, &pos12, &*capsule)
        else {
            continue;
        };
        let theirs = theirs.distance;
        for (pose, shape1, shape2) in
            [(pos12, &triangle, &capsule), (pos12.inverse(), &capsule, &triangle)]
        {
            let (found, _) = manifolds(&pose, &**shape1, &**shape2, 0.1);
            assert_sound(&found, &pose, 0.1, "capsule and triangle");
            let ours = found.first().map(|manifold| manifold.deepest_dist());
            if theirs > 0.0 && theirs < 0.09 {
                let ours = ours.unwrap_or_else(|| panic!("round {round}: {theirs} is missed"));
                // A face reaches some millimetres beyond its edges.
                assert!((ours - theirs).abs() < 1.2e-2, "round {round}: {ours}, {theirs}");
                compared += 1;
            } else if theirs > 0.11 {
                assert!(ours.is_none(), "round {round}: {ours:?}, {theirs}");
            }
        }
    }
    assert!(compared > 1_000, "only {compared} were close");
}
