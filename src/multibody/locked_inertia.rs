//! The locked body of a multibody: one rigid body, as if all its joints were locked.
//!
//! ```text
//! m = Σ mᵢ        c = Σ mᵢ xᵢ / m        I = Σ Iᵢ - mᵢ [xᵢ - c]ₓ²
//! ```
//!
//! The motion of the links is the sum of two motions. The locked body moves with the same linear and angular
//! momentum, and the change of shape has no momentum. They are orthogonal in the mass matrix, so the energy
//! is the sum of their energies. (Locked inertia tensor: Marsden, Ratiu, "Introduction to Mechanics and
//! Symmetry", 1999.) Two rules follow:
//!
//! * Among all motions that correct a missing momentum, that of the locked body has the least energy. Applied
//!   to the root alone, a moment of a few roundings about the axis of a thin limb on a ball joint spins that
//!   limb. A straight chain is a thin locked body. Its missing momentum about that axis is therefore
//!   corrected slowly, or soon about another axis, as the chain rotates.
//! * Excess energy can be taken from the change of shape. This conserves the linear and angular momentum in
//!   every frame of reference.

use super::kinematics::Kinematics;
use super::spatial::{AngularMatrix, SpatialMatrix, ZERO, add_scaled};
use crate::dim::math::{ANG_DIM, DIM, Real, SPATIAL_DIM, SpatialVector, Vector, cross, torque};
use crate::dim::spatial::{ANG_AXES, ang_components};

/// Regularisation of the locked inertia when it corrects a missing momentum, as a fraction of the sum of its
/// moments of inertia.
const REGULARISATION_FRACTION: Real = 0.05;
/// Number of rounds of the correction.
const ROUNDS: usize = 6;
/// A pivot of the inertia below this fraction of its diagonal element is rounding.
const PIVOT_MIN: Real = 64.0 * Real::EPSILON;

/// See the [module](self). Momenta are about the root's centre of mass, and rates those of the root: zero
/// along its locked axes.
#[derive(Clone, Debug, Default)]
pub struct LockedInertia {
    matrix: SpatialMatrix,
    /// The inverse of the matrix with the regularisation.
    inv_regularised: SpatialMatrix,
    /// Whether the root can move along or about each axis.
    is_free: [bool; SPATIAL_DIM],
}

impl LockedInertia {
    /// The locked inertia of the links at their poses. Without degrees of freedom of the root, the locked
    /// body does not move.
    pub fn of(kinematics: &Kinematics) -> Self {
        let mut locked = Self::default();
        if kinematics.root_axes.is_empty() {
            return locked;
        }
        let root = kinematics.links[0].center;
        let (mut mass, mut moment) = (0.0, Vector::ZERO);
        let mut inertia: AngularMatrix = [[0.0; ANG_DIM]; ANG_DIM];
        for link in &kinematics.links {
            let arm = link.center - root;
            (mass, moment) = (mass + link.mass, moment + arm * link.mass);
            for ((row, own), axis) in inertia.iter_mut().zip(&link.inertia).zip(ANG_AXES) {
                let of_mass = ang_components(torque(arm, cross(axis, arm)) * link.mass);
                for k in 0..ANG_DIM {
                    row[k] += own[k] + of_mass[k];
                }
            }
        }
        let trace: Real = (0..ANG_DIM).map(|k| inertia[k][k]).sum();
        locked.matrix = SpatialMatrix::composite(mass, moment, &inertia);
        for &axis in &kinematics.root_axes {
            locked.is_free[axis] = true;
        }
        // About the common centre of mass: the sum of moments of inertia about all axes loses twice `m r²`
        // in 3D, and once in 2D.
        let of_root = (DIM - 1) as Real * moment.length_squared() / mass;
        let trace = if of_root < trace { trace - of_root } else { 0.0 };
        let mut more = ZERO;
        more[DIM..].fill(REGULARISATION_FRACTION * trace);
        let mut regularised = locked.matrix;
        regularised.add_diagonal(&more);
        locked.inv_regularised = regularised.inverse(&locked.least_pivots());
        locked
    }

    /// The rates at which the locked body has a momentum.
    pub fn rates_at(&self, momentum: &SpatialVector) -> SpatialVector {
        self.matrix.inverse(&self.least_pivots()).mul(momentum)
    }

    /// The rates that correct a missing momentum, except about thin axes.
    ///
    /// Each round corrects the fraction `I / (I + S)` of the rest, with the regularisation `S`. Six rounds
    /// leave a few millionths about axes that are not thin, and correct almost nothing about thin ones.
    pub fn correction(&self, missing: &SpatialVector) -> SpatialVector {
        let (mut rest, mut sum) = (*missing, ZERO);
        for _ in 0..ROUNDS {
            let rates = self.inv_regularised.mul(&rest);
            add_scaled(&mut sum, &rates, 1.0);
            add_scaled(&mut rest, &self.matrix.mul(&rates), -1.0);
        }
        sum
    }

    fn least_pivots(&self) -> SpatialVector {
        let diagonal = self.matrix.diagonal();
        core::array::from_fn(|k| if self.is_free[k] { PIVOT_MIN * diagonal[k] } else { Real::MAX })
    }
}
