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
//! is inverted. That is an `L D Lᵀ` decomposition of the joint's block, column by column. The degrees of
//! freedom of the root are components of its velocity; its inertia is inverted as a whole. Then forces become
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

use super::kinematics::Kinematics;
use super::spatial::{SpatialMatrix, ZERO, add_scaled, carry, carry_back, dot};
use crate::dim::math::{ANG_DIM, DIM, Real, SPATIAL_DIM, SpatialVector, ang_length_squared};
use crate::dim::spatial::{angular, linear};

/// An inertia below this fraction of its subtree's is rounding: the motion of that degree of freedom is
/// undetermined, and it is locked.
const INERTIA_MIN: Real = 64.0 * Real::EPSILON;

/// A degree of freedom of a link with a parent.
#[derive(Copy, Clone, Debug)]
struct Pivot {
    axis: SpatialVector,
    u: SpatialVector,
    /// `1 / D`; zero for an immovable degree of freedom.
    inv_inertia: Real,
}

/// The articulated inertias at one configuration.
#[derive(Clone, Debug, Default)]
pub struct Factor {
    /// By degree of freedom; those of the root are unused.
    pivots: Vec<Pivot>,
    /// The inverse of the root's articulated inertia along its free axes.
    inv_root: SpatialMatrix,
    inertias: Vec<SpatialMatrix>,
    /// By link: approximate mass and angular inertia from the link to the tips.
    sizes: Vec<[Real; 2]>,
    /// Wrenches of the upward pass of the last [`Self::solve`].
    wrenches: Vec<SpatialVector>,
    accelerations: Vec<SpatialVector>,
    /// A buffer of [`Self::inverse_inertias`].
    responses: Vec<SpatialMatrix>,
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
        let Self { pivots, inertias, sizes, .. } = self;
        debug_assert!(resistance.armature.len() >= kinematics.axes.len());
        inertias.clear();
        sizes.clear();
        pivots.clear();
        for (id, link) in kinematics.links.iter().enumerate() {
            let [along, about] = resistance.drag.get(id).copied().unwrap_or([1.0; 2]);
            let inertia = link.inertia.map(|row| row.map(|m| m * about));
            inertias.push(SpatialMatrix::rigid(link.mass * along, &inertia));
            sizes.push([link.mass, (0..ANG_DIM).map(|k| link.inertia[k][k]).sum()]);
        }
        let pivot = |axis: &SpatialVector| Pivot { axis: *axis, u: ZERO, inv_inertia: 0.0 };
        pivots.extend(kinematics.axes.iter().map(pivot));
        for (id, link) in kinematics.links.iter().enumerate().rev() {
            let Some(parent) = link.parent else { continue };
            let ([mass, moment], mut inertia) = (sizes[id], inertias[id]);
            let (dofs, armature) =
                (&mut pivots[link.dofs.clone()], &resistance.armature[link.dofs.clone()]);
            for (Pivot { axis, u, inv_inertia }, armature) in dofs.iter_mut().zip(armature).rev() {
                *u = inertia.mul(axis);
                let (along, about) =
                    (linear(axis).length_squared(), ang_length_squared(angular(axis)));
                let total = dot(axis, u) + armature;
                let moves =
                    total > INERTIA_MIN * (mass * along + moment * about) && total.is_finite();
                *inv_inertia = if moves { 1.0 / total } else { 0.0 };
                inertia.add_product(u, u, -*inv_inertia);
            }
            inertias[parent].add(&inertia.carried_back(link.offset));
            sizes[parent][0] += mass;
            sizes[parent][1] += moment + mass * link.offset.length_squared();
        }
        debug_assert!(pivots.iter().all(|pivot| pivot.inv_inertia >= 0.0), "inertias are positive");
        self.invert_root(&kinematics.root_axes, resistance.armature);
    }

    fn invert_root(&mut self, axes: &[usize], armature: &[Real]) {
        let (Some(inertia), Some(&[mass, moment])) = (self.inertias.first(), self.sizes.first())
        else {
            return;
        };
        let (mut inertia, mut least) = (*inertia, [Real::MAX; SPATIAL_DIM]);
        let mut more = ZERO;
        for (&axis, armature) in axes.iter().zip(armature) {
            more[axis] = *armature;
            least[axis] = INERTIA_MIN * if axis < DIM { mass } else { moment };
        }
        inertia.add_diagonal(&more);
        self.inv_root = inertia.inverse(&least);
    }

    /// Inverse articulated inertia of each degree of freedom: descendants free, ancestors locked. All of the
    /// root are free.
    pub fn inv_articulated_inertias(&self, root_axes: &[usize]) -> impl Iterator<Item = Real> {
        let of_root = self.inv_root.diagonal();
        let others = self.pivots.iter().skip(root_axes.len()).map(|pivot| pivot.inv_inertia);
        root_axes.iter().map(move |&axis| of_root[axis]).chain(others)
    }

    /// By degree of freedom: its acceleration by a force of 1 on it, while all others are free: the diagonal
    /// of `M⁻¹`.
    ///
    /// The response `Ω` of a link to wrenches on it follows from its parent's, from the root to the tips. A
    /// degree of freedom takes `u/D` of a wrench on the link away from the parent, and adds its own motion:
    ///
    /// ```text
    /// M⁻¹_jj = (1 + uᵀ Ω u / D) / D        Ω ← (1 - s uᵀ/D) Ω (1 - u sᵀ/D) + s sᵀ / D
    /// ```
    pub fn inverse_inertias(&mut self, kinematics: &Kinematics, inverses: &mut Vec<Real>) {
        inverses.clear();
        inverses.extend(self.inv_articulated_inertias(&kinematics.root_axes));
        let Self { pivots, responses, .. } = self;
        responses.clear();
        responses.push(self.inv_root);
        for link in &kinematics.links {
            let Some(parent) = link.parent else { continue };
            let mut response = responses[parent].carried(link.offset);
            for dof in link.dofs.clone() {
                let Pivot { axis, u, inv_inertia } = &pivots[dof];
                let moved = response.mul(u);
                let inverse = inv_inertia + inv_inertia * inv_inertia * dot(u, &moved);
                response.add_product(axis, &moved, -inv_inertia);
                response.add_product(&moved, axis, -inv_inertia);
                response.add_product(axis, axis, inverse);
                inverses[dof] = inverse;
            }
            responses.push(response);
        }
    }

    /// Computes accelerations from forces on the degrees of freedom and wrenches on the links (or velocities
    /// from impulses): `forces` become `M⁻¹ (forces + Σ Jᵀ wrench)`. The list of wrenches may be empty.
    pub fn solve(
        &mut self,
        kinematics: &Kinematics,
        wrenches: &[SpatialVector],
        forces: &mut [Real],
    ) {
        debug_assert!(wrenches.len() <= kinematics.links.len());
        debug_assert_eq!(forces.len(), kinematics.axes.len(), "one force per degree of freedom");
        self.wrenches.clear();
        self.wrenches.extend_from_slice(wrenches);
        self.wrenches.resize(kinematics.links.len(), ZERO);
        self.gather(kinematics, forces);
        self.respond(kinematics, forces);
    }

    /// From the tips to the root: `forces` become `u`.
    fn gather(&mut self, kinematics: &Kinematics, forces: &mut [Real]) {
        for (id, link) in kinematics.links.iter().enumerate().rev() {
            let Some(parent) = link.parent else { continue };
            let mut wrench = self.wrenches[id];
            let dofs = self.pivots[link.dofs.clone()].iter().zip(&mut forces[link.dofs.clone()]);
            for (Pivot { axis, u, inv_inertia }, force) in dofs.rev() {
                *force += dot(axis, &wrench);
                add_scaled(&mut wrench, u, -(inv_inertia * *force));
            }
            add_scaled(&mut self.wrenches[parent], &carry_back(&wrench, link.offset), 1.0);
        }
    }

    /// From the root to the tips: `u` becomes the acceleration.
    fn respond(&mut self, kinematics: &Kinematics, forces: &mut [Real]) {
        self.accelerations.clear();
        let Some(mut of_root) = self.wrenches.first().copied() else { return };
        for (&axis, force) in kinematics.root_axes.iter().zip(&*forces) {
            of_root[axis] += force;
        }
        let of_root = self.inv_root.mul(&of_root);
        for (&axis, force) in kinematics.root_axes.iter().zip(&mut *forces) {
            *force = of_root[axis];
        }
        self.accelerations.push(of_root);
        for link in &kinematics.links {
            let Some(parent) = link.parent else { continue };
            let mut acceleration = carry(&self.accelerations[parent], link.offset);
            let dofs = self.pivots[link.dofs.clone()].iter().zip(&mut forces[link.dofs.clone()]);
            for (Pivot { axis, u, inv_inertia }, force) in dofs {
                *force = inv_inertia * (*force - dot(u, &acceleration));
                add_scaled(&mut acceleration, axis, *force);
            }
            self.accelerations.push(acceleration);
        }
    }
}
