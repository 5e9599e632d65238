//! "My character does not get up the stairs", "it flies off them on its way down", "it climbs what is too
//! high".

use super::stage::{DT, FOOT, GAP_TOLERANCE, OFFSET, Walker, level};
use crate::dim::{about_z, cuboid, vec};
use rapier::control::{CharacterAutostep, CharacterLength};
use rapier::prelude::*;

fn autostep(max_height: Real) -> Option<CharacterAutostep> {
    Some(CharacterAutostep {
        max_height: CharacterLength::Absolute(max_height),
        min_width: CharacterLength::Absolute(0.3),
        include_dynamic_bodies: true,
    })
}

/// Returns a level with a long block on it that begins at x = 1.
fn step_of(height: Real) -> PhysicsWorld {
    let mut world = level();
    world.insert_collider(cuboid(5.0, height).translation(vec(6.0, 0.0)), None);
    world
}

/// Returns whether the character climbs the step, and its final height.
pub fn goes_up(shape: &ColliderBuilder, height: Real, max_height: Real, speed: Real) -> bool {
    let mut walker = Walker::of(step_of(height), shape.clone(), vec(0.0, FOOT + OFFSET)).settled();
    walker.controller.autostep = autostep(max_height);
    let before = walker.place().y;
    let steps = (3.0 / (speed * DT)) as usize;
    let mut highest: Real = 0.0;
    for _ in 0..steps {
        let movement = walker.step(vec(speed, 0.0));
        assert!(movement.grounded, "left the ground at {}", walker.place());
        highest = highest.max(walker.place().y - before);
    }
    let up = walker.place().y - before;
    // The descent onto an edge stops early, by a few tolerances at an almost vertical edge.
    assert!(highest < height + 2.0e-3, "got as high as {highest}");
    let expected = if walker.place().x > 1.5 { height } else { 0.0 };
    assert!((up - expected).abs() < GAP_TOLERANCE, "{up} at {}", walker.place());
    up > 0.5 * height
}

#[test]
fn low_steps_are_climbed_and_high_ones_are_walls() {
    let capsule = ColliderBuilder::capsule_y(super::stage::CAPSULE.0, super::stage::CAPSULE.1);
    for shape in [capsule, cuboid(0.3, FOOT)] {
        for (height, expected) in
            [(0.05, true), (0.2, true), (0.39, true), (0.42, false), (1.0, false)]
        {
            for speed in [0.5, 3.0, 8.0] {
                let up = goes_up(&shape, height, 0.4, speed);
                assert_eq!(up, expected, "a step of {height} at {speed}");
            }
        }
    }
}

/// A character does not climb a step that is too narrow.
#[test]
fn steps_need_room() {
    for (room, expected) in [(0.2, false), (0.5, true)] {
        let mut world = step_of(0.2);
        world.insert_collider(cuboid(1.0, 5.0).translation(vec(2.0 + room, 5.0)), None);
        let mut walker = Walker::new(world, vec(0.0, 1.2)).settled();
        walker.controller.autostep = autostep(0.4);
        walker.steps(120, vec(2.0, 0.0));
        assert_eq!(walker.feet() > 0.1, expected, "{room}: {}", walker.place());
        walker.steps(60, vec(2.0, 0.0));
        let movement = walker.step(vec(2.0, 0.0));
        assert!(movement.translation.length() < 1.0e-4, "{room}: trembles by {movement:?}");
    }
}

fn stairs(count: usize, rise: Real, run: Real) -> PhysicsWorld {
    let mut world = level();
    for i in 0..count {
        let height = rise * (i + 1) as Real;
        let left = 1.0 + run * i as Real;
        let place = vec(left + 10.0, 0.5 * height);
        world.insert_collider(cuboid(10.0, 0.5 * height).translation(place), None);
    }
    world
}

/// On a flight of stairs, up and down, the character stays on the ground at the desired horizontal speed.
#[test]
fn characters_walk_up_and_down_stairs() {
    for speed in [1.5, 4.0] {
        let mut walker = Walker::new(stairs(8, 0.2, 0.3), vec(0.0, 1.2)).settled();
        walker.controller.autostep = autostep(0.3);
        for direction in [1.0, -1.0] {
            let (from, steps) = (walker.place().x, (5.0 / (speed * DT)) as usize);
            for _ in 0..steps {
                let movement = walker.step(vec(direction * speed, 0.0));
                assert!(movement.grounded, "left the ground at {}", walker.place());
            }
            let came = (walker.place().x - from).abs() / (speed * DT * steps as Real);
            // The fraction is slightly below 1, because a round bottom rolls over each edge: its path is
            // longer than the stairs.
            assert!((0.93..1.001).contains(&came), "came {came} of the way at {speed}");
            let expected = if direction > 0.0 { 1.6 } else { 0.0 };
            let feet = walker.feet() - OFFSET;
            assert!((feet - expected).abs() < GAP_TOLERANCE, "feet at {feet}");
        }
    }
}

#[test]
fn without_autostep_a_step_is_a_wall() {
    let mut walker = Walker::new(step_of(0.25), vec(0.0, 1.2)).settled();
    walker.steps(120, vec(2.0, 0.0));
    assert!(walker.feet() < 0.1, "{}", walker.place());
}

/// A slope that is too steep is not a staircase, however small its parts.
#[test]
fn steep_slopes_are_no_steps() {
    let mut world = level();
    let angle = Real::to_radians(60.0);
    let place = vec(1.0 + angle.sin(), -angle.cos());
    world.insert_collider(cuboid(20.0, 1.0).translation(place).rotation(about_z(angle)), None);
    let mut walker = Walker::new(world, vec(-1.0, 1.2)).settled();
    walker.controller.autostep = autostep(0.4);
    walker.steps(240, vec(3.0, 0.0));
    assert!((walker.feet() - OFFSET).abs() < GAP_TOLERANCE, "{}", walker.place());
}

/// Steps work from a slope onto a step, and from a step onto a slope.
#[test]
fn steps_work_on_slopes() {
    let angle = Real::to_radians(20.0);
    let (along, out) = (vec(angle.cos(), angle.sin()), vec(-angle.sin(), angle.cos()));
    let corner = along * 2.0;
    // A slab of 0.15 is on the slope.
    let middle = corner + along * 5.0 + out * 0.05;
    let slab = cuboid(5.0, 0.1).translation(middle).rotation(about_z(angle));
    // The level top of a block begins 0.2 above the slope.
    let block = cuboid(0.5, 1.0).translation(corner + vec(0.5, 0.2 - 1.0));
    for (name, obstacle) in [("slab", slab), ("block", block)] {
        let mut airborne = 0;
        for phase in 0..50 {
            let mut world = super::stage::slope(20.0);
            world.insert_collider(obstacle.clone(), None);
            let start = super::stage::on_slope(20.0, 0.001 * phase as Real);
            let mut walker = Walker::new(world, start).settled();
            walker.controller.autostep = autostep(0.4);
            let mut seen = false;
            for _ in 0..90 {
                airborne += usize::from(!walker.step(vec(2.5, 0.0)).grounded);
                seen |= walker.place().x > corner.x + 0.4;
            }
            assert!(seen, "{name}, {phase}: is stuck at {}", walker.place());
        }
        // In 1 of 4,500 steps the character ends just above the edge.
        assert!(airborne <= 2, "{name}: off the ground in {airborne} steps");
    }
}

/// Dynamic bodies are steps only if the setting allows it.
#[test]
fn dynamic_bodies_may_be_steps() {
    for include in [true, false] {
        let mut world = level();
        let block = RigidBodyBuilder::dynamic().translation(vec(3.0, 0.1)).lock_translations();
        world.insert(block.lock_rotations(), cuboid(2.0, 0.1));
        let mut walker = Walker::new(world, vec(0.0, 1.2)).settled();
        let mut step = autostep(0.4).expect("is there");
        step.include_dynamic_bodies = include;
        walker.controller.autostep = Some(step);
        walker.steps(90, vec(2.0, 0.0));
        assert_eq!(walker.feet() > 0.15, include, "{}", walker.place());
    }
}

/// Beyond a cliff the character falls, and does not stick to the side.
#[test]
fn characters_fall_from_cliffs() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(cuboid(2.0, 2.0).translation(vec(0.0, -2.0)), None);
    let mut walker = Walker::new(world, vec(0.0, 1.2)).settled();
    walker.controller.autostep = autostep(0.4);
    walker.steps(240, vec(2.0, 0.0));
    assert!(!walker.grounded && walker.place().y < -5.0, "{}", walker.place());
    assert!((walker.place().x - 8.0).abs() < 0.4, "{}", walker.place());
}
