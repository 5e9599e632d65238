//! Bodies below other entities: their `Transform` is relative to the parent, the engine's pose is not.

use super::write_back::{Written, has_pose_of, set_pose};
use crate::body::{BodyState, RigidBody};
use crate::dim::pose_of;
use crate::hierarchy::{Hierarchy, local_transform};
use crate::world::PhysicsWorld;
use bevy::ecs::entity::Entity;
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::query::With;
use bevy::ecs::system::{Query, Res, ResMut};
use bevy::transform::components::Transform;

/// Moves the bodies whose ancestors the user moved or exchanged. Motion of a parent body by the engine does
/// not count.
pub(crate) fn carry_nested_bodies(
    mut world: ResMut<PhysicsWorld>,
    nested: Query<Entity, (With<ChildOf>, With<RigidBody>)>,
    mut bodies: Query<(&RigidBody, &mut BodyState)>,
    locals: Query<&Transform>,
    hierarchy: Hierarchy,
) {
    let local = |entity| locals.get(entity).ok();
    let detached = core::mem::take(&mut world.pending.detached);
    for entity in nested.iter().chain(detached) {
        let parent = hierarchy.parent_transform(entity, local);
        let (Ok((kind, mut state)), Some(body)) =
            (bodies.get_mut(entity), world.bodies.get(&entity).copied())
        else {
            continue;
        };
        if parent == state.parent {
            continue;
        }
        state.parent = parent;
        let placed = pose_of(&hierarchy.world_transform(entity, local));
        match (world.engine.bodies.get_mut(body), kind) {
            (None, _) => {}
            (Some(body), RigidBody::KinematicPosition) => body.set_next_kinematic_position(placed),
            (Some(body), _) => body.set_position(placed, true),
        }
    }
}

/// Writes the local transforms of nested bodies that moved or whose parent moved, parents first.
pub(crate) fn write_nested_transforms(
    world: Res<PhysicsWorld>,
    nested: Query<Entity, (With<ChildOf>, With<RigidBody>)>,
    mut transforms: Query<&mut Transform>,
    mut bodies: Query<Written>,
    hierarchy: Hierarchy,
) {
    let mut order: Vec<_> = nested.iter().map(|entity| (hierarchy.depth(entity), entity)).collect();
    order.sort();
    for (_, entity) in order {
        let parent = hierarchy.parent_transform(entity, |entity| transforms.get(entity).ok());
        let (Some(body), Ok(mut written), Ok(mut transform)) =
            (world.body(entity), bodies.get_mut(entity), transforms.get_mut(entity))
        else {
            continue;
        };
        let was_sleeping = written.sleeping.is_sleeping();
        written.write_motion(body);
        let rests = body.is_fixed() || was_sleeping && body.is_sleeping();
        if rests && parent == written.state.parent {
            written.state.settle();
            continue;
        }
        written.state.parent = parent;
        let mut placed = *transform;
        crate::dim::write_pose(body.position(), &mut placed);
        let placed = local_transform(&parent, &placed, transform.scale);
        if !has_pose_of(&placed, &transform) {
            set_pose(&mut transform, &placed);
        }
        written.state.advance(*transform);
    }
}
