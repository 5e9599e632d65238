//! Invalid values for the setters of colliders.

use super::listener::{listen, names};
use super::scene::Scene;
use super::values::{EDGES, SHAPE_MAX, edge_vectors};
use crate::dim::{about_z, hostile::broken_rotations};
use rapier::prelude::*;

/// Name of a setter of a number, the setter, and the getter.
type Knob = (&'static str, fn(&mut Collider, Real), fn(&Collider) -> Real);

const KNOBS: [Knob; 7] = [
    ("friction", |c, v| c.set_friction(v), Collider::friction),
    ("restitution", |c, v| c.set_restitution(v), Collider::restitution),
    ("contact skin", |c, v| c.set_contact_skin(v), Collider::contact_skin),
    ("density", |c, v| c.set_density(v), Collider::density),
    ("mass", |c, v| c.set_mass(v), Collider::mass),
    (
        "threshold",
        |c, v| c.set_contact_force_event_threshold(v),
        Collider::contact_force_event_threshold,
    ),
    (
        "translation on its body",
        |c, v| c.set_translation_wrt_parent(Vector::Y * v),
        |c| c.position_wrt_parent().map_or(0.0, |pose| pose.translation.y),
    ),
];

/// Largest coordinate that keeps the collider away from the second pile.
const COORDINATE: Real = 900.0;

#[test]
fn numbers_are_accepted_or_refused_by_name() {
    let distant = Scene::new().distant_in_the_end();
    let untouched = Scene::new().all_in_the_end();
    for (name, set, get) in KNOBS {
        for value in EDGES {
            let mut scene = Scene::new();
            let old = get(scene.collider());
            let ((), heard) = listen(|| set(scene.collider(), value));
            let new = get(scene.collider());
            if new == value {
                assert!(heard.is_empty(), "{name} {value}: {heard:?}");
                let end = scene.distant_in_the_end();
                let reaches_them = name == "contact skin" && value > COORDINATE;
                assert!(end == distant || reaches_them, "{name} {value} affects distant bodies");
            } else {
                assert_eq!(new, old, "{name} {value}");
                assert!(heard.iter().any(|text| names(text, value)), "{name} {value}: {heard:?}");
                let end = scene.all_in_the_end();
                assert!(end == untouched, "{name} {value} changed something, though refused");
            }
        }
    }
}

/// A ground without a body is moved.
#[test]
fn a_collider_without_body_stays_at_valid_positions() {
    let mut other = Scene::new();
    other.steps(3);
    let distant = other.distant_in_the_end();
    for vector in edge_vectors() {
        let mut scene = Scene::new();
        let wall = ColliderBuilder::ball(0.5).translation(Vector::Y * 2.0);
        let wall = scene.world.insert_collider(wall, None);
        scene.steps(3);
        let ((), heard) = listen(|| scene.world.colliders[wall].set_translation(vector));
        let taken = scene.world.colliders[wall].translation() == vector;
        let named = vector.to_array().iter().any(|v| heard.iter().any(|text| names(text, *v)));
        assert!(taken == heard.is_empty() && (taken || named), "{vector}: {heard:?}");
        assert!(scene.distant_in_the_end() == distant, "{vector} affects distant bodies");
    }
}

#[test]
fn invalid_rotations_are_rejected() {
    let untouched = Scene::new().all_in_the_end();
    for rotation in broken_rotations() {
        let mut scene = Scene::new();
        let pose = Pose::from_parts(Vector::ONE, rotation);
        let ground = scene.ground;
        let (_, heard) = listen(|| {
            scene.collider().set_position_wrt_parent(pose);
            scene.world.colliders[ground].set_rotation(rotation);
            scene.world.colliders[ground].set_position(pose);
        });
        assert_eq!(heard.len(), 3, "{rotation:?}: {heard:?}");
        assert!(scene.all_in_the_end() == untouched, "{rotation:?} changed something");
    }
    for angle in [Real::NAN, Real::INFINITY] {
        let mut scene = Scene::new();
        let turn = || scene.collider().set_rotation_wrt_parent(about_z(angle));
        assert!(!listen(turn).1.is_empty(), "{angle}");
        assert!(scene.all_in_the_end() == untouched, "{angle} changed something");
    }
}

/// `shape_mut` lets the user change numbers without the engine's checks.
#[test]
fn a_broken_shape_disables_its_collider_only() {
    let mut other = Scene::new();
    other.steps(4);
    let distant = other.distant_in_the_end();
    for value in EDGES {
        let mut scene = Scene::new();
        scene.collider().set_shape(SharedShape::ball(0.5));
        scene.steps(2);
        let ball = scene.collider().shape_mut().as_ball_mut();
        ball.unwrap().radius = value;
        // Before the next step, queries of the shape must not panic.
        let collider = scene.collider();
        let _ = (collider.mass(), collider.volume(), collider.density());
        let _ = (collider.compute_aabb(), collider.mass_properties());
        let mut body = scene.body().clone();
        body.recompute_mass_properties_from_colliders(&scene.world.colliders);
        assert!(body.mass().is_finite(), "{value}");

        let ((), heard) = listen(|| scene.steps(2));
        let possible = value == 0.0 || (1.0e-15..=SHAPE_MAX).contains(&value);
        // A ball of the world's size may overflow its body's numbers.
        let quarantined = possible && scene.body().quarantine().is_some();
        assert_eq!(scene.collider().is_enabled(), possible && !quarantined, "{value}");
        if !possible {
            assert!(heard.iter().any(|text| names(text, value)), "{value}: {heard:?}");
        }
        let end = scene.distant_in_the_end();
        assert!(
            end == distant || (possible && value > COORDINATE),
            "{value} affects distant bodies"
        );
    }
}

#[test]
fn invalid_shapes_and_masses_are_rejected() {
    let untouched = Scene::new().all_in_the_end();
    let is_size = |v: &Real| *v == 0.0 || (1.0e-15..=SHAPE_MAX).contains(v);
    for value in EDGES.into_iter().filter(|v| !is_size(v)) {
        let mut scene = Scene::new();
        let ((), heard) = listen(|| scene.collider().set_shape(SharedShape::ball(value)));
        assert!(heard.iter().any(|text| names(text, value)), "{value}: {heard:?}");
        assert!(scene.all_in_the_end() == untouched, "a ball of {value} changed something");
    }
    for value in [Real::NAN, Real::INFINITY, -1.0] {
        let mut scene = Scene::new();
        let mut mass = scene.collider().mass_properties();
        mass.inv_mass = value;
        let ((), heard) = listen(|| scene.collider().set_mass_properties(mass));
        assert!(heard.iter().any(|text| names(text, value)), "{value}: {heard:?}");
        assert!(scene.all_in_the_end() == untouched, "a mass of {value} changed something");
    }
}
