//! Springs and access to joints.

use super::world::{World, assert_near};
use rapier::prelude::*;

/// A body on a spring below an anchor, without gravity.
fn spring(damping: Real) -> (World, RigidBodyHandle, ImpulseJointHandle) {
    let mut world = World::default();
    let anchor = world.bodies.insert(RigidBodyBuilder::fixed());
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::Y * -1.5)
        .gravity_scale(0.0)
        .additional_mass(2.0);
    let body = world.bodies.insert(body);
    let spring = SpringJointBuilder::new(1.0, 200.0, damping).build();
    let joint = world.impulse_joints.insert(anchor, body, spring, true);
    (world, body, joint)
}

/// The period is `2π √(m/k)`.
#[test]
fn springs_oscillate() {
    let (mut world, body, _) = spring(0.0);
    world.parameters.dt = 1.0 / 240.0;
    let mut crossings = Vec::new();
    let mut last = 0.5;
    for step in 1..=480 {
        world.steps(1);
        let stretch = -world.bodies[body].translation().y - 1.0;
        if last > 0.0 && stretch <= 0.0 {
            crossings.push(step as Real * world.parameters.dt);
        }
        last = stretch;
    }
    let period = core::f64::consts::TAU as Real * (2.0 as Real / 200.0).sqrt();
    let count = (crossings.len() - 1) as Real;
    assert_near((crossings.last().unwrap() - crossings[0]) / count, period, 0.02 * period);
}

/// With the critical damping `2 √(k m)` the spring does not overshoot.
#[test]
fn damped_springs_come_to_rest() {
    let critical = 2.0 * (200.0 as Real * 2.0).sqrt();
    let (mut world, body, _) = spring(critical);
    for _ in 0..120 {
        world.steps(1);
        assert!(world.bodies[body].translation().y <= -0.99);
    }
    assert_near(world.bodies[body].translation().y, -1.0, 1.0e-3);
}

#[test]
fn joints_have_public_bodies() {
    let (world, body, joint) = spring(1.0);
    let joint = world.impulse_joints.get(joint).unwrap();
    assert_eq!(joint.body2, body);
    assert!(world.bodies[joint.body1].is_fixed());
}

/// Access without the request to wake leaves sleeping bodies asleep.
#[test]
fn access_wakes_on_request() {
    for wake_up in [false, true] {
        let (mut world, body, joint) = spring(10.0);
        world.steps(5);
        world.bodies[body].sleep();
        world.impulse_joints.get_mut(joint, wake_up).unwrap().data.set_contacts_enabled(false);
        world.steps(1);
        assert_eq!(world.bodies[body].is_sleeping(), !wake_up);
    }
}

/// The iteration wakes no body, and the step applies the edits.
#[test]
fn iteration_wakes_none() {
    let (mut world, body, joint) = spring(10.0);
    world.steps(5);
    world.bodies[body].sleep();
    world.steps(1);
    let anchor = world.impulse_joints.get(joint).unwrap().body1;
    let second = world.bodies.insert(RigidBodyBuilder::fixed());
    let mut seen = Vec::new();
    for (handle, joint) in world.impulse_joints.iter_mut() {
        joint.body1 = second;
        seen.push(handle);
    }
    assert_eq!(seen, [joint]);
    world.steps(1);
    assert!(world.bodies[body].is_sleeping());
    assert_eq!(world.impulse_joints.attached_joints(second).count(), 1);
    assert_eq!(world.impulse_joints.attached_joints(anchor).count(), 0);
}

/// Mutable access without an argument for it wakes no body.
#[test]
fn access_by_slot_or_body_wakes_none() {
    let (mut world, body, joint) = spring(10.0);
    world.steps(5);
    world.bodies[body].sleep();
    world.steps(1);
    let (slot, _) = joint.into_raw_parts();
    let (found, handle) = world.impulse_joints.get_unknown_gen_mut(slot).unwrap();
    found.data.set_contacts_enabled(false);
    assert_eq!(handle, joint);
    let mut seen = Vec::new();
    world.impulse_joints.map_attached_joints_mut(body, |_, second, handle, joint| {
        joint.data.set_contacts_enabled(true);
        seen.push((second, handle));
    });
    assert_eq!(seen, [(body, joint)]);
    world.steps(1);
    assert!(world.bodies[body].is_sleeping());
    assert!(world.impulse_joints.get_unknown_gen_mut(slot + 1).is_none());
}
