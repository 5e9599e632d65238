//! Colliders: description, body, and pose on the body.

use super::edits::checked_pose;
use crate::collider::{ColliderDescription, ColliderEdits, ColliderMoves, ColliderState};
use crate::dim::{from_transform, pose_of};
use crate::hierarchy::{Hierarchy, Locals, is_same};
use crate::invalid::refuse;
use crate::world::PhysicsWorld;
use bevy::ecs::entity::Entity;
use bevy::ecs::query::With;
use bevy::ecs::system::{Commands, Query, ResMut};
use bevy::transform::components::Transform;
use rapier::math::Pose;
use rapier::prelude::Collider;

/// Moves the colliders that have another pose on their body. Those with another body, another scale or an
/// invalid pose are described anew.
pub(crate) fn move_colliders(
    mut world: ResMut<PhysicsWorld>,
    mut colliders: Query<(Entity, &mut ColliderState), ColliderMoves>,
    locals: Locals,
    hierarchy: Hierarchy,
) {
    let mut edited = Vec::new();
    for (entity, mut state) in &mut colliders {
        let body = hierarchy.body_of(entity);
        let relative = hierarchy.relative_transform(entity, body, |entity| locals.get(entity).ok());
        if body == state.body && is_same(&relative, &state.relative) {
            continue;
        }
        let [scale, old_scale] =
            [relative, state.relative].map(|transform| Transform::from_scale(transform.scale));
        let is_moved = body == state.body
            && is_same(&scale, &old_scale)
            && checked_pose(&state.relative).is_ok();
        match checked_pose(&relative) {
            Ok(pose) if is_moved => {
                let handle = world.colliders.get(&entity).copied();
                if let Some(collider) = handle.and_then(|h| world.engine.colliders.get_mut(h)) {
                    set_pose(collider, pose);
                    state.relative = relative;
                }
            }
            _ => edited.push(entity),
        }
    }
    world.pending.colliders.extend_sorted(edited);
}

/// Inserts new colliders, and replaces the description of those with edits.
pub(crate) fn describe_colliders(
    mut world: ResMut<PhysicsWorld>,
    mut colliders: Query<(ColliderDescription, &mut ColliderState)>,
    edited: Query<Entity, (ColliderEdits, With<ColliderState>)>,
    locals: Locals,
    hierarchy: Hierarchy,
    mut commands: Commands,
) {
    world.pending.colliders.extend_sorted(edited);
    for entity in world.pending.colliders.take() {
        let Ok((description, mut state)) = colliders.get_mut(entity) else {
            continue;
        };
        let body = hierarchy.body_of(entity);
        if body.is_some_and(|body| !world.bodies.contains_key(&body)) {
            // The engine refused the body: the collider follows once there is one.
            world.pending.colliders.push(entity);
            continue;
        }
        let relative = hierarchy.relative_transform(entity, body, |entity| locals.get(entity).ok());
        let collider = description
            .builder(from_transform(relative.scale))
            .and_then(|builder| builder.position(pose_of(&relative)).try_build());
        // Refused values are stored, too: they are reported once, and another value is the next attempt.
        *state = ColliderState { body, relative };
        match collider {
            Ok(collider) => world.upsert_collider(entity, collider, &state),
            Err(reason) => refuse(&mut commands, entity, reason),
        }
    }
}

impl PhysicsWorld {
    /// Inserts the collider of an entity, or replaces it. A replaced collider keeps its handle.
    fn upsert_collider(&mut self, entity: Entity, new: Collider, state: &ColliderState) {
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
            set_pose(collider, pose_of(&state.relative));
        }
    }
}

/// Moves a collider on its body, or in the world.
fn set_pose(collider: &mut Collider, pose: Pose) {
    if collider.parent().is_some() {
        collider.set_position_wrt_parent(pose);
    } else {
        collider.set_position(pose);
    }
}
