//! The step of a whole simulation.

use crate::base::measure::is_point;
use crate::base::tasks::Threads;
use crate::dim::math::Vector;
use crate::model::body::RigidBodySet;
use crate::model::collider::ColliderSet;
use crate::model::contact::NarrowPhase;
use crate::model::counters::Counters;
use crate::model::event::EventHandler;
use crate::model::hooks::PhysicsHooks;
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;
use crate::model::params::IntegrationParameters;
use crate::model::structure::Structure;
use crate::model::tree::BroadPhaseBvh;
use crate::step::{self, StepScratch, StepStage, World};
use core::borrow::Borrow;

/// The pipeline that steps a simulation.
///
/// Create one pipeline and reuse it. It has no state of the simulation, only buffers that later steps reuse.
/// All state is in the arguments of [`Self::step`]; [`PhysicsWorld`](crate::pipeline::PhysicsWorld) contains
/// them.
#[derive(Default)]
pub struct PhysicsPipeline {
    /// Times and counts of the last step.
    pub counters: Counters,
    scratch: StepScratch,
}

impl PhysicsPipeline {
    /// A pipeline with empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the threads of the steps. The default is the pool of the calling thread.
    pub fn set_threads(&mut self, threads: Threads) {
        self.scratch.set_threads(threads);
    }

    /// Selects the widest instructions of the machine for the solver (the default), or the baseline of its
    /// architecture.
    ///
    /// The selection changes the speed but no bit of the results. It serves to test this property.
    pub fn set_wide_instructions(&mut self, wide: bool) {
        self.scratch.set_wide_instructions(wide);
    }

    /// Sets whether every step hashes the world after each stage (default: no). A hash of 1000 bodies in
    /// contact takes about a hundredth of their step.
    pub fn set_stage_hashes(&mut self, enabled: bool) {
        self.scratch.trace_stages(enabled);
    }

    /// The hashes of the world after the stages of the last step, in their order. The first unequal hash of
    /// two runs names the stage of their divergence. Empty unless [enabled](Self::set_stage_hashes). A stage
    /// occurs twice if the step was repeated because a body diverged.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let mut world = PhysicsWorld::new();
    /// world.physics_pipeline.set_stage_hashes(true);
    /// world.insert_body(RigidBodyBuilder::dynamic().additional_mass(1.0));
    /// world.step();
    /// let hashes = world.physics_pipeline.stage_hashes();
    /// assert_eq!(hashes.last(), Some(&(StepStage::Sleep, world.hash())));
    /// ```
    pub fn stage_hashes(&self) -> &[(StepStage, u64)] {
        self.scratch.stage_hashes()
    }

    /// Moves the simulation forward by [`IntegrationParameters::dt`].
    ///
    /// `gravity` is an acceleration in world space (length/s²), such as `(0, -9.81)` or `(0, -9.81, 0)`; the
    /// argument can be `gravity` or `&gravity`. The sets, `islands`, `broad_phase` and `narrow_phase` belong
    /// together from the first step on. They refer to each other, and the references are invalid in other
    /// sets. If one of them was not part of the last step, the step logs a warning and treats all elements as
    /// new. All bodies wake, colliders and joints of missing bodies are removed, and contacts end and begin
    /// again.
    ///
    /// Invalid parameters (see [`IntegrationParameters::validate`]), and a gravity that is not finite or
    /// above 1e15, are logged as an error, and the step changes nothing.
    #[expect(
        clippy::too_many_arguments,
        reason = "the documented signature; unpacked here once, named fields from here on"
    )]
    pub fn step(
        &mut self,
        gravity: impl Borrow<Vector>,
        integration_parameters: &IntegrationParameters,
        islands: &mut IslandManager,
        broad_phase: &mut BroadPhaseBvh,
        narrow_phase: &mut NarrowPhase,
        bodies: &mut RigidBodySet,
        colliders: &mut ColliderSet,
        impulse_joints: &mut ImpulseJointSet,
        multibody_joints: &mut MultibodyJointSet,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) {
        let gravity = *gravity.borrow();
        if !is_point(gravity) {
            log::error!(
                "step refused: gravity is {gravity:?}, but its components must be at most 1e15"
            );
            return;
        }
        if let Err(error) = integration_parameters.validate() {
            log::error!("step refused: {error}");
            return;
        }
        let world = World {
            gravity,
            params: *integration_parameters,
            structure: Structure { bodies, colliders, narrow_phase, islands },
            broad_phase,
            joints: impulse_joints,
            multibodies: multibody_joints,
            hooks,
            events,
        };
        step::step(world, &mut self.counters, &mut self.scratch);
    }
}
