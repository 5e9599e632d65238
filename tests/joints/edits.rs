//! Insertion and removal of joints: islands, sleep, contacts and bodies follow.

use super::stage::post;
use crate::dim::{cuboid, hinge, vec};
use crate::suite::physics::stage::{add_ground, run, world};
use rapier::prelude::*;

/// Adds two boxes on the ground, three metres apart.
fn two_boxes(world: &mut PhysicsWorld) -> [RigidBodyHandle; 2] {
    add_ground(world, 0.6);
    [-1.5, 1.5].map(|x| {
        let body = RigidBodyBuilder::dynamic().translation(vec(x, 0.5));
        world.insert(body, cuboid(0.5, 0.5)).0
    })
}

fn rope(world: &mut PhysicsWorld, [a, b]: [RigidBodyHandle; 2]) -> ImpulseJointHandle {
    world.insert_impulse_joint(a, b, RopeJointBuilder::new(4.0))
}

fn asleep(world: &PhysicsWorld, bodies: [RigidBodyHandle; 2]) -> [bool; 2] {
    bodies.map(|body| world.bodies[body].is_sleeping())
}

#[test]
fn joined_bodies_sleep_and_wake_together() {
    let mut world = world(60);
    let boxes = two_boxes(&mut world);
    rope(&mut world, boxes);
    run(&mut world, 5.0);
    assert_eq!(asleep(&world, boxes), [true; 2]);
    world.bodies[boxes[0]].wake_up(true);
    world.step();
    assert_eq!(asleep(&world, boxes), [false; 2]);
}

#[test]
fn changing_a_joint_wakes_its_bodies_and_reading_does_not() {
    let mut world = world(60);
    let boxes = two_boxes(&mut world);
    let joint = rope(&mut world, boxes);
    run(&mut world, 5.0);
    assert!(world.impulse_joints.get(joint).is_some());
    world.step();
    assert_eq!(asleep(&world, boxes), [true; 2]);
    world.impulse_joints.get_mut(joint).unwrap().data.user_data = 7;
    world.step();
    assert_eq!(asleep(&world, boxes), [false; 2]);
}

#[test]
fn joints_may_be_inserted_without_waking_bodies() {
    let mut world = world(60);
    let boxes = two_boxes(&mut world);
    run(&mut world, 5.0);
    let joint = world.impulse_joints.insert(boxes[0], boxes[1], RopeJoint::new(4.0), false);
    world.step();
    assert_eq!(asleep(&world, boxes), [true; 2]);
    // The boxes are one island now: they wake together.
    world.bodies[boxes[1]].wake_up(true);
    world.step();
    assert_eq!(asleep(&world, boxes), [false; 2]);
    run(&mut world, 5.0);
    assert!(world.impulse_joints.remove(joint, false).is_some());
    world.step();
    assert_eq!(asleep(&world, boxes), [true; 2]);
}

#[test]
fn removing_a_body_removes_its_joints_and_wakes_its_neighbours() {
    let mut world = world(60);
    let boxes = two_boxes(&mut world);
    let joint = rope(&mut world, boxes);
    run(&mut world, 5.0);
    world.remove_body(boxes[0]);
    world.step();
    assert!(world.impulse_joints.get(joint).is_none() && world.impulse_joints.is_empty());
    assert!(!world.bodies[boxes[1]].is_sleeping());
    // The slot gets a new body without joints.
    let next = world.insert_body(RigidBodyBuilder::dynamic());
    assert_eq!(world.impulse_joints_with(next).count(), 0);
    run(&mut world, 5.0);
}

#[test]
fn bodies_fall_when_their_post_is_removed() {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let (load, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.2));
    world.insert_impulse_joint(post, load, FixedJoint::new());
    run(&mut world, 5.0);
    assert!(world.bodies[load].is_sleeping());
    world.remove_body(post);
    run(&mut world, 1.0);
    assert!(world.bodies[load].translation().y < -4.0);
}

#[test]
fn disabled_joints_and_bodies_release_and_act_again() {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let (load, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.2));
    let joint = world.insert_impulse_joint(post, load, FixedJoint::new());
    run(&mut world, 1.0);
    world.impulse_joints[joint].data.set_enabled(false);
    run(&mut world, 0.5);
    assert!(world.bodies[load].translation().y < -1.0);
    world.impulse_joints[joint].data.set_enabled(true);
    run(&mut world, 2.0);
    assert!(world.bodies[load].translation().length() < 1.0e-2);
    world.bodies[post].set_enabled(false);
    run(&mut world, 0.5);
    assert_eq!(world.impulse_joints[joint].data.enabled, JointEnabled::DisabledByAttachedBody);
    assert!(world.bodies[load].translation().y < -1.0);
    world.bodies[post].set_enabled(true);
    run(&mut world, 2.0);
    assert_eq!(world.impulse_joints[joint].data.enabled, JointEnabled::Enabled);
    assert!(world.bodies[load].translation().length() < 1.0e-2);
}

#[test]
fn joined_bodies_touch_each_other_unless_disabled() {
    for enabled in [true, false] {
        let mut world = world(60);
        world.gravity = Vector::ZERO;
        let post = world.insert(RigidBodyBuilder::fixed(), cuboid(0.5, 0.5)).0;
        let body = RigidBodyBuilder::dynamic().translation(vec(0.6, 0.0)).can_sleep(false);
        let (load, _) = world.insert(body, cuboid(0.5, 0.5));
        let joint = PrismaticJointBuilder::new(Vector::X).contacts_enabled(enabled);
        let joint = world.insert_impulse_joint(post, load, joint);
        world.step();
        assert_eq!(world.contact_pairs().count(), usize::from(enabled));
        run(&mut world, 1.0);
        let pushed = world.bodies[load].translation().x > 0.9;
        assert_eq!(pushed, enabled);
        // The filter works in the other direction as well, at any time.
        world.bodies[load].set_translation(vec(0.6, 0.0), true);
        world.bodies[load].set_linvel(Vector::ZERO, true);
        world.impulse_joints[joint].data.set_contacts_enabled(!enabled);
        world.step();
        assert_eq!(world.contact_pairs().count(), usize::from(!enabled));
    }
}

#[test]
fn joints_can_be_given_other_bodies() {
    let mut world = world(60);
    let posts = [0.0, 5.0].map(|x| post(&mut world, vec(x, 0.0)));
    let (load, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.2));
    let joint = world.insert_impulse_joint(posts[0], load, FixedJoint::new());
    run(&mut world, 1.0);
    world.impulse_joints.set_bodies(joint, posts[1], load);
    assert_eq!(world.impulse_joints_with(posts[1]).count(), 1);
    assert_eq!(world.impulse_joints_with(posts[0]).count(), 0);
    run(&mut world, 3.0);
    assert!((world.bodies[load].translation() - vec(5.0, 0.0)).length() < 1.0e-2);
}

#[test]
fn joints_are_found_by_their_bodies() {
    let mut world = world(60);
    let [a, b, c] = [0; 3].map(|_| world.insert_body(RigidBodyBuilder::dynamic()));
    let joints =
        [(a, b), (b, c), (a, b)].map(|(one, two)| world.insert_impulse_joint(one, two, hinge()));
    let set = &mut world.impulse_joints;
    let between: Vec<_> = set.joints_between(b, a).map(|(handle, _)| handle).collect();
    assert_eq!(between, [joints[0], joints[2]]);
    assert_eq!(set.attached_joints(b).count(), 3);
    set[joints[1]].data.set_enabled(false);
    assert_eq!(set.attached_enabled_joints(b).count(), 2);
    let mut seen = 0;
    set.map_attached_joints_mut(a, |one, two, _, joint| {
        assert_eq!((one, two, joint.body1()), (a, b, a));
        seen += 1;
    });
    assert_eq!((seen, set.len(), set.iter().count()), (2, 3, 3));
    assert_eq!(set.remove_joints_attached_to_rigid_body(a), [joints[0], joints[2]]);
    assert!(!set.contains(joints[0]) && set.contains(joints[1]));
    assert_eq!(set.get_unknown_gen(joints[1].into_raw_parts().0).unwrap().1, joints[1]);
}
