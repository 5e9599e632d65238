//! Joints, links and mass ratios that overflow numbers.

use super::stage::{Stage, experiment};
use crate::dim::{hinge, vec};
use rapier::prelude::*;

/// The solver decides whether it can compute such a motor. If not, it disables one of the two bodies, and the
/// others move as without it.
#[test]
fn overflowing_motors_disable_a_body() {
    for model in [MotorModel::ForceBased, MotorModel::AccelerationBased] {
        for number in [1.0e20, 1.0e30, 0.5 * Real::MAX] {
            let taken = experiment(|stage| {
                stage.drive(model, number);
            });
            assert!(taken.len() <= 2, "{model:?} {number}: {taken:?}");
        }
    }
}

#[test]
fn a_link_takes_its_multibody_along() {
    let links = Stage::new().links;
    let taken = experiment(|stage| {
        stage.world.bodies[stage.links[2]].add_force(vec(1.0e30, 0.0), true);
    });
    let mut bodies: Vec<_> = taken.iter().map(|(_, body, _)| *body).collect();
    bodies.sort_unstable();
    assert_eq!(bodies, links);
    for (step, _, cause) in taken {
        assert_eq!(step, 0);
        assert!(matches!(cause, QuarantineCause::Force { .. }), "{cause:?}");
    }
}

/// All links are enabled again, and connected as before.
#[test]
fn a_multibody_comes_back() {
    let mut stage = Stage::new();
    stage.world.bodies[stage.links[2]].add_force(vec(1.0e30, 0.0), true);
    assert_eq!(stage.step().quarantines.len(), 4);
    stage.world.bodies[stage.links[2]].reset_forces(true);
    for &link in &stage.links {
        stage.world.bodies[link].set_enabled(true);
    }
    for _ in 0..60 {
        assert_eq!(stage.step().quarantines, []);
    }
    for pair in stage.links.windows(2) {
        let [one, two] = [0, 1].map(|k| *stage.world.bodies[pair[k]].position());
        let gap = one * vec(0.5, 0.0) - two * vec(-0.5, 0.0);
        assert!(gap.length() < 1.0e-3, "{gap}");
    }
}

/// A motor moves the coordinate of a joint beyond the range of numbers.
#[test]
fn a_motor_within_a_multibody() {
    for number in [1.0e20, 0.5 * Real::MAX] {
        experiment(|stage| {
            let (joint, ..) = stage.world.multibody_joints.iter().nth(2).expect("there are four");
            let (multibody, link) =
                stage.world.multibody_joints.get_mut(joint).expect("it is there");
            let data = &mut multibody.link_mut(link).expect("a link").joint.data;
            data.set_motor(JointAxis::AngX, number, number, number, number);
            multibody.generalized_velocity_mut()[2] = 1.0e14;
        });
    }
}

/// Masses from a microgram to a mountain hang on each other and collide.
#[test]
fn masses_of_all_ratios() {
    for (light, heavy) in [(1.0e-9, 1.0e9), (1.0e-15, 1.0e15), (1.0e-3, 1.0e12)] {
        experiment(|stage| {
            let Stage { world, suspect, neighbour, sleeper, .. } = stage;
            for (body, mass) in [(*suspect, heavy), (*neighbour, light), (*sleeper, heavy)] {
                let collider = world.bodies[body].colliders()[0];
                world.colliders[collider].set_mass(mass);
                world.bodies[body].wake_up(true);
            }
            let joint = hinge().local_anchor1(vec(0.5, 0.5)).local_anchor2(vec(-0.5, 0.5));
            world.insert_impulse_joint(*neighbour, *suspect, joint);
            world.bodies[*suspect].set_linvel(vec(30.0, -1.0), true);
        });
    }
}
