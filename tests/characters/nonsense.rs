//! Invalid input causes no motion and no damage.

use super::stage::{DT, Walker, level};
use crate::dim::{about_z, cuboid, vec};
use rapier::control::*;
use rapier::prelude::*;

#[test]
fn invalid_translations_times_and_poses_cause_no_motion() {
    let mut walker = Walker::new(level(), vec(0.0, 1.2)).settled();
    for bad in [Real::NAN, Real::INFINITY, Real::NEG_INFINITY, Real::MAX] {
        for desired in [vec(bad, 0.0), vec(0.0, bad), Vector::ONE * bad] {
            assert_eq!(walker.compute(desired), EffectiveCharacterMovement::default(), "{desired}");
        }
    }
    let shape = walker.world.colliders[walker.collider].shape();
    let queries = walker.world.query_pipeline();
    let still = |dt: Real, pose: Pose| {
        let moved = walker.controller.move_shape(dt, &queries, shape, &pose, vec(0.1, 0.0), |_| ());
        assert_eq!(moved, EffectiveCharacterMovement::default());
    };
    for dt in [0.0, -DT, Real::NAN, Real::INFINITY] {
        still(dt, *walker.world.colliders[walker.collider].position());
    }
    still(DT, Pose::from_translation(vec(Real::NAN, 0.0)));
    still(DT, Pose::from_translation(vec(0.0, Real::INFINITY)));
}

/// The change of velocity is finite or absent, whatever the controller, the time step and the target.
#[test]
fn feedback_of_invalid_input_is_a_velocity() {
    let values = crate::suite::hostile::values::EDGES;
    let body = RigidBodyBuilder::dynamic().translation(vec(1.0, 2.0)).linvel(vec(3.0, 4.0)).build();
    let usable = |change: RigidBodyVelocity| {
        assert!(change.linvel.is_finite() && change.angvel.is_finite(), "{change:?}");
    };
    let at = |value: Real| Pose::from_translation(vec(value, value));
    for gain in values {
        for value in values {
            let pd = PdController::new(gain, value, AxesMask::all());
            let vels = RigidBodyVelocity::new(vec(value, gain), about_z(value));
            usable(pd.rigid_body_correction(&body, at(value), vels));
            let mut pid = PidController::new(gain, value, 0.8, AxesMask::all());
            for dt in values {
                usable(pid.rigid_body_correction(dt, &body, at(value), vels));
                assert!(pid.lin_integral.is_finite() && pid.ang_integral.is_finite());
            }
            pid.reset_integrals();
        }
    }
}

#[test]
fn invalid_settings_cause_no_motion() {
    let mut walker = Walker::new(level(), vec(0.0, 1.2)).settled();
    let good = KinematicCharacterController::default();
    let mut settings = Vec::new();
    for up in [Vector::ZERO, Vector::Y * Real::NAN, Vector::Y * Real::INFINITY] {
        settings.push(KinematicCharacterController { up, ..good });
    }
    for bad in [-1.0, Real::NAN, Real::INFINITY] {
        for length in [CharacterLength::Absolute(bad), CharacterLength::Relative(bad)] {
            settings.push(KinematicCharacterController { offset: length, ..good });
            let snap_to_ground = Some(length);
            settings.push(KinematicCharacterController { snap_to_ground, ..good });
            let step = CharacterAutostep { max_height: length, ..Default::default() };
            settings.push(KinematicCharacterController { autostep: Some(step), ..good });
            let step = CharacterAutostep { min_width: length, ..Default::default() };
            settings.push(KinematicCharacterController { autostep: Some(step), ..good });
        }
        settings.push(KinematicCharacterController { normal_nudge_factor: bad, ..good });
    }
    settings.push(KinematicCharacterController { max_slope_climb_angle: Real::NAN, ..good });
    settings.push(KinematicCharacterController { min_slope_slide_angle: Real::NAN, ..good });
    for controller in settings {
        walker.controller = controller;
        assert_eq!(
            walker.compute(vec(0.1, -0.1)),
            EffectiveCharacterMovement::default(),
            "{controller:?}"
        );
    }
}

/// An empty world is free, an up direction may have any length, and angles beyond 90° act as 90°.
#[test]
fn unusual_settings_are_accepted() {
    let mut walker = Walker::new(PhysicsWorld::new(), Vector::ZERO);
    assert_eq!(walker.compute(vec(0.1, -0.1)).translation, vec(0.1, -0.1));
    let mut walker = Walker::new(level(), vec(0.0, 1.2)).settled();
    for length in [1.0e-20, 7.0, 1.0e20] {
        walker.controller.up = Vector::Y * length;
        let movement = walker.compute(vec(0.1, -0.1));
        assert!(movement.grounded && (movement.translation - vec(0.1, 0.0)).length() < 1.0e-4);
    }
    walker.controller.up = Vector::Y;
    for angle in [10.0, -10.0, Real::INFINITY] {
        walker.controller.max_slope_climb_angle = angle;
        assert!(walker.compute(vec(0.1, -0.1)).translation.is_finite());
    }
    walker.controller.offset = CharacterLength::Absolute(0.0);
    assert!(walker.compute(vec(0.1, -0.1)).translation.is_finite());
}

/// A character deep inside an obstacle leaves it within a few calls, or at least stays finite.
#[test]
fn a_buried_character_gets_out() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(cuboid(2.0, 2.0), None);
    let mut walker = Walker::new(world, vec(0.3, 1.5));
    for _ in 0..30 {
        walker.step(Vector::ZERO);
        assert!(walker.place().is_finite());
    }
    assert!(walker.place().y > 2.5 || walker.place().x.abs() > 2.2, "{}", walker.place());
}

/// Random worlds, translations and settings give finite and reproducible results.
#[test]
fn nothing_panics_and_everything_repeats() {
    let mut state = 12345_u64;
    let mut random = move |low: Real, high: Real| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * ((state >> 33) as Real / (1_u64 << 31) as Real)
    };
    for _ in 0..60 {
        let mut world = PhysicsWorld::new();
        for _ in 0..20 {
            let place = vec(random(-3.0, 3.0), random(-3.0, 3.0));
            let size = (random(0.01, 1.0), random(0.01, 1.0));
            let turn = crate::dim::about_z(random(-3.0, 3.0));
            world.insert_collider(cuboid(size.0, size.1).translation(place).rotation(turn), None);
        }
        let mut walker = Walker::new(world, vec(random(-3.0, 3.0), random(-3.0, 3.0)));
        walker.controller.autostep = Some(CharacterAutostep::default());
        walker.controller.slide = random(0.0, 1.0) > 0.2;
        for _ in 0..20 {
            let desired = vec(random(-0.3, 0.3), random(-0.3, 0.1));
            let movement = walker.compute(desired);
            assert!(movement.translation.is_finite());
            assert_eq!(movement, walker.compute(desired));
            let next = walker.place() + movement.translation;
            walker.world.bodies[walker.body].set_next_kinematic_translation(next);
            walker.world.step();
        }
    }
}

/// Every shape can be a character: its motion is finite, and over a level floor it is not zero.
#[test]
fn all_shapes_can_walk() {
    for shape in crate::dim::hostile::shapes(0.5) {
        let mut walker = Walker::of(level(), shape, vec(0.0, 1.0));
        walker.controller.autostep = Some(CharacterAutostep::default());
        for _ in 0..60 {
            walker.step(vec(1.0, 0.0));
            assert!(walker.place().is_finite(), "{}", walker.place());
        }
    }
}

/// Every shape can be an obstacle.
#[test]
fn all_shapes_can_be_obstacles() {
    for shape in crate::dim::hostile::shapes(1.0) {
        let mut world = level();
        world.insert_collider(shape.translation(vec(2.0, 1.0)), None);
        let mut walker = Walker::new(world, vec(0.0, 1.2));
        walker.controller.autostep = Some(CharacterAutostep::default());
        for _ in 0..120 {
            walker.step(vec(2.0, 0.0));
            assert!(walker.place().is_finite(), "{}", walker.place());
        }
    }
}

/// Sizes and positions at the limits of the usual range.
#[test]
fn unusual_sizes_and_positions_are_harmless() {
    for size in [1.0e-6, 1.0e-3, 1.0e3, 1.0e6] {
        for place in [0.0, 1.0e3, 1.0e6] {
            let mut world = PhysicsWorld::new();
            let ground = cuboid(100.0 * size, size).translation(vec(place, -size));
            world.insert_collider(ground, None);
            let shape = ColliderBuilder::capsule_y(size, 0.5 * size);
            let mut walker = Walker::of(world, shape, vec(place, 1.6 * size));
            walker.controller.autostep = Some(CharacterAutostep::default());
            for _ in 0..20 {
                let movement = walker.compute(vec(size, -size) * 0.05);
                assert!(movement.translation.is_finite());
                let next = walker.place() + movement.translation;
                walker.world.bodies[walker.body].set_next_kinematic_translation(next);
                walker.world.step();
            }
        }
    }
}

/// A shape passed to `move_shape` bypasses the checks of a collider. Its sizes may be NaN, on floors of every
/// kind.
#[test]
fn shapes_without_a_size_do_not_panic() {
    for (name, floor) in super::floors::level_floors() {
        let mut world = PhysicsWorld::new();
        for part in floor {
            world.insert_collider(part, None);
        }
        world.step();
        let queries = world.query_pipeline();
        let controller = KinematicCharacterController::default();
        for value in crate::suite::hostile::values::EDGES {
            for shape in
                [SharedShape::ball(value), SharedShape::new(Cuboid::new(Vector::splat(value)))]
            {
                let pose = Pose::from_translation(vec(0.3, 0.4));
                let desired = vec(0.3, -0.1);
                let movement = controller.move_shape(DT, &queries, &*shape, &pose, desired, |_| ());
                assert!(movement.translation.is_finite(), "{value} on {name}");
            }
        }
    }
}
