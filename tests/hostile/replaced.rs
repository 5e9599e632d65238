//! Replaced records: `set[a] = set[b].clone()`, and two swapped records.
//!
//! A `&mut` to a body or collider allows an assignment. The new value brings references of *its* slot along:
//! its body, its colliders, its indices in the lists of the step.

use super::listener::listen;
use super::scene::Scene;
use super::world::check;
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// A collider is assigned to its neighbour's slot. It then exists twice, once in each slot, with the same
/// shape and body.
#[test]
fn a_collider_that_is_assigned_belongs_to_the_body_that_it_names() {
    let mut scene = Scene::new();
    let other = scene.world.bodies[scene.neighbours[1]].colliders()[0];
    let copy = scene.world.colliders[other].clone();
    scene.world.colliders[scene.collider] = copy;
    scene.steps(2);
    assert!(scene.world.bodies[scene.body].colliders().is_empty());
    let mut parts = scene.world.bodies[scene.neighbours[1]].colliders().to_vec();
    parts.sort_unstable();
    let mut expected = [other, scene.collider];
    expected.sort_unstable();
    assert_eq!(parts, expected);
    let mass = scene.world.bodies[scene.neighbours[1]].mass();
    let part = scene.world.colliders[other].mass();
    assert!((mass - 2.0 * part).abs() < 1.0e-5 * mass, "two parts of {part} weigh {mass}");
}

/// The same holds just before it is attached to another body, or removed: no list contains it.
#[test]
fn a_collider_that_was_assigned_can_be_moved_and_removed() {
    for removes in [false, true] {
        let mut scene = Scene::new();
        let copy = scene.world.colliders[scene.ground].clone();
        scene.world.colliders[scene.collider] = copy;
        if removes {
            scene.world.remove_collider(scene.collider);
        } else {
            let PhysicsWorld { colliders, bodies, .. } = &mut scene.world;
            colliders.set_parent(scene.collider, Some(scene.neighbours[0]), bodies);
        }
        assert!(scene.world.bodies[scene.body].colliders().is_empty(), "it is gone from here");
        scene.steps(3);
        let expected = if removes { 1 } else { 2 };
        assert_eq!(scene.world.bodies[scene.neighbours[0]].colliders().len(), expected);
    }
}

/// Two swapped colliders change bodies: each belongs to the body that its record names.
#[test]
fn colliders_that_are_swapped_stay_with_their_bodies() {
    let mut scene = Scene::new();
    let below = scene.world.bodies[scene.neighbours[0]].colliders()[0];
    if let (Some(one), Some(two)) = scene.world.colliders.get_pair_mut(scene.collider, below) {
        core::mem::swap(one, two);
    }
    scene.steps(2);
    assert_eq!(scene.world.bodies[scene.body].colliders(), [below]);
    assert_eq!(scene.world.bodies[scene.neighbours[0]].colliders(), [scene.collider]);
}

/// A fixed body is in no list of the step. Only its slot shows that another body replaced it.
#[test]
fn fixed_bodies_that_are_swapped_keep_the_colliders_of_their_places() {
    let mut world = PhysicsWorld::new();
    let bare = world.insert_body(RigidBodyBuilder::fixed());
    let (clad, collider) = world.insert(RigidBodyBuilder::fixed(), cuboid(0.5, 0.5));
    world.step();
    for _ in 0..2 {
        if let (Some(one), Some(two)) = world.bodies.get_pair_mut(bare, clad) {
            core::mem::swap(one, two);
            // The collider is attached to the body that the record in this slot already names.
            let PhysicsWorld { colliders, bodies, .. } = &mut world;
            colliders.set_parent(collider, Some(bare), bodies);
            colliders.set_parent(collider, Some(clad), bodies);
        }
        world.step();
        assert!(world.bodies[bare].colliders().is_empty());
        assert_eq!(world.bodies[clad].colliders(), [collider]);
    }
}

/// A body that is set back to an older copy of itself takes its colliders along, although the copy records no
/// change.
#[test]
fn a_body_set_back_to_a_copy_keeps_its_colliders() {
    let mut world = PhysicsWorld::new();
    let body = RigidBodyBuilder::fixed().translation(vec(1.0, 2.0));
    let (body, collider) = world.insert(body, cuboid(0.5, 0.5));
    world.step();
    let old = world.bodies[body].clone();
    world.bodies[body].set_translation(vec(5.0, 5.0), true);
    world.step();
    world.bodies[body] = old;
    world.step();
    assert_eq!(world.colliders[collider].translation(), vec(1.0, 2.0));
}

/// A multibody joint connects a body to the former body of its slot.
#[test]
fn a_multibody_of_a_body_and_its_predecessor_is_removed() {
    let mut world = PhysicsWorld::new();
    let gone = world.insert_body(RigidBodyBuilder::dynamic());
    world.remove_body(gone);
    let body = world.insert_body(RigidBodyBuilder::dynamic());
    assert_eq!(gone.into_raw_parts().0, body.into_raw_parts().0, "the slot is used again");
    for [parent, child] in [[gone, body], [body, gone]] {
        world.insert_multibody_joint(parent, child, FixedJointBuilder::new());
        world.step();
        super::world::check(&world);
        assert!(world.multibody_joints.is_empty());
    }
}

/// Adds chains of balls. Returns their joints, in the order of the links.
fn chains(world: &mut PhysicsWorld, lengths: &[usize]) -> Vec<Vec<MultibodyJointHandle>> {
    let mut chain = |row: usize, length: usize| {
        let ball = |k: usize| {
            RigidBodyBuilder::dynamic().translation(vec(k as Real, 3.0 * row as Real + 2.0))
        };
        let mut last = world.insert(ball(0), ColliderBuilder::ball(0.2)).0;
        (1..length)
            .map(|k| {
                let next = world.insert(ball(k), ColliderBuilder::ball(0.2)).0;
                let joint = crate::dim::hinge().local_anchor1(vec(1.0, 0.0)).build();
                let joint = world.multibody_joints.insert(last, next, joint, true);
                last = next;
                joint.expect("nothing is in the way")
            })
            .collect()
    };
    lengths.iter().enumerate().map(|(row, &length)| chain(row, length)).collect()
}

fn multibody(world: &mut PhysicsWorld, joint: MultibodyJointHandle) -> &mut Multibody {
    world.multibody_joints.get_mut(joint).expect("it was not removed").0
}

/// Runs all queries of a multibody.
fn query(multibody: &mut Multibody, bodies: &mut RigidBodySet) {
    let count = multibody.num_links() + 2;
    multibody.mass_matrix();
    multibody.bias_forces();
    multibody.accelerations_of(&[1.0; 3]);
    multibody.forward_kinematics(bodies, true);
    multibody.apply_displacements(&[0.1; 40]);
    for id in (0..count).chain([usize::MAX]) {
        multibody.forward_kinematics_single_branch(bodies, id);
        multibody.body_jacobian(id);
        multibody.kinematic_branch(id);
        multibody.joint_velocity(id);
        let options = InverseKinematicsOption::default();
        let mut shift = vec![0.0; multibody.ndofs()];
        let target = Pose::from_translation(Vector::ONE);
        multibody.inverse_kinematics(bodies, id, &options, &target, |_| true, &mut shift);
        multibody.inverse_kinematics_delta(id, &[0.1; _], 1.0, &mut shift);
        for axis in [JointAxis::LinX, JointAxis::AngX] {
            let _ = multibody.add_dof_coupling(id, axis, 1, JointAxis::AngX, 1.0, 0.0);
        }
    }
    multibody.update_rigid_bodies(bodies, true);
}

/// A multibody with links other than the joined ones is invalid: its joints are removed, and no other object
/// is.
#[test]
fn swapped_multibodies_and_links_are_removed() {
    type Change = (&'static str, fn(&mut PhysicsWorld, &[Vec<MultibodyJointHandle>]));
    let changes: [Change; 7] = [
        ("emptied", |world, chains| *multibody(world, chains[0][0]) = Multibody::new()),
        ("swapped", |world, chains| {
            let short = core::mem::take(multibody(world, chains[0][0]));
            let long = core::mem::replace(multibody(world, chains[1][0]), short);
            *multibody(world, chains[0][0]) = long;
        }),
        ("a copy of another", |world, chains| {
            let long = multibody(world, chains[1][0]).clone();
            *multibody(world, chains[0][0]) = long;
        }),
        ("a link twice", |world, chains| {
            let chain = multibody(world, chains[0][0]);
            *chain.link_mut(1).expect("three links") = chain.link(2).expect("three").clone();
        }),
        ("a root behind", |world, chains| {
            let chain = multibody(world, chains[0][0]);
            *chain.link_mut(2).expect("three links") = chain.root().expect("three").clone();
        }),
        ("a link from far behind", |world, chains| {
            let last = multibody(world, chains[1][0]).link(5).expect("six links").clone();
            *multibody(world, chains[0][0]).root_mut().expect("a root") = last;
        }),
        ("turned round", |world, chains| {
            let chain = multibody(world, chains[0][0]);
            let mut links: Vec<_> = chain.links().cloned().collect();
            chain.links_mut().for_each(|link| *link = links.pop().expect("as many as before"));
        }),
    ];
    for (name, change) in changes {
        for (step_first, then) in
            [false, true].into_iter().flat_map(|s| (0..4).map(move |t| (s, t)))
        {
            let mut world = PhysicsWorld::new();
            world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
            let chains = chains(&mut world, &[3, 6, 2]);
            if step_first {
                world.step();
            }
            change(&mut world, &chains);
            listen(|| continue_world(&mut world, chains[0][1], then));
            let left = |k: usize| chains[k].iter().filter(|j| world.multibody_joints.contains(**j));
            assert_eq!(left(0).count(), 0, "{name}, {then}: joints of the broken one are left");
            assert_eq!(left(2).count(), 1, "{name}, {then}: another chain lost its joint");
        }
    }
}

/// Queries, edits in one of four ways, and steps a world with an invalid multibody.
fn continue_world(world: &mut PhysicsWorld, joint: MultibodyJointHandle, then: usize) {
    let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
    let PhysicsWorld { multibody_joints, bodies: set, .. } = &mut *world;
    if let Some((multibody, _)) = multibody_joints.get_mut(joint) {
        query(multibody, set);
    }
    match then {
        0 => {}
        1 => drop(world.multibody_joints.remove(joint, true)),
        2 => drop(world.remove_body(bodies[1])),
        _ => {
            let hinge = crate::dim::hinge().build();
            world.multibody_joints.insert(bodies[2], bodies[9], hinge, true);
        }
    }
    for &body in &bodies {
        world.multibody_joints.attached_joints(body).count();
        world.multibody_joints.attached_bodies(body).count();
    }
    for _ in 0..5 {
        world.step();
        check(world);
    }
}

/// Swapped joints act on each other's bodies, or on none.
#[test]
fn swapped_joints_act_on_the_bodies_of_their_records() {
    let mut world = PhysicsWorld::new();
    let balls: [_; 6] = core::array::from_fn(|k| {
        let body = RigidBodyBuilder::dynamic().translation(vec(k as Real, 0.0));
        world.insert(body, ColliderBuilder::ball(0.2)).0
    });
    let mut join = |a: usize, b: usize| {
        let joint = FixedJointBuilder::new().local_anchor1(vec(1.0, 0.0)).build();
        world.impulse_joints.insert(balls[a], balls[b], joint, true)
    };
    let joints = [join(0, 1), join(2, 3), join(4, 5)];
    world.step();
    let first = world.impulse_joints[joints[0]].clone();
    let second = core::mem::replace(&mut world.impulse_joints[joints[1]], first);
    world.impulse_joints[joints[0]] = second;
    world.remove_body(balls[2]);
    for _ in 0..10 {
        world.step();
        check(&world);
    }
    assert!(!world.impulse_joints.contains(joints[0]), "it held the body that was removed");
    assert_eq!(world.impulse_joints.joints_between(balls[0], balls[1]).count(), 1);
    assert_eq!(world.impulse_joints.len(), 2);
}
