//! The same bits: from run to run, on any number of threads, with any instructions, and next to strangers.
//!
//! The scene falls, collides, piles up and comes to rest, with bodies removed and put in on the way, so
//! that every list of the engine is reordered. What is compared is every bit of every pose and velocity.
//! Without the feature `parallel` all thread counts are one; the gate runs this with the feature too.

use crate::dim;
use rapier::prelude::*;

const STEPS: usize = 150;

/// All numbers of all bodies.
fn bits(world: &PhysicsWorld) -> Vec<u64> {
    let mut bits = Vec::new();
    let mut push = |value: Real| bits.push(f64::from(value).to_bits());
    for (_, body) in world.bodies.iter() {
        let (at, velocity) = (body.translation(), body.linvel());
        for k in 0..DIM {
            push(at[k]);
            push(velocity[k]);
        }
        push(dim::angle(body.rotation()));
        push(dim::z_of(body.angvel()));
    }
    bits
}

/// A floor and a heap of balls, boxes and capsules above it.
fn heap(world: &mut PhysicsWorld, center: Vector) {
    let floor = RigidBodyBuilder::fixed().translation(center - dim::vec(0.0, 1.0));
    world.insert(floor, dim::cuboid(30.0, 1.0));
    for k in 0..160_u8 {
        let (column, row) = (Real::from(k % 8), Real::from(k / 8));
        let at = center + dim::vec(column * 0.9 + row * 0.07 - 4.0, 1.0 + row * 1.1);
        let collider = match k % 3 {
            0 => ColliderBuilder::ball(0.4),
            1 => dim::cuboid(0.4, 0.3),
            _ => ColliderBuilder::capsule_y(0.3, 0.2),
        };
        let body = RigidBodyBuilder::dynamic().translation(at).rotation(dim::about_z(row));
        world.insert(body, collider.restitution(0.2));
    }
}

/// Runs the heap, with bodies going and coming.
fn run(mut world: PhysicsWorld) -> Vec<u64> {
    for step in 0..STEPS {
        if step % 25 == 24 {
            let oldest =
                world.bodies.iter().find(|(_, body)| body.is_dynamic()).map(|(handle, _)| handle);
            world.bodies.remove(oldest.expect("the heap is not that small"));
            let at = dim::vec(0.3, 14.0);
            world.insert(RigidBodyBuilder::dynamic().translation(at), ColliderBuilder::ball(0.5));
        }
        world.step();
    }
    bits(&world)
}

fn world() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    heap(&mut world, Vector::ZERO);
    world
}

#[test]
fn determinism_from_run_to_run() {
    assert_eq!(run(world()), run(world()));
}

#[test]
fn determinism_on_any_number_of_threads() {
    let expected = run(world());
    for threads in [1, 2, 3, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let found = pool.expect("a pool of threads").install(|| run(world()));
        assert_eq!(expected, found, "{threads} threads");
    }
}

#[test]
fn determinism_with_any_instructions() {
    let mut plain = world();
    plain.physics_pipeline.set_wide_instructions(false);
    assert_eq!(run(world()), run(plain));
}

#[test]
fn determinism_next_to_strangers() {
    let mut crowded = world();
    heap(&mut crowded, dim::vec(1000.0, 0.0));
    let (alone, among_others) = (run(world()), run(crowded));
    // The heap's own bodies come first: those of the second one have later slots. The last one put in
    // takes the slot of the last one removed in both worlds.
    assert_eq!(alone[..], among_others[..alone.len()]);
}
