//! Sketches of shapes, stored from one picture to the next if they are expensive.

use super::sketch::outline;
use crate::base::outline::{Detail, Outline};
use parry::shape::SharedShape;
use std::collections::HashMap;
use std::sync::Arc;

/// Sketches with at least this number of points are stored. Those of balls and boxes are made as fast as
/// found.
const STORED_POINTS_MIN: usize = 128;

/// A store of sketches.
///
/// Keyed by the address of the shared shape. The store references the shape, so that its address is not
/// reused, and a referenced shape is immutable.
#[derive(Clone, Default)]
pub(super) struct Outlines {
    detail: Option<Detail>,
    kept: HashMap<usize, (SharedShape, Outline)>,
    fresh: Outline,
}

impl Outlines {
    /// The sketch of a shape.
    pub(super) fn of(&mut self, shape: &SharedShape, detail: Detail) -> &Outline {
        if self.detail != Some(detail) {
            self.kept.clear();
            self.detail = Some(detail);
        }
        let address = Arc::as_ptr(&shape.0).cast::<()>() as usize;
        if !self.kept.contains_key(&address) {
            self.fresh = outline(&**shape, detail);
            if self.fresh.points.len() >= STORED_POINTS_MIN {
                let sketch = core::mem::take(&mut self.fresh);
                self.kept.insert(address, (shape.clone(), sketch));
            }
        }
        self.kept.get(&address).map_or(&self.fresh, |(_, sketch)| sketch)
    }

    #[cfg(test)]
    pub(super) fn len(&self) -> usize {
        self.kept.len()
    }

    /// Removes the outlines of shapes without another owner.
    pub(super) fn drop_unused(&mut self) {
        self.kept.retain(|_, (shape, _)| Arc::strong_count(&shape.0) > 1);
    }
}
