//! Impacts on jointed bodies, and misuse of joints.

use super::stage::{bob, post};
use crate::dim::{hinge, vec};
use crate::suite::physics::stage::{run, weightless, world};
use rapier::prelude::*;

/// Adds a ball of 1 kg with the restitution `e`, at this position and velocity.
fn throw(world: &mut PhysicsWorld, at: Vector, velocity: Vector, e: Real) -> RigidBodyHandle {
    let shape = ColliderBuilder::ball(0.25).mass(1.0).friction(0.0).restitution(e);
    let shape = shape.restitution_combine_rule(CoefficientCombineRule::Max);
    let body = RigidBodyBuilder::dynamic().translation(at).linvel(velocity).can_sleep(false);
    world.insert(body, shape).0
}

/// Returns the kinetic energy of all bodies (J).
fn energy(world: &PhysicsWorld) -> Real {
    world.bodies.iter().map(|(_, body)| body.kinetic_energy()).sum()
}

/// A plate of 2 kg that is welded to the world is hit at 30 m/s. It reflects the ball with `e`, and the weld
/// carries `(1 + e) m v` in the step of the impact.
#[test]
fn joints_withstand_impacts() {
    for e in [0.0, 0.5, 1.0] {
        for limit in [Real::INFINITY, 1000.0] {
            let mut world = weightless(60);
            let post = post(&mut world, Vector::ZERO);
            let plate = crate::dim::cuboid(0.25, 0.5).mass(2.0).friction(0.0);
            let (plate, _) = world.insert(RigidBodyBuilder::dynamic(), plate);
            let weld = FixedJointBuilder::new().break_thresholds(limit, Real::INFINITY);
            let weld = world.insert_impulse_joint(post, plate, weld);
            let ball = throw(&mut world, vec(-2.0, 0.0), vec(30.0, 0.0), e);
            let mut most: Real = 0.0;
            for _ in 0..20 {
                world.step();
                most = most.max(world.impulse_joints[weld].force().length());
            }
            let thrown = -world.bodies[ball].linvel().x;
            let formula = (1.0 + e) * 30.0 * 60.0;
            // Without restitution the solver stops the ball softly: the weld yields, and reflects the ball
            // slightly.
            let tolerance = if e == 0.0 { 0.1 } else { 0.001 };
            assert!((most / formula - 1.0).abs() < tolerance, "{most}, not {formula}");
            assert!((thrown - e * 30.0).abs() < tolerance * 30.0, "{thrown}, e = {e}");
            assert_eq!(world.impulse_joints[weld].data.is_enabled(), limit > formula);
        }
    }
}

/// A door at its limit is hit towards the limit, or away from it.
#[test]
fn doors_at_their_limits_are_hit() {
    for e in [0.0, 0.5, 1.0] {
        for side in [-1.0, 1.0] {
            let mut world = weightless(60);
            let post = post(&mut world, Vector::ZERO);
            let shape = crate::dim::cuboid(1.0, 0.1).mass(1.0).restitution(e).friction(0.0);
            let body = RigidBodyBuilder::dynamic().translation(vec(1.0, 0.0)).can_sleep(false);
            let (door, _) = world.insert(body, shape);
            let joint = hinge().local_anchor2(vec(-1.0, 0.0)).limits([0.0, 1.0]);
            world.insert_impulse_joint(post, door, joint);
            throw(&mut world, vec(1.5, side), vec(0.0, -side * 10.0), e);
            let first = energy(&world);
            let (mut most, mut least, mut gap): (Real, Real, Real) = (0.0, 0.0, 0.0);
            for _ in 0..30 {
                world.step();
                most = most.max(energy(&world) / first);
                least = least.min(crate::dim::turned_about_z(world.bodies[door].rotation()));
                let pose = world.bodies[door].position();
                gap = gap.max((*pose * vec(-1.0, 0.0)).length());
            }
            assert!(most < 1.001, "energy {most}");
            assert!(least > -0.02, "angle {least}");
            assert!(gap < 0.01, "gap {gap}");
        }
    }
}

/// Chains with links in contact are hit: iterated joints, limits and motors combine with elastic contacts.
#[test]
fn chains_in_contact_that_are_hit_do_not_gain_energy() {
    for e in [0.0, 0.5, 1.0] {
        for speed in [1.0, 10.0, 100.0] {
            for held in [false, true] {
                let mut world = weightless(60);
                let mut last = post(&mut world, vec(-0.5, 0.0));
                for k in 0..8 {
                    let shape =
                        crate::dim::cuboid(0.45, 0.2).mass(1.0).restitution(e).friction(0.5);
                    let body = RigidBodyBuilder::dynamic().translation(vec(k as Real, 0.0));
                    let (next, _) = world.insert(body.can_sleep(false), shape);
                    let mut joint =
                        hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
                    if k == 0 {
                        joint = joint.local_anchor1(Vector::ZERO);
                    }
                    if k % 2 == 1 {
                        joint = joint.limits([-0.3, 0.3]);
                    }
                    if k > 0 || held {
                        world.insert_impulse_joint(last, next, joint);
                    }
                    last = next;
                }
                throw(&mut world, vec(4.5, 2.0), vec(0.0, -speed), e);
                let (first, mut most): (Real, Real) = (energy(&world), 0.0);
                for _ in 0..180 {
                    world.step();
                    most = most.max(energy(&world) / first);
                }
                assert!(most < 1.005, "energy {most}: e {e}, {speed} m/s, held {held}");
            }
        }
    }
}

/// Bodies that overlap at the insertion of the joint reach the joint's anchors, with and without contacts
/// between them.
#[test]
fn joints_between_bodies_that_overlap() {
    for contacts in [false, true] {
        for e in [0.0, 1.0] {
            let mut world = weightless(60);
            let bodies = [0.0, 0.1].map(|x| throw(&mut world, vec(x, 0.0), Vector::ZERO, e));
            let joint = hinge().local_anchor1(vec(0.25, 0.0)).local_anchor2(vec(-0.25, 0.0));
            world.insert_impulse_joint(bodies[0], bodies[1], joint.contacts_enabled(contacts));
            let mut fastest: Real = 0.0;
            for _ in 0..120 {
                world.step();
                fastest = bodies
                    .iter()
                    .map(|&b| world.bodies[b].linvel().length())
                    .fold(fastest, Real::max);
            }
            let [a, b] = bodies.map(|b| *world.bodies[b].position());
            let gap = (a * vec(0.25, 0.0) - b * vec(-0.25, 0.0)).length();
            assert!(gap < 1.0e-3, "{gap}");
            assert!(fastest < 30.0);
        }
    }
}

/// Twenty joints of one pair act like one joint.
#[test]
fn pairs_that_are_joined_twenty_times() {
    for count in [1, 20] {
        let mut world = world(60);
        let post = post(&mut world, Vector::ZERO);
        let load = world.insert_body(bob(1.0, 0.2).translation(vec(1.0, 0.0)));
        let joints: Vec<_> = (0..count)
            .map(|_| {
                world.insert_impulse_joint(
                    post,
                    load,
                    FixedJointBuilder::new().local_anchor2(vec(-1.0, 0.0)),
                )
            })
            .collect();
        run(&mut world, 2.0);
        let off = (world.bodies[load].translation() - vec(1.0, 0.0)).length();
        let force: Vector = joints.iter().map(|&j| world.impulse_joints[j].force()).sum();
        assert!(off < 1.0e-3 && (force - vec(0.0, 9.81)).length() < 0.1);
        for &joint in &joints[1..] {
            world.impulse_joints.remove(joint, true);
        }
        run(&mut world, 0.5);
        assert!((world.bodies[load].translation() - vec(1.0, 0.0)).length() < 1.0e-3);
    }
}

/// Moment arms from a micrometre to a thousand kilometres keep the joint closed and the world finite.
#[test]
fn anchors_near_and_far() {
    for moment_arm in [1.0e-6, 1.0e-3, 1.0, 1.0e3, 1.0e6] {
        let mut world = world(60);
        let post = post(&mut world, vec(0.0, 0.0));
        let load = world.insert_body(bob(1.0, 0.2).translation(vec(moment_arm, 0.0)));
        world.insert_impulse_joint(post, load, hinge().local_anchor2(vec(-moment_arm, 0.0)));
        run(&mut world, 2.0);
        let pose = world.bodies[load].position();
        let gap = (*pose * vec(-moment_arm, 0.0)).length();
        // The errors are the rounding of positions, and that of a rotation times the moment arm.
        assert!(gap < 1.0e-3 + 16.0 * Real::EPSILON * moment_arm, "{gap} with {moment_arm}");
    }
}

/// Bodies with broken joints can be removed at once.
#[test]
fn bodies_are_removed_after_a_break() {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let mut last = post;
    let links: Vec<_> = (0..5)
        .map(|k| {
            let body =
                world.insert_body(bob(1.0, 0.1).translation(vec(0.0, -0.5 * (k + 1) as Real)));
            let joint =
                hinge().local_anchor2(vec(0.0, 0.5)).break_thresholds(3.5 * 9.81, Real::INFINITY);
            let joint = world.insert_impulse_joint(last, body, joint);
            last = body;
            (body, joint)
        })
        .collect();
    let mut removed = Vec::new();
    for _ in 0..60 {
        world.step();
        for &(body, joint) in &links {
            if world.impulse_joints.get(joint).is_some_and(|joint| !joint.data.is_enabled()) {
                world.remove_body(body);
                removed.push(joint);
            }
        }
    }
    assert!(!removed.is_empty());
    assert!(removed.iter().all(|&joint| !world.impulse_joints.contains(joint)));
    assert!(world.bodies.iter().all(|(_, body)| body.translation().is_finite()));
}

/// Joints that are edited in every step follow the last edit.
#[test]
fn joints_edited_in_every_step() {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let load = world.insert_body(bob(1.0, 0.2).translation(vec(1.0, 0.0)).can_sleep(true));
    let joint = world.insert_impulse_joint(post, load, hinge().local_anchor2(vec(-1.0, 0.0)));
    for k in 0..120 {
        let data = &mut world.impulse_joints[joint].data;
        let refused = data.try_set_limits(JointAxis::AngX, [0.5, -0.5]);
        assert!(matches!(refused, Err(InvalidJoint::Limits { .. })));
        data.set_enabled(k % 2 == 0);
        world.step();
        assert!(!world.bodies[load].is_sleeping());
    }
    world.impulse_joints[joint].data.set_enabled(true);
    run(&mut world, 1.0);
    let gap = (*world.bodies[load].position() * vec(-1.0, 0.0)).length();
    assert!(gap < 1.0e-3, "{gap}");
}

/// The handle of a removed joint finds nothing, although its slot is reused.
#[test]
fn handles_of_joints_are_not_recycled() {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let load = world.insert_body(bob(1.0, 0.2));
    let mut old = Vec::new();
    for _ in 0..100 {
        let joint = world.insert_impulse_joint(post, load, hinge());
        assert!(old.iter().all(|&gone| !world.impulse_joints.contains(gone) && gone != joint));
        world.step();
        assert!(world.impulse_joints.remove(joint, true).is_some());
        assert!(world.impulse_joints.remove(joint, true).is_none());
        old.push(joint);
    }
    assert_eq!(world.impulse_joints.len(), 0);
}

/// A joint that is enabled, disabled, edited or removed wakes its bodies; reading does not.
#[test]
fn joints_wake_their_bodies() {
    let rest = || {
        let mut world = world(60);
        let post = post(&mut world, Vector::ZERO);
        let load = bob(1.0, 0.2).translation(vec(0.0, -1.0)).can_sleep(true);
        let load = world.insert_body(load);
        let joint = world.insert_impulse_joint(post, load, hinge().local_anchor2(vec(0.0, 1.0)));
        run(&mut world, 5.0);
        assert!(world.bodies[load].is_sleeping());
        (world, load, joint)
    };
    let (mut world, load, joint) = rest();
    assert!(world.impulse_joints[joint].data.is_enabled());
    world.step();
    assert!(world.bodies[load].is_sleeping());
    let (mut world, load, joint) = rest();
    world.impulse_joints[joint].data.set_enabled(false);
    run(&mut world, 0.1);
    assert!(!world.bodies[load].is_sleeping() && world.bodies[load].linvel().y < -0.5);
    let (mut world, load, joint) = rest();
    world.impulse_joints.remove(joint, true);
    run(&mut world, 0.1);
    assert!(!world.bodies[load].is_sleeping() && world.bodies[load].linvel().y < -0.5);
}

/// A plate on a spring, or on a soft weld, is hit: the impact ends before the joint yields.
#[test]
fn springs_yield_after_the_impact() {
    for e in [0.5, 1.0] {
        for soft in [0, 1, 2] {
            let mut world = weightless(240);
            let post = post(&mut world, Vector::ZERO);
            let plate = crate::dim::cuboid(0.25, 0.5).mass(1.0).friction(0.0);
            let (plate, _) = world.insert(RigidBodyBuilder::dynamic(), plate);
            let softness = SpringCoefficients::new(2.0, 0.0);
            let joint: GenericJoint = match soft {
                0 => FixedJointBuilder::new().softness(Some(softness)).build().into(),
                1 => SpringJointBuilder::new(Vector::ZERO, Vector::ZERO, 0.0, 100.0).build().into(),
                _ => hinge().softness(Some(softness)).build().into(),
            };
            world.insert_impulse_joint(post, plate, joint);
            let ball = throw(&mut world, vec(-0.55, 0.0), vec(10.0, 0.0), e);
            for _ in 0..3 {
                world.step();
            }
            let [v, u] = [ball, plate].map(|body| world.bodies[body].linvel().x);
            let formula = [5.0 * (1.0 - e), 5.0 * (1.0 + e)];
            assert!((v - formula[0]).abs() < 0.1 && (u - formula[1]).abs() < 0.2, "{v} {u}");
        }
    }
}
