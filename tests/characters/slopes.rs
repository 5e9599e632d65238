//! "My character is slower uphill", "it hops downhill", "it climbs walls", "it slides off hills".

use super::stage::{CAPSULE, DT, FOOT, GAP_TOLERANCE, OFFSET, Walker, level, on_slope, slope};
use crate::dim::{about_z, cuboid, vec};
use rapier::control::CharacterSlopeSpeed;
use rapier::prelude::*;

/// Returns the worst displacement of a step, as a fraction of the desired one, and the number of steps off
/// the ground.
pub fn walk_on_slope(degrees: Real, speed: Real, rule: CharacterSlopeSpeed) -> (Real, usize) {
    let mut walker = Walker::new(slope(degrees), on_slope(degrees, 0.0)).settled();
    walker.controller.slope_speed = rule;
    let (mut worst, mut in_the_air): (Real, usize) = (1.0, 0);
    for _ in 0..240 {
        let movement = walker.step(vec(speed, 0.0));
        let share = movement.translation.length() / (speed * DT).abs();
        if (share - 1.0).abs() > (worst - 1.0).abs() {
            worst = share;
        }
        in_the_air += usize::from(!movement.grounded);
    }
    (worst, in_the_air)
}

#[test]
fn walking_has_the_same_speed_on_all_slopes() {
    for degrees in [0.0, 10.0, 30.0, 44.0] {
        for speed in [2.0, -2.0, 6.0, -6.0] {
            let (share, in_the_air) = walk_on_slope(degrees, speed, CharacterSlopeSpeed::Constant);
            assert!((share - 1.0).abs() < 0.01, "{share} of {speed} on {degrees}°");
            assert_eq!(in_the_air, 0, "at {speed} on {degrees}°");
        }
    }
}

#[test]
fn other_rules_give_other_speeds() {
    let cos = Real::to_radians(30.0).cos();
    let rules =
        [(CharacterSlopeSpeed::Horizontal, 1.0 / cos), (CharacterSlopeSpeed::Projected, cos)];
    for (rule, expected) in rules {
        for speed in [3.0, -3.0] {
            let (share, in_the_air) = walk_on_slope(30.0, speed, rule);
            assert!((share - expected).abs() < 0.01, "{share} instead of {expected}");
            assert_eq!(in_the_air, 0);
        }
    }
}

/// A character does not walk up a slope beyond the limit, and can walk away from it at once.
#[test]
fn steep_slopes_are_walls() {
    for degrees in [50.0, 60.0, 75.0] {
        let mut world = level();
        let angle = Real::to_radians(degrees);
        let ramp = cuboid(20.0, 1.0)
            .translation(vec(3.0 + angle.sin(), -angle.cos()))
            .rotation(about_z(angle));
        world.insert_collider(ramp, None);
        let mut walker = Walker::new(world, vec(0.0, 1.0)).settled();
        let height = walker.place().y;
        let mut highest: Real = height;
        for _ in 0..240 {
            let movement = walker.step(vec(5.0, 0.0));
            assert!(movement.grounded);
            highest = highest.max(walker.place().y);
        }
        assert!(highest - height < GAP_TOLERANCE, "climbed {} at {degrees}°", highest - height);
        assert!(walker.place().x > 2.0, "did not get to the slope");
        let place = walker.place();
        let movement = walker.step(vec(5.0, 0.0));
        assert!(movement.translation.length() < 1.0e-5, "trembles by {}", movement.translation);
        assert!((walker.place() - place).length() < 1.0e-5);
    }
}

/// A character on a slope beyond the limit slides down, also while it walks against it.
#[test]
fn characters_slide_down_steep_slopes() {
    for speed in [0.0, 4.0, -1.0] {
        let mut walker = Walker::new(slope(60.0), on_slope(60.0, 0.0) + vec(0.0, 0.3));
        walker.steps(30, vec(speed, 0.0));
        let height = walker.place().y;
        let movement = walker.step(vec(speed, 0.0));
        assert!(movement.is_sliding_down_slope && !movement.grounded, "{movement:?}");
        walker.steps(30, vec(speed, 0.0));
        assert!(walker.place().y < height - 0.5, "fell from {height} to {}", walker.place().y);
        let gap =
            (walker.place() - on_slope(60.0, walker.place().x)).y * Real::to_radians(60.0).cos();
        assert!(speed < 0.0 || gap.abs() < 0.01, "is {gap} off the slope");
    }
}

/// The two angles are independent: a slope can be climbable and slippery, or neither.
#[test]
fn slippery_and_climbable_are_independent() {
    let mut walker = Walker::new(slope(35.0), on_slope(35.0, 0.0)).settled();
    walker.controller.min_slope_slide_angle = Real::to_radians(20.0);
    let movement = walker.step(Vector::ZERO);
    assert!(movement.is_sliding_down_slope && movement.grounded);
    assert!(movement.translation.x < 0.0 && movement.translation.y < 0.0);
    let climbed = walker.step(vec(4.0, 0.0));
    assert!(climbed.translation.y > 0.0, "{climbed:?}");

    let mut walker = Walker::new(slope(55.0), on_slope(55.0, 0.0));
    walker.controller.min_slope_slide_angle = Real::to_radians(70.0);
    walker.steps(30, Vector::ZERO);
    let place = walker.place();
    let movement = walker.step(Vector::ZERO);
    assert!(movement.grounded && movement.translation == Vector::ZERO, "{movement:?}");
    walker.steps(30, vec(3.0, 0.0));
    assert!(
        walker.place().y - place.y < GAP_TOLERANCE,
        "the character climbed a slope that is too steep"
    );
}

/// A slope of exactly the largest angle is climbable and holds the character.
#[test]
fn the_largest_angle_itself_can_be_climbed() {
    let mut walker = Walker::new(slope(45.0), on_slope(45.0, 0.0)).settled();
    assert_eq!(walker.step(Vector::ZERO).translation, Vector::ZERO);
    walker.steps(60, vec(2.0, 0.0));
    let way = 2.0 * Real::to_radians(45.0).cos();
    assert!((walker.place().x - way).abs() < 0.02, "at {}", walker.place());
}

/// Returns a level with a roof on it, with the ridge at x = 0.
fn roof(degrees: Real) -> PhysicsWorld {
    let mut world = level();
    for side in [-1.0, 1.0] {
        let angle = -side * Real::to_radians(degrees);
        let along = vec(angle.cos(), angle.sin()) * side;
        let outwards = vec(-angle.sin(), angle.cos());
        let middle = vec(0.0, 2.0) + along * 5.0 - outwards;
        let half = cuboid(5.0, 1.0).translation(middle).rotation(about_z(angle));
        world.insert_collider(half, None);
    }
    world
}

/// The character walks from a level up a slope, over its ridge, and down again. It stays on the ground and
/// keeps the desired speed except at changes of slope. The gap never falls below the offset.
#[test]
fn ridges_and_valleys_keep_the_character_on_the_ground() {
    for (degrees, speed) in [(30.0, 3.0), (40.0, 6.0), (20.0, 10.0)] {
        let mut walker = Walker::new(roof(degrees), vec(-9.0, 1.0)).settled();
        let (mut highest, mut changes): (Real, usize) = (0.0, 0);
        while walker.place().x < 9.0 {
            let movement = walker.step(vec(speed, 0.0));
            let at = walker.place();
            assert!(movement.grounded, "{degrees}°, {speed}: in the air at {at}");
            let share = movement.translation.length() / (speed * DT);
            changes += usize::from((share - 1.0).abs() > 0.01);
            assert!((0.7..1.5).contains(&share), "{degrees}°, {speed}: {share} at {at}");
            highest = highest.max(at.y);
        }
        // Over the ridge, the capsule's middle is as high as its lowest point is below it.
        assert!((highest - 2.0 - FOOT - OFFSET).abs() < 0.05, "{highest}");
        // A ball rolls over a ridge by its radius times the angle; in a valley there are two planes at once.
        let round = CAPSULE.1 * 2.0 * Real::to_radians(degrees) / (speed * DT);
        assert!((changes as Real) < round + 8.0, "{changes} steps of another speed");
    }
}
