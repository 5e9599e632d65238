//! A joint in the world, and its handle.

use super::{GenericJoint, TransmissionCount};
use crate::base::arena::Index;
use crate::dim::math::{
    ANG_DIM, ANG_ZERO, AngVector, Real, SPATIAL_DIM, SpatialVector, Vector, ang_is_finite,
};
use crate::model::body::RigidBodyHandle;

/// Handle of a joint in its set. It is stale after the joint is removed, and a stale handle refers to no
/// joint.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct ImpulseJointHandle(pub Index);

impl ImpulseJointHandle {
    /// A handle that refers to no joint in any set.
    pub const fn invalid() -> Self {
        Self(Index::INVALID)
    }

    /// Restores a handle from the result of [`Self::into_raw_parts`].
    pub const fn from_raw_parts(id: u32, generation: u32) -> Self {
        Self(Index::from_raw_parts(id, generation))
    }

    /// The slot in the set, and the generation of the slot. Each reuse of a slot gets a new generation.
    pub const fn into_raw_parts(self) -> (u32, u32) {
        self.0.into_raw_parts()
    }
}

/// The two bodies of a joint.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct BodyPair {
    /// The first body.
    pub body1: RigidBodyHandle,
    /// The second body.
    pub body2: RigidBodyHandle,
}

/// A joint between two bodies that the solver enforces by impulses.
///
/// `joint.body1` and `joint.body2` are read-only. To change them, call
/// [`ImpulseJointSet::set_bodies`](super::ImpulseJointSet), which also updates the lists of both bodies.
//
// The order of the fields is fixed (`repr(C)`): see [`ImpulseJoint::FRONT`].
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct ImpulseJoint {
    pub(super) bodies: BodyPair,
    /// Impulses on the second body along the locked axes in the last substep (mass·length/s, mass·length²/s).
    /// The next step starts with them.
    pub impulses: SpatialVector,
    /// Mean force of the last step, in world space.
    pub(crate) force: Vector,
    pub(crate) torque: AngVector,
    /// The angles at the end of the last step, of which turns are counted on. `None`: not known yet.
    pub(crate) angles: Option<[crate::dim::math::Real; ANG_DIM]>,
    /// Whether a program may have separated its anchors, and the error is not corrected yet.
    pub(crate) is_displaced: bool,
    /// Locked axes, limits and motors of the joint.
    pub data: GenericJoint,
    /// What a transmission has counted; `None`: nothing yet.
    pub(crate) count: Option<TransmissionCount>,
}

impl core::ops::Deref for ImpulseJoint {
    type Target = BodyPair;

    fn deref(&self) -> &BodyPair {
        &self.bodies
    }
}

/// The bodies are writable, as in Rapier 0.32. The next step files the joint under the new bodies.
#[cfg(feature = "upstream-signatures")]
impl core::ops::DerefMut for ImpulseJoint {
    fn deref_mut(&mut self) -> &mut BodyPair {
        &mut self.bodies
    }
}

impl ImpulseJoint {
    /// Bytes at the front of a joint that are all that the step needs of one without limits and motors.
    pub(crate) const FRONT: usize =
        core::mem::offset_of!(Self, data) + core::mem::offset_of!(GenericJoint, limits);

    pub(super) fn new(body1: RigidBodyHandle, body2: RigidBodyHandle, data: GenericJoint) -> Self {
        let (force, torque) = (Vector::ZERO, ANG_ZERO);
        let bodies = BodyPair { body1, body2 };
        let impulses = [0.0; SPATIAL_DIM];
        Self {
            bodies,
            data,
            impulses,
            force,
            torque,
            angles: None,
            is_displaced: false,
            count: None,
        }
    }

    /// Both bodies.
    pub fn bodies(&self) -> BodyPair {
        self.bodies
    }

    /// The first body.
    pub fn body1(&self) -> RigidBodyHandle {
        self.body1
    }

    /// The second body.
    pub fn body2(&self) -> RigidBodyHandle {
        self.body2
    }

    /// The force of the joint on the second body, at the joint's anchor (mass·length/s², world space, mean of
    /// the last step). It includes locked axes, limits and motors. The first body gets the opposite force,
    /// unless the joint is a [`Transmission`](super::Transmission).
    pub fn force(&self) -> Vector {
        self.force
    }

    /// The torque of the joint on the second body, about the joint's anchor (mass·length²/s², world space,
    /// mean of the last step). It includes locked axes, limits and motors. The first body gets the opposite
    /// torque.
    pub fn torque(&self) -> AngVector {
        self.torque
    }

    /// Clears impulses and turns, which belonged to other bodies.
    pub(super) fn clear_history(&mut self) {
        self.angles = None;
        self.count = None;
        self.clear_impulses();
    }

    /// Begins a new measurement of a transmission, after a program has moved a joint frame.
    pub(super) fn forget_frames(&mut self) {
        if let Some(count) = &mut self.count {
            count.frames = None;
        }
    }

    /// Clears all impulses, so that the next step starts with zeros.
    pub(crate) fn clear_impulses(&mut self) {
        self.impulses = [0.0; SPATIAL_DIM];
        (self.force, self.torque) = (Vector::ZERO, ANG_ZERO);
        self.data.limits.iter_mut().for_each(|limits| limits.impulse = 0.0);
        self.data.motors.iter_mut().for_each(|motor| motor.impulse = 0.0);
    }

    /// Scales the impulses with which the next step starts.
    pub(crate) fn scale_impulses(&mut self, factor: Real) {
        self.impulses.iter_mut().for_each(|impulse| *impulse *= factor);
        self.data.limits.iter_mut().for_each(|limits| limits.impulse *= factor);
        self.data.motors.iter_mut().for_each(|motor| motor.impulse *= factor);
    }

    /// Returns whether the impulses and angles with which the next step would start are numbers.
    pub(crate) fn is_sound(&self) -> bool {
        self.impulses.iter().all(|impulse| impulse.is_finite())
            && self.data.limits.iter().all(|limits| limits.impulse.is_finite())
            && self.data.motors.iter().all(|motor| motor.impulse.is_finite())
            && self.force.is_finite()
            && ang_is_finite(self.torque)
            && self.angles.iter().flatten().all(|angle| angle.is_finite())
    }
}
