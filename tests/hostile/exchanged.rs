//! Whole sets that are taken or replaced: `mem::take(&mut world.bodies)`, or one set returned to an older
//! copy.
//!
//! The sets refer to each other. A step detects a set that does not belong to its last step, and continues
//! with the present contents.

use super::event_checker::EventChecker;
use super::scene::Scene;
use super::world::check;
use crate::dim::{cuboid, vec};
use core::mem::{swap, take};
use rapier::prelude::*;

/// Exchange of one set of two worlds.
type Exchange = fn(&mut PhysicsWorld, &mut PhysicsWorld);

const SETS: [(&str, Exchange); 7] = [
    ("bodies", |one, two| swap(&mut one.bodies, &mut two.bodies)),
    ("colliders", |one, two| swap(&mut one.colliders, &mut two.colliders)),
    ("islands", |one, two| swap(&mut one.islands, &mut two.islands)),
    ("broad phase", |one, two| swap(&mut one.broad_phase, &mut two.broad_phase)),
    ("narrow phase", |one, two| swap(&mut one.narrow_phase, &mut two.narrow_phase)),
    ("impulse joints", |one, two| swap(&mut one.impulse_joints, &mut two.impulse_joints)),
    ("multibody joints", |one, two| swap(&mut one.multibody_joints, &mut two.multibody_joints)),
];

/// Returns a pile, a pendulum and a chain of links beside it.
fn busy_world() -> PhysicsWorld {
    let Scene { mut world, .. } = Scene::new();
    let ceiling = world.insert_body(RigidBodyBuilder::fixed().translation(vec(9.0, 9.0)));
    for linked in [false, true] {
        let bob = RigidBodyBuilder::dynamic().translation(vec(8.0, 9.0));
        let (bob, _) = world.insert(bob, cuboid(0.2, 0.2));
        let joint = FixedJointBuilder::new().local_anchor2(vec(1.0, 0.0));
        if linked {
            world.insert_multibody_joint(ceiling, bob, joint);
        } else {
            world.insert_impulse_joint(ceiling, bob, joint);
        }
    }
    world.step();
    world
}

/// Runs some steps with an event checker.
fn steps(world: &mut PhysicsWorld, event_checker: &EventChecker, count: usize) {
    for _ in 0..count {
        world.step_with_events(&(), event_checker);
        check(world);
        event_checker.check();
    }
}

#[test]
fn a_world_continues_without_a_set() {
    for (name, exchange) in SETS {
        let mut world = busy_world();
        exchange(&mut world, &mut PhysicsWorld::new());
        println!("without {name}");
        for _ in 0..20 {
            world.step();
            check(&world);
        }
    }
}

#[test]
fn collision_detection_continues_without_a_set() {
    for (name, exchange) in SETS {
        let mut world = busy_world();
        exchange(&mut world, &mut PhysicsWorld::new());
        println!("without {name}");
        world.detect_collisions(&(), &());
        check(&world);
        world.step();
        check(&world);
    }
}

/// Two worlds have sets of equal sizes, with other slots.
#[test]
fn a_world_continues_with_a_set_of_another_world() {
    for (name, exchange) in SETS {
        let (mut one, mut two) = (busy_world(), busy_world());
        let fallen = RigidBodyBuilder::dynamic().translation(vec(3.0, 0.5));
        one.insert(fallen, cuboid(0.5, 0.5));
        for _ in 0..3 {
            one.step();
            two.step();
        }
        println!("other {name}");
        exchange(&mut one, &mut two);
        for world in [&mut one, &mut two] {
            steps(world, &EventChecker::default(), 3);
        }
    }
}

/// One set returns to an older copy, while bodies were inserted into and removed from the others.
#[test]
fn one_set_can_return_to_a_copy() {
    for (name, exchange) in SETS {
        let mut world = busy_world();
        let mut old = PhysicsWorld {
            bodies: world.bodies.clone(),
            colliders: world.colliders.clone(),
            islands: world.islands.clone(),
            broad_phase: world.broad_phase.clone(),
            narrow_phase: world.narrow_phase.clone(),
            impulse_joints: world.impulse_joints.clone(),
            multibody_joints: world.multibody_joints.clone(),
            ..PhysicsWorld::new()
        };
        let gone = world.bodies.iter().map(|(handle, _)| handle).nth(2);
        world.remove_body(gone.expect("there are more than two"));
        world.insert(RigidBodyBuilder::dynamic().translation(vec(0.0, 5.0)), cuboid(0.5, 0.5));
        for _ in 0..5 {
            world.step();
        }
        println!("older {name}");
        exchange(&mut world, &mut old);
        for _ in 0..20 {
            world.step();
            check(&world);
        }
    }
}

/// Sets are exchanged before the first step and between two steps. Colliders refer to missing bodies, and
/// bodies list colliders that refer to other bodies.
#[test]
fn sets_are_exchanged_between_edits_and_the_next_step() {
    for steps in [0, 3] {
        for (name, exchange) in SETS {
            let world = || {
                let mut world = PhysicsWorld::new();
                let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 2.0));
                let (body, _) = world.insert(body, cuboid(0.5, 0.5));
                (0..steps).for_each(|_| world.step());
                (world, body)
            };
            let ((mut one, body), (mut two, _)) = (world(), world());
            one.insert(RigidBodyBuilder::dynamic().translation(vec(3.0, 0.5)), cuboid(0.5, 0.5));
            one.insert_collider(cuboid(0.1, 0.1), Some(body));
            println!("other {name} after {steps} steps");
            exchange(&mut one, &mut two);
            for world in [&mut one, &mut two] {
                world.step();
                check(world);
            }
        }
    }
}

/// A body is replaced by a copy of another one, and its joints are removed. Positions are corrected before
/// any body wakes.
#[test]
fn joints_are_removed_while_a_body_is_replaced() {
    for (name, exchange) in SETS {
        let mut world = busy_world();
        let handles: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
        exchange(&mut world, &mut PhysicsWorld::new());
        println!("without {name}");
        for pair in handles.windows(2).rev() {
            if let (Some(one), Some(two)) = world.bodies.get_pair_mut(pair[0], pair[1]) {
                swap(one, two);
            }
        }
        for _ in 0..3 {
            world.step();
            check(&world);
        }
    }
}

/// Missing bodies count as removed, and sleeping bodies on them fall.
#[test]
fn missing_bodies_lose_their_colliders() {
    let mut world = PhysicsWorld::new();
    let ground = ColliderBuilder::halfspace(Vector::Y).active_events(ActiveEvents::all());
    let ground = world.insert_collider(ground, None);
    let (body, collider) =
        world.insert(RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5)), cuboid(0.5, 0.5));
    let event_checker = EventChecker::default();
    steps(&mut world, &event_checker, 300);
    assert!(world.bodies[body].is_sleeping());
    let bodies = take(&mut world.bodies);
    steps(&mut world, &event_checker, 2);
    assert!(bodies.contains(body) && !world.colliders.contains(collider));
    assert!(world.colliders.contains(ground) && world.contact_pairs().next().is_none());
}

#[test]
fn bodies_fall_without_the_ground() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5)).additional_mass(1.0);
    let (body, _) = world.insert(body, cuboid(0.5, 0.5));
    for _ in 0..300 {
        world.step();
    }
    assert!(world.bodies[body].is_sleeping());
    world.colliders = ColliderSet::new();
    world.step();
    check(&world);
    let expected = -9.81 * world.integration_parameters.dt;
    let velocity = world.bodies[body].linvel().y;
    assert!((velocity - expected).abs() < 1.0e-4, "it falls at {velocity}, not {expected}");
}

/// Contact events stay consistent: discarded pairs end, and begin again if they still touch.
#[test]
fn events_stay_consistent_when_a_set_is_exchanged() {
    for (name, exchange) in SETS.into_iter().filter(|(name, _)| *name != "narrow phase") {
        let mut world = busy_world();
        world.colliders.iter_mut().for_each(|(_, it)| it.set_active_events(ActiveEvents::all()));
        let event_checker = EventChecker::default();
        steps(&mut world, &event_checker, 60);
        println!("without {name}");
        exchange(&mut world, &mut PhysicsWorld::new());
        steps(&mut world, &event_checker, 3);
    }
}

/// A world without joints accepts a new empty set of joints each time, without a resync.
#[test]
fn new_empty_sets_of_joints_change_nothing() {
    let run = |exchanges: bool| {
        let mut scene = Scene::new();
        for _ in 0..10 {
            scene.steps(1);
            if exchanges {
                scene.world.impulse_joints = ImpulseJointSet::new();
                scene.world.multibody_joints = MultibodyJointSet::new();
            }
        }
        scene.all_in_the_end()
    };
    assert_eq!(run(true), run(false));
}

/// Joints that return act again.
#[test]
fn joints_that_return_act_again() {
    let mut world = PhysicsWorld::new();
    let ceiling = world.insert_body(RigidBodyBuilder::fixed());
    let bob = RigidBodyBuilder::dynamic().translation(vec(1.0, 0.0));
    let (bob, _) = world.insert(bob, cuboid(0.2, 0.2));
    let joint = FixedJointBuilder::new().local_anchor2(vec(-1.0, 0.0));
    world.insert_impulse_joint(ceiling, bob, joint);
    world.step();
    let joints = take(&mut world.impulse_joints);
    world.step();
    let fallen = world.bodies[bob].translation().y;
    assert!(fallen < 0.0, "without its joint it falls, and is at {fallen}");
    world.bodies[bob].set_position(Pose::from_translation(vec(1.0, 0.0)), true);
    world.bodies[bob].set_vels(RigidBodyVelocity::zero(), true);
    world.impulse_joints = joints;
    for _ in 0..60 {
        world.step();
    }
    let error = world.bodies[bob].translation().distance(vec(1.0, 0.0));
    assert!(error < 1.0e-3, "held, it is {error} away from its place");
}
