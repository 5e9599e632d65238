//! The mass matrix: composite rigid bodies.
//!
//! If only the degree of freedom `j` accelerates, its subtree moves like one rigid body, whose inertia `I^C`
//! is the sum of the links'. The required wrench `I^C sⱼ` acts, through the moment arms, on each degree of
//! freedom up to the root (Featherstone 2008, section 6.2):
//!
//! ```text
//! I^C_parent += Xᵀ I^C X        M_ij = sᵢᵀ Xᵀ … Xᵀ I^C sⱼ
//! ```

use super::factor::{Factor, Resistance};
use super::kinematics::Kinematics;
use super::spatial::{SpatialMatrix, carry_back, dot};
use crate::base::square::SquareMatrix;
use crate::dim::math::Real;
use crate::model::multibody::Multibody;

impl Multibody {
    /// The mass matrix `M`, one row and column per degree of freedom: `½ q̇ᵀ M q̇` is the kinetic energy, and
    /// `M q̈` the accelerating forces. Symmetric; [armature](Self::armature) stands on the diagonal.
    pub fn mass_matrix(&self) -> SquareMatrix {
        let kinematics = Kinematics::of(self);
        let mut matrix = SquareMatrix::zeros(self.ndofs());
        let links = &kinematics.links;
        let rigid = links.iter().map(|link| SpatialMatrix::rigid(link.mass, &link.inertia));
        let mut composites: Vec<_> = rigid.collect();
        for (id, link) in links.iter().enumerate().rev() {
            for dof in link.dofs.clone() {
                fill_column(&mut matrix, &kinematics, id, dof, &composites[id]);
            }
            if let Some(parent) = link.parent {
                let felt = composites[id].carried_back(link.offset);
                composites[parent].add(&felt);
            }
        }
        for (dof, &armature) in self.armature().iter().enumerate() {
            matrix[(dof, dof)] += usable(armature);
        }
        matrix
    }

    /// The diagonal of `M⁻¹`: the acceleration of each degree of freedom by a force of 1 on it, while the
    /// others are free. A spring of the stiffness `k` there has the angular frequency `√(k M⁻¹ᵢᵢ)`.
    pub fn dof_inverse_inertia(&self) -> Vec<Real> {
        let (mut inverses, (kinematics, mut factor)) = (Vec::new(), self.factorized());
        if self.is_whole() {
            factor.inverse_inertias(&kinematics, &mut inverses);
        }
        inverses.resize(self.ndofs(), 0.0);
        inverses
    }

    /// `M⁻¹ τ`: the accelerations of the degrees of freedom by these forces on them (or velocities by
    /// impulses), in time proportional to their number. Missing forces are 0.
    pub fn accelerations_of(&self, forces: &[Real]) -> Vec<Real> {
        if !self.is_whole() {
            return vec![0.0; self.ndofs()];
        }
        let (kinematics, mut factor) = self.factorized();
        let mut forces = forces.to_vec();
        forces.resize(self.ndofs(), 0.0);
        factor.solve(&kinematics, &[], &mut forces);
        forces
    }

    fn factorized(&self) -> (Kinematics, Factor) {
        let (kinematics, mut factor) = (Kinematics::of(self), Factor::default());
        let armature: Vec<_> = self.armature().iter().copied().map(usable).collect();
        factor.update(&kinematics, Resistance { armature: &armature, drag: &[] });
        (kinematics, factor)
    }
}

/// A user-defined number of a degree of freedom, or zero if it is invalid.
pub fn usable(value: Real) -> Real {
    if value.is_finite() && value > 0.0 { value } else { 0.0 }
}

/// All entries of one degree of freedom and of earlier degrees of freedom.
fn fill_column(
    matrix: &mut SquareMatrix,
    kinematics: &Kinematics,
    id: usize,
    dof: usize,
    composite: &SpatialMatrix,
) {
    let mut wrench = composite.mul(&kinematics.axes[dof]);
    let mut next = Some(id);
    while let Some(link) = next.map(|id| &kinematics.links[id]) {
        for other in link.dofs.clone().filter(|&other| other <= dof) {
            let entry = dot(&kinematics.axes[other], &wrench);
            matrix[(other, dof)] = entry;
            matrix[(dof, other)] = entry;
        }
        wrench = carry_back(&wrench, link.offset);
        next = link.parent;
    }
}
