//! Locked axes: a dynamic body has no velocity along and about them, wherever a velocity comes from.

use crate::dim::{about_z, angle, cuboid, tumble, vec, z_of};
use rapier::prelude::*;

/// Velocity that each way gives to the body, along x, along y, and about the axis out of the plane.
const SPEED: Real = 3.0;

/// A source of a velocity, with its name. It gets the builder of the body, with its locks, and inserts the
/// body.
type Way = (&'static str, fn(&mut PhysicsWorld, RigidBodyBuilder, LockedAxes) -> RigidBodyHandle);

/// A collider whose centre of mass is beside the body's origin.
fn weight() -> ColliderBuilder {
    cuboid(0.5, 0.25).translation(vec(0.5, 0.5))
}

fn moving(body: RigidBodyBuilder) -> RigidBodyBuilder {
    body.linvel(vec(SPEED, SPEED)).angvel(tumble(SPEED, SPEED))
}

const WAYS: [Way; 9] = [
    ("builder", |world, body, locks| world.insert(moving(body).locked_axes(locks), weight()).0),
    ("set_linvel, set_angvel", |world, body, locks| {
        let (body, _) = world.insert(body.locked_axes(locks), weight());
        world.step();
        world.bodies[body].set_linvel(vec(SPEED, SPEED), true);
        world.bodies[body].set_angvel(tumble(SPEED, SPEED), true);
        body
    }),
    ("set_vels", |world, body, locks| {
        let (body, _) = world.insert(body.locked_axes(locks), weight());
        let vels = RigidBodyVelocity::new(vec(SPEED, SPEED), tumble(SPEED, SPEED));
        world.bodies[body].set_vels(vels, true);
        body
    }),
    ("impulses", |world, body, locks| {
        let (body, _) = world.insert(body.locked_axes(locks), weight());
        world.step();
        let body_mut = &mut world.bodies[body];
        body_mut.apply_impulse(vec(SPEED, SPEED) * body_mut.mass(), true);
        body_mut.apply_torque_impulse(tumble(SPEED, SPEED), true);
        body
    }),
    ("set_locked_axes while it moves", |world, body, locks| {
        let (body, _) = world.insert(moving(body), weight());
        world.step();
        world.bodies[body].set_locked_axes(locks, true);
        body
    }),
    ("a change of the type", |world, body, locks| {
        let (body, _) = world.insert(moving(body).locked_axes(locks), weight());
        world.bodies[body].set_body_type(RigidBodyType::KinematicVelocityBased, true);
        world.bodies[body].set_linvel(vec(SPEED, SPEED), true);
        world.bodies[body].set_angvel(tumble(SPEED, SPEED), true);
        world.step();
        world.bodies[body].set_body_type(RigidBodyType::Dynamic, true);
        body
    }),
    ("copy_from", |world, body, locks| {
        let (body, _) = world.insert(body, weight());
        world.step();
        let source = moving(RigidBodyBuilder::dynamic()).locked_axes(locks).build();
        world.bodies[body].copy_from(&source);
        body
    }),
    ("a new mass", |world, body, locks| {
        let (body, _) = world.insert(moving(body).locked_axes(locks), weight());
        world.step();
        world.insert_collider(weight().translation(vec(-3.0, 2.0)), Some(body));
        body
    }),
    ("a collision", |world, body, locks| {
        let (body, _) = world.insert(moving(body).locked_axes(locks), weight());
        let ball = RigidBodyBuilder::dynamic().translation(vec(-3.0, 0.2)).linvel(vec(30.0, 0.0));
        world.insert(ball, ColliderBuilder::ball(0.5).density(10.0));
        body
    }),
];

const LOCKS: [LockedAxes; 6] = [
    LockedAxes::TRANSLATION_LOCKED_X,
    LockedAxes::TRANSLATION_LOCKED_Y,
    LockedAxes::TRANSLATION_LOCKED,
    LockedAxes::ROTATION_LOCKED_Z,
    LockedAxes::ROTATION_LOCKED,
    LockedAxes::TRANSLATION_LOCKED.union(LockedAxes::ROTATION_LOCKED),
];

/// No velocity along a locked axis survives, whatever its source: the centre of mass keeps its coordinate,
/// and the body its angle, to the rounding of half a second.
#[test]
fn dynamic_bodies_have_no_velocity_along_locked_axes() {
    println!("| velocity by | locked | speed along them | motion along them |\n|---|---|--:|--:|");
    let mut failures = Vec::new();
    for (name, way) in WAYS {
        for locks in LOCKS {
            let mut world = PhysicsWorld::new();
            let body = way(&mut world, RigidBodyBuilder::dynamic(), locks);
            let (place, turn) = place(&world, body);
            let mut speed: Real = 0.0;
            for _ in 0..30 {
                speed = speed.max(along(
                    locks,
                    world.bodies[body].linvel(),
                    z_of(world.bodies[body].angvel()),
                ));
                world.step();
            }
            let (end, end_turn) = self::place(&world, body);
            // Rotations about two axes in turn add up to one about the third.
            let is_upright = locks.contains(LockedAxes::ROTATION_LOCKED);
            let turned = if is_upright { end_turn - turn } else { 0.0 };
            let motion = along(locks, end - place, turned);
            println!("| {name} | {locks:?} | {speed} | {motion:.1e} |");
            if speed > 0.0 || motion > 1.0e-5 {
                failures.push((name, locks, speed, motion));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

/// Returns the centre of mass and the angle of a body.
fn place(world: &PhysicsWorld, body: RigidBodyHandle) -> (Vector, Real) {
    let body = &world.bodies[body];
    (body.center_of_mass(), angle(body.rotation()))
}

/// Returns the largest component along the locked axes.
fn along(locks: LockedAxes, linear: Vector, angular: Real) -> Real {
    [
        (LockedAxes::TRANSLATION_LOCKED_X, linear.x),
        (LockedAxes::TRANSLATION_LOCKED_Y, linear.y),
        (LockedAxes::ROTATION_LOCKED_Z, angular),
    ]
    .into_iter()
    .filter(|(axis, _)| locks.contains(*axis))
    .map(|(_, component)| component.abs())
    .fold(0.0, Real::max)
}

/// A lock takes nothing from the other axes.
#[test]
fn free_axes_keep_their_velocity() {
    let locks = LockedAxes::TRANSLATION_LOCKED_X;
    let body = moving(RigidBodyBuilder::dynamic()).locked_axes(locks).build();
    assert_eq!((body.linvel(), z_of(body.angvel())), (vec(0.0, SPEED), SPEED));
    let mut body = moving(RigidBodyBuilder::dynamic()).build();
    body.lock_rotations(true, true);
    assert_eq!((body.linvel(), body.angvel()), (vec(SPEED, SPEED), about_z(0.0)));
    body.lock_rotations(false, true);
    body.set_angvel(about_z(1.0), true);
    assert_eq!(body.angvel(), about_z(1.0), "an unlocked axis is free again");
}

/// The user alone moves kinematic bodies: locks are for forces and for dynamic bodies.
#[test]
fn kinematic_bodies_ignore_locks() {
    let locks = LockedAxes::TRANSLATION_LOCKED | LockedAxes::ROTATION_LOCKED;
    let mut world = PhysicsWorld::new();
    let body = moving(RigidBodyBuilder::kinematic_velocity_based()).locked_axes(locks);
    let (body, _) = world.insert(body, cuboid(0.5, 0.5));
    (0..30).for_each(|_| world.step());
    let at = world.bodies[body].translation();
    assert!((at - vec(1.5, 1.5)).length() < 1.0e-4, "it came to {at}");
}
