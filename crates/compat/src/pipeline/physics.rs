//! The simulation step.

use super::events::Events;
use super::hooks::Hooks;
#[cfg(rapier036)]
use super::physics036::Quarantine;
use super::{EventHandler, PhysicsHooks};
use crate::counters::Counters;
use crate::dynamics::{
    CCDSolver, ImpulseJointSet, IntegrationParameters, IslandManager, MultibodyJointSet,
    RigidBodySet,
};
use crate::geometry::{BroadPhaseBvh, ColliderSet, NarrowPhase};
use crate::math::Vector;

/// The simulation step, with its buffers and counters.
#[derive(Default)]
pub struct PhysicsPipeline {
    engine: engine::pipeline::PhysicsPipeline,
    /// Times and counts of the last step.
    pub counters: Counters,
    #[cfg(rapier036)]
    quarantine: Quarantine,
    #[cfg(all(rapier036, feature = "parallel"))]
    thread_pool: Option<std::sync::Arc<rayon::ThreadPool>>,
}

impl core::ops::Deref for PhysicsPipeline {
    type Target = engine::pipeline::PhysicsPipeline;

    fn deref(&self) -> &engine::pipeline::PhysicsPipeline {
        &self.engine
    }
}

impl core::ops::DerefMut for PhysicsPipeline {
    fn deref_mut(&mut self) -> &mut engine::pipeline::PhysicsPipeline {
        &mut self.engine
    }
}

impl PhysicsPipeline {
    /// A pipeline with empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Moves the simulation forward by [`IntegrationParameters::dt`].
    #[expect(clippy::too_many_arguments, reason = "the signature of Rapier")]
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
        #[cfg(rapier036)] _soft_bodies: &mut crate::dynamics::SoftBodySet,
        _ccd_solver: &mut CCDSolver,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) {
        self.counters.prepare_engine(&mut self.engine.counters);
        let recorder = Events::new(events);
        let engine = &mut self.engine;
        let mut step = || {
            engine.step(
                gravity,
                &integration_parameters.to_engine(),
                islands,
                broad_phase.begin_step(),
                narrow_phase.begin_step(),
                bodies,
                colliders,
                impulse_joints,
                multibody_joints.begin_step(),
                &Hooks(hooks),
                &recorder,
            );
        };
        #[cfg(all(rapier036, feature = "parallel"))]
        match &self.thread_pool {
            Some(pool) => pool.install(step),
            None => step(),
        }
        #[cfg(not(all(rapier036, feature = "parallel")))]
        step();
        #[cfg(rapier036)]
        {
            self.quarantine.bodies = recorder.into_quarantined();
        }
        self.counters.copy_from_engine(&self.engine.counters);
    }
}

#[cfg(rapier036)]
impl PhysicsPipeline {
    /// The bodies that the last step disabled.
    pub fn quarantine(&self) -> &Quarantine {
        &self.quarantine
    }
}

/// Threads of the steps.
#[cfg(all(rapier036, feature = "parallel"))]
impl PhysicsPipeline {
    /// Creates a pool of threads for the steps.
    ///
    /// # Errors
    /// If the threads cannot be created.
    pub fn configure_thread_pool(
        &mut self,
        num_threads: usize,
    ) -> Result<(), rayon::ThreadPoolBuildError> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(num_threads).build()?;
        self.set_thread_pool(Some(std::sync::Arc::new(pool)));
        Ok(())
    }

    /// The pool of the steps; `None` for the pool of the calling thread.
    pub fn thread_pool(&self) -> Option<std::sync::Arc<rayon::ThreadPool>> {
        self.thread_pool.clone()
    }

    /// Sets the pool of the steps.
    pub fn set_thread_pool(&mut self, pool: Option<std::sync::Arc<rayon::ThreadPool>>) {
        self.thread_pool = pool;
    }

    /// Selects the pool of the calling thread.
    pub fn clear_thread_pool(&mut self) {
        self.thread_pool = None;
    }

    /// Number of threads of the pool of the steps.
    pub fn num_threads(&self) -> Option<usize> {
        self.thread_pool.as_ref().map(|pool| pool.current_num_threads())
    }
}
