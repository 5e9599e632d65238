//! Everything that most programs need: the plugin, its components and events.

#[cfg(feature = "debug-lines")]
pub use crate::debug_lines::{PhysicsDebugPlugin, PhysicsGizmos};
pub use crate::{
    AngVector, Collider, ColliderMass, CollisionEvents, CollisionGroups, CollisionHooks,
    CollisionStarted, CollisionStopped, ContactForce, ContactForceEvents, ContactPair, Damping,
    ExternalForce, ExternalImpulse, Friction, GravityScale, HookedPairs, Invalid, Joint,
    JointBroken, LockedAxes, ModifiedContacts, PhysicsPlugin, PhysicsSystems, PhysicsWorld,
    PointHit, RayHit, Refused, Restitution, RigidBody, Scalar, Sensor, ShapeHit, Sleeping,
    SpatialFilter, SpatialQuery, Vector, Velocity,
};
pub use rapier::prelude::{
    ActiveHooks, CoefficientCombineRule, Group, InteractionGroups, JointAxis,
    LockedAxes as AxesMask,
};
