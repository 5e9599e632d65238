//! The renderer of a world as lines.

use super::debug_backend::Backend;
use super::{DebugRenderBackend, DebugRenderStyle};
use crate::dynamics::{ImpulseJointSet, MultibodyJointSet, RigidBodySet};
use crate::geometry::{ColliderSet, NarrowPhase};
use engine::pipeline::DebugRenderMode as EngineMode;

bitflags::bitflags! {
    /// The drawn parts, with the bits of Rapier 0.32.
    #[derive(Copy, Clone, PartialEq, Eq, Debug)]
    pub struct DebugRenderMode: u32 {
        /// The shapes of colliders.
        const COLLIDER_SHAPES = 1;
        /// The axes of bodies.
        const RIGID_BODY_AXES = 1 << 1;
        /// Multibody joints.
        const MULTIBODY_JOINTS = 1 << 2;
        /// Impulse joints.
        const IMPULSE_JOINTS = 1 << 3;
        /// Joints of both kinds.
        const JOINTS = Self::MULTIBODY_JOINTS.bits() | Self::IMPULSE_JOINTS.bits();
        /// Contacts of the solver.
        const SOLVER_CONTACTS = 1 << 4;
        /// Contacts.
        const CONTACTS = 1 << 5;
        /// The boxes of colliders.
        const COLLIDER_AABBS = 1 << 6;
        /// Soft bodies: the engine has none.
        #[cfg(rapier036)]
        const SOFT_BODIES = 1 << 7;
        /// The pseudo-normals of meshes and polylines.
        #[cfg(rapier036)]
        const PSEUDO_NORMALS = 1 << 8;
        /// Contacts of volumes: the engine has no soft bodies.
        #[cfg(rapier036)]
        const SOFT_VOLUME_CONTACTS = 1 << 9;
        /// Stress of soft bodies: the engine has none.
        #[cfg(rapier036)]
        const SOFT_BODY_STRESS = 1 << 10;
    }
}

impl Default for DebugRenderMode {
    fn default() -> Self {
        Self::COLLIDER_SHAPES | Self::JOINTS | Self::RIGID_BODY_AXES
    }
}

/// The flags have equal names in the engine, and other bits.
impl From<DebugRenderMode> for EngineMode {
    fn from(mode: DebugRenderMode) -> Self {
        mode.iter_names().filter_map(|(name, _)| Self::from_name(name)).collect()
    }
}

/// A renderer of a world as coloured lines.
#[derive(Clone, Default)]
pub struct DebugRenderPipeline {
    /// Colours and lengths.
    pub style: DebugRenderStyle,
    /// The drawn parts.
    pub mode: DebugRenderMode,
    engine: engine::pipeline::DebugRenderPipeline,
}

impl DebugRenderPipeline {
    /// A pipeline that draws in this style the parts that `mode` selects.
    pub fn new(style: DebugRenderStyle, mode: DebugRenderMode) -> Self {
        Self { style, mode, engine: Default::default() }
    }

    /// A pipeline that draws everything in this style.
    pub fn render_all(style: DebugRenderStyle) -> Self {
        Self::new(style, DebugRenderMode::all())
    }

    /// The engine's pipeline with this style and mode.
    fn engine(&mut self) -> &mut engine::pipeline::DebugRenderPipeline {
        self.engine.style = self.style.into();
        self.engine.mode = self.mode.into();
        &mut self.engine
    }

    /// Draws everything that the mode selects.
    #[cfg_attr(
        rapier036,
        expect(clippy::too_many_arguments, reason = "the signature of Rapier 0.36")
    )]
    pub fn render(
        &mut self,
        backend: &mut impl DebugRenderBackend,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        impulse_joints: &ImpulseJointSet,
        multibody_joints: &MultibodyJointSet,
        narrow_phase: &NarrowPhase,
        #[cfg(rapier036)] _soft_bodies: &crate::dynamics::SoftBodySet,
    ) {
        self.render_rigid_bodies(backend, bodies);
        self.render_colliders(backend, bodies, colliders);
        self.render_joints(backend, bodies, impulse_joints, multibody_joints);
        self.render_contacts(backend, colliders, narrow_phase);
    }

    /// Draws the axes of all bodies.
    pub fn render_rigid_bodies(
        &mut self,
        backend: &mut impl DebugRenderBackend,
        bodies: &RigidBodySet,
    ) {
        self.engine().render_rigid_bodies(&mut Backend(backend), bodies);
    }

    /// Draws the shapes and the boxes of all colliders.
    pub fn render_colliders(
        &mut self,
        backend: &mut impl DebugRenderBackend,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
    ) {
        self.engine().render_colliders(&mut Backend(backend), bodies, colliders);
    }

    /// Draws all joints.
    pub fn render_joints(
        &mut self,
        backend: &mut impl DebugRenderBackend,
        bodies: &RigidBodySet,
        impulse_joints: &ImpulseJointSet,
        multibody_joints: &MultibodyJointSet,
    ) {
        self.engine().render_joints(
            &mut Backend(backend),
            bodies,
            impulse_joints,
            multibody_joints,
        );
    }

    /// Draws all contacts.
    pub fn render_contacts(
        &mut self,
        backend: &mut impl DebugRenderBackend,
        colliders: &ColliderSet,
        narrow_phase: &NarrowPhase,
    ) {
        self.engine().render_contacts(&mut Backend(backend), colliders, narrow_phase);
    }

    /// Draws nothing: the engine has no soft bodies.
    #[cfg(rapier036)]
    pub fn render_soft_bodies<B: DebugRenderBackend>(
        &mut self,
        _backend: &mut B,
        _soft_bodies: &crate::dynamics::SoftBodySet,
    ) {
    }

    /// Draws nothing: the engine has no soft bodies.
    #[cfg(rapier036)]
    pub fn render_soft_volume_contacts<B: DebugRenderBackend>(
        &mut self,
        _backend: &mut B,
        _soft_bodies: &crate::dynamics::SoftBodySet,
    ) {
    }
}
