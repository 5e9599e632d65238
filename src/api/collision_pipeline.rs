//! Collision detection without a simulation.

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
use crate::step::{self, StepScratch, World};

/// The pipeline of collision detection. It computes contacts and intersections, and moves nothing.
///
/// Create one pipeline and reuse it. It has no state, only buffers that later steps reuse.
#[derive(Default)]
pub struct CollisionPipeline {
    /// Times and counts of the last step.
    pub counters: Counters,
    scratch: StepScratch,
}

impl CollisionPipeline {
    /// A pipeline with empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the threads of the steps. The default is the pool of the calling thread.
    pub fn set_threads(&mut self, threads: Threads) {
        self.scratch.set_threads(threads);
    }

    /// Updates all contacts and intersections, and sends the events of those that began or stopped. Impulses
    /// of contacts are 0, because nothing is solved.
    ///
    /// `handle_user_changes` selects whether edits of bodies and colliders since the last step are applied
    /// first. Without it, insertions, moves and removals since then have no effect.
    ///
    /// Invalid parameters (see [`IntegrationParameters::validate`]) are logged as an error, and the step
    /// changes nothing.
    #[expect(
        clippy::too_many_arguments,
        reason = "the documented signature; unpacked here once, named fields from here on"
    )]
    pub fn step(
        &mut self,
        integration_parameters: &IntegrationParameters,
        islands: &mut IslandManager,
        broad_phase: &mut BroadPhaseBvh,
        narrow_phase: &mut NarrowPhase,
        bodies: &mut RigidBodySet,
        colliders: &mut ColliderSet,
        impulse_joints: &ImpulseJointSet,
        multibody_joints: &MultibodyJointSet,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
        handle_user_changes: bool,
    ) {
        if let Err(error) = integration_parameters.validate() {
            log::error!("collision detection refused: {error}");
            return;
        }
        let world = World {
            gravity: Vector::ZERO,
            params: *integration_parameters,
            structure: Structure { bodies, colliders, narrow_phase, islands },
            broad_phase,
            joints: &mut ImpulseJointSet::new(),
            multibodies: &mut MultibodyJointSet::new(),
            hooks,
            events,
        };
        let (counters, scratch) = (&mut self.counters, &mut self.scratch);
        let joints = (impulse_joints, multibody_joints);
        step::detect_collisions(world, joints, counters, scratch, handle_user_changes);
    }
}
