//! Materials of soft bodies. They have no effect.

use super::settings::settings;
use crate::math::Real;
use engine::dynamics::SpringCoefficients;

/// Strains that deform an edge permanently.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum SoftEdgePlasticFlow {
    /// All strains.
    #[default]
    Both,
    /// Strains of longer edges.
    Tension,
    /// Strains of shorter edges.
    Compression,
}

/// Purpose of an edge.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum SoftBodyEdgeKind {
    /// It keeps a length.
    Structural,
    /// It resists bending.
    Bend,
}

/// Elasticity of a cell.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum SoftBodyCellModel {
    /// A cell keeps its volume.
    #[default]
    Volume,
    /// Corotational elasticity.
    Corotational,
    /// Neo-Hookean elasticity.
    NeoHookean,
}

settings! {
    /// Material of a soft body.
    SoftBodyMaterial {
        edge_softness: SpringCoefficients<Real> = SpringCoefficients::new(30.0, 1.0),
        bend_softness: SpringCoefficients<Real> = SpringCoefficients::new(10.0, 1.0),
        volume_softness: SpringCoefficients<Real> = SpringCoefficients::new(30.0, 1.0),
        shape_matching_softness: SpringCoefficients<Real> = SpringCoefficients::new(10.0, 1.0),
        young_modulus: Real = 1.0e4,
        poisson_ratio: Real = 0.3,
        elastic_damping_ratio: Real = 1.0,
        plastic_yield: Real = 0.0,
        plastic_creep: Real = 1.0,
        plastic_max: Real = 1.0,
        deformation_damping: Real = 0.0,
        edge_plastic_yield: Real = 0.0,
        edge_plastic_creep: Real = 1.0,
        edge_plastic_max: Real = 0.5,
        edge_plastic_flow: SoftEdgePlasticFlow = SoftEdgePlasticFlow::Both,
        tear_strain: Option<Real> = None,
        tear_force: Option<Real> = None,
        tear_smoothing: Real = 0.0,
        interior_strength: Real = 1.0,
        max_tears_per_step: u32 = u32::MAX,
        min_piece: Option<u32> = None,
    }
}

impl SoftBodyMaterial {
    /// A material with the same softness everywhere.
    pub fn uniform(softness: SpringCoefficients<Real>) -> Self {
        Self {
            edge_softness: softness,
            bend_softness: softness,
            volume_softness: softness,
            shape_matching_softness: softness,
            ..Self::default()
        }
    }

    /// Returns whether the material has a limit at which it tears.
    pub fn tears(&self) -> bool {
        self.tear_strain.is_some() || self.tear_force.is_some()
    }

    /// The Lamé parameters `λ = E ν / ((1 + ν) (1 - 2 ν))` and `μ = E / (2 (1 + ν))`.
    pub fn lame_parameters(&self) -> (Real, Real) {
        let (e, nu) = (self.young_modulus, self.poisson_ratio);
        (e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), e / (2.0 * (1.0 + nu)))
    }
}

settings! {
    /// Settings of all particles of a soft body.
    SoftBodyParticleSettings {
        linear_damping: Real = 0.0,
        gravity_scale: Real = 1.0,
        additional_solver_iterations: usize = 0,
        additional_pgs_iterations: usize = 3,
        can_sleep: bool = true,
        dominance_group: i8 = 0,
    }
}
