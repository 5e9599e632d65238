//! Shapes, colliders, and the contacts between them.

pub use crate::model::collider::{
    ActiveCollisionTypes, Collider, ColliderBuilder, ColliderChanges, ColliderEnabled,
    ColliderFlags, ColliderHandle, ColliderMassProps, ColliderMaterial, ColliderParent,
    ColliderSet, Group, InteractionGroups, InteractionTestMode, InvalidCollider, MeshConverter,
};
pub use crate::model::contact::{
    Contact, ContactManifold, ContactManifoldData, ContactPair, ContactPoints, IntersectionPair,
    NarrowPhase, SolverFlags,
};
// Globs: the names differ by version of parry, and by dimension.
pub use crate::base::parry_version::names::*;
pub use crate::dim::names::*;
pub use crate::model::event::{CollisionEvent, CollisionEventFlags, ContactForceEvent};
pub use crate::model::tree::{BroadPhaseBvh, DefaultBroadPhase};
pub use parry::bounding_volume::{Aabb, BoundingSphere, BoundingVolume};
pub use parry::query::{
    PointProjection, PointQuery, PointQueryWithLocation, Ray, RayCast, RayIntersection,
    ShapeCastHit, ShapeCastOptions,
};
pub use parry::shape::{
    AxisMask, Ball, Capsule, CompositeShape, CompositeShapeRef, Compound, Cuboid, FeatureId,
    HalfSpace, HeightField, HeightFieldCellStatus, OctantPattern, PackedFeatureId,
    PolygonalFeature, PolygonalFeatureMap, Polyline, RoundCuboid, RoundShape, RoundTriangle,
    Segment, SegmentPointLocation, Shape, ShapeType, SharedShape, SupportMap, TopoFace,
    TopoHalfEdge, TopoVertex, TopologyError, TriMesh, TriMeshBuilderError,
    TriMeshConnectedComponents, TriMeshFlags, TriMeshTopology, Triangle, TriangleOrientation,
    TrianglePointLocation, TrianglePseudoNormals, TypedCompositeShape, TypedShape, VoxelData,
    VoxelState, VoxelType, Voxels, VoxelsChunkRef,
};
