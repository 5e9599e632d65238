//! The engine's world, and the entities of its bodies, colliders and joints.

use crate::dim::{Vector, to_engine};
use crate::event::StepEvent;
use bevy::ecs::entity::{Entity, EntityHashMap, EntityHashSet};
use bevy::ecs::resource::Resource;
use rapier::prelude::{
    Collider, ColliderHandle, ImpulseJoint, ImpulseJointHandle, RigidBody, RigidBodyHandle,
};
use std::collections::HashMap;

/// The simulation: the engine's world, and the maps between entities and handles.
///
/// [`Self::engine`] gives access to everything that has no component. The user data of its bodies, colliders
/// and joints are the bits of their entities. Elements that the program inserts itself need the user data 0.
#[derive(Resource, Default)]
pub struct PhysicsWorld {
    /// The engine's world.
    pub engine: rapier::prelude::PhysicsWorld,
    pub(crate) bodies: EntityHashMap<RigidBodyHandle>,
    pub(crate) colliders: EntityHashMap<ColliderHandle>,
    pub(crate) joints: EntityHashMap<ImpulseJointHandle>,
    pub(crate) pending: Pending,
    /// The bodies that were awake in the last step, in the engine's order.
    pub(crate) awake: Vec<(Entity, RigidBodyHandle)>,
    /// Colliders that were removed since the last step.
    pub(crate) removed: HashMap<ColliderHandle, Entity>,
    /// Colliders that were removed between the last two steps. Events of the last step still name them.
    pub(crate) removed_before_step: HashMap<ColliderHandle, Entity>,
    /// Events of the last step.
    pub(crate) events: Vec<StepEvent>,
}

/// Entities whose elements the next step inserts or updates.
#[derive(Default)]
pub(crate) struct Pending {
    pub bodies: Queue,
    pub colliders: Queue,
    pub joints: Queue,
    /// Bodies that lost their parent entity since the last step.
    pub detached: Vec<Entity>,
}

/// Entities in the order in which the engine receives their elements.
#[derive(Default)]
pub(crate) struct Queue(Vec<Entity>);

impl Queue {
    /// Appends an entity whose component was inserted.
    pub fn push(&mut self, entity: Entity) {
        self.0.push(entity);
    }

    /// Appends entities that a query found, sorted. Queries iterate by archetype, so their order depends on
    /// unrelated components.
    pub fn extend_sorted(&mut self, found: impl IntoIterator<Item = Entity>) {
        let start = self.0.len();
        self.0.extend(found);
        self.0[start..].sort_unstable();
    }

    /// Empties the queue. Each entity is returned once.
    pub fn take(&mut self) -> Vec<Entity> {
        let mut seen = EntityHashSet::default();
        let mut entities = core::mem::take(&mut self.0);
        entities.retain(|entity| seen.insert(*entity));
        entities
    }
}

/// The entity in an element's user data.
pub(crate) fn entity_of(user_data: u128) -> Option<Entity> {
    u64::try_from(user_data).ok().and_then(Entity::try_from_bits)
}

impl PhysicsWorld {
    pub(crate) fn new(gravity: Vector) -> Self {
        let mut world = Self::default();
        world.engine.gravity = to_engine(gravity);
        world
    }

    /// Sets the gravity (length/s²).
    pub fn set_gravity(&mut self, gravity: Vector) {
        self.engine.gravity = to_engine(gravity);
    }

    /// Handle of an entity's body.
    pub fn body_handle(&self, entity: Entity) -> Option<RigidBodyHandle> {
        self.bodies.get(&entity).copied()
    }

    /// Handle of an entity's collider.
    pub fn collider_handle(&self, entity: Entity) -> Option<ColliderHandle> {
        self.colliders.get(&entity).copied()
    }

    /// Handle of an entity's joint.
    pub fn joint_handle(&self, entity: Entity) -> Option<ImpulseJointHandle> {
        self.joints.get(&entity).copied()
    }

    /// The engine's body of an entity.
    pub fn body(&self, entity: Entity) -> Option<&RigidBody> {
        self.engine.bodies.get(self.body_handle(entity)?)
    }

    /// The engine's collider of an entity.
    pub fn collider(&self, entity: Entity) -> Option<&Collider> {
        self.engine.colliders.get(self.collider_handle(entity)?)
    }

    /// The engine's joint of an entity, with its force and torque.
    pub fn joint(&self, entity: Entity) -> Option<&ImpulseJoint> {
        self.engine.impulse_joints.get(self.joint_handle(entity)?)
    }

    /// The entity of a body.
    pub fn entity_of_body(&self, handle: RigidBodyHandle) -> Option<Entity> {
        entity_of(self.engine.bodies.get(handle)?.user_data)
    }

    /// The entity of a collider.
    pub fn entity_of_collider(&self, handle: ColliderHandle) -> Option<Entity> {
        entity_of(self.engine.colliders.get(handle)?.user_data)
    }

    /// The entity of a joint.
    pub fn entity_of_joint(&self, handle: ImpulseJointHandle) -> Option<Entity> {
        entity_of(self.engine.impulse_joints.get(handle)?.data.user_data)
    }

    /// Removes a body. Its colliders and joints return to the pending ones: their entities may live on.
    pub(crate) fn remove_body(&mut self, entity: Entity) {
        let Some(handle) = self.bodies.remove(&entity) else {
            return;
        };
        let colliders = self.engine.bodies.get(handle).map(|body| body.colliders().to_vec());
        for collider in colliders.unwrap_or_default() {
            if let Some(entity) = self.entity_of_collider(collider) {
                self.remove_collider(entity);
                self.pending.colliders.push(entity);
            }
        }
        let joints = self.engine.impulse_joints_with(handle);
        let joints: Vec<_> =
            joints.filter_map(|(_, joint)| entity_of(joint.data.user_data)).collect();
        for entity in joints {
            self.remove_joint(entity);
            self.pending.joints.push(entity);
        }
        self.engine.remove_body(handle);
    }

    /// Removes a collider. Its pairs end in the next step.
    pub(crate) fn remove_collider(&mut self, entity: Entity) {
        if let Some(handle) = self.colliders.remove(&entity) {
            self.engine.remove_collider(handle);
            self.removed.insert(handle, entity);
        }
    }

    /// Removes a joint.
    pub(crate) fn remove_joint(&mut self, entity: Entity) {
        if let Some(handle) = self.joints.remove(&entity) {
            self.engine.remove_impulse_joint(handle);
        }
    }

    /// The entity of a collider that exists, or existed before the last step.
    pub(crate) fn entity_of_any_collider(&self, handle: ColliderHandle) -> Option<Entity> {
        self.entity_of_collider(handle).or_else(|| {
            let removed = self.removed_before_step.get(&handle);
            removed.or_else(|| self.removed.get(&handle)).copied()
        })
    }
}
