//! A world with all of its parts.

use super::{CollisionPipeline, EventHandler, PhysicsHooks, PhysicsPipeline, Quarantine};
#[cfg(feature = "debug-render")]
use super::{DebugRenderBackend, DebugRenderPipeline};
use crate::dynamics::{
    CCDSolver, GenericJoint, ImpulseJoint, ImpulseJointHandle, ImpulseJointSet,
    IntegrationParameters, IslandManager, Multibody, MultibodyJointHandle, MultibodyJointSet,
    MultibodyLink, MultibodyLinkId, RigidBody, RigidBodyHandle, RigidBodySet, SoftBindingError,
    SoftBody, SoftBodyBuilder, SoftBodyHandle, SoftBodySet, SoftBodyTearEvent, SoftClusterRemoval,
    SoftMeshBinding,
};
use crate::geometry::{BroadPhaseBvh, Collider, ColliderHandle, ColliderSet, NarrowPhase};
use crate::math::{DIM, Vector};

/// A world with all of its parts, and functions that pass them.
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct PhysicsWorld {
    /// Gravitational acceleration (length/s²).
    pub gravity: Vector,
    /// Parameters of a step.
    pub integration_parameters: IntegrationParameters,
    /// The simulation step.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub physics_pipeline: PhysicsPipeline,
    /// Collision detection without dynamics.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub collision_pipeline: CollisionPipeline,
    /// Islands of connected bodies.
    pub islands: IslandManager,
    /// Broad phase.
    pub broad_phase: BroadPhaseBvh,
    /// Narrow phase.
    pub narrow_phase: NarrowPhase,
    /// All bodies.
    pub bodies: RigidBodySet,
    /// All colliders.
    pub colliders: ColliderSet,
    /// All impulse joints.
    pub impulse_joints: ImpulseJointSet,
    /// All multibodies.
    pub multibody_joints: MultibodyJointSet,
    /// Soft bodies: none.
    pub soft_bodies: SoftBodySet,
    /// Continuous collision detection.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub ccd_solver: CCDSolver,
}

impl Default for PhysicsWorld {
    fn default() -> Self {
        Self {
            gravity: Vector::Y * -9.81,
            integration_parameters: IntegrationParameters::default(),
            physics_pipeline: PhysicsPipeline::default(),
            collision_pipeline: CollisionPipeline::default(),
            islands: IslandManager::default(),
            broad_phase: BroadPhaseBvh::default(),
            narrow_phase: NarrowPhase::default(),
            bodies: RigidBodySet::default(),
            colliders: ColliderSet::default(),
            impulse_joints: ImpulseJointSet::default(),
            multibody_joints: MultibodyJointSet::default(),
            soft_bodies: SoftBodySet,
            ccd_solver: CCDSolver,
        }
    }
}

/// Steps, bodies and colliders.
impl PhysicsWorld {
    /// An empty world with gravity along -y.
    pub fn new() -> Self {
        Self::default()
    }

    /// Moves the simulation forward by a step.
    pub fn step(&mut self) {
        self.step_with_events(&(), &());
    }

    /// Moves the simulation forward by a step, with hooks and events.
    pub fn step_with_events(&mut self, hooks: &dyn PhysicsHooks, events: &dyn EventHandler) {
        self.physics_pipeline.step(
            self.gravity,
            &self.integration_parameters,
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.soft_bodies,
            &mut self.ccd_solver,
            hooks,
            events,
        );
    }

    /// Updates contacts and intersections, and sends the events of their changes.
    pub fn detect_collisions(&mut self, hooks: &dyn PhysicsHooks, events: &dyn EventHandler) {
        self.collision_pipeline.step(
            self.integration_parameters.prediction_distance(),
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            hooks,
            events,
        );
    }

    /// The bodies that the last step disabled.
    pub fn quarantine(&self) -> &Quarantine {
        self.physics_pipeline.quarantine()
    }

    /// Inserts a body with a collider.
    pub fn insert(
        &mut self,
        body: impl Into<RigidBody>,
        collider: impl Into<Collider>,
    ) -> (RigidBodyHandle, ColliderHandle) {
        let body = self.bodies.insert(body);
        (body, self.insert_collider(collider, Some(body)))
    }

    /// Inserts a body.
    pub fn insert_body(&mut self, body: impl Into<RigidBody>) -> RigidBodyHandle {
        self.bodies.insert(body)
    }

    /// Removes a body with its colliders and joints.
    pub fn remove_body(&mut self, handle: RigidBodyHandle) -> Option<RigidBody> {
        self.remove_body_with_colliders(handle, true)
    }

    /// Removes a body with its joints. Its colliders are removed too, or they stay where they are.
    pub fn remove_body_with_colliders(
        &mut self,
        handle: RigidBodyHandle,
        remove_attached_colliders: bool,
    ) -> Option<RigidBody> {
        self.bodies.remove(
            handle,
            &mut self.islands,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.soft_bodies,
            remove_attached_colliders,
        )
    }

    /// Wakes a body.
    pub fn wake_up(&mut self, handle: RigidBodyHandle, strong: bool) {
        self.islands.wake_up(&mut self.bodies, handle, strong);
    }

    /// Wakes all bodies.
    pub fn wake_up_all(&mut self, strong: bool) {
        let handles: Vec<_> = self.bodies.iter().map(|(handle, _)| handle).collect();
        handles.into_iter().for_each(|handle| self.wake_up(handle, strong));
    }

    /// Inserts a collider, with or without a body.
    pub fn insert_collider(
        &mut self,
        collider: impl Into<Collider>,
        parent: Option<RigidBodyHandle>,
    ) -> ColliderHandle {
        match parent {
            Some(body) => self.colliders.insert_with_parent(collider, body, &mut self.bodies),
            None => self.colliders.insert(collider),
        }
    }

    /// Removes a collider.
    pub fn remove_collider(&mut self, handle: ColliderHandle) -> Option<Collider> {
        let Self { islands, bodies, soft_bodies, .. } = self;
        self.colliders.remove(handle, islands, bodies, soft_bodies, true)
    }

    /// All bodies.
    pub fn rigid_bodies(&self) -> impl Iterator<Item = (RigidBodyHandle, &RigidBody)> {
        self.bodies.iter()
    }

    /// All bodies, mutably.
    pub fn rigid_bodies_mut(&mut self) -> impl Iterator<Item = (RigidBodyHandle, &mut RigidBody)> {
        self.bodies.iter_mut()
    }

    /// The bodies that are awake and not fixed.
    pub fn active_bodies(&self) -> impl Iterator<Item = (RigidBodyHandle, &RigidBody)> + '_ {
        let handles = self.islands.active_bodies();
        handles.filter_map(|handle| Some((handle, self.bodies.get(handle)?)))
    }

    /// All colliders.
    pub fn all_colliders(&self) -> impl Iterator<Item = (ColliderHandle, &Collider)> {
        self.colliders.iter()
    }

    /// All colliders, mutably.
    pub fn all_colliders_mut(&mut self) -> impl Iterator<Item = (ColliderHandle, &mut Collider)> {
        self.colliders.iter_mut()
    }

    /// Draws the world as lines.
    #[cfg(feature = "debug-render")]
    pub fn debug_render(
        &self,
        pipeline: &mut DebugRenderPipeline,
        backend: &mut impl DebugRenderBackend,
    ) {
        pipeline.render(
            backend,
            &self.bodies,
            &self.colliders,
            &self.impulse_joints,
            &self.multibody_joints,
            &self.narrow_phase,
            &self.soft_bodies,
        );
    }
}

/// Joints.
impl PhysicsWorld {
    /// Inserts an impulse joint.
    pub fn insert_impulse_joint(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        joint: impl Into<GenericJoint>,
    ) -> ImpulseJointHandle {
        self.impulse_joints.insert(body1, body2, joint, true)
    }

    /// Removes an impulse joint.
    pub fn remove_impulse_joint(&mut self, handle: ImpulseJointHandle) -> Option<GenericJoint> {
        self.impulse_joints.remove(handle, true).map(|joint| joint.data)
    }

    /// All impulse joints.
    pub fn impulse_joints(&self) -> impl Iterator<Item = (ImpulseJointHandle, &ImpulseJoint)> {
        self.impulse_joints.iter()
    }

    /// All impulse joints of a body.
    pub fn impulse_joints_with(
        &self,
        body: RigidBodyHandle,
    ) -> impl Iterator<Item = (RigidBodyHandle, RigidBodyHandle, ImpulseJointHandle, &ImpulseJoint)>
    {
        self.impulse_joints.attached_joints(body)
    }

    /// Inserts a multibody joint.
    pub fn insert_multibody_joint(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        joint: impl Into<GenericJoint>,
    ) -> Option<MultibodyJointHandle> {
        self.multibody_joints.insert(body1, body2, joint, true)
    }

    /// Removes a multibody joint.
    pub fn remove_multibody_joint(&mut self, handle: MultibodyJointHandle) {
        self.multibody_joints.remove(handle, true);
    }

    /// All multibody joints.
    pub fn multibody_joints(
        &self,
    ) -> impl Iterator<Item = (MultibodyJointHandle, &MultibodyLinkId, &Multibody, &MultibodyLink)>
    {
        self.multibody_joints.iter()
    }

    /// All multibody joints of a body.
    pub fn multibody_joints_with(
        &self,
        body: RigidBodyHandle,
    ) -> impl Iterator<Item = (RigidBodyHandle, RigidBodyHandle, MultibodyJointHandle)> + '_ {
        self.multibody_joints.attached_joints(body)
    }
}

/// Soft bodies. The engine has none: no call has an effect.
impl PhysicsWorld {
    /// Logs an error and returns an invalid handle.
    pub fn insert_soft_body(&mut self, soft_body: SoftBodyBuilder) -> SoftBodyHandle {
        self.soft_bodies.insert(soft_body, &mut self.bodies, &mut self.colliders)
    }

    /// Inserts nothing.
    ///
    /// # Errors
    /// Always.
    pub fn insert_deformable(
        &mut self,
        collider: impl Into<Collider>,
        binding: SoftMeshBinding,
        parent: RigidBodyHandle,
    ) -> Result<ColliderHandle, SoftBindingError> {
        let Self { bodies, soft_bodies, .. } = self;
        self.colliders.insert_deformable(collider, binding, parent, bodies, soft_bodies)
    }

    /// Removes nothing.
    pub fn remove_soft_body(&mut self, _handle: SoftBodyHandle) -> Option<SoftBody> {
        None
    }

    /// Cuts nothing.
    pub fn cut_soft_body(
        &mut self,
        _handle: SoftBodyHandle,
        _blade: &[Vector; DIM],
    ) -> Option<SoftBodyTearEvent> {
        None
    }

    /// Tears nothing.
    pub fn tear_soft_body(
        &mut self,
        _handle: SoftBodyHandle,
        _edges: &[u32],
        _cells: &[u32],
    ) -> Option<SoftBodyTearEvent> {
        None
    }

    /// Adds nothing.
    pub fn add_soft_body_cluster(
        &mut self,
        _handle: SoftBodyHandle,
        _particles: &[u32],
    ) -> Option<u32> {
        None
    }

    /// Removes nothing.
    pub fn remove_soft_body_cluster(
        &mut self,
        _handle: SoftBodyHandle,
        _cluster: u32,
    ) -> Option<SoftClusterRemoval> {
        None
    }

    /// All soft bodies: none.
    pub fn soft_bodies(&self) -> impl Iterator<Item = (SoftBodyHandle, &SoftBody)> {
        self.soft_bodies.iter()
    }
}

/// Threads.
#[cfg(feature = "parallel")]
impl PhysicsWorld {
    /// Creates a pool of threads for the steps.
    ///
    /// # Errors
    /// If the threads cannot be created.
    pub fn configure_thread_pool(
        &mut self,
        num_threads: usize,
    ) -> Result<(), rayon::ThreadPoolBuildError> {
        self.physics_pipeline.configure_thread_pool(num_threads)
    }

    /// The pool of the steps; `None` for the pool of the calling thread.
    pub fn thread_pool(&self) -> Option<std::sync::Arc<rayon::ThreadPool>> {
        self.physics_pipeline.thread_pool()
    }

    /// Sets the pool of the steps.
    pub fn set_thread_pool(&mut self, pool: Option<std::sync::Arc<rayon::ThreadPool>>) {
        self.physics_pipeline.set_thread_pool(pool);
    }

    /// Selects the pool of the calling thread.
    pub fn clear_thread_pool(&mut self) {
        self.physics_pipeline.clear_thread_pool();
    }

    /// Number of threads of the pool of the steps.
    pub fn num_threads(&self) -> Option<usize> {
        self.physics_pipeline.num_threads()
    }
}
