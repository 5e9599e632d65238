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

use super::factor::{Factor, Resistance};
use super::kinematics::{Kinematics, LinkFrame};
use super::spatial::{AngularMatrix, ZERO, add_scaled, carry, carry_back};
use crate::dim::math::{
    ANG_DIM, ANG_ZERO, Real, SPATIAL_DIM, SpatialVector, Vector, cross, torque,
};
use crate::dim::spatial::{ANG_AXES, ang_components, angular};

/// Regularisation of the locked inertia when it corrects a missing momentum, as a fraction of the sum of its
/// moments of inertia.
const REGULARISATION_FRACTION: Real = 0.05;
/// Number of rounds of the correction.
const ROUNDS: usize = 6;

/// See the [module](self). Its degrees of freedom are the root's.
#[derive(Clone, Debug, Default)]
pub struct LockedInertia {
    /// A single link.
    body: Kinematics,
    factor: Factor,
    /// From the root's centre of mass to that of the locked body.
    reach: Vector,
    rates: Vec<Real>,
}

impl LockedInertia {
    /// The locked inertia of the links at their poses. Without degrees of freedom of the
    /// root, the locked body does not move.
    pub fn update(&mut self, kinematics: &Kinematics) {
        let root = &kinematics.links[0];
        self.body.links.clear();
        self.body.axes.clear();
        if root.dofs.is_empty() {
            return;
        }
        let mass: Real = kinematics.links.iter().map(|link| link.mass).sum();
        let moment = |sum: Vector, link: &LinkFrame| sum + (link.center - root.center) * link.mass;
        let moment = kinematics.links.iter().fold(Vector::ZERO, moment);
        self.reach = if mass > 0.0 { moment / mass } else { Vector::ZERO };
        let center = root.center + self.reach;
        let mut inertia: AngularMatrix = [[0.0; ANG_DIM]; ANG_DIM];
        for link in &kinematics.links {
            let arm = link.center - center;
            for ((row, own), axis) in inertia.iter_mut().zip(&link.inertia).zip(ANG_AXES) {
                let of_mass = ang_components(torque(arm, cross(axis, arm)) * link.mass);
                for k in 0..ANG_DIM {
                    row[k] += own[k] + of_mass[k];
                }
            }
        }
        let axes = &kinematics.axes[root.dofs.clone()];
        self.body.axes.extend(axes.iter().map(|axis| carry(axis, self.reach)));
        self.body.links.push(LinkFrame { center, mass, inertia, ..root.clone() });
    }

    /// Adds its inertia up, with this much more of it about or along each axis.
    fn resist(&mut self, armature: impl Fn(&SpatialVector) -> Real) {
        let mut resisting = [0.0; SPATIAL_DIM];
        let axes = &self.body.axes;
        resisting.iter_mut().zip(axes).for_each(|(own, axis)| *own = armature(axis));
        let armature = &resisting[..axes.len()];
        self.factor.update(&self.body, Resistance { armature, drag: &[] });
    }

    /// The rates of the root's degrees of freedom at which the locked body has a momentum, given about the
    /// root's centre of mass.
    pub fn rates_at(&mut self, momentum: &SpatialVector) -> &[Real] {
        self.resist(|_| 0.0);
        self.solve(&carry_back(momentum, -self.reach));
        &self.rates
    }

    /// The rates that correct a missing momentum, except about thin axes.
    ///
    /// Each round corrects the fraction `I / (I + S)` of the rest, with the regularisation `S`. Six rounds
    /// leave a few millionths about axes that are not thin, and correct almost nothing about thin ones.
    pub fn correction(&mut self, missing: &SpatialVector) -> &[Real] {
        let link = &self.body.links[0];
        let regularisation =
            REGULARISATION_FRACTION * (0..ANG_DIM).map(|k| link.inertia[k][k]).sum::<Real>();
        self.resist(|axis| if angular(axis) == ANG_ZERO { 0.0 } else { regularisation });
        let mut rest = carry_back(missing, -self.reach);
        let mut sum = [0.0; SPATIAL_DIM];
        for _ in 0..ROUNDS {
            self.solve(&rest);
            let mut velocity = ZERO;
            for (dof, (axis, rate)) in self.body.axes.iter().zip(&self.rates).enumerate() {
                add_scaled(&mut velocity, axis, *rate);
                sum[dof] += rate;
            }
            add_scaled(&mut rest, &self.body.links[0].momentum(&velocity), -1.0);
        }
        let count = self.rates.len();
        self.rates.copy_from_slice(&sum[..count]);
        &self.rates
    }

    /// The rates that a momentum about the centre of mass of the locked body leads to.
    fn solve(&mut self, momentum: &SpatialVector) {
        self.rates.clear();
        self.rates.resize(self.body.axes.len(), 0.0);
        self.factor.solve(&self.body, &[*momentum], &mut self.rates);
    }
}
