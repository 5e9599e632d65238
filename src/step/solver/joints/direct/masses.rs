//! Response of a body to impulses, in double precision.
//!
//! `J M⁻¹ Jᵀ` has no negative eigenvalue if `M⁻¹ Jᵀ` is computed from the same `J` and `M⁻¹` to the last
//! digit. With responses rounded to single precision it has some. A chain of hinges is a beam in the
//! direction of their axes, and its matrix has eigenvalues of 10⁻⁸ beside those of 1. The factorisation then
//! finds pivots of either sign. Such chains exploded.

use crate::dim::math::{ANG_DIM, AngularInertia, DIM, Real, SPATIAL_DIM, Vector, mul_inertia};
use crate::dim::spatial::{ANG_AXES, ang_components};

/// The inverse mass of a body along the axes of the world, and its inverse inertia.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) struct InverseMass {
    linear: [Real; DIM],
    /// By column.
    angular: [[Real; ANG_DIM]; ANG_DIM],
}

impl InverseMass {
    pub fn new(inv_mass: Vector, inv_inertia: &AngularInertia) -> Self {
        Self {
            linear: inv_mass.to_array(),
            angular: ANG_AXES.map(|axis| ang_components(mul_inertia(inv_inertia, axis))),
        }
    }

    /// The velocities that a unit of impulse along a row gives.
    pub fn response(&self, row: &[f64; SPATIAL_DIM]) -> [f64; SPATIAL_DIM] {
        let mut response = [0.0; SPATIAL_DIM];
        for k in 0..DIM {
            response[k] = f64::from(self.linear[k]) * row[k];
        }
        for (column, about) in self.angular.iter().zip(&row[DIM..]) {
            for (response, value) in response[DIM..].iter_mut().zip(column) {
                *response += f64::from(*value) * about;
            }
        }
        response
    }
}
