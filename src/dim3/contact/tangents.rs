//! Two tangential rows at one point, solved together within Coulomb's cone.
//!
//! The impulse that stops the slip `s` is `λt - K⁻¹ s`. If it is outside the cone, the point slides, and
//! friction is opposite to the slip (maximum dissipation). `K⁻¹ s` has another direction, because an impulse
//! that rotates a body meets a smaller effective mass. The impulse therefore follows the slip itself, and
//! Coulomb's law is the fixed point:
//!
//! ```text
//! λt ← λt - K⁻¹ s                               within the cone
//! λt ← μ N d/|d|,   d = λt - ρ s                else; ρ the smallest eigenvalue of K⁻¹, so that it contracts
//! ```
//!
//! (de Saxcé, Feng, "The bipotential method", 1998.) Shortening `λt - K⁻¹ s` to the cone is not sufficient.
//! With it, a beam of 4×0.5×0.5 m that slid at 45° to its axis turned by 11° and slid 6 % too far.

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

    /// The new impulse of the rows. It stops the slip, or has the size `limit` if that is smaller.
    #[inline(always)]
    pub fn friction(self, [old_x, old_y]: [W; 2], [slip_x, slip_y]: [W; 2], limit: W) -> [W; 2] {
        let [m11, m12, m22] = self.matrix;
        let rho = self.eigenvalue_min;
        let stopping =
            [old_x - (m11 * slip_x + m12 * slip_y), old_y - (m12 * slip_x + m22 * slip_y)];
        let [x, y] = [old_x - rho * slip_x, old_y - rho * slip_y];
        let scale = limit / (x * x + y * y).sqrt().max(W::splat(Real::MIN_POSITIVE));
        let sticks = (stopping[0] * stopping[0] + stopping[1] * stopping[1]).le(limit * limit);
        [W::select(sticks, stopping[0], x * scale), W::select(sticks, stopping[1], y * scale)]
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
