//! The bodies of a block while it is prepared.

use super::block::ContactBlock;
use super::rows::Frame;
use crate::base::wide::Wide;
use crate::dim3::state::WidePose;
use crate::dim3::wide::{WideSymmetric, WideVector};
use crate::model::contact::{ContactInput, Turning};

/// The bodies of a block and the frame of its contacts.
pub(crate) struct Pair<W> {
    pub frame: Frame<W>,
    /// `c = x1 - x2` in the contact frame.
    pub offset: WideVector<W>,
    /// Inverse masses along the axes of the world.
    pub inv_mass: [WideVector<W>; 2],
    /// Inverse inertias in the contact frame.
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
        frame.t1.store(&mut block.tangent);
        offset.store(&mut block.offset);
        let mut inv_mass = [WideVector::zero(); 2];
        let mut columns = [[WideVector::zero(); 3]; 2];
        for side in 0..2 {
            // A dominated body cannot move a dominant one.
            let factor = W::load(&input.mass_factors[side]);
            inv_mass[side] = poses[side].inv_mass * factor;
            inv_mass[side].store(&mut block.inv_mass[side]);
            let world = frame.columns(poses[side].inv_inertia);
            for axis in 0..3 {
                columns[side][axis] = world[axis] * factor;
                columns[side][axis].store(&mut block.inv_inertia[axis][side]);
            }
        }
        let inv_inertia = [frame.local_symmetric(columns[0]), frame.local_symmetric(columns[1])];
        Self { frame, offset, inv_mass, inv_inertia }
    }

    /// The tangential velocity of a point, relative to the first body, that the [turns](Turning) of the bodies
    /// add.
    #[inline(always)]
    pub fn turn(&self, point: WideVector<W>, turning: Turning<W>) -> [W; 2] {
        let arms = [point, point + self.offset];
        let mut turns = [[W::zero(); 2]; 2];
        for side in 0..2 {
            let (r, w) = (arms[side], self.frame.local(turning.angvels[side]));
            let (along, square) = (w.dot(r), w.dot(w));
            let [tangent, chord] = turning.factors(square, self.inv_mass[side]);
            turns[side] = [
                tangent * (w.y * r.z - w.z * r.y) + chord * (w.x * along - r.x * square),
                tangent * (w.z * r.x - w.x * r.z) + chord * (w.y * along - r.y * square),
            ];
        }
        [turns[1][0] - turns[0][0], turns[1][1] - turns[0][1]]
    }

    /// The angular part of `J_i M⁻¹ J_jᵀ` of two points, with `ρ × n = (ρ₂, -ρ₁, 0)`.
    #[inline(always)]
    pub fn angular_part(&self, [ix, iy]: [W; 2], [jx, jy]: [W; 2]) -> W {
        let c = self.offset;
        let [i1, i2] = self.inv_inertia;
        arm_product(i1, [ix, iy], [jx, jy])
            + arm_product(i2, [ix + c.x, iy + c.y], [jx + c.x, jy + c.y])
    }
}

/// `(a₂, -a₁, 0) I⁻¹ (b₂, -b₁, 0)ᵀ`.
#[inline(always)]
fn arm_product<W: Wide>(inv_inertia: WideSymmetric<W>, a: [W; 2], b: [W; 2]) -> W {
    inv_inertia.m11 * a[1] * b[1] - inv_inertia.m12 * (a[1] * b[0] + a[0] * b[1])
        + inv_inertia.m22 * a[0] * b[0]
}
