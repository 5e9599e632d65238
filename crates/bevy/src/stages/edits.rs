//! Validation of edits of a body. The engine's setters only log invalid values, without the entity.

use super::pose_parts::PoseParts;
use crate::body::{BodyState, Velocity};
use crate::dim::{ang_to_engine, pose_of, to_engine};
use crate::invalid::refuse;
use bevy::ecs::entity::Entity;
use bevy::ecs::system::Commands;
use bevy::ecs::world::EntityWorldMut;
use bevy::transform::components::Transform;
use core::fmt::Debug;
use rapier::math::Pose;
use rapier::prelude::{InvalidRigidBody, RigidBodyBuilder, RigidBodyVelocity};

/// Validates values of a body that are edited together.
pub(super) fn check(values: &RigidBodyBuilder) -> Result<(), InvalidRigidBody> {
    values.try_build().map(drop)
}

/// The engine's pose of a transform.
pub(super) fn checked_pose(transform: &Transform) -> Result<Pose, InvalidRigidBody> {
    let pose = pose_of(transform);
    check(&RigidBodyBuilder::fixed().pose(pose)).map(|()| pose)
}

/// The engine's velocity: both parts, or none.
pub(super) fn checked_velocity(velocity: &Velocity) -> Result<RigidBodyVelocity, InvalidRigidBody> {
    let (linear, angular) = (to_engine(velocity.linear), ang_to_engine(velocity.angular));
    check(&RigidBodyBuilder::dynamic().linvel(linear).angvel(angular))
        .map(|()| RigidBodyVelocity::new(linear, angular))
}

/// Refuses a component whose numbers are not finite.
pub(super) fn check_finite(
    is_finite: bool,
    field: &'static str,
    value: &impl Debug,
) -> Result<(), InvalidRigidBody> {
    match is_finite {
        true => Ok(()),
        false => Err(InvalidRigidBody { field, value: format!("{value:?}") }),
    }
}

/// Reports an invalid pose, and restores the last valid one.
pub(super) fn refuse_pose(commands: &mut Commands, entity: Entity, reason: InvalidRigidBody) {
    commands.entity(entity).queue_silenced(|mut entity: EntityWorldMut| {
        let Some(mut state) = entity.get_mut::<BodyState>() else {
            return;
        };
        state.shown = state.current;
        let current = state.current;
        if let Some(mut transform) = entity.get_mut::<Transform>() {
            PoseParts::ALL.copy(&current, &mut transform);
            // In 2D the z coordinate is no part of the pose, and a lost vector has an invalid one.
            if !transform.translation.is_finite() {
                transform.translation = current.translation;
            }
        }
    });
    refuse(commands, entity, reason);
}
