//! Events of a step, as entity events for observers.

use crate::dim::{Vector, to_bevy};
use crate::invalid::{Invalid, refuse};
use crate::precision::Scalar;
use crate::world::{PhysicsWorld, entity_of};
use bevy::ecs::entity::Entity;
use bevy::ecs::event::EntityEvent;
use bevy::ecs::system::Commands;
use rapier::prelude::{
    ColliderHandle, ColliderSet, CollisionEvent, ContactForceEvent, ContactPair, EventHandler,
    ImpulseJointSet, JointBreakEvent, QuarantineEvent, RigidBodySet,
};
use std::sync::Mutex;

/// Event: two colliders began to touch or to intersect, and at least one of them has
/// [`CollisionEvents`](crate::CollisionEvents). Triggered once on each of the two entities.
///
/// `propagate(true)` in an observer passes the event to the parent entity, for example to the body.
#[derive(EntityEvent, Copy, Clone, Debug, PartialEq, Eq)]
#[entity_event(propagate)]
pub struct CollisionStarted {
    /// The entity that the event targets.
    #[event_target]
    pub entity: Entity,
    /// The entity of this collider: `entity`, before any propagation.
    pub collider: Entity,
    /// The entity of the other collider.
    pub other: Entity,
    /// Whether one of them is a sensor.
    pub is_sensor: bool,
}

/// Event: two colliders no longer touch or intersect, or one of them was removed. Triggered once on each of
/// the two entities.
#[derive(EntityEvent, Copy, Clone, Debug, PartialEq, Eq)]
#[entity_event(propagate)]
pub struct CollisionStopped {
    /// The entity that the event targets.
    #[event_target]
    pub entity: Entity,
    /// The entity of this collider: `entity`, before any propagation.
    pub collider: Entity,
    /// The entity of the other collider.
    pub other: Entity,
    /// Whether one of them is a sensor.
    pub is_sensor: bool,
    /// Whether a collider was removed.
    pub is_removed: bool,
}

/// Event: the contact forces of two colliders exceed the threshold of one with
/// [`ContactForceEvents`](crate::ContactForceEvents). Triggered once per step on each of the two entities.
#[derive(EntityEvent, Copy, Clone, Debug, PartialEq)]
#[entity_event(propagate)]
pub struct ContactForce {
    /// The entity that the event targets.
    #[event_target]
    pub entity: Entity,
    /// The entity of this collider: `entity`, before any propagation.
    pub collider: Entity,
    /// The entity of the other collider.
    pub other: Entity,
    /// Sum of the contact forces on this collider.
    pub total_force: Vector,
    /// Sum of the magnitudes of the contact forces.
    pub total_magnitude: Scalar,
    /// Magnitude of the largest force.
    pub max_magnitude: Scalar,
    /// Whether the pair touched in this step for the first time.
    pub is_started: bool,
}

/// Event: the load of a joint exceeded its thresholds. The joint is disabled. Triggered on its entity.
#[derive(EntityEvent, Copy, Clone, Debug, PartialEq)]
pub struct JointBroken {
    /// The entity of the joint.
    pub entity: Entity,
    /// Force at that moment.
    pub force: Scalar,
    /// Torque at that moment.
    pub torque: Scalar,
}

/// An event of the engine.
pub(crate) enum StepEvent {
    Collision(CollisionEvent),
    Force(ContactForceEvent),
    Break(JointBreakEvent),
    Quarantine(QuarantineEvent),
}

/// Collects the events of a step in the engine's order.
#[derive(Default)]
pub(crate) struct Recorder(Mutex<Vec<StepEvent>>);

impl Recorder {
    fn push(&self, event: StepEvent) {
        self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner).push(event);
    }

    /// The events.
    pub fn into_events(self) -> Vec<StepEvent> {
        self.0.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl EventHandler for Recorder {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        self.push(StepEvent::Collision(*event));
    }

    fn handle_contact_force_event(
        &self,
        _: Scalar,
        event: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        self.push(StepEvent::Force(*event));
    }

    fn handle_joint_break_event(&self, event: &JointBreakEvent, _: &RigidBodySet) {
        self.push(StepEvent::Break(*event));
    }

    fn handle_quarantine_event(&self, event: &QuarantineEvent, _: &RigidBodySet, _: &ColliderSet) {
        self.push(StepEvent::Quarantine(*event));
    }
}

impl StepEvent {
    /// Triggers the entity events of this event.
    pub fn trigger(&self, world: &PhysicsWorld, commands: &mut Commands) {
        match self {
            Self::Collision(event) => trigger_collision(*event, world, commands),
            Self::Force(event) => trigger_force(event, world, commands),
            Self::Break(event) => trigger_break(event, &world.engine.impulse_joints, commands),
            Self::Quarantine(event) => {
                let entity = event.body().and_then(|body| world.entity_of_body(body));
                if let Some(entity) = entity {
                    refuse(commands, entity, Invalid::Motion(event.cause()));
                }
            }
        }
    }
}

/// Both directions of a pair.
fn directions(
    world: &PhysicsWorld,
    collider1: ColliderHandle,
    collider2: ColliderHandle,
) -> Option<[(Entity, Entity); 2]> {
    let entity1 = world.entity_of_any_collider(collider1)?;
    let entity2 = world.entity_of_any_collider(collider2)?;
    Some([(entity1, entity2), (entity2, entity1)])
}

fn trigger_collision(event: CollisionEvent, world: &PhysicsWorld, commands: &mut Commands) {
    let (is_sensor, is_removed) = (event.sensor(), event.removed());
    let pair = directions(world, event.collider1(), event.collider2());
    for (entity, other) in pair.into_iter().flatten() {
        let collider = entity;
        if event.started() {
            commands.trigger(CollisionStarted { entity, collider, other, is_sensor });
        } else {
            commands.trigger(CollisionStopped { entity, collider, other, is_sensor, is_removed });
        }
    }
}

fn trigger_force(event: &ContactForceEvent, world: &PhysicsWorld, commands: &mut Commands) {
    let Some([first, second]) = directions(world, event.collider1, event.collider2) else {
        return;
    };
    // The engine's force acts on the second collider.
    let force = to_bevy(event.total_force);
    for ((entity, other), total_force) in [(first, -force), (second, force)] {
        commands.trigger(ContactForce {
            entity,
            collider: entity,
            other,
            total_force,
            total_magnitude: event.total_force_magnitude,
            max_magnitude: event.max_force_magnitude,
            is_started: event.started,
        });
    }
}

fn trigger_break(event: &JointBreakEvent, joints: &ImpulseJointSet, commands: &mut Commands) {
    let entity = joints.get(event.joint).and_then(|joint| entity_of(joint.data.user_data));
    if let Some(entity) = entity {
        commands.trigger(JointBroken { entity, force: event.force, torque: event.torque });
    }
}
