//! Observers of inserted and removed components.
//!
//! An observer runs in the order of the user's commands, so the engine receives elements in the order in
//! which their entities were spawned. A query's order depends on all components of the entities.

use crate::body::RigidBody;
use crate::collider::{Collider, CollisionEvents, ContactForceEvents, HookedPairs, Sensor};
use crate::joint::Joint;
use crate::world::PhysicsWorld;
use bevy::app::App;
use bevy::ecs::component::Component;
use bevy::ecs::entity::Entity;
use bevy::ecs::entity_disabling::Disabled;
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::lifecycle::{Insert, Remove};
use bevy::ecs::observer::On;
use bevy::ecs::query::With;
use bevy::ecs::system::ResMut;
use bevy::ecs::world::World;

/// Adds the observers.
pub(crate) fn observe_lifecycle(app: &mut App) {
    app.add_observer(|on: On<Insert, RigidBody>, mut world: ResMut<PhysicsWorld>| {
        world.pending.bodies.push(on.entity);
    })
    .add_observer(|on: On<Insert, Collider>, mut world: ResMut<PhysicsWorld>| {
        world.pending.colliders.push(on.entity);
    })
    .add_observer(|on: On<Insert, Joint>, mut world: ResMut<PhysicsWorld>| {
        world.pending.joints.push(on.entity);
    })
    .add_observer(|on: On<Remove, RigidBody>, mut world: ResMut<PhysicsWorld>| {
        world.remove_body(on.entity);
    })
    .add_observer(|on: On<Remove, Collider>, mut world: ResMut<PhysicsWorld>| {
        world.remove_collider(on.entity);
    })
    .add_observer(|on: On<Remove, Joint>, mut world: ResMut<PhysicsWorld>| {
        world.remove_joint(on.entity);
    })
    .add_observer(|on: On<Remove, ChildOf>, mut world: ResMut<PhysicsWorld>| {
        if world.bodies.contains_key(&on.entity) {
            world.pending.detached.push(on.entity);
        }
    })
    .add_observer(|on: On<Insert, Disabled>, mut world: ResMut<PhysicsWorld>| {
        world.remove_joint(on.entity);
        world.remove_collider(on.entity);
        world.remove_body(on.entity);
    })
    .add_observer(|on: On<Remove, Disabled>, mut world: ResMut<PhysicsWorld>| {
        // A stage ignores entities without its component.
        world.pending.bodies.push(on.entity);
        world.pending.colliders.push(on.entity);
        world.pending.joints.push(on.entity);
    })
    // Change detection reports insertions, and no removals.
    .add_observer(describe_again::<ChildOf>)
    .add_observer(describe_again::<Sensor>)
    .add_observer(describe_again::<CollisionEvents>)
    .add_observer(describe_again::<ContactForceEvents>)
    .add_observer(describe_again::<HookedPairs>);
}

fn describe_again<C: Component>(on: On<Remove, C>, mut world: ResMut<PhysicsWorld>) {
    world.pending.colliders.push(on.entity);
}

/// Queues the elements of entities that were spawned before the plugin was added.
pub(crate) fn queue_existing_entities(app: &mut App) {
    let world = app.world_mut();
    let bodies = entities_with::<RigidBody>(world);
    let colliders = entities_with::<Collider>(world);
    let joints = entities_with::<Joint>(world);
    let pending = &mut world.resource_mut::<PhysicsWorld>().pending;
    pending.bodies.extend_sorted(bodies);
    pending.colliders.extend_sorted(colliders);
    pending.joints.extend_sorted(joints);
}

fn entities_with<C: Component>(world: &mut World) -> Vec<Entity> {
    world.query_filtered::<Entity, With<C>>().iter(world).collect()
}
