//! The contact frame, and the common operations of its rows: velocities out of the bodies, impulses into
//! them.

use super::block::ContactBlock;
use crate::base::wide::Wide;
use crate::dim2::state::WideMotion;
use crate::dim2::wide::{WideAngVector, WideVector, load_symmetric, mul_inertia};

/// The axes of the contact frame in world space.
#[derive(Copy, Clone)]
pub(crate) struct Frame<W> {
    pub t: WideVector<W>,
    pub n: WideVector<W>,
}

impl<W: Wide> Frame<W> {
    /// The right-handed frame of a unit normal, see [`tangents`](crate::dim2::math::tangents).
    #[inline(always)]
    pub fn about(n: WideVector<W>) -> Self {
        Self { t: WideVector { x: n.y, y: -n.x }, n }
    }

    /// The frame of a block.
    #[inline(always)]
    pub fn load(block: &ContactBlock) -> Self {
        Self::about(WideVector::load(&block.normal))
    }

    /// World to contact frame.
    #[inline(always)]
    pub fn local(&self, v: WideVector<W>) -> WideVector<W> {
        WideVector { x: self.t.dot(v), y: self.n.dot(v) }
    }
}

/// The normal component of a relative motion, as a function of the point along the tangent.
#[derive(Copy, Clone)]
pub(crate) struct NormalRow<W> {
    base: W,
    slope: W,
}

impl<W: Wide> NormalRow<W> {
    /// The row of two bodies' velocities, or of their displacements.
    #[inline(always)]
    pub fn new(frame: &Frame<W>, c: WideVector<W>, [m1, m2]: [WideMotion<W>; 2]) -> Self {
        Self {
            base: frame.n.dot(m2.linear - m1.linear) + c.x * m2.angular,
            slope: m2.angular - m1.angular,
        }
    }

    /// Its value at a point.
    #[inline(always)]
    pub fn at(&self, [x]: [W; 1]) -> W {
        self.base + self.slope * x
    }
}

/// The sum of impulses along the normal, on the second body; the first gets the opposite.
#[derive(Copy, Clone)]
pub(crate) struct NormalImpulse<W> {
    sum: W,
    /// About the first centre of mass.
    moment: W,
}

impl<W: Wide> NormalImpulse<W> {
    #[inline(always)]
    pub fn zero() -> Self {
        Self { sum: W::zero(), moment: W::zero() }
    }

    /// Adds an impulse at a point.
    #[inline(always)]
    pub fn add(&mut self, impulse: W, [x]: [W; 1]) {
        self.sum = self.sum + impulse;
        self.moment = self.moment + impulse * x;
    }

    /// The velocities after the impulses have acted.
    #[inline(always)]
    pub fn apply(
        &self,
        block: &ContactBlock,
        frame: &Frame<W>,
        velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        let c = WideVector::<W>::load(&block.offset);
        let moments = [self.moment, self.moment + self.sum * c.x];
        push(block, frame.n * self.sum, moments, velocities)
    }
}

/// The velocities after an impulse on the second body, and its opposite on the first, with these
/// moments about their centres of mass.
#[inline(always)]
pub(super) fn push<W: Wide>(
    block: &ContactBlock,
    impulse: WideVector<W>,
    moments: [WideAngVector<W>; 2],
    [mut m1, mut m2]: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    m1.linear = m1.linear - impulse.component_mul(WideVector::load(&block.inv_mass[0]));
    m2.linear = m2.linear + impulse.component_mul(WideVector::load(&block.inv_mass[1]));
    let inv_inertia =
        [load_symmetric(&block.inv_inertia[0]), load_symmetric(&block.inv_inertia[1])];
    m1.angular = m1.angular - mul_inertia(inv_inertia[0], moments[0]);
    m2.angular = m2.angular + mul_inertia(inv_inertia[1], moments[1]);
    [m1, m2]
}
