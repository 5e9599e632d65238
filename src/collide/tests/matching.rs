//! Matching of the contacts of successive steps.

use super::{Scene, just_touching, manifolds};
use crate::base::random::Random;
use crate::collide::matching::inherit_impulses;
use crate::dim::collide::samples;
use crate::dim::math::{MAX_MANIFOLD_POINTS, Pose, Real, Vector};
use crate::model::contact::{Contact, ContactManifold};
use parry::shape::PackedFeatureId;

/// Gives every point an impulse that encodes its position.
fn mark(manifolds: &mut [ContactManifold]) {
    for manifold in manifolds {
        manifold.data.user_data = 7;
        for contact in &mut manifold.data.points {
            contact.warmstart_impulse = 10.0 + contact.local_p2.dot(Vector::ONE);
        }
    }
}

/// The number of points with the impulse of the point at the same place of the second shape.
fn recognised(manifolds: &[ContactManifold]) -> usize {
    let contacts = manifolds.iter().flat_map(ContactManifold::contacts);
    let expected = |contact: &Contact| 10.0 + contact.local_p2.dot(Vector::ONE);
    contacts.filter(|contact| (contact.warmstart_impulse - expected(contact)).abs() < 0.05).count()
}

#[test]
fn a_sliding_box_keeps_its_impulses() {
    let mut scene =
        Scene::new(samples::cuboid(Vector::splat(5.0)), samples::cuboid(Vector::splat(0.5)));
    scene.place(Pose::from_translation(Vector::Y * 5.5));
    mark(&mut scene.found);
    for step in 1..100 {
        // A tenth of its size each step, far more than any distance would match.
        scene.place(Pose::from_translation(Vector::Y * 5.5 + Vector::X * (0.04 * step as Real)));
        assert_eq!(recognised(&scene.found), MAX_MANIFOLD_POINTS, "step {step}");
        assert_eq!(scene.found[0].data.user_data, 7);
    }
}

#[test]
fn a_rolling_ball_keeps_its_impulse() {
    let mut scene =
        Scene::new(samples::cuboid(Vector::splat(5.0)), samples::shape(0, &mut Random(1), 1.0));
    let radius = scene.shapes[1].as_ball().unwrap().radius;
    scene.place(Pose::from_translation(Vector::Y * (5.0 + radius)));
    scene.found[0].data.points[0].warmstart_impulse = 3.0;
    for step in 1..50 {
        let x = 0.1 * step as Real;
        let rotation = samples::planar_rotation(-x / radius);
        scene.place(Pose::from_parts(Vector::Y * (5.0 + radius) + Vector::X * x, rotation));
        assert_eq!(scene.found[0].data.points[0].warmstart_impulse, 3.0, "step {step}");
    }
}

#[test]
fn points_without_features_are_matched_by_place() {
    let point = |x: Real| {
        let place = Vector::X * x;
        Contact::new(place, place, PackedFeatureId::UNKNOWN, PackedFeatureId::UNKNOWN, 0.0)
    };
    let manifold = |places: [Real; 2]| {
        let mut manifold = ContactManifold { local_n1: Vector::Y, ..Default::default() };
        manifold.data.points.extend(places.map(point));
        manifold
    };
    let mut old = manifold([-1.0, 1.0]);
    mark(core::slice::from_mut(&mut old));
    let mut new = [manifold([0.99, -1.01])];
    inherit_impulses(&mut new, core::slice::from_ref(&old));
    assert_eq!(recognised(&new), 2);
    let mut far = [manifold([0.0, 3.0])];
    inherit_impulses(&mut far, &[old]);
    assert!(far[0].contacts().iter().all(|contact| contact.warmstart_impulse == 0.0));
}

#[test]
fn another_side_inherits_nothing() {
    let cube = samples::cuboid(Vector::splat(0.5));
    let (mut above, _) = manifolds(&Pose::from_translation(Vector::Y), &*cube, &*cube, 0.01);
    mark(&mut above);
    let (mut beside, _) = manifolds(&Pose::from_translation(Vector::X), &*cube, &*cube, 0.01);
    inherit_impulses(&mut beside, &above);
    assert!(beside[0].contacts().iter().all(|contact| contact.warmstart_impulse == 0.0));
}

#[test]
fn contacts_with_meshes_keep_their_impulses() {
    let mut random = Random(8);
    let (mut recognised_all, mut all) = (0, 0);
    for _ in 0..40 {
        let mesh = samples::shape(samples::MESH, &mut random, 2.0);
        let mut scene = Scene::new(mesh, samples::cuboid(Vector::splat(0.8)));
        let [mesh, cube] = &scene.shapes;
        let pose = just_touching(&**mesh, &**cube, 0.01, &mut random);
        scene.place(pose);
        mark(&mut scene.found);
        scene.place(Pose::from_translation(Vector::splat(1.0e-4)) * pose);
        let count: usize = scene.found.iter().map(|manifold| manifold.contacts().len()).sum();
        let recognised = recognised(&scene.found);
        (recognised_all, all) = (recognised_all + recognised, all + count);
    }
    // In a valley of faces, another one may support the box a moment later.
    assert!(all >= 30 && recognised_all * 10 >= all * 9, "{recognised_all} of {all}");
}
