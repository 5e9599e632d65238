//! Worlds that are saved and loaded.

use super::scene::{bits, copy, cube, step, world};
use super::sets::{load_all, load_into, save_all};
use crate::rapier::prelude::*;

/// Returns one of the awake bodies. `None` in a damaged world that has too few.
fn awake(world: &PhysicsWorld, position: usize) -> Option<RigidBodyHandle> {
    let body = world.active_bodies().get(position).copied();
    body.filter(|body| world.bodies.contains(*body))
}

fn change_awake(world: &mut PhysicsWorld, position: usize, change: impl Fn(&mut RigidBody)) {
    let body = awake(world, position);
    body.and_then(|body| world.bodies.get_mut(body)).into_iter().for_each(change);
}

fn remove_awake(world: &mut PhysicsWorld, position: usize) {
    awake(world, position).into_iter().for_each(|body| drop(world.bodies.remove(body)));
}

/// Name of an edit of a world, and the edit.
pub type Edit = (&'static str, fn(&mut PhysicsWorld));

/// Edits between the last step and saving.
pub const EDITS: [Edit; 9] = [
    ("nothing", |_| {}),
    ("a push", |world| change_awake(world, 2, |body| body.apply_impulse(Vector::X, true))),
    ("a body that was moved", |world| {
        change_awake(world, 1, |body| body.set_translation(Vector::Y * 20.0, true));
    }),
    ("a body more", |world| {
        world.insert(RigidBodyBuilder::dynamic().translation(Vector::Y * 9.0), cube(0.3));
    }),
    ("a body less", |world| remove_awake(world, 1)),
    ("a body in the place of another", |world| {
        remove_awake(world, 1);
        world.insert(RigidBodyBuilder::dynamic().translation(Vector::Y * 9.0), cube(0.3));
    }),
    ("a collider less", |world| {
        let body = awake(world, 3).and_then(|body| world.bodies.get(body));
        let collider = body.and_then(|body| body.colliders().first().copied());
        collider.into_iter().for_each(|collider| drop(world.remove_collider(collider)));
    }),
    ("another type", |world| {
        change_awake(world, 2, |body| body.set_body_type(RigidBodyType::Fixed, true));
    }),
    ("a joint less, and links that are cut", |world| {
        let joint = world.impulse_joints.iter().next().map(|(handle, _)| handle);
        if let Some(joint) = joint {
            world.impulse_joints.remove(joint, true);
        }
        let link = world.multibody_joints.iter().nth(1).map(|joint| joint.0);
        if let Some(link) = link {
            world.multibody_joints.remove(link, true);
        }
    }),
];

/// A loaded world continues bit for bit like the saved one, whatever the edits before saving.
#[test]
fn a_loaded_world_continues_like_the_saved_one() {
    for steps in [0, 1, 12, 150] {
        for (name, edit) in EDITS {
            if steps == 0 && name != "nothing" {
                continue;
            }
            let mut one = world();
            (0..steps).for_each(|_| step(&mut one));
            edit(&mut one);
            let mut two = load_all(&save_all(&one)).expect("it was saved");
            for k in 0..20 {
                step(&mut one);
                step(&mut two);
                assert_eq!(bits(&one), bits(&two), "{name}: {k} steps after {steps}");
            }
        }
    }
}

/// Saved data is the same in every run and for a copy: it contains no process-wide counter.
#[test]
fn equal_histories_give_equal_data() {
    let run = || {
        let mut world = world();
        (0..12).for_each(|_| step(&mut world));
        save_all(&world)
    };
    let first = run();
    assert!(first == run() && first == save_all(&load_all(&first).expect("it was saved")));
}

/// Each loaded set belongs to the live sets of its world: any of them may be loaded alone.
#[test]
fn a_set_loaded_alone_belongs_to_the_others() {
    let mut one = world();
    (0..12).for_each(|_| step(&mut one));
    let saved = save_all(&one);
    let mut expected = copy(&one);
    (0..5).for_each(|_| step(&mut expected));
    for sets in 0..1 << saved.len() {
        let mut mixed = copy(&one);
        for (set, tree) in saved.iter().enumerate().filter(|(set, _)| sets & (1 << set) != 0) {
            load_into(&mut mixed, set, tree).expect("it was saved");
        }
        (0..5).for_each(|_| step(&mut mixed));
        assert_eq!(bits(&mixed), bits(&expected), "loaded sets: {sets:07b}");
    }
}

/// Sets of different times and of twins are mixed: the world continues in every combination.
#[test]
fn sets_of_different_times_are_mixed() {
    let mut one = world();
    (0..10).for_each(|_| step(&mut one));
    let early = save_all(&one);
    (0..3).for_each(|_| step(&mut one));
    let late = save_all(&one);
    for sets in 0..1 << early.len() {
        let mixed = core::array::from_fn(|set| {
            if sets & (1 << set) == 0 { early[set].clone() } else { late[set].clone() }
        });
        let mut loaded = load_all(&mixed).expect("each set was saved");
        loaded.detect_collisions(&(), &());
        (0..3).for_each(|_| step(&mut loaded));
    }
}

/// Pairs of sleeping bodies are in no list of a step: only the history shows that some are missing.
#[test]
fn sleeping_bodies_loaded_without_pairs_touch_again() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let stack = [0.5, 1.5, 2.5]
        .map(|y| world.insert(RigidBodyBuilder::dynamic().translation(Vector::Y * y), cube(0.5)).0);
    (0..300).for_each(|_| step(&mut world));
    assert!(world.bodies[stack[2]].is_sleeping());
    let saved = save_all(&world);
    for without in [2, 3, 4] {
        let mut loaded = PhysicsWorld::new();
        for set in (0..saved.len()).filter(|set| *set != without) {
            load_into(&mut loaded, set, &saved[set]).expect("it was saved");
        }
        loaded.bodies[stack[1]].wake_up(true);
        (0..120).for_each(|_| step(&mut loaded));
        let height = loaded.bodies[stack[2]].translation().y;
        assert!((height - 2.5).abs() < 0.05, "the top of the stack is at {height}");
    }
}

/// A loaded world is edited and queried before its first step.
#[test]
fn a_loaded_world_can_be_edited_before_its_first_step() {
    for (name, edit) in EDITS {
        let mut one = world();
        (0..12).for_each(|_| step(&mut one));
        let mut two = load_all(&save_all(&one)).expect("it was saved");
        edit(&mut one);
        edit(&mut two);
        for _ in 0..5 {
            step(&mut one);
            step(&mut two);
        }
        assert_eq!(bits(&one), bits(&two), "{name}");
    }
}
