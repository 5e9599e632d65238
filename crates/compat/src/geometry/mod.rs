//! Colliders, shapes and contacts.

mod broad_phase;
mod contact;
mod convert;
mod force;
mod narrow_phase;

pub use crate::parry::bounding_volume::BoundingVolume;
pub use crate::parry::partitioning::{Bvh, BvhBuildStrategy};
pub use crate::parry::query::{PointQuery, PointQueryWithLocation, RayCast, TrackedContact};
pub use crate::parry::shape::*;
pub use crate::parry::utils::Array2;
pub use broad_phase::{BroadPhaseBvh, BvhOptimizationStrategy, DefaultBroadPhase};
pub use contact::{
    Contact, ContactData, ContactManifold, ContactManifoldData, ContactManifoldExt, ContactPair,
    SolverContact, SolverFlags,
};
pub(crate) use convert::{to_manifold, to_pair, write_back};
pub use engine::geometry::{
    Aabb, ActiveCollisionTypes, Collider, ColliderBuilder, ColliderChanges, ColliderEnabled,
    ColliderFlags, ColliderHandle, ColliderMassProps, ColliderMaterial, ColliderParent,
    ColliderSet, CollisionEvent, CollisionEventFlags, Group, InteractionGroups,
    InteractionTestMode, IntersectionPair, MeshConverter, PointProjection, Ray, RayIntersection,
    ShapeCastHit,
};
/// Error of a mesh that makes no collider.
pub type MeshConverterError = engine::geometry::InvalidCollider;
pub use force::ContactForceEvent;
pub use narrow_phase::NarrowPhase;
