//! One body of a multibody.

use super::{MultibodyJoint, MultibodyJointHandle};
use crate::dim::joint_axes::JointAxesMask;
use crate::dim::mass::{mass_is_valid, no_mass};
use crate::dim::math::Pose;
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodyVelocity};
use crate::model::check::checked_pose;
use parry::mass_properties::MassProperties;

/// One body of a multibody, and the joint to its parent.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct MultibodyLink {
    /// The joint to the parent. The joint of a root has no effect.
    pub joint: MultibodyJoint,
    pub(crate) id: usize,
    pub(crate) parent: Option<usize>,
    pub(crate) body: RigidBodyHandle,
    pub(crate) handle: Option<MultibodyJointHandle>,
    /// Links of the same group do not collide with each other; 0: no group. A group is a merged multibody
    /// without self-contacts.
    pub(super) exclusion_group: u32,
    /// First of the link's degrees of freedom among the multibody's.
    pub(crate) first_dof: usize,
    /// The axes that are degrees of freedom. For a root: along and about the axes of the world, at its centre
    /// of mass.
    pub(crate) free: JointAxesMask,
    pub(crate) pose: Pose,
    /// The mass properties of the body at the last update.
    pub(crate) mass: MassProperties,
    /// The body's pose at the last read or write by the multibody; `None` before the first.
    pub(crate) seen_pose: Option<Pose>,
    /// Whether the pose was read before a step for the user alone: the step reads it again, as if it were the
    /// first time.
    pub(crate) is_preview: bool,
    /// The body's velocity at the last write by the multibody; `None` before the first. A body with another
    /// velocity was pushed. Zero after a change of the degrees of freedom: moving bodies count as pushed.
    pub(crate) seen_velocity: Option<RigidBodyVelocity>,
}

impl MultibodyLink {
    /// A link without a pose yet.
    pub(super) fn new(body: RigidBodyHandle, joint: MultibodyJoint, parent: Option<usize>) -> Self {
        Self {
            free: if parent.is_some() { joint.free_axes() } else { JointAxesMask::empty() },
            joint,
            id: 0,
            parent,
            body,
            handle: None,
            exclusion_group: 0,
            first_dof: 0,
            pose: Pose::IDENTITY,
            mass: no_mass(),
            seen_pose: None,
            is_preview: false,
            seen_velocity: None,
        }
    }

    /// The coordinates follow from the pose of the body, or the body got the pose of the coordinates.
    pub(crate) fn match_body(&mut self, body: &RigidBody) {
        self.joint.match_bodies();
        if self.parent.is_none() {
            self.pose = body.pose;
        }
        self.seen_pose = Some(body.pose);
        self.is_preview = false;
    }

    /// Returns whether all numbers are usable.
    pub(super) fn is_sound(&self) -> bool {
        let poses = [Some(self.pose), self.seen_pose];
        let mut velocities = self.seen_velocity.iter();
        self.joint.is_sound()
            && mass_is_valid(&self.mass)
            && poses.into_iter().flatten().all(|pose| checked_pose(pose).is_some())
            && velocities.all(|velocity| velocity.is_finite())
    }

    /// The joint to the parent.
    pub fn joint(&self) -> &MultibodyJoint {
        &self.joint
    }

    /// The handle of the joint; `None` for a root.
    pub fn joint_handle(&self) -> Option<MultibodyJointHandle> {
        self.handle
    }

    /// The link's index among the multibody's links. Parents precede their children.
    pub fn link_id(&self) -> usize {
        self.id
    }

    /// The parent's index among the multibody's links; `None` for a root.
    pub fn parent_id(&self) -> Option<usize> {
        self.parent
    }

    /// Returns whether it is the root.
    pub fn is_root(&self) -> bool {
        self.parent.is_none()
    }

    /// The body.
    pub fn rigid_body_handle(&self) -> RigidBodyHandle {
        self.body
    }

    /// The first of the link's degrees of freedom among the multibody's.
    pub fn assembly_id(&self) -> usize {
        self.first_dof
    }

    /// Number of degrees of freedom that this link adds to the multibody. That of a root depends on its body:
    /// see [`Multibody::ndofs`](super::Multibody::ndofs).
    pub fn ndofs(&self) -> usize {
        self.free.bits().count_ones() as usize
    }

    /// Pose of the body in world space, as of the last step, [forward
    /// kinematics](super::Multibody::forward_kinematics) or insertion by `PhysicsWorld`.
    pub fn local_to_world(&self) -> &Pose {
        &self.pose
    }

    /// Pose of the body in the frame of the parent's body, from the joint's coordinates.
    pub fn local_to_parent(&self) -> Pose {
        self.joint.body_to_parent()
    }
}
