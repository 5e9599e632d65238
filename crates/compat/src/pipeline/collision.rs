//! Collision detection without dynamics.

use super::events::Events;
use super::hooks::Hooks;
use super::{EventHandler, PhysicsHooks};
use crate::dynamics::{
    ImpulseJointSet, IntegrationParameters, IslandManager, MultibodyJointSet, RigidBodySet,
};
use crate::geometry::{BroadPhaseBvh, ColliderSet, NarrowPhase};
use crate::math::Real;

/// Collision detection without dynamics, with its buffers and counters.
#[derive(Default)]
pub struct CollisionPipeline(engine::pipeline::CollisionPipeline);

impl CollisionPipeline {
    /// A pipeline with empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Updates all contacts and intersections, and sends the events of their changes.
    #[expect(clippy::too_many_arguments, reason = "the signature of Rapier")]
    pub fn step(
        &mut self,
        prediction_distance: Real,
        islands: &mut IslandManager,
        broad_phase: &mut BroadPhaseBvh,
        narrow_phase: &mut NarrowPhase,
        bodies: &mut RigidBodySet,
        colliders: &mut ColliderSet,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) {
        let parameters = engine::dynamics::IntegrationParameters {
            normalized_prediction_distance: prediction_distance,
            ..IntegrationParameters::default().to_engine()
        };
        self.0.step(
            &parameters,
            islands,
            broad_phase.begin_step(),
            narrow_phase.begin_step(),
            bodies,
            colliders,
            &ImpulseJointSet::new(),
            &MultibodyJointSet::new(),
            &Hooks(hooks),
            &Events::new(events),
            true,
        );
    }
}
