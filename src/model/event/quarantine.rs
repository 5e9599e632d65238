//! Bodies that the step took out of the simulation, and contacts that it left out.

use crate::dim::math::Pose;
use crate::model::body::{QuarantineCause, RigidBodyHandle, RigidBodyVelocity};
use crate::model::collider::ColliderHandle;

/// Event of an unusable number: the step continued without the body or contact that contains it.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum QuarantineEvent {
    /// The step disabled the body and was computed without it:
    /// [`RigidBody::quarantine`](crate::model::body::RigidBody::quarantine).
    Body {
        /// The body.
        body: RigidBodyHandle,
        /// The unusable value.
        cause: QuarantineCause,
        /// Pose of the body at the start of the step.
        position: Pose,
        /// Velocity of the body at the start of the step.
        velocity: RigidBodyVelocity,
    },
    /// A number of a contact is unusable and was left out. Unusable restitution and tangent velocity are
    /// replaced by zero. Contacts with an unusable normal or distance exert no force. The event is sent
    /// whenever such contacts are computed.
    Contact {
        /// The first collider.
        collider1: ColliderHandle,
        /// The second collider.
        collider2: ColliderHandle,
        /// The unusable value.
        cause: QuarantineCause,
    },
}

impl QuarantineEvent {
    /// The unusable value.
    pub fn cause(&self) -> QuarantineCause {
        match *self {
            Self::Body { cause, .. } | Self::Contact { cause, .. } => cause,
        }
    }

    /// The disabled body; `None` if a contact was left out.
    pub fn body(&self) -> Option<RigidBodyHandle> {
        match *self {
            Self::Body { body, .. } => Some(body),
            Self::Contact { .. } => None,
        }
    }
}
