//! Bodies that a step disabled because one of their quantities left the usable range.

use super::{RigidBody, RigidBodyChanges, RigidBodyVelocity};
use crate::dim::math::{AngVector, Pose, Real, Vector, ang_is_finite};
use crate::model::check::checked_pose;
use core::fmt;

/// Cause of a quarantine: the unusable quantity, and its value.
///
/// Positions and speeds above 1e15 are unusable: computations with their squares would overflow in single
/// precision.
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut world = PhysicsWorld::new();
/// let ball = world.insert_body(RigidBodyBuilder::dynamic().additional_mass(1.0));
/// world.bodies[ball].add_force(Vector::X * 1.0e30, true);
/// world.step();
///
/// let ball = &mut world.bodies[ball];
/// assert_eq!(ball.translation(), Vector::ZERO, "it stays where it was");
/// assert!(!ball.is_enabled(), "and takes no part");
/// let Some(QuarantineCause::Force { force, .. }) = ball.quarantine() else { panic!() };
/// assert_eq!(force, Vector::X * 1.0e30);
///
/// // Repaired, it may come back.
/// ball.reset_forces(true);
/// ball.set_enabled(true);
/// assert_eq!(ball.quarantine(), None);
/// world.step();
/// ```
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum QuarantineCause {
    /// The body's pose when the step began. Setters refuse unusable poses; saved worlds may contain them.
    Position(Pose),
    /// The body's velocity when the step began. The speed is above 1e15, or the body would leave the range of
    /// positions within the step.
    Velocity(RigidBodyVelocity),
    /// The user's force (mass·length/s²) and torque (mass·length²/s²) on the body. The motion that they cause
    /// within one step exceeds 1e15.
    Force {
        /// The force on the centre of mass.
        force: Vector,
        /// The torque about the centre of mass.
        torque: AngVector,
    },
    /// Gravity (length/s²), times the body's gravity scale. The motion that it causes within one step exceeds
    /// 1e15.
    Gravity(Vector),
    /// The body's inverse mass along each axis (1/mass). It is not finite.
    Mass(Vector),
    /// The target of a kinematic body at the end of the step. The speed that reaches it exceeds 1e15.
    KinematicTarget(Pose),
    /// The velocity of the body after contacts, joints and the gyroscopic torque were solved.
    Constraints(RigidBodyVelocity),
    /// The body is a link of a multibody. The value is the velocity of the first diverged link. All moving
    /// links are disabled together.
    Multibody(RigidBodyVelocity),
    /// A contact's coefficient of restitution.
    Restitution(Real),
    /// A contact's velocity along its plane, as set by a hook (length/s).
    TangentVelocity(Vector),
    /// A contact's normal, and the distance at one of its points.
    Contact {
        /// The contact normal from the first collider to the second, in world space.
        normal: Vector,
        /// The distance of the two surfaces (length units).
        dist: Real,
    },
}

impl fmt::Display for QuarantineCause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Position(pose) => write!(f, "its position was {pose:?}"),
            Self::Velocity(velocity) => write!(f, "its velocity was {velocity:?}"),
            Self::Force { force, torque } => write!(f, "the force {force:?}, torque {torque:?}"),
            Self::Gravity(gravity) => write!(f, "gravity was {gravity:?}"),
            Self::Mass(inv_mass) => write!(f, "its inverse mass was {inv_mass:?}"),
            Self::KinematicTarget(pose) => write!(f, "it was to go to {pose:?} within the step"),
            Self::Constraints(velocity) => write!(f, "contacts or joints made it {velocity:?}"),
            Self::Multibody(velocity) => write!(f, "a link of its multibody was {velocity:?}"),
            Self::Restitution(value) => write!(f, "the restitution was {value}"),
            Self::TangentVelocity(value) => write!(f, "the tangent velocity was {value:?}"),
            Self::Contact { normal, dist } => write!(f, "the normal was {normal:?} at {dist}"),
        }
    }
}

impl RigidBody {
    /// The cause for which a step disabled the body; `None` if no step did. The body keeps its pose from the
    /// start of that step. [`Self::set_enabled`] returns the body to the simulation and clears the cause. The
    /// cause itself, such as a large force, remains until the user changes it. Saved worlds do not contain
    /// the cause.
    pub fn quarantine(&self) -> Option<QuarantineCause> {
        self.quarantine.as_deref().copied()
    }

    /// Takes the body out of the simulation as [`Self::set_enabled`] does. Unusable values of its motion are
    /// replaced: velocities and forces by zero, poses by the origin.
    pub(crate) fn put_in_quarantine(&mut self, cause: QuarantineCause) {
        if self.enabled {
            self.enabled = false;
            self.changes.insert(RigidBodyChanges::ENABLED_OR_DISABLED);
        }
        self.quarantine = Some(Box::new(cause));
        self.drop_push();
        self.pose = checked_pose(self.pose).unwrap_or(Pose::IDENTITY);
        self.next_pose = checked_pose(self.next_pose).unwrap_or(self.pose);
        if !self.vels.is_usable() {
            self.halt();
        }
        if !self.force.is_finite() || !ang_is_finite(self.torque) {
            (self.force, self.torque) = Default::default();
        }
    }
}
