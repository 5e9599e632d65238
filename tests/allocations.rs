//! Steps without new contacts or bodies allocate no memory.

use crate::dim::{self, cuboid, hinge, vec};
use allocation_counter::measure;
use rapier::prelude::*;

/// Returns the number of allocations in 60 steps, after some seconds for the growth of buffers.
fn allocations(mut world: PhysicsWorld) -> u64 {
    (0..300).for_each(|_| world.step());
    let awake = world.active_bodies().len();
    assert!(awake > 0, "all sleep");
    allocations_of(&mut world)
}

/// Returns the number of allocations in 60 steps on one thread. A second thread would allocate a little in
/// each step.
fn allocations_of(world: &mut PhysicsWorld) -> u64 {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    pool.install(|| measure(|| (0..60).for_each(|_| world.step())).count_total)
}

fn world_with_floor() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.insert_collider(cuboid(60.0, 1.0).translation(vec(0.0, -1.0)), None);
    world
}

/// Returns a body that stays awake.
fn body(at: Vector) -> RigidBodyBuilder {
    RigidBodyBuilder::dynamic().translation(at).can_sleep(false)
}

/// Returns a pyramid of boxes.
fn pyramid(can_sleep: bool) -> PhysicsWorld {
    let mut world = world_with_floor();
    for row in 0..12_u8 {
        for column in 0..12 - row {
            let x = Real::from(column) - 0.5 * Real::from(11 - row);
            let cube = body(vec(x, 0.5 + Real::from(row))).can_sleep(can_sleep);
            world.insert(cube, cuboid(0.5, 0.5));
        }
    }
    world
}

#[test]
fn a_pile_allocates_nothing() {
    assert_eq!(allocations(pyramid(false)), 0);
}

/// Adds arms of five links that swing with a small amplitude: hinges, the first with a motor, the others with
/// limits.
fn arms(
    mut join: impl FnMut(&mut PhysicsWorld, [RigidBodyHandle; 2], GenericJoint),
) -> PhysicsWorld {
    let mut world = world_with_floor();
    for arm in 0..3_u8 {
        let at = |link: u8| vec(4.0 * Real::from(arm), 8.0 - 0.5 * Real::from(link));
        let mut last = world.insert_body(RigidBodyBuilder::fixed().translation(at(0)));
        for link in 1..=5 {
            let (next, _) = world.insert(body(at(link)), ColliderBuilder::ball(0.2));
            let hinge = hinge().local_anchor1(vec(0.0, -0.25)).local_anchor2(vec(0.0, 0.25));
            let hinge = match link {
                1 => hinge.motor_velocity(0.3, 1.0),
                _ => hinge.limits([-0.5, 0.5]),
            };
            join(&mut world, [last, next], hinge.build().into());
            last = next;
        }
    }
    world
}

#[test]
fn arms_of_joints_allocate_nothing() {
    let world = arms(|world, [first, second], joint| {
        world.impulse_joints.insert(first, second, joint, true);
    });
    assert_eq!(allocations(world), 0);
}

#[test]
fn multibodies_allocate_nothing() {
    let world = arms(|world, [first, second], joint| {
        world.multibody_joints.insert(first, second, joint, true).expect("the joint fits");
    });
    assert_eq!(allocations(world), 0);
}

/// Moving boxes leave their fat AABBs every few steps, so the tree is rebuilt several times per second.
#[test]
fn rebuilt_trees_allocate_nothing() {
    let mut world = PhysicsWorld::new();
    for k in 0..100_u8 {
        let [column, row] = [k % 10, k / 10].map(Real::from);
        let flier = RigidBodyBuilder::kinematic_velocity_based()
            .translation(vec(3.0 * column, 3.0 * row))
            .linvel(vec(column - 4.5, row - 4.5));
        world.insert(flier, cuboid(0.5, 0.5));
    }
    assert_eq!(allocations(world), 0);
}

/// Boxes and balls rest on a floor of many pieces.
#[test]
fn bodies_on_a_mesh_allocate_nothing() {
    let mut world = PhysicsWorld::new();
    dim::grounds::GROUNDS[1].1(&mut world, Pose::IDENTITY, 0.5);
    for k in 0..10_u8 {
        let collider = if k % 2 == 0 { cuboid(0.3, 0.2) } else { ColliderBuilder::ball(0.3) };
        world.insert(body(vec(0.5 + Real::from(k), 0.5)), collider.friction(1.0));
    }
    assert_eq!(allocations(world), 0);
}

/// All bodies of the world sleep.
#[test]
fn sleeping_bodies_allocate_nothing() {
    let mut world = pyramid(true);
    (0..600).for_each(|_| world.step());
    assert_eq!(world.active_bodies().len(), 0);
    assert_eq!(allocations_of(&mut world), 0);
}
