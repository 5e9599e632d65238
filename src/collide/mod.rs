//! # Collide: contact manifolds of two shapes
//!
//! Contact manifolds of any two shapes, from their poses and from the manifolds of a moment ago. Its code is
//! independent of bodies and of time: the narrow phase, queries and controllers use it.
//!
//! [`manifolds`] splits shapes into convex [`parts`], finds the contacts with [`internal_edges`] between
//! these, and merges the remaining [`patches`]. [`convex`] selects the algorithm for two parts: [`ball`],
//! [`capsule`], [`polytopes`] (boxes, hulls, triangles, and their rounded forms), or [`support`] for all
//! others. Dimension-specific code is in [`crate::dim::collide`]. [`matching`] hands impulses on from step to
//! step.

mod ball;
mod capsule;
mod convex;
mod culling;
mod coplanar;
mod support_feature;
mod form;
mod manifolds;
mod matching;
mod neighbor;
mod part_pairs;
mod parts;
mod patches;
mod polytopes;
mod search;
mod internal_edges;
mod flat_parts;
mod support;
mod sweep;
#[cfg(test)]
mod tests;
mod voxels;

pub(crate) use form::form_of;
pub(crate) use internal_edges::SAME_NORMAL;
pub(crate) use manifolds::{
    ManifoldScratch, ShapePair, compute_manifolds, renew_convex_manifold, shapes_intersect,
};
pub(crate) use matching::inherit_impulses;
pub(crate) use neighbor::{Neighbor, ghost_contacts_among};
pub(crate) use sweep::{
    Overlap, PENETRATION_FRACTION_MAX, PathSegment, Solid, Sweep, SweepGoal, Touch, ends_deep,
    find_touches, first_impact, passes, turned,
};
