//! "My character sticks to walls", "it trembles in corners", "it gets stuck in corridors", "it is pushed
//! through the wall".

use super::stage::{CAPSULE, DT, GAP_TOLERANCE, OFFSET, Walker, level};
use crate::dim::{about_z, cuboid, vec};
use rapier::prelude::*;

/// Returns the centre of a capsule at the offset from a wall with its side at `x`.
fn at_wall(x: Real) -> Real {
    x - CAPSULE.1 - OFFSET
}

fn wall(world: &mut PhysicsWorld, left_side: Real) -> ColliderHandle {
    world.insert_collider(cuboid(1.0, 20.0).translation(vec(left_side + 1.0, 19.0)), None)
}

#[test]
fn walking_into_a_wall_ends_at_the_offset() {
    for speed in [1.0, 5.0, 300.0] {
        let mut world = level();
        wall(&mut world, 3.0);
        let mut walker = Walker::new(world, vec(0.0, 1.2)).settled();
        walker.steps(240, vec(speed, 0.0));
        let x = walker.place().x;
        assert!((x - at_wall(3.0)).abs() < GAP_TOLERANCE, "at {x}, not {}", at_wall(3.0));
        for _ in 0..60 {
            assert_eq!(walker.step(vec(speed, 0.0)).translation, Vector::ZERO);
        }
    }
}

/// Flight along a wall, pressing against it, keeps the tangential part of the speed.
#[test]
fn walls_remove_the_normal_component_alone() {
    for degrees in [0.0, 20.0, -20.0] {
        let angle = Real::to_radians(degrees);
        let (along, away) = (vec(-angle.sin(), angle.cos()), vec(-angle.cos(), -angle.sin()));
        let mut world = PhysicsWorld::new();
        world.insert_collider(
            cuboid(1.0, 50.0).translation(away * -1.0).rotation(about_z(angle)),
            None,
        );
        let ball = ColliderBuilder::ball(0.3);
        let mut walker = Walker::of(world, ball, away * 0.5);
        walker.controller.up = along;
        let desired = along * 0.05 - away * 0.02;
        let mut way = Vector::ZERO;
        for _ in 0..120 {
            let movement = walker.compute(desired);
            let next = walker.place() + movement.translation;
            walker.world.bodies[walker.body].set_next_kinematic_translation(next);
            walker.world.step();
            way += movement.translation;
        }
        assert!((way.dot(along) / (120.0 * 0.05) - 1.0).abs() < 0.01, "{way}");
        let gap = walker.place().dot(away) - 0.3;
        assert!((gap - 0.006).abs() < GAP_TOLERANCE, "{degrees}: gap {gap}");
    }
}

/// In an acute corner the motion ends, stays ended, and keeps the offset from both sides.
#[test]
fn corners_hold_still() {
    for half_angle in [5.0, 15.0, 30.0, 40.0] {
        let mut world = PhysicsWorld::new();
        for side in [-1.0, 1.0] {
            let angle = -side * Real::to_radians(half_angle);
            let (along, away) = (vec(angle.cos(), angle.sin()), vec(-angle.sin(), angle.cos()));
            let place = vec(10.0, 0.0) - along * 20.0 + away * side;
            world.insert_collider(
                cuboid(20.0, 1.0).translation(place).rotation(about_z(angle)),
                None,
            );
        }
        // The lower side of the corner is a floor.
        let mut walker = Walker::of(world, ColliderBuilder::ball(0.3), vec(0.0, 0.0));
        for step in 0..400 {
            let movement = walker.compute(vec(0.1, -0.01));
            let next = walker.place() + movement.translation;
            walker.world.bodies[walker.body].set_next_kinematic_translation(next);
            walker.world.step();
            let last = movement.translation.length();
            assert!(step < 360 || last == 0.0, "{half_angle}°: moves by {last} in step {step}");
        }
    }
}

/// Returns the largest error of the speed, as a fraction, in a corridor. The corridor leaves room for the
/// character and its two offsets, plus `extra` offsets.
pub fn corridor(extra: Real) -> Real {
    let mut world = PhysicsWorld::new();
    let width = 2.0 * (0.3 + 0.006 * (1.0 + extra));
    for side in [-1.0, 1.0] {
        let place = vec(0.0, side * (1.0 + 0.5 * width));
        world.insert_collider(cuboid(50.0, 1.0).translation(place), None);
    }
    let mut walker = Walker::of(world, ColliderBuilder::ball(0.3), vec(0.0, 0.0));
    let mut error: Real = 0.0;
    for _ in 0..60 {
        let movement = walker.compute(vec(0.05, 0.01));
        error = error.max((movement.translation.x / 0.05 - 1.0).abs());
        let next = walker.place() + movement.translation;
        walker.world.bodies[walker.body].set_next_kinematic_translation(next);
        walker.world.step();
        assert!(walker.place().y.abs() < 0.006 * (1.0 + extra.abs()), "{}", walker.place());
    }
    let rest = walker.compute(Vector::ZERO).translation.length();
    assert!(rest < 2.0e-3, "{extra}: trembles by {rest}");
    error
}

/// A corridor as wide as the character and its offsets, or narrower, is passed at full speed.
#[test]
fn characters_pass_narrow_corridors() {
    for extra in [0.5, 0.0, -0.5, -1.0, -1.5] {
        let error = corridor(extra);
        assert!(error < 0.01, "{error} at {extra}");
    }
}

/// Returns the worst penetration of the offset by a wall at this speed, in excess of the wall's motion in one
/// step.
pub fn pushed_by_wall(speed: Real) -> Real {
    let mut world = level();
    let wall = RigidBodyBuilder::kinematic_velocity_based()
        .translation(vec(3.0, 3.0))
        .linvel(vec(speed, 0.0));
    let (wall, _) = world.insert(wall, cuboid(1.0, 2.9));
    let mut walker = Walker::new(world, vec(0.5, 1.2)).settled();
    let mut short: Real = 0.0;
    for _ in 0..60 {
        let movement = walker.step(Vector::ZERO);
        let left_side = walker.world.bodies[wall].translation().x - 1.0;
        let gap = left_side - walker.place().x - CAPSULE.1;
        short = short.max(OFFSET + speed * DT - gap);
        assert!(movement.grounded && (walker.feet() - OFFSET).abs() < GAP_TOLERANCE);
        assert!(walker.place().x < left_side, "was passed");
    }
    assert!(walker.place().x < 0.4, "was not pushed");
    short
}

/// A moving wall pushes the character, and penetrates its offset by at most one step of motion.
#[test]
fn moving_walls_push() {
    for speed in [-1.0, -6.0] {
        let short = pushed_by_wall(speed);
        assert!(short < GAP_TOLERANCE, "{short} at {speed}");
    }
}

/// Between a moving and a fixed wall there is no solution, but the result stays finite.
#[test]
fn a_crushed_character_stays_between_the_walls() {
    let mut world = level();
    wall(&mut world, 1.0);
    let press = RigidBodyBuilder::kinematic_velocity_based()
        .translation(vec(-2.0, 3.0))
        .linvel(vec(1.0, 0.0));
    let (press, _) = world.insert(press, cuboid(1.0, 2.9));
    let mut walker = Walker::new(world, vec(0.0, 1.2));
    for _ in 0..100 {
        walker.step(Vector::ZERO);
        let place = walker.place();
        assert!(
            place.x.abs() < 1.0 && walker.feet() > -GAP_TOLERANCE && walker.feet() < 0.5,
            "{place}"
        );
    }
    assert!(walker.world.bodies[press].translation().x > -0.5);
}

/// Without sliding the character stops at a wall, but walks on floors.
#[test]
fn a_character_without_sliding_stops() {
    let mut world = level();
    let leaning = cuboid(1.0, 20.0).translation(vec(4.0, 0.0)).rotation(about_z(-0.2));
    world.insert_collider(leaning, None);
    let mut walker = Walker::new(world, vec(0.0, 1.2)).settled();
    walker.controller.slide = false;
    walker.steps(30, vec(2.0, 0.0));
    assert!((walker.place().x - 1.0).abs() < 0.01, "{}", walker.place());
    walker.steps(120, vec(2.0, 0.0));
    let place = walker.place();
    let jump = walker.compute(vec(0.1, 0.1));
    assert!(jump.translation.length() < 0.02, "{jump:?} at {place}");
    walker.controller.slide = true;
    let jump = walker.compute(vec(0.1, 0.1));
    assert!(jump.translation.y > 0.05, "{jump:?} at {place}");
}
