//! The contact frame, and the common operations of its rows: velocities out of the bodies, impulses into
//! them.

use super::block::ContactBlock;
use crate::base::wide::Wide;
use crate::dim3::state::WideMotion;
use crate::dim3::wide::{WideSymmetric, WideVector, cross, mul_inertia};

/// The axes of the contact frame in world space.
#[derive(Copy, Clone)]
pub(crate) struct Frame<W> {
    pub t1: WideVector<W>,
    pub t2: WideVector<W>,
    pub n: WideVector<W>,
}

impl<W: Wide> Frame<W> {
    /// A right-handed frame about a unit normal (Duff et al. 2017, see
    /// [`tangents`](crate::dim3::math::tangents)).
    #[inline(always)]
    pub fn about(n: WideVector<W>) -> Self {
        let one = W::splat(1.0);
        let sign = W::select(n.z.lt(W::zero()), -one, one);
        let a = -one / (sign + n.z);
        let t1 = WideVector {
            x: one + sign * n.x * n.x * a,
            y: sign * (n.x * n.y * a),
            z: -(sign * n.x),
        };
        Self { t1, t2: cross(n, t1), n }
    }

    /// The contact frame of a block, which stores two of the axes.
    #[inline(always)]
    pub fn load(block: &ContactBlock) -> Self {
        let n = WideVector::load(&block.normal);
        let t1 = WideVector::load(&block.tangent);
        Self { t1, t2: cross(n, t1), n }
    }

    /// World to contact frame.
    #[inline(always)]
    pub fn local(&self, v: WideVector<W>) -> WideVector<W> {
        WideVector { x: self.t1.dot(v), y: self.t2.dot(v), z: self.n.dot(v) }
    }

    /// The first two components of [`Self::local`].
    #[inline(always)]
    pub fn tangential(&self, v: WideVector<W>) -> [W; 2] {
        [self.t1.dot(v), self.t2.dot(v)]
    }

    /// `I⁻¹ t1`, `I⁻¹ t2` and `I⁻¹ n` of an inverse inertia in world space. They are the angular velocities
    /// per moment about the axes of the contact frame.
    #[inline(always)]
    pub fn columns(&self, inv_inertia: WideSymmetric<W>) -> [WideVector<W>; 3] {
        [
            mul_inertia(inv_inertia, self.t1),
            mul_inertia(inv_inertia, self.t2),
            mul_inertia(inv_inertia, self.n),
        ]
    }

    /// The inverse inertia in the contact frame, from its [`Self::columns`].
    #[inline(always)]
    pub fn local_symmetric(&self, [c1, c2, c3]: [WideVector<W>; 3]) -> WideSymmetric<W> {
        WideSymmetric {
            m11: self.t1.dot(c1),
            m12: self.t1.dot(c2),
            m13: self.t1.dot(c3),
            m22: self.t2.dot(c2),
            m23: self.t2.dot(c3),
            m33: self.n.dot(c3),
        }
    }
}

/// The normal component of a relative motion, as a function of the point in the contact plane.
#[derive(Copy, Clone)]
pub(crate) struct NormalRow<W> {
    base: W,
    slope_x: W,
    slope_y: W,
}

impl<W: Wide> NormalRow<W> {
    /// The row of two bodies' velocities, or of their displacements.
    #[inline(always)]
    pub fn new(frame: &Frame<W>, c: WideVector<W>, [m1, m2]: [WideMotion<W>; 2]) -> Self {
        let (w1, w2) = (frame.tangential(m1.angular), frame.tangential(m2.angular));
        Self {
            base: frame.n.dot(m2.linear - m1.linear) + c.y * w2[0] - c.x * w2[1],
            slope_x: w1[1] - w2[1],
            slope_y: w2[0] - w1[0],
        }
    }

    /// Its value at a point.
    #[inline(always)]
    pub fn at(&self, [x, y]: [W; 2]) -> W {
        self.base + self.slope_x * x + self.slope_y * y
    }
}

/// The sum of impulses along the normal, on the second body; the first gets the opposite.
#[derive(Copy, Clone)]
pub(crate) struct NormalImpulse<W> {
    sum: W,
    /// Sums of impulse times coordinate.
    sum_x: W,
    sum_y: W,
}

impl<W: Wide> NormalImpulse<W> {
    #[inline(always)]
    pub fn zero() -> Self {
        Self { sum: W::zero(), sum_x: W::zero(), sum_y: W::zero() }
    }

    /// Adds an impulse at a point.
    #[inline(always)]
    pub fn add(&mut self, impulse: W, [x, y]: [W; 2]) {
        self.sum = self.sum + impulse;
        self.sum_x = self.sum_x + impulse * x;
        self.sum_y = self.sum_y + impulse * y;
    }

    /// The velocities after the impulses have acted. Their moment is `ρ × n = (ρ₂, -ρ₁, 0)` times each.
    #[inline(always)]
    pub fn apply(
        &self,
        block: &ContactBlock,
        frame: &Frame<W>,
        velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        let c = WideVector::<W>::load(&block.offset);
        let (x2, y2) = (self.sum_x + self.sum * c.x, self.sum_y + self.sum * c.y);
        let moments = [[self.sum_y, -self.sum_x], [y2, -x2]];
        push(block, frame.n * self.sum, moments, velocities)
    }
}

/// The velocities after an impulse on the second body, and its opposite on the first, with these
/// moments about their centres of mass.
///
/// The impulse is in world space, the moments are the first components in the contact frame (the
/// others are zero).
#[inline(always)]
pub(super) fn push<W: Wide, const N: usize>(
    block: &ContactBlock,
    impulse: WideVector<W>,
    moments: [[W; N]; 2],
    [mut m1, mut m2]: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    m1.linear = m1.linear - impulse.component_mul(WideVector::load(&block.inv_mass[0]));
    m2.linear = m2.linear + impulse.component_mul(WideVector::load(&block.inv_mass[1]));
    for axis in 0..N {
        let [i1, i2] = &block.inv_inertia[axis];
        m1.angular = m1.angular - WideVector::load(i1) * moments[0][axis];
        m2.angular = m2.angular + WideVector::load(i2) * moments[1][axis];
    }
    [m1, m2]
}
