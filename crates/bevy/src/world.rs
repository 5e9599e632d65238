//! The engine's world, and the entities of its bodies, colliders and joints.

use crate::dim::{Vector, to_engine};
use crate::event::Occurrence;
use bevy::ecs::entity::{Entity, EntityHashMap};
use bevy::ecs::resource::Resource;
use rapier::prelude::{
    Collider, ColliderHandle, ImpulseJoint, ImpulseJointHandle, RigidBody, RigidBodyHandle,
};

/// The simulation: the engine's world, and the maps between entities and handles.
///
/// [`Self::engine`] gives access to everything that has no component. The user data of its bodies, colliders
/// and joints are the bits of their entities.
#[derive(Resource, Default)]
pub struct PhysicsWorld {
    /// The engine's world.
    pub engine: rapier::prelude::PhysicsWorld,
    pub(crate) bodies: EntityHashMap<RigidBodyHandle>,
    pub(crate) colliders: EntityHashMap<ColliderHandle>,
    pub(crate) joints: EntityHashMap<ImpulseJointHandle>,
    pub(crate) pending: Pending,
    /// Entities of the bodies that were awake in the last step, in the engine's order.
    pub(crate) awake: Vec<Entity>,
    /// Colliders that were removed since the last step.
    pub(crate) removed: Vec<(ColliderHandle, Entity)>,
    /// Colliders that were removed before the last step. Its events still name them.
    pub(crate) removed_before_step: Vec<(ColliderHandle, Entity)>,
    /// Events of the last step.
    pub(crate) occurrences: Vec<Occurrence>,
}

/// Entities with components that were inserted since the last step, in the order of insertion.
///
/// Queries iterate by archetype, so their order depends on unrelated components.
#[derive(Default)]
pub(crate) struct Pending {
    pub bodies: Vec<Entity>,
    pub colliders: Vec<Entity>,
    pub joints: Vec<Entity>,
    /// Bodies that lost their parent entity since the last step.
    pub detached: Vec<Entity>,
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
            self.removed.push((handle, entity));
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
            let mut removed = self.removed_before_step.iter().chain(&self.removed);
            removed.find(|(removed, _)| *removed == handle).map(|&(_, entity)| entity)
        })
    }
}
