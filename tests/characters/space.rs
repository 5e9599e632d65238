//! Scenes of 3D only: turntables, corners of three sides, stairs at an angle.

use crate::suite::characters::stage::{CAPSULE, DT, FOOT, GAP_TOLERANCE, OFFSET, Walker, level};
use rapier::control::*;
use rapier::prelude::*;

/// Rides a turntable at 2 rad/s for ten seconds, 2 from its middle. Returns the worst deviations of the
/// distance from the middle and of the gap.
pub fn turntable() -> (Real, Real) {
    let mut world = PhysicsWorld::new();
    let table = RigidBodyBuilder::kinematic_velocity_based().angvel(Vector::Y * 2.0);
    world.insert(table, ColliderBuilder::cylinder(0.5, 4.0));
    let mut walker = Walker::new(world, Vector::new(2.0, 0.5 + FOOT + OFFSET, 0.0));
    walker.rides = true;
    let radius = |walker: &Walker| Vector::new(walker.place().x, 0.0, walker.place().z).length();
    let (before, mut off, mut worst) = (radius(&walker), 0.0, 0.0);
    for _ in 0..600 {
        let movement = walker.step(Vector::ZERO);
        assert!(movement.grounded, "left the table");
        off = (radius(&walker) - before).abs().max(off);
        worst = (walker.feet() - 0.5 - OFFSET).abs().max(worst);
    }
    (off, worst)
}

/// The displacement follows the arc. A chord would move the character outwards by `r (ω dt)² / 2` in each
/// step: 0.7 in ten seconds.
#[test]
fn turntables_carry_round() {
    let (off, gap) = turntable();
    assert!(off < 1.0e-3, "wandered by {off}");
    assert!(gap < GAP_TOLERANCE, "gap off by {gap}");
}

/// In a corner of two walls and the floor, the motion ends and stays ended.
#[test]
fn corners_of_three_sides_hold_still() {
    for degrees in [90.0, 60.0, 30.0] {
        let mut world = level();
        let half: Real = Real::to_radians(0.5 * degrees);
        for side in [-1.0, 1.0] {
            let turn = Rotation::from_scaled_axis(Vector::Y * (half * side));
            let place = turn * Vector::new(-10.0, 4.0, -side);
            let wall = ColliderBuilder::cuboid(12.0, 5.0, 1.0).translation(place);
            world.insert_collider(wall.rotation(turn.to_scaled_axis()), None);
        }
        let mut walker = Walker::new(world, Vector::new(-6.0, 1.2, 0.0));
        for step in 0..400 {
            let movement = walker.step(Vector::new(2.5, 0.0, 0.3));
            assert!(step < 30 || movement.grounded, "{degrees}°: left the ground");
            let still = movement.translation.length() < 1.0e-6;
            assert!(step < 300 || still, "{degrees}°: moves by {}", movement.translation);
        }
        assert!(walker.place().x < -0.3, "{degrees}°: got through, to {}", walker.place());
    }
}

/// Along a wall, pressing against it at 45°, the tangential part of the velocity remains.
#[test]
fn characters_slide_along_walls() {
    let mut world = level();
    let wall = ColliderBuilder::cuboid(50.0, 5.0, 1.0).translation(Vector::new(0.0, 5.0, 1.5));
    world.insert_collider(wall, None);
    let mut walker = Walker::new(world, Vector::new(0.0, 1.2, 0.0));
    walker.steps(60, Vector::new(0.0, 0.0, 2.0));
    let before = walker.place();
    for _ in 0..120 {
        let movement = walker.step(Vector::new(3.0, 0.0, 3.0));
        assert!((movement.translation.x / (3.0 * DT) - 1.0).abs() < 1.0e-3, "{movement:?}");
    }
    assert!((walker.place().z - before.z).abs() < GAP_TOLERANCE);
    assert!((walker.place().z - (0.5 - CAPSULE.1 - OFFSET)).abs() < GAP_TOLERANCE);
}

/// Stairs at an angle of 45° are climbed as well as straight ones.
#[test]
fn stairs_at_an_angle_are_climbed() {
    let mut world = level();
    for i in 0..6 {
        let height = 0.2 * (i + 1) as Real;
        let place = Vector::new(1.0 + 0.35 * i as Real + 10.0, 0.5 * height, 0.0);
        let step = ColliderBuilder::cuboid(10.0, 0.5 * height, 10.0).translation(place);
        world.insert_collider(step, None);
    }
    let mut walker = Walker::new(world, Vector::new(0.0, 1.2, -3.0));
    walker.controller.autostep = Some(CharacterAutostep {
        max_height: CharacterLength::Absolute(0.3),
        min_width: CharacterLength::Absolute(0.25),
        include_dynamic_bodies: true,
    });
    walker.steps(30, Vector::ZERO);
    for _ in 0..150 {
        let movement = walker.step(Vector::new(2.0, 0.0, 2.0));
        assert!(movement.grounded, "left the ground at {}", walker.place());
    }
    assert!((walker.feet() - 1.2 - OFFSET).abs() < GAP_TOLERANCE, "{}", walker.place());
}
