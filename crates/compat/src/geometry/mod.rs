//! Colliders, shapes and contacts.

mod broad_phase;
#[cfg(rapier036)]
mod colliders;
#[cfg_attr(rapier036, path = "contact036.rs")]
mod contact;
mod convert;
mod force;
mod narrow_phase;

#[cfg(rapier036)]
pub use crate::dynamics::{
    SoftContactImpulse, SoftEdgeCandidate, SoftEdgePass, SoftPairContacts, SoftVertexCandidate,
    SoftVertexHits, SoftVertexPass, SoftVolumePatch, VolumeBin,
};
pub use crate::parry::bounding_volume::BoundingVolume;
pub use crate::parry::partitioning::{Bvh, BvhBuildStrategy};
pub use crate::parry::query::{PointQuery, PointQueryWithLocation, RayCast, TrackedContact};
pub use crate::parry::shape::*;
pub use crate::parry::utils::Array2;
pub use broad_phase::{BroadPhaseBvh, BvhOptimizationStrategy, DefaultBroadPhase};
#[cfg(rapier036)]
pub use colliders::ColliderSet;
pub use contact::{
    Contact, ContactData, ContactManifold, ContactManifoldData, ContactManifoldExt, ContactPair,
    SolverContact, SolverFlags,
};
#[cfg(rapier036)]
pub use contact::{
    ContactId, NEW_CONTACT_BIT, PairContacts, RigidPairContacts, SolverContacts, is_bouncy,
};
pub(crate) use convert::{to_manifold, to_pair, write_back};
#[cfg(not(rapier036))]
pub use engine::geometry::ColliderSet;
pub use engine::geometry::{
    Aabb, ActiveCollisionTypes, Collider, ColliderBuilder, ColliderChanges, ColliderEnabled,
    ColliderFlags, ColliderHandle, ColliderMassProps, ColliderMaterial, ColliderParent,
    CollisionEvent, CollisionEventFlags, Group, InteractionGroups, InteractionTestMode,
    IntersectionPair, MeshConverter, PointProjection, Ray, RayIntersection, ShapeCastHit,
};

/// A borrowed set of the engine as the set of this version.
#[cfg(rapier036)]
pub(crate) fn wrap_colliders(colliders: &engine::geometry::ColliderSet) -> &ColliderSet {
    ColliderSet::wrap(colliders)
}

/// A borrowed set of the engine as the set of this version.
#[cfg(not(rapier036))]
pub(crate) const fn wrap_colliders(colliders: &ColliderSet) -> &ColliderSet {
    colliders
}

/// Error of a mesh that makes no collider.
pub type MeshConverterError = engine::geometry::InvalidCollider;
pub use force::ContactForceEvent;
pub use narrow_phase::NarrowPhase;
