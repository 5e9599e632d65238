//! Bodies below other entities: their `Transform` is relative to the parent, the engine's pose is not.

use super::edits::{checked_pose, refuse_pose};
use super::pose_parts::PoseParts;
use super::write_back::Written;
use crate::body::{BodyState, RigidBody};
use crate::hierarchy::{Hierarchy, Locals, is_same, local_transform};
use crate::world::PhysicsWorld;
use bevy::ecs::entity::Entity;
use bevy::ecs::entity_disabling::Disabled;
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::query::{Allow, With};
use bevy::ecs::system::{Commands, Query, Res, ResMut};
use bevy::transform::components::Transform;

/// Moves the bodies whose ancestors the user moved or exchanged. Motion by the step is ignored, and so is
/// that of ancestors which the step is going to move.
pub(crate) fn carry_nested_bodies(
    mut world: ResMut<PhysicsWorld>,
    nested: Query<Entity, (With<ChildOf>, With<RigidBody>)>,
    mut bodies: Query<(&RigidBody, &mut BodyState)>,
    locals: Locals,
    hierarchy: Hierarchy,
    mut commands: Commands,
) {
    let local = |entity| locals.get(entity).ok();
    let detached = core::mem::take(&mut world.pending.detached);
    for entity in nested.iter().chain(detached) {
        let (Ok((kind, mut state)), Some(body)) =
            (bodies.get_mut(entity), world.bodies.get(&entity).copied())
        else {
            continue;
        };
        let carrier = hierarchy.carrier(entity, local);
        if carrier.is_same(&state.carrier) {
            continue;
        }
        state.carrier = carrier;
        state.parent = hierarchy.parent_transform(entity, local);
        let Some(body) = world.engine.bodies.get_mut(body) else {
            continue;
        };
        match (checked_pose(&hierarchy.world_transform(entity, local)), kind) {
            (Err(reason), _) => refuse_pose(&mut commands, entity, reason),
            (Ok(pose), RigidBody::KinematicPosition) => body.set_next_kinematic_position(pose),
            (Ok(pose), _) => body.set_position(pose, true),
        }
    }
}

/// Writes the local transforms of nested bodies that moved or whose parent moved, parents first.
pub(crate) fn write_nested_transforms(
    world: Res<PhysicsWorld>,
    nested: Query<Entity, (With<ChildOf>, With<RigidBody>)>,
    mut transforms: Query<&mut Transform, Allow<Disabled>>,
    mut bodies: Query<Written>,
    hierarchy: Hierarchy,
) {
    let mut order: Vec<_> = nested.iter().map(|entity| (hierarchy.depth(entity), entity)).collect();
    order.sort();
    for (_, entity) in order {
        let parent = hierarchy.parent_transform(entity, |entity| transforms.get(entity).ok());
        let (Some(body), Ok(mut written)) = (world.body(entity), bodies.get_mut(entity)) else {
            continue;
        };
        let was_sleeping = written.sleeping.is_sleeping();
        written.write_motion(body);
        let rests = body.is_fixed() || was_sleeping && body.is_sleeping();
        if rests && is_same(&parent, &written.state.parent) {
            written.state.end_interpolation();
            continue;
        }
        written.state.parent = parent;
        let local = |entity| transforms.get(entity).ok();
        written.state.carrier = hierarchy.carrier(entity, local);
        let Ok(mut transform) = transforms.get_mut(entity) else {
            continue;
        };
        let mut world_pose = *transform;
        crate::dim::write_pose(body.position(), &mut world_pose);
        let new = local_transform(&parent, &world_pose, &transform);
        let parts = PoseParts::of_difference(&new, &transform);
        if parts.is_any() {
            parts.copy(&new, &mut transform);
        }
        written.state.push(*transform);
    }
}
