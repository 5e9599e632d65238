//! "My character trembles when it stands."

use super::stage::{DT, GAP_TOLERANCE, OFFSET, Walker, level, on_slope, slope};
use crate::dim::{about_z, cuboid, vec};
use rapier::prelude::*;

/// A minute of gravity gives a displacement of exactly zero.
fn stands(mut walker: Walker) {
    let place = walker.place();
    for step in 0..3600 {
        let movement = walker.step(Vector::ZERO);
        assert_eq!(movement.translation, Vector::ZERO, "in step {step}");
        assert!(movement.grounded && !movement.is_sliding_down_slope);
    }
    assert_eq!(walker.place(), place);
}

#[test]
fn a_standing_character_does_not_move_in_a_minute() {
    let walker = Walker::new(level(), vec(0.3, 1.2)).settled();
    assert!((walker.feet() - OFFSET).abs() < GAP_TOLERANCE, "gap {}", walker.feet());
    stands(walker);
}

#[test]
fn a_box_on_level_ground_keeps_its_place() {
    stands(Walker::of(level(), cuboid(0.4, 0.9), vec(0.3, 1.2)).settled());
}

#[test]
fn a_capsule_on_a_slope_far_from_the_origin_keeps_its_place() {
    stands(Walker::new(slope(30.0), on_slope(30.0, 40.0) + vec(0.0, 0.1)).settled());
}

#[test]
fn a_capsule_in_a_valley_or_at_a_wall_keeps_its_place() {
    let mut world = slope(25.0);
    let rise = Real::to_radians(25.0);
    let other =
        cuboid(200.0, 1.0).translation(vec(-rise.sin(), -rise.cos())).rotation(about_z(-rise));
    world.insert_collider(other, None);
    stands(Walker::new(world, vec(0.0, 2.0)).settled());

    let mut world = level();
    world.insert_collider(cuboid(1.0, 5.0).translation(vec(1.3, 5.0)), None);
    stands(Walker::new(world, vec(-0.01, 1.2)).settled());
}

/// The translation of a character without obstacles is exact to the bit.
#[test]
fn free_motion_is_exact() {
    let mut walker = Walker::new(level(), vec(0.0, 50.0));
    let desired = vec(0.37, -0.11);
    assert_eq!(walker.compute(desired).translation, desired);
    assert!(!walker.compute(desired).grounded);
}

/// A fall ends at the offset, whatever its speed, in one step.
#[test]
fn falls_end_at_the_offset() {
    for speed in [1.0, 20.0, 500.0] {
        let mut walker = Walker::new(level(), vec(0.0, 2.0));
        walker.fall = -speed;
        let mut landed = false;
        for _ in 0..60 {
            let movement = walker.step(Vector::ZERO);
            assert!(walker.feet() > OFFSET - GAP_TOLERANCE, "at {}", walker.feet());
            assert!(!landed || movement.translation.length() < GAP_TOLERANCE);
            landed = movement.grounded;
        }
        assert!(landed && (walker.feet() - OFFSET).abs() < GAP_TOLERANCE);
    }
}

/// A jumping character leaves the ground, also within the snapping distance, and lands at the same place.
#[test]
fn jumps_leave_the_ground() {
    let mut walker = Walker::new(level(), vec(0.0, 1.2)).settled();
    let before = walker.place();
    let (mut velocity, mut highest): (Real, Real) = (4.0, 0.0);
    for step in 0..60 {
        velocity -= 9.81 * DT;
        let movement = walker.compute(vec(0.0, velocity * DT));
        assert!(step > 10 || !movement.grounded, "still on the ground in step {step}");
        let next = walker.place() + movement.translation;
        walker.world.bodies[walker.body].set_next_kinematic_translation(next);
        walker.world.step();
        highest = highest.max(walker.place().y - before.y);
    }
    // The height is v²/2g minus the error of the step, v·dt/2.
    assert!((highest - 16.0 / 19.62).abs() < 4.0 * DT, "jumped {highest}");
    assert!((walker.place() - before).length() < GAP_TOLERANCE);
}
