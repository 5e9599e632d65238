//! Names of Rapier 0.36 on the engine's types, for the facade of that version. The engine has no soft bodies,
//! so no body or collider belongs to a world.

use crate::base::arena::Index;
use crate::dim::math::Real;
use crate::model::body::{RigidBody, RigidBodyBuilder, RigidBodyHandle, RigidBodyType};
use crate::model::collider::{CoefficientCombineRule, Collider};
use crate::model::joint::SpringCoefficients;
use crate::model::multibody::MultibodyJoint;

/// Handle of a soft body.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SoftBodyHandle(pub Index);

impl SoftBodyHandle {
    /// A handle of no soft body.
    pub const fn invalid() -> Self {
        Self(Index::INVALID)
    }

    /// The handle with these two numbers.
    pub const fn from_raw_parts(id: u32, generation: u32) -> Self {
        Self(Index::from_raw_parts(id, generation))
    }

    /// Both numbers of the handle.
    pub const fn into_raw_parts(self) -> (u32, u32) {
        self.0.into_raw_parts()
    }

    /// Returns whether this is [`Self::invalid`].
    pub fn is_invalid(self) -> bool {
        self == Self::invalid()
    }
}

/// Number of a surface of a soft body.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SoftMeshId {
    /// Number of the cluster.
    pub cluster: u32,
    /// Number of the surface in the cluster.
    pub mesh: u32,
}

/// A surface of a soft body.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SoftMeshRef {
    /// The soft body.
    pub body: SoftBodyHandle,
    /// Number of the surface.
    pub id: SoftMeshId,
}

impl RigidBodyType {
    /// The type of bodies that a soft body moves. There are none: the name stands for a dynamic body.
    #[allow(non_upper_case_globals, reason = "the name of a variant in Rapier 0.36")]
    pub const SoftFrame: Self = Self::Dynamic;

    /// Returns whether a soft body moves the body: no.
    pub const fn is_soft_frame(self) -> bool {
        false
    }
}

impl RigidBody {
    /// Returns whether a soft body moves the body: no.
    pub const fn is_soft_frame(&self) -> bool {
        false
    }

    /// The soft body that moves the body: none.
    pub const fn soft_body(&self) -> Option<SoftBodyHandle> {
        None
    }

    /// The cluster that moves the body: none.
    pub const fn soft_cluster(&self) -> Option<u32> {
        None
    }

    /// Iterations of a substep beyond those of the parameters: 0.
    pub const fn additional_pgs_iterations(&self) -> usize {
        0
    }

    /// Accepted for compatibility; no effect.
    pub const fn set_additional_pgs_iterations(&mut self, additional_iterations: usize) {
        let _ = additional_iterations;
    }

    /// Returns whether any rotation per substep is allowed: yes, the engine limits none.
    pub const fn is_fast_rotation_allowed(&self) -> bool {
        true
    }

    /// Accepted for compatibility; no effect.
    pub const fn set_allow_fast_rotation(&mut self, allow: bool) {
        let _ = allow;
    }
}

impl RigidBodyBuilder {
    /// Accepted for compatibility; no effect.
    pub fn additional_pgs_iterations(self, additional_iterations: usize) -> Self {
        let _ = additional_iterations;
        self
    }

    /// Accepted for compatibility; no effect.
    pub fn allow_fast_rotation(self, allow: bool) -> Self {
        let _ = allow;
        self
    }
}

impl Collider {
    /// The surface of a soft body that the collider represents: none.
    pub const fn deformable_mesh_ref(&self) -> Option<SoftMeshRef> {
        None
    }
}

impl CoefficientCombineRule {
    /// The combined coefficient of two surfaces.
    pub fn combine(coeff1: Real, coeff2: Real, rule1: Self, rule2: Self) -> Real {
        Self::combined(coeff1, rule1, coeff2, rule2)
    }
}

impl MultibodyJoint {
    /// The spring along the axis with this number: its stiffness and its rest coordinate.
    ///
    /// # Panics
    /// If there is no such axis.
    pub fn spring(&self, axis: usize) -> (Real, Real) {
        self.spring_at(axis)
    }

    /// Sets the spring along the axis with this number.
    ///
    /// # Panics
    /// If there is no such axis.
    pub fn set_spring(&mut self, axis: usize, stiffness: Real, rest: Real) {
        self.set_spring_at(axis, stiffness, rest);
    }
}

impl SpringCoefficients {
    /// The spring of contacts with fixed bodies in Rapier 0.36. The engine's contacts follow
    /// [`IntegrationParameters::erp`](crate::model::params::IntegrationParameters::erp).
    pub const fn contact_static_defaults() -> Self {
        Self::new(60.0, 10.0)
    }
}

impl RigidBodyHandle {
    /// Returns whether this is [`Self::invalid`].
    pub fn is_invalid(self) -> bool {
        self == Self::invalid()
    }
}
