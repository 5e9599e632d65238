//! Friction at each point: in 2D it needs no rows of its own.
//!
//! All points of a manifold lie on one line and slide along it. One tangential row with the limit `μ` times
//! the sum of the normal impulses is therefore the exact cone.

use crate::base::wide::{Lane, Wide};
use crate::dim2::math::MAX_MANIFOLD_POINTS;

/// Empty in 2D. In 3D: the rows of each point.
#[derive(Clone, Debug)]
pub(crate) struct CoulombBlock;

impl CoulombBlock {
    /// Empty in 2D.
    pub const EMPTY: Self = Self;

    /// No operation in 2D.
    pub fn scale_impulses(&mut self, _factors: &Lane) {}

    /// No impulses: the manifold has one as a whole. (Points of links have some, whatever the dimension.)
    pub fn store_impulses<W: Wide>(
        &self,
        impulses: &mut [[Lane; 1]; MAX_MANIFOLD_POINTS],
        _withheld: W,
    ) {
        *impulses = Default::default();
    }
}
