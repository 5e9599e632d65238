//! Momentum of multibodies whose degrees of freedom change in motion: a kinematic root becomes dynamic, a
//! joint is locked or freed.

use super::stage::{angular_momentum, momentum};
use crate::dim::{about_z, ang_length, cuboid, hinge, vec};
use crate::suite::physics::stage::weightless;
use rapier::prelude::*;

/// Length of the steps around an edit (s): nothing moves.
const INSTANT: Real = 1.0e-6;

/// Angular velocity of the tree (rad/s).
const SPIN: Real = 1.0;

/// A free chain that rotates like one body, and slides.
struct Train {
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    joints: Vec<MultibodyJointHandle>,
}

impl Train {
    fn new(links: usize) -> Self {
        let mut train = Self { world: weightless(60), bodies: Vec::new(), joints: Vec::new() };
        for k in 0..=links {
            let x = k as Real;
            let body = RigidBodyBuilder::dynamic().translation(vec(x, 0.0)).can_sleep(false);
            let body = body.linvel(vec(2.0, SPIN * x)).angvel(about_z(SPIN));
            let (body, _) = train.world.insert(body, cuboid(0.3, 0.1));
            if let Some(&parent) = train.bodies.last() {
                let joint = hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
                let joint = train.world.insert_multibody_joint(parent, body, joint);
                train.joints.push(joint.expect("a tree"));
            }
            train.bodies.push(body);
        }
        train
    }

    fn root(&mut self) -> &mut RigidBody {
        &mut self.world.bodies[self.bodies[0]]
    }

    fn joint(&mut self, k: usize) -> &mut GenericJoint {
        let (multibody, link) = self.world.multibody_joints.get_mut(self.joints[k]).expect("there");
        &mut multibody.link_mut(link).expect("there").joint.data
    }

    fn velocities(&self) -> Vec<RigidBodyVelocity> {
        self.bodies.iter().map(|&body| self.world.bodies[body].vels()).collect()
    }

    /// Momentum, and angular momentum about the origin.
    fn momenta(&self) -> (Vector, AngVector) {
        (momentum(&self.world, &self.bodies), angular_momentum(&self.world, &self.bodies))
    }

    /// A step in which nothing moves.
    fn apply(&mut self) {
        let dt = core::mem::replace(&mut self.world.integration_parameters.dt, INSTANT);
        self.world.step();
        self.world.integration_parameters.dt = dt;
    }
}

/// A root that was kinematic for a while and becomes dynamic moves on, and so do its links. Before, all of
/// them stopped.
#[test]
fn released_roots_move_on() {
    use RigidBodyType::{Dynamic, KinematicPositionBased, KinematicVelocityBased};
    println!(
        "| root | links | steps | heavier | change of velocity (m/s) |\n|---|--:|--:|---|--:|"
    );
    let mut failures = Vec::new();
    for kind in [KinematicVelocityBased, KinematicPositionBased] {
        for (links, steps, is_heavier) in
            [(1, 1, false), (1, 10, true), (3, 1, true), (3, 10, false), (3, 0, false)]
        {
            let mut train = Train::new(links);
            train.world.step();
            train.root().set_body_type(kind, true);
            for _ in 0..steps {
                let next = train.root().predict_position_using_velocity(1.0 / 60.0);
                train.root().set_next_kinematic_position(next);
                train.world.step();
            }
            let before = train.velocities();
            train.root().set_body_type(Dynamic, true);
            if is_heavier {
                train.root().set_additional_mass(2.0, true);
            }
            train.apply();
            let changes = before.iter().zip(train.velocities()).map(|(before, after)| {
                (before.linvel - after.linvel).length() + ang_length(before.angvel - after.angvel)
            });
            let change = changes.fold(0.0, Real::max);
            println!("| {kind:?} | {links} | {steps} | {is_heavier} | {change:.1e} |");
            if change > 1.0e-3 {
                failures.push((kind, links, steps, is_heavier, change));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

/// To lock a joint of a free tree is a matter of inner impulses: relative motion ends, momentum and angular
/// momentum stay. Before, the link's share of them was lost. A freed joint changes no velocity.
#[test]
fn joints_that_are_locked_or_freed_keep_the_momentum() {
    for joint in 0..3 {
        let mut train = Train::new(3);
        train.apply();
        for k in 0..3 {
            let body = &mut train.world.bodies[train.bodies[k + 1]];
            body.apply_torque_impulse(about_z(0.01 * (k + 1) as Real), true);
        }
        train.apply();
        let before = train.momenta();
        train.joint(joint).lock_axes(JointAxesMask::ANG_X);
        train.apply();
        let after = train.momenta();
        let change = [(before.0 - after.0).length(), ang_length(before.1 - after.1)];
        println!("joint {joint} locked: p {:.1e}, L {:.1e}", change[0], change[1]);
        assert!(change[0] < 1.0e-5 && change[1] < 1.0e-4, "{joint}: {before:?}, {after:?}");
        let velocities = train.velocities();
        let relative = velocities[joint + 1].angvel - velocities[joint].angvel;
        assert!(ang_length(relative) < 1.0e-4, "it rotates at {relative}");

        train.joint(joint).locked_axes -= JointAxesMask::ANG_X;
        train.apply();
        for (before, after) in velocities.iter().zip(train.velocities()) {
            let change = ang_length(before.angvel - after.angvel);
            assert!(change < 1.0e-4, "{before:?}, {after:?}");
        }
    }
}

/// Displacements of zero change nothing: bodies sleep on.
#[test]
fn displacements_of_zero_wake_nothing() {
    let mut train = Train::new(2);
    for k in 0..3 {
        let body = &mut train.world.bodies[train.bodies[k]];
        body.set_vels(RigidBodyVelocity::zero(), true);
        *body.activation_mut() = RigidBodyActivation::active();
        let turned = body.position().rotation * about_z_rotation(0.3);
        body.set_rotation(turned, true);
    }
    (0..120).for_each(|_| train.world.step());
    assert_eq!(train.world.active_bodies().len(), 0);
    let (multibody, _) = train.world.multibody_joints.get_mut(train.joints[0]).expect("there");
    multibody.apply_displacements(&vec![0.0; multibody.ndofs()]);
    train.world.step();
    assert_eq!(train.world.active_bodies().len(), 0);
}

fn about_z_rotation(angle: Real) -> Rotation {
    Pose::new(Vector::ZERO, about_z(angle)).rotation
}
