//! Multibodies with extreme motors, extreme mass ratios, and edits at any time.

use super::stage::{chain, slab};
use crate::dim::{about_z, cuboid, hinge, loose_joint, vec};
use crate::suite::joints::stage::bob;
use crate::suite::physics::stage::{Dice, RATES, add_ground, run, weightless, world};
use rapier::prelude::*;

fn assert_finite(world: &PhysicsWorld, what: &str) {
    for (handle, body) in world.bodies.iter() {
        let numbers = body.translation().is_finite() && body.linvel().is_finite();
        let turns = (body.angvel() - body.angvel()) == about_z(0.0);
        assert!(numbers && turns, "{what}: {handle:?} at {}", body.translation());
    }
}

/// No link exceeds the speed limit of bodies, whatever the cause: forces, torques, motors, or setters.
#[test]
fn links_are_no_faster_than_bodies_may_be() {
    for rate in RATES {
        for force in [1.0e3, 1.0e6, 1.0e12, 1.0e30] {
            for hangs in [true, false] {
                let mut world = world(rate);
                world.integration_parameters.normalized_max_linear_velocity = 20.0;
                let post = hangs.then(|| world.insert_body(RigidBodyBuilder::fixed()));
                let chain = chain(&mut world, post, 4);
                let mut most: Real = 0.0;
                for k in 0..20 {
                    if k < 10 {
                        world.bodies[chain.bodies[3]].add_force(vec(0.3 * force, force), true);
                        world.bodies[chain.bodies[2]].add_torque(about_z(force), true);
                    } else {
                        world.bodies[chain.bodies[3]].reset_forces(true);
                        world.bodies[chain.bodies[2]].reset_torques(true);
                    }
                    world.step();
                    let speeds = world.bodies.iter().map(|(_, body)| body.linvel().length());
                    most = speeds.fold(most, Real::max);
                    assert_finite(&world, &format!("{force} N"));
                }
                // At the end of a step the links rotate from the pose of the speed limit to a pose with the
                // same momentum. This changes the velocities by the rotation of a substep.
                assert!(most < 21.0, "{force} N at {rate} Hz: {most} m/s");
            }
        }
    }
}

/// Masses, steps and motors beyond any valid simulation leave finite numbers.
#[test]
fn extremes_stay_finite() {
    for dt in [1.0e-9, 1.0 / 60.0, 10.0] {
        for masses in [[1.0e-9, 1.0e9], [1.0e9, 1.0e-9], [1.0e-9, 1.0e-9], [0.0, 1.0]] {
            for torque in [0.0, 1.0e6, 1.0e30] {
                let mut world = world(60);
                world.integration_parameters.dt = dt;
                add_ground(&mut world, 0.5);
                let mut parent = None;
                let mut joints = Vec::new();
                for k in 0..6 {
                    let at = vec(k as Real, 0.3);
                    let body = RigidBodyBuilder::dynamic().translation(at);
                    let shape = cuboid(0.4, 0.2).mass(masses[k % 2]).restitution(0.5);
                    let (body, _) = world.insert(body, shape);
                    if let Some(parent) = parent {
                        let joint =
                            hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
                        let joint = joint.limits([-1.0, 1.0]).motor_velocity(torque, 1.0e9);
                        let joint = if k % 2 == 0 { joint.motor_max_force(torque) } else { joint };
                        joints
                            .push(world.insert_multibody_joint(parent, body, joint).expect("fits"));
                    }
                    parent = Some(body);
                }
                let (multibody, _) = world.multibody_joints.get_mut(joints[0]).expect("there");
                multibody.armature_mut().fill(0.0);
                for _ in 0..10 {
                    world.bodies[parent.expect("a link")].add_torque(about_z(torque), true);
                    world.step();
                    assert_finite(&world, &format!("dt {dt}, masses {masses:?}, {torque} N m"));
                }
            }
        }
    }
}

/// Warm-start impulses belong to the old length of a substep. Shorter substeps must not throw resting or
/// suspended bodies.
#[test]
fn changed_substeps_throw_no_body() {
    let mut world = world(60);
    add_ground(&mut world, 0.6);
    let mut bodies = Vec::new();
    let joint = || hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
    // A chain lies on the ground, with a box on it.
    for k in 0..8 {
        let body = RigidBodyBuilder::dynamic().translation(vec(k as Real, 0.2)).can_sleep(false);
        let (body, _) = world.insert(body, cuboid(0.45, 0.2).friction(0.6));
        if let Some(&parent) = bodies.last() {
            world.insert_multibody_joint(parent, body, joint()).expect("it fits");
        }
        bodies.push(body);
    }
    let lid = RigidBodyBuilder::dynamic().translation(vec(3.5, 0.6)).can_sleep(false);
    world.insert(lid, cuboid(1.0, 0.2).density(5.0).friction(0.6));
    // Joints of an arm have limits, motors with force limits, dry friction and a loop.
    let post = world.insert_body(RigidBodyBuilder::fixed().translation(vec(-20.0, 5.0)));
    let mut parent = post;
    for k in 0..4 {
        let at = vec(k as Real - 19.5, 5.0);
        let body = world.insert_body(slab(at));
        let joint = joint().local_anchor1(vec(if k == 0 { 0.0 } else { 0.5 }, 0.0));
        let joint = match k {
            0 => joint.limits([0.0, 1.0]),
            1 => joint.motor_position(0.0, 1.0e5, 1.0e3).motor_max_force(1.0e4),
            _ => joint,
        };
        let handle = world.insert_multibody_joint(parent, body, joint).expect("it fits");
        if k == 2 {
            let (multibody, link) = world.multibody_joints.get_mut(handle).expect("it is there");
            let dof = multibody.link(link).expect("a link").assembly_id();
            multibody.frictions_mut()[dof] = 1.0e4;
        }
        parent = body;
        bodies.push(body);
    }
    let hook = loose_joint(1, vec(4.0, 0.0), vec(0.5, 0.0));
    world.insert_impulse_joint(post, parent, hook);
    run(&mut world, 2.0);
    let fastest = |world: &PhysicsWorld| {
        bodies.iter().map(|&body| world.bodies[body].linvel().length()).fold(0.0, Real::max)
    };
    let before = fastest(&world);
    for &body in &bodies {
        world.bodies[body].set_additional_solver_iterations(28);
    }
    let mut most: Real = 0.0;
    for _ in 0..3 {
        world.step();
        most = most.max(fastest(&world));
    }
    println!("{before} m/s before, {most} m/s after");
    // Eight times the impulses of a substep of 1/1920 s would give 4 cm/s. The softness follows the substep,
    // so some overlap is pushed out.
    assert!(most < before + 1.0e-2, "{most} m/s");
}

/// An impulse joint connects two multibodies. Both the joint and the multibodies are cut in mid-air.
#[test]
fn joined_multibodies_are_cut_in_mid_air() {
    let mut world = world(60);
    add_ground(&mut world, 0.5);
    let [one, two] = [0.0, 6.0].map(|x| {
        let chain = chain(&mut world, None, 4);
        for &body in &chain.bodies {
            let at = world.bodies[body].translation() + vec(x, 6.0);
            world.bodies[body].set_translation(at, true);
        }
        chain
    });
    let tie = loose_joint(0, vec(2.5, 0.0), vec(-0.5, 0.0));
    let tie = world.insert_impulse_joint(one.bodies[3], two.bodies[0], tie);
    run(&mut world, 0.2);
    world.bodies[one.bodies[1]].apply_impulse(vec(0.0, 5.0), true);
    world.remove_body(two.bodies[1]);
    run(&mut world, 0.2);
    assert_finite(&world, "a body was removed");
    world.impulse_joints.remove(tie, true);
    world.multibody_joints.remove(one.joints[1], true);
    // The detached part hangs on the other chain now, in reverse order.
    let joint = hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
    assert!(world.insert_multibody_joint(two.bodies[3], one.bodies[2], joint).is_some());
    run(&mut world, 2.0);
    assert_finite(&world, "links have new parents");
    let [tip, link] = [two.bodies[3], one.bodies[2]].map(|body| *world.bodies[body].position());
    let gap = tip * vec(0.5, 0.0) - link * vec(-0.5, 0.0);
    assert!(gap.length() < 1.0e-3, "joined at {gap}");
}

/// A sleeping chain wakes as a whole when a body falls on one link, or when one of its joints is edited.
#[test]
fn sleeping_chains_wake() {
    let mut world = world(60);
    add_ground(&mut world, 0.6);
    let mut bodies = Vec::new();
    let mut last = None;
    for k in 0..5 {
        let body = RigidBodyBuilder::dynamic().translation(vec(k as Real, 0.2));
        let (body, _) = world.insert(body, cuboid(0.45, 0.2).friction(0.6));
        if let Some(&parent) = bodies.last() {
            let joint = hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
            last = world.insert_multibody_joint(parent, body, joint);
        }
        bodies.push(body);
    }
    run(&mut world, 3.0);
    let asleep = |world: &PhysicsWorld| {
        bodies.iter().filter(|&&body| world.bodies[body].is_sleeping()).count()
    };
    assert_eq!(asleep(&world), 5);
    let (multibody, link) = world.multibody_joints.get_mut(last.expect("a joint")).expect("there");
    let data = &mut multibody.link_mut(link).expect("a link").joint.data;
    data.set_motor_velocity(JointAxis::AngX, 1.0, 10.0);
    world.step();
    assert_eq!(asleep(&world), 0, "a motor was set");
    let (multibody, link) = world.multibody_joints.get_mut(last.expect("a joint")).expect("there");
    multibody.link_mut(link).expect("a link").joint.data.set_motor_velocity(
        JointAxis::AngX,
        0.0,
        10.0,
    );
    run(&mut world, 5.0);
    assert_eq!(asleep(&world), 5);
    let ball = RigidBodyBuilder::dynamic().translation(vec(1.0, 1.5));
    world.insert(ball, ColliderBuilder::ball(0.2).density(5.0));
    run(&mut world, 0.6);
    assert_eq!(asleep(&world), 0, "it was hit");
}

/// A sensor on a link detects bodies without forces. A link with a disabled joint is a free body until the
/// joint is enabled.
#[test]
fn sensors_and_disabled_joints() {
    let mut world = weightless(60);
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let arm = world.insert_body(bob(1.0, 0.2).translation(vec(1.0, 0.0)).linvel(vec(0.0, 1.0)));
    let sensor =
        world.insert_collider(ColliderBuilder::ball(0.3).density(0.0).sensor(true), Some(arm));
    let joint = hinge().local_anchor2(vec(-1.0, 0.0));
    let handle = world.insert_multibody_joint(post, arm, joint).expect("it fits");
    let wall = ColliderBuilder::ball(0.3).translation(vec(0.0, 1.0));
    let wall = world.insert_collider(wall, None);
    run(&mut world, 1.5);
    assert_eq!(world.intersection_pair(sensor, wall), Some(true));
    let speed = world.bodies[arm].linvel().length();
    // The total angular momentum of the arm is about the post.
    let fraction = 1.0 / (1.0 + crate::suite::joints::stage::inertia(1.0, 0.2));
    assert!((speed - fraction).abs() < 1.0e-3, "it passes through: {speed}");
    let data = |world: &mut PhysicsWorld, enabled: JointEnabled| {
        let (multibody, link) = world.multibody_joints.get_mut(handle).expect("it is there");
        multibody.link_mut(link).expect("a link").joint.data.enabled = enabled;
    };
    data(&mut world, JointEnabled::Disabled);
    run(&mut world, 1.0);
    assert!(world.bodies[arm].translation().length() > 1.2, "it flies off");
    data(&mut world, JointEnabled::Enabled);
    run(&mut world, 0.1);
    assert!((world.bodies[arm].translation().length() - 1.0).abs() < 1.0e-4, "it is back");
}

/// Random edits of multibodies between steps, in any order, leave finite numbers.
#[test]
fn edits_in_any_order() {
    for seed in 0..4 {
        let mut dice = Dice(seed);
        let mut world = world(60);
        world.integration_parameters.normalized_max_linear_velocity = 100.0;
        add_ground(&mut world, 0.5);
        let mut bodies = Vec::new();
        for step in 0..400 {
            let mut pick = |list: &[RigidBodyHandle]| {
                list.get(dice.within(0.0, list.len() as Real - 0.01).max(0.0) as usize).copied()
            };
            let (one, two) = (pick(&bodies), pick(&bodies));
            match (dice.within(0.0, 10.99) as usize, one, two) {
                (0..=1, ..) | (_, None, _) | (_, _, None) if bodies.len() < 24 => {
                    let at = vec(dice.within(-3.0, 3.0), dice.within(0.3, 3.0));
                    let shape = cuboid(0.3, 0.15).restitution(dice.within(0.0, 1.0));
                    bodies.push(world.insert(RigidBodyBuilder::dynamic().translation(at), shape).0);
                }
                (2..=5, Some(one), Some(two)) => {
                    let joint = loose_joint(step, vec(0.35, 0.0), vec(-0.35, 0.0));
                    let _ = world.multibody_joints.insert(one, two, joint, step % 2 == 0);
                }
                (6, Some(one), _) => {
                    world.remove_body(one);
                    bodies.retain(|&body| body != one);
                }
                (7, Some(one), _) => {
                    let kinds = [
                        RigidBodyType::Fixed,
                        RigidBodyType::KinematicVelocityBased,
                        RigidBodyType::KinematicPositionBased,
                        RigidBodyType::Dynamic,
                    ];
                    let kind = kinds[dice.within(0.0, 3.99) as usize];
                    world.bodies[one].set_body_type(kind, true);
                }
                (8, Some(one), _) => {
                    let size = [1.0, 1.0e3, 1.0e6][step % 3];
                    world.bodies[one].apply_torque_impulse(about_z(dice.within(-size, size)), true);
                }
                (9, Some(one), _) => {
                    if let Some(link) = world.multibody_joints.rigid_body_link(one).copied()
                        && let Some(multibody) =
                            world.multibody_joints.get_multibody_mut(link.multibody)
                        && let Some(link) = multibody.link_mut(link.id)
                    {
                        let data = &mut link.joint.data;
                        data.set_limits(JointAxis::AngX, [dice.within(-1.0, 0.0), 0.5]);
                        data.set_motor_velocity(JointAxis::AngX, dice.within(-50.0, 50.0), 1.0e3);
                        data.set_motor_max_force(JointAxis::AngX, dice.within(0.0, 1.0e4));
                        data.contacts_enabled = step % 2 == 0;
                    }
                }
                (10, Some(one), Some(_)) => {
                    world.multibody_joints.remove_joints_attached_to_rigid_body(one);
                }
                _ => {}
            }
            world.step();
            assert_finite(&world, &format!("seed {seed}, step {step}"));
        }
    }
}
