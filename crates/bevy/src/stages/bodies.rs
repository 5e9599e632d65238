//! User edits of bodies, and new bodies.

use super::edits::{check, check_finite, checked_pose, checked_velocity, refuse_pose};
use super::pose_parts::PoseParts;
use crate::body::{
    BodyState, Damping, ExternalForce, ExternalImpulse, GravityScale, LockedAxes, RigidBody,
    Velocity,
};
use crate::dim::{ang_to_engine, pose_of, to_engine};
use crate::hierarchy::{Hierarchy, Locals};
use crate::invalid::refuse;
use crate::world::PhysicsWorld;
use bevy::ecs::change_detection::{DetectChanges, Ref};
use bevy::ecs::entity::Entity;
use bevy::ecs::query::{Changed, Or, QueryData};
use bevy::ecs::system::{Commands, Query, ResMut};
use bevy::transform::components::Transform;
use rapier::prelude::{InvalidRigidBody, RigidBody as EngineBody, RigidBodyBuilder};

/// All components of a body.
#[derive(QueryData)]
#[query_data(mutable)]
pub(crate) struct BodyItem {
    entity: Entity,
    body: Ref<'static, RigidBody>,
    transform: &'static Transform,
    velocity: &'static mut Velocity,
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

/// Copies the edits since the last step into the engine. An edit of a refused body queues it again.
pub(crate) fn edit_bodies(
    mut world: ResMut<PhysicsWorld>,
    mut bodies: Query<BodyItem, BodyEdits>,
    locals: Locals,
    hierarchy: Hierarchy,
    mut commands: Commands,
) {
    let mut refused = Vec::new();
    for mut item in &mut bodies {
        // A mutable borrow counts as an edit in the engine.
        if !item.is_edited() {
            continue;
        }
        let Some(&handle) = world.bodies.get(&item.entity) else {
            refused.push(item.entity);
            continue;
        };
        let Some(body) = world.engine.bodies.get_mut(handle) else {
            continue;
        };
        item.edit_settings(body, &mut commands);
        let parts = item.edited_parts();
        if parts.is_any() {
            let world_transform =
                hierarchy.world_transform(item.entity, |entity| locals.get(entity).ok());
            item.edit_pose(body, parts, &world_transform, &mut commands);
        }
    }
    world.pending.bodies.extend_sorted(refused);
}

/// Inserts the bodies whose component was inserted since the last step.
pub(crate) fn insert_bodies(
    mut world: ResMut<PhysicsWorld>,
    mut bodies: Query<BodyItem>,
    locals: Locals,
    hierarchy: Hierarchy,
    mut commands: Commands,
) {
    for entity in world.pending.bodies.take() {
        let Ok(mut item) = bodies.get_mut(entity) else {
            continue;
        };
        if world.bodies.contains_key(&entity) {
            continue;
        }
        let local = |entity| locals.get(entity).ok();
        let body = item.builder(&hierarchy.world_transform(entity, local)).try_build();
        match body.and_then(|body| item.check_force().map(|()| body)) {
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
        item.state.carrier = hierarchy.carrier(entity, local);
    }
}

/// Applies the impulses, once the bodies have the masses of their colliders, and resets the components.
pub(crate) fn apply_impulses(
    mut world: ResMut<PhysicsWorld>,
    mut impulses: Query<(Entity, &mut ExternalImpulse)>,
    mut commands: Commands,
) {
    let PhysicsWorld { engine, bodies, .. } = &mut *world;
    for (entity, mut impulse) in &mut impulses {
        if *impulse == ExternalImpulse::default() {
            continue;
        }
        // The impulse of a refused body remains until its insertion.
        let Some(&handle) = bodies.get(&entity) else {
            continue;
        };
        let ExternalImpulse { impulse: linear, torque_impulse } = *impulse;
        let is_finite = linear.is_finite() && torque_impulse.is_finite();
        if let Err(reason) = check_finite(is_finite, "external_impulse", &*impulse) {
            refuse(&mut commands, entity, reason);
        } else if let Some(body) = engine.bodies.get_mut(handle) {
            body.recompute_mass_properties_from_colliders(&engine.colliders);
            body.apply_impulse(to_engine(linear), true);
            body.apply_torque_impulse(ang_to_engine(torque_impulse), true);
        }
        *impulse = ExternalImpulse::default();
    }
}

impl BodyItemItem<'_, '_> {
    /// The engine's description of a new body.
    fn builder(&self, world_transform: &Transform) -> RigidBodyBuilder {
        RigidBodyBuilder::new(self.body.engine_type())
            .pose(pose_of(world_transform))
            .linvel(to_engine(self.velocity.linear))
            .angvel(ang_to_engine(self.velocity.angular))
            .gravity_scale(self.gravity_scale.0)
            .linear_damping(self.damping.linear)
            .angular_damping(self.damping.angular)
            .locked_axes(self.locked_axes.0)
            .user_data(u128::from(self.entity.to_bits()))
    }

    /// The parts of the transform that differ from the last ones which the plugin wrote.
    fn edited_parts(&self) -> PoseParts {
        PoseParts::of_difference(self.transform, &self.state.shown)
    }

    /// Returns whether a value differs from the engine's. Each step changes transforms and velocities, too.
    fn is_edited(&self) -> bool {
        self.body.is_changed()
            || self.gravity_scale.is_changed()
            || self.damping.is_changed()
            || self.locked_axes.is_changed()
            || self.force.is_changed()
            || *self.velocity != self.state.velocity
            || self.edited_parts().is_any()
    }

    fn edit_settings(&mut self, body: &mut EngineBody, commands: &mut Commands) {
        let engine_type = self.body.engine_type();
        let is_other_type = body.body_type() != engine_type;
        if is_other_type {
            body.set_body_type(engine_type, true);
        }
        let mut report = |result: Result<(), InvalidRigidBody>| {
            if let Err(reason) = result {
                refuse(commands, self.entity, reason);
            }
        };
        if self.gravity_scale.is_changed() {
            let scale = self.gravity_scale.0;
            let checked = check(&RigidBodyBuilder::dynamic().gravity_scale(scale));
            report(checked.map(|()| body.set_gravity_scale(scale, true)));
        }
        if self.damping.is_changed() {
            let Damping { linear, angular } = *self.damping;
            let values = RigidBodyBuilder::dynamic().linear_damping(linear);
            report(check(&values.angular_damping(angular)).map(|()| {
                body.set_linear_damping(linear);
                body.set_angular_damping(angular);
            }));
        }
        if self.locked_axes.is_changed() {
            body.set_locked_axes(self.locked_axes.0, true);
        }
        // Bodies that are not dynamic have no force in the engine.
        if self.force.is_changed() || is_other_type {
            report(self.check_force().map(|()| {
                body.reset_forces(true);
                body.reset_torques(true);
                self.apply_force(body);
            }));
        }
        // A fixed body has no velocity in the engine: its component may differ.
        if is_other_type || *self.velocity != self.state.velocity {
            self.edit_velocity(body, commands);
        }
    }

    fn edit_velocity(&mut self, body: &mut EngineBody, commands: &mut Commands) {
        match checked_velocity(&self.velocity) {
            Ok(velocity) => {
                body.set_vels(velocity, true);
                self.state.velocity = *self.velocity;
            }
            Err(reason) => {
                *self.velocity = self.state.velocity;
                refuse(commands, self.entity, reason);
            }
        }
    }

    fn check_force(&self) -> Result<(), InvalidRigidBody> {
        let is_finite = self.force.force.is_finite() && self.force.torque.is_finite();
        check_finite(is_finite, "external_force", &*self.force)
    }

    fn apply_force(&self, body: &mut EngineBody) {
        body.add_force(to_engine(self.force.force), true);
        body.add_torque(ang_to_engine(self.force.torque), true);
    }

    /// Moves a kinematic body during the next step, and any other body at once. A part without an edit keeps
    /// the engine's own number: the transform is rounded to single precision.
    fn edit_pose(
        &mut self,
        body: &mut EngineBody,
        parts: PoseParts,
        world_transform: &Transform,
        commands: &mut Commands,
    ) {
        let mut pose = match checked_pose(world_transform) {
            Ok(pose) => pose,
            Err(reason) => return refuse_pose(commands, self.entity, reason),
        };
        let old = *body.next_position();
        if !parts.translation {
            pose.translation = old.translation;
        }
        if !parts.rotation {
            pose.rotation = old.rotation;
        }
        let edited = *self.transform;
        if *self.body == RigidBody::KinematicPosition {
            body.set_next_kinematic_position(pose);
            parts.copy(&edited, &mut self.state.shown);
        } else {
            body.set_position(pose, true);
            let state = &mut *self.state;
            for written in [&mut state.previous, &mut state.current, &mut state.shown] {
                parts.copy(&edited, written);
            }
        }
    }
}
