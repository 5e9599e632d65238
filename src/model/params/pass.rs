//! Parameters of the solver's passes over contacts and joints.

use super::{IntegrationParameters, Softness};
use crate::dim::math::{Real, Vector};

/// The common numbers of all contact constraints of a substep.
#[derive(Copy, Clone, Debug)]
pub(crate) struct ContactPass {
    /// One over the length of a substep (1/s).
    pub inv_substep: Real,
    /// Softness of contacts.
    pub softness: Softness,
    /// Largest velocity at which overlap is corrected (length/s).
    pub push_velocity_max: Real,
    /// Overlap that is not corrected (length).
    pub allowed_error: Real,
    /// Whether this is the last iteration of the constraints in the substep. Then its impulses are the
    /// substep's, and count into those of the step.
    pub is_last_iteration: bool,
}

impl ContactPass {
    /// For substeps of `substep` seconds. Contacts have the spring of substeps that are `reference_ratio`
    /// times as long.
    pub fn new(params: &IntegrationParameters, substep: Real, reference_ratio: Real) -> Self {
        let softness = params.contact_softness(substep * reference_ratio);
        Self {
            inv_substep: if substep > 0.0 { 1.0 / substep } else { 0.0 },
            softness: softness.in_shorter_substep(reference_ratio, substep),
            push_velocity_max: params.max_corrective_velocity(),
            allowed_error: params.allowed_error(substep),
            is_last_iteration: true,
        }
    }
}

/// The common numbers of all impacts of a substep.
#[derive(Copy, Clone, Debug)]
pub(crate) struct ImpactPass {
    /// Length of the step (s): nothing can have hit longer ago.
    pub step: Real,
    /// Length of a substep (s).
    pub substep: Real,
    /// One over it (1/s).
    pub inv_substep: Real,
    /// Approach slower than this does not bounce (length/s).
    pub threshold: Real,
    /// The speed that gravity gives in a substep (length/s).
    pub fall: Real,
}

impl ImpactPass {
    /// For substeps of `substep` seconds under this acceleration of gravity.
    pub fn new(params: &IntegrationParameters, gravity: Real, substep: Real) -> Self {
        Self {
            step: params.dt,
            substep,
            inv_substep: if substep > 0.0 { 1.0 / substep } else { 0.0 },
            threshold: params.restitution_velocity_threshold(),
            fall: gravity * substep,
        }
    }
}

/// The common numbers of all joint constraints of a substep.
#[derive(Copy, Clone, Debug)]
pub(crate) struct JointPass {
    /// Length of a substep (s).
    pub substep: Real,
    /// One over it (1/s).
    pub inv_substep: Real,
    /// Softness of joints without their own softness.
    pub softness: Softness,
    /// Largest velocity at which joints bring anchors together (length/s).
    pub correction_max: Real,
    /// Whether this is the last iteration of the constraints in the substep.
    pub is_last_iteration: bool,
    /// Whether it corrects positions. Otherwise it leads to zero relative velocity.
    pub is_biased: bool,
}

impl JointPass {
    /// For substeps of `substep` seconds.
    pub fn new(params: &IntegrationParameters, substep: Real) -> Self {
        Self {
            substep,
            inv_substep: if substep > 0.0 { 1.0 / substep } else { 0.0 },
            softness: params.joint_softness(substep),
            correction_max: params.max_joint_corrective_velocity(),
            is_last_iteration: true,
            is_biased: true,
        }
    }

    /// The factor on the bias of a joint whose anchors are `separation` apart: 1 unless the correction would
    /// be faster than it may be.
    ///
    /// The separation is that of the start of the step. A factor that followed it within the step would make
    /// the bias a constant velocity, which overshoots.
    pub fn bias_scale(&self, separation: Vector) -> Real {
        let correction = separation.length() * self.softness.bias_rate;
        if correction > self.correction_max { self.correction_max / correction } else { 1.0 }
    }
}
