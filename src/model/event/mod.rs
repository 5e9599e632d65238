//! Events of a step: pairs that begin or stop to touch, strong contact forces, broken joints, and bodies that
//! were disabled because of unusable numbers.
//!
//! Events are sent at the end of a step, on the thread that called it. Collision events have the order of the
//! colliders. The [`ActiveEvents`](crate::model::collider::ActiveEvents) of the colliders select the pairs
//! that send any.

mod channel;
mod force;
mod joint;
mod quarantine;

#[cfg(test)]
mod tests;

pub use channel::ChannelEventCollector;
pub use force::ContactForceEvent;
pub use joint::JointBreakEvent;
pub use quarantine::QuarantineEvent;

use crate::dim::math::Real;
use crate::model::body::RigidBodySet;
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::ContactPair;

bitflags::bitflags! {
    /// Circumstances of a collision event.
    #[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    pub struct CollisionEventFlags: u32 {
        /// At least one of the colliders is a sensor: they intersect, without contact points.
        const SENSOR = 1;
        /// The collision stopped because one of the colliders was removed.
        const REMOVED = 1 << 1;
    }
}

/// Event of two colliders that began or stopped to touch, or to intersect if one is a sensor.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum CollisionEvent {
    /// They touch now, but did not in the previous step.
    Started(ColliderHandle, ColliderHandle, CollisionEventFlags),
    /// They touched in the previous step, but do not now. The handle of a removed collider is stale.
    Stopped(ColliderHandle, ColliderHandle, CollisionEventFlags),
}

impl CollisionEvent {
    fn parts(self) -> (ColliderHandle, ColliderHandle, CollisionEventFlags) {
        match self {
            Self::Started(collider1, collider2, flags) => (collider1, collider2, flags),
            Self::Stopped(collider1, collider2, flags) => (collider1, collider2, flags),
        }
    }

    /// Returns whether the collision began.
    pub fn started(self) -> bool {
        matches!(self, Self::Started(..))
    }

    /// Returns whether the collision stopped.
    pub fn stopped(self) -> bool {
        matches!(self, Self::Stopped(..))
    }

    /// The first collider.
    pub fn collider1(self) -> ColliderHandle {
        self.parts().0
    }

    /// The second collider.
    pub fn collider2(self) -> ColliderHandle {
        self.parts().1
    }

    /// Returns whether one of the colliders is a sensor.
    pub fn sensor(self) -> bool {
        self.parts().2.contains(CollisionEventFlags::SENSOR)
    }

    /// Returns whether the collision stopped because a collider was removed.
    pub fn removed(self) -> bool {
        self.parts().2.contains(CollisionEventFlags::REMOVED)
    }
}

/// Handler of the events of a step.
///
/// The handler reads the bodies and colliders at the end of the step. To change them, it stores a note for
/// use after the step. A handler that panics is called for the remaining events nevertheless; then its first
/// panic propagates to the caller of the step.
///
/// ```
/// # use rapier3d::prelude::*;
///
/// struct Announce;
///
/// impl EventHandler for Announce {
///     fn handle_collision_event(
///         &self,
///         _bodies: &RigidBodySet,
///         _colliders: &ColliderSet,
///         event: &CollisionEvent,
///         _contact_pair: Option<&ContactPair>,
///     ) {
///         if event.started() {
///             println!("{:?} hit {:?}", event.collider1(), event.collider2());
///         }
///     }
/// }
/// ```
pub trait EventHandler: Send + Sync {
    /// Called when two colliders began or stopped to touch or intersect, and at least one of them has
    /// [`COLLISION_EVENTS`](crate::model::collider::ActiveEvents::COLLISION_EVENTS).
    ///
    /// `contact_pair` is `None` if one of them is a sensor or was removed.
    fn handle_collision_event(
        &self,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        event: &CollisionEvent,
        contact_pair: Option<&ContactPair>,
    );

    /// Called when the contact forces between two colliders sum up to at least the
    /// `contact_force_event_threshold` of one that has
    /// [`CONTACT_FORCE_EVENTS`](crate::model::collider::ActiveEvents::CONTACT_FORCE_EVENTS), and not to zero.
    /// `dt` is the length of the step (s). The default implementation does nothing.
    fn handle_contact_force_event(
        &self,
        dt: Real,
        event: &ContactForceEvent,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let _ = (dt, event, bodies, colliders);
    }

    /// [`Self::handle_contact_force_event`] with the contacts of the pair. The engine calls this method only.
    /// The default implementation calls that function.
    fn handle_contact_force_event_of_pair(
        &self,
        dt: Real,
        event: &ContactForceEvent,
        contact_pair: &ContactPair,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let _ = contact_pair;
        self.handle_contact_force_event(dt, event, bodies, colliders);
    }

    /// Called when a joint broke: its load exceeded its
    /// [thresholds](crate::model::joint::GenericJoint::set_break_thresholds). The joint is already disabled.
    /// The default implementation does nothing.
    fn handle_joint_break_event(&self, event: &JointBreakEvent, bodies: &RigidBodySet) {
        let _ = (event, bodies);
    }

    /// Called when a step disabled a body, or left out a contact, because of an unusable number. These events
    /// precede all others, with one event per body. The default implementation does nothing.
    fn handle_quarantine_event(
        &self,
        event: &QuarantineEvent,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let _ = (event, bodies, colliders);
    }
}

/// Ignores all events.
impl EventHandler for () {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
    }
}

/// Ignores all events.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct DefaultEventHandler;

impl EventHandler for DefaultEventHandler {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
    }
}
