//! Bodies in one place.

use super::super::world::check;
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// 10 000 bodies, forty each in the same place: every number stays finite, and no body is disabled.
#[test]
fn ten_thousand_bodies_in_few_places() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    for k in 0..10_000_u16 {
        let (place, kind) = (k / 40, k % 2);
        let at = vec(3.0 * Real::from(place), 1.0);
        let collider = if kind == 0 { ColliderBuilder::ball(0.5) } else { cuboid(0.5, 0.5) };
        world.insert(RigidBodyBuilder::dynamic().translation(at), collider);
    }
    for _ in 0..3 {
        world.step();
        assert_eq!(world.physics_pipeline.counters.solver.nquarantined, 0);
    }
    check(&world);
}
