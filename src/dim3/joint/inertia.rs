//! The inertia of a body as one number.

use crate::dim3::math::{AngularInertia, Real};

/// The harmonic mean of the moments of inertia of a body with this inverse; `None` if it cannot turn.
pub(crate) fn inertia_about(inv_inertia: &AngularInertia) -> Option<Real> {
    let sum = inv_inertia.m11 + inv_inertia.m22 + inv_inertia.m33;
    (sum > 0.0).then(|| 3.0 / sum)
}
