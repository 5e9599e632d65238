//! Boxes against boxes: the pair of which stacks are made.

use super::{assert_sound, just_touching, manifolds};
use crate::base::random::Random;
use crate::dim::collide::samples;
use crate::dim::math::{DIM, MAX_MANIFOLD_POINTS, Pose, Real, Vector};
use crate::model::contact::ContactManifold;
use parry::shape::SharedShape;

fn random_box(random: &mut Random) -> SharedShape {
    let offset = samples::vector(random, 0.4);
    samples::cuboid(Vector::splat(0.6) + offset)
}

#[test]
fn the_deepest_point_is_as_deep_as_in_parry() {
    let mut random = Random(1);
    let (mut compared, mut same) = (0, 0);
    for round in 0..3_000 {
        let (shape1, shape2) = (random_box(&mut random), random_box(&mut random));
        let pos12 = just_touching(&*shape1, &*shape2, 0.03, &mut random);
        let (found, _) = manifolds(&pos12, &*shape1, &*shape2, 0.01);
        assert_sound(&found, &pos12, 0.01, &format!("round {round}"));
        let theirs = parry::query::contact(&Pose::IDENTITY, &*shape1, &pos12, &*shape2, 0.01);
        let theirs = theirs.unwrap().unwrap();
        let ours = found[0].deepest_dist();
        // Faces are preferred to edges that overlap a little less: a hundredth of the smallest half
        // extent, and as much again for the first face.
        assert!(
            (ours - theirs.dist).abs() < 1.0e-3 + 0.011,
            "round {round}: {ours}, {}",
            theirs.dist
        );
        if (ours - theirs.dist).abs() < 1.0e-4 {
            compared += 1;
            same += u32::from(found[0].local_n1.dot(theirs.normal1) > 0.99);
        }
    }
    // Two axes may happen to be equally good.
    assert!(compared > 2_000 && same + compared / 500 >= compared, "{same} of {compared}");
}

#[test]
fn the_points_lie_on_both_surfaces() {
    let mut random = Random(2);
    for round in 0..2_000 {
        let (shape1, shape2) = (random_box(&mut random), random_box(&mut random));
        let pos12 = just_touching(&*shape1, &*shape2, 0.02, &mut random);
        for manifold in &manifolds(&pos12, &*shape1, &*shape2, 0.05).0 {
            for contact in manifold.contacts() {
                let surface1 = shape1.distance_to_local_point(contact.local_p1, false).abs();
                let surface2 = shape2.distance_to_local_point(contact.local_p2, false).abs();
                // Corners may stick out of the other face by half a percent of its size.
                assert!(surface1.min(surface2) < 1.0e-4, "round {round}: {surface1}, {surface2}");
                assert!(surface1.max(surface2) < 0.01, "round {round}: {surface1}, {surface2}");
                let gap = pos12 * contact.local_p2 - contact.local_p1;
                let along = gap.dot(manifold.local_n1);
                assert!((along - contact.dist).abs() < 1.0e-4, "round {round}: {along}");
            }
        }
    }
}

#[test]
fn the_roles_of_the_boxes_do_not_matter() {
    let mut random = Random(3);
    for round in 0..2_000 {
        let (shape1, shape2) = (random_box(&mut random), random_box(&mut random));
        let pos12 = just_touching(&*shape1, &*shape2, 0.02, &mut random);
        let (one, _) = manifolds(&pos12, &*shape1, &*shape2, 0.02);
        let (other, _) = manifolds(&pos12.inverse(), &*shape2, &*shape1, 0.02);
        let (one, other) = (one[0].deepest_dist(), other[0].deepest_dist());
        assert!((one - other).abs() < 0.012, "round {round}: {one}, {other}");
    }
}

/// The manifold of a box that lies on another, moved aside and turned about the normal.
fn stacked(aside: Vector, gap: Real, previous: &[ContactManifold]) -> ContactManifold {
    let cube = samples::cuboid(Vector::splat(0.5));
    let pos12 = Pose::from_translation(aside + Vector::Y * (1.0 + gap));
    let mut found = smallvec::SmallVec::new();
    let scratch = &mut Default::default();
    let pair = super::ShapePair::alone(&pos12, [&*cube, &*cube], 0.02);
    super::compute_manifolds(&pair, previous, None, scratch, &mut found);
    assert_eq!(found.len(), 1);
    found.remove(0)
}

#[test]
fn a_box_on_a_box_stands_on_the_corners_of_the_overlap() {
    let aside = Vector::X * 0.2;
    let manifold = stacked(aside, -0.005, &[]);
    assert!((manifold.local_n1 - Vector::Y).length() < 1.0e-6);
    assert_eq!(manifold.contacts().len(), MAX_MANIFOLD_POINTS);
    for contact in manifold.contacts() {
        assert!((contact.dist + 0.005).abs() < 1.0e-5);
        let place = contact.local_p1;
        assert!((place.y - 0.5).abs() < 1.0e-5);
        let is_end = |x: Real| (x - 0.5).abs() < 1.0e-5 || (x + 0.3).abs() < 1.0e-5;
        assert!(is_end(place.x), "{place}");
        if DIM == 3 {
            assert!((place[DIM - 1].abs() - 0.5).abs() < 1.0e-5, "{place}");
        }
    }
}

#[test]
fn rounding_does_not_change_the_features_of_equal_boxes() {
    let mut random = Random(4);
    let mut previous = vec![stacked(Vector::ZERO, 0.0, &[])];
    for round in 0..500 {
        let noise = samples::vector(&mut random, 1.0e-4);
        let manifold = stacked(noise, 0.0, &previous);
        let features = |m: &ContactManifold| -> Vec<_> {
            m.contacts().iter().map(|c| (c.fid1, c.fid2)).collect()
        };
        assert_eq!(features(&manifold), features(&previous[0]), "round {round}: {noise}");
        previous[0] = manifold;
    }
}

#[test]
fn a_leaning_box_stands_on_its_lower_edge() {
    let cube = samples::cuboid(Vector::splat(0.5));
    for lean in [0.05, 0.2, 0.4] {
        let height = 0.5 + 0.5 * (Real::cos(lean) + Real::sin(lean));
        let pos12 = Pose::from_parts(Vector::Y * height, samples::planar_rotation(lean));
        let (found, _) = manifolds(&pos12, &*cube, &*cube, 0.01);
        let lowest: Vec<_> = found[0].contacts().iter().filter(|c| c.dist.abs() < 1.0e-3).collect();
        assert_eq!(lowest.len(), DIM - 1, "leaning by {lean}: {:?}", found[0].contacts());
        assert!(found[0].local_n1.y > 0.999);
    }
}

#[test]
fn turned_boxes_keep_four_points_that_span_the_overlap() {
    let cube = samples::cuboid(Vector::splat(0.5));
    let mut random = Random(5);
    let mut previous: Vec<ContactManifold> = Vec::new();
    let mut kept = 0;
    for round in 0..200 {
        let turn = samples::about_y(0.6 + random.within(-1.0e-5, 1.0e-5));
        let height = Vector::Y * (0.995 + random.within(-1.0e-5, 1.0e-5));
        let mut found = smallvec::SmallVec::new();
        let scratch = &mut Default::default();
        let pos12 = Pose::from_parts(height, turn);
        let pair = super::ShapePair::alone(&pos12, [&*cube, &*cube], 0.02);
        super::compute_manifolds(&pair, &previous, None, scratch, &mut found);
        let names = |m: &ContactManifold| -> Vec<_> {
            m.contacts().iter().map(|c| (c.fid1, c.fid2)).collect()
        };
        kept += usize::from(previous.first().is_some_and(|last| names(last) == names(&found[0])));
        let center: Vector = found[0].contacts().iter().map(|c| c.local_p1).sum();
        let center = center / found[0].contacts().len() as Real;
        assert_eq!(found[0].contacts().len(), MAX_MANIFOLD_POINTS, "round {round}");
        assert!(center.with_y(0.0).length() < 0.15, "round {round}: all points aside, at {center}");
        previous = found.to_vec();
    }
    assert!(kept >= 190, "the points changed {} times", 199 - kept);
}

#[test]
fn a_box_touches_a_point_of_a_chain() {
    let point = Vector::ZERO.with_x(0.1);
    let chain = SharedShape::polyline(vec![point, point], None);
    let cube = samples::cuboid(Vector::splat(0.5));
    let pos12 = Pose::from_translation(Vector::Y * 0.51);
    let (found, _) = manifolds(&pos12, &*chain, &*cube, 0.02);
    assert!((found[0].deepest_dist() - 0.01).abs() < 1.0e-4, "{found:?}");
}
