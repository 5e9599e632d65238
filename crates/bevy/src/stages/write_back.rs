//! After the step: poses, velocities and sleep states of the bodies that moved.

use crate::body::{BodyState, Sleeping, Velocity};
use crate::dim::{ang_to_bevy, to_bevy, write_pose};
use crate::world::{PhysicsWorld, entity_of};
use bevy::ecs::change_detection::DetectChangesMut;
use bevy::ecs::entity::Entity;
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
    mut bodies: Query<(&mut Transform, Written), Without<ChildOf>>,
) {
    let awake = awake_entities(&world);
    for entity in core::mem::replace(&mut world.awake, awake) {
        if let (Some(body), Ok((transform, mut written))) =
            (world.body(entity), bodies.get_mut(entity))
            && (body.is_sleeping() || body.is_fixed() || !body.is_enabled())
        {
            written.write_motion(body);
            written.write_transform(body, transform);
            written.state.end_interpolation();
        }
    }
    for &entity in &world.awake {
        if let (Some(body), Ok((transform, mut written))) =
            (world.body(entity), bodies.get_mut(entity))
        {
            written.write_motion(body);
            written.write_transform(body, transform);
        }
    }
}

impl WrittenItem<'_, '_> {
    fn write_transform(
        &mut self,
        body: &RigidBody,
        mut transform: bevy::ecs::world::Mut<Transform>,
    ) {
        let mut placed = *transform;
        write_pose(body.position(), &mut placed);
        transform.set_if_neq(placed);
        self.state.push(placed);
    }
}

/// The entities of the engine's awake bodies.
fn awake_entities(world: &PhysicsWorld) -> Vec<Entity> {
    let handles = world.engine.active_bodies().iter();
    let bodies = handles.filter_map(|&handle| world.engine.bodies.get(handle));
    bodies.filter_map(|body| entity_of(body.user_data)).collect()
}
