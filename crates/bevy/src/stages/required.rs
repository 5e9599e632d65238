//! Required components that the user removes: the default takes their place, as long as the entity needs one.

use crate::body::{
    Damping, ExternalForce, ExternalImpulse, GravityScale, LockedAxes, RigidBody, Sleeping,
    Velocity,
};
use crate::collider::{Collider, ColliderMass, CollisionGroups, Friction, Restitution};
use crate::world::PhysicsWorld;
use bevy::app::App;
use bevy::ecs::component::Component;
use bevy::ecs::lifecycle::Remove;
use bevy::ecs::observer::On;
use bevy::ecs::system::{Commands, Res};
use bevy::ecs::world::EntityWorldMut;

/// Adds the observers.
pub(crate) fn observe_required(app: &mut App) {
    app.add_observer(reset::<RigidBody, Velocity>)
        .add_observer(reset::<RigidBody, GravityScale>)
        .add_observer(reset::<RigidBody, Damping>)
        .add_observer(reset::<RigidBody, LockedAxes>)
        .add_observer(reset::<RigidBody, ExternalForce>)
        .add_observer(reset::<RigidBody, ExternalImpulse>)
        .add_observer(reset_sleeping)
        .add_observer(reset::<Collider, Friction>)
        .add_observer(reset::<Collider, Restitution>)
        .add_observer(reset::<Collider, ColliderMass>)
        .add_observer(reset::<Collider, CollisionGroups>);
}

/// Inserts the default of a removed component, if its entity still exists and has the owner.
fn reset<Owner: Component, C: Component + Default>(on: On<Remove, C>, mut commands: Commands) {
    commands.entity(on.entity).queue_silenced(|mut entity: EntityWorldMut| {
        if entity.contains::<Owner>() && !entity.contains::<C>() {
            entity.insert(C::default());
        }
    });
}

/// The sleep state has no default: it is the engine's.
fn reset_sleeping(on: On<Remove, Sleeping>, world: Res<PhysicsWorld>, mut commands: Commands) {
    let is_sleeping = world.body(on.entity).is_some_and(|body| body.is_sleeping());
    commands.entity(on.entity).queue_silenced(move |mut entity: EntityWorldMut| {
        if entity.contains::<RigidBody>() && !entity.contains::<Sleeping>() {
            entity.insert(Sleeping::new(is_sleeping));
        }
    });
}
