//! Every way in which a body's numbers can overflow.

use super::stage::{Stage, experiment};
use crate::dim::{about_z, vec};
use rapier::prelude::*;

/// Checks that the suspect alone is disabled, for this cause. Returns the step.
fn suspect_is_disabled(
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
fn an_overflowing_force() {
    for force in [1.0e20, 1.0e30, 0.3 * Real::MAX] {
        let force = vec(force, 0.0);
        let cause = QuarantineCause::Force { force, torque: Default::default() };
        let step = suspect_is_disabled(
            |stage| stage.suspect().add_force(force, true),
            |found| found == cause,
        );
        assert_eq!(step, 0);
    }
}

/// The largest speed limits the effect of forces and edited velocities before positions change. The force
/// alone would move the body beyond the range of positions in one step. Above the heap nothing slows the body
/// down, so it ends with the largest speed.
#[test]
fn the_largest_speed_prevents_an_overflow() {
    let edits: [fn(&mut RigidBody); 2] = [
        |body| body.add_force(vec(1.0e18, 0.0), true),
        |body| body.set_linvel(vec(9.0e14, 0.0), true),
    ];
    for edit in edits {
        let mut stage = Stage::new();
        stage.world.integration_parameters.normalized_max_linear_velocity = 100.0;
        stage.suspect().set_translation(vec(0.0, 100.0), true);
        edit(stage.suspect());
        let events = stage.step();
        assert!(events.quarantines.is_empty(), "{:?}", events.quarantines);
        let speed = stage.suspect().linvel().length();
        assert!((99.9..100.1).contains(&speed), "{speed}");
    }
}

#[test]
fn an_overflowing_torque() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Force { .. });
    suspect_is_disabled(|stage| stage.suspect().add_torque(about_z(1.0e25), true), is_cause);
}

/// Each of these forces alone is within range.
#[test]
fn forces_that_add_up() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Force { .. });
    let pull = |stage: &mut Stage| {
        (0..1000).for_each(|_| stage.suspect().add_force(Vector::Y * 1.0e15, true));
    };
    suspect_is_disabled(pull, is_cause);
}

/// The force overflows after some steps.
#[test]
fn a_speed_that_grows() {
    let step = suspect_is_disabled(
        |stage| stage.suspect().add_force(Vector::Y * 1.0e16, true),
        |cause| matches!(cause, QuarantineCause::Velocity(_) | QuarantineCause::Force { .. }),
    );
    // v = F t / m = 1e15 after m / 10 s, and m is about 1.
    assert!((1..30).contains(&step), "{step}");
}

#[test]
fn overflowing_gravity() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Gravity(_));
    suspect_is_disabled(|stage| stage.suspect().set_gravity_scale(-1.0e20, true), is_cause);
}

/// A valid velocity may lead out of the world: here after a second.
#[test]
fn a_velocity_that_leads_out_of_the_world() {
    let step = suspect_is_disabled(
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
    // The world is large enough for the lower speed: 120 steps of 10 s at 1e9 are 1.2e12.
    for (speed, leads_out) in [(3.0e14, true), (1.0e9, false)] {
        let taken = experiment(|stage| {
            stage.world.integration_parameters.dt = 10.0;
            stage.suspect().set_position(Pose::from_translation(Vector::Y * 50.0), true);
            stage.suspect().set_linvel(Vector::Y * speed, true);
        });
        // A chain of links diverges in such steps, and is disabled as well.
        let links = Stage::new().links;
        let others: Vec<_> = taken.iter().filter(|(_, body, _)| !links.contains(body)).collect();
        let found = matches!(others[..], [(0, body, cause)] if *body == Stage::new().suspect && is_cause(*cause));
        assert!(found == leads_out && others.len() <= 1, "{speed}: {taken:?}");
    }
}

/// A body at the edge of the world moves outwards.
#[test]
fn a_place_at_the_edge() {
    let edge = Pose::from_translation(vec(-1.0e15, 1.0));
    let mistreat = |stage: &mut Stage| {
        stage.suspect().set_position(edge, true);
        stage.suspect().set_linvel(vec(-1.0e12, 0.0), true);
    };
    let is_cause = |cause| matches!(cause, QuarantineCause::Velocity(_));
    assert_eq!(suspect_is_disabled(mistreat, is_cause), 0);
}

/// Setters reject values that are not finite or beyond the world, so no body is disabled.
#[test]
fn rejected_values_have_no_effect() {
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

/// A body is replaced by another one, which brings its force along.
#[test]
fn a_body_swapped_for_another() {
    let is_cause = |cause| matches!(cause, QuarantineCause::Force { .. });
    suspect_is_disabled(
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

/// A diverged body hits and wakes no other body in its last step.
#[test]
fn neighbours_of_a_diverged_body_sleep_on() {
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
    suspect_is_disabled(mistreat, |cause| matches!(cause, QuarantineCause::Force { .. }));
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

/// Gravity overflows: all moving bodies are disabled, with one event each.
#[test]
fn gravity_that_disables_all_bodies() {
    let taken = experiment(|stage| {
        stage.world.gravity = Vector::X * 1.0e15;
        stage.world.integration_parameters.dt = 10.0;
        stage.world.wake_up_all(true);
    });
    let dynamic = Stage::new().world.bodies.iter().filter(|(_, body)| body.is_dynamic()).count();
    assert_eq!(taken.len(), dynamic);
    assert!(taken.iter().all(|(step, ..)| *step == 0));
}
