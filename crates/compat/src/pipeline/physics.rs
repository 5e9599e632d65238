//! The simulation step.

use super::events::Events;
use super::hooks::Hooks;
use super::{EventHandler, PhysicsHooks};
use crate::dynamics::{
    CCDSolver, ImpulseJointSet, IntegrationParameters, IslandManager, MultibodyJointSet,
    RigidBodySet,
};
use crate::geometry::{BroadPhaseBvh, ColliderSet, NarrowPhase};
use crate::math::Vector;
use crate::wrapper::forward;

/// The simulation step, with its buffers and counters.
#[derive(Default)]
pub struct PhysicsPipeline(engine::pipeline::PhysicsPipeline);

forward!(PhysicsPipeline, engine::pipeline::PhysicsPipeline);

impl PhysicsPipeline {
    /// A pipeline with empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Moves the simulation forward by [`IntegrationParameters::dt`].
    #[expect(clippy::too_many_arguments, reason = "the signature of Rapier 0.32")]
    pub fn step(
        &mut self,
        gravity: Vector,
        integration_parameters: &IntegrationParameters,
        islands: &mut IslandManager,
        broad_phase: &mut BroadPhaseBvh,
        narrow_phase: &mut NarrowPhase,
        bodies: &mut RigidBodySet,
        colliders: &mut ColliderSet,
        impulse_joints: &mut ImpulseJointSet,
        multibody_joints: &mut MultibodyJointSet,
        _ccd_solver: &mut CCDSolver,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) {
        self.0.step(
            gravity,
            &integration_parameters.to_engine(),
            islands,
            broad_phase,
            narrow_phase.begin_step(),
            bodies,
            colliders,
            impulse_joints,
            multibody_joints,
            &Hooks(hooks),
            &Events(events),
        );
    }
}
