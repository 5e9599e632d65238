//! Every road on which a body can leave the range of numbers by itself.

use super::stage::{Stage, experiment};
use crate::dim::{about_z, vec};
use rapier::prelude::*;

/// The suspect alone is taken out, for this cause. Returns when.
fn suspect_falls(
    mistreat: impl Fn(&mut Stage),
    is_cause: impl Fn(QuarantineCause) -> bool,
) -> usize {
    let suspect = Stage::new().suspect;
    let taken = experiment(mistreat);
    let [(step, body, cause)] = taken[..] else { panic!("{taken:?}") };
    assert_eq!(body, suspect);
    assert!(is_cause(cause), "{cause:?}");
    step
}

#[test]
fn a_force_beyond_all_measure() {
    for force in [1.0e20, 1.0e30, 0.3 * Real::MAX] {
        let force = vec(force, 0.0);
        let cause = QuarantineCause::Force { force, torque: Default::default() };
        let step =
            suspect_falls(|stage| stage.suspect().add_force(force, true), |found| found == cause);
        assert_eq!(step, 0);
    }
}

#[test]
fn a_torque_beyond_all_measure() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Force { .. });
    suspect_falls(|stage| stage.suspect().add_torque(about_z(1.0e25), true), is_cause);
}

/// Each of these forces could be borne.
#[test]
fn forces_that_add_up() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Force { .. });
    let pull = |stage: &mut Stage| {
        (0..1000).for_each(|_| stage.suspect().add_force(Vector::Y * 1.0e15, true));
    };
    suspect_falls(pull, is_cause);
}

/// A force that takes some steps.
#[test]
fn a_speed_that_grows() {
    let step = suspect_falls(
        |stage| stage.suspect().add_force(Vector::Y * 1.0e16, true),
        |cause| matches!(cause, QuarantineCause::Velocity(_) | QuarantineCause::Force { .. }),
    );
    // v = F t / m = 1e15 after m / 10 s, and m is 1 or so.
    assert!((1..30).contains(&step), "{step}");
}

#[test]
fn gravity_beyond_all_measure() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Gravity(_));
    suspect_falls(|stage| stage.suspect().set_gravity_scale(-1.0e20, true), is_cause);
}

/// An accepted velocity may still lead out of the world: here after a second.
#[test]
fn a_velocity_that_leads_out_of_the_world() {
    let step = suspect_falls(
        |stage| {
            stage.suspect().set_position(Pose::from_translation(Vector::Y * 50.0), true);
            stage.suspect().set_linvel(Vector::Y * 1.0e15, true);
        },
        |cause| matches!(cause, QuarantineCause::Velocity(_)),
    );
    assert!((58..=60).contains(&step), "{step}");
}

#[test]
fn a_step_of_ten_seconds_at_great_speed() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Velocity(_));
    // Fast, but the world is large: 120 steps of 10 s at 1e9 are 1.2e12.
    for (speed, leads_out) in [(3.0e14, true), (1.0e9, false)] {
        let taken = experiment(|stage| {
            stage.world.integration_parameters.dt = 10.0;
            stage.suspect().set_position(Pose::from_translation(Vector::Y * 50.0), true);
            stage.suspect().set_linvel(Vector::Y * speed, true);
        });
        // A chain of links does not find its way in such steps, and goes too.
        let links = Stage::new().links;
        let others: Vec<_> = taken.iter().filter(|(_, body, _)| !links.contains(body)).collect();
        let found = matches!(others[..], [(0, body, cause)] if *body == Stage::new().suspect && is_cause(*cause));
        assert!(found == leads_out && others.len() <= 1, "{speed}: {taken:?}");
    }
}

/// A body at the edge of the world that moves on.
#[test]
fn a_place_at_the_edge() {
    let edge = Pose::from_translation(vec(-1.0e15, 1.0));
    let mistreat = |stage: &mut Stage| {
        stage.suspect().set_position(edge, true);
        stage.suspect().set_linvel(vec(-1.0e12, 0.0), true);
    };
    let is_cause = |cause| matches!(cause, QuarantineCause::Velocity(_));
    assert_eq!(suspect_falls(mistreat, is_cause), 0);
}

/// Setters refuse values that are not finite, or beyond the world: no body is disabled.
#[test]
fn what_setters_refuse_leads_nowhere() {
    for value in [1.0e30, Real::INFINITY, Real::NAN] {
        let taken = experiment(|stage| {
            stage.suspect().set_linvel(Vector::X * value, true);
            stage.suspect().set_angvel(about_z(value), true);
            stage.suspect().set_translation(Vector::X * value, true);
            stage.suspect().apply_impulse(Vector::X * value, true);
        });
        assert_eq!(taken, []);
    }
}

/// One body is put in the place of another, and takes its force along.
#[test]
fn a_body_swapped_for_another() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Force { .. });
    suspect_falls(
        |stage| {
            let mut other = stage.world.bodies[stage.neighbour].clone();
            other.add_force(Vector::X * 1.0e30, true);
            let at = *stage.suspect().position();
            other.set_position(at, true);
            core::mem::swap(stage.suspect(), &mut other);
        },
        is_cause,
    );
}

/// A diverged body hits nothing and wakes nothing in its last step.
#[test]
fn who_falls_asleep_beside_it_sleeps_on() {
    let mistreat = |stage: &mut Stage| {
        let above = *stage.world.bodies[stage.sleeper].position();
        let touching = above * Pose::from_translation(Vector::Y * 0.99);
        stage.suspect().set_position(touching, true);
        stage.suspect().add_force(Vector::X * 1.0e30, true);
    };
    let mut stage = Stage::new();
    mistreat(&mut stage);
    stage.step();
    assert!(stage.world.bodies[stage.sleeper].is_sleeping());
    suspect_falls(mistreat, |cause| matches!(cause, QuarantineCause::Force { .. }));
}

#[test]
fn a_kinematic_body_with_an_impossible_target() {
    let taken = experiment(|stage| {
        stage.world.integration_parameters.dt = 1.0e-9;
        let far = Pose::from_translation(Vector::Y * 1.0e10);
        stage.world.bodies[stage.lift].set_next_kinematic_position(far);
    });
    let [(0, body, QuarantineCause::KinematicTarget(_))] = taken[..] else { panic!("{taken:?}") };
    assert_eq!(body, Stage::new().lift);
}

/// An impossible load: all moving bodies are disabled, with one event each.
#[test]
fn gravity_that_nobody_can_bear() {
    let taken = experiment(|stage| {
        stage.world.gravity = Vector::X * 1.0e15;
        stage.world.integration_parameters.dt = 10.0;
        stage.world.wake_up_all(true);
    });
    let dynamic = Stage::new().world.bodies.iter().filter(|(_, body)| body.is_dynamic()).count();
    assert_eq!(taken.len(), dynamic);
    assert!(taken.iter().all(|(step, ..)| *step == 0));
}
