//! Taut components that gained energy by being projected.
//!
//! Taut joints lead their bodies to where they would go freely, and from there to the nearest place that the joints allow (`taut.rs`). The
//! velocity `v*` that leads to the nearest place has no more energy than the free one `v`: with the impulses `λ` along
//! the rows `J` at the end, and pulls `λ > 0` that curve the way,
//!
//! ```text
//! T(v) - T(v*) = ½ λᵀ J M⁻¹ Jᵀ λ + λᵀ J v*      and   h J v* = ½ h² v*ᵀ ∇²C v* > 0
//! ```
//!
//! But what Newton's method finds need not be the nearest place. Who is far from where the joints let him be, farther than `I/(m r)` for a
//! body of mass `m` and inertia `I` that is held at the lever `r`, has several places that no small step makes nearer, as a rod
//! pushed along itself buckles to either side. Thin limbs with anchors far outside are there after one blow of a contact, and came
//! out of the projection with ten times the energy.
//!
//! So the work of the impulses is counted: what a push `p` does to a velocity `V` is `p·V + ½ p M⁻¹ p`. All of it may be what the
//! correction of errors brings in, `½ bᵀ A⁻¹ b` with the bias `b` and `A = J M⁻¹ Jᵀ`, since a projection on `J v = -b` brings in no
//! more. A component that gained more is set back to where its rounds began, and solved once where its bodies are, without looking
//! ahead: for this substep it keeps to its joints along tangents.

use super::block::JointBlock;
use crate::dim::state::BodyState;

/// How bodies and joints were when the rounds of a solve pass began.
#[derive(Default)]
pub(super) struct Guard {
    states: Vec<BodyState>,
    blocks: Vec<JointBlock>,
}

impl Guard {
    pub fn remember(&mut self, states: &[BodyState], blocks: &[JointBlock]) {
        self.states.clear();
        self.states.extend_from_slice(states);
        self.blocks.clear();
        self.blocks.extend_from_slice(blocks);
    }

    /// The velocity that a body had.
    pub fn set_back(&self, body: u32, state: &mut BodyState) {
        let (v, w) = self.states[body as usize].velocity();
        state.set_velocity(v, w);
    }

    /// The impulses that the joint in a lane of a block had given.
    pub fn take_back(&self, index: usize, lane: usize, block: &mut JointBlock) {
        block.set_impulses(lane, &self.blocks[index]);
    }
}
