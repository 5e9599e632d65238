//! Parts of bodies and colliders as plain data. The engine stores them in another form: they serve programs
//! that name the types.

use crate::geometry::{ColliderHandle, SharedShape};
use crate::math::{AngVector, Pose, Real, Vector};

/// The type of a body.
pub type BodyStatus = engine::dynamics::RigidBodyType;
/// The shape of a collider.
pub type ColliderShape = SharedShape;

/// Defines plain data.
macro_rules! components {
    ($($(#[$doc:meta])* $name:ident { $($field:ident: $type:ty,)* })*) => {
        $(
            $(#[$doc])*
            #[derive(Copy, Clone, Debug, Default, PartialEq)]
            #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
            pub struct $name {
                $(#[doc = concat!("The value `", stringify!($field), "`.")] pub $field: $type,)*
            }
        )*
    };
}

components! {
    /// Pose of a body, now and at the end of the step.
    RigidBodyPosition { position: Pose, next_position: Pose, }
    /// Damping of a body (1/s).
    RigidBodyDamping { linear_damping: Real, angular_damping: Real, }
    /// Forces on a body.
    RigidBodyForces {
        force: Vector,
        torque: AngVector,
        gravity_scale: Real,
        user_force: Vector,
        user_torque: AngVector,
        gyroscopic_forces_enabled: bool,
    }
    /// Continuous collision detection of a body.
    RigidBodyCcd {
        ccd_thickness: Real,
        ccd_active: bool,
        ccd_enabled: bool,
        soft_ccd_prediction: Real,
    }
    /// Two colliders.
    ColliderPair { collider1: ColliderHandle, collider2: ColliderHandle, }
}

impl ColliderPair {
    /// A pair of two colliders.
    pub fn new(collider1: ColliderHandle, collider2: ColliderHandle) -> Self {
        Self { collider1, collider2 }
    }

    /// The pair in the other order.
    #[must_use]
    pub fn swap(self) -> Self {
        Self::new(self.collider2, self.collider1)
    }
}

/// Dominance group of a body.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct RigidBodyDominance(pub i8);

impl RigidBodyDominance {
    /// The group of a body of this type: bodies that are not dynamic dominate all others.
    pub fn effective_group(&self, status: &BodyStatus) -> i16 {
        if status.is_dynamic() { i16::from(self.0) } else { i16::from(i8::MAX) + 1 }
    }
}

/// Colliders of a body.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RigidBodyColliders(pub Vec<ColliderHandle>);

/// Whether a collider is a sensor.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum ColliderType {
    /// It touches others.
    Solid,
    /// It reports intersections only.
    Sensor,
}

impl ColliderType {
    /// Returns whether it is a sensor.
    pub fn is_sensor(self) -> bool {
        self == Self::Sensor
    }
}

/// Pose of a collider.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct ColliderPosition(pub Pose);

impl ColliderPosition {
    /// The identity.
    pub fn identity() -> Self {
        Self(Pose::IDENTITY)
    }
}

/// The begin or end of a pair of boxes.
#[derive(Copy, Clone, Debug, PartialEq)]
pub enum BroadPhasePairEvent {
    /// The boxes overlap.
    AddPair(ColliderPair),
    /// The boxes do not overlap any more.
    DeletePair(ColliderPair),
}
