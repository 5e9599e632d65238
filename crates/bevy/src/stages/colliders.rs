//! Colliders: description, body, and placement on the body.

use crate::body::RigidBody;
use crate::collider::{ColliderDescription, ColliderEdits, ColliderState};
use crate::dim::{from_transform, pose_of};
use crate::hierarchy::{Hierarchy, Locals, is_same};
use crate::invalid::refuse;
use crate::world::PhysicsWorld;
use bevy::ecs::change_detection::{DetectChanges, Ref};
use bevy::ecs::entity::{Entity, EntityHashSet};
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::query::{Has, With};
use bevy::ecs::system::{Commands, Query, ResMut};
use bevy::transform::components::Transform;
use rapier::math::Pose;
use rapier::prelude::{Collider, ColliderBuilder, InvalidCollider};

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
    locals: Locals,
    hierarchy: Hierarchy,
    mut commands: Commands,
) {
    let mut edited = Vec::new();
    for (entity, transform, mut state, has_body, has_parent) in &mut colliders {
        let has_same_body = state.body == has_body.then_some(entity);
        if !has_parent && has_same_body && !transform.is_changed() {
            continue;
        }
        let body = hierarchy.body_of(entity);
        let placement = hierarchy.placement(entity, body, |entity| locals.get(entity).ok());
        if body == state.body && is_same(&placement, &state.placement) {
            continue;
        }
        let handle = world.colliders.get(&entity).copied();
        let collider = handle.and_then(|handle| world.engine.colliders.get_mut(handle));
        // A collider that the engine refused gets another try.
        let is_valid = state.placement.is_finite() && collider.is_some();
        let size = |placement: &Transform| Transform::from_scale(placement.scale);
        let is_same_size = is_same(&size(&placement), &size(&state.placement));
        let Some(collider) = collider.filter(|_| is_valid && is_same_size && body == state.body)
        else {
            if !is_same_size || !state.placement.is_finite() || body != state.body {
                edited.push(entity);
            }
            continue;
        };
        state.placement = placement;
        if let Err(reason) = set_placement(collider, &placement) {
            refuse(&mut commands, entity, reason);
        }
    }
    // The order of a query depends on unrelated components.
    edited.sort();
    world.pending.colliders.extend(edited);
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
                world.upsert_collider(entity, collider, &ColliderState { body, placement });
            }
            Err(reason) => refuse(&mut commands, entity, reason),
        }
        // Refused values are stored, too: they are reported once, and another value is the next try.
        *state = ColliderState { body, placement };
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
            set_pose(collider, pose_of(&state.placement));
        }
    }
}

/// Moves a collider on its body, or in the world.
fn set_placement(collider: &mut Collider, placement: &Transform) -> Result<(), InvalidCollider> {
    let pose = pose_of(placement);
    ColliderBuilder::ball(1.0).position(pose).try_build()?;
    set_pose(collider, pose);
    Ok(())
}

fn set_pose(collider: &mut Collider, pose: Pose) {
    if collider.parent().is_some() {
        collider.set_position_wrt_parent(pose);
    } else {
        collider.set_position(pose);
    }
}
