//! Limits of joints, anywhere on the circle and beyond it.

use super::stage::{bob, post};
use crate::dim::{about_z, angle, hinge, vec, z_of};
use crate::suite::physics::stage::{RATES, run, steps, substep, weightless, world};
use rapier::prelude::*;

/// Half a degree: the tolerance of limits.
const TOLERANCE: Real = 0.5 * core::f64::consts::PI as Real / 180.0;
const TURN: Real = 2.0 * core::f64::consts::PI as Real;

/// Rotates a wheel against a limit by a motor. Returns the largest and the last angle, including all
/// revolutions.
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
fn hinges_stop_at_limits_of_any_angle() {
    for rate in RATES {
        for degrees in [20.0, 90.0, 170.0, 179.0, 185.0, 350.0, 730.0] {
            let limit = Real::to_radians(degrees);
            for (limits, speed, expected) in
                [([-0.1, limit], 4.0, limit), ([-limit, 0.1], -4.0, -limit)]
            {
                let (largest, last) = turned_to(rate, limits, speed);
                assert!(
                    (largest - expected).abs() < TOLERANCE,
                    "{largest} at {rate} Hz, {expected}"
                );
                assert!(
                    (last - expected).abs() < TOLERANCE,
                    "{last} at {rate} Hz instead of {expected}"
                );
            }
        }
    }
}

/// A joint between limits beyond half a revolution starts there. The first angle of a hinge is ambiguous by
/// revolutions, and is chosen within the limits.
#[test]
fn joints_between_their_limits_keep_their_position() {
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

/// Two wheels on one hinge.
struct Wheels {
    world: PhysicsWorld,
    wheels: [RigidBodyHandle; 2],
    /// Angle of the second wheel relative to the first, including all revolutions.
    turned: Real,
}

impl Wheels {
    /// Adds wheels with this joint that rotate relative to each other at `speed`. The first wheel, which
    /// nothing stops, rotates at `carried`.
    fn new(rate: u32, joint: impl Into<GenericJoint>, [speed, carried]: [Real; 2]) -> Self {
        let mut world = weightless(rate);
        let carrier = RigidBodyBuilder::kinematic_velocity_based().angvel(about_z(carried));
        let wheel = bob(1.0, 0.5).angvel(about_z(carried + speed));
        let wheels = [carrier, wheel].map(|wheel| world.insert_body(wheel));
        world.insert_impulse_joint(wheels[0], wheels[1], joint);
        Self { world, wheels, turned: 0.0 }
    }

    fn speed(&self) -> Real {
        let [first, second] = self.wheels.map(|wheel| z_of(self.world.bodies[wheel].angvel()));
        second - first
    }

    /// Steps the world and counts revolutions. The wheels' poses give the angle up to whole revolutions, and
    /// their speeds give the number of revolutions.
    fn step(&mut self) {
        let before = self.speed();
        self.world.step();
        let about = 0.5 * (before + self.speed()) * self.world.integration_parameters.dt;
        let [first, second] = self.wheels.map(|wheel| *self.world.bodies[wheel].rotation());
        let ahead = angle(&(first.inverse() * second)) - (self.turned + about);
        self.turned += about + (ahead / TURN - (ahead / TURN).round()) * TURN;
    }
}

/// Wheels reach a limit many revolutions away in the step that their speed predicts, and stay there. This
/// holds for half a revolution and for several revolutions per step.
#[test]
fn wheels_that_turn_several_times_in_a_step_stop_at_their_limits() {
    for (rate, speed) in [30, 60].into_iter().flat_map(|rate| {
        [50.0, 100.0, 150.0, 200.0, 250.0, 300.0, 350.0, 400.0].map(|speed: Real| (rate, speed))
    }) {
        for limit in [10.0, 34.5, 57.0, 99.0] {
            for (sign, carried) in [(1.0, 0.0), (-1.0, 0.0), (1.0, -40.0), (1.0, 20.0)] {
                let joint = hinge().limits([-limit, limit]);
                let mut wheels = Wheels::new(rate, joint, [sign * speed, carried]);
                let what = format!("{speed} on {carried} rad/s, limit {limit}, at {rate} Hz");
                let each = speed / rate as Real;
                // The error of counted revolutions is in `base/turning.rs`: a thousandth at 13 rad per step.
                // A limit also slows down wheels that would reach it in the next substep.
                let free = (limit / (1.002 * each) - 0.3) as usize;
                for k in 1..=free {
                    wheels.step();
                    let (turned, expected) = (sign * wheels.turned, k as Real * each);
                    assert!((turned - expected).abs() < 2.0e-3 * expected, "{turned}, {what}");
                    assert!((wheels.speed() - sign * speed).abs() < 1.0e-3 * speed, "{k}, {what}");
                }
                // The next step, or the step after it if the limit was near, leads to the limit. The pose
                // shows whether the wheel reached it.
                run(&mut wheels.world, 2.0 / rate as Real);
                assert!(wheels.speed().abs() < 1.0e-2, "{} rad/s, {what}", wheels.speed());
                run(&mut wheels.world, 0.5);
                wheels.step();
                let off = (wheels.turned - sign * limit) / TURN;
                let off = (off - off.round()) * TURN;
                assert!(off.abs() < TOLERANCE, "{off} rad, {what}");
            }
        }
    }
}

/// A motor moves wheels to a target many revolutions away, and not to an equivalent angle, at any speed.
#[test]
fn motors_reach_targets_many_turns_away() {
    for rate in [30, 60] {
        for target in [30.0, -100.0, 200.5] {
            for carried in [0.0, 20.0] {
                // There is no overshoot: the largest speed is 5/e times the distance, 368 rad/s for the
                // longest.
                let joint = hinge().motor_position(target, 25.0, 10.0);
                let mut wheels = Wheels::new(rate, joint, [0.0, carried]);
                let mut fastest: Real = 0.0;
                for _ in 0..steps(&wheels.world, 5.0) {
                    wheels.step();
                    fastest = fastest.max(wheels.speed().abs());
                }
                let off = wheels.turned - target;
                let what = format!("{target} rad at {rate} Hz on {carried}, {fastest} rad/s");
                assert!(off.abs() < 0.01 && fastest > 1.5 * target.abs(), "{off} rad off, {what}");
            }
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
        assert!((found + 0.6).abs() < TOLERANCE, "{found} at {rate} Hz");
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

/// A body that circles on a rope stays within its length, keeps its speed, and pulls with `m v² / r`. The
/// tolerance is `(h v / r)²`, the difference of a polygon of substeps from a circle.
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

/// A pendulum on a rope keeps its amplitude for half a minute: a rope under tension dissipates nothing.
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
        // A height of 1 cm below the level of 90° is 0.6° of the amplitude.
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
            // The load is in free fall, without tension.
            assert!((world.bodies[load].translation().x - 0.5).abs() < 1.0e-5);
        }
        for _ in 0..steps(&world, 5.0) {
            world.step();
            longest = longest.max(world.bodies[load].translation().length());
        }
        assert!(longest > 1.999 && longest < 2.02, "{longest} at {rate} Hz");
    }
}
