//! Bodies that the step took out of the simulation, and contacts that it left out.

use crate::dim::math::Pose;
use crate::model::body::{QuarantineCause, RigidBodyHandle, RigidBodyVelocity};
use crate::model::collider::ColliderHandle;

/// Some numbers could not be calculated with, and the step went on without what they belonged to.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum QuarantineEvent {
    /// The body is disabled now, and was not there in this step:
    /// [`RigidBody::quarantine`](crate::model::body::RigidBody::quarantine).
    Body {
        /// The body.
        body: RigidBodyHandle,
        /// The unusable value.
        cause: QuarantineCause,
        /// Position of the body: where the step found it.
        position: Pose,
        /// The velocity that it had then.
        velocity: RigidBodyVelocity,
    },
    /// A number of a contact was impossible, and is left out. Restitution and tangent velocity are zero
    /// instead; where normals or distances are no numbers, the two do not press on each other. Sent whenever
    /// such contacts are computed.
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

    /// The body that was disabled; none if a contact was left out.
    pub fn body(&self) -> Option<RigidBodyHandle> {
        match *self {
            Self::Body { body, .. } => Some(body),
            Self::Contact { .. } => None,
        }
    }
}
