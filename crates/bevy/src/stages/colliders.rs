//! Colliders: description, body, and placement on the body.

use crate::body::RigidBody;
use crate::collider::{ColliderDescription, ColliderEdits, ColliderState};
use crate::dim::{from_transform, pose_of};
use crate::hierarchy::Hierarchy;
use crate::invalid::refuse;
use crate::world::PhysicsWorld;
use bevy::ecs::change_detection::{DetectChanges, Ref};
use bevy::ecs::entity::{Entity, EntityHashSet};
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::query::{Has, With};
use bevy::ecs::system::{Commands, Query, ResMut};
use bevy::transform::components::Transform;
use rapier::prelude::Collider;

/// Finds colliders that have another body, another size or another place on their body. Those of the first
/// two kinds are described anew.
pub(crate) fn place_colliders(
    mut world: ResMut<PhysicsWorld>,
    mut colliders: Query<(
        Entity,
        Ref<Transform>,
        &mut ColliderState,
        Has<RigidBody>,
        Has<ChildOf>,
    )>,
    locals: Query<&Transform>,
    hierarchy: Hierarchy,
) {
    for (entity, transform, mut state, has_body, has_parent) in &mut colliders {
        let has_same_body = state.body == has_body.then_some(entity);
        if !has_parent && has_same_body && !transform.is_changed() {
            continue;
        }
        let Some(&handle) = world.colliders.get(&entity) else {
            continue;
        };
        let body = hierarchy.body_of(entity);
        let placement = hierarchy.placement(entity, body, |entity| locals.get(entity).ok());
        if body != state.body || placement.scale != state.placement.scale {
            world.pending.colliders.push(entity);
        } else if placement != state.placement {
            state.placement = placement;
            if let Some(collider) = world.engine.colliders.get_mut(handle) {
                set_placement(collider, &placement);
            }
        }
    }
}

/// Inserts new colliders, and replaces the description of those with edits.
pub(crate) fn describe_colliders(
    mut world: ResMut<PhysicsWorld>,
    mut colliders: Query<(ColliderDescription, &mut ColliderState)>,
    edited: Query<Entity, (ColliderEdits, With<ColliderState>)>,
    locals: Query<&Transform>,
    hierarchy: Hierarchy,
    mut commands: Commands,
) {
    let mut seen = EntityHashSet::default();
    for entity in core::mem::take(&mut world.pending.colliders).into_iter().chain(&edited) {
        let Ok((description, mut state)) = colliders.get_mut(entity) else {
            continue;
        };
        if !seen.insert(entity) {
            continue;
        }
        let body = hierarchy.body_of(entity);
        if body.is_some_and(|body| !world.bodies.contains_key(&body)) {
            // The engine refused the body: the collider follows once there is one.
            world.pending.colliders.push(entity);
            continue;
        }
        let placement = hierarchy.placement(entity, body, |entity| locals.get(entity).ok());
        let collider = description
            .builder(from_transform(placement.scale))
            .and_then(|builder| builder.position(pose_of(&placement)).try_build());
        match collider {
            Ok(collider) => {
                *state = ColliderState { body, placement };
                world.put_collider(entity, collider, &state);
            }
            Err(reason) => {
                state.placement.scale = placement.scale;
                refuse(&mut commands, entity, reason);
            }
        }
    }
}

impl PhysicsWorld {
    /// Inserts the collider of an entity, or replaces it. A replaced collider keeps its handle.
    fn put_collider(&mut self, entity: Entity, new: Collider, state: &ColliderState) {
        let body = state.body.and_then(|body| self.bodies.get(&body)).copied();
        let Some(&handle) = self.colliders.get(&entity) else {
            let handle = self.engine.insert_collider(new, body);
            self.colliders.insert(entity, handle);
            return;
        };
        let Some(collider) = self.engine.colliders.get_mut(handle) else {
            return;
        };
        collider.copy_from(&new);
        if collider.parent() != body {
            self.engine.colliders.set_parent(handle, body, &mut self.engine.bodies);
        }
        if let Some(collider) = self.engine.colliders.get_mut(handle) {
            set_placement(collider, &state.placement);
        }
    }
}

fn set_placement(collider: &mut Collider, placement: &Transform) {
    if collider.parent().is_some() {
        collider.set_position_wrt_parent(pose_of(placement));
    } else {
        collider.set_position(pose_of(placement));
    }
}
