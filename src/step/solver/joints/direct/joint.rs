//! A joint in the factorisation.

use crate::dim::math::Real;
use crate::dim::state::{BodyPose, READ_ONLY};
use crate::model::island::NONE;
use crate::model::joint::JointForm;

/// Largest mass ratio of the bodies of a component that is left to iterations.
const MASS_RATIO_MODERATE_MAX: Real = 32.0;

/// A joint in the factorisation.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(in super::super) struct DirectJoint {
    /// The joint's slot in its set: the order of members must not depend on other islands.
    pub slot: u32,
    /// Block and lane of its rows.
    pub block: u32,
    pub lane: u32,
    /// Solver indices of its bodies.
    pub bodies: [u32; 2],
    /// Inverse masses of its bodies; zero for immovable ones.
    pub inv_masses: [Real; 2],
    /// Whether a body has both locked and free axes of its own.
    pub has_locked_body: bool,
    /// Whether the last step took back impulses in its island: see `solver/ledger/`.
    pub is_strained: bool,
    pub form: JointForm,
    /// Number of its rows of locked axes.
    pub locked_row_count: u8,
}

impl DirectJoint {
    /// No joint.
    pub const NONE: Self = Self {
        slot: NONE,
        block: 0,
        lane: 0,
        bodies: [READ_ONLY; 2],
        inv_masses: [0.0; 2],
        has_locked_body: false,
        is_strained: false,
        form: JointForm {
            locked: 0,
            driven: 0,
            is_point_to_point: false,
            is_weld: false,
            is_transmission: false,
            is_soft: false,
            does_work: false,
        },
        locked_row_count: 0,
    };

    /// The joint in a slot between two bodies; where its rows will be is not known yet.
    pub fn new(slot: u32, bodies: [u32; 2], form: JointForm, poses: &[BodyPose]) -> Self {
        let ends = bodies.map(|body| (body & READ_ONLY == 0).then(|| &poses[body as usize]));
        let inv_masses = ends.map(|end| end.map_or(0.0, |pose| pose.inv_mass().max_element()));
        let has_locked_body = ends.into_iter().flatten().any(BodyPose::has_locked_axis);
        let locked_row_count = form.row_count() as u8;
        Self { slot, bodies, inv_masses, has_locked_body, form, locked_row_count, ..Self::NONE }
    }

    /// Returns whether there is a joint.
    pub fn is_valid(&self) -> bool {
        self.slot != NONE
    }

    /// Number of its rows of locked axes.
    pub fn locked_row_count(&self) -> usize {
        usize::from(self.locked_row_count)
    }

    /// Number of its rows, of locked and driven axes.
    pub fn row_count(&self) -> usize {
        usize::from(self.locked_row_count + self.form.driven)
    }

    /// The bodies that can move, with their sides.
    pub fn movable(&self) -> impl Iterator<Item = (usize, u32)> + use<> {
        self.bodies.into_iter().enumerate().filter(|(_, body)| body & READ_ONLY == 0)
    }
}

/// Returns whether the masses of the bodies of these joints are within [`MASS_RATIO_MODERATE_MAX`].
pub(super) fn has_moderate_mass_ratio<'a>(members: impl Iterator<Item = &'a DirectJoint>) -> bool {
    let bodies =
        members.flat_map(|member| member.movable().map(|(side, _)| member.inv_masses[side]));
    let [least, most] = bodies.fold([Real::INFINITY, 0.0], |[least, most], inv_mass| {
        [inv_mass.min(least), inv_mass.max(most)]
    });
    most <= MASS_RATIO_MODERATE_MAX * least
}
