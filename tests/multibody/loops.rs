//! Impulse joints on links: closed loops, and single bodies that hang on multibodies.

use super::stage::{chain, energy, momentum, slab};
use crate::dim::{about_z, hinge, vec, z_of};
use crate::suite::joints::stage::{bob, post};
use crate::suite::physics::stage::{G, RATES, steps, weightless, world};
use rapier::prelude::*;

/// Two rods of length 1 hang from two posts, with a bar between their lower ends. The bar stays level, the
/// whole swings like a pendulum, and the hinge that closes the loop holds.
#[test]
fn a_loop_that_is_closed_holds() {
    for rate in RATES {
        let mut world = world(rate);
        let left = post(&mut world, Vector::ZERO);
        let right = post(&mut world, vec(2.0, 0.0));
        let down = vec(0.6, -0.8);
        let mut add = |at: Vector| world.insert_body(bob(1.0, 0.1).translation(at));
        let [rod1, bar, rod2] = [down, down + vec(1.0, 0.0), vec(2.0, 0.0) + down].map(&mut add);
        let set = &mut world.multibody_joints;
        let up = |down: Vector| hinge().local_anchor2(-down);
        set.insert(left, rod1, up(down), true).expect("it fits");
        set.insert(rod1, bar, hinge().local_anchor2(vec(-1.0, 0.0)), true).expect("it fits");
        set.insert(bar, rod2, hinge().local_anchor1(vec(1.0, 0.0)), true).expect("it fits");
        world.impulse_joints.insert(right, rod2, up(down), true);
        let bodies = [rod1, bar, rod2];
        let (mut gap, mut tilt, mut error): (Real, Real, Real) = (0.0, 0.0, 0.0);
        world.step();
        let start = energy(&world, &bodies);
        for _ in 0..steps(&world, 5.0) {
            world.step();
            gap = gap.max((*world.bodies[rod2].position() * -down - vec(2.0, 0.0)).length());
            tilt = tilt.max(crate::dim::angle(world.bodies[bar].rotation()).abs());
            error = error.max((energy(&world, &bodies) - start).abs() / (3.0 * G));
        }
        println!("{rate} Hz: gap {gap:.5}, tilt {tilt:.5}, error of E {error:.4}");
        assert!(gap < 1.0e-3 && tilt < 1.0e-3, "the loop opens by {gap}, the bar tilts by {tilt}");
        assert!(error < 0.02, "energy is off by {error} of m g L");
    }
}

/// A body hangs on the end of a chain in free flight: the total momentum is constant.
#[test]
fn bodies_on_links_share_momentum() {
    let mut world = weightless(60);
    let chain = chain(&mut world, None, 3);
    let rider = world.insert_body(slab(vec(3.5, 0.0)));
    let joint = hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
    world.impulse_joints.insert(chain.bodies[2], rider, joint, true);
    world.bodies[rider].set_linvel(vec(0.0, 1.0), true);
    world.bodies[chain.bodies[0]].set_angvel(about_z(1.0), true);
    world.step();
    let mut bodies = chain.bodies.clone();
    bodies.push(rider);
    let before = momentum(&world, &bodies);
    let mut gap: Real = 0.0;
    for _ in 0..steps(&world, 5.0) {
        world.step();
        let [end, start] = [chain.bodies[2], rider].map(|body| *world.bodies[body].position());
        gap = gap.max((end * vec(0.5, 0.0) - start * vec(-0.5, 0.0)).length());
    }
    let after = momentum(&world, &bodies);
    let error = (after - before).length() / before.length();
    println!("gap {gap:.5}, momentum off by {:.4} %", error * 100.0);
    assert!(gap < 0.01, "the joint opens by {gap}");
    assert!(error < 1.0e-3, "{after} instead of {before}");
}

/// A weld between two arms of one multibody makes them one rigid body.
#[test]
fn a_weld_between_arms_holds() {
    let mut world = world(60);
    let ceiling = post(&mut world, Vector::ZERO);
    let [left, right] = [-0.5, 0.5].map(|x| world.insert_body(slab(vec(x, -1.0))));
    for body in [left, right] {
        let anchor = -world.bodies[body].translation();
        let joint = hinge().local_anchor2(anchor);
        world.multibody_joints.insert(ceiling, body, joint, true).expect("it fits");
    }
    let weld = FixedJointBuilder::new().local_anchor1(vec(1.0, 0.0));
    world.impulse_joints.insert(left, right, weld, true);
    world.bodies[left].set_linvel(vec(1.0, 0.0), true);
    let mut apart: Real = 0.0;
    for _ in 0..steps(&world, 3.0) {
        world.step();
        let [l, r] = [left, right].map(|body| crate::dim::angle(world.bodies[body].rotation()));
        apart = apart.max((l - r).abs());
    }
    assert!(apart < 0.01, "the arms turn against each other by {apart} rad");
    let [l, r] = [left, right].map(|body| z_of(world.bodies[body].angvel()));
    assert!((l - r).abs() < 0.02, "{l} and {r}");
}

/// A light bracket, welded to the world by an impulse joint, carries a heavy arm on a hinge with limits. The
/// arm swings into its limit, and rests there.
#[test]
fn welded_brackets_hold_arms_at_their_limits() {
    let half_degree = (0.5 as Real).to_radians();
    for rate in RATES {
        for ratio in [1.0, 60.0, 1000.0] {
            for limit in [0.0, 0.21] {
                let mut world = world(rate);
                let wall = post(&mut world, Vector::ZERO);
                let bracket = world.insert_body(bob(0.2, 0.2).translation(vec(0.3, -0.2)));
                let arm = world.insert_body(bob(0.2 * ratio, 0.3).translation(vec(1.0, -0.1)));
                let weld = FixedJointBuilder::new().local_anchor2(vec(-0.3, 0.2));
                world.insert_impulse_joint(wall, bracket, weld);
                let joint = hinge()
                    .local_anchor1(vec(0.2, 0.3))
                    .local_anchor2(vec(-0.5, 0.2))
                    .limits([-limit, limit]);
                world.multibody_joints.insert(bracket, arm, joint, true).expect("it fits");
                let start = energy(&world, &[bracket, arm]);
                let (mut gain, mut excess): (Real, Real) = (0.0, 0.0);
                for _ in 0..steps(&world, 3.0) {
                    world.step();
                    gain = gain.max(energy(&world, &[bracket, arm]) - start);
                    let [one, two] = [bracket, arm].map(|body| *world.bodies[body].rotation());
                    let turn = crate::dim::angle(&(one.inverse() * two)).abs();
                    excess = excess.max(turn - limit);
                }
                let speed = world.bodies[arm].linvel().length();
                let case = format!("{rate} Hz, 1:{ratio}, limit {limit}");
                // The bracket gives way under the blow by some millimetres, and comes back.
                assert!(gain < 0.01 * 0.2 * (1.0 + ratio) * G, "{case}: gains {gain} J");
                assert!(excess < half_degree, "{case}: {excess} rad beyond");
                assert!(speed < 0.01, "{case}: {speed} m/s at the end");
            }
        }
    }
}
