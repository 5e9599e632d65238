//! Results and arguments of operations on soft bodies, which never happen.

use crate::dynamics::{ImpulseJointHandle, RigidBodyHandle};
use crate::math::{DIM, Real};
use core::fmt::{Display, Formatter, Result};
use engine::dynamics::SoftBodyHandle;

/// Defines plain data.
macro_rules! records {
    ($($(#[$meta:meta])* $name:ident { $($(#[$doc:meta])* $field:ident: $type:ty,)* })*) => {
        $(
            $(#[$meta])*
            #[derive(Clone, Debug, PartialEq, Eq)]
            pub struct $name {
                $($(#[$doc])* pub $field: $type,)*
            }
        )*
    };
}

records! {
    /// A part of a torn soft body.
    SoftBodyPiece {
        /// The part.
        soft_body: SoftBodyHandle,
        /// Particles of the torn body.
        particles: Vec<u32>,
        /// Clusters of the torn body and of the part.
        clusters: Vec<[u32; 2]>,
    }

    /// A torn soft body.
    #[derive(Default)]
    SoftBodyTearEvent {
        /// The soft body.
        soft_body: SoftBodyHandle,
        /// Torn edges.
        torn_edges: Vec<[u32; 2]>,
        /// Torn cells.
        torn_cells: Vec<[u32; DIM + 1]>,
        /// Removed edges.
        removed_edges: Vec<[u32; 2]>,
        /// Divided particles, and their second parts.
        split_particles: Vec<(u32, u32)>,
        /// New particles.
        inserted_particles: Vec<u32>,
        /// Parts.
        pieces: Vec<SoftBodyPiece>,
        /// Divided clusters.
        clusters: Vec<SoftClusterSplit>,
        /// Joints of other bodies.
        moved_joints: Vec<SoftJointMove>,
    }

    /// A divided cluster.
    #[derive(Copy)]
    SoftClusterSplit {
        /// The divided cluster.
        source_cluster: u32,
        /// The soft body of the part.
        soft_body: SoftBodyHandle,
        /// The part.
        cluster: u32,
        /// Body of the part.
        proxy: RigidBodyHandle,
        /// Whether the part keeps the body.
        keeps_proxy: bool,
    }

    /// A joint that joins another body.
    #[derive(Copy)]
    SoftJointMove {
        /// The joint.
        joint: ImpulseJointHandle,
        /// The former body.
        from: RigidBodyHandle,
        /// The new body.
        to: RigidBodyHandle,
    }

    /// Counts of removed elements.
    #[derive(Copy, Default)]
    SoftClusterRemoval {
        /// Particles.
        particles: usize,
        /// Edges.
        edges: usize,
        /// Cells.
        cells: usize,
        /// Dihedral angles.
        dihedrals: usize,
        /// Elements of the surface.
        surface_elements: usize,
        /// Attachments.
        attachments: usize,
        /// Whether the soft body is removed.
        soft_body_removed: bool,
    }
}

impl SoftBodyTearEvent {
    /// The soft body and its parts.
    pub fn bodies(&self) -> impl Iterator<Item = SoftBodyHandle> + '_ {
        core::iter::once(self.soft_body).chain(self.pieces.iter().map(|piece| piece.soft_body))
    }

    /// The part that a particle belongs to, and its number there.
    pub fn particle_destination(&self, particle: u32) -> Option<(SoftBodyHandle, u32)> {
        self.pieces.iter().find_map(|piece| {
            let number = piece.particles.iter().position(|own| *own == particle)?;
            Some((piece.soft_body, number as u32))
        })
    }

    /// Particles at both sides of the tear.
    pub fn seeds(&self) -> Vec<[u32; 2]> {
        self.split_particles.iter().map(|&(one, other)| [one, other]).collect()
    }
}

/// Error of a collider on a soft body. There is no soft body.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum SoftBindingError {
    /// The collider cannot deform.
    NotDeformable,
    /// The body is no cluster of a soft body.
    NotAClusterProxy,
    /// The shape has no vertices.
    UnsupportedShape,
    /// The mesh is degenerate.
    DegenerateMesh,
    /// A vertex has no particle.
    UnboundVertex {
        /// The vertex.
        vertex: u32,
    },
    /// No particle is at a vertex.
    UnmatchedVertex {
        /// The vertex.
        vertex: u32,
    },
    /// A particle is not in the cluster.
    VertexOutsideCluster {
        /// The vertex.
        vertex: u32,
        /// The particle.
        particle: u32,
    },
}

impl Display for SoftBindingError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "the engine has no soft bodies ({self:?})")
    }
}

impl core::error::Error for SoftBindingError {}

/// The relation of the vertices of a collider to particles.
#[derive(Clone, Debug)]
pub enum SoftMeshBindingMode {
    /// A particle for each vertex.
    Direct {
        /// The particles.
        particles: Vec<u32>,
    },
    /// The particle at each vertex.
    DirectByPosition {
        /// Largest distance (length units).
        eps: Real,
    },
    /// Weights of the cell of each vertex.
    Skinned,
}

/// The relation of a collider to a soft body.
#[derive(Clone, Debug)]
pub struct SoftMeshBinding {
    /// The relation of the vertices.
    pub mode: SoftMeshBindingMode,
    /// Whether the surface collides with itself.
    pub self_contacts: bool,
}

impl SoftMeshBinding {
    /// A particle for each vertex.
    pub fn direct(particles: Vec<u32>) -> Self {
        Self { mode: SoftMeshBindingMode::Direct { particles }, self_contacts: false }
    }

    /// The particle at each vertex.
    pub fn direct_by_position(eps: Real) -> Self {
        Self { mode: SoftMeshBindingMode::DirectByPosition { eps }, self_contacts: false }
    }

    /// Weights of the cell of each vertex.
    pub fn skinned() -> Self {
        Self { mode: SoftMeshBindingMode::Skinned, self_contacts: false }
    }

    /// Sets whether the surface collides with itself.
    #[must_use]
    pub fn self_contacts(mut self, enabled: bool) -> Self {
        self.self_contacts = enabled;
        self
    }
}

/// Weights of a vertex in a cell.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SoftMeshCellBinding {
    /// The cell.
    pub cell: u32,
    /// Weights of its particles.
    pub weights: [Real; DIM + 1],
}

/// The relation of the vertices of a surface to particles.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum SoftMeshMapping {
    /// A particle for each vertex.
    Direct {
        /// The particles.
        particles: Vec<u32>,
    },
    /// Weights of the cell of each vertex.
    Skinned {
        /// The weights.
        bindings: Vec<SoftMeshCellBinding>,
    },
}
