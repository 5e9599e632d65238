//! The parameters of a step in Rapier 0.36.

use super::SoftBodiesSettings;
use engine::dynamics::SpringCoefficients;
use engine::math::Real;

/// Model of friction.
#[cfg(feature = "dim3")]
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum FrictionModel {
    /// One friction impulse and one torsional impulse per manifold.
    #[default]
    Simplified,
    /// One friction impulse per contact point.
    Coulomb,
}

/// The parameters of a step.
///
/// A field with upstream's default value selects the engine's default: the two solvers have different best
/// settings. Another value is converted to the engine's parameter by its definition.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct IntegrationParameters {
    /// Length of a step (s).
    pub dt: Real,
    /// Shortest substep of continuous collision detection (s).
    pub min_ccd_dt: Real,
    /// Spring of contacts.
    pub contact_softness: SpringCoefficients<Real>,
    /// No effect: the engine has one spring for all contacts.
    pub static_contact_softness: SpringCoefficients<Real>,
    /// Fraction of the last impulses with which a step begins.
    pub warmstart_coefficient: Real,
    /// Length of a typical object.
    pub length_unit: Real,
    /// Overlap that is not corrected, in multiples of the length unit.
    pub normalized_allowed_linear_error: Real,
    /// Largest velocity of the correction of an overlap, in multiples of the length unit per second.
    pub normalized_max_corrective_velocity: Real,
    /// Distance at which contacts are computed, in multiples of the length unit.
    pub normalized_prediction_distance: Real,
    /// Substeps of a step.
    pub num_solver_iterations: usize,
    /// Iterations of a substep.
    pub num_internal_pgs_iterations: usize,
    /// No effect: the engine's substeps need no separate stabilization.
    pub num_internal_stabilization_iterations: usize,
    /// Largest linear velocity of a body, in multiples of the length unit per second.
    pub normalized_max_linear_velocity: Real,
    /// Largest number of substeps of continuous collision detection.
    pub max_ccd_substeps: usize,
    /// No effect: the engine merges no manifolds.
    pub contact_clustering: bool,
    /// Whether contact points move with bodies that are displaced little.
    pub contact_recycling: bool,
    /// Displacement above which contact points are recomputed, in multiples of the length unit.
    pub normalized_contact_recycle_distance: Real,
    /// No effect: the engine solves friction in the passes that it needs.
    pub friction_in_bias_pass: bool,
    /// No effect: the engine's joints always start with the last impulses.
    pub warmstart_joints: bool,
    /// No effect: the engine has no soft bodies.
    pub soft_bodies: SoftBodiesSettings,
    /// Model of friction.
    #[cfg(feature = "dim3")]
    pub friction_model: FrictionModel,
}

impl Default for IntegrationParameters {
    fn default() -> Self {
        Self {
            dt: 1.0 / 60.0,
            min_ccd_dt: 1.0 / 60.0 / 100.0,
            contact_softness: SpringCoefficients::new(30.0, 10.0),
            static_contact_softness: SpringCoefficients::contact_static_defaults(),
            warmstart_coefficient: 1.0,
            length_unit: 1.0,
            normalized_allowed_linear_error: 0.005,
            normalized_max_corrective_velocity: 3.0,
            normalized_prediction_distance: 0.02,
            normalized_max_linear_velocity: 400.0,
            num_solver_iterations: 4,
            num_internal_pgs_iterations: 1,
            num_internal_stabilization_iterations: 1,
            max_ccd_substeps: 1,
            contact_clustering: true,
            contact_recycling: true,
            normalized_contact_recycle_distance: 0.05,
            friction_in_bias_pass: false,
            warmstart_joints: false,
            soft_bodies: SoftBodiesSettings::default(),
            #[cfg(feature = "dim3")]
            friction_model: FrictionModel::default(),
        }
    }
}

impl IntegrationParameters {
    /// Steps per second; 0 for a step without length.
    pub fn inv_dt(&self) -> Real {
        if self.dt == 0.0 { 0.0 } else { 1.0 / self.dt }
    }

    /// Sets the length of a step (s).
    #[deprecated = "assign the field `dt`"]
    pub fn set_dt(&mut self, dt: Real) {
        assert!(dt >= 0.0, "the step length {dt} is negative");
        self.dt = dt;
    }

    /// Sets the number of steps per second. Zero makes a step without length.
    pub fn set_inv_dt(&mut self, inv_dt: Real) {
        self.dt = if inv_dt == 0.0 { 0.0 } else { 1.0 / inv_dt };
    }

    /// Overlap that is not corrected (length units).
    pub fn allowed_linear_error(&self) -> Real {
        self.normalized_allowed_linear_error * self.length_unit
    }

    /// Largest velocity of the correction of an overlap (length/s).
    pub fn max_corrective_velocity(&self) -> Real {
        match self.normalized_max_corrective_velocity {
            Real::MAX => Real::MAX,
            normalized => normalized * self.length_unit,
        }
    }

    /// Largest linear velocity of a body (length/s).
    pub fn max_linear_velocity(&self) -> Real {
        match self.normalized_max_linear_velocity {
            Real::MAX => Real::MAX,
            normalized => normalized * self.length_unit,
        }
    }

    /// Displacement above which contact points are recomputed (length units).
    pub fn contact_recycle_distance(&self) -> Real {
        self.normalized_contact_recycle_distance * self.length_unit
    }

    /// Distance at which contacts are computed (length units).
    pub fn prediction_distance(&self) -> Real {
        self.normalized_prediction_distance * self.length_unit
    }

    /// The parameters of the engine. It refuses values outside their ranges, and upstream does not. Counts of
    /// zero and coefficients outside 0 to 1 become the nearest valid value.
    pub(crate) fn to_engine(self) -> engine::dynamics::IntegrationParameters {
        let upstream = Self::default();
        let own = engine::dynamics::IntegrationParameters::default();
        let select = |value: Real, default: Real, own: Real| {
            if value == default { own } else { value }
        };
        let (erp, damping_ratio) = self.engine_softness(own.erp, own.damping_ratio);
        engine::dynamics::IntegrationParameters {
            dt: self.dt,
            min_ccd_dt: self.min_ccd_dt,
            erp,
            damping_ratio,
            warmstart_coefficient: self.warmstart_coefficient.clamp(0.0, 1.0),
            length_unit: self.length_unit,
            allowed_linear_error: select(
                self.normalized_allowed_linear_error,
                upstream.normalized_allowed_linear_error,
                own.allowed_linear_error,
            ),
            normalized_max_linear_velocity: select(
                self.normalized_max_linear_velocity,
                upstream.normalized_max_linear_velocity,
                own.normalized_max_linear_velocity,
            ),
            normalized_contact_recycle_distance: if self.contact_recycling {
                select(
                    self.normalized_contact_recycle_distance,
                    upstream.normalized_contact_recycle_distance,
                    own.normalized_contact_recycle_distance,
                )
            } else {
                0.0
            },
            normalized_max_corrective_velocity: select(
                self.normalized_max_corrective_velocity,
                upstream.normalized_max_corrective_velocity,
                own.normalized_max_corrective_velocity,
            ),
            normalized_prediction_distance: select(
                self.normalized_prediction_distance,
                upstream.normalized_prediction_distance,
                own.normalized_prediction_distance,
            ),
            num_solver_iterations: self.num_solver_iterations.max(1),
            num_internal_pgs_iterations: self.num_internal_pgs_iterations.max(1),
            max_ccd_substeps: self.max_ccd_substeps,
            #[cfg(feature = "dim3")]
            friction_model: match self.friction_model {
                FrictionModel::Simplified => engine::dynamics::FrictionModel::Standard,
                FrictionModel::Coulomb => engine::dynamics::FrictionModel::Coulomb,
            },
            ..own
        }
    }

    /// The engine's parameters of contact softness.
    ///
    /// A contact without a frequency removes no error, and stays as hard as the engine's. The engine's
    /// contacts have at least [`CONTACT_COMPLIANCE`](engine::dynamics::CONTACT_COMPLIANCE): stiffer springs
    /// get that compliance.
    fn engine_softness(&self, own_erp: Real, own_damping_ratio: Real) -> (Real, Real) {
        use engine::dynamics::{CONTACT_COMPLIANCE, CONTACT_ERP_SCALE};
        let substep = self.dt / self.num_solver_iterations.max(1) as Real;
        if self.contact_softness == Self::default().contact_softness || self.dt <= 0.0 {
            return (own_erp, own_damping_ratio);
        }
        if substep * self.contact_softness.angular_frequency() <= 0.0 {
            return (0.0, own_damping_ratio);
        }
        let fraction = self.contact_softness.erp(substep);
        let compliance = self.contact_softness.cfm_coeff(substep);
        ((fraction / CONTACT_ERP_SCALE).min(1.0), (compliance - CONTACT_COMPLIANCE).max(0.0))
    }
}
