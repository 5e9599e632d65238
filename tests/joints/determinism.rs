//! Bitwise determinism with joints: on any number of threads, with any instructions, and beside unrelated
//! bodies.

use crate::dim::{about_z, cuboid, hinge, vec};
use rapier::prelude::*;

/// Adds a tree of joints with a net and a motor in it, above a floor.
fn contraption(world: &mut PhysicsWorld, at: Vector) {
    let floor = RigidBodyBuilder::fixed().translation(at - vec(0.0, 3.0));
    world.insert(floor, cuboid(20.0, 1.0));
    let top = world.insert_body(RigidBodyBuilder::fixed().translation(at + vec(0.0, 4.0)));
    let mut last = top;
    for k in 0..30_u8 {
        let place = at + vec(Real::from(k % 6) * 0.8, 3.0 - Real::from(k / 6) * 0.8);
        let body = RigidBodyBuilder::dynamic().translation(place).rotation(about_z(0.1));
        let (body, _) =
            world.insert(body, cuboid(0.2, 0.1).density(1.0 + Real::from(k % 4) * 20.0));
        match k % 5 {
            0 => world.insert_impulse_joint(last, body, RopeJointBuilder::new(1.0)),
            1 => world.insert_impulse_joint(
                last,
                body,
                hinge().local_anchor1(vec(0.4, 0.0)).motor_velocity(3.0, 1.0),
            ),
            2 => world.insert_impulse_joint(
                last,
                body,
                SpringJoint::new(Vector::ZERO, Vector::ZERO, 0.8, 60.0),
            ),
            3 => world.insert_impulse_joint(
                last,
                body,
                hinge().local_anchor2(vec(-0.4, 0.0)).limits([-0.3, 0.6]),
            ),
            _ => world.insert_impulse_joint(top, body, RopeJointBuilder::new(5.0)),
        };
        last = body;
    }
    loose(world, at + vec(8.0, 0.0));
}

/// Adds a free structure with too many joints for the direct solver.
fn loose(world: &mut PhysicsWorld, at: Vector) {
    let mut last = None;
    for k in 0..12_u8 {
        let place = at + vec(0.5 * Real::from(k), 0.1 * Real::from(k % 3));
        let (body, _) =
            world.insert(RigidBodyBuilder::dynamic().translation(place), cuboid(0.2, 0.1));
        if let Some(last) = last {
            let pin = GenericJointBuilder::new(JointAxesMask::LIN_AXES);
            let pin = pin.local_anchor1(vec(0.25, 0.0)).local_anchor2(vec(-0.25, 0.0));
            let hinge = hinge().local_anchor1(vec(0.25, 0.0)).local_anchor2(vec(-0.25, 0.0));
            let limited = hinge.limits([-0.4, 0.4]);
            let joint: GenericJoint = if k % 3 == 0 { limited.into() } else { pin.build() };
            world.insert_impulse_joint(last, body, joint);
        }
        last = Some(body);
    }
}

fn world() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    contraption(&mut world, Vector::ZERO);
    world
}

/// Runs a world with insertions and removals of joints, and returns all numbers of the first contraption.
fn run(mut world: PhysicsWorld) -> Vec<u64> {
    for step in 0..120 {
        if step % 30 == 29 {
            let oldest = world.impulse_joints().next().map(|(handle, _)| handle);
            world.remove_impulse_joint(oldest.unwrap());
        }
        world.step();
    }
    let mut bits = Vec::new();
    for (_, body) in world.bodies.iter().take(44) {
        let (at, velocity) = (body.translation(), body.linvel());
        bits.extend((0..DIM).map(|k| f64::from(at[k]).to_bits()));
        bits.extend((0..DIM).map(|k| f64::from(velocity[k]).to_bits()));
    }
    bits
}

#[test]
fn determinism_of_joints_from_run_to_run() {
    assert_eq!(run(world()), run(world()));
}

#[test]
fn determinism_of_joints_on_any_number_of_threads() {
    let expected = run(world());
    for threads in [1, 2, 3, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let found = pool.expect("a pool of threads").install(|| run(world()));
        assert_eq!(expected, found, "{threads} threads");
    }
}

#[test]
fn determinism_of_joints_with_any_instructions() {
    let mut plain = world();
    plain.physics_pipeline.set_wide_instructions(false);
    assert_eq!(run(world()), run(plain));
}

#[test]
fn determinism_of_joints_next_to_strangers() {
    let mut crowded = world();
    contraption(&mut crowded, vec(500.0, 0.0));
    assert_eq!(run(world()), run(crowded));
}
