//! Hulls, boxes and triangles against each other, with and without a last step to start from.

use super::{Scene, assert_sound, just_touching};
use crate::base::random::Random;
use crate::dim::collide::{Polytope, samples};
use crate::dim::math::{Pose, Real, Vector, rotation_from_angle};
use parry::shape::SharedShape;

/// A shape with flat faces and an inside.
fn random_polytope(random: &mut Random) -> SharedShape {
    let kinds = [1, samples::HULL, samples::HULL + 1];
    samples::shape(kinds[random.below(3)], random, 0.6)
}

#[test]
fn faces_and_supports_of_polytopes_agree() {
    let mut random = Random(1);
    for round in 0..500 {
        let shape = random_polytope(&mut random);
        let Some((polytope, _)) = Polytope::of(&*shape) else { continue };
        let direction = samples::rotation(&mut random) * Vector::X;
        let face = polytope.face_toward(direction).unwrap();
        assert!((face.normal.length() - 1.0).abs() < 1.0e-4, "round {round}");
        let highest = polytope.support(face.normal).dot(face.normal);
        assert!(
            (highest - face.offset).abs() < 1.0e-4,
            "round {round}: {highest}, {}",
            face.offset
        );
        let support = polytope.as_support().local_support_point(direction);
        let ours = polytope.support(direction);
        assert!((support - ours).dot(direction).abs() < 1.0e-5, "round {round}");
        if let Some(edge) = polytope.edge_toward(direction) {
            let top = edge.ends[0].dot(direction).max(edge.ends[1].dot(direction));
            assert!(
                (top - ours.dot(direction)).abs() < 0.3,
                "round {round}: the edge is elsewhere"
            );
        }
    }
}

/// Moves two shapes along each other and compares the deepest point with parry's result in each step.
fn follow(shapes: [SharedShape; 2], random: &mut Random, what: &str) -> [u32; 2] {
    let mut pos12 = just_touching(&*shapes[0], &*shapes[1], 0.005, random);
    let mut scene = Scene::new(shapes[0].clone(), shapes[1].clone());
    let turn = rotation_from_angle(samples::angle(random, 0.01));
    let shift = samples::vector(random, 0.004);
    let (mut compared, mut agreed) = (0, 0);
    for step in 0..40 {
        scene.place(pos12);
        let what = format!("{what}, step {step}");
        assert_sound(&scene.found, &pos12, 0.02, &what);
        let theirs = parry::query::contact(&Pose::IDENTITY, &*shapes[0], &pos12, &*shapes[1], 0.0);
        if let Ok(Some(theirs)) = theirs {
            assert!(
                !scene.found.is_empty(),
                "{what}: a contact of depth {} is missed",
                -theirs.dist
            );
            let ours = scene.found[0].deepest_dist();
            // The least overlap is the least there is; ours may be that of a face near by.
            assert!(ours <= theirs.dist + 0.01, "{what}: {ours} is less than {}", theirs.dist);
            compared += 1;
            agreed += u32::from((ours - theirs.dist).abs() < 0.01);
        }
        pos12 = Pose::from_parts(pos12.translation + shift, turn * pos12.rotation);
    }
    [compared, agreed]
}

#[test]
fn contacts_that_are_followed_stay_as_deep_as_in_parry() {
    let mut random = Random(2);
    let (mut compared, mut agreed) = (0, 0);
    for round in 0..300 {
        let shapes = [random_polytope(&mut random), random_polytope(&mut random)];
        let [more, same] = follow(shapes, &mut random, &format!("round {round}"));
        compared += more;
        agreed += same;
    }
    assert!(compared > 3_000, "only {compared}");
    assert!(agreed * 100 > compared * 97, "{agreed} of {compared}");
}

#[test]
fn a_hull_in_the_form_of_a_box_behaves_like_the_box() {
    let half = Vector::splat(0.5);
    let cube = samples::cuboid(half);
    let hull = SharedShape::convex_hull(&samples::corners(half)).unwrap();
    let mut random = Random(3);
    for round in 0..300 {
        let aside = samples::vector(&mut random, 0.3);
        let pos12 = Pose::from_translation(aside.with_y(0.995));
        let mut ours = Scene::new(cube.clone(), hull.clone());
        let mut boxes = Scene::new(cube.clone(), cube.clone());
        for _ in 0..2 {
            ours.place(pos12);
            boxes.place(pos12);
            let (a, b) = (&ours.found[0], &boxes.found[0]);
            assert!((a.local_n1 - b.local_n1).length() < 1.0e-3, "round {round}: {}", a.local_n1);
            assert_eq!(a.contacts().len(), b.contacts().len(), "round {round}");
            for contact in a.contacts() {
                let near = b.contacts().iter().map(|c| c.local_p1.distance(contact.local_p1));
                let nearest = near.fold(Real::INFINITY, Real::min);
                assert!(nearest < 0.01, "round {round}: no point at {}", contact.local_p1);
                assert!((contact.dist + 0.005).abs() < 1.0e-4, "round {round}: {}", contact.dist);
            }
        }
    }
}

#[test]
fn a_resting_hull_keeps_its_features() {
    let mut random = Random(4);
    let floor = samples::cuboid(Vector::splat(3.0));
    let hull = SharedShape::convex_hull(&samples::corners(Vector::splat(0.5))).unwrap();
    let mut scene = Scene::new(floor, hull);
    let mut names = Vec::new();
    for round in 0..200 {
        let noise = samples::vector(&mut random, 1.0e-3);
        scene.place(Pose::from_translation(Vector::Y * 3.499 + noise * (Vector::ONE - Vector::Y)));
        let now: Vec<_> = scene.found[0].contacts().iter().map(|c| (c.fid1, c.fid2)).collect();
        assert!(round == 0 || now == names, "round {round}: {now:?}, {names:?}");
        names = now;
    }
}
