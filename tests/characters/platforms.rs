//! "My character sinks into lifts", "it slides off turntables", "it jumps on its way down".

use super::stage::{CAPSULE, DT, FOOT, GAP_TOLERANCE, OFFSET, Walker};
use crate::dim::{about_z, cuboid, vec};
use rapier::prelude::*;

/// Returns the largest deviation of the gap from the offset on a lift at this speed, with an optional
/// sinusoidal motion.
pub fn ride(amplitude: Real, frequency: Real, steady: Real, by_position: bool) -> Real {
    let mut world = PhysicsWorld::new();
    let lift = if by_position {
        RigidBodyBuilder::kinematic_position_based()
    } else {
        RigidBodyBuilder::kinematic_velocity_based()
    };
    let (lift, _) = world.insert(lift, cuboid(3.0, 0.5));
    let mut walker = Walker::new(world, vec(0.1, 0.6 + FOOT)).settled();
    walker.rides = true;
    let mut worst: Real = 0.0;
    for step in 0..240 {
        let time = step as Real * DT;
        let speed = steady + amplitude * (frequency * time).sin();
        let body = &mut walker.world.bodies[lift];
        if by_position {
            let next = body.translation() + vec(0.0, speed * DT);
            body.set_next_kinematic_translation(next);
        } else {
            body.set_linvel(vec(0.0, speed), true);
        }
        let movement = walker.step(Vector::ZERO);
        assert!(movement.grounded, "left the lift");
        let gap = walker.feet() - walker.world.bodies[lift].translation().y - 0.5;
        worst = worst.max((gap - OFFSET).abs());
    }
    worst
}

#[test]
fn characters_on_a_lift_keep_the_offset() {
    for by_position in [true, false] {
        for (amplitude, frequency, steady) in [(0.0, 0.0, 3.0), (0.0, 0.0, -3.0), (4.0, 5.0, 0.0)] {
            let worst = ride(amplitude, frequency, steady, by_position);
            assert!(worst < GAP_TOLERANCE, "{worst} at {amplitude} sin {frequency} t + {steady}");
        }
    }
}

/// Without riding, a rising lift still carries the character. It penetrates the offset by at most one step of
/// the lift's motion.
#[test]
fn lifts_carry_characters_that_do_not_ride() {
    let mut world = PhysicsWorld::new();
    let lift = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(0.0, 2.0));
    let (lift, _) = world.insert(lift, cuboid(3.0, 0.5));
    let mut walker = Walker::new(world, vec(0.1, 0.6 + FOOT));
    for step in 0..120 {
        let movement = walker.step(Vector::ZERO);
        let gap = walker.feet() - walker.world.bodies[lift].translation().y - 0.5;
        assert!(gap > OFFSET - 2.0 * DT - GAP_TOLERANCE, "{gap}");
        assert!(step < 20 || (movement.grounded && gap < OFFSET + GAP_TOLERANCE), "{gap}");
    }
}

/// A platform's sideways motion adds to the motion of a walking character. A standing character keeps its
/// place on it.
#[test]
fn platforms_carry_sideways() {
    let mut world = PhysicsWorld::new();
    let raft = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(2.0, 0.0));
    let (raft, _) = world.insert(raft, cuboid(5.0, 0.5));
    let mut walker = Walker::new(world, vec(0.0, 0.6 + FOOT));
    walker.rides = true;
    walker.steps(30, Vector::ZERO);
    let on_raft = |walker: &Walker| walker.place().x - walker.world.bodies[raft].translation().x;
    let before = on_raft(&walker);
    walker.steps(120, Vector::ZERO);
    assert!((on_raft(&walker) - before).abs() < 1.0e-3);
    walker.steps(60, vec(1.0, 0.0));
    assert!((on_raft(&walker) - before - 1.0).abs() < 1.0e-3);
}

/// Returns the largest drift of the point below the feet, and the largest deviation of the gap. The platform
/// tilts, and in 3D rotates, for four seconds.
pub fn rocking() -> (Real, Real) {
    let mut world = PhysicsWorld::new();
    let (raft, _) = world.insert(RigidBodyBuilder::kinematic_velocity_based(), cuboid(5.0, 0.5));
    let mut walker = Walker::new(world, vec(2.0, 0.6 + FOOT)).settled();
    walker.rides = true;
    let (mut off, mut worst): (Real, Real) = (0.0, 0.0);
    for step in 0..240 {
        let rate = 0.3 * (2.0 * step as Real * DT).cos();
        walker.world.bodies[raft].set_angvel(about_z(rate), true);
        let movement = walker.step(Vector::ZERO);
        assert!(movement.grounded, "left the raft");
        let pose = *walker.world.bodies[raft].position();
        let ball = pose.inverse() * (walker.place() - vec(0.0, CAPSULE.0));
        worst = worst.max((ball.y - 0.5 - CAPSULE.1 - OFFSET).abs());
        off = off.max((ball.x - 2.0).abs());
    }
    (off, worst)
}

#[test]
fn characters_do_not_sink_into_rocking_platforms() {
    let (off, worst) = rocking();
    // The platform rotates by at most 0.3/2 rad. For an upright character on a tilted floor, the lowest
    // contact of the ball moves by r·sin.
    assert!(off < 0.2, "wandered {off}");
    assert!(worst < 2.0e-3, "the gap was off by {worst}");
}

/// The velocity of the ground is that of the point below, including rotation. A jump with it keeps the
/// momentum.
#[test]
fn the_ground_velocity_includes_rotation() {
    let mut world = PhysicsWorld::new();
    let raft = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(1.5, 0.5));
    let (raft, raft_collider) = world.insert(raft, cuboid(5.0, 0.5));
    let mut walker = Walker::new(world, vec(2.0, 0.5 + FOOT + OFFSET));
    walker.world.bodies[raft].set_angvel(about_z(0.2), true);
    let movement = walker.compute(vec(0.0, -0.01));
    let ground = movement.ground.expect("it stands on the raft");
    assert_eq!(ground.collider, raft_collider);
    let (bodies, colliders) = (&walker.world.bodies, &walker.world.colliders);
    let velocity = ground.velocity(bodies, colliders);
    let expected = bodies[raft].velocity_at_point(ground.point);
    assert!((velocity - expected).length() < 1.0e-5 && velocity.y > 0.8, "{velocity}");
    assert!((ground.displacement(bodies, colliders, DT) / DT - velocity).length() < 0.01);
    assert_eq!(ground.displacement(bodies, colliders, Real::NAN), Vector::ZERO);
    // The removal of the body removes its collider.
    walker.world.remove_body(raft);
    walker.world.step();
    assert_eq!(ground.velocity(&walker.world.bodies, &walker.world.colliders), Vector::ZERO);
}
