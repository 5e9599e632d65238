//! Gears: two degrees of freedom that move together.

use super::Multibody;
use super::record::Dof;
use crate::dim::joint_axes::JointAxis;
use crate::dim::math::{DIM, Real};
use crate::model::joint::InvalidJoint;

/// Two coupled degrees of freedom of a multibody: `q2 = coeff · q1 + offset`, with the coordinates `q1` and
/// `q2` of the axes (length units, radians). [`Multibody::add_dof_coupling`] creates it.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct MultibodyDofCoupling {
    /// The first link. The coupling acts in both directions.
    pub link1: usize,
    /// The axis of its joint.
    pub axis1: JointAxis,
    /// The second link.
    pub link2: usize,
    /// The axis of its joint.
    pub axis2: JointAxis,
    /// Displacement of the second coordinate per unit of the first. Examples are the ratio of a gear
    /// (negative for external gears) and the radius of a pinion on a rack.
    pub coeff: Real,
    /// The second coordinate where the first one is 0.
    pub offset: Real,
    /// The impulse of the last substep. The next step starts with this impulse.
    pub(crate) impulse: Real,
}

impl MultibodyDofCoupling {
    /// Returns whether the coupling names two of `link_count` links, and its numbers are finite.
    pub(super) fn is_sound(&self, link_count: usize) -> bool {
        let numbers = [self.coeff, self.offset, self.impulse];
        self.link1.max(self.link2) < link_count && numbers.iter().all(|number| number.is_finite())
    }
}

impl Multibody {
    /// Couples two degrees of freedom, `q2 = coeff · q1 + offset`, and returns the position of the coupling
    /// in [`Self::couplings`]. An initial error is corrected over some steps.
    ///
    /// The rotations of a ball joint cannot be coupled, because they have no separate coordinates. A coupling
    /// is inactive while one of its axes is locked. It is removed when one of its links leaves the multibody.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// # let mut world = PhysicsWorld::new();
    /// # let frame = world.insert_body(RigidBodyBuilder::fixed());
    /// # let mut wheel = |x: Real| {
    /// #     let body = RigidBodyBuilder::dynamic().translation(vector![x, 0.0, 0.0]);
    /// #     let (body, _) = world.insert(body, ColliderBuilder::cylinder(0.1, 0.4));
    /// #     let axle = RevoluteJointBuilder::new(Vector::Y).local_anchor1(vector![x, 0.0, 0.0]);
    /// #     world.insert_multibody_joint(frame, body, axle).unwrap()
    /// # };
    /// # let (small, large) = (wheel(0.0), wheel(1.0));
    /// // The large wheel has three times as many teeth, and turns the other way.
    /// let link2 = world.multibody_joints.get(large).unwrap().1;
    /// let (multibody, link1) = world.multibody_joints.get_mut(small).unwrap();
    /// multibody.add_dof_coupling(link1, JointAxis::AngX, link2, JointAxis::AngX, -1.0 / 3.0, 0.0)?;
    /// # Ok::<(), InvalidJoint>(())
    /// ```
    ///
    /// # Errors
    /// If a link has no such degree of freedom, both are the same, or a number is not finite.
    pub fn add_dof_coupling(
        &mut self,
        link1: usize,
        axis1: JointAxis,
        link2: usize,
        axis2: JointAxis,
        coeff: Real,
        offset: Real,
    ) -> Result<usize, InvalidJoint> {
        let finite = |parameter, value: Real| match value.is_finite() {
            true => Ok(()),
            false => Err(InvalidJoint::Number { parameter, value, expected: "finite" }),
        };
        finite("the coefficient of a coupling", coeff)?;
        finite("the offset of a coupling", offset)?;
        for (link, axis) in [(link1, axis1), (link2, axis2)] {
            self.coupled_dof(link, axis).ok_or(InvalidJoint::Dof { link, axis })?;
        }
        if (link1, axis1) == (link2, axis2) {
            return Err(InvalidJoint::SameDof { link: link1, axis: axis1 });
        }
        let impulse = 0.0;
        let coupling = MultibodyDofCoupling { link1, axis1, link2, axis2, coeff, offset, impulse };
        self.couplings.push(coupling);
        Ok(self.couplings.len() - 1)
    }

    /// The couplings, in the order in which they were added.
    pub fn couplings(&self) -> &[MultibodyDofCoupling] {
        &self.couplings
    }

    /// Removes and returns the coupling at a position; later ones move up. `None` if there is no such
    /// coupling.
    pub fn remove_dof_coupling(&mut self, position: usize) -> Option<MultibodyDofCoupling> {
        (position < self.couplings.len()).then(|| self.couplings.remove(position))
    }

    /// Keeps the couplings for which `keep` returns `true`.
    pub fn retain_dof_couplings(&mut self, keep: impl FnMut(&MultibodyDofCoupling) -> bool) {
        self.couplings.retain(keep);
    }

    /// Removes all couplings.
    pub fn clear_dof_couplings(&mut self) {
        self.couplings.clear();
    }

    /// The degrees of freedom of a coupling; `None` while it is inactive.
    pub(crate) fn coupled_dofs(&self, coupling: &MultibodyDofCoupling) -> Option<[usize; 2]> {
        let usable = coupling.coeff.is_finite() && coupling.offset.is_finite();
        let first = self.coupled_dof(coupling.link1, coupling.axis1)?;
        let second = self.coupled_dof(coupling.link2, coupling.axis2)?;
        (usable && first != second).then_some([first, second])
    }

    /// The error of a coupling: `q2 - coeff · q1 - offset`.
    pub(crate) fn coupling_error(&self, coupling: &MultibodyDofCoupling) -> Real {
        let q = |link: usize, axis| self.links[link].joint.coordinate(axis);
        let (q1, q2) = (q(coupling.link1, coupling.axis1), q(coupling.link2, coupling.axis2));
        q2 - coupling.coeff * q1 - coupling.offset
    }

    /// The degree of freedom of an axis, if it has a coordinate of its own.
    fn coupled_dof(&self, link: usize, axis: JointAxis) -> Option<usize> {
        let joint = &self.links.get(link).filter(|link| link.parent.is_some())?.joint;
        if (axis as usize) >= DIM && joint.is_ball() {
            return None;
        }
        self.dofs.iter().position(|dof| *dof == Dof { link, axis })
    }
}
