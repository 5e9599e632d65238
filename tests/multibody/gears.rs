//! Gears: coupled degrees of freedom move in a constant ratio, and share forces accordingly.

use crate::dim::{about_z, hinge, vec, z_of};
use crate::suite::joints::stage::{bob, inertia};
use crate::suite::physics::stage::{RATES, steps, weightless};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Adds two wheels of mass 1 and these radii on one frame.
fn wheels(world: &mut PhysicsWorld, radii: [Real; 2]) -> [MultibodyJointHandle; 2] {
    let frame = world.insert_body(RigidBodyBuilder::fixed());
    let mut x = 0.0;
    radii.map(|radius| {
        x += 1.0;
        let wheel = world.insert_body(bob(1.0, radius).translation(vec(x, 0.0)));
        let axle = hinge().local_anchor1(vec(x, 0.0));
        world.insert_multibody_joint(frame, wheel, axle).expect("it fits")
    })
}

/// Couples two joints: the second rotates by `ratio` times the angle of the first.
fn couple(
    world: &mut PhysicsWorld,
    [first, second]: [MultibodyJointHandle; 2],
    ratio: Real,
    offset: Real,
) {
    let link2 = world.multibody_joints.get(second).expect("it is there").1;
    let (multibody, link1) = world.multibody_joints.get_mut(first).expect("it is there");
    let axis = JointAxis::AngX;
    multibody.add_dof_coupling(link1, axis, link2, axis, ratio, offset).expect("it fits");
}

/// Returns angle and angular velocity of a joint.
fn turned(world: &PhysicsWorld, joint: MultibodyJointHandle) -> (Real, Real) {
    let (multibody, id) = world.multibody_joints.get(joint).expect("it is there");
    let link = multibody.link(id).expect("it is there");
    (link.joint().coords()[JointAxis::AngX as usize], multibody.joint_velocity(id)[0])
}

/// A torque `τ` on the first wheel rotates both: `α₁ = τ / (I₁ + r² I₂)`, `α₂ = r α₁`.
#[test]
fn gears_turn_by_their_ratio() {
    let radii = [0.2, 0.5];
    let [i1, i2] = radii.map(|radius| inertia(1.0, radius));
    for rate in RATES {
        for ratio in [-0.4, 2.5] {
            let mut world = weightless(rate);
            let joints = wheels(&mut world, radii);
            couple(&mut world, joints, ratio, 0.0);
            let torque = 0.05;
            let driven = world.multibody_joints.get_link(joints[0]).expect("it is there");
            let driven = driven.rigid_body_handle();
            world.bodies[driven].add_torque(about_z(torque), true);
            for _ in 0..steps(&world, 1.0) {
                world.step();
            }
            let alpha = torque / (i1 + ratio * ratio * i2);
            let [(q1, w1), (q2, w2)] = joints.map(|joint| turned(&world, joint));
            println!("{rate} Hz, {ratio}: ω {w1:.5} of {alpha:.5}, ratio {:.6}", q2 / q1);
            // The coupling acts in the same substep as the torque; rounding is far below 0.1 %.
            assert!((w1 / alpha - 1.0).abs() < 1.0e-3, "{w1} instead of {alpha}");
            assert!((w2 / w1 / ratio - 1.0).abs() < 1.0e-3, "{w2} is not {ratio} times {w1}");
            assert!((q2 - ratio * q1).abs() < 1.0e-3 * q1.abs(), "{q2} is not {ratio} times {q1}");
            let body2 = world.multibody_joints.get_link(joints[1]).expect("it is there");
            let omega = z_of(world.bodies[body2.rigid_body_handle()].angvel());
            assert!((omega - w2).abs() < 1.0e-4 * w2.abs(), "the body turns with its joint");
        }
    }
}

/// Wheels whose angles violate their coupling converge to it, and a motor rotates both.
#[test]
fn violated_couplings_converge() {
    let mut world = weightless(60);
    let joints = wheels(&mut world, [0.3, 0.3]);
    couple(&mut world, joints, 2.0, 0.5);
    for _ in 0..120 {
        world.step();
    }
    let [(q1, _), (q2, _)] = joints.map(|joint| turned(&world, joint));
    assert!((q2 - 2.0 * q1 - 0.5).abs() < 1.0e-3, "{q1} and {q2}");

    let (multibody, id) = world.multibody_joints.get_mut(joints[0]).expect("it is there");
    let joint = &mut multibody.link_mut(id).expect("it is there").joint.data;
    joint.set_motor_position(JointAxis::AngX, 1.0, 100.0, 20.0);
    for _ in 0..240 {
        world.step();
    }
    let [(q1, _), (q2, _)] = joints.map(|joint| turned(&world, joint));
    assert!((q1 - 1.0).abs() < 1.0e-2 && (q2 - 2.5).abs() < 2.0e-2, "{q1} and {q2}");
}

/// A gear train on a free frame drives itself; momentum and energy are constant.
#[test]
fn free_gears_keep_momentum_and_energy() {
    let mut world = weightless(60);
    let frame = world.insert_body(bob(2.0, 0.5));
    let joints = [-1.0, 0.0, 1.0].map(|x| {
        let wheel = world.insert_body(bob(1.0, 0.3).translation(vec(x, 0.0)));
        let axle = hinge().local_anchor1(vec(x, 0.0));
        world.insert_multibody_joint(frame, wheel, axle).expect("it fits")
    });
    couple(&mut world, [joints[0], joints[1]], -1.0, 0.0);
    couple(&mut world, [joints[1], joints[2]], -2.0, 0.0);
    world.bodies[frame].set_linvel(vec(0.3, 0.2), true);
    let wheel =
        world.multibody_joints.get_link(joints[0]).expect("it is there").rigid_body_handle();
    world.bodies[wheel].set_angvel(about_z(5.0), true);
    world.step();
    let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
    let measure = |world: &PhysicsWorld| {
        let energy = super::stage::kinetic_energy(world, &bodies);
        (
            super::stage::momentum(world, &bodies),
            z_of(super::stage::angular_momentum(world, &bodies)),
            energy,
        )
    };
    let (p, l, energy) = measure(&world);
    for _ in 0..600 {
        world.step();
    }
    let (p_now, l_now, energy_now) = measure(&world);
    println!("L {l} to {l_now}, E {energy} to {energy_now}");
    assert!((p_now - p).length() < 1.0e-3 * p.length(), "{p} to {p_now}");
    assert!((l_now - l).abs() < 1.0e-3 * l.abs(), "{l} to {l_now}");
    assert!((energy_now / energy - 1.0).abs() < 0.01, "{energy} to {energy_now}");
}

/// A motor on one wheel, and the limit of the other: with the gear between both wheels, the motor has no rate
/// of its own, and must yield. The largest torque accelerates a free wheel by 1 to 10³ rad/s per substep.
#[test]
fn gears_hold_against_a_motor_and_a_limit() {
    let mut table = Table::new(
        "a wheel at its limit, driven through a gear",
        &["N·m", "ratio", "limited", "beyond", "slip"],
    );
    for torque in [10.0, 100.0, 1.0e4] {
        for ratio in [-1.0, 0.1, 0.5, 2.0, 10.0] {
            for limited in [0, 1] {
                let mut world = weightless(60);
                let joints = wheels(&mut world, [0.3, 0.3]);
                couple(&mut world, joints, ratio, 0.0);
                let axis = JointAxis::AngX;
                let (multibody, link) =
                    world.multibody_joints.get_mut(joints[limited]).expect("it is there");
                let stop = &mut multibody.link_mut(link).expect("it is there").joint.data;
                stop.set_limits(axis, [-0.3, 0.3]);
                let (multibody, link) =
                    world.multibody_joints.get_mut(joints[0]).expect("it is there");
                let motor = &mut multibody.link_mut(link).expect("it is there").joint.data;
                motor.set_motor_velocity(axis, 100.0, 1.0e6);
                motor.set_motor_max_force(axis, torque);
                motor.set_motor_model(axis, MotorModel::ForceBased);
                let (mut beyond, mut slip): (Real, Real) = (0.0, 0.0);
                for _ in 0..180 {
                    world.step();
                    let [q1, q2] = joints.map(|joint| turned(&world, joint).0);
                    beyond = beyond.max([q1, q2][limited].abs() - 0.3);
                    slip = slip.max((q2 - ratio * q1).abs());
                }
                table.row([
                    format!("{torque:e}"),
                    ratio.to_string(),
                    limited.to_string(),
                    format!("{beyond:.5}"),
                    format!("{slip:.5}"),
                ]);
                // Half a degree. Gears are a little compliant.
                table.require(beyond < 0.009 && slip < 0.009, "the gear or the limit yields");
            }
        }
    }
}

/// Couplings move with their links when multibodies split, and are removed with them.
#[test]
fn couplings_follow_their_links() {
    let mut world = weightless(60);
    let root = world.insert_body(RigidBodyBuilder::fixed());
    let mut parent = root;
    let chain = [1.0, 2.0, 3.0, 4.0].map(|x| {
        let body = world.insert_body(bob(1.0, 0.2).translation(vec(x, 0.0)));
        let joint = hinge().local_anchor1(vec(if parent == root { 0.0 } else { 0.5 }, 0.0));
        let joint = world.insert_multibody_joint(parent, body, joint.local_anchor2(vec(-0.5, 0.0)));
        parent = body;
        joint.expect("it fits")
    });
    couple(&mut world, [chain[0], chain[3]], 1.0, 0.0);
    couple(&mut world, [chain[2], chain[3]], 3.0, 0.0);
    world.remove_multibody_joint(chain[1]);
    world.step();
    let couplings = |joint| {
        let (multibody, link) = world.multibody_joints.get(joint).expect("it is there");
        (multibody.couplings().to_vec(), link)
    };
    assert!(couplings(chain[0]).0.is_empty(), "its other link is elsewhere");
    let ((kept, second), first) = (couplings(chain[3]), couplings(chain[2]).1);
    assert_eq!(kept.len(), 1);
    assert_eq!((kept[0].link1, kept[0].link2, kept[0].coeff), (first, second, 3.0));
    world.step();
}

#[test]
fn invalid_couplings_are_rejected() {
    let mut world = weightless(60);
    let joints = wheels(&mut world, [0.3, 0.3]);
    let (multibody, link) = world.multibody_joints.get_mut(joints[0]).expect("it is there");
    let axis = JointAxis::AngX;
    let mut add = |link1, axis1, link2, coeff| {
        multibody.add_dof_coupling(link1, axis1, link2, axis, coeff, 0.0)
    };
    let error = add(link, axis, 2, Real::NAN).unwrap_err();
    assert!(matches!(error, InvalidJoint::Number { value, .. } if value.is_nan()), "{error}");
    assert_eq!(add(link, axis, 9, 1.0), Err(InvalidJoint::Dof { link: 9, axis }));
    assert_eq!(add(0, axis, 2, 1.0), Err(InvalidJoint::Dof { link: 0, axis }));
    let locked = JointAxis::LinX;
    assert_eq!(add(link, locked, 2, 1.0), Err(InvalidJoint::Dof { link, axis: locked }));
    assert_eq!(add(2, axis, 2, 1.0), Err(InvalidJoint::SameDof { link: 2, axis }));
    assert_eq!(add(1, axis, 2, 1.0), Ok(0));
    assert_eq!(multibody.remove_dof_coupling(1), None);
    assert!(multibody.remove_dof_coupling(0).is_some() && multibody.couplings().is_empty());
}
