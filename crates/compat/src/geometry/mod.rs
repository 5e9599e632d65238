//! Colliders, shapes and contacts.

mod broad_phase;
#[cfg(rapier036)]
mod colliders;
#[cfg_attr(rapier036, path = "contact036.rs")]
mod contact;
mod convert;
mod force;
mod interaction_graph;
mod narrow_phase;

pub use crate::components::{
    BroadPhasePairEvent, ColliderPair, ColliderPosition, ColliderShape, ColliderType,
};
#[cfg(rapier036)]
pub use crate::dynamics::{
    SoftContactImpulse, SoftEdgeCandidate, SoftEdgePass, SoftPairContacts, SoftVertexCandidate,
    SoftVertexHits, SoftVertexPass, SoftVolumePatch, VolumeBin,
};
/// Index of a collider in a graph.
pub type ColliderGraphIndex = crate::data::graph::NodeIndex;
/// Index of a body in a graph.
pub type RigidBodyGraphIndex = crate::data::graph::NodeIndex;
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
    MeshConverter, PointProjection, Ray, RayIntersection, ShapeCastHit,
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
pub use interaction_graph::{InteractionGraph, IntersectionPair, TemporaryInteractionIndex};
pub use narrow_phase::NarrowPhase;
