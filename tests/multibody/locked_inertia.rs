//! Locked multibodies move like rigid bodies: they fall, slide, roll and bounce without additional
//! rotation.

use super::stage::{angular_momentum, kinetic_energy, momentum};
use crate::dim::{about_z, ang_length, hinge, vec};
use crate::suite::physics::stage::{G, add_ground, run, steps, substep, weightless, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Adds a chain of thin capsules along x, hinged end to end, that rotates about its middle at `spin` and
/// moves at `velocity`.
fn thin_chain(
    world: &mut PhysicsWorld,
    count: usize,
    velocity: Vector,
    spin: Real,
) -> Vec<RigidBodyHandle> {
    let mut links = Vec::new();
    for k in 0..count {
        let arm = vec((k as Real - 0.5 * (count - 1) as Real) * 0.6, 0.0);
        let body = RigidBodyBuilder::dynamic().translation(arm).can_sleep(false);
        let body = body.linvel(velocity + vec(0.0, spin * arm.x + 0.1 * k as Real));
        let capsule = ColliderBuilder::capsule_x(0.25, 0.03);
        let (body, _) = world.insert(body.angvel(about_z(spin)), capsule);
        if let Some(&last) = links.last() {
            let joint = hinge().local_anchor1(vec(0.3, 0.0)).local_anchor2(vec(-0.3, 0.0));
            let joint = world.insert_multibody_joint(last, body, joint.contacts_enabled(false));
            joint.expect("the joint fits");
        }
        links.push(body);
    }
    links
}

/// Adds two balls of radius 0.25 side by side, welded to one multibody.
fn pair(world: &mut PhysicsWorld, at: Vector, collider: &ColliderBuilder) -> [RigidBodyHandle; 2] {
    let [first, second] = [0.0, 0.6].map(|x| {
        let body = RigidBodyBuilder::dynamic().translation(at + vec(x, 0.0)).can_sleep(false);
        world.insert(body, collider.clone()).0
    });
    let weld = FixedJointBuilder::new().local_anchor1(vec(0.6, 0.0));
    world.insert_multibody_joint(first, second, weld).expect("the joint fits");
    [first, second]
}

/// Two links rotate about each other at 10 rad/s while they move at 5 m/s through empty space. One is up to a
/// hundred times as heavy. Momentum and energy are constant in any frame. (There are no contacts, so there is
/// no contact error.)
#[test]
fn rotating_links_in_free_motion_conserve_momentum_and_energy() {
    for ratio in [1.0, 10.0, 100.0] {
        let mut world = weightless(60);
        let center = ratio / (1.0 + ratio);
        let mut link = |x: Real, mass: Real| {
            let body = RigidBodyBuilder::dynamic().translation(vec(x, 0.0)).can_sleep(false);
            let body = body.linvel(vec(5.0, 10.0 * x)).angvel(about_z(10.0));
            world.insert(body, ColliderBuilder::ball(0.2).mass(mass)).0
        };
        let links = [link(-center, 1.0), link(1.0 - center, ratio)];
        let joint = hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
        world.insert_multibody_joint(links[0], links[1], joint).expect("the joint fits");
        run(&mut world, 0.05);
        let (before, energy) = (momentum(&world, &links), kinetic_energy(&world, &links));
        run(&mut world, 10.0);
        let missing = (momentum(&world, &links) - before).length() / before.length();
        assert!(missing < 1.0e-3, "1:{ratio}: {missing} of the momentum is missing");
        let left = kinetic_energy(&world, &links) / energy;
        assert!((left - 1.0).abs() < 0.01, "1:{ratio}: {left} of the energy is left");
    }
}

/// Chains of thin limbs tumble in free fall: the centre of mass follows the parabola, and spin and
/// internal energy are constant. The momentum is rounded in each substep, at the size of speeds of 50
/// m/s. The error of the energy is of second order in the angle of the fastest link per substep.
#[test]
fn tumbling_chains_fall_like_bodies() {
    let columns = ["rate", "spin", "velocity off by", "L off by (%)", "E off by (%)"];
    let mut table = Table::new("chains of thin limbs that tumble in a fall of 5 s", &columns);
    for rate in [60, 120] {
        for (count, spin) in [(4, 5.0), (6, 8.0), (4, 15.0)] {
            let mut world = world(rate);
            let chain = thin_chain(&mut world, count, vec(3.0, 0.0), spin);
            let mass: Real = chain.iter().map(|&link| world.bodies[link].mass()).sum();
            let middle = |world: &PhysicsWorld| {
                let of =
                    |&link: &_| world.bodies[link].center_of_mass() * world.bodies[link].mass();
                chain.iter().map(of).sum::<Vector>() / mass
            };
            // The energy is relative to the centre of mass.
            let inner = |world: &PhysicsWorld| {
                let (p, at) = (momentum(world, &chain), middle(world));
                let spin = angular_momentum(world, &chain) - crate::dim::moment(at, p);
                (p, spin, kinetic_energy(world, &chain) - 0.5 * p.length_squared() / mass)
            };
            world.step();
            let (p, l, energy) = inner(&world);
            let (seconds, mut fastest) = (5.0, spin);
            for _ in 0..steps(&world, seconds) {
                world.step();
                let turning = chain.iter().map(|&link| ang_length(world.bodies[link].angvel()));
                fastest = turning.fold(fastest, Real::max);
            }
            let (p2, l2, energy2) = inner(&world);
            let missed = ((p2 - p) / mass - vec(0.0, -G * seconds)).length();
            let turned = ang_length(l2 - l) / ang_length(l);
            let gained = (energy2 / energy - 1.0).abs();
            table.row([
                rate.to_string(),
                format!("{spin}"),
                format!("{missed:.5}"),
                format!("{:.4}", turned * 100.0),
                format!("{:.4}", gained * 100.0),
            ]);
            let angle = fastest * substep(&world);
            table.check("the velocity", missed, 0.0, 0.01);
            table.check("the angular momentum", turned, 0.0, 0.01);
            table.check("the energy", gained, 0.0, Real::max(0.01, angle * angle));
        }
    }
}

/// Without friction the ground rotates no body, independent of the contact's motion per step: here 17 cm.
#[test]
fn sliding_bodies_do_not_turn() {
    for hinged in [false, true] {
        let mut world = world(60);
        add_ground(&mut world, 0.0);
        let ball = ColliderBuilder::ball(0.25).friction(0.0);
        let ball = ball.friction_combine_rule(CoefficientCombineRule::Min);
        let bodies = pair(&mut world, vec(0.0, 0.25), &ball);
        if hinged {
            let tip = RigidBodyBuilder::dynamic().translation(vec(1.2, 0.25)).can_sleep(false);
            let (tip, _) = world.insert(tip, ball);
            let joint = hinge().local_anchor1(vec(0.3, 0.0)).local_anchor2(vec(-0.3, 0.0));
            world.insert_multibody_joint(bodies[1], tip, joint).expect("the joint fits");
        }
        let all: Vec<_> = world.bodies.iter().filter(|(_, body)| body.is_dynamic()).collect();
        let all: Vec<_> = all.into_iter().map(|(handle, _)| handle).collect();
        for &body in &all {
            world.bodies[body].set_linvel(vec(10.0, 0.0), true);
        }
        run(&mut world, 2.0);
        for &body in &all {
            let body = &world.bodies[body];
            assert!(ang_length(body.angvel()) < 0.02, "turns at {:?}", body.angvel());
            assert!((body.linvel() - vec(10.0, 0.0)).length() < 0.02, "goes at {}", body.linvel());
        }
    }
}

/// A hub with two wheels on hinges keeps rolling at its speed, and the hub does not rotate.
#[test]
fn wheels_of_a_multibody_roll() {
    let (radius, speed) = (0.3, 3.0);
    let mut world = world(60);
    add_ground(&mut world, 1.0);
    let hub = RigidBodyBuilder::dynamic().translation(vec(0.0, radius)).can_sleep(false);
    let (hub, _) = world.insert(hub, ColliderBuilder::ball(0.05));
    let mut all = vec![hub];
    for side in [-1.0, 1.0] {
        let wheel = RigidBodyBuilder::dynamic().translation(vec(side, radius)).can_sleep(false);
        let wheel = wheel.angvel(about_z(-speed / radius));
        let (wheel, _) = world.insert(wheel, ColliderBuilder::ball(radius).friction(1.0));
        let axle = hinge().local_anchor1(vec(side, 0.0));
        world.insert_multibody_joint(hub, wheel, axle).expect("the joint fits");
        all.push(wheel);
    }
    for &body in &all {
        world.bodies[body].set_linvel(vec(speed, 0.0), true);
    }
    run(&mut world, 3.0);
    let hub = &world.bodies[hub];
    assert!(ang_length(hub.angvel()) < 0.05, "the hub turns at {:?}", hub.angvel());
    assert!((hub.linvel().x / speed - 1.0).abs() < 0.01, "it goes at {}", hub.linvel());
}

/// A frictionless bounce changes neither the spin nor the apex.
#[test]
fn spin_does_not_change_the_bounce() {
    let mut table = Table::new(
        "two balls that spin about the upright axis and bounce",
        &["spin (rad/s)", "apex (m)"],
    );
    for spin in [0.0, 20.0, 40.0] {
        for slide in [0.0, 5.0] {
            let mut world = world(60);
            add_ground(&mut world, 0.0);
            let ball = ColliderBuilder::ball(0.25).friction(0.0).restitution(1.0);
            let ball = ball.friction_combine_rule(CoefficientCombineRule::Min);
            let ball = ball.restitution_combine_rule(CoefficientCombineRule::Max);
            let height = 1.0;
            let bodies = pair(&mut world, vec(0.0, 0.25 + height), &ball);
            for (body, x) in bodies.into_iter().zip([-0.3, 0.3]) {
                crate::dim::spin_upright(&mut world.bodies[body], spin, x, slide);
            }
            let fall = (2.0 * height / G).sqrt();
            run(&mut world, 1.2 * fall);
            let mut apex: Real = 0.0;
            for _ in 0..steps(&world, 1.2 * fall) {
                world.step();
                apex = apex.max(world.bodies[bodies[0]].translation().y - 0.25);
            }
            table.row([format!("{spin}"), format!("{apex:.3}")]);
            // In a step at the ground the ball moves by 7 cm, so the contact is 1 cm deep for a moment.
            table.check("the apex", apex, height, 0.02);
        }
    }
}

/// A rotation on a carriage continues at any speed of the carriage: nothing in its frame does work.
#[test]
fn arms_on_carriages_turn_on() {
    for (speed, spin) in [(3.0, 3.0), (10.0, 10.0), (20.0, 20.0)] {
        let mut world = weightless(60);
        let carriage = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(speed, 0.0));
        let carriage = world.insert_body(carriage);
        let arm = RigidBodyBuilder::dynamic().translation(vec(0.0, -1.0)).can_sleep(false);
        let (arm, _) = world.insert(arm, ColliderBuilder::ball(0.1));
        let joint = hinge().local_anchor2(vec(0.0, 1.0));
        let joint = world.insert_multibody_joint(carriage, arm, joint).expect("the joint fits");
        world.step();
        let rate = |world: &mut PhysicsWorld| -> Real {
            let (multibody, _) = world.multibody_joints.get_mut(joint).expect("it is there");
            multibody.generalized_velocity()[0]
        };
        let (multibody, _) = world.multibody_joints.get_mut(joint).expect("it is there");
        multibody.generalized_velocity_mut()[0] = spin;
        run(&mut world, 2.0);
        let now = rate(&mut world);
        assert!((now / spin - 1.0).abs() < 1.0e-3, "{speed} m/s: {spin} rad/s became {now}");
    }
}

/// Undamped springs of degrees of freedom keep oscillating: at 2 Hz and 240 substeps per second they lose 0.2
/// % of their amplitude in three seconds.
#[test]
fn springs_of_degrees_of_freedom_swing_on() {
    for rate in [60, 120] {
        let mut world = weightless(rate);
        let post = world.insert_body(RigidBodyBuilder::fixed());
        let bob = RigidBodyBuilder::dynamic().translation(vec(1.0, 0.0)).can_sleep(false);
        let (bob, _) = world.insert(bob, ColliderBuilder::ball(0.1).mass(1.0));
        let slider = PrismaticJointBuilder::new(vec(1.0, 0.0))
            .motor_model(MotorModel::ForceBased)
            .motor_position(0.0, 200.0, 0.0);
        world.insert_multibody_joint(post, bob, slider).expect("the joint fits");
        let energy = |world: &PhysicsWorld| {
            let body = &world.bodies[bob];
            0.5 * body.linvel().length_squared() + 100.0 * body.translation().length_squared()
        };
        world.step();
        let start = energy(&world);
        run(&mut world, 3.0);
        // Position and velocity are half a substep apart: `h ω / 2`, in either direction.
        let apart = substep(&world) * Real::sqrt(200.0);
        let kept = energy(&world) / start;
        assert!((kept - 1.0).abs() < 0.01 + apart, "{rate} Hz: kept {kept} of the energy");
    }
}
