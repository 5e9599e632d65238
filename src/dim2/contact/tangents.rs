//! The tangential row of one point, within Coulomb's cone.

use crate::dim2::math::Real;

/// Effective mass of the tangential row of one point, outside of lanes.
#[derive(Copy, Clone, Debug)]
pub(crate) struct PointTangentMass(Real);

impl PointTangentMass {
    /// The effective mass of a row. A plane has one tangent, so rows have no coupling.
    pub fn of([mass]: [Real; 1], _coupling: impl Fn() -> Real) -> Self {
        Self(mass)
    }

    /// The new impulse of the row: at most `limit`.
    pub fn friction(&self, [old]: [Real; 1], [slip]: [Real; 1], limit: Real) -> [Real; 1] {
        let stopping = old - slip * self.0;
        let length = stopping.abs();
        [if length > limit { stopping * (limit / length) } else { stopping }]
    }
}
