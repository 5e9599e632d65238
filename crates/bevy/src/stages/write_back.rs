//! After the step: poses, velocities and sleep states of the bodies that moved.

use crate::body::{BodyState, Sleeping, Velocity};
use crate::dim::{ang_to_bevy, to_bevy, write_pose};
use crate::world::{PhysicsWorld, entity_of};
use bevy::ecs::change_detection::{DetectChangesMut, Mut};
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::query::{QueryData, Without};
use bevy::ecs::system::{Query, ResMut};
use bevy::transform::components::Transform;
use rapier::prelude::RigidBody;

/// The components that a step writes, besides the transform.
#[derive(QueryData)]
#[query_data(mutable)]
pub(crate) struct Written {
    pub velocity: &'static mut Velocity,
    pub sleeping: &'static mut Sleeping,
    pub state: &'static mut BodyState,
}

impl WrittenItem<'_, '_> {
    /// Writes velocity, sleep state and pose.
    fn write(&mut self, body: &RigidBody, mut transform: Mut<Transform>) {
        self.write_motion(body);
        let mut new = *transform;
        write_pose(body.position(), &mut new);
        transform.set_if_neq(new);
        self.state.push(new);
    }

    /// Writes velocity and sleep state, and marks them as changed only if they differ.
    pub fn write_motion(&mut self, body: &RigidBody) {
        let velocity =
            Velocity { linear: to_bevy(body.linvel()), angular: ang_to_bevy(body.angvel()) };
        self.state.velocity = velocity;
        self.velocity.set_if_neq(velocity);
        self.sleeping.set_if_neq(Sleeping::new(body.is_sleeping()));
    }
}

impl BodyState {
    /// Stores the transform after a step.
    pub fn push(&mut self, transform: Transform) {
        self.previous = self.current;
        (self.current, self.shown) = (transform, transform);
    }

    /// Ends the interpolation of a body without motion.
    pub fn end_interpolation(&mut self) {
        self.previous = self.current;
    }
}

/// Writes the bodies that are awake, and those that no longer are: asleep, fixed, or disabled.
///
/// Transforms below a parent follow in a [system](super::write_nested_transforms) of their own.
pub(crate) fn write_transforms(
    mut world: ResMut<PhysicsWorld>,
    mut bodies: Query<(Mut<Transform>, Written), Without<ChildOf>>,
) {
    let PhysicsWorld { engine, awake, .. } = &mut *world;
    for (entity, handle) in awake.drain(..) {
        if let Some(body) = engine.bodies.get(handle)
            && (body.is_sleeping() || body.is_fixed() || !body.is_enabled())
            && let Ok((transform, mut written)) = bodies.get_mut(entity)
        {
            written.write(body, transform);
            written.state.end_interpolation();
        }
    }
    for &handle in engine.active_bodies() {
        if let Some(body) = engine.bodies.get(handle)
            && let Some(entity) = entity_of(body.user_data)
        {
            awake.push((entity, handle));
            if let Ok((transform, mut written)) = bodies.get_mut(entity) {
                written.write(body, transform);
            }
        }
    }
}
