//! Validation of the parameters of a step.

use super::IntegrationParameters;
use crate::base::measure::{is_length, is_margin};
use crate::dim::math::Real;

/// Largest number of substeps, iterations or impacts of one step. Larger numbers, such as typing errors,
/// would make a program appear to hang.
pub(crate) const ITERATIONS_MAX: usize = 1000;

/// A field of [`IntegrationParameters`] has a value with which no step can be computed.
#[derive(Copy, Clone, Debug, PartialEq, thiserror::Error)]
#[error("IntegrationParameters::{field} is {value}, but must be {expected}")]
pub struct InvalidParameters {
    /// Name of the field.
    pub field: &'static str,
    /// The refused value.
    pub value: Real,
    /// The admissible values, in words.
    pub expected: &'static str,
}

impl InvalidParameters {
    fn unless(
        valid: bool,
        field: &'static str,
        value: Real,
        expected: &'static str,
    ) -> Result<(), Self> {
        if valid { Ok(()) } else { Err(Self { field, value, expected }) }
    }
}

fn count(field: &'static str, value: usize, min: usize) -> Result<(), InvalidParameters> {
    let expected = if min == 0 { "from 0 to 1000" } else { "from 1 to 1000" };
    let valid = (min..=ITERATIONS_MAX).contains(&value);
    InvalidParameters::unless(valid, field, value as Real, expected)
}

fn fraction(field: &'static str, value: Real) -> Result<(), InvalidParameters> {
    InvalidParameters::unless((0.0..=1.0).contains(&value), field, value, "from 0 to 1")
}

/// A time or number whose square must not overflow.
fn moderate(field: &'static str, value: Real) -> Result<(), InvalidParameters> {
    InvalidParameters::unless(is_margin(value), field, value, "from 0 to 1e15")
}

/// A multiple of the length unit that must be a usable length in the world's own units.
fn scaled(field: &'static str, value: Real, unit: Real) -> Result<(), InvalidParameters> {
    let valid = value >= 0.0 && is_margin(value * unit);
    let expected = "0 or more, and at most 1e15 in the world's own units";
    InvalidParameters::unless(valid, field, value, expected)
}

fn limit(field: &'static str, value: Real) -> Result<(), InvalidParameters> {
    InvalidParameters::unless(value >= 0.0, field, value, "0 or more")
}

impl IntegrationParameters {
    /// Checks that all fields are within their documented ranges.
    ///
    /// # Errors
    /// If a field is outside its documented range. The error contains the first such field and its value.
    pub fn validate(&self) -> Result<(), InvalidParameters> {
        self.validate_dt()?;
        count("num_solver_iterations", self.num_solver_iterations, 1)?;
        let friction = self.num_additional_friction_iterations;
        count("num_additional_friction_iterations", friction, 0)?;
        count("num_internal_pgs_iterations", self.num_internal_pgs_iterations, 1)?;
        count("max_ccd_substeps", self.max_ccd_substeps, 0)?;
        fraction("erp", self.erp)?;
        fraction("joint_erp", self.joint_erp)?;
        fraction("warmstart_coefficient", self.warmstart_coefficient)?;
        moderate("damping_ratio", self.damping_ratio)?;
        moderate("joint_damping_ratio", self.joint_damping_ratio)?;
        moderate("min_ccd_dt", self.min_ccd_dt)?;
        self.validate_scales()
    }

    /// The inverse of a time step, and its square, must not overflow either.
    pub(super) fn validate_dt(&self) -> Result<(), InvalidParameters> {
        let valid = self.dt == 0.0 || is_length(self.dt);
        InvalidParameters::unless(valid, "dt", self.dt, "0, or from 1e-15 to 1e15")
    }

    /// The length unit, and the fields that are its multiples.
    fn validate_scales(&self) -> Result<(), InvalidParameters> {
        let unit = self.length_unit;
        let valid = is_length(unit);
        InvalidParameters::unless(valid, "length_unit", unit, "from 1e-15 to 1e15")?;
        scaled("allowed_linear_error", self.allowed_linear_error, unit)?;
        let prediction = self.normalized_prediction_distance;
        scaled("normalized_prediction_distance", prediction, unit)?;
        let recycle = self.normalized_contact_recycle_distance;
        scaled("normalized_contact_recycle_distance", recycle, unit)?;
        limit("normalized_max_corrective_velocity", self.normalized_max_corrective_velocity)?;
        let of_joints = self.normalized_max_joint_corrective_velocity;
        limit("normalized_max_joint_corrective_velocity", of_joints)?;
        limit("normalized_max_linear_velocity", self.normalized_max_linear_velocity)?;
        let threshold = self.normalized_restitution_velocity_threshold;
        limit("normalized_restitution_velocity_threshold", threshold)
    }
}
