//! A whole simulation in one value.

use super::collision_pipeline::CollisionPipeline;
use super::physics_pipeline::PhysicsPipeline;
use crate::dim::math::Vector;
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::collider::{Collider, ColliderHandle, ColliderSet};
use crate::model::contact::{ContactPair, NarrowPhase};
use crate::model::event::EventHandler;
use crate::model::hooks::PhysicsHooks;
use crate::model::island::IslandManager;
use crate::model::joint::{
    GenericJoint, ImpulseJoint, ImpulseJointHandle, ImpulseJointSet, InvalidJoint,
};
use crate::model::multibody::{
    Multibody, MultibodyJoint, MultibodyJointHandle, MultibodyJointSet, MultibodyLink,
    MultibodyLinkId,
};
use crate::model::params::IntegrationParameters;
use crate::model::state_hash::{WorldSets, world_hash};
use crate::model::tree::BroadPhaseBvh;

/// A whole simulation: bodies, colliders, and all further sets of a step.
///
/// The fields are public, and the methods are shortcuts for common operations.
pub struct PhysicsWorld {
    /// Acceleration of all dynamic bodies, in world space (length/s²). 9.81 along -y by default.
    pub gravity: Vector,
    /// Length of a step, and settings of the solver.
    pub integration_parameters: IntegrationParameters,
    /// Awake bodies and islands.
    pub islands: IslandManager,
    /// The broad phase: the pairs of nearby colliders.
    pub broad_phase: BroadPhaseBvh,
    /// The contacts of these pairs.
    pub narrow_phase: NarrowPhase,
    /// The bodies.
    pub bodies: RigidBodySet,
    /// The colliders.
    pub colliders: ColliderSet,
    /// The joints that the solver enforces by impulses.
    pub impulse_joints: ImpulseJointSet,
    /// The joints that make bodies links of a multibody.
    pub multibody_joints: MultibodyJointSet,
    /// Buffers and counters of the step.
    pub physics_pipeline: PhysicsPipeline,
    /// Buffers and counters of [`Self::detect_collisions`].
    pub collision_pipeline: CollisionPipeline,
}

impl Default for PhysicsWorld {
    fn default() -> Self {
        Self::new()
    }
}

/// Copies all state of a world. The copy continues bit for bit like the original.
///
/// `clone_from` reuses the memory of an earlier copy: this is the fast way to save a world and to return to
/// it, for rollback. It allocates no memory unless a list has grown since. Pipelines have buffers and
/// settings but no state: a clone has new pipelines, and `clone_from` keeps those of the target.
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut world = PhysicsWorld::new();
/// world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
/// let mut saved = world.clone();
/// (0..10).for_each(|_| world.step());
/// let first = world.hash();
/// world.clone_from(&saved); // back
/// (0..10).for_each(|_| world.step());
/// assert_eq!(world.hash(), first);
/// saved.clone_from(&world); // saves again, into the same memory
/// ```
impl Clone for PhysicsWorld {
    fn clone(&self) -> Self {
        Self {
            gravity: self.gravity,
            integration_parameters: self.integration_parameters,
            islands: self.islands.clone(),
            broad_phase: self.broad_phase.clone(),
            narrow_phase: self.narrow_phase.clone(),
            bodies: self.bodies.clone(),
            colliders: self.colliders.clone(),
            impulse_joints: self.impulse_joints.clone(),
            multibody_joints: self.multibody_joints.clone(),
            physics_pipeline: PhysicsPipeline::new(),
            collision_pipeline: CollisionPipeline::new(),
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.gravity = source.gravity;
        self.integration_parameters = source.integration_parameters;
        self.islands.clone_from(&source.islands);
        self.broad_phase.clone_from(&source.broad_phase);
        self.narrow_phase.clone_from(&source.narrow_phase);
        self.bodies.clone_from(&source.bodies);
        self.colliders.clone_from(&source.colliders);
        self.impulse_joints.clone_from(&source.impulse_joints);
        self.multibody_joints.clone_from(&source.multibody_joints);
    }
}

impl PhysicsWorld {
    /// An empty world with the gravity of the earth along -y.
    pub fn new() -> Self {
        Self {
            gravity: Vector::Y * -9.81,
            integration_parameters: IntegrationParameters::default(),
            islands: IslandManager::new(),
            broad_phase: BroadPhaseBvh::new(),
            narrow_phase: NarrowPhase::new(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            impulse_joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            physics_pipeline: PhysicsPipeline::new(),
            collision_pipeline: CollisionPipeline::new(),
        }
    }

    /// Moves the world forward by one time step, without hooks and events.
    pub fn step(&mut self) {
        self.step_with_events(&(), &());
    }

    /// Moves the world forward by one time step.
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
            hooks,
            events,
        );
    }

    /// Updates contacts and intersections after edits, and moves nothing.
    pub fn detect_collisions(&mut self, hooks: &dyn PhysicsHooks, events: &dyn EventHandler) {
        self.collision_pipeline.step(
            &self.integration_parameters,
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &self.impulse_joints,
            &self.multibody_joints,
            hooks,
            events,
            true,
        );
    }

    /// A hash of the simulated state: of all bodies, colliders, joints and pairs with their handles. Equal
    /// bits give equal hashes on every machine, so two runs compare one number per step.
    ///
    /// The hashes of the sets and of single elements ([`RigidBody::hash`]) locate a difference.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let run = || {
    ///     let mut world = PhysicsWorld::new();
    ///     world.insert(RigidBodyBuilder::dynamic().rotation(vector![0.3, 0.2, 0.1]), ColliderBuilder::ball(0.5));
    ///     (0..10).map(|_| { world.step(); world.hash() }).collect::<Vec<u64>>()
    /// };
    /// assert_eq!(run(), run());
    /// ```
    pub fn hash(&self) -> u64 {
        world_hash(&WorldSets {
            bodies: &self.bodies,
            colliders: &self.colliders,
            impulse_joints: &self.impulse_joints,
            multibody_joints: &self.multibody_joints,
            narrow_phase: &self.narrow_phase,
        })
    }

    /// Adds a body with one collider.
    pub fn insert(
        &mut self,
        body: impl Into<RigidBody>,
        collider: impl Into<Collider>,
    ) -> (RigidBodyHandle, ColliderHandle) {
        let body = self.insert_body(body);
        (body, self.colliders.insert_with_parent(collider, body, &mut self.bodies))
    }

    /// Adds a body.
    pub fn insert_body(&mut self, body: impl Into<RigidBody>) -> RigidBodyHandle {
        self.bodies.insert(body)
    }

    /// Adds a collider. With a body, it follows the motion of the body; without one, it stays at its pose.
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

    /// Removes a body and returns it; `None` if the handle is stale. The next step removes its colliders and
    /// wakes the bodies that rested on it.
    pub fn remove_body(&mut self, handle: RigidBodyHandle) -> Option<RigidBody> {
        self.bodies.remove(handle)
    }

    /// Removes a collider and returns it; `None` if the handle is stale. Its body wakes.
    pub fn remove_collider(&mut self, handle: ColliderHandle) -> Option<Collider> {
        self.colliders.remove(handle, &mut self.islands, &mut self.bodies, true)
    }

    /// Inserts a joint between two bodies, and wakes them. [`ImpulseJointSet::insert`] documents the
    /// treatment of invalid joints.
    pub fn insert_impulse_joint(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        joint: impl Into<GenericJoint>,
    ) -> ImpulseJointHandle {
        self.impulse_joints.insert(body1, body2, joint, true)
    }

    /// The same as [`Self::insert_impulse_joint`].
    ///
    /// # Errors
    /// If a body is missing, the bodies are the same, or neither is dynamic. If a number of the joint is not
    /// usable.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let mut world = PhysicsWorld::new();
    /// let [post, wall] = [0, 1].map(|_| world.insert_body(RigidBodyBuilder::fixed()));
    /// let refused = world.try_insert_impulse_joint(post, wall, FixedJoint::new());
    /// assert_eq!(refused, Err(InvalidJoint::NoDynamicBody { body1: post, body2: wall }));
    /// ```
    pub fn try_insert_impulse_joint(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        joint: impl Into<GenericJoint>,
    ) -> Result<ImpulseJointHandle, InvalidJoint> {
        self.check_joined(body1, body2)?;
        self.impulse_joints.try_insert(body1, body2, joint, true)
    }

    /// Returns whether a joint can connect these bodies.
    fn check_joined(
        &self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
    ) -> Result<(), InvalidJoint> {
        let find = |body| self.bodies.get(body).ok_or(InvalidJoint::MissingBody { body });
        let (first, second) = (find(body1)?, find(body2)?);
        if body1 != body2 && !first.is_dynamic() && !second.is_dynamic() {
            return Err(InvalidJoint::NoDynamicBody { body1, body2 });
        }
        Ok(())
    }

    /// Removes a joint and returns it; its bodies wake. `None` if the handle is stale.
    pub fn remove_impulse_joint(&mut self, handle: ImpulseJointHandle) -> Option<ImpulseJoint> {
        self.impulse_joints.remove(handle, true)
    }

    /// All impulse joints with their handles, in the order of their slots.
    pub fn impulse_joints(&self) -> impl Iterator<Item = (ImpulseJointHandle, &ImpulseJoint)> {
        self.impulse_joints.iter()
    }

    /// The impulse joints of a body with their handles, in the order of insertion.
    pub fn impulse_joints_with(
        &self,
        body: RigidBodyHandle,
    ) -> impl Iterator<Item = (ImpulseJointHandle, &ImpulseJoint)> {
        self.impulse_joints.attached_joints(body).map(|(_, _, handle, joint)| (handle, joint))
    }

    /// Makes `body2` a child of `body1` in a multibody, and wakes both. `None` for an invalid joint: see
    /// [`MultibodyJointSet::insert`].
    pub fn insert_multibody_joint(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        joint: impl Into<GenericJoint>,
    ) -> Option<MultibodyJointHandle> {
        let handle = self.multibody_joints.insert(body1, body2, joint, true)?;
        self.preview_links(body2);
        Some(handle)
    }

    /// The same as [`Self::insert_multibody_joint`].
    ///
    /// # Errors
    /// If a body is missing, the bodies are the same, or neither is dynamic. If `body2` already has a parent
    /// or is an ancestor of `body1`. If a number of the joint is not usable.
    pub fn try_insert_multibody_joint(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        joint: impl Into<GenericJoint>,
    ) -> Result<MultibodyJointHandle, InvalidJoint> {
        self.check_joined(body1, body2)?;
        let handle = self.multibody_joints.try_insert(body1, body2, joint, true)?;
        self.preview_links(body2);
        Ok(handle)
    }

    /// Removes a multibody joint and returns it; its bodies wake. `None` if the handle is stale.
    pub fn remove_multibody_joint(
        &mut self,
        handle: MultibodyJointHandle,
    ) -> Option<MultibodyJoint> {
        let child = self.multibody_joints.get_link(handle)?.rigid_body_handle();
        let joint = self.multibody_joints.remove(handle, true)?;
        self.preview_links(child);
        Some(joint)
    }

    /// Brings new links up to date with their bodies: that of a body, and later ones of its multibody.
    fn preview_links(&mut self, body: RigidBodyHandle) {
        if let Some(&MultibodyLinkId { multibody, id }) =
            self.multibody_joints.rigid_body_link(body)
            && let Some(multibody) = self.multibody_joints.get_unnoted_mut(multibody)
        {
            multibody.preview(id, &self.bodies);
        }
    }

    /// All multibody joints, in the order of their slots: handle, multibody, link.
    pub fn multibody_joints(
        &self,
    ) -> impl Iterator<Item = (MultibodyJointHandle, &Multibody, &MultibodyLink)> {
        self.multibody_joints.iter().map(|(handle, _, multibody, link)| (handle, multibody, link))
    }

    /// The multibody joints of a body, as (parent, child, handle): the one to its parent first.
    pub fn multibody_joints_with(
        &self,
        body: RigidBodyHandle,
    ) -> impl Iterator<Item = (RigidBodyHandle, RigidBodyHandle, MultibodyJointHandle)> {
        self.multibody_joints.attached_joints(body)
    }

    /// Wakes a body and its island at once. If the body is awake, `strong` restarts its time until sleep. A
    /// stale handle has no effect.
    pub fn wake_up(&mut self, handle: RigidBodyHandle, strong: bool) {
        self.islands.wake_up(&mut self.bodies, handle, strong);
    }

    /// Wakes all bodies.
    pub fn wake_up_all(&mut self, strong: bool) {
        for (_, body) in self.bodies.iter_mut() {
            if body.is_sleeping() {
                body.wake_up(strong);
            }
        }
    }

    /// Handles of the awake dynamic and kinematic bodies.
    pub fn active_bodies(&self) -> &[RigidBodyHandle] {
        self.islands.active_bodies()
    }

    /// All pairs of solid colliders whose fat AABBs overlap, as (first collider, second collider, pair).
    pub fn contact_pairs(
        &self,
    ) -> impl Iterator<Item = (ColliderHandle, ColliderHandle, &ContactPair)> {
        self.narrow_phase.contact_pairs()
    }

    /// The contacts of two colliders, given in either order; `None` if their fat AABBs do not overlap.
    pub fn contact_pair(
        &self,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
    ) -> Option<&ContactPair> {
        self.narrow_phase.contact_pair(collider1, collider2)
    }

    /// The contacts of one collider.
    pub fn contact_pairs_with(
        &self,
        collider: ColliderHandle,
    ) -> impl Iterator<Item = &ContactPair> {
        self.narrow_phase.contact_pairs_with(collider)
    }

    /// All pairs with a sensor whose fat AABBs overlap, as (first collider, second collider, whether they
    /// intersect).
    pub fn intersection_pairs(
        &self,
    ) -> impl Iterator<Item = (ColliderHandle, ColliderHandle, bool)> {
        self.narrow_phase.intersection_pairs()
    }

    /// Returns whether two colliders intersect, at least one of them a sensor. `None` if their fat AABBs do
    /// not overlap.
    pub fn intersection_pair(
        &self,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
    ) -> Option<bool> {
        self.narrow_phase.intersection_pair(collider1, collider2)
    }

    /// The sensor pairs of one collider, as (first collider, second collider, whether they intersect).
    pub fn intersection_pairs_with(
        &self,
        collider: ColliderHandle,
    ) -> impl Iterator<Item = (ColliderHandle, ColliderHandle, bool)> {
        self.narrow_phase.intersection_pairs_with(collider)
    }
}

#[cfg(feature = "debug-render")]
impl PhysicsWorld {
    /// Draws the world as lines, with the mode and style of the pipeline.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// struct Lines(Vec<[Vector; 2]>);
    ///
    /// impl DebugRenderBackend for Lines {
    ///     fn draw_line(&mut self, _: DebugRenderObject, a: Vector, b: Vector, _: DebugColor) {
    ///         self.0.push([a, b]);
    ///     }
    /// }
    ///
    /// let mut world = PhysicsWorld::new();
    /// world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::cuboid(1.0, 1.0, 1.0));
    /// let mut lines = Lines(Vec::new());
    /// world.debug_render(&mut DebugRenderPipeline::default(), &mut lines);
    /// assert_eq!(lines.0.len(), 12); // the edges of a box
    /// ```
    pub fn debug_render(
        &self,
        pipeline: &mut crate::debug_render::DebugRenderPipeline,
        backend: &mut dyn crate::debug_render::DebugRenderBackend,
    ) {
        pipeline.render(
            backend,
            &self.bodies,
            &self.colliders,
            &self.impulse_joints,
            &self.multibody_joints,
            &self.narrow_phase,
        );
    }
}
