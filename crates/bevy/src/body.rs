//! Components of a body.

use crate::dim::{ANG_ZERO, AngVector, Vector};
use crate::hierarchy::Carrier;
use crate::precision::Scalar;
use bevy::ecs::component::Component;
use bevy::ecs::reflect::ReflectComponent;
use bevy::reflect::Reflect;
use bevy::transform::components::Transform;
use rapier::prelude::{LockedAxes as AxesMask, RigidBodyType};

/// A rigid body. The entity's `Transform` is its pose. The [`Collider`](crate::Collider)s of the entity and
/// of its descendants are its shape.
///
/// All other components of a body are required ones, so `commands.spawn(RigidBody::Dynamic)` is complete.
#[derive(Component, Reflect, Copy, Clone, Debug, Default, PartialEq, Eq)]
#[reflect(Component)]
#[require(
    Transform,
    Velocity,
    GravityScale,
    Damping,
    LockedAxes,
    ExternalForce,
    ExternalImpulse,
    Sleeping,
    BodyState
)]
pub enum RigidBody {
    /// Forces, gravity and contacts move the body.
    #[default]
    Dynamic,
    /// The body never moves.
    Fixed,
    /// The user sets the `Transform`. The next step moves the body there, and it pushes and carries other
    /// bodies on the way.
    ///
    /// Edits relative to the old `Transform` belong in `FixedUpdate`: in `Update` it is an interpolated pose,
    /// which is up to one step old.
    KinematicPosition,
    /// The user sets the [`Velocity`]. Contacts do not slow the body down.
    KinematicVelocity,
}

impl RigidBody {
    /// The engine's name of the type.
    pub(crate) fn engine_type(self) -> RigidBodyType {
        match self {
            Self::Dynamic => RigidBodyType::Dynamic,
            Self::Fixed => RigidBodyType::Fixed,
            Self::KinematicPosition => RigidBodyType::KinematicPositionBased,
            Self::KinematicVelocity => RigidBodyType::KinematicVelocityBased,
        }
    }
}

/// Velocity of a body. Each step writes it; an edit by the user sets it.
#[derive(Component, Reflect, Copy, Clone, Debug, PartialEq)]
#[reflect(Component)]
pub struct Velocity {
    /// Velocity of the centre of mass (length/s).
    pub linear: Vector,
    /// Angular velocity (rad/s).
    pub angular: AngVector,
}

impl Default for Velocity {
    fn default() -> Self {
        Self { linear: Vector::ZERO, angular: ANG_ZERO }
    }
}

impl Velocity {
    /// A velocity without rotation.
    pub fn linear(linear: Vector) -> Self {
        Self { linear, ..Self::default() }
    }

    /// A rotation about the centre of mass.
    pub fn angular(angular: AngVector) -> Self {
        Self { angular, ..Self::default() }
    }
}

/// Factor of the gravity on a body. 1 by default.
#[derive(Component, Reflect, Copy, Clone, Debug, PartialEq)]
#[reflect(Component)]
pub struct GravityScale(pub Scalar);

impl Default for GravityScale {
    fn default() -> Self {
        Self(1.0)
    }
}

/// Rates (1/s) at which a body loses velocity. 0 by default.
#[derive(Component, Reflect, Copy, Clone, Debug, Default, PartialEq)]
#[reflect(Component)]
pub struct Damping {
    /// Rate of the linear velocity.
    pub linear: Scalar,
    /// Rate of the angular velocity.
    pub angular: Scalar,
}

/// World axes along and about which forces do not move a body. None by default.
#[derive(Component, Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct LockedAxes(pub AxesMask);

impl LockedAxes {
    /// No rotation.
    pub const ROTATION: Self = Self(AxesMask::ROTATION_LOCKED);
    /// No translation.
    pub const TRANSLATION: Self = Self(AxesMask::TRANSLATION_LOCKED);
}

/// A force and a torque that act on a body in every step, until the user changes them.
#[derive(Component, Reflect, Copy, Clone, Debug, PartialEq)]
#[reflect(Component)]
pub struct ExternalForce {
    /// Force on the centre of mass, in world space.
    pub force: Vector,
    /// Torque, in world space.
    pub torque: AngVector,
}

impl Default for ExternalForce {
    fn default() -> Self {
        Self { force: Vector::ZERO, torque: ANG_ZERO }
    }
}

/// An impulse that acts on a body in the next step, which resets the component to zero.
#[derive(Component, Reflect, Copy, Clone, Debug, PartialEq)]
#[reflect(Component)]
pub struct ExternalImpulse {
    /// Impulse on the centre of mass (mass · length/s), in world space.
    pub impulse: Vector,
    /// Angular impulse, in world space.
    pub torque_impulse: AngVector,
}

impl Default for ExternalImpulse {
    fn default() -> Self {
        Self { impulse: Vector::ZERO, torque_impulse: ANG_ZERO }
    }
}

/// Sleep state of a body. The plugin writes it.
#[derive(Component, Reflect, Copy, Clone, Debug, Default, PartialEq, Eq)]
#[reflect(Component)]
pub struct Sleeping(bool);

impl Sleeping {
    pub(crate) fn new(is_sleeping: bool) -> Self {
        Self(is_sleeping)
    }

    /// Returns whether the body sleeps.
    pub fn is_sleeping(self) -> bool {
        self.0
    }
}

/// The last values that the plugin wrote. A component with another value has an edit of the user.
#[derive(Component, Copy, Clone, Debug, Default)]
pub(crate) struct BodyState {
    /// The transform before the last step.
    pub previous: Transform,
    /// The transform after the last step.
    pub current: Transform,
    /// The last transform that the plugin wrote: `current`, or one between `previous` and `current`.
    pub shown: Transform,
    /// World transform of the parent entity at the last step.
    pub parent: Transform,
    /// The part of `parent` that edits of the user alone change.
    pub carrier: Carrier,
    /// The velocity after the last step.
    pub velocity: Velocity,
}

impl BodyState {
    /// Makes a transform the only one: a teleport is not interpolated.
    pub fn reset(&mut self, transform: Transform) {
        (self.previous, self.current, self.shown) = (transform, transform, transform);
    }
}
