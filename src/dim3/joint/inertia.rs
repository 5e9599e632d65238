//! The inertia of a body as one number.

use crate::dim3::math::{AngularInertia, Real};

/// The harmonic mean of the moments of inertia of a body with this inverse; `None` if it cannot turn.
pub(crate) fn inertia_about(inv_inertia: &AngularInertia) -> Option<Real> {
    let sum = inv_inertia.m11 + inv_inertia.m22 + inv_inertia.m33;
    (sum > 0.0).then(|| 3.0 / sum)
}

/// Moments that differ by less than this share make no visible difference.
const ROUNDNESS: Real = 1.0e-3;

/// Are the moments of inertia about all axes the same?
pub(crate) fn is_round(inv_inertia: &AngularInertia) -> bool {
    let m = inv_inertia;
    let differences = [m.m11 - m.m22, m.m22 - m.m33, m.m33 - m.m11, m.m12, m.m13, m.m23];
    let largest =
        differences.into_iter().fold(0.0, |largest: Real, value| largest.max(value.abs()));
    largest <= ROUNDNESS * (m.m11 + m.m22 + m.m33)
}

/// The inertia of a body whose moments are all 1.
#[cfg(test)]
pub(crate) fn unit_inertia() -> AngularInertia {
    AngularInertia { m11: 1.0, m22: 1.0, m33: 1.0, ..AngularInertia::zero() }
}
