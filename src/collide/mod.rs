//! # Where do two shapes touch?
//!
//! Contact manifolds of any two shapes, from their poses and from the manifolds of a moment ago.
//! Nothing here knows of bodies or of time: the narrow phase asks for the pairs of the world, queries
//! and controllers for whatever they like.
//!
//! [`manifolds`] takes shapes apart into convex [`parts`], finds out which contacts are only [`internal_edges`]
//! between these, and puts the [`patches`] that are left together; [`convex`] chooses the way for two
//! parts: [`ball`], [`capsule`], [`polytopes`] (boxes, hulls, triangles, and
//! what is round about them), or [`support`] for all others. What differs by dimension is in
//! [`crate::dim::collide`]. [`matching`] hands impulses on from step to step.

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
pub(crate) use neighbor::{Neighbor, internal_edges_among};
pub(crate) use sweep::{
    Overlap, PENETRATION_FRACTION_MAX, Segment, Solid, Sweep, SweepGoal, Touch, ends_deep,
    find_touches, first_impact, passes, turned,
};
