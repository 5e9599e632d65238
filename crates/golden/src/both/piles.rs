//! Contacts: shapes of all kinds that fall onto each other.

use super::super::dim::{about, cuboid, enclose, shapes, vec};
use super::super::rapier::prelude::*;
use super::{Act, undisturbed};

/// A basin.
fn basin(world: &mut PhysicsWorld) {
    world.insert_collider(cuboid(6.0, 0.5, 6.0), None);
    for side in [-1.0, 1.0] {
        world.insert_collider(cuboid(0.3, 4.0, 6.0).translation(vec(6.0 * side, 4.0, 0.0)), None);
    }
    enclose(world, 6.0);
}

/// A heap of shapes of all kinds, with events of contacts and forces.
pub fn heap(world: &mut PhysicsWorld) -> Act {
    basin(world);
    let shapes = shapes();
    for k in 0..120_usize {
        let t = k as Real;
        let at = vec((k % 7) as Real * 0.9 - 2.7, 1.5 + t * 0.12, (k % 5) as Real * 0.8 - 1.6);
        let body = RigidBodyBuilder::dynamic()
            .translation(at)
            .rotation(about(0.3 * t, 0.7 * t, 0.5 * t))
            .angvel(about(0.1 * t, 0.0, 1.0));
        let surface =
            shapes[k % shapes.len()].clone().restitution(0.1 * (k % 4) as Real).friction(0.3);
        let events = ActiveEvents::COLLISION_EVENTS | ActiveEvents::CONTACT_FORCE_EVENTS;
        world.insert(body, surface.active_events(events).contact_force_event_threshold(20.0));
    }
    undisturbed()
}

/// A pyramid that a ball hits.
pub fn pyramid(world: &mut PhysicsWorld) -> Act {
    world.insert_collider(cuboid(20.0, 0.5, 20.0), None);
    for row in 0..10_u8 {
        for k in 0..10 - row {
            let at = vec(
                Real::from(k) * 1.05 + Real::from(row) * 0.525 - 5.0,
                1.0 + Real::from(row) * 1.01,
                0.0,
            );
            world.insert(RigidBodyBuilder::dynamic().translation(at), cuboid(0.5, 0.5, 0.5));
        }
    }
    let ball =
        RigidBodyBuilder::dynamic().translation(vec(-25.0, 4.0, 0.1)).linvel(vec(30.0, 2.0, 0.0));
    world.insert(ball, ColliderBuilder::ball(0.7).density(5.0));
    undisturbed()
}
