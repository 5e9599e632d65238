//! `M⁻¹ τ` in time proportional to the number of links: articulated bodies.
//!
//! The articulated inertia `I^A` of a link is its apparent inertia against a force at its centre of mass,
//! with all its descendants. It follows from the tips to the root. Let `s` be the axis of the last degree of
//! freedom of a link's joint. For it (Featherstone 2008, section 7.3)
//!
//! ```text
//! U = I^A s        D = sᵀ U + a        I^A ← I^A - U Uᵀ / D        (once that axis gives way)
//! I^A_parent = I_parent + Σ Xᵀ I^A X
//! ```
//!
//! with the armature `a`. A joint with several degrees of freedom is a chain of massless ones, so no matrix
//! is inverted. That is an `L D Lᵀ` decomposition of the joint's block, column by column. Then forces become
//! accelerations:
//!
//! ```text
//! up     u = τ + sᵀ f        f ← f - U u / D        f_parent += Xᵀ f
//! down   a = X a_parent      q̈ = (u - Uᵀ a) / D     a ← a + s q̈
//! ```
//!
//! Velocities follow from impulses the same way. The damping `d` of a degree of freedom is integrated
//! implicitly over `h`. A spring of stiffness `k` is evaluated after the fraction `θ` of that (`motion/`).
//! They add `h d + θ h² k` to its armature: they are stable for any stiffness, without cost.

use super::kinematics::{Kinematics, LinkFrame};
use super::spatial::{SpatialMatrix, ZERO, add_scaled, carry, carry_back, dot};
use crate::dim::math::{ANG_DIM, Real, SpatialVector, ang_length_squared};
use crate::dim::spatial::{angular, linear};

/// An inertia below this fraction of its subtree's is rounding: the motion of that degree of freedom is
/// undetermined, and it is locked.
const INERTIA_MIN: Real = 64.0 * Real::EPSILON;

/// `U` and `1/D` of one degree of freedom.
#[derive(Copy, Clone, Debug)]
struct Pivot {
    u: SpatialVector,
    /// `1 / D`; zero for an immovable degree of freedom.
    inv_inertia: Real,
}

/// The articulated inertias at one configuration.
#[derive(Clone, Debug, Default)]
pub struct Factor {
    pivots: Vec<Pivot>,
    inertias: Vec<SpatialMatrix>,
    /// By link: approximate mass and angular inertia from the link to the tips.
    sizes: Vec<[Real; 2]>,
    /// Wrenches of the upward pass of the last [`Self::solve`].
    wrenches: Vec<SpatialVector>,
    accelerations: Vec<SpatialVector>,
}

/// Data of the degrees of freedom when their inertias are summed up.
#[derive(Copy, Clone, Debug)]
pub struct Resistance<'a> {
    /// Inertia in addition to that of the links; infinite for prescribed ones.
    pub armature: &'a [Real],
    /// By link: factors on its mass and its angular inertia, for the damping of its body.
    pub drag: &'a [[Real; 2]],
}

impl Factor {
    /// Adds up the articulated inertias.
    pub fn update(&mut self, kinematics: &Kinematics, resistance: Resistance<'_>) {
        let links = &kinematics.links;
        self.inertias.clear();
        self.inertias.extend(links.iter().enumerate().map(|(id, link)| {
            let [along, about] = resistance.drag.get(id).copied().unwrap_or([1.0; 2]);
            SpatialMatrix::rigid(link.mass * along, &link.inertia.map(|row| row.map(|m| m * about)))
        }));
        self.measure(kinematics);
        let none = Pivot { u: ZERO, inv_inertia: 0.0 };
        self.pivots.clear();
        self.pivots.resize(kinematics.ndofs(), none);
        for (id, link) in links.iter().enumerate().rev() {
            let mut inertia = self.inertias[id];
            for dof in link.dofs.clone().rev() {
                let axis = &kinematics.axes[dof];
                let u = inertia.mul(axis);
                let [mass, moment] = self.sizes[id];
                let (along, about) =
                    (linear(axis).length_squared(), ang_length_squared(angular(axis)));
                let total = dot(axis, &u) + resistance.armature[dof];
                let moves =
                    total > INERTIA_MIN * (mass * along + moment * about) && total.is_finite();
                let inv_inertia = if moves { 1.0 / total } else { 0.0 };
                inertia.reduce(&u, inv_inertia);
                self.pivots[dof] = Pivot { u, inv_inertia };
            }
            if let Some(parent) = link.parent {
                let felt = inertia.carried_back(link.offset);
                self.inertias[parent].add(&felt);
            }
        }
    }

    fn measure(&mut self, kinematics: &Kinematics) {
        let trace = |link: &LinkFrame| (0..ANG_DIM).map(|k| link.inertia[k][k]).sum();
        self.sizes.clear();
        self.sizes.extend(kinematics.links.iter().map(|link| [link.mass, trace(link)]));
        for (id, link) in kinematics.links.iter().enumerate().rev() {
            let Some(parent) = link.parent else { continue };
            let [mass, moment] = self.sizes[id];
            self.sizes[parent][0] += mass;
            self.sizes[parent][1] += moment + mass * link.offset.length_squared();
        }
    }

    /// Inverse articulated inertia of each degree of freedom: descendants free, ancestors locked.
    pub fn inv_articulated_inertias(&self) -> impl Iterator<Item = Real> {
        self.pivots.iter().map(|pivot| pivot.inv_inertia)
    }

    /// Computes accelerations from forces on the degrees of freedom and wrenches on the links (or velocities
    /// from impulses): `forces` become `M⁻¹ (forces + Σ Jᵀ wrench)`. The list of wrenches may be empty.
    pub fn solve(
        &mut self,
        kinematics: &Kinematics,
        wrenches: &[SpatialVector],
        forces: &mut [Real],
    ) {
        self.gather(kinematics, wrenches, forces);
        self.respond(kinematics, forces);
    }

    /// From the tips to the root: `forces` become `u`.
    fn gather(&mut self, kinematics: &Kinematics, wrenches: &[SpatialVector], forces: &mut [Real]) {
        self.wrenches.clear();
        self.wrenches.extend_from_slice(wrenches);
        self.wrenches.resize(kinematics.links.len(), ZERO);
        for (id, link) in kinematics.links.iter().enumerate().rev() {
            let mut wrench = self.wrenches[id];
            for dof in link.dofs.clone().rev() {
                let pivot = &self.pivots[dof];
                forces[dof] += dot(&kinematics.axes[dof], &wrench);
                add_scaled(&mut wrench, &pivot.u, -(pivot.inv_inertia * forces[dof]));
            }
            if let Some(parent) = link.parent {
                let felt = carry_back(&wrench, link.offset);
                add_scaled(&mut self.wrenches[parent], &felt, 1.0);
            }
        }
    }

    /// From the root to the tips: `u` becomes the acceleration.
    fn respond(&mut self, kinematics: &Kinematics, forces: &mut [Real]) {
        self.accelerations.clear();
        for link in &kinematics.links {
            let mut acceleration = match link.parent {
                Some(parent) => carry(&self.accelerations[parent], link.offset),
                None => ZERO,
            };
            for dof in link.dofs.clone() {
                let pivot = &self.pivots[dof];
                let rate = pivot.inv_inertia * (forces[dof] - dot(&pivot.u, &acceleration));
                forces[dof] = rate;
                add_scaled(&mut acceleration, &kinematics.axes[dof], rate);
            }
            self.accelerations.push(acceleration);
        }
    }
}
