//! The bodies of a block while it is prepared.

use super::block::ContactBlock;
use super::rows::Frame;
use crate::base::wide::Wide;
use crate::dim2::state::WidePose;
use crate::dim2::wide::{WideSymmetric, WideVector};
use crate::model::contact::{ContactInput, Turning};

/// The bodies of a block and the frame of its contacts.
pub(crate) struct Pair<W> {
    pub frame: Frame<W>,
    /// `c = x1 - x2` in the contact frame.
    pub offset: WideVector<W>,
    /// Inverse masses along the axes of the world.
    pub inv_mass: [WideVector<W>; 2],
    pub inv_inertia: [WideSymmetric<W>; 2],
}

impl<W: Wide> Pair<W> {
    /// Stores the frame and the inverse masses of bodies in a block.
    #[inline(always)]
    pub fn store(
        input: &ContactInput,
        block: &mut ContactBlock,
        frame: Frame<W>,
        offset: WideVector<W>,
        poses: &[WidePose<W>; 2],
    ) -> Self {
        frame.n.store(&mut block.normal);
        offset.store(&mut block.offset);
        let mut inv_mass = [WideVector::zero(); 2];
        let mut inv_inertia = [W::zero(); 2];
        for side in 0..2 {
            // A dominated body cannot move a dominant one.
            let factor = W::load(&input.mass_factors[side]);
            inv_mass[side] = poses[side].inv_mass * factor;
            inv_mass[side].store(&mut block.inv_mass[side]);
            inv_inertia[side] = poses[side].inv_inertia * factor;
            inv_inertia[side].store(&mut block.inv_inertia[side]);
        }
        Self { frame, offset, inv_mass, inv_inertia }
    }

    /// The tangential velocity of a point, relative to the first body, that the [turns](Turning) of the bodies
    /// add.
    #[inline(always)]
    pub fn turn(&self, point: WideVector<W>, turning: Turning<W>) -> W {
        let arms = [point, point + self.offset];
        let mut turns = [W::zero(); 2];
        for side in 0..2 {
            let (r, w) = (arms[side], turning.angvels[side]);
            let [tangent, chord] = turning.factors(w * w, self.inv_mass[side]);
            turns[side] = -(tangent * w * r.y) - chord * w * w * r.x;
        }
        turns[1] - turns[0]
    }

    /// The angular part of `J_i M⁻¹ J_jᵀ` of two points, with `ρ × n = ρₜ`.
    #[inline(always)]
    pub fn angular_part(&self, [a]: [W; 1], [b]: [W; 1]) -> W {
        let c = self.offset.x;
        self.inv_inertia[0] * a * b + self.inv_inertia[1] * (a + c) * (b + c)
    }
}
