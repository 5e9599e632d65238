//! Required components that the user removes: observers insert their defaults while the entity needs them.

use crate::body::{
    Damping, ExternalForce, ExternalImpulse, GravityScale, LockedAxes, RigidBody, Sleeping,
    Velocity,
};
use crate::collider::{Collider, ColliderMass, CollisionGroups, Friction, Restitution};
use crate::world::PhysicsWorld;
use bevy::app::App;
use bevy::ecs::bundle::Bundle;
use bevy::ecs::component::Component;
use bevy::ecs::lifecycle::Remove;
use bevy::ecs::observer::On;
use bevy::ecs::system::{Commands, Res};
use bevy::ecs::world::EntityWorldMut;

/// Adds the observers.
pub(crate) fn observe_required(app: &mut App) {
    type OfBody = (Velocity, GravityScale, Damping, LockedAxes, ExternalForce, ExternalImpulse);
    type OfCollider = (Friction, Restitution, ColliderMass, CollisionGroups);
    app.add_observer(reset::<RigidBody, OfBody>)
        .add_observer(reset::<Collider, OfCollider>)
        .add_observer(reset_sleeping);
}

/// Inserts the defaults of removed components, if their entity still exists and has the owner.
fn reset<Owner: Component, Required: Bundle + Default>(
    on: On<Remove, Required>,
    mut commands: Commands,
) {
    commands.entity(on.entity).queue_silenced(|mut entity: EntityWorldMut| {
        if entity.contains::<Owner>() {
            entity.insert_if_new(Required::default());
        }
    });
}

/// The sleep state has no default: it is the engine's.
fn reset_sleeping(on: On<Remove, Sleeping>, world: Res<PhysicsWorld>, mut commands: Commands) {
    let is_sleeping = world.body(on.entity).is_some_and(|body| body.is_sleeping());
    commands.entity(on.entity).queue_silenced(move |mut entity: EntityWorldMut| {
        if entity.contains::<RigidBody>() {
            entity.insert_if_new(Sleeping::new(is_sleeping));
        }
    });
}
