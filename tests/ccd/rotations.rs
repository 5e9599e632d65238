//! Fast rotations do not skip obstacles.

use crate::dim::{about_z, cuboid, sheet, vec};
use crate::suite::physics::stage::weightless;
use rapier::prelude::*;

/// A part with a thick skin, far from the centre of mass, stops below a ceiling that the body itself does not
/// reach: at the distance of its skin, or at the allowed error of contacts.
#[test]
fn a_thick_skin_meets_a_ceiling() {
    for (skin, height, error) in [(1.0, 1.8, 0.001), (0.3, 1.6, 0.001), (0.0, 1.8, 0.5)] {
        let mut world = weightless(60);
        world.integration_parameters.allowed_linear_error = error;
        world.insert_collider(cuboid(5.0, 0.5).translation(vec(0.0, height + 0.5)), None);
        let body = RigidBodyBuilder::dynamic().linvel(vec(60.0, 0.0)).angvel(about_z(180.0));
        let (body, _) = world.insert(body, ColliderBuilder::ball(0.1));
        let arm = ColliderBuilder::capsule_x(1.0, 0.1).density(0.0).contact_skin(skin);
        world.insert_collider(arm.translation(vec(0.0, -1.0)), Some(body));
        world.step();
        assert_eq!(world.physics_pipeline.counters.ccd.num_substeps, 1, "skin {skin}");
        assert!(world.bodies[body].translation().x < 0.9, "skin {skin}: not stopped");
    }
}

/// A bar of 2 m rotates about a hinge at its middle, past a post of 4 cm.
#[test]
fn a_bar_does_not_skip_a_post() {
    for rate in [30, 60, 240] {
        for speed in [20.0, 60.0, 200.0, 1000.0] {
            for phase in 0..8 {
                let mut world = weightless(rate);
                world.insert_collider(cuboid(0.02, 0.02).translation(vec(0.0, 0.9)), None);
                // The bar starts before the post, within the quarter revolution that leads to it.
                let start = -1.2 + 0.12 * phase as Real;
                let body = RigidBodyBuilder::dynamic().angvel(about_z(speed));
                let body = body.rotation(about_z(start)).angular_damping(0.0);
                let (bar, _) = world.insert(body, cuboid(1.0, 0.02).friction(0.0));
                for _ in 0..20 {
                    world.step();
                    let tip = world.bodies[bar].position().rotation * vec(1.0, 0.0);
                    let at = world.bodies[bar].translation();
                    // The post may push the bar in any direction, but not through itself: the side of the bar
                    // stays in front of the post.
                    if at.length() < 0.05 {
                        assert!(
                            tip.x > -0.1,
                            "{rate} steps/s, {speed} rad/s: passed the post {tip}"
                        );
                    }
                }
            }
        }
    }
}

/// A bar that spins in a closed box with walls of 2 cm stays inside.
#[test]
fn spinners_stay_in_their_box() {
    for speed in [20.0, 100.0, 400.0, 1000.0] {
        for phase in 0..8 {
            let mut world = weightless(60);
            for side in 0..4 {
                let turned = about_z(core::f64::consts::FRAC_PI_2 as Real * side as Real);
                let place = Pose::new(vec(0.0, 0.0), turned) * vec(0.0, 1.0);
                let wall = cuboid(500.0, 0.01).translation(place).rotation(turned);
                world.insert_collider(wall, None);
            }
            let start = 0.1 * phase as Real;
            let body =
                RigidBodyBuilder::dynamic().angvel(about_z(speed)).linvel(vec(0.1 * speed, 3.0));
            let body = body.rotation(about_z(start)).angular_damping(0.0);
            let (bar, _) = world.insert(body, cuboid(0.5, 0.02).restitution(1.0));
            for step in 0..120 {
                world.step();
                let at = world.bodies[bar].translation();
                let out = at.x.abs().max(at.y.abs());
                assert!(
                    out < 1.0,
                    "{speed} rad/s from {start}: out of the box at {at} in step {step}"
                );
            }
        }
    }
}

/// A bar hits the ground, and its rotation takes the touching end away at 11 m/s while its middle still falls
/// at 94 m/s. It is not held in flight, however deep that end is, and neither if it rotates the other way.
#[test]
fn bars_are_not_held_while_their_ends_leave_the_ground() {
    let [half_length, half_width, tilt] = [0.4, 0.02, 0.53 as Real];
    let (sin, cos) = tilt.sin_cos();
    let arm = half_width * sin - half_length * cos;
    let away = (11.0 + 94.0) / arm;
    let grounds = [cuboid(500.0, 1.0).translation(vec(0.0, -1.0)), sheet(500.0)];
    for (ground, spin) in grounds.iter().flat_map(|ground| [(ground, away), (ground, -away)]) {
        for depth in (0..200).map(|k| 1.0e-4 * k as Real) {
            let mut world = weightless(60);
            world.insert_collider(ground.clone(), None);
            let start = vec(0.0, half_length * sin + half_width * cos - depth);
            let body = RigidBodyBuilder::dynamic().translation(start).rotation(about_z(tilt));
            let body = body.linvel(vec(0.0, -94.0)).angvel(about_z(spin));
            let (bar, _) = world.insert(body, cuboid(half_length, half_width));
            (0..5).for_each(|_| world.step());
            let before = world.bodies[bar].translation();
            (0..10).for_each(|_| world.step());
            // At the end it lies, or has left the ground.
            let (place, speed) =
                (world.bodies[bar].translation(), world.bodies[bar].linvel().length());
            let is_held = place == before && speed > 1.0;
            assert!(!is_held, "{spin} rad/s, {depth} deep: held at {place} with {speed} m/s");
        }
    }
}

/// A free rotation keeps its speed: there is no largest angular velocity.
#[test]
fn free_turns_are_not_capped() {
    let dt = 1.0 / 60.0;
    for speed in [10.0, 47.0, 100.0, 150.0] {
        let mut world = weightless(60);
        let body = RigidBodyBuilder::dynamic().angvel(about_z(speed));
        let (ball, _) = world.insert(body, ColliderBuilder::ball(0.5));
        world.step();
        let turned = crate::dim::turned_about_z(&world.bodies[ball].rotation().clone());
        let full = 2.0 * core::f64::consts::PI as Real;
        let expected = speed * dt;
        let difference = (turned - expected) / full;
        let off = (difference - difference.round()).abs() * full;
        // The error is of fifth order: for a quarter revolution in rotations of half a radian, (0.5)⁵/80 of
        // each half.
        assert!(off < 1.0e-3 * expected, "{speed} rad/s turned by {turned}, not by {expected}");
    }
}
