//! Contacts of links with the ground, with other bodies and with each other.

use super::stage::{Chain, chain_of, energy, momentum};
use crate::dim::{cuboid, hinge, vec};
use crate::suite::physics::stage::{G, add_ground, penetration, run, steps, weightless, world};
use rapier::prelude::*;

/// Adds a chain of boxes along x, with hinges at their ends.
fn boxes(world: &mut PhysicsWorld, count: usize, height: Real) -> Chain {
    chain_of(world, None, count, |world, k| {
        let body = RigidBodyBuilder::dynamic().translation(vec(k as Real, height));
        let (body, _) = world.insert(body, cuboid(0.45, 0.2).friction(0.6));
        let joint = hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
        (body, joint.into())
    })
}

/// A falling chain comes to rest on the ground, lies still, and falls asleep as a unit.
#[test]
fn a_chain_on_the_ground_lies_still_and_sleeps() {
    for rate in [30, 60, 240] {
        let mut world = world(rate);
        add_ground(&mut world, 0.6);
        let chain = boxes(&mut world, 8, 0.5);
        run(&mut world, 1.0);
        let before: Vec<_> = chain.bodies.iter().map(|&b| world.bodies[b].translation()).collect();
        for _ in 0..steps(&world, 2.0) {
            world.step();
            let asleep = chain.bodies.iter().filter(|&&b| world.bodies[b].is_sleeping()).count();
            assert!(asleep == 0 || asleep == chain.bodies.len(), "{asleep} of the links sleep");
        }
        for (&body, before) in chain.bodies.iter().zip(before) {
            let moved = (world.bodies[body].translation() - before).length();
            assert!(moved < 2.0e-3, "a link crept by {moved} at {rate} Hz");
            assert!(world.bodies[body].is_sleeping(), "a link is awake at {rate} Hz");
        }
        assert!(penetration(&world) < 5.0e-3, "{}", penetration(&world));

        world.wake_up(chain.bodies[3], true);
        world.step();
        let awake = chain.bodies.iter().all(|&body| !world.bodies[body].is_sleeping());
        assert!(awake, "all links wake with one of them");
    }
}

/// A ball that nothing touches goes on as before when the last contacts of links go with their chain, and
/// when it is the only body that is awake.
#[test]
fn a_free_ball_outlives_the_contacts_of_links() {
    let mut world = world(60);
    add_ground(&mut world, 0.6);
    let chain = boxes(&mut world, 3, 0.21);
    let ball = RigidBodyBuilder::dynamic().translation(vec(0.0, 50.0)).gravity_scale(0.0);
    let ball = ball.linvel(vec(1.0, 0.0)).can_sleep(false);
    let (ball, _) = world.insert(ball, ColliderBuilder::ball(0.5));
    run(&mut world, 0.2);
    let touches = world.contact_pairs().any(|(_, _, pair)| pair.has_any_active_contact);
    assert!(touches, "links lie on the ground");
    let mut without = world.clone();
    chain.bodies.iter().for_each(|&body| {
        without.remove_body(body);
    });
    for _ in 0..steps(&world, 5.0) {
        world.step();
        without.step();
        assert_eq!(world.bodies[ball].position(), without.bodies[ball].position());
    }
    assert!(chain.bodies.iter().all(|&body| world.bodies[body].is_sleeping()));
}

/// Adds a chain of capsules that hangs by its end, horizontal along x. Their round ends touch at the hinges,
/// which have limits. Every third capsule has a multiple of the others' mass. The post is a capsule as well
/// if it `is_solid`.
fn capsules(
    world: &mut PhysicsWorld,
    count: usize,
    limit: Real,
    mass: Real,
    is_solid: bool,
) -> Chain {
    let post = world.insert_body(RigidBodyBuilder::fixed());
    if is_solid {
        world.insert_collider(ColliderBuilder::capsule_x(0.15, 0.1), Some(post));
    }
    chain_of(world, Some(post), count, |world, k| {
        let at = vec(0.5 * (k + 1) as Real, 0.0);
        let body = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
        let density = if k % 3 == 0 { mass } else { 1.0 };
        let capsule = ColliderBuilder::capsule_x(0.15, 0.1).density(density);
        let (body, _) = world.insert(body, capsule);
        let joint = hinge().local_anchor1(vec(0.25, 0.0)).local_anchor2(vec(-0.25, 0.0));
        (body, joint.limits([-limit, limit]).into())
    })
}

/// Links that touch at their hinges swing, hit their limits and each other, and gain no energy. (The moment
/// arms of such contacts are almost zero.)
#[test]
fn links_that_touch_at_their_joints_gain_no_energy() {
    for is_solid in [false, true] {
        for (count, limit, mass) in
            [(5, 0.5, 1.0), (20, 0.5, 1.0), (20, 0.2, 1.0), (20, 2.0, 1.0), (12, 0.5, 30.0)]
        {
            let mut world = world(60);
            let chain = capsules(&mut world, count, limit, mass, is_solid);
            let start = energy(&world, &chain.bodies);
            let all: Real = chain.bodies.iter().map(|&body| world.bodies[body].mass()).sum();
            for step in 0..600 {
                world.step();
                let gained = energy(&world, &chain.bodies) - start;
                // The bound is a hundredth of the energy of fall, because the correction of penetration does
                // some work.
                let most = 0.01 * all * G * 0.5 * count as Real;
                let case = format!("{count} links, {limit} rad, {mass}, {is_solid}");
                assert!(gained < most, "{case}: {gained} J gained by step {step}");
                let last = &world.bodies[chain.bodies[count - 1]];
                assert!(last.is_enabled(), "{case}: the last link is disabled");
            }
        }
    }
}

/// Colliders of an arm that closes up to its limits do not overlap. Within the limits the ends of two
/// capsules would overlap by `2 r (1 - cos(α/2))`, which the contact prevents.
#[test]
fn links_that_touch_at_their_joints_are_held_apart() {
    let mut world = world(60);
    capsules(&mut world, 4, 2.0, 1.0, false);
    run(&mut world, 10.0);
    assert!(penetration(&world) < 0.01, "{} deep", penetration(&world));
}

/// The ground carries the weight of all links: the contact impulses of a step are `m g dt`.
#[test]
fn the_ground_carries_the_weight() {
    let mut world = world(60);
    add_ground(&mut world, 0.6);
    let chain = boxes(&mut world, 5, 0.2);
    for &body in &chain.bodies {
        world.bodies[body].activation_mut().normalized_linear_threshold = -1.0;
    }
    run(&mut world, 2.0);
    let total: Real = world
        .contact_pairs()
        .flat_map(|(_, _, pair)| &pair.manifolds)
        .flat_map(|manifold| &manifold.data)
        .map(|contact| contact.impulse)
        .sum();
    let mass: Real = chain.bodies.iter().map(|&body| world.bodies[body].mass()).sum();
    let expected = mass * G / 60.0;
    assert!((total / expected - 1.0).abs() < 0.01, "{total} instead of {expected}");
}

/// A box hits the end of a chain in free flight. Contact impulses are opposite: the total momentum is
/// constant.
#[test]
fn collisions_keep_momentum() {
    for restitution in [0.0, 0.7] {
        let mut world = weightless(60);
        let chain = boxes(&mut world, 4, 0.0);
        let bullet = RigidBodyBuilder::dynamic().translation(vec(3.1, 2.0)).linvel(vec(0.3, -5.0));
        let (bullet, _) = world.insert(bullet, cuboid(0.2, 0.2).restitution(restitution));
        let mut bodies = chain.bodies.clone();
        bodies.push(bullet);
        world.step();
        let before = momentum(&world, &bodies);
        run(&mut world, 1.0);
        let after = momentum(&world, &bodies);
        let changed = world.bodies[chain.bodies[3]].linvel().length();
        assert!(changed > 0.5, "the link was hit");
        // The error is rounding alone.
        let error = (after - before).length() / before.length();
        println!("momentum is off by {:.4} %", error * 100.0);
        assert!(error < 1.0e-4, "{after} instead of {before}");
    }
}

/// The end of an elastic chain rises to `e² h`.
#[test]
fn a_link_bounces() {
    let mut world = world(240);
    add_ground(&mut world, 0.5);
    let ball = |x: Real| RigidBodyBuilder::dynamic().translation(vec(x, 1.5)).can_sleep(false);
    let (first, _) = world.insert(ball(0.0), ColliderBuilder::ball(0.5).restitution(0.8));
    let (second, _) = world.insert(ball(1.2), ColliderBuilder::ball(0.5).restitution(0.8));
    let weld = FixedJointBuilder::new().local_anchor1(vec(1.2, 0.0));
    world.multibody_joints.insert(first, second, weld, true).expect("it fits");
    run(&mut world, 0.6);
    let mut top: Real = 0.0;
    for _ in 0..steps(&world, 0.5) {
        world.step();
        top = top.max(world.bodies[first].translation().y - 0.5);
    }
    // The coefficient is averaged with the ground's 0: 0.4² of 1 m.
    assert!((top - 0.16).abs() < 0.02, "{top}");
}

/// Links of one multibody collide if their contacts are enabled, and otherwise pass through each other.
#[test]
fn links_collide_if_enabled() {
    for enabled in [true, false] {
        let mut world = weightless(60);
        let post = world.insert_body(RigidBodyBuilder::fixed());
        let mut handles = Vec::new();
        for side in [-1.0, 1.0] {
            let slider = RigidBodyBuilder::dynamic().translation(vec(side * 2.0, 0.0));
            let (slider, _) = world.insert(slider.linvel(vec(-side, 0.0)), cuboid(0.5, 0.5));
            let rail = PrismaticJointBuilder::new(vec(1.0, 0.0));
            handles.push(world.multibody_joints.insert(post, slider, rail, true).expect("it fits"));
        }
        let (multibody, _) = world.multibody_joints.get_mut(handles[0]).expect("it is there");
        multibody.set_self_contacts_enabled(enabled);
        run(&mut world, 3.0);
        let at = |k: usize| {
            let link = world.multibody_joints.get_link(handles[k]).expect("a link");
            world.bodies[link.rigid_body_handle()].translation().x
        };
        let gap = at(1) - at(0);
        if enabled {
            assert!((gap - 1.0).abs() < 0.01, "they stop at each other, not at {gap}");
        } else {
            assert!((gap + 2.0).abs() < 0.01, "they pass through each other, to {gap}");
        }
    }
}

/// A box rests on a link at its limit, and the link carries the box's weight.
#[test]
fn bodies_rest_on_links() {
    let mut world = world(60);
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let shelf = RigidBodyBuilder::dynamic().translation(vec(1.0, 0.0));
    let (shelf, _) = world.insert(shelf, cuboid(1.0, 0.1).friction(0.8));
    let joint = hinge().local_anchor2(vec(-1.0, 0.0)).limits([0.0, 1.0]);
    let handle = world.multibody_joints.insert(post, shelf, joint, true).expect("it fits");
    let weight = RigidBodyBuilder::dynamic().translation(vec(1.5, 0.31)).can_sleep(false);
    let (weight, _) = world.insert(weight, cuboid(0.2, 0.2).density(5.0).friction(0.8));
    run(&mut world, 3.0);
    let torque = {
        let link = world.multibody_joints.get_link(handle).expect("a link");
        let limits = link.joint().data.limits(JointAxis::AngX).expect("limits");
        limits.impulse / world.integration_parameters.substep()
    };
    let at = world.bodies[weight].translation();
    assert!((at.y - 0.3).abs() < 0.02 && (at.x - 1.5).abs() < 0.01, "it lies on the shelf: {at}");
    let expected = G * (world.bodies[shelf].mass() * 1.0 + world.bodies[weight].mass() * 1.5);
    assert!((torque / expected - 1.0).abs() < 0.03, "{torque} instead of {expected}");
}

/// Islands have separate numbers of substeps: a chain with additional substeps falls and lies beside a chain
/// without.
#[test]
fn chains_with_different_substeps_coexist() {
    let mut world = world(60);
    add_ground(&mut world, 0.6);
    let usual = boxes(&mut world, 4, 0.5);
    let careful = boxes(&mut world, 4, 3.0);
    for &body in &careful.bodies {
        world.bodies[body].set_additional_solver_iterations(4);
        let at = world.bodies[body].translation() + vec(20.0, -2.5);
        world.bodies[body].set_translation(at, true);
    }
    run(&mut world, 3.0);
    for &body in usual.bodies.iter().chain(&careful.bodies) {
        let y = world.bodies[body].translation().y;
        assert!((y - 0.2).abs() < 5.0e-3, "it lies on the ground, not at {y}");
        assert!(world.bodies[body].is_sleeping());
    }
}
