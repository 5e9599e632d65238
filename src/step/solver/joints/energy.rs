//! Joints in the ledger of energy: what drives them, and the fractions of their impulses.

use super::SolverJoints;
use super::block::JointBlock;
use crate::base::wide::{LANES, Lane};
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::ledger::{Entry, Ledger, is_carried};

impl SolverJoints {
    /// Notes the sums of impulses before this substep.
    pub fn note_totals(&mut self) {
        self.blocks.iter_mut().for_each(JointBlock::note_totals);
        self.transmissions.note_totals();
    }

    /// Leaves all islands the fractions of their impulses that they keep. At the end of the substep the sums
    /// include these.
    pub fn limit(&mut self, ledger: &Ledger, entry: Entry, bodies: &SolverBodies) {
        if entry == Entry::End {
            let Self { blocks, point_to_point, transmissions, .. } = self;
            let kept_by = |pairs: &[[u32; LANES]; 2]| ledger.kept_by(pairs, bodies);
            for block in &mut *blocks {
                kept_by(&block.bodies).iter().for_each(|factors| block.scale_totals(factors));
            }
            point_to_point.scale_totals(kept_by);
            transmissions.scale_totals(blocks, kept_by);
        }
        self.scale_impulses(|pairs| ledger.kept_by(pairs, bodies));
    }

    /// Scales impulses by the fraction, if any, that the constraints of a block of bodies keep.
    pub(super) fn scale_impulses(&mut self, kept_by: impl Fn(&[[u32; LANES]; 2]) -> Option<Lane>) {
        let Self { blocks, rows, point_to_point, transmissions, .. } = self;
        for block in &mut *blocks {
            if let Some(factors) = kept_by(&block.bodies) {
                block.scale_impulses(&factors);
                rows[block.axis_rows()].iter_mut().for_each(|row| row.scale_impulses(&factors));
            }
        }
        point_to_point.scale_impulses(&kept_by);
        transmissions.scale_impulses(blocks, kept_by);
    }

    /// Notes the islands of all joints, and what drives them.
    pub fn note_in(&self, ledger: &mut Ledger, bodies: &SolverBodies) {
        for member in &self.members {
            ledger.note_joint(member.bodies, is_carried(member.bodies, bodies), bodies);
        }
        for block in &self.blocks {
            let rows = &self.rows[block.axis_rows()];
            for lane in 0..LANES {
                let pair = block.bodies.map(|bodies| bodies[lane]);
                if block.is_spring.0[lane] > 0.0 || rows.iter().any(|row| row.motor.drives(lane)) {
                    ledger.leave_out(bodies.island_of(pair));
                }
            }
        }
    }
}
