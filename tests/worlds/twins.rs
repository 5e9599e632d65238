//! Exchanges of sets with a twin: a world that differs in a single number, a single sleeping body, or a
//! single edit.
//!
//! The step detects every mixture of sets, and the world continues like one with new islands, pairs and
//! trees, bit for bit.

use super::records::check_attachments;
use super::scene::{bits, copy, cube, step, world};
use crate::rapier::prelude::*;
use core::mem::swap;

/// Exchange of one set of two worlds.
pub type Exchange = fn(&mut PhysicsWorld, &mut PhysicsWorld);

pub const SETS: [Exchange; 7] = [
    |one, two| swap(&mut one.bodies, &mut two.bodies),
    |one, two| swap(&mut one.colliders, &mut two.colliders),
    |one, two| swap(&mut one.islands, &mut two.islands),
    |one, two| swap(&mut one.broad_phase, &mut two.broad_phase),
    |one, two| swap(&mut one.narrow_phase, &mut two.narrow_phase),
    |one, two| swap(&mut one.impulse_joints, &mut two.impulse_joints),
    |one, two| swap(&mut one.multibody_joints, &mut two.multibody_joints),
];

/// All sets.
const ALL: u32 = (1 << SETS.len()) - 1;

/// Number of steps before the exchange: the pile has contacts.
const BEFORE: usize = 12;

type Change = fn(&mut PhysicsWorld);

/// Returns the second dynamic body: part of the pile.
fn second(world: &PhysicsWorld) -> RigidBodyHandle {
    let mut dynamic = world.bodies.iter().filter(|(_, body)| body.is_dynamic());
    dynamic.nth(1).expect("there are more").0
}

fn shift(world: &mut PhysicsWorld, along: Vector) {
    let body = second(world);
    let place = world.bodies[body].translation() + along * 1.0e-3;
    world.bodies[body].set_translation(place, true);
}

/// Differences of a twin before the steps of both worlds.
const EARLIER: [(&str, Change); 8] = [
    ("nothing", |_| {}),
    ("x", |world| shift(world, Vector::X)),
    ("y", |world| shift(world, Vector::Y)),
    ("the last coordinate", |world| shift(world, Vector::AXES[DIM - 1])),
    ("a velocity", |world| {
        let body = second(world);
        world.bodies[body].set_linvel(Vector::AXES[DIM - 1] * 0.01, true);
    }),
    ("a sleeper", |world| {
        let mut bodies = world.bodies.iter_mut();
        let sleeper = bodies.find(|(_, body)| body.is_sleeping()).expect("some sleep").1;
        sleeper.set_translation(sleeper.translation() + Vector::AXES[DIM - 1] * 0.01, false);
    }),
    ("friction", |world| {
        world.colliders.iter_mut().next().expect("the ground").1.set_friction(0.1);
    }),
    ("a body that was removed and inserted again", |world| {
        let handle = second(world);
        let body = world.bodies.remove(handle).expect("it is there");
        world.step();
        world.insert(body, cube(0.5));
    }),
];

/// Edits of a twin after the last step.
const LATER: [(&str, Change); 7] = [
    ("nothing", |_| {}),
    ("a body is inserted", |world| {
        world.insert_body(RigidBodyBuilder::dynamic().additional_mass(1.0));
    }),
    ("a body with a collider is inserted", |world| {
        world.insert(RigidBodyBuilder::dynamic().translation(Vector::Y * 8.0), cube(0.3));
    }),
    ("a body is removed", |world| drop(world.bodies.remove(second(world)))),
    ("a collider is removed", |world| {
        let collider = world.bodies[second(world)].colliders()[0];
        world.remove_collider(collider);
    }),
    ("collisions are detected", |world| world.detect_collisions(&(), &())),
    ("joints are removed, inserted and registered by a detection", |world| {
        let joint = world.impulse_joints.iter().next().expect("there are two").0;
        let joint = world.impulse_joints.remove(joint, true).expect("it is there");
        world.impulse_joints.insert(second(world), joint.body2(), joint.data, true);
        world.detect_collisions(&(), &());
    }),
];

fn stepped(mut world: PhysicsWorld, count: usize) -> PhysicsWorld {
    (0..count).for_each(|_| world.step());
    world
}

/// Exchanges the sets of a bit mask.
fn exchanged(one: &PhysicsWorld, two: &PhysicsWorld, sets: u32) -> [PhysicsWorld; 2] {
    let (mut one, mut two) = (copy(one), copy(two));
    for exchange in SETS.iter().enumerate().filter(|(set, _)| sets & (1 << set) != 0) {
        exchange.1(&mut one, &mut two);
    }
    [one, two]
}

/// Returns the bits after some steps. No collider belongs to a missing body.
pub fn outcome(mut world: PhysicsWorld) -> Vec<String> {
    (0..3).for_each(|_| step(&mut world));
    check_attachments(&world);
    bits(&world)
}

/// Returns the same with new islands, pairs and trees.
pub fn outcome_anew(mut world: PhysicsWorld) -> Vec<String> {
    world.islands = IslandManager::new();
    world.broad_phase = BroadPhaseBvh::new();
    world.narrow_phase = NarrowPhase::new();
    outcome(world)
}

#[test]
fn every_mixture_of_twins_is_detected() {
    let one = stepped(world(), BEFORE);
    for (name, change) in EARLIER {
        let mut two = world();
        change(&mut two);
        let two = stepped(two, BEFORE);
        // A mixture equals that of the other sets from the twin's side.
        for sets in 1..=ALL / 2 {
            for (side, mixed) in exchanged(&one, &two, sets).into_iter().enumerate() {
                let expected = outcome_anew(copy(&mixed));
                assert_eq!(outcome(mixed), expected, "{name}: sets {sets:07b} of twin {side}");
            }
        }
    }
}

#[test]
fn all_sets_of_a_twin_belong_together() {
    for (_, change) in EARLIER {
        let mut two = world();
        change(&mut two);
        let (one, two) = (stepped(world(), BEFORE), stepped(two, BEFORE));
        let [first, second] = exchanged(&one, &two, ALL);
        assert_eq!(outcome(first), outcome(copy(&two)));
        assert_eq!(outcome(second), outcome(copy(&one)));
    }
}

/// Copies belong to each other as long as edits affect one set at a time. In every mixture the world
/// continues, equally in every run.
#[test]
fn copies_that_were_edited_are_mixed_in_every_way() {
    let one = stepped(world(), BEFORE);
    for (name, change) in LATER {
        for step_between in [false, true] {
            let mut two = copy(&one);
            if step_between {
                two.step();
            }
            change(&mut two);
            for sets in 1..=ALL / 2 {
                let runs = [(); 2].map(|()| exchanged(&one, &two, sets).map(outcome));
                assert_eq!(runs[0], runs[1], "{name}, {step_between}: sets {sets:07b}");
            }
        }
    }
}

/// Edit of the rigid joint of one of two copies, applied by a detection.
const JOINT_EDITS: [(&str, Change); 3] = [
    ("disabled", |world| {
        rigid_joint(world).1.data.set_enabled(false);
    }),
    ("removed", |world| {
        let joint = rigid_joint(world).0;
        world.impulse_joints.remove(joint, true);
    }),
    ("free", |world| {
        rigid_joint(world).1.data.locked_axes = JointAxesMask::empty();
    }),
];

/// Returns the joint that fixes one bob to another.
fn rigid_joint(world: &mut PhysicsWorld) -> (ImpulseJointHandle, &mut ImpulseJoint) {
    world.impulse_joints.iter_mut().nth(1).expect("there are two")
}

/// A copy detects collisions after an edit of a joint, and gets the joints of the other copy, without the
/// edit; and the reverse. Each world solves its present joints. An active joint is apart by less than 5 cm
/// after a second; without it the second bob falls.
#[test]
fn joints_of_another_copy_act() {
    let mut one = stepped(world(), BEFORE);
    let (joint, [bob, other]) = {
        let (handle, joint) = rigid_joint(&mut one);
        (handle, [joint.body1(), joint.body2()])
    };
    one.step();
    for (name, edit) in JOINT_EDITS {
        let mut two = copy(&one);
        edit(&mut two);
        two.detect_collisions(&(), &());
        for (side, mut mixed) in exchanged(&one, &two, 1 << 5).into_iter().enumerate() {
            let acts = mixed.impulse_joints.get(joint).is_some_and(|joint| {
                joint.data.enabled == JointEnabled::Enabled && !joint.data.locked_axes.is_empty()
            });
            assert_eq!(acts, side == 1, "the joints have changed places");
            (0..60).for_each(|_| step(&mut mixed));
            let anchor = mixed.bodies[other].position().transform_point(-Vector::X);
            let gap = (anchor - mixed.bodies[bob].translation()).length();
            println!("{name}, side {side}: the joint acts: {acts}, and is apart by {gap:.4} m");
            assert_eq!(gap < 0.05, acts, "{name}: apart by {gap} m");
        }
    }
}

/// Sets of one world that were copied at one time continue like the original.
#[test]
fn copies_of_one_time_belong_together() {
    let one = stepped(world(), BEFORE);
    let expected = outcome(copy(&one));
    for sets in 1..=ALL {
        let [mixed, other] = exchanged(&one, &one, sets);
        assert_eq!(outcome(mixed), expected, "sets {sets:07b}");
        assert_eq!(outcome(other), expected, "sets {sets:07b}");
    }
}

/// A pipeline has buffers, but no state of its last world.
#[test]
fn pipelines_are_exchanged() {
    let (mut one, mut two) = (world(), PhysicsWorld::new());
    two.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    for k in 0..40_u8 {
        let (x, y) = (Real::from(k % 5), Real::from(k / 5));
        let place = Vector::X * (1.1 * x) + Vector::Y * (0.6 + 1.1 * y);
        two.insert(RigidBodyBuilder::dynamic().translation(place), cube(0.5));
    }
    let (mut alone, mut other) = (copy(&one), copy(&two));
    for turn in 0..30 {
        [&mut one, &mut two, &mut alone, &mut other].into_iter().for_each(step);
        swap(&mut one.physics_pipeline, &mut two.physics_pipeline);
        swap(&mut one.collision_pipeline, &mut two.collision_pipeline);
        if turn % 7 == 0 {
            [&mut one, &mut two, &mut alone, &mut other]
                .into_iter()
                .for_each(|it| it.detect_collisions(&(), &()));
        }
    }
    assert_eq!(bits(&one), bits(&alone));
    assert_eq!(bits(&two), bits(&other));
}

/// Islands of a twin are stepped on several threads. Without a resync, constraints of a colour would share
/// bodies, and runs would differ.
#[test]
fn every_run_of_mixed_twins_is_the_same() {
    let pile = |offset: Real| {
        let mut world = PhysicsWorld::new();
        world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
        for k in 0..200_u8 {
            let (column, row) = (Real::from(k % 10), Real::from(k / 10));
            let place = Vector::X * (column + 0.05 * row) + Vector::Y * (0.5 + row);
            let place = place + Vector::AXES[DIM - 1] * (offset * row);
            world.insert(RigidBodyBuilder::dynamic().translation(place), cube(0.5));
        }
        stepped(world, 30)
    };
    let (one, two) = (pile(0.0), pile(0.02));
    for (set, _) in SETS.iter().enumerate() {
        let run = || {
            let [mut mixed, _] = exchanged(&one, &two, 1 << set);
            (0..10).for_each(|_| step(&mut mixed));
            bits(&mixed)
        };
        let first = run();
        for _ in 0..7 {
            assert_eq!(run(), first, "set {set}");
        }
    }
}

/// A step that panics leaves sets that do not belong together.
#[test]
fn a_world_continues_after_an_exchange_at_every_step() {
    let (mut one, mut two) = (world(), world());
    shift(&mut two, Vector::AXES[DIM - 1]);
    for turn in 0..40 {
        SETS[turn % SETS.len()](&mut one, &mut two);
        step(&mut one);
        step(&mut two);
    }
}
