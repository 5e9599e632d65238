//! Bodies that were disabled because a number of theirs left the usable range.

use super::{RigidBody, RigidBodyChanges, RigidBodyVelocity};
use crate::dim::math::{AngVector, Pose, Real, Vector, ang_is_finite};
use crate::model::check::checked_pose;
use core::fmt;

/// The unusable quantity, and its value.
///
/// Positions and speeds beyond 1e15 cannot be calculated with: their squares would soon be infinite in single
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
    /// The body's pose when the step began. Setters refuse such poses; saved worlds may have them.
    Position(Pose),
    /// The body's velocity when the step began: impossible by itself, or so large that it leads out of the
    /// world within the step.
    Velocity(RigidBodyVelocity),
    /// The user's force (mass·length/s²) and torque (mass·length²/s²) on the body: within a step of this
    /// length they exceed the range of numbers.
    Force {
        /// The force on the centre of mass.
        force: Vector,
        /// The torque about it.
        torque: AngVector,
    },
    /// Gravity (length/s²), times the body's gravity scale.
    Gravity(Vector),
    /// The body's inverse mass along each axis.
    Mass(Vector),
    /// The target of a kinematic body at the end of the step, too far away for a finite speed.
    KinematicTarget(Pose),
    /// The velocity that contacts and joints, or the gyroscopic torque, gave to the body in the solver.
    Constraints(RigidBodyVelocity),
    /// The body is a link of a multibody. The value is the velocity that its joints gave to the first
    /// diverged link. All moving links are disabled together.
    Multibody(RigidBodyVelocity),
    /// A contact's coefficient of restitution.
    Restitution(Real),
    /// A contact's velocity along its plane, as set by a hook (length/s).
    TangentVelocity(Vector),
    /// A contact's normal, and the distance at one of its points.
    Contact {
        /// From the first collider to the second, in world space.
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
    /// The cause for which the step disabled the body, if it did. It stands where that step found it.
    /// [`Self::set_enabled`] takes it back into the simulation, and forgets the cause; what caused it is
    /// still there, unless it was changed. Saved worlds do not keep the cause.
    pub fn quarantine(&self) -> Option<QuarantineCause> {
        self.quarantine.as_deref().copied()
    }

    /// Takes the body out of the simulation as [`Self::set_enabled`] does. Numbers of its motion that are
    /// none are made up: zero for velocities and forces, the origin for a place.
    pub(crate) fn put_in_quarantine(&mut self, cause: QuarantineCause) {
        if self.enabled {
            self.enabled = false;
            self.changes.insert(RigidBodyChanges::ENABLED_OR_DISABLED);
        }
        self.quarantine = Some(Box::new(cause));
        self.drop_push();
        self.pose = checked_pose(self.pose).unwrap_or(Pose::IDENTITY);
        self.next_pose = checked_pose(self.next_pose).unwrap_or(self.pose);
        if !self.vels().is_usable() {
            self.halt();
        }
        if !self.force.is_finite() || !ang_is_finite(self.torque) {
            (self.force, self.torque) = Default::default();
        }
    }
}
