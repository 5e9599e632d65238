//! Error of a refused joint, or of a refused value of a joint.

use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::RigidBodyHandle;

/// The reason why a joint, or one of its values, is refused, with that value.
#[derive(Copy, Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidJoint {
    /// An anchor has a coordinate that is not finite, or too large to calculate with.
    #[error("the anchor is {anchor}, but its coordinates must be finite and at most 1e15")]
    Anchor {
        /// The anchor.
        anchor: Vector,
    },
    /// An axis has no direction: it is zero, not finite, or too long or short to calculate with.
    #[error("the axis is {axis}, but must have a finite length above 0")]
    Axis {
        /// The axis.
        axis: Vector,
    },
    /// A frame is not a finite translation and a rotation of unit length.
    #[error(
        "the frame is {frame:?}, but must be a finite translation and a rotation of unit length"
    )]
    Frame {
        /// The frame.
        frame: Pose,
    },
    /// A set of axes contains unknown axes.
    #[error("the axes {axes:?} are not all axes of a joint")]
    UnknownAxes {
        /// The axes.
        axes: JointAxesMask,
    },
    /// The lower limit is above the upper one, or one of them is NaN.
    #[error(
        "the limits of {axis:?} are {min} to {max}, but the first must not be above the second"
    )]
    Limits {
        /// The axis.
        axis: JointAxis,
        /// The lower limit.
        min: Real,
        /// The upper limit.
        max: Real,
    },
    /// A number of a motor, a spring or a threshold is out of its range.
    #[error("{parameter} is {value}, but must be {expected}")]
    Number {
        /// The parameter.
        parameter: &'static str,
        /// The refused value.
        value: Real,
        /// The admissible values.
        expected: &'static str,
    },
    /// A transmission has locked axes, or limits or motors besides those of its sum.
    #[error("a transmission has no axes besides LinX, but {axes:?} are locked, limited or driven")]
    TransmissionAxes {
        /// The axes.
        axes: JointAxesMask,
    },
    /// A multibody joint must not be a transmission. Couple the degrees of freedom of the multibody, or use
    /// an impulse joint between its links.
    #[error("a multibody joint cannot be a transmission")]
    TransmissionInMultibody,
    /// A link of a multibody has no degree of freedom with its own coordinate on this axis.
    #[error("link {link} has no coordinate {axis:?}: the axis is locked, or one of a ball joint")]
    Dof {
        /// The link's index among the multibody's links.
        link: usize,
        /// The axis.
        axis: JointAxis,
    },
    /// A degree of freedom is coupled with itself.
    #[error("a coordinate cannot be coupled with itself: {axis:?} of link {link}")]
    SameDof {
        /// The link's index among the multibody's links.
        link: usize,
        /// The axis.
        axis: JointAxis,
    },
    /// Both ends are at the same body.
    #[error("a joint cannot join {body:?} to itself")]
    SameBody {
        /// The body.
        body: RigidBodyHandle,
    },
    /// A body handle is stale.
    #[error("{body:?} is not the handle of a rigid body")]
    MissingBody {
        /// The handle.
        body: RigidBodyHandle,
    },
    /// Neither body is dynamic, so they cannot move relative to each other.
    #[error("neither {body1:?} nor {body2:?} is dynamic")]
    NoDynamicBody {
        /// The first body.
        body1: RigidBodyHandle,
        /// The second body.
        body2: RigidBodyHandle,
    },
    /// The child body of a multibody joint already has a parent.
    #[error("{body:?} already has a parent")]
    SecondParent {
        /// The intended child body.
        body: RigidBodyHandle,
    },
    /// A multibody joint must not limit or drive the distance along several axes, as ropes and springs do.
    /// That distance is not a coordinate of the multibody. Use an impulse joint between its links.
    #[error("a multibody has no coordinate for the distance along {axes:?}")]
    DistanceInMultibody {
        /// The axes.
        axes: JointAxesMask,
    },
    /// The joint would close a loop of multibody joints. Close loops with impulse joints.
    #[error("{child:?} is an ancestor of {parent:?}")]
    Loop {
        /// The intended parent body.
        parent: RigidBodyHandle,
        /// The intended child body.
        child: RigidBodyHandle,
    },
}
