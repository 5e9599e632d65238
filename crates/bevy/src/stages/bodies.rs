//! User edits of bodies, and new bodies.

use super::write_back::has_pose_of;
use crate::body::{
    BodyState, Damping, ExternalForce, ExternalImpulse, GravityScale, LockedAxes, RigidBody,
    Velocity,
};
use crate::dim::{ang_to_engine, pose_of, to_engine};
use crate::hierarchy::Hierarchy;
use crate::invalid::refuse;
use crate::world::PhysicsWorld;
use bevy::ecs::change_detection::{DetectChanges, Ref};
use bevy::ecs::entity::{Entity, EntityHashSet};
use bevy::ecs::query::{Changed, Or, QueryData};
use bevy::ecs::system::{Commands, Query, ResMut};
use bevy::transform::components::Transform;
use rapier::prelude::{RigidBody as EngineBody, RigidBodyBuilder};

/// All components of a body.
#[derive(QueryData)]
#[query_data(mutable)]
pub(crate) struct BodyItem {
    entity: Entity,
    body: Ref<'static, RigidBody>,
    transform: &'static Transform,
    velocity: &'static Velocity,
    gravity_scale: Ref<'static, GravityScale>,
    damping: Ref<'static, Damping>,
    locked_axes: Ref<'static, LockedAxes>,
    force: Ref<'static, ExternalForce>,
    state: &'static mut BodyState,
}

type BodyEdits = Or<(
    Changed<RigidBody>,
    Changed<Transform>,
    Changed<Velocity>,
    Changed<GravityScale>,
    Changed<Damping>,
    Changed<LockedAxes>,
    Changed<ExternalForce>,
)>;

/// Hands the edits since the last step to the engine. An edit of a refused body queues it again.
pub(crate) fn edit_bodies(
    mut world: ResMut<PhysicsWorld>,
    mut bodies: Query<BodyItem, BodyEdits>,
    locals: Query<&Transform>,
    hierarchy: Hierarchy,
) {
    for mut item in &mut bodies {
        let Some(&handle) = world.bodies.get(&item.entity) else {
            world.pending.bodies.push(item.entity);
            continue;
        };
        // The engine looks for edits at every body that was borrowed mutably.
        if !item.is_edited() {
            continue;
        }
        let Some(body) = world.engine.bodies.get_mut(handle) else {
            continue;
        };
        item.edit_settings(body);
        item.edit_velocity(body);
        if item.is_moved() {
            let placed = hierarchy.world_transform(item.entity, |entity| locals.get(entity).ok());
            item.edit_pose(body, &placed);
        }
    }
}

/// Inserts the bodies whose component was inserted since the last step.
pub(crate) fn insert_bodies(
    mut world: ResMut<PhysicsWorld>,
    mut bodies: Query<BodyItem>,
    locals: Query<&Transform>,
    hierarchy: Hierarchy,
    mut commands: Commands,
) {
    let mut seen = EntityHashSet::default();
    for entity in core::mem::take(&mut world.pending.bodies) {
        let Ok(mut item) = bodies.get_mut(entity) else {
            continue;
        };
        if world.bodies.contains_key(&entity) || !seen.insert(entity) {
            continue;
        }
        let local = |entity| locals.get(entity).ok();
        match item.builder(&hierarchy.world_transform(entity, local)).try_build() {
            Ok(mut body) => {
                item.apply_force(&mut body);
                let handle = world.engine.insert_body(body);
                world.bodies.insert(entity, handle);
            }
            Err(reason) => refuse(&mut commands, entity, reason),
        }
        let (transform, velocity) = (*item.transform, *item.velocity);
        item.state.reset(transform);
        item.state.velocity = velocity;
        item.state.parent = hierarchy.parent_transform(entity, local);
    }
}

/// Applies the impulses, once the bodies have the masses of their colliders, and resets the components.
pub(crate) fn apply_impulses(
    mut world: ResMut<PhysicsWorld>,
    mut impulses: Query<(Entity, &mut ExternalImpulse), Changed<ExternalImpulse>>,
) {
    let PhysicsWorld { engine, bodies, .. } = &mut *world;
    for (entity, mut impulse) in &mut impulses {
        let handle = bodies.get(&entity);
        if *impulse == ExternalImpulse::default() || handle.is_none() {
            continue;
        }
        if let Some(body) = handle.and_then(|&handle| engine.bodies.get_mut(handle)) {
            body.recompute_mass_properties_from_colliders(&engine.colliders);
            body.apply_impulse(to_engine(impulse.impulse), true);
            body.apply_torque_impulse(ang_to_engine(impulse.torque_impulse), true);
        }
        *impulse = ExternalImpulse::default();
    }
}

impl BodyItemItem<'_, '_> {
    /// The engine's description of a new body.
    fn builder(&self, placed: &Transform) -> RigidBodyBuilder {
        RigidBodyBuilder::new(self.body.engine_type())
            .pose(pose_of(placed))
            .linvel(to_engine(self.velocity.linear))
            .angvel(ang_to_engine(self.velocity.angular))
            .gravity_scale(self.gravity_scale.0)
            .linear_damping(self.damping.linear)
            .angular_damping(self.damping.angular)
            .locked_axes(self.locked_axes.0)
            .user_data(u128::from(self.entity.to_bits()))
    }

    /// Returns whether the transform has another pose than the plugin wrote.
    fn is_moved(&self) -> bool {
        !has_pose_of(self.transform, &self.state.shown)
    }

    /// Returns whether the engine needs to take over a value. Each step changes transforms and velocities,
    /// too.
    fn is_edited(&self) -> bool {
        self.body.is_changed()
            || self.gravity_scale.is_changed()
            || self.damping.is_changed()
            || self.locked_axes.is_changed()
            || self.force.is_changed()
            || *self.velocity != self.state.velocity
            || self.is_moved()
    }

    fn edit_settings(&self, body: &mut EngineBody) {
        if self.body.is_changed() {
            body.set_body_type(self.body.engine_type(), true);
        }
        if self.gravity_scale.is_changed() {
            body.set_gravity_scale(self.gravity_scale.0, true);
        }
        if self.damping.is_changed() {
            body.set_linear_damping(self.damping.linear);
            body.set_angular_damping(self.damping.angular);
        }
        if self.locked_axes.is_changed() {
            body.set_locked_axes(self.locked_axes.0, true);
        }
        if self.force.is_changed() {
            body.reset_forces(true);
            body.reset_torques(true);
            self.apply_force(body);
        }
    }

    fn edit_velocity(&mut self, body: &mut EngineBody) {
        if *self.velocity != self.state.velocity {
            body.set_linvel(to_engine(self.velocity.linear), true);
            body.set_angvel(ang_to_engine(self.velocity.angular), true);
            self.state.velocity = *self.velocity;
        }
    }

    fn apply_force(&self, body: &mut EngineBody) {
        body.add_force(to_engine(self.force.force), true);
        body.add_torque(ang_to_engine(self.force.torque), true);
    }

    /// Moves a kinematic body during the next step, and any other body at once.
    fn edit_pose(&mut self, body: &mut EngineBody, placed: &Transform) {
        if *self.body == RigidBody::KinematicPosition {
            body.set_next_kinematic_position(pose_of(placed));
            self.state.shown = *self.transform;
        } else {
            body.set_position(pose_of(placed), true);
            let transform = *self.transform;
            self.state.reset(transform);
        }
    }
}
