//! Joints in the ledger of energy: what drives them, and the fractions of their impulses.

use super::SolverJoints;
use crate::base::wide::{LANES, Lane};
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::ledger::{Entry, Ledger, is_carried};

impl SolverJoints {
    /// Leaves all islands the fractions of their impulses that the ledger keeps.
    pub fn limit(&mut self, ledger: &Ledger, entry: Entry, bodies: &SolverBodies) {
        self.scale_impulses(|pairs| ledger.kept_by(pairs, bodies), entry == Entry::End);
    }

    /// Scales impulses by the fraction, if any, that the constraints of a block of bodies keep.
    /// `are_counted`: whether the sums over all substeps include the impulses.
    pub(super) fn scale_impulses(
        &mut self,
        kept_by: impl Fn(&[[u32; LANES]; 2]) -> Option<Lane>,
        are_counted: bool,
    ) {
        let Self { blocks, rows, point_to_point, transmissions, .. } = self;
        // Transmissions count the impulses of their rows.
        transmissions.scale_impulses((blocks, rows), &kept_by, are_counted);
        point_to_point.scale_impulses(&kept_by, are_counted);
        for block in blocks {
            if let Some(kept) = kept_by(&block.bodies) {
                block.scale_impulses(&kept, are_counted);
                rows[block.axis_rows()].iter_mut().for_each(|row| row.scale_impulses(&kept));
            }
        }
    }

    /// Notes the islands of all joints, and springs, motors and moving bodies that drive the joints.
    pub fn note_in(&self, ledger: &mut Ledger, bodies: &SolverBodies) {
        for member in &self.members {
            let is_driven = member.form.does_work || is_carried(member.bodies, bodies);
            ledger.note_joint(member.bodies, is_driven, bodies);
        }
    }
}
