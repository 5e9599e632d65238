//! The meshes of shapes, kept from picture to picture.

use crate::rapier::prelude::*;
use crate::shapes::mesh;
use drawing::Mesh;
use std::collections::HashMap;
use std::sync::Arc;

/// Pieces of the quarter turn of a rounded border.
pub(crate) const BORDER_PIECES: u32 = 5;

/// The meshes of shapes that are not one of the shared ones, by the address of the shape.
///
/// The store keeps the shape alive, so its address stays its own, and a shared shape never changes.
#[derive(Clone, Default)]
pub(crate) struct Surfaces {
    kept: HashMap<usize, (SharedShape, Arc<Mesh>)>,
}

impl Surfaces {
    /// The mesh of a shape, made at the first call.
    pub(crate) fn kept(&mut self, shape: &SharedShape) -> Arc<Mesh> {
        let address = Arc::as_ptr(&shape.0).cast::<()>() as usize;
        let entry = self.kept.entry(address);
        entry.or_insert_with(|| (shape.clone(), Arc::new(mesh(&shape.as_typed_shape())))).1.clone()
    }

    /// Drops the meshes of shapes that have no other owner any more.
    pub(crate) fn drop_unused(&mut self) {
        self.kept.retain(|_, (shape, _)| Arc::strong_count(&shape.0) > 1);
    }
}
