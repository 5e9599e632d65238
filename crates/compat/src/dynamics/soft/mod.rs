//! The names of soft bodies in Rapier 0.36. The engine has no soft bodies.
//!
//! Settings, materials and builders are plain data without effect. A [`SoftBodySet`] stays empty: an
//! insertion logs an error and returns an invalid handle. No value of [`SoftBody`] and of its parts exists,
//! so their functions cannot be called.

mod absent;
mod builder;
mod contacts;
mod material;
mod records;
mod set;
mod settings;

pub use absent::{
    SoftBody, SoftBodyCell, SoftBodyCluster, SoftBodyDihedral, SoftBodyEdge, SoftBodyParticle,
    SoftCollisionMesh, SoftParticleAttachment, SoftVolumeContact, SoftVolumePiece,
};
pub use builder::SoftBodyBuilder;
pub use contacts::{
    SoftContactImpulse, SoftEdgeCandidate, SoftEdgePass, SoftPairContacts, SoftVertexCandidate,
    SoftVertexHits, SoftVertexPass, SoftVolumePatch, VolumeBin,
};
pub use material::{
    SoftBodyCellModel, SoftBodyEdgeKind, SoftBodyMaterial, SoftBodyParticleSettings,
    SoftEdgePlasticFlow,
};
pub use records::{
    SoftBindingError, SoftBodyPiece, SoftBodyTearEvent, SoftClusterRemoval, SoftClusterSplit,
    SoftJointMove, SoftMeshBinding, SoftMeshBindingMode, SoftMeshCellBinding, SoftMeshMapping,
};
pub use set::SoftBodySet;
pub use settings::{SoftBodiesSettings, SoftPatchConstraints, SoftRecoverySettings};
#[cfg(feature = "fem")]
pub use settings::{SoftBodySolver, SoftFemParameters};

use crate::math::{DIM, Vector};

/// Largest number of particles of one constraint.
pub const SOFT_BODY_MAX_CONSTRAINT_PARTICLES: usize = 1 << 16;

/// Particles of a part of a surface: an edge in 2D, a triangle in 3D.
pub type SurfaceElement = [u32; DIM];
/// Particles of a cell: a triangle in 2D, a tetrahedron in 3D.
pub type CellParticles = [u32; DIM + 1];
/// Corners of a blade: a segment in 2D, a triangle in 3D.
pub type Blade = [Vector; DIM];
