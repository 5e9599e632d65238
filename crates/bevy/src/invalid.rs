//! Values that the engine refuses.

use bevy::ecs::entity::Entity;
use bevy::ecs::event::EntityEvent;
use bevy::ecs::system::Commands;
use bevy::log::warn;
use rapier::prelude::{InvalidCollider, InvalidJoint, InvalidRigidBody, QuarantineCause};

/// The reason why the simulation left a component out, with the value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Invalid {
    /// A body.
    #[error("the body is invalid: {0}")]
    Body(#[from] InvalidRigidBody),
    /// A collider.
    #[error("the collider is invalid: {0}")]
    Collider(#[from] InvalidCollider),
    /// A joint.
    #[error("the joint is invalid: {0}")]
    Joint(#[from] InvalidJoint),
    /// A body whose motion left the range of numbers, for example by an excessive force. The engine disabled
    /// it; its `set_enabled` enables it again.
    #[error("the body is disabled: {0}")]
    Motion(QuarantineCause),
}

/// Event: a body, collider or joint has an invalid value. The simulation continues without it, or with its
/// last valid state. Another value of the component, or of the scale, is the next attempt. The guide lists
/// the exceptions.
#[derive(EntityEvent, Clone, Debug)]
pub struct Refused {
    /// The entity with the component.
    pub entity: Entity,
    /// The value and the reason.
    pub reason: Invalid,
}

/// Logs a warning with the entity and the value, and triggers the event.
pub(crate) fn refuse(commands: &mut Commands, entity: Entity, reason: impl Into<Invalid>) {
    let reason = reason.into();
    warn!("entity {entity}: {reason}");
    commands.trigger(Refused { entity, reason });
}
