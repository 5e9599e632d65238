//! Contacts of soft bodies. The engine makes none.

use crate::geometry::ColliderHandle;
use crate::math::{DIM, Real, Vector};
use core::ops::Range;

/// Defines plain data.
macro_rules! contacts {
    ($($(#[$meta:meta])* $name:ident { $($field:ident: $type:ty,)* })*) => {
        $(
            $(#[$meta])*
            #[derive(Clone, Debug)]
            pub struct $name {
                $(#[doc = "A value of a contact of soft bodies."] pub $field: $type,)*
            }
        )*
    };
}

contacts! {
    /// Contacts of a pair with a soft body.
    #[derive(Default)]
    SoftPairContacts {
        vertex_passes: Vec<SoftVertexPass>,
        edges: Option<SoftEdgePass>,
        volume: Option<SoftVolumePatch>,
    }

    /// Contacts of the vertices of one surface with another surface.
    #[derive(Default)]
    SoftVertexPass {
        surface: ColliderHandle,
        vertices_of: ColliderHandle,
        candidates: Vec<SoftVertexCandidate>,
        hits: Vec<SoftVertexHits>,
        cross_pairs: Vec<(u32, u32)>,
        cross_tangled_elements: Vec<bool>,
        cross_tangled_vb_elements: Vec<bool>,
        cross_tangled_vertices: Vec<bool>,
        patch_inside_vb: Vec<bool>,
        repel_guides: Vec<(Vector, Vector)>,
        repel_inside: Vec<bool>,
    }

    /// Contacts of the edges of two surfaces.
    #[derive(Default)]
    SoftEdgePass {
        own: ColliderHandle,
        other: ColliderHandle,
        candidates: Vec<SoftEdgeCandidate>,
        crossed: bool,
    }

    /// Contacts of one vertex.
    SoftVertexHits {
        vertex: u32,
        candidates: Range<u32>,
        crossed: bool,
    }

    /// A contact of a vertex with an element of a surface.
    #[derive(Copy)]
    SoftVertexCandidate {
        element: u32,
        weights: [Real; DIM],
        dir: Vector,
        dist: Real,
        enabled: bool,
        impulse: Real,
        tangent_impulse: Vector,
        interior: bool,
        outward: Option<Vector>,
        rest_gap: bool,
    }

    /// A contact of two edges.
    #[derive(Copy)]
    SoftEdgeCandidate {
        edge: u32,
        other_edge: u32,
        bcoords: [Real; 2],
        other_bcoords: [Real; 2],
        point: Vector,
        other_point: Vector,
        dir: Vector,
        dist: Real,
        enabled: bool,
        impulse: Real,
        tangent_impulse: Vector,
    }

    /// Contacts of two volumes.
    SoftVolumePatch {
        own: ColliderHandle,
        bins: Vec<VolumeBin>,
    }

    /// A part of the overlap of two volumes.
    VolumeBin {
        center: Vector,
        normal: Vector,
        volume: Real,
        own: Vec<(u32, Vector)>,
        other: Vec<(u32, Vector)>,
        enabled: bool,
        impulse: Real,
    }

    /// An impulse of a contact.
    #[derive(Copy)]
    SoftContactImpulse {
        normal: Vector,
        impulse: Real,
        tangent_impulse: Vector,
    }
}

impl SoftPairContacts {
    /// Returns whether the pair touches: no.
    pub fn is_touching(&self) -> bool {
        false
    }

    /// Disables nothing.
    pub fn disable_all(&mut self) {}

    /// The contacts with a surface.
    pub fn vertex_pass_on(&self, surface: ColliderHandle) -> Option<&SoftVertexPass> {
        self.vertex_passes.iter().find(|pass| pass.surface == surface)
    }

    /// The impulses: none.
    pub fn impulses(
        &self,
        _collider1: ColliderHandle,
    ) -> impl Iterator<Item = SoftContactImpulse> + '_ {
        core::iter::empty()
    }
}

impl SoftVertexPass {
    /// The contacts of a vertex.
    pub fn candidates_of(&self, hit: &SoftVertexHits) -> &[SoftVertexCandidate] {
        &self.candidates[hit.candidates.start as usize..hit.candidates.end as usize]
    }
}
