//! Invalid parameters of a step, and invalid gravity.

use super::listener::{listen, names};
use super::scene::Scene;
use super::values::{EDGES, NOT_FINITE, edge_vectors};
use rapier::prelude::*;

/// Name of a field of the parameters, and its setter.
type Field = (&'static str, fn(&mut IntegrationParameters, Real));

const FIELDS: [Field; 15] = [
    ("dt", |p, v| p.dt = v),
    ("erp", |p, v| p.erp = v),
    ("damping_ratio", |p, v| p.damping_ratio = v),
    ("joint_erp", |p, v| p.joint_erp = v),
    ("joint_damping_ratio", |p, v| p.joint_damping_ratio = v),
    ("allowed_linear_error", |p, v| p.allowed_linear_error = v),
    ("length_unit", |p, v| p.length_unit = v),
    ("normalized_prediction_distance", |p, v| p.normalized_prediction_distance = v),
    ("normalized_max_corrective_velocity", |p, v| p.normalized_max_corrective_velocity = v),
    ("normalized_max_linear_velocity", |p, v| p.normalized_max_linear_velocity = v),
    ("normalized_contact_recycle_distance", |p, v| p.normalized_contact_recycle_distance = v),
    ("normalized_restitution_velocity_threshold", |p, v| {
        p.normalized_restitution_velocity_threshold = v;
    }),
    ("warmstart_coefficient", |p, v| p.warmstart_coefficient = v),
    ("min_ccd_dt", |p, v| p.min_ccd_dt = v),
    ("dt", |p, v| p.dt = -v.abs()),
];

/// A step is rejected as a whole, with the field and the value in the log, or keeps all invariants.
#[test]
fn each_number_is_refused_by_name_or_survived() {
    let mut still = Scene::new();
    still.world.integration_parameters.dt = Real::NAN;
    let untouched = still.all_in_the_end();
    for (name, set) in FIELDS {
        for value in EDGES {
            let mut scene = Scene::new();
            set(&mut scene.world.integration_parameters, value);
            let valid = scene.world.integration_parameters.validate();
            let ((), heard) = listen(|| scene.world.step());
            if let Err(error) = valid {
                assert_eq!(error.field, name);
                assert!(names(&error.to_string(), error.value), "{name} {value}: {error}");
                let reported = heard.iter().any(|text| text.contains(&error.to_string()));
                assert!(reported, "{name} {value}: {heard:?}");
                assert!(scene.all_in_the_end() == untouched, "{name} {value} changed something");
                rejected_by_collision_detection_too(&mut scene, &error);
            } else {
                scene.steps(10);
            }
            if !value.is_finite() && value != Real::INFINITY {
                assert!(valid.is_err(), "{name} {value} is accepted");
            }
        }
    }
}

fn rejected_by_collision_detection_too(scene: &mut Scene, error: &InvalidParameters) {
    let ((), heard) = listen(|| scene.world.detect_collisions(&(), &()));
    assert!(heard.iter().any(|text| text.contains(&error.to_string())), "{error}: {heard:?}");
}

#[test]
fn excessive_iterations_are_rejected_by_name() {
    type Counter = (&'static str, fn(&mut IntegrationParameters, usize));
    let fields: [Counter; 4] = [
        ("num_solver_iterations", |p, n| p.num_solver_iterations = n),
        ("num_internal_pgs_iterations", |p, n| p.num_internal_pgs_iterations = n),
        ("num_additional_friction_iterations", |p, n| p.num_additional_friction_iterations = n),
        ("max_ccd_substeps", |p, n| p.max_ccd_substeps = n),
    ];
    for (name, set) in fields {
        for count in [usize::MAX, 1_000_000] {
            let mut scene = Scene::new();
            set(&mut scene.world.integration_parameters, count);
            let error = scene.world.integration_parameters.validate().unwrap_err();
            assert!(error.to_string().contains(name), "{error}");
            let ((), heard) = listen(|| scene.world.step());
            assert!(heard.iter().any(|text| text.contains(&error.to_string())), "{heard:?}");
        }
    }
    let mut scene = Scene::new();
    scene.world.integration_parameters.num_solver_iterations = 0;
    assert!(scene.world.integration_parameters.validate().is_err());
    assert!(scene.world.integration_parameters.substep() > 0.0);
    scene.steps(2);
}

/// Zero neighbours of the same size are allowed, and so is any larger number.
#[test]
fn any_number_of_neighbours_is_a_limit() {
    let expected = Scene::new().all_in_the_end();
    for most in [3, usize::MAX / 2, usize::MAX / 2 + 1, usize::MAX] {
        let mut scene = Scene::new();
        scene.world.integration_parameters.max_neighbors_per_collider = most;
        scene.world.bodies.iter_mut().for_each(|(_, body)| body.wake_up(false));
        assert!(scene.all_in_the_end() == expected, "{most} is a limit for piles of three");
    }
    let mut scene = Scene::new();
    scene.world.integration_parameters.max_neighbors_per_collider = 0;
    scene
        .world
        .insert(RigidBodyBuilder::dynamic().translation(Vector::Y), ColliderBuilder::ball(0.5));
    scene.steps(10);
}

#[test]
fn setters_of_the_time_step_keep_the_old_one() {
    for value in NOT_FINITE.into_iter().chain([-1.0, Real::MAX, Real::MIN_POSITIVE]) {
        let mut params = IntegrationParameters::default();
        let error = params.set_dt(value).unwrap_err();
        assert!(names(&error.to_string(), value), "{error}");
        assert_eq!(params, IntegrationParameters::default());
    }
    for value in [Real::NAN, -1.0, Real::MAX, Real::MIN_POSITIVE] {
        let mut params = IntegrationParameters::default();
        assert!(params.set_inv_dt(value).is_err(), "{value}");
        assert_eq!(params, IntegrationParameters::default());
    }
}

/// Gravity acts on all bodies, so this test has no unaffected body.
#[test]
fn invalid_gravity_is_rejected_by_name() {
    let mut still = Scene::new();
    still.world.gravity = Vector::NAN;
    let untouched = still.all_in_the_end();
    for vector in edge_vectors() {
        let mut scene = Scene::new();
        scene.world.gravity = vector;
        let ((), heard) = listen(|| scene.steps(1));
        if vector.is_finite() && vector.abs().max_element() <= 1.0e15 {
            scene.steps(20);
        } else {
            let named = vector.to_array().iter().any(|v| heard.iter().any(|text| names(text, *v)));
            assert!(named, "{vector}: {heard:?}");
            assert!(scene.all_in_the_end() == untouched, "{vector} changed something");
        }
    }
}

/// The simulation recovers with the parameters.
#[test]
fn the_simulation_continues_after_rejected_steps() {
    let expected = Scene::new().all_in_the_end();
    let mut scene = Scene::new();
    let good = scene.world.integration_parameters;
    for (_, set) in FIELDS {
        set(&mut scene.world.integration_parameters, Real::NAN);
        scene.world.step();
        scene.world.integration_parameters = good;
    }
    assert!(scene.all_in_the_end() == expected, "refused steps left something behind");
}
