//! Phases of an impact over all blocks: hit detection, deferral, friction.

use super::points::NormalRows;
use super::rows::{ImpactBlock, ImpactMark, KnownVelocities};
use super::touched::Touched;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Kernel, Wide};
use crate::dim::contact::ContactBlock;
use crate::dim::state::{BodyState, READ_ONLY};
use crate::model::params::ImpactPass;
use crate::step::solver::contacts::Blocks;
use core::ops::Range;

/// The operation on each block.
#[derive(Copy, Clone, PartialEq, Eq)]
pub(super) enum ImpactPhase {
    Begin,
    Mark,
    Defer,
    Friction,
}

/// A phase of an impact, for some blocks.
pub(super) struct BlockVisit<'a> {
    pub phase: ImpactPhase,
    pub range: Range<usize>,
    pub contacts: Blocks<'a>,
    pub impacts: DisjointMut<'a, ImpactBlock>,
    pub marks: DisjointMut<'a, ImpactMark>,
    /// Velocities before any impulse of this substep, which impacts change.
    pub states: DisjointMut<'a, BodyState>,
    pub known: KnownVelocities<'a>,
    pub touched: &'a Touched,
    pub pass: &'a ImpactPass,
}

impl Kernel for BlockVisit<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        for index in self.range.clone() {
            // SAFETY: each block belongs to one task. The phase that changes bodies runs colour by colour,
            // and constraints of one colour have no common dynamic body. The other phases change their block
            // alone.
            unsafe { self.visit::<W>(index) };
        }
    }
}

impl BlockVisit<'_> {
    /// Returns whether this round has changed a movable body of the block.
    fn is_changed(&self, block: &ContactBlock) -> bool {
        let mut movable = block.bodies.iter().flatten().filter(|&body| body & READ_ONLY == 0);
        movable.any(|&body| self.touched.is_changed(body))
    }

    /// # Safety
    /// The caller has exclusive access to the block, and no other thread writes the states of its bodies.
    #[inline(always)]
    unsafe fn visit<W: Wide>(&self, index: usize) {
        let (states, pass) = (&self.states, self.pass);
        // SAFETY: the caller's promise.
        unsafe {
            let mark = self.marks.get_mut(index);
            let is_of_interest = match self.phase {
                ImpactPhase::Begin | ImpactPhase::Mark => true,
                ImpactPhase::Defer => mark.has_points_to_defer(),
                ImpactPhase::Friction => mark.was_active,
            };
            if !is_of_interest {
                return;
            }
            let impact = self.impacts.get_mut(index);
            let (block, coulomb) = self.contacts.get(impact.at);
            match self.phase {
                ImpactPhase::Begin => {
                    if mark.is_deferred() {
                        impact.restore(mark, block);
                    }
                    *mark = ImpactMark::default();
                    let rows = NormalRows::<W>::gather(states, block);
                    impact.begin(&rows, block, self.known, pass);
                    impact.mark(mark, &rows, block, pass);
                }
                // Unchanged blocks keep their last mark.
                ImpactPhase::Mark if !self.is_changed(block) => {}
                ImpactPhase::Mark => {
                    let rows = NormalRows::<W>::gather(states, block);
                    impact.mark(mark, &rows, block, pass);
                }
                ImpactPhase::Defer => impact.defer(mark, block),
                ImpactPhase::Friction => impact.solve_friction::<W>(block, coulomb, states),
            }
        }
    }
}
