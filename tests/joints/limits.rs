//! Limits hold, anywhere on the circle and beyond it.

use super::stage::{bob, post};
use crate::dim::{about_z, angle, hinge, vec};
use crate::suite::physics::stage::{RATES, run, steps, substep, weightless, world};
use rapier::prelude::*;

/// Half a degree.
const ROOM: Real = 0.5 * core::f64::consts::PI as Real / 180.0;
const TURN: Real = 2.0 * core::f64::consts::PI as Real;

/// Turns a wheel against a limit with a motor; returns the largest and the last angle, with all turns.
fn turned_to(rate: u32, limits: [Real; 2], speed: Real) -> (Real, Real) {
    let mut world = weightless(rate);
    let post = post(&mut world, Vector::ZERO);
    let wheel = world.insert_body(bob(1.0, 0.5));
    let joint = hinge().limits(limits).motor_velocity(speed, 20.0).motor_max_force(5.0);
    world.insert_impulse_joint(post, wheel, joint);
    let (mut turned, mut largest, mut last) = (0.0, 0.0, 0.0);
    for _ in 0..steps(&world, 5.0) {
        world.step();
        let now = angle(world.bodies[wheel].rotation());
        let change = (now - last) / TURN;
        turned += (change - change.round()) * TURN;
        largest = if speed > 0.0 { Real::max(largest, turned) } else { Real::min(largest, turned) };
        last = now;
    }
    (largest, turned)
}

#[test]
fn hinges_stop_at_their_limits_wherever_these_are() {
    for rate in RATES {
        for degrees in [20.0, 90.0, 170.0, 179.0, 185.0, 350.0, 730.0] {
            let limit = Real::to_radians(degrees);
            for (limits, speed, expected) in
                [([-0.1, limit], 4.0, limit), ([-limit, 0.1], -4.0, -limit)]
            {
                let (largest, last) = turned_to(rate, limits, speed);
                assert!((largest - expected).abs() < ROOM, "{largest} at {rate} Hz, {expected}");
                assert!(
                    (last - expected).abs() < ROOM,
                    "{last} at {rate} Hz instead of {expected}"
                );
            }
        }
    }
}

/// Who is put between limits beyond half a turn is there: a hinge reads its first angle, which has as many readings as
/// there are turns, so that it fits.
#[test]
fn what_is_put_between_its_limits_stays_there() {
    for limits in [[2.5, 4.0], [3.0, 3.3], [-4.0, -2.5], [0.0, 3.4], [6.0, 7.0], [0.0, 20.0]] {
        for is_multibody in [false, true] {
            let mut world = weightless(60);
            let at = Real::min(limits[1] - 0.1, 3.25).max(limits[0] + 0.1);
            let post = world.insert_body(RigidBodyBuilder::fixed());
            let flap = RigidBodyBuilder::dynamic().rotation(about_z(at)).can_sleep(false);
            let (flap, _) = world.insert(flap, ColliderBuilder::ball(0.5));
            let joint = hinge().limits(limits);
            if is_multibody {
                world.insert_multibody_joint(post, flap, joint).expect("the joint fits");
            } else {
                world.insert_impulse_joint(post, flap, joint);
            }
            let start = *world.bodies[flap].rotation();
            run(&mut world, 0.5);
            let turned = angle(&(*world.bodies[flap].rotation() * start.inverse())).abs();
            assert!(turned < 1.0e-3, "{limits:?} at {at}: {turned} rad, {is_multibody}");
        }
    }
}

#[test]
fn a_flap_rests_on_its_limit() {
    for rate in RATES {
        let mut world = world(rate);
        let post = post(&mut world, Vector::ZERO);
        let flap = world.insert_body(bob(3.0, 0.3).translation(vec(1.0, 0.0)));
        let joint = hinge().local_anchor2(vec(-1.0, 0.0)).limits([-0.6, 0.2]);
        world.insert_impulse_joint(post, flap, joint);
        run(&mut world, 3.0);
        let found = angle(world.bodies[flap].rotation());
        assert!((found + 0.6).abs() < ROOM, "{found} at {rate} Hz");
    }
}

#[test]
fn sliders_stop_at_their_limits() {
    for rate in RATES {
        let mut world = world(rate);
        let post = post(&mut world, Vector::ZERO);
        let load = world.insert_body(bob(3.0, 0.3));
        let joint = PrismaticJointBuilder::new(Vector::Y).limits([-0.75, 1.0]);
        world.insert_impulse_joint(post, load, joint);
        let mut lowest: Real = 0.0;
        for _ in 0..steps(&world, 3.0) {
            world.step();
            lowest = lowest.min(world.bodies[load].translation().y);
        }
        assert!((lowest + 0.75).abs() < 2.0e-3, "{lowest} at {rate} Hz");
    }
}

#[test]
fn equal_limits_are_a_lock() {
    let mut world = weightless(60);
    let post = post(&mut world, Vector::ZERO);
    let wheel = world.insert_body(bob(1.0, 0.5).rotation(about_z(0.4)).angvel(about_z(1.0)));
    world.insert_impulse_joint(post, wheel, hinge().limits([0.4, 0.4]));
    run(&mut world, 2.0);
    let found = angle(world.bodies[wheel].rotation());
    assert!((found - 0.4).abs() < 1.0e-3, "{found}");
}

/// What circles at the end of a rope is no farther than the rope is long, keeps its speed, and pulls with `m v² / r`: within the
/// `(h v / r)²` by which a polygon of substeps differs from a circle.
#[test]
fn ropes_lead_round_in_circles() {
    for rate in RATES {
        for speed in [2.0, 5.0, 10.0] {
            let mut world = weightless(rate);
            let post = post(&mut world, Vector::ZERO);
            let load = bob(1.0, 0.3).translation(vec(1.0, 0.0)).linvel(vec(0.0, speed));
            let load = world.insert_body(load);
            let rope = world.insert_impulse_joint(post, load, RopeJointBuilder::new(1.0));
            let mut longest: Real = 0.0;
            for _ in 0..steps(&world, 5.0) {
                world.step();
                longest = longest.max(world.bodies[load].translation().length());
            }
            let what = format!("{speed} m/s at {rate} Hz");
            assert!(longest < 1.001, "{longest} m, {what}");
            let kept = world.bodies[load].linvel().length() / speed;
            assert!((kept - 1.0).abs() < 1.0e-3, "{kept} of the speed, {what}");
            let pull = world.impulse_joints.get(rope).expect("the rope is there").force().length();
            let turn = speed * substep(&world);
            let error = (pull / (speed * speed) - 1.0).abs();
            assert!(error < turn * turn + 1.0e-3, "{pull} N, {what}");
        }
    }
}

/// A pendulum on a rope swings as high after half a minute as at first: taut throughout, it loses nothing.
#[test]
fn ropes_let_pendulums_swing() {
    for rate in RATES {
        let mut world = world(rate);
        let post = post(&mut world, Vector::ZERO);
        let load = world.insert_body(bob(1.0, 0.1).translation(vec(1.0, 0.0)));
        world.insert_impulse_joint(post, load, RopeJointBuilder::new(1.0));
        run(&mut world, 27.0);
        let mut highest = Real::MIN;
        for _ in 0..steps(&world, 3.0) {
            world.step();
            highest = highest.max(world.bodies[load].translation().y);
        }
        // 1 cm below the level of 90° is 0.6° of the amplitude.
        assert!(highest.abs() < 0.01, "{highest} m at {rate} Hz");
    }
}

#[test]
fn ropes_hold_at_their_length_and_not_before() {
    for rate in RATES {
        let mut world = world(rate);
        let post = post(&mut world, Vector::ZERO);
        let load = world.insert_body(bob(3.0, 0.3).translation(vec(0.5, 0.2)));
        world.insert_impulse_joint(post, load, RopeJointBuilder::new(2.0));
        let mut longest: Real = 0.0;
        for _ in 0..steps(&world, 0.3) {
            world.step();
            // Free fall: nothing pulls yet.
            assert!((world.bodies[load].translation().x - 0.5).abs() < 1.0e-5);
        }
        for _ in 0..steps(&world, 5.0) {
            world.step();
            longest = longest.max(world.bodies[load].translation().length());
        }
        assert!(longest > 1.999 && longest < 2.02, "{longest} at {rate} Hz");
    }
}
