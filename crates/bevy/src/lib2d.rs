//! The 2D physics engine as a plugin for [Bevy](bevy).
//!
//! An entity with a [`RigidBody`] and a [`Collider`] falls, collides and rests. [`PhysicsPlugin`] steps the
//! simulation in Bevy's fixed schedule and writes poses to `Transform`.

#[path = "dim2.rs"]
mod dim;
mod body;
mod collider;
#[cfg(feature = "debug-lines")]
mod debug_lines;
mod event;
mod hierarchy;
mod hooks;
mod invalid;
mod joint;
mod plugin;
mod precision;
mod query;
mod scale;
mod stages;
mod world;

pub mod prelude;

pub use body::{
    Damping, ExternalForce, ExternalImpulse, GravityScale, LockedAxes, RigidBody, Sleeping,
    Velocity,
};
pub use collider::{
    Collider, ColliderMass, CollisionEvents, CollisionGroups, ContactForceEvents, Friction,
    HookedPairs, Restitution, Sensor,
};
#[cfg(feature = "debug-lines")]
pub use debug_lines::{PhysicsDebugPlugin, PhysicsGizmos};
pub use dim::{AngVector, Vector};
pub use event::{CollisionStarted, CollisionStopped, ContactForce, JointBroken};
pub use hooks::{CollisionHooks, ContactPair, ModifiedContacts};
pub use invalid::{Invalid, Refused};
pub use joint::Joint;
pub use plugin::{PhysicsPlugin, PhysicsSystems};
pub use precision::{Precision, Scalar};
pub use query::{PointHit, RayHit, ShapeHit, SpatialFilter, SpatialQuery};
/// The engine: its types appear where Bevy has none.
pub use rapier;
pub use world::PhysicsWorld;
