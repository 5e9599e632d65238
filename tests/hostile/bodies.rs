//! Invalid values for the setters of bodies.

use super::listener::{listen, names};
use super::scene::Scene;
use super::values::{EDGES, edge_vectors};
use crate::dim::{about_z, hostile::broken_rotations, z_of};
use rapier::prelude::*;

/// Name of a setter of a number, body type, the setter, and the getter.
type Knob = (&'static str, RigidBodyType, fn(&mut RigidBody, Real), fn(&RigidBody) -> Real);

const DYNAMIC: RigidBodyType = RigidBodyType::Dynamic;
const KINEMATIC: RigidBodyType = RigidBodyType::KinematicPositionBased;

/// Every setter of a number.
const KNOBS: [Knob; 10] = [
    ("linear damping", DYNAMIC, |b, v| b.set_linear_damping(v), RigidBody::linear_damping),
    ("angular damping", DYNAMIC, |b, v| b.set_angular_damping(v), RigidBody::angular_damping),
    ("gravity scale", DYNAMIC, |b, v| b.set_gravity_scale(v, true), RigidBody::gravity_scale),
    ("soft CCD", DYNAMIC, |b, v| b.set_soft_ccd_prediction(v), RigidBody::soft_ccd_prediction),
    ("angular velocity", DYNAMIC, |b, v| b.set_angvel(about_z(v), true), |b| z_of(b.angvel())),
    ("torque", DYNAMIC, |b, v| b.add_torque(about_z(v), true), |b| z_of(b.user_torque())),
    ("translation", DYNAMIC, |b, v| b.set_translation(Vector::Y * v, true), |b| b.translation().y),
    ("velocity", DYNAMIC, |b, v| b.set_linvel(Vector::Y * v, true), |b| b.linvel().y),
    ("force", DYNAMIC, |b, v| b.add_force(Vector::Y * v, true), |b| b.user_force().y),
    (
        "next translation",
        KINEMATIC,
        |b, v| b.set_next_kinematic_translation(Vector::Y * v),
        |b| b.next_position().translation.y,
    ),
];

/// A number is accepted, or rejected with a message that names it and without any change.
#[test]
fn numbers_are_accepted_or_refused_by_name() {
    for (name, body_type, set, get) in KNOBS {
        let distant = Scene::with_body_type(body_type).distant_in_the_end();
        let untouched = Scene::with_body_type(body_type).all_in_the_end();
        for value in EDGES {
            let mut scene = Scene::with_body_type(body_type);
            let old = get(scene.body());
            let ((), heard) = listen(|| set(scene.body(), value));
            let new = get(scene.body());
            if new == value {
                assert!(heard.is_empty(), "{name} {value}: {heard:?}");
                let end = scene.distant_in_the_end();
                assert!(end == distant, "{name} {value} affects distant bodies");
            } else {
                assert_eq!(new, old, "{name} {value}");
                assert!(heard.iter().any(|text| names(text, value)), "{name} {value}: {heard:?}");
                let end = scene.all_in_the_end();
                assert!(end == untouched, "{name} {value} changed something, though refused");
            }
        }
    }
}

/// Name of an edit of a body by a vector, and the edit.
type Push = (&'static str, fn(&mut RigidBody, Vector));

const PUSHES: [Push; 9] = [
    ("translation", |b, v| b.set_translation(v, true)),
    ("velocity", |b, v| b.set_linvel(v, true)),
    ("velocities", |b, v| b.set_vels(RigidBodyVelocity::new(v, about_z(v.y)), true)),
    ("force", |b, v| b.add_force(v, true)),
    ("force at a point", |b, v| b.add_force_at_point(Vector::ONE, v, true)),
    ("force at itself", |b, v| b.add_force_at_point(v, v, true)),
    ("impulse", |b, v| b.apply_impulse(v, true)),
    ("impulse at a point", |b, v| b.apply_impulse_at_point(Vector::ONE, v, true)),
    ("turning impulse", |b, v| b.apply_torque_impulse(about_z(v.y), true)),
];

/// Returns whether a text names an invalid component of a vector.
fn names_one_of(text: &str, vector: Vector) -> bool {
    vector.to_array().into_iter().any(|value| !value.is_finite() && names(text, value))
}

#[test]
fn no_vector_affects_another_pile() {
    let distant = Scene::new().distant_in_the_end();
    for (name, push) in PUSHES {
        for vector in edge_vectors() {
            let mut scene = Scene::new();
            let ((), heard) = listen(|| push(scene.body(), vector));
            // A vector along x has no moment about x.
            if !vector.is_finite() && (name != "turning impulse" || !vector.y.is_finite()) {
                assert!(heard.iter().any(|text| names_one_of(text, vector)), "{name}: {heard:?}");
            }
            let end = scene.distant_in_the_end();
            assert!(end == distant, "{name} {vector} affects distant bodies");
        }
    }
}

#[test]
fn invalid_rotations_are_rejected() {
    for rotation in broken_rotations() {
        for body_type in [DYNAMIC, KINEMATIC] {
            let untouched = Scene::with_body_type(body_type).all_in_the_end();
            let mut scene = Scene::with_body_type(body_type);
            let pose = Pose::from_parts(Vector::ONE, rotation);
            let body = scene.body();
            let (_, heard) = listen(|| {
                body.set_rotation(rotation, true);
                body.set_position(pose, true);
                body.set_next_kinematic_rotation(rotation);
                body.set_next_kinematic_position(pose);
            });
            let messages = if body_type == KINEMATIC { 4 } else { 2 };
            assert_eq!(heard.len(), messages, "{rotation:?}: {heard:?}");
            assert!(scene.all_in_the_end() == untouched, "{rotation:?} changed something");
        }
    }
}

#[test]
fn invalid_masses_are_rejected() {
    let untouched = Scene::new().all_in_the_end();
    for value in EDGES {
        let mut scene = Scene::new();
        let old = scene.body().mass();
        let ((), heard) = listen(|| scene.body().set_additional_mass(value, true));
        let mass = scene.body().mass();
        assert!(mass.is_finite() && mass >= old, "{value} makes it weigh {mass}");
        let ((), heard_more) = listen(|| {
            let mut part = ColliderBuilder::ball(1.0).build().mass_properties();
            part.inv_mass = value;
            scene.body().set_additional_mass_properties(part, true);
        });
        if value.is_nan() || value.is_infinite() || value < 0.0 {
            let named = |heard: &[String]| heard.iter().any(|text| names(text, value));
            assert!(named(&heard) && named(&heard_more), "{value}: {heard:?} {heard_more:?}");
            assert!(scene.all_in_the_end() == untouched, "{value} changed something");
        } else {
            scene.steps(10);
        }
    }
}

#[test]
fn thresholds_of_sleep_can_be_anything() {
    let distant = Scene::new().distant_in_the_end();
    for value in EDGES {
        let mut scene = Scene::new();
        let activation = scene.body().activation_mut();
        activation.normalized_linear_threshold = value;
        activation.angular_threshold = value;
        activation.time_until_sleep = value;
        activation.time_since_can_sleep = value;
        assert!(scene.distant_in_the_end() == distant, "{value} affects distant bodies");
    }
}

#[test]
fn predictions_of_impossible_times_stay_finite() {
    for value in EDGES {
        let mut scene = Scene::new();
        let body = scene.body();
        body.set_angvel(about_z(3.0), true);
        body.add_force(Vector::Y * 1.0e9, true);
        for vector in edge_vectors() {
            // Any result is valid, but there must be no panic.
            let _ = body.velocity_at_point(vector);
            let _ = body.gravitational_potential_energy(value, vector);
        }
        assert!(body.predict_position_using_velocity(value).is_finite(), "{value}");
        assert!(body.predict_position_using_velocity_and_forces(value).is_finite(), "{value}");
    }
}

/// A number of substeps beyond any reasonable computation time is rejected.
#[test]
fn excessive_substeps_are_rejected() {
    let untouched = Scene::new().all_in_the_end();
    for count in [usize::MAX, usize::MAX / 2, 1_000_000] {
        let mut scene = Scene::new();
        let ((), heard) = listen(|| scene.body().set_additional_solver_iterations(count));
        assert!(heard.iter().any(|text| text.contains(&count.to_string())), "{count}: {heard:?}");
        assert!(scene.all_in_the_end() == untouched);
    }
}
