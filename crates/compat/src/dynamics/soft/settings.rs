//! Settings of all soft bodies. They have no effect.

use crate::math::Real;

/// Defines plain data with default values.
macro_rules! settings {
    ($(#[$doc:meta])* $name:ident { $($(#[$cfg:meta])* $field:ident: $type:ty = $default:expr,)* }) => {
        $(#[$doc])*
        #[derive(Copy, Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde-serialize", serde(default))]
        pub struct $name {
            $($(#[$cfg])* #[doc = "Accepted for compatibility; no effect."] pub $field: $type,)*
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($(#[$cfg])* $field: $default,)* }
            }
        }
    };
}
pub(super) use settings;

/// Constraints of the points in an overlap.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum SoftPatchConstraints {
    /// They stay.
    Keep,
    /// They are inactive.
    StandDown,
    /// They act along the normal of the overlap.
    AlongNormal,
}

settings! {
    /// Settings of soft bodies.
    SoftBodiesSettings {
        recovery: SoftRecoverySettings = SoftRecoverySettings::default(),
        resweep_strain: Real = 0.75,
        max_extra_substeps: usize = 4,
        contact_stiffening: Real = 4.0,
        #[cfg(feature = "fem")]
        fem: SoftFemParameters = SoftFemParameters::default(),
    }
}

settings! {
    /// Settings of the recovery of tangled soft bodies.
    SoftRecoverySettings {
        authored_velocity_margin: bool = true,
        edge_speculation: bool = false,
        inverted_cell_detection: bool = true,
        self_crossing_detection: bool = true,
        detection_motion_gating: bool = true,
        cross_body_detection: bool = true,
        self_stand_down: bool = true,
        cross_body_expel_gate: bool = true,
        edge_stand_down: bool = true,
        crossing_repulsion: bool = false,
        crossing_repulsion_guide: bool = false,
        crossing_repulsion_self_guide: bool = false,
        recovery_pace: Real = 0.5,
        overlap_constraints: bool = true,
        overlap_rigid: bool = true,
        overlap_skip_self_tangled: bool = true,
        overlap_edge_stand_down: bool = true,
        overlap_constraint_pace: Real = 1.0,
        overlap_patch_constraints: SoftPatchConstraints = SoftPatchConstraints::AlongNormal,
        overlap_skin_volume: bool = false,
        overlap_kept_depth: Real = 0.0,
        overlap_normal_push: bool = true,
        overlap_self_regions: bool = false,
        overlap_multi_volume: bool = false,
        overlap_split: u32 = 3,
        overlap_patience: u32 = 240,
        overlap_progress_margin: Real = 0.02,
    }
}

#[cfg(feature = "fem")]
settings! {
    /// Settings of the finite-element solver.
    SoftFemParameters {
        linear_tolerance: Real = 1.0e-5,
        max_linear_iterations: usize = 20,
        max_dense_dofs: usize = 600,
    }
}

/// Solver of the elasticity of a soft body.
#[cfg(feature = "fem")]
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum SoftBodySolver {
    /// Impulses.
    #[default]
    Impulse,
    /// Finite elements.
    Fem,
}
