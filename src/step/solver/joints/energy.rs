//! Joints in the ledger of energy: what drives them, and the fractions of their impulses.

use super::SolverJoints;
use crate::base::wide::{LANES, Lane};
use crate::model::joint::JointForm;
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::ledger::{Entry, Frame, Ledger};

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

    /// Notes the island of each joint, and the frames in which the joint does no work.
    pub fn note_in(&self, ledger: &mut Ledger, bodies: &SolverBodies) {
        for member in &self.members {
            let JointForm { is_soft, is_transmission, does_work, .. } = member.form;
            let is_elastic = is_soft || (is_transmission && does_work);
            let frame = match is_elastic || self.direct.is_too_large(member.slot) {
                true => Frame::None,
                // Its coordinate is relative to the world.
                false if is_transmission => Frame::Rest,
                false => Frame::Any,
            };
            ledger.note_joint(member.bodies, frame, does_work, bodies);
        }
    }

    /// Notes the most energy that the motors can give in this substep.
    pub fn note_drives(&self, ledger: &mut Ledger, bodies: &SolverBodies) {
        for block in self.blocks.iter().filter(|block| block.row_count > 0) {
            for lane in 0..LANES {
                let motors = self.rows[block.axis_rows()].iter().map(|row| &row.motor);
                let energy = motors.map(|motor| motor.capacity(lane)).sum();
                ledger.add_drive(block.bodies.map(|bodies| bodies[lane]), energy, bodies);
            }
        }
    }
}
