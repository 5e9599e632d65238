//! Bias forces by inertia alone: recursive Newton–Euler.
//!
//! Links accelerate on curved paths even if no degree of freedom accelerates (Featherstone 2008, section
//! 5.3). Consider the parent `p` and a link. The joint's origin is at `reach` from the parent's centre of
//! mass, and the link's centre of mass at `arm` from there. With the translation velocity `u` along the
//! joint's axes and the relative angular velocity `ω_r`:
//!
//! ```text
//! α = α_p + ω_p × ω_r (+ a₁ × a₂ q̇₁ q̇₂ for two free rotations: a₂ rotates with the first)
//! c = c_p + α_p × reach + ω_p × (ω_p × reach) + 2 ω_p × u + α × arm + ω × (ω × arm)
//! ```
//!
//! That requires the wrench `(m c, I α + ω × I ω)`. The result is its opposite.

use super::kinematics::{Kinematics, LinkFrame};
use super::spatial::{ZERO, angular_momentum};
use crate::dim::math::{ANG_ZERO, AngVector, Real, SpatialVector, Vector, cross};
use crate::dim::spatial::{ang_cross, angular, join, linear};
use crate::model::multibody::Multibody;

impl Kinematics {
    /// By link: the wrench of inertia if no degree of freedom accelerates.
    ///
    /// `velocities` are those of the links at these `rates`; `accelerations` is a buffer.
    pub fn inertial_wrenches(
        &self,
        rates: &[Real],
        velocities: &[SpatialVector],
        accelerations: &mut Vec<SpatialVector>,
        wrenches: &mut Vec<SpatialVector>,
    ) {
        accelerations.clear();
        wrenches.clear();
        for (id, link) in self.links.iter().enumerate() {
            let omega = angular(&velocities[id]);
            let acceleration = match link.parent {
                None => ZERO,
                Some(parent) => {
                    let before = [&velocities[parent], &accelerations[parent]];
                    self.unforced(link, rates, before, omega)
                }
            };
            accelerations.push(acceleration);
            let about = angular_momentum(&link.inertia, angular(&acceleration))
                + ang_cross(omega, angular_momentum(&link.inertia, omega));
            wrenches.push(join(linear(&acceleration) * -link.mass, -about));
        }
    }

    /// The acceleration of a link, given velocity and acceleration of its parent.
    fn unforced(
        &self,
        link: &LinkFrame,
        rates: &[Real],
        [velocity, acceleration]: [&SpatialVector; 2],
        omega: AngVector,
    ) -> SpatialVector {
        let (parent_omega, parent_alpha) = (angular(velocity), angular(acceleration));
        let (slide, spin, spin_turn) = self.relative(link, rates);
        let alpha = parent_alpha + ang_cross(parent_omega, spin) + spin_turn;
        let c = linear(acceleration)
            + cross(parent_alpha, link.reach)
            + cross(parent_omega, cross(parent_omega, link.reach) + slide * 2.0)
            + cross(alpha, link.arm)
            + cross(omega, cross(omega, link.arm));
        join(c, alpha)
    }

    /// Motion of a link relative to its parent: translation velocity, angular velocity, and the rate of
    /// change of the latter's axes.
    fn relative(&self, link: &LinkFrame, rates: &[Real]) -> (Vector, AngVector, AngVector) {
        let first_turn = link.dofs.start + link.slides;
        let (mut slide, mut spin, mut spin_turn) = (Vector::ZERO, ANG_ZERO, ANG_ZERO);
        for dof in link.dofs.start..first_turn {
            slide += linear(&self.axes[dof]) * rates[dof];
        }
        let turns = first_turn..link.dofs.end;
        for dof in turns.clone() {
            spin += angular(&self.axes[dof]) * rates[dof];
        }
        if turns.len() == 2 {
            let [a, b] =
                [turns.start, turns.start + 1].map(|dof| angular(&self.axes[dof]) * rates[dof]);
            spin_turn = ang_cross(a, b);
        }
        (slide, spin, spin_turn)
    }
}

impl Multibody {
    /// The forces `C(q, q̇) q̇` on the degrees of freedom that keep their velocities constant, without
    /// gravity. With the [mass matrix](Self::mass_matrix) `M` and the forces `τ` on the degrees of freedom,
    /// `M q̈ = τ - C q̇`.
    ///
    /// A root without degrees of freedom counts as being at rest.
    pub fn bias_forces(&self) -> Vec<Real> {
        let kinematics = Kinematics::of(self);
        let rates = self.generalized_velocity();
        let (mut velocities, mut buffer, mut wrenches) = (Vec::new(), Vec::new(), Vec::new());
        kinematics.velocities(rates, &ZERO, &mut velocities);
        kinematics.inertial_wrenches(rates, &velocities, &mut buffer, &mut wrenches);
        let mut forces = vec![0.0; self.ndofs()];
        for (id, wrench) in wrenches.iter().enumerate() {
            kinematics.add_generalized_force(id, &wrench.map(|number| -number), &mut forces);
        }
        forces
    }
}
