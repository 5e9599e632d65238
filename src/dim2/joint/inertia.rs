//! The inertia of a body as one number.

use crate::dim2::math::{AngularInertia, Real};

/// The moment of inertia of a body with this inverse; `None` if it cannot turn.
pub(crate) fn inertia_about(inv_inertia: &AngularInertia) -> Option<Real> {
    (*inv_inertia > 0.0).then(|| 1.0 / inv_inertia)
}

/// Are the moments of inertia about all axes the same? In 2D there is one.
pub(crate) fn is_round(_inv_inertia: &AngularInertia) -> bool {
    true
}

/// The inertia of a body whose moment is 1.
#[cfg(test)]
pub(crate) fn unit_inertia() -> AngularInertia {
    1.0
}
