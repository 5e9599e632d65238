//! Gears, racks and pulleys: accelerations, ratios, forces and energy by formulas.

use super::stage::{bob, inertia, post};
use crate::dim::{about_z, angle, gear, hinge, rack, vec, z_of};
use crate::suite::physics::stage::{G, RATES, steps, weightless, world};
use rapier::prelude::*;

/// Rounding and the discretisation of a second of constant acceleration.
const TOLERANCE: Real = 2.0e-3;

const TURN: Real = core::f64::consts::TAU as Real;

/// The families: substeps, ratios, and masses of the second body.
const SUBSTEPS: [usize; 3] = [1, 4, 16];
const RATIOS: [Real; 5] = [-3.0, -0.2, 0.5, 1.0, 10.0];
const MASSES: [Real; 3] = [1.0e-3, 1.0, 1.0e3];

/// How a body is held: by an impulse joint, or as a link of a multibody.
#[derive(Copy, Clone, Debug)]
enum Held {
    ByJoint,
    AsLink,
}
const HELD: [Held; 2] = [Held::ByJoint, Held::AsLink];

fn hold(
    world: &mut PhysicsWorld,
    held: Held,
    at: Vector,
    body: RigidBodyHandle,
    joint: impl Into<GenericJoint>,
) {
    let post = post(world, at);
    match held {
        Held::ByJoint => drop(world.insert_impulse_joint(post, body, joint)),
        Held::AsLink => {
            world.insert_multibody_joint(post, body, joint).expect("it fits");
        }
    }
}

/// Adds a wheel of this mass and radius on a post.
fn wheel(
    world: &mut PhysicsWorld,
    held: Held,
    x: Real,
    mass: Real,
    radius: Real,
) -> RigidBodyHandle {
    let at = vec(x, 0.0);
    let wheel = world.insert_body(bob(mass, radius).translation(at));
    hold(world, held, at, wheel, hinge());
    wheel
}

fn omega(world: &PhysicsWorld, body: RigidBodyHandle) -> Real {
    z_of(world.bodies[body].angvel())
}

fn run(world: &mut PhysicsWorld, seconds: Real) {
    for _ in 0..steps(world, seconds) {
        world.step();
    }
}

fn is_near(value: Real, expected: Real, tolerance: Real) -> bool {
    (value - expected).abs() <= tolerance * expected.abs()
}

/// A torque `τ` on the first wheel: `α₁ = τ / (I₁ + I₂ / r²)`, `α₂ = -α₁ / r`.
#[test]
fn wheels_turn_by_the_ratio_of_their_gear() {
    for held in HELD {
        for (rate, substeps) in RATES.into_iter().zip(SUBSTEPS.into_iter().cycle()) {
            for (ratio, mass) in RATIOS.into_iter().flat_map(|r| MASSES.map(|mass| (r, mass))) {
                let mut world = weightless(rate);
                world.integration_parameters.num_solver_iterations = substeps;
                let first = wheel(&mut world, held, 0.0, 1.0, 0.5);
                let second = wheel(&mut world, held, 2.0, mass, 0.5);
                world.insert_impulse_joint(first, second, gear(ratio));
                let alpha = 10.0;
                let total = inertia(1.0, 0.5) + inertia(mass, 0.5) / (ratio * ratio);
                world.bodies[first].add_torque(about_z(alpha * total), true);
                run(&mut world, 1.0);
                let [w1, w2] = [first, second].map(|wheel| omega(&world, wheel));
                let context = format!("{held:?}, {rate} Hz, {substeps}, ratio {ratio}, {mass} kg");
                assert!(is_near(w1, alpha, TOLERANCE), "{context}: {w1} rad/s");
                assert!(is_near(w2, -w1 / ratio, TOLERANCE), "{context}: {w2} of {w1} rad/s");
            }
        }
    }
}

/// Gears do not slip in a minute of alternating load, at more than 100 turns.
#[test]
fn gears_do_not_slip() {
    for held in HELD {
        let mut world = weightless(60);
        let first = wheel(&mut world, held, 0.0, 1.0, 0.5);
        let second = wheel(&mut world, held, 2.0, 3.0, 0.5);
        world.insert_impulse_joint(first, second, gear(1.0));
        let mut turns = 0.0;
        for step in 0..3600 {
            let torque = if step % 600 < 300 { 1.0 } else { -1.0 };
            let target = if step % 900 < 450 { first } else { second };
            world.bodies[target].reset_torques(false);
            world.bodies[target].add_torque(about_z(torque), true);
            world.step();
            turns += omega(&world, first) * world.integration_parameters.dt / TURN;
        }
        // Angles are known to a turn; with the ratio 1 the sum must vanish.
        let sum = angle(world.bodies[first].rotation()) + angle(world.bodies[second].rotation());
        let slip = (sum + 1.5 * TURN).rem_euclid(TURN) - 0.5 * TURN;
        println!("{held:?}: {turns} turns, slip {slip}");
        assert!(turns.abs() > 10.0, "the wheels turn: {turns}");
        assert!(slip.abs() < 2.0e-3, "the gear slips by {slip} rad");
    }
}

/// A train of wheels passes the load on: a motor on the first wheel against a stop of the last one.
#[test]
fn a_train_of_gears_holds_against_a_stop() {
    for rate in RATES {
        let mut world = weightless(rate);
        let mut wheels = Vec::new();
        for k in 0..5 {
            let at = vec(k as Real, 0.0);
            let wheel = world.insert_body(bob(1.0, 0.5).translation(at));
            let axle = match k {
                0 => hinge().motor_velocity(1.0, 1.0e6).motor_max_force(100.0),
                4 => hinge().limits([-0.3, 0.3]),
                _ => hinge(),
            };
            hold(&mut world, Held::ByJoint, at, wheel, axle);
            wheels.push(wheel);
        }
        for pair in wheels.windows(2) {
            world.insert_impulse_joint(pair[0], pair[1], gear(1.0));
        }
        run(&mut world, 2.0);
        for (k, wheel) in wheels.iter().enumerate() {
            let angle = angle(world.bodies[*wheel].rotation());
            let expected = if k % 2 == 0 { 0.3 } else { -0.3 };
            // Half a degree is the tolerance of limits.
            assert!((angle - expected).abs() < 0.009, "{rate} Hz: wheel {k} at {angle} rad");
            assert!(omega(&world, *wheel).abs() < 1.0e-3, "{rate} Hz: wheel {k} rests");
        }
    }
}

/// The first wheel turns by the backlash before the second one moves.
#[test]
fn backlash_lets_a_wheel_turn() {
    for held in HELD {
        let mut world = weightless(60);
        let first = wheel(&mut world, held, 0.0, 1.0, 0.5);
        let second = wheel(&mut world, held, 2.0, 1.0, 0.5);
        let joint = gear(1.0).backlash(0.4).build();
        assert!((joint.backlash() - 0.4).abs() < 1.0e-6, "it is what was set");
        world.insert_impulse_joint(first, second, joint);
        world.bodies[first].set_angvel(about_z(0.5), true);
        run(&mut world, 0.35);
        let [w1, w2] = [first, second].map(|wheel| omega(&world, wheel));
        assert!(is_near(w1, 0.5, TOLERANCE) && w2 == 0.0, "free within it: {w1}, {w2} rad/s");
        run(&mut world, 1.0);
        // Both have the same inertia, and the teeth do not bounce.
        let [w1, w2] = [first, second].map(|wheel| omega(&world, wheel));
        assert!(is_near(w1, 0.25, 0.01) && is_near(w2, -0.25, 0.01), "{held:?}: {w1}, {w2} rad/s");
    }
}

/// A torque `τ` on a pinion of radius `r` moves a rack of mass `m`: `a = r τ / (I + m r²)`.
#[test]
fn a_pinion_moves_its_rack() {
    for (held, substeps) in HELD.into_iter().flat_map(|held| SUBSTEPS.map(|n| (held, n))) {
        for (radius, mass) in [-0.3, 0.1, 2.0].into_iter().flat_map(|r| MASSES.map(|m| (r, m))) {
            let mut world = weightless(60);
            world.integration_parameters.num_solver_iterations = substeps;
            let pinion = wheel(&mut world, held, 0.0, 1.0, 0.5);
            let at = vec(0.0, 1.0);
            let body = world.insert_body(bob(mass, 0.5).translation(at));
            hold(&mut world, held, at, body, PrismaticJointBuilder::new(Vector::X));
            world.insert_impulse_joint(pinion, body, rack(radius));
            let alpha = 5.0;
            let total = inertia(1.0, 0.5) + mass * radius * radius;
            world.bodies[pinion].add_torque(about_z(alpha * total), true);
            run(&mut world, 1.0);
            let (v, x) = (world.bodies[body].linvel().x, world.bodies[body].translation().x);
            let context = format!("{held:?}, {substeps}, radius {radius}, {mass} kg");
            assert!(is_near(v, alpha * radius, TOLERANCE), "{context}: {v} m/s");
            assert!(is_near(x, 0.5 * alpha * radius, 0.02), "{context}: {x} m");
        }
    }
}

/// Two weights on a rope over two pulleys: `a₁ = g (m₁ - m₂/r) / (m₁ + m₂/r²)`, and the rope has the force
/// `m₁ (g - a₁)` on the first weight, `r` times as much on the second.
#[test]
fn weights_on_a_pulley_accelerate() {
    for (rate, substeps) in RATES.into_iter().flat_map(|rate| SUBSTEPS.map(|n| (rate, n))) {
        for (ratio, mass) in [0.5, 1.0, 2.0].into_iter().flat_map(|r| MASSES.map(|m| (r, m))) {
            let mut world = world(rate);
            world.integration_parameters.num_solver_iterations = substeps;
            let over = [vec(-1.0, 40.0), vec(1.0, 40.0)];
            let first = world.insert_body(bob(1.0, 0.1).translation(vec(-1.0, 20.0)));
            let second = world.insert_body(bob(mass, 0.1).translation(vec(1.0, 20.0)));
            let rope = PulleyJoint::new(over, 20.0 + ratio * 20.0, ratio);
            let handle = world.insert_impulse_joint(first, second, rope);
            run(&mut world, 0.5);
            let a = G * (1.0 - mass / ratio) / (1.0 + mass / (ratio * ratio));
            let [v1, v2] = [first, second].map(|body| world.bodies[body].linvel().y);
            let context = format!("{rate} Hz, {substeps}, ratio {ratio}, {mass} kg");
            let tolerance = TOLERANCE * G;
            assert!((v1 + 0.5 * a).abs() < tolerance, "{context}: {v1} of {} m/s", -0.5 * a);
            assert!((v2 - 0.5 * a / ratio).abs() < tolerance, "{context}: {v2} m/s");
            let pull = world.impulse_joints.get(handle).expect("it is there").force().y;
            let expected = ratio * (G - a);
            assert!(is_near(pull, expected, 5.0 * TOLERANCE), "{context}: {pull} of {expected} N");
        }
    }
}

/// The rope never pushes: a weight that is thrown up is free until the rope is straight again.
#[test]
fn a_slack_rope_does_not_push() {
    let mut world = world(60);
    let over = [vec(-1.0, 10.0), vec(1.0, 10.0)];
    let first = world.insert_body(bob(1.0, 0.1).translation(vec(-1.0, 5.0)));
    let second = world.insert_body(bob(1.0, 0.1).translation(vec(1.0, 5.0)));
    world.insert_impulse_joint(first, second, PulleyJoint::new(over, 10.0, 1.0));
    world.bodies[first].set_linvel(vec(0.0, 3.0), true);
    world.bodies[second].set_linvel(vec(0.0, 1.0), true);
    run(&mut world, 0.2);
    let [v1, v2] = [first, second].map(|body| world.bodies[body].linvel().y);
    assert!(is_near(v1, 3.0 - 0.2 * G, 0.01), "the first one is free: {v1} m/s");
    assert!(is_near(v2, 1.0 - 0.2 * G, 0.01), "the second one is free: {v2} m/s");
    run(&mut world, 2.0);
    let [y1, y2] = [first, second].map(|body| world.bodies[body].translation().y);
    assert!((20.0 - y1 - y2 - 10.0) < 2.0e-3, "the rope is not stretched: {y1}, {y2}");
}

/// A weight swings on one end of the rope, the other one moves up and down (Tufillaro, Abbott and Griffiths,
/// "Swinging Atwood's machine", 1984): the energy is constant, and the rope keeps its length.
#[test]
fn a_swinging_pulley_keeps_its_energy() {
    for rate in RATES {
        let mut world = world(rate);
        let over = [vec(-1.0, 0.0), vec(1.0, 0.0)];
        let swinging = world.insert_body(bob(1.0, 0.1).translation(vec(-1.0 + 2.0, -2.0)));
        let weight = world.insert_body(bob(2.0, 0.1).translation(vec(1.0, -5.0)));
        let length = 5.0 + (8.0 as Real).sqrt();
        world.insert_impulse_joint(swinging, weight, PulleyJoint::new(over, length, 1.0));
        let energy = |world: &PhysicsWorld| -> Real {
            let bodies = [swinging, weight].map(|body| &world.bodies[body]);
            let energies = bodies.map(|body| {
                body.mass() * (0.5 * body.linvel().length_squared() + G * body.translation().y)
            });
            energies.iter().sum()
        };
        let start = energy(&world);
        let (mut error, mut stretch): (Real, Real) = (0.0, 0.0);
        for _ in 0..steps(&world, 20.0) {
            world.step();
            error = error.max((energy(&world) - start).abs());
            let [one, two] = [swinging, weight].map(|body| world.bodies[body].translation());
            stretch = stretch.max((one - over[0]).length() + (two - over[1]).length() - length);
        }
        println!("{rate} Hz: error of the energy {error}, stretch {stretch}");
        // Of m g L, the energy of the pendulum.
        assert!(error < 0.01 * G * 8.0_f32 as Real, "{rate} Hz: energy is off by {error} J");
        assert!(stretch < 5.0e-3, "{rate} Hz: the rope is longer by {stretch} m");
    }
}

/// A drum that a program rotates winds a rope up: the weight rises by `radius · angle`.
#[test]
fn a_kinematic_drum_lifts_a_weight() {
    for held in HELD {
        let mut world = world(60);
        let drum = world.insert_body(RigidBodyBuilder::kinematic_velocity_based());
        let at = vec(3.0, -4.0);
        let weight = world.insert_body(bob(100.0, 0.3).translation(at));
        if matches!(held, Held::AsLink) {
            let rail = post(&mut world, at);
            let slider = PrismaticJointBuilder::new(Vector::Y);
            world.insert_multibody_joint(rail, weight, slider).expect("it fits");
        }
        let mut winch: GenericJoint = gear(1.0).build().into();
        let ends = [TransmissionEnd::Angle, TransmissionEnd::Distance { from: vec(3.0, 0.0) }];
        winch.set_transmission(Transmission::new(ends, [0.2, 1.0]));
        winch.set_limits(JointAxis::LinX, [-Real::MAX, 4.0]);
        world.insert_impulse_joint(drum, weight, winch);
        run(&mut world, 1.0);
        world.bodies[drum].set_angvel(about_z(2.0), true);
        run(&mut world, 5.0);
        let y = world.bodies[weight].translation().y;
        let expected = -4.0 + 0.2 * 2.0 * 5.0;
        assert!((y - expected).abs() < 5.0e-3, "{held:?}: the weight is at {y}, not {expected}");
    }
}

/// A load of many times the mass of the hook on which it hangs at the end of the rope: as steady as on a rope
/// between two bodies.
#[test]
fn light_hooks_on_pulleys_carry_heavy_loads() {
    for (mass, substeps) in [(0.003, 2), (0.001, 4)] {
        let mut world = world(60);
        world.integration_parameters.num_solver_iterations = substeps;
        let anchor = post(&mut world, vec(4.0, -2.0));
        let hook = world.insert_body(bob(mass, 0.02).translation(vec(0.0, -1.0)));
        let load = world.insert_body(bob(100.0, 0.3).translation(vec(0.0, -1.0)));
        world.insert_impulse_joint(hook, load, hinge());
        let over = [vec(4.0, 0.0), Vector::ZERO];
        world.insert_impulse_joint(anchor, hook, PulleyJoint::new(over, 3.0, 1.0));
        world.bodies[load].set_linvel(vec(1.0, 0.0), true);
        let (mut fastest, mut farthest): (Real, Real) = (0.0, 0.0);
        for _ in 0..steps(&world, 10.0) {
            world.step();
            fastest = fastest.max(world.bodies[load].linvel().length());
            farthest = farthest.max(world.bodies[hook].translation().length());
        }
        println!("{mass} kg, {substeps}: {fastest} m/s, {farthest} m");
        assert!(fastest < 1.02, "{mass} kg, {substeps} substeps: the load has {fastest} m/s");
        assert!(farthest < 1.01, "{mass} kg, {substeps} substeps: the hook is at {farthest} m");
    }
}

/// A weight that is pulled up to its pulley blocks the rope: the heavy one does not fall on.
#[test]
fn a_weight_at_its_pulley_blocks_the_rope() {
    for (mass, substeps) in [30.0, 100.0, 1000.0].into_iter().flat_map(|m| SUBSTEPS.map(|n| (m, n)))
    {
        let mut world = world(60);
        world.integration_parameters.num_solver_iterations = substeps;
        let over = [vec(-1.0, 0.0), vec(1.0, 0.0)];
        let light = world.insert_body(bob(1.0, 0.1).translation(vec(-1.0, -1.0)));
        let heavy = world.insert_body(bob(mass, 0.1).translation(vec(1.0, -1.0)));
        world.insert_impulse_joint(light, heavy, PulleyJoint::new(over, 2.0, 1.0));
        run(&mut world, 10.0);
        let y = world.bodies[heavy].translation().y;
        println!("{mass} kg, {substeps}: {y}");
        assert!(y > -2.1, "{mass} kg, {substeps} substeps: the heavy one is at {y}");
    }
}

/// A geared arm that hits a post at 100 m/s stops within the step, and the gear does not slip.
#[test]
fn gears_do_not_slip_when_an_arm_is_stopped() {
    for held in HELD {
        let mut world = weightless(60);
        let first = wheel(&mut world, held, 0.0, 1.0, 0.5);
        let second = wheel(&mut world, held, 5.0, 1.0, 0.5);
        let arm = ColliderBuilder::ball(0.05).translation(vec(2.0, 0.0));
        world.insert_collider(arm.restitution(0.5), Some(first));
        world.bodies[first].enable_ccd(true);
        world.insert_collider(ColliderBuilder::ball(0.05).translation(vec(0.0, 2.0)), None);
        world.insert_impulse_joint(first, second, gear(1.0));
        world.bodies[first].set_angvel(about_z(50.0), true);
        run(&mut world, 1.0);
        let sum = angle(world.bodies[first].rotation()) + angle(world.bodies[second].rotation());
        let slip = (sum + 1.5 * TURN).rem_euclid(TURN) - 0.5 * TURN;
        println!("{held:?}: slip {slip}");
        assert!(slip.abs() < 5.0e-3, "{held:?}: the gear slips by {slip} rad");
    }
}

/// A pulley on a corner of a net that is solved iteratively holds its length.
#[test]
fn a_pulley_holds_the_corner_of_a_net() {
    const KNOTS: usize = 12;
    let mut world = world(60);
    let at = |i: usize, j: usize| vec(0.5 * i as Real, -0.5 * j as Real);
    let mut knots = Vec::new();
    for (i, j) in (0..KNOTS * KNOTS).map(|k| (k % KNOTS, k / KNOTS)) {
        let knot = bob(0.1, 0.1).translation(at(i, j));
        let is_fixed = j == 0 && i + 1 < KNOTS;
        let knot = if is_fixed { RigidBodyBuilder::fixed().translation(at(i, j)) } else { knot };
        knots.push(world.insert_body(knot));
        let mut tie = |other: usize, way: Vector| {
            let joint = hinge().local_anchor1(way);
            world.insert_impulse_joint(knots[other], knots[i + KNOTS * j], joint);
        };
        if i > 0 {
            tie(i - 1 + KNOTS * j, vec(0.5, 0.0));
        }
        if j > 0 {
            tie(i + KNOTS * (j - 1), vec(0.0, -0.5));
        }
    }
    let corner = knots[KNOTS - 1];
    let weight = world.insert_body(bob(1.0, 0.1).translation(vec(10.0, 0.0)));
    let over = [vec(5.5, 3.0), vec(10.0, 3.0)];
    world.insert_impulse_joint(corner, weight, PulleyJoint::new(over, 6.0, 1.0));
    run(&mut world, 3.0);
    let distance = |body, k: usize| (world.bodies[body].translation() - over[k]).length();
    let length = distance(corner, 0) + distance(weight, 1);
    assert!(length < 6.01, "the rope of 6 m has {length} m");
    assert!(world.bodies[weight].linvel().length() < 10.0, "nothing flies");
}

/// What a transmission has counted belongs to its bodies.
#[test]
fn new_bodies_begin_at_zero() {
    let mut world = world(60);
    let drum = |world: &mut PhysicsWorld| {
        world.insert_body(RigidBodyBuilder::kinematic_velocity_based().angvel(about_z(2.0)))
    };
    let first = drum(&mut world);
    let weight = world.insert_body(bob(1.0, 0.1).translation(vec(0.0, -1.0)));
    let mut winch = GenericJoint::new(JointAxesMask::empty());
    let ends = [TransmissionEnd::Angle, TransmissionEnd::Distance { from: Vector::ZERO }];
    winch.set_transmission(Transmission::new(ends, [-0.2, 1.0]));
    winch.set_limits(JointAxis::LinX, [-Real::MAX, 1.0]);
    winch.set_local_frame1(gear(1.0).build().data.local_frame1);
    let joint = world.insert_impulse_joint(first, weight, winch);
    run(&mut world, 2.0);
    let y = world.bodies[weight].translation().y;
    assert!((y + 1.8).abs() < 0.02, "4 rad of the drum let the rope out by 0.8 m: {y}");
    let second = world.insert_body(RigidBodyBuilder::fixed());
    world.impulse_joints.set_bodies(joint, second, weight);
    run(&mut world, 5.0);
    let y = world.bodies[weight].translation().y;
    assert!(y > -1.02, "the rope of the new drum has 1 m again: {y}");
}

/// A joint whose bodies change places is the same joint.
#[test]
fn a_flipped_gear_is_the_same_gear() {
    let mut flipped: GenericJoint = gear(4.0).backlash(0.1).build().into();
    let before = flipped;
    flipped.flip();
    assert_ne!(flipped, before, "the ends change places");
    let mut world = weightless(60);
    let first = wheel(&mut world, Held::ByJoint, 0.0, 1.0, 0.5);
    let second = wheel(&mut world, Held::ByJoint, 2.0, 1.0, 0.5);
    world.insert_impulse_joint(second, first, flipped);
    world.bodies[first].set_angvel(about_z(4.0), true);
    run(&mut world, 1.0);
    let [w1, w2] = [first, second].map(|wheel| omega(&world, wheel));
    assert!(is_near(w1, -4.0 * w2, TOLERANCE) && w1 > 1.0, "{w1}, {w2} rad/s");
    flipped.flip();
    assert_eq!(flipped, before, "two flips change nothing");
}

/// Unusable numbers are refused by name, and unusable joints do not act.
#[test]
fn nonsense_is_refused() {
    let ends = [TransmissionEnd::Angle; 2];
    let mut joint = GenericJoint::new(JointAxesMask::empty());
    for ratio in [0.0, Real::NAN, Real::INFINITY, 1.0e-20, 1.0e20] {
        let error = joint.try_set_transmission(Transmission::new(ends, [1.0, ratio]));
        let error = error.expect_err("the ratio is unusable").to_string();
        assert!(error.contains("ratio"), "{error}");
    }
    let far = [TransmissionEnd::Distance { from: Vector::X * Real::NAN }; 2];
    let error = joint.try_set_transmission(Transmission::new(far, [1.0; 2]));
    assert!(matches!(error, Err(InvalidJoint::Anchor { .. })), "{error:?}");
    assert!(joint.transmission().is_none(), "nothing was changed");
    joint.set_transmission(Transmission::new(ends, [1.0, 1.0]));
    assert_eq!(joint.validate(), Ok(()), "a transmission without limits is valid");
    joint.coupled_axes = JointAxesMask::LIN_AXES;
    assert!(matches!(joint.validate(), Err(InvalidJoint::TransmissionAxes { .. })), "coupled axes");
    assert!(joint.as_rope().is_none() && joint.as_gear().is_some(), "it is a gear");
    joint.coupled_axes = JointAxesMask::empty();
    joint.lock_axes(JointAxesMask::LIN_X);
    assert!(matches!(joint.validate(), Err(InvalidJoint::TransmissionAxes { .. })), "locked axes");
    let mut pulley = PulleyJoint::new([Vector::ZERO; 2], 1.0, 2.0);
    pulley.set_length(-1.0).set_length(Real::NAN).set_ratio(-1.0).set_ratio(1.0e9);
    assert_eq!((pulley.length(), pulley.ratio()), (1.0, 2.0), "ropes do not push");
    let mut world = weightless(60);
    let [first, second] =
        [0.0, 1.0].map(|x| world.insert_body(bob(1.0, 0.1).translation(vec(x, 0.0))));
    let error = world.multibody_joints.try_insert(first, second, gear(1.0), true);
    assert!(matches!(error, Err(InvalidJoint::TransmissionInMultibody)), "{error:?}");
}
