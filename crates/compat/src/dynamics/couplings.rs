//! Couplings of degrees of freedom in Rapier 0.36: axes have numbers.

use super::Multibody;
use crate::math::{Real, SPATIAL_DIM};
use engine::dynamics::JointAxis;

/// Two degrees of freedom that move together: `q2 = coeff q1 + offset`.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct MultibodyDofCoupling {
    /// The first link.
    pub link1: usize,
    /// Its degree of freedom.
    pub dof1: usize,
    /// The axis of that degree of freedom.
    pub axis1: usize,
    /// The second link.
    pub link2: usize,
    /// Its degree of freedom.
    pub dof2: usize,
    /// The axis of that degree of freedom.
    pub axis2: usize,
    /// Displacement of the second coordinate per unit of the first.
    pub coeff: Real,
    /// The second coordinate where the first one is 0.
    pub offset: Real,
}

/// The axis with a number.
fn axis_of(number: usize) -> Option<JointAxis> {
    JointAxis::ALL.into_iter().find(|axis| *axis as usize == number)
}

impl Multibody {
    /// A coupling of the engine with the numbers of its degrees of freedom: the count of earlier free axes.
    fn to_coupling(&self, own: &engine::dynamics::MultibodyDofCoupling) -> MultibodyDofCoupling {
        let dof = |link: usize, axis: JointAxis| {
            let locked = self.0.link(link).map_or(0, |it| it.joint().data.locked_axes.bits());
            (0..SPATIAL_DIM.min(axis as usize)).filter(|number| locked & (1 << number) == 0).count()
        };
        MultibodyDofCoupling {
            link1: own.link1,
            dof1: dof(own.link1, own.axis1),
            axis1: own.axis1 as usize,
            link2: own.link2,
            dof2: dof(own.link2, own.axis2),
            axis2: own.axis2 as usize,
            coeff: own.coeff,
            offset: own.offset,
        }
    }

    /// Couples two degrees of freedom. An impossible coupling is logged and ignored.
    pub fn add_dof_coupling(&mut self, coupling: MultibodyDofCoupling) {
        let MultibodyDofCoupling { link1, axis1, link2, axis2, coeff, offset, .. } = coupling;
        let (Some(first), Some(second)) = (axis_of(axis1), axis_of(axis2)) else {
            return log::warn!("the axes of {coupling:?} do not exist: it is ignored");
        };
        let added = self.0.add_dof_coupling(link1, first, link2, second, coeff, offset);
        if let Err(error) = added {
            log::warn!("{coupling:?} is ignored: {error}");
        }
    }

    /// The couplings, in the order in which they were added.
    pub fn couplings(&self) -> Vec<MultibodyDofCoupling> {
        self.0.couplings().iter().map(|own| self.to_coupling(own)).collect()
    }

    /// Removes and returns the coupling at a position.
    pub fn remove_dof_coupling(&mut self, i: usize) -> Option<MultibodyDofCoupling> {
        let removed = self.0.remove_dof_coupling(i)?;
        Some(self.to_coupling(&removed))
    }

    /// Keeps the couplings for which the function returns `true`.
    pub fn retain_dof_couplings(&mut self, f: impl FnMut(&MultibodyDofCoupling) -> bool) {
        let mut kept = self.couplings().iter().map(f).collect::<Vec<_>>().into_iter();
        self.0.retain_dof_couplings(|_| kept.next().unwrap_or(true));
    }
}
