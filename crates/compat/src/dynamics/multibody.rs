//! Multibodies, with the vectors and matrices of nalgebra in their signatures.

use crate::math::{DVector, Jacobian, Pose, Real, SPATIAL_DIM};
use crate::wrapper::wrapper;
use engine::dynamics::{
    InverseKinematicsOption, MultibodyIndex, MultibodyJointHandle, MultibodyLink, MultibodyLinkId,
    RigidBodyHandle, RigidBodySet,
};
use na::{DVectorView, DVectorViewMut, SVector};
use std::sync::OnceLock;

/// Jacobians of the links that were read.
type Jacobians = Vec<OnceLock<Jacobian<Real>>>;

/// Bodies that are joined by reduced coordinates.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(transparent))]
#[repr(transparent)]
pub struct Multibody(pub(super) engine::dynamics::Multibody);

impl core::ops::Deref for Multibody {
    type Target = engine::dynamics::Multibody;

    fn deref(&self) -> &engine::dynamics::Multibody {
        &self.0
    }
}

/// A change removes the Jacobians that were computed before.
impl core::ops::DerefMut for Multibody {
    fn deref_mut(&mut self) -> &mut engine::dynamics::Multibody {
        self.0.remove_attachment();
        &mut self.0
    }
}

/// A borrowed list of numbers as a vector.
fn view(numbers: &[Real]) -> DVectorView<'_, Real> {
    DVectorView::from_slice(numbers, numbers.len())
}

/// A mutable list of numbers as a vector.
fn view_mut(numbers: &mut [Real]) -> DVectorViewMut<'_, Real> {
    let count = numbers.len();
    DVectorViewMut::from_slice(numbers, count)
}

impl Multibody {
    /// A multibody without links.
    pub fn new() -> Self {
        Self::default()
    }

    /// A borrowed multibody of the engine as this type.
    pub(crate) fn wrap(own: &engine::dynamics::Multibody) -> &Self {
        // SAFETY: the wrapper is transparent, so both types have the same layout and validity.
        unsafe { &*core::ptr::from_ref(own).cast() }
    }

    /// A mutable multibody of the engine as this type.
    pub(crate) fn wrap_mut(own: &mut engine::dynamics::Multibody) -> &mut Self {
        own.remove_attachment();
        // SAFETY: the wrapper is transparent, so both types have the same layout and validity.
        unsafe { &mut *core::ptr::from_mut(own).cast() }
    }

    /// The root.
    ///
    /// # Panics
    /// If the multibody has no links.
    pub fn root(&self) -> &MultibodyLink {
        self.0.root().expect("a multibody with links")
    }

    /// Mutable access to the root.
    ///
    /// # Panics
    /// If the multibody has no links.
    pub fn root_mut(&mut self) -> &mut MultibodyLink {
        self.0.root_mut().expect("a multibody with links")
    }

    /// Velocities of the degrees of freedom.
    pub fn generalized_velocity(&self) -> DVectorView<'_, Real> {
        view(self.0.generalized_velocity())
    }

    /// Mutable access to the velocities of the degrees of freedom.
    pub fn generalized_velocity_mut(&mut self) -> DVectorViewMut<'_, Real> {
        view_mut(self.0.generalized_velocity_mut())
    }

    /// Accelerations of the degrees of freedom.
    pub fn generalized_acceleration(&self) -> DVectorView<'_, Real> {
        view(self.0.generalized_acceleration())
    }

    /// Velocities of the degrees of freedom of a link.
    pub fn joint_velocity(&self, link: &MultibodyLink) -> DVectorView<'_, Real> {
        view(self.0.joint_velocity(link.link_id()))
    }

    /// Damping of the degrees of freedom.
    pub fn damping(&self) -> DVectorView<'_, Real> {
        view(self.0.damping())
    }

    /// Mutable access to the damping of the degrees of freedom.
    pub fn damping_mut(&mut self) -> &mut [Real] {
        self.0.damping_mut()
    }

    /// Inertia that is added to the degrees of freedom.
    pub fn armature(&self) -> DVectorView<'_, Real> {
        view(self.0.armature())
    }

    /// Mutable access to the inertia that is added to the degrees of freedom.
    pub fn armature_mut(&mut self) -> &mut [Real] {
        self.0.armature_mut()
    }

    /// Friction of the degrees of freedom.
    pub fn frictions(&self) -> DVectorView<'_, Real> {
        view(self.0.frictions())
    }

    /// Mutable access to the friction of the degrees of freedom.
    pub fn frictions_mut(&mut self) -> &mut [Real] {
        self.0.frictions_mut()
    }

    /// The diagonal of the inverse mass matrix, as the links are now.
    pub fn dof_inverse_inertia(&mut self, bodies: &RigidBodySet) -> DVector {
        self.0.forward_kinematics(bodies, false);
        DVector::from_vec(self.0.dof_inverse_inertia())
    }

    /// The Jacobian of a link: a column for each degree of freedom. The first read after a step or a change
    /// computes it.
    ///
    /// # Panics
    /// If there is no such link.
    pub fn body_jacobian(&self, link_id: usize) -> &Jacobian<Real> {
        let links: &Jacobians = self
            .0
            .attachment()
            .get_or_init(|| {
                let empty: Jacobians = (0..self.0.num_links()).map(|_| OnceLock::new()).collect();
                Box::new(empty)
            })
            .downcast_ref()
            .expect("the Jacobians of the links");
        links[link_id].get_or_init(|| {
            let columns = self.0.body_jacobian(link_id);
            Jacobian::from_fn(columns.len(), |row, column| columns[column][row])
        })
    }

    /// Searches displacements that move a link to a pose, from the values in `displacements`.
    pub fn inverse_kinematics(
        &self,
        bodies: &RigidBodySet,
        link_id: usize,
        options: &InverseKinematicsOption,
        target_pose: &Pose,
        joint_can_move: impl Fn(&MultibodyLink) -> bool,
        displacements: &mut DVector,
    ) {
        let mut found = displacements.as_slice().to_vec();
        self.0.inverse_kinematics(
            bodies,
            link_id,
            options,
            target_pose,
            joint_can_move,
            &mut found,
        );
        *displacements = DVector::from_vec(found);
    }

    /// Adds a damped least-squares step that moves a link by `desired_movement`.
    pub fn inverse_kinematics_delta(
        &self,
        link_id: usize,
        desired_movement: &SVector<Real, SPATIAL_DIM>,
        damping: Real,
        displacements: &mut DVector,
    ) {
        let movement = core::array::from_fn(|row| desired_movement[row]);
        let numbers = displacements.as_mut_slice();
        self.0.inverse_kinematics_delta(link_id, &movement, damping, numbers);
    }

    /// Adds a damped least-squares step for any Jacobian.
    pub fn inverse_kinematics_delta_with_jacobian(
        jacobian: &Jacobian<Real>,
        desired_movement: &SVector<Real, SPATIAL_DIM>,
        damping: Real,
        displacements: &mut DVector,
    ) {
        let to_numbers =
            |column: na::MatrixView<'_, Real, _, _, _, _>| core::array::from_fn(|row| column[row]);
        let columns: Vec<[Real; SPATIAL_DIM]> = jacobian.column_iter().map(to_numbers).collect();
        let movement = core::array::from_fn(|row| desired_movement[row]);
        engine::dynamics::Multibody::inverse_kinematics_delta_with_jacobian(
            &columns,
            &movement,
            damping,
            displacements.as_mut_slice(),
        );
    }
}

wrapper! {
    /// All multibodies of a world.
    MultibodyJointSet, engine::dynamics::MultibodyJointSet
}

impl MultibodyJointSet {
    /// Mutable access for a step.
    pub(crate) fn begin_step(&mut self) -> &mut engine::dynamics::MultibodyJointSet {
        self.0.remove_attachments();
        &mut self.0
    }

    /// The multibody of a joint, and the number of its link. `None` if the handle is stale.
    pub fn get(&self, handle: MultibodyJointHandle) -> Option<(&Multibody, usize)> {
        self.0.get(handle).map(|(own, link)| (Multibody::wrap(own), link))
    }

    /// Mutable access to the multibody of a joint, and the number of its link.
    pub fn get_mut(&mut self, handle: MultibodyJointHandle) -> Option<(&mut Multibody, usize)> {
        self.0.get_mut(handle).map(|(own, link)| (Multibody::wrap_mut(own), link))
    }

    /// The multibody of the joint in a slot, the number of its link, and the joint's handle.
    pub fn get_unknown_gen(&self, slot: u32) -> Option<(&Multibody, usize, MultibodyJointHandle)> {
        let (own, link, handle) = self.0.get_unknown_gen(slot)?;
        Some((Multibody::wrap(own), link, handle))
    }

    /// A multibody.
    pub fn get_multibody(&self, index: MultibodyIndex) -> Option<&Multibody> {
        self.0.get_multibody(index).map(Multibody::wrap)
    }

    /// Mutable access to a multibody.
    pub fn get_multibody_mut(&mut self, index: MultibodyIndex) -> Option<&mut Multibody> {
        self.0.get_multibody_mut(index).map(Multibody::wrap_mut)
    }

    /// All multibodies.
    pub fn multibodies(&self) -> impl Iterator<Item = &Multibody> {
        self.0.multibodies().map(Multibody::wrap)
    }

    /// All joints with their multibodies and links.
    pub fn iter(
        &self,
    ) -> impl Iterator<Item = (MultibodyJointHandle, &MultibodyLinkId, &Multibody, &MultibodyLink)>
    {
        self.0.iter().map(|(handle, id, own, link)| (handle, id, Multibody::wrap(own), link))
    }

    /// The joint between two bodies, with its multibody and link.
    pub fn joint_between(
        &self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
    ) -> Option<(MultibodyJointHandle, &Multibody, &MultibodyLink)> {
        let (handle, own, link) = self.0.joint_between(body1, body2)?;
        Some((handle, Multibody::wrap(own), link))
    }

    /// Removes a joint.
    pub fn remove(&mut self, handle: MultibodyJointHandle, wake_up: bool) {
        self.0.remove(handle, wake_up);
    }

    /// Removes all joints of the multibody that a body belongs to.
    pub fn remove_multibody_articulations(&mut self, handle: RigidBodyHandle, wake_up: bool) {
        let joint = self.0.attached_joints(handle).map(|(.., joint)| joint).next();
        if let Some(joint) = joint {
            self.0.remove_multibody_articulations(joint, wake_up);
        }
    }
}
