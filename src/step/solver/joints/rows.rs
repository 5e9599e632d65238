//! Rows: the response of two bodies to an impulse along one, and the joint solution of several.

use super::block::{JointBlock, Wrench};
use crate::base::wide::{Lane, Wide};
use crate::dim::math::Real;
use crate::dim::state::WideMotion;
use crate::dim::wide::{
    ANG_ZERO_LANES, WideAngVector, WideSymmetric, WideVector, ang_dot, load_ang, mul_inertia,
    select_ang, store_ang,
};

/// A pivot smaller than this fraction of the diagonal is rounding: the row is redundant.
const PIVOT_MIN: Real = 64.0 * Real::EPSILON;

/// One row of the Jacobian: `Ċ = linear·(v2 - v1) + angular[1]·ω2 - angular[0]·ω1`.
#[derive(Copy, Clone)]
pub(super) struct Row<W> {
    pub linear: WideVector<W>,
    pub angular: [WideAngVector<W>; 2],
}

impl<W: Wide> Row<W> {
    #[inline(always)]
    pub fn zero() -> Self {
        Self { linear: WideVector::zero(), angular: [zero_ang(); 2] }
    }

    /// This row where the mask is set, and another one elsewhere.
    #[inline(always)]
    pub fn select(&self, mask: W::Mask, other: Self) -> Self {
        Self {
            linear: WideVector::select(mask, self.linear, other.linear),
            angular: [
                select_ang(mask, self.angular[0], other.angular[0]),
                select_ang(mask, self.angular[1], other.angular[1]),
            ],
        }
    }

    /// This row minus a multiple of another.
    #[inline(always)]
    pub fn minus(mut self, other: &Self, fraction: W) -> Self {
        self.linear = self.linear - other.linear * fraction;
        for side in 0..2 {
            self.angular[side] = self.angular[side] - other.angular[side] * fraction;
        }
        self
    }

    /// The rate of change of the constraint.
    #[inline(always)]
    pub fn rate(&self, [m1, m2]: &[WideMotion<W>; 2]) -> W {
        self.linear.dot(m2.linear - m1.linear) + ang_dot(self.angular[1], m2.angular)
            - ang_dot(self.angular[0], m1.angular)
    }
}

/// The bodies' inverse masses.
pub(super) struct Masses<W> {
    /// The sum of both, per axis of the world.
    sum: WideVector<W>,
    each: [WideVector<W>; 2],
    inertia: [WideSymmetric<W>; 2],
}

impl<W: Wide> Masses<W> {
    #[inline(always)]
    pub fn load(block: &JointBlock) -> Self {
        let each = [WideVector::load(&block.inv_mass[0]), WideVector::load(&block.inv_mass[1])];
        Self { sum: each[0] + each[1], each, inertia: block.inertias.load() }
    }

    /// `M⁻¹ Jᵀ` of a row, as velocity changes per unit of impulse: the second body's, and the negatives of
    /// the first one's. The linear part is the sum over both bodies.
    #[inline(always)]
    fn response(&self, row: &Row<W>) -> Row<W> {
        Row {
            linear: row.linear.component_mul(self.sum),
            angular: [
                mul_inertia(self.inertia[0], row.angular[0]),
                mul_inertia(self.inertia[1], row.angular[1]),
            ],
        }
    }

    /// `J M⁻¹ Jᵀ` of a row.
    #[inline(always)]
    pub fn effective(&self, row: &Row<W>) -> W {
        dot(row, &self.response(row))
    }

    /// `J M⁻¹ Jᵀ` of several rows with another.
    #[inline(always)]
    pub fn couplings<const N: usize>(&self, rows: &[Row<W>; N], other: &Row<W>) -> [W; N] {
        let response = self.response(other);
        let mut couplings = [W::zero(); N];
        for (coupling, row) in couplings.iter_mut().zip(rows) {
            *coupling = dot(row, &response);
        }
        couplings
    }

    /// `J M⁻¹ Jᵀ` of all locked axes; a row that is not locked is alone, with one on the diagonal.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn coupling<const N: usize>(&self, rows: &[Row<W>; N], locked: &[W; N]) -> [[W; N]; N] {
        let mut k = [[W::zero(); N]; N];
        for i in 0..N {
            let response = self.response(&rows[i]);
            for j in 0..=i {
                k[i][j] = dot(&rows[j], &response) * (locked[i] * locked[j]);
            }
            k[i][i] = k[i][i] + (W::splat(1.0) - locked[i]);
        }
        k
    }

    /// Changes of the angular velocities by a wrench.
    #[inline(always)]
    pub fn angvel_change(&self, wrench: &Wrench<W>) -> [WideAngVector<W>; 2] {
        [
            -mul_inertia(self.inertia[0], wrench.angular[0]),
            mul_inertia(self.inertia[1], wrench.angular[1]),
        ]
    }

    /// The velocities after a wrench has acted.
    #[inline(always)]
    pub fn push(&self, wrench: &Wrench<W>, velocities: [WideMotion<W>; 2]) -> [WideMotion<W>; 2] {
        let [mut m1, mut m2] = self.push_along(wrench.linear, velocities);
        let [change1, change2] = self.angvel_change(wrench);
        m1.angular = m1.angular + change1;
        m2.angular = m2.angular + change2;
        [m1, m2]
    }

    /// The velocities after an impulse at the centres of mass.
    #[inline(always)]
    pub fn push_along(
        &self,
        impulse: WideVector<W>,
        [mut m1, mut m2]: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        m1.linear = m1.linear - impulse.component_mul(self.each[0]);
        m2.linear = m2.linear + impulse.component_mul(self.each[1]);
        [m1, m2]
    }
}

#[inline(always)]
fn dot<W: Wide>(a: &Row<W>, b: &Row<W>) -> W {
    a.linear.dot(b.linear)
        + ang_dot(a.angular[0], b.angular[0])
        + ang_dot(a.angular[1], b.angular[1])
}

#[inline(always)]
fn zero_ang<W: Wide>() -> WideAngVector<W> {
    load_ang(&ANG_ZERO_LANES)
}

impl<W: Wide> Wrench<W> {
    #[inline(always)]
    pub fn zero() -> Self {
        Self { linear: WideVector::zero(), angular: [zero_ang(); 2] }
    }

    #[inline(always)]
    pub fn load(from: &Wrench<Lane>) -> Self {
        let [first, second] = &from.angular;
        Self {
            linear: WideVector::load(&from.linear),
            angular: [load_ang(first), load_ang(second)],
        }
    }

    #[inline(always)]
    pub fn store(self, to: &mut Wrench<Lane>) {
        self.linear.store(&mut to.linear);
        store_ang(self.angular[0], &mut to.angular[0]);
        store_ang(self.angular[1], &mut to.angular[1]);
    }

    /// Adds an impulse along a row.
    #[inline(always)]
    pub fn add(&mut self, row: &Row<W>, impulse: W) {
        self.linear = self.linear + row.linear * impulse;
        for side in 0..2 {
            self.angular[side] = self.angular[side] + row.angular[side] * impulse;
        }
    }

    /// This one and another together.
    #[inline(always)]
    pub fn plus(self, other: &Self) -> Self {
        Self {
            linear: self.linear + other.linear,
            angular: [self.angular[0] + other.angular[0], self.angular[1] + other.angular[1]],
        }
    }

    /// This one without another.
    #[inline(always)]
    pub fn minus(self, other: &Self) -> Self {
        Self {
            linear: self.linear - other.linear,
            angular: [self.angular[0] - other.angular[0], self.angular[1] - other.angular[1]],
        }
    }
}

/// A symmetric matrix of which the lower half is given, factorised `L D Lᵀ` (Golub and Van Loan, "Matrix
/// Computations", section 4.1).
pub(super) struct Factored<W, const N: usize> {
    l: [[W; N]; N],
    inverses: [W; N],
}

impl<W: Wide, const N: usize> Factored<W, N> {
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn new(mut k: [[W; N]; N]) -> Self {
        let mut inverses = [W::zero(); N];
        for j in 0..N {
            let diagonal = k[j][j];
            let mut pivot = diagonal;
            let mut scaled = [W::zero(); N];
            for m in 0..j {
                scaled[m] = k[j][m] * k[m][m];
                pivot = pivot - k[j][m] * scaled[m];
            }
            let usable = (diagonal * W::splat(PIVOT_MIN)).lt(pivot);
            let one = W::splat(1.0);
            inverses[j] = W::select(usable, one / W::select(usable, pivot, one), W::zero());
            k[j][j] = W::select(usable, pivot, W::zero());
            for i in j + 1..N {
                let mut sum = k[i][j];
                for m in 0..j {
                    sum = sum - k[i][m] * scaled[m];
                }
                k[i][j] = sum * inverses[j];
            }
        }
        Self { l: k, inverses }
    }

    /// Solves `K x = b`. Rows that nothing can move get 0.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn solve(&self, mut b: [W; N]) -> [W; N] {
        for i in 0..N {
            for m in 0..i {
                b[i] = b[i] - self.l[i][m] * b[m];
            }
        }
        for i in (0..N).rev() {
            b[i] = b[i] * self.inverses[i];
            for m in i + 1..N {
                b[i] = b[i] - self.l[m][i] * b[m];
            }
        }
        b
    }
}
