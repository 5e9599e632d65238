//! Joints break above their limit, and report it.

use super::stage::{bob, post};
use crate::dim::vec;
use crate::suite::physics::stage::{G, world};
use rapier::prelude::*;
use std::sync::Mutex;

/// Handler that records broken joints.
#[derive(Default)]
struct Breaks(Mutex<Vec<JointBreakEvent>>);

impl EventHandler for Breaks {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
    }

    fn handle_joint_break_event(&self, event: &JointBreakEvent, bodies: &RigidBodySet) {
        assert!(bodies.contains(event.body1) && bodies.contains(event.body2));
        self.0.lock().unwrap().push(*event);
    }
}

/// Hangs 2 kg on a joint with this breaking force, for half a second.
fn hang(limit: Real) -> (PhysicsWorld, RigidBodyHandle, ImpulseJointHandle, Breaks) {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let load = world.insert_body(bob(2.0, 0.2));
    let joint = FixedJointBuilder::new().break_thresholds(limit, Real::INFINITY);
    let joint = world.insert_impulse_joint(post, load, joint);
    let breaks = Breaks::default();
    for _ in 0..30 {
        world.step_with_events(&(), &breaks);
    }
    (world, load, joint, breaks)
}

#[test]
fn joints_hold_up_to_their_threshold_and_report_their_force() {
    let (world, load, joint, breaks) = hang(2.1 * G);
    assert!(breaks.0.lock().unwrap().is_empty());
    assert!(world.bodies[load].translation().length() < 1.0e-3);
    let force = world.impulse_joints[joint].force();
    assert!((force - vec(0.0, 2.0 * G)).length() < 0.01 * G, "{force}");
}

#[test]
fn overloaded_joints_break_once_and_let_go() {
    let (world, load, joint, breaks) = hang(1.9 * G);
    let breaks = breaks.0.lock().unwrap();
    assert_eq!(breaks.len(), 1);
    assert_eq!((breaks[0].joint, breaks[0].body2), (joint, load));
    assert!((breaks[0].force - 2.0 * G).abs() < 0.01 * G, "{}", breaks[0].force);
    assert!(!world.impulse_joints[joint].data.is_enabled());
    // The load falls from the second step on.
    let exact = 0.5 * G * (29.0 / 60.0) * (29.0 / 60.0);
    let fallen = -world.bodies[load].translation().y;
    assert!((fallen / exact - 1.0).abs() < 0.03, "{fallen} instead of {exact}");
}

/// Joints on links report forces and break like others: locked axes and limits. The link is a plate on a
/// fixed root with a small range of rotation.
#[test]
fn joints_on_links_break_too() {
    let rope = RopeJointBuilder::new(0.5).local_anchor2(Vector::ZERO).build().into();
    let weld = FixedJointBuilder::new().local_anchor2(vec(0.0, 0.5)).build().into();
    for joint in [rope, weld] {
        let hung = |limit: Real| {
            let mut world = world(60);
            let (root, _) = (post(&mut world, Vector::ZERO), ());
            let link = world.insert_body(bob(1.0, 0.2));
            world
                .insert_multibody_joint(root, link, crate::dim::hinge().limits([0.0, 0.0]))
                .expect("it fits");
            let load = world.insert_body(bob(2.0, 0.2).translation(vec(0.0, -0.5)));
            let mut joint: GenericJoint = joint;
            joint.set_break_thresholds(limit, Real::INFINITY);
            let joint = world.insert_impulse_joint(link, load, joint);
            let breaks = Breaks::default();
            for _ in 0..30 {
                world.step_with_events(&(), &breaks);
            }
            let broken = breaks.0.lock().unwrap().len();
            (world.impulse_joints[joint].clone(), broken, world.bodies[load].translation().y)
        };
        let (held, broken, y) = hung(2.1 * G);
        assert_eq!(broken, 0);
        assert!((held.force() - vec(0.0, 2.0 * G)).length() < 0.02 * G, "{}", held.force());
        assert!((y + 0.5).abs() < 5.0e-3, "{y}");
        let (broke, broken, y) = hung(1.9 * G);
        assert_eq!(broken, 1);
        assert!(!broke.data.is_enabled() && y < -1.0, "{y}");
    }
}

#[test]
fn joints_break_by_torque_too() {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let load = world.insert_body(bob(2.0, 0.2).translation(vec(1.0, 0.0)));
    let joint = FixedJointBuilder::new().local_anchor2(vec(-1.0, 0.0));
    let joint = world.insert_impulse_joint(post, load, joint);
    world.step();
    world.step();
    let torque = crate::dim::ang_length(world.impulse_joints[joint].torque());
    assert!((torque - 2.0 * G).abs() < 0.02 * G, "{torque}");
    let thresholds = |world: &mut PhysicsWorld, torque| {
        world.impulse_joints[joint].data.set_break_thresholds(Real::INFINITY, torque);
        world.step();
        world.impulse_joints[joint].data.is_enabled()
    };
    assert!(thresholds(&mut world, 2.1 * G));
    assert!(!thresholds(&mut world, 1.9 * G));
}
