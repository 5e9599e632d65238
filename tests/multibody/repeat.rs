//! Equal worlds and equal calls give equal bits.

use super::stage::chain;
use crate::dim::{components, cuboid, vec};
use crate::suite::physics::stage::{add_ground, drop_pile, run, world};
use rapier::prelude::*;

/// Runs ten chains that fall into a pile of bodies of all shapes.
fn scene(change: impl FnOnce(&mut PhysicsWorld)) -> Vec<u64> {
    let mut world = world(60);
    add_ground(&mut world, 0.5);
    drop_pile(&mut world, 0.0, 20);
    for _ in 0..10 {
        let chain = chain(&mut world, None, 5);
        for (k, &body) in chain.bodies.iter().enumerate() {
            let collider = cuboid(0.3, 0.15).density(0.0);
            world.insert_collider(collider, Some(body));
            let at = vec(k as Real - 2.0, 3.0 + world.bodies.len() as Real * 0.06);
            world.bodies[body].set_translation(at, true);
        }
    }
    change(&mut world);
    run(&mut world, 2.0);
    let numbers =
        |(_, body): (_, &RigidBody)| components(body.position()).map(|x| f64::from(x).to_bits());
    world.bodies.iter().flat_map(numbers).collect()
}

#[test]
fn twice_the_same() {
    assert!(scene(|_| ()) == scene(|_| ()));
}

#[test]
fn instructions_and_threads_change_nothing() {
    let usual = scene(|_| ());
    assert!(usual == scene(|world| world.physics_pipeline.set_wide_instructions(false)));
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        assert!(usual == pool.install(|| scene(|_| ())), "with {threads} threads");
    }
}
