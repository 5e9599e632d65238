//! Construction of grounds from one piece or from many.

use rapier::prelude::*;

/// Adds a ground of one collider.
pub fn add(world: &mut PhysicsWorld, pose: Pose, friction: Real, ground: ColliderBuilder) {
    world.insert_collider(ground.position(pose).friction(friction), None);
}

/// Adds a body with a tile at each place.
pub fn on_a_body(
    world: &mut PhysicsWorld,
    pose: Pose,
    friction: Real,
    tile: &ColliderBuilder,
    places: impl Iterator<Item = Vector>,
) {
    let body = world.insert_body(RigidBodyBuilder::fixed().pose(pose));
    for place in places {
        world.insert_collider(tile.clone().translation(place).friction(friction), Some(body));
    }
}

/// Adds a tile at each place, on a separate body if `with_bodies`.
pub fn scatter(
    world: &mut PhysicsWorld,
    pose: Pose,
    tile: &ColliderBuilder,
    places: impl Iterator<Item = Vector>,
    with_bodies: bool,
) {
    for place in places {
        let pose = pose * Pose::from_translation(place);
        if with_bodies {
            world.insert(RigidBodyBuilder::fixed().pose(pose), tile.clone());
        } else {
            world.insert_collider(tile.clone().position(pose), None);
        }
    }
}
