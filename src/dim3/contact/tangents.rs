//! Two tangential rows at one point, solved together within Coulomb's cone.
//!
//! The impulse that stops the slip `s` is `λt - K⁻¹ s`. If it is outside the cone, the point slides, and
//! friction is opposite to the slip (maximum dissipation). `K⁻¹ s` has another direction, because an impulse
//! that rotates a body meets a smaller effective mass. The impulse of a sliding point therefore follows the
//! slip itself, and is projected on the cone of radius `L = μ N`:
//!
//! ```text
//! p = λt - K⁻¹ s,   d = λt - ρ s                ρ the smallest eigenvalue of K⁻¹
//!
//!       p           if |p| ≤ L                  the point sticks
//! λt ←  L d/|d|     if |p| > L and |d| ≥ L      it slides
//!       L p/|p|     else                          its slip is far from the direction of sliding
//! ```
//!
//! The second line is a step of projected gradient descent on the energy `½ sᵀ K⁻¹ s`, so with this `ρ` the
//! energy decreases. Its fixed point is Coulomb's law: `|λt| = L`, opposite to the slip (de Saxcé, Feng, "The
//! bipotential method", 1998). The impulse of the third line lies between 0 and the minimum of the energy, so
//! it dissipates energy, too. It has no fixed point: that would be `p = c λt` with `c > 1`, hence `λt·s < 0`
//! and `|d| > L`. Two simpler rules are not sufficient:
//!
//! * *The third line instead of the second*: a beam of 4×0.5×0.5 m that slid at 45° to its axis turned by 11°
//!   and slid 6 % too far.
//! * *The second line instead of the third*: after a belt reverses, `d` may still point along the slip.
//!   Friction would then accelerate the sliding.

use crate::base::wide::{Lane, Wide, invert};
use crate::dim3::math::Real;

/// Of two eigenvalues, the smaller one counts if it is at least about this fraction of the larger one. Bodies
/// that can slide freely stay above a hundredth, whatever their shape.
const EIGENVALUE_RATIO_MIN: Real = 1.0e-3;

/// Effective mass of two tangential rows.
#[derive(Copy, Clone, Debug, Default)]
#[repr(C)]
pub(crate) struct TangentMass<N> {
    /// `K⁻¹`: 11, 12, 22.
    matrix: [N; 3],
    /// Its smallest eigenvalue.
    eigenvalue_min: N,
}

impl TangentMass<Lane> {
    /// No friction in any lane.
    pub const ZERO: Self = Self { matrix: [Lane::ZERO; 3], eigenvalue_min: Lane::ZERO };
}

impl<W: Wide> TangentMass<W> {
    /// The effective mass of rows with the matrix `K`: 11, 12, 22.
    #[inline(always)]
    pub fn of(k: [W; 3]) -> Self {
        let matrix = invert_matrix(k);
        Self { matrix, eigenvalue_min: smallest_eigenvalue(matrix) }
    }

    #[inline(always)]
    pub fn load(from: &TangentMass<Lane>) -> Self {
        Self { matrix: load(&from.matrix), eigenvalue_min: W::load(&from.eigenvalue_min) }
    }

    #[inline(always)]
    pub fn store(self, to: &mut TangentMass<Lane>) {
        store(self.matrix, &mut to.matrix);
        self.eigenvalue_min.store(&mut to.eigenvalue_min);
    }

    /// The new impulse of the rows: at most `limit`.
    #[inline(always)]
    pub fn friction(self, [old_x, old_y]: [W; 2], [slip_x, slip_y]: [W; 2], limit: W) -> [W; 2] {
        let ([m11, m12, m22], rho) = (self.matrix, self.eigenvalue_min);
        let stopping =
            [old_x - (m11 * slip_x + m12 * slip_y), old_y - (m12 * slip_x + m22 * slip_y)];
        let sliding = [old_x - rho * slip_x, old_y - rho * slip_y];
        let square = limit * limit;
        let sticks = length_squared(stopping).le(square);
        let slides = square.le(length_squared(sliding));
        let x = W::select(slides, sliding[0], stopping[0]);
        let y = W::select(slides, sliding[1], stopping[1]);
        let scale = limit / length_squared([x, y]).sqrt().max(W::splat(Real::MIN_POSITIVE));
        [W::select(sticks, stopping[0], x * scale), W::select(sticks, stopping[1], y * scale)]
    }
}

#[inline(always)]
fn length_squared<W: Wide>([x, y]: [W; 2]) -> W {
    x * x + y * y
}

/// [`TangentMass`] of one point, outside of lanes.
#[derive(Copy, Clone, Debug)]
pub(crate) struct PointTangentMass {
    matrix: [Real; 3],
    eigenvalue_min: Real,
}

impl PointTangentMass {
    /// The effective mass of two rows with the masses `1 / K₁₁` and `1 / K₂₂` and the coupling `K₁₂`.
    pub fn of(masses: [Real; 2], coupling: impl Fn() -> Real) -> Self {
        let [k11, k22] = masses.map(|mass| if mass > 0.0 { 1.0 / mass } else { 0.0 });
        let k12 = coupling();
        let (trace, det) = (k11 + k22, k11 * k22 - k12 * k12);
        let matrix = if det > EIGENVALUE_RATIO_MIN * trace * trace {
            [k22 / det, -k12 / det, k11 / det]
        } else {
            let mass = if trace > 0.0 { 1.0 / trace } else { 0.0 };
            [mass, 0.0, mass]
        };
        let [m11, m12, m22] = matrix;
        let difference = m11 - m22;
        let eigenvalue_min = 0.5 * (m11 + m22 - (difference * difference + 4.0 * m12 * m12).sqrt());
        Self { matrix, eigenvalue_min }
    }

    /// The new impulses of the rows: together at most `limit`.
    pub fn friction(&self, old: [Real; 2], slip: [Real; 2], limit: Real) -> [Real; 2] {
        let ([m11, m12, m22], rho) = (self.matrix, self.eigenvalue_min);
        let change = [m11 * slip[0] + m12 * slip[1], m12 * slip[0] + m22 * slip[1]];
        let stopping = [old[0] - change[0], old[1] - change[1]];
        let sliding = [old[0] - rho * slip[0], old[1] - rho * slip[1]];
        let length = |[x, y]: [Real; 2]| (x * x + y * y).sqrt();
        if length(stopping) <= limit {
            return stopping;
        }
        let impulse = if length(sliding) >= limit { sliding } else { stopping };
        let scale = limit / length(impulse).max(Real::MIN_POSITIVE);
        impulse.map(|impulse| impulse * scale)
    }
}

/// The inverse of a symmetric 2×2 matrix without negative eigenvalues.
///
/// Bodies with locked axes may be free to slide along one direction alone. Their matrix has one
/// eigenvalue, which is its trace, and a determinant of rounding errors. One over the trace inverts it
/// along that direction, and leaves the impulse parallel to the sliding.
#[inline(always)]
fn invert_matrix<W: Wide>([k11, k12, k22]: [W; 3]) -> [W; 3] {
    let trace = k11 + k22;
    let det = k11 * k22 - k12 * k12;
    let regular = (trace * trace * W::splat(EIGENVALUE_RATIO_MIN)).lt(det);
    let (inv_det, inv_trace) = (invert(det), invert(trace));
    [
        W::select(regular, k22 * inv_det, inv_trace),
        W::select(regular, -(k12 * inv_det), W::zero()),
        W::select(regular, k11 * inv_det, inv_trace),
    ]
}

/// The smallest eigenvalue of a symmetric 2×2 matrix: 11, 12, 22.
#[inline(always)]
fn smallest_eigenvalue<W: Wide>([m11, m12, m22]: [W; 3]) -> W {
    let half = W::splat(0.5);
    let (mean, difference) = (half * (m11 + m22), half * (m11 - m22));
    mean - (difference * difference + m12 * m12).sqrt()
}

#[inline(always)]
pub(super) fn load<W: Wide, const N: usize>(from: &[Lane; N]) -> [W; N] {
    let mut numbers = [W::zero(); N];
    for (number, lane) in numbers.iter_mut().zip(from) {
        *number = W::load(lane);
    }
    numbers
}

#[inline(always)]
pub(super) fn store<W: Wide, const N: usize>(numbers: [W; N], to: &mut [Lane; N]) {
    for (number, lane) in numbers.into_iter().zip(to) {
        number.store(lane);
    }
}
