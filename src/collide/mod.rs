//! # Collide: contact manifolds and times of impact of two shapes
//!
//! Contact manifolds of any two shapes, from their poses and from the manifolds of a moment ago, and times of
//! impact of two moving shapes ([`sweep`]). The room is independent of bodies and of the world. The narrow
//! phase, CCD, queries and controllers use it.
//!
//! [`manifolds`] splits shapes into convex [`parts`], [`search`]es for contacts between these, removes those
//! at [`internal_edges`], and merges the remaining [`patches`]. [`convex`] selects the algorithm for two
//! parts: [`ball`], [`capsule`], [`polytopes`] (boxes, hulls, triangles, and their rounded forms), or
//! [`support`] for all others. The last two [`cut`] large flat parts for searches. Dimension-specific code is
//! in [`crate::dim::collide`]. [`matching`] hands impulses on from step to step. The modules have no circular
//! imports.

mod ball;
mod best_part;
mod capsule;
mod convex;
mod culling;
mod cut;
mod support_feature;
mod form;
mod manifolds;
mod matching;
mod neighbor;
mod normals;
mod pair;
mod part;
mod parts;
mod patches;
mod polytopes;
mod queries;
mod search;
mod sides;
mod internal_edges;
mod support;
mod sweep;
#[cfg(test)]
mod tests;
mod voxels;

pub(crate) use form::form_of;
pub(crate) use manifolds::{ManifoldScratch, compute_manifolds, renew_convex_manifold};
pub(crate) use matching::inherit_impulses;
pub(crate) use neighbor::{Neighbor, ghost_contacts_among};
pub(crate) use normals::NORMAL_DISTANCE_SQUARED_MAX;
pub(crate) use pair::ShapePair;
pub(crate) use queries::{
    Dispatcher, intersection, nearest_point, shapes_intersect, time_of_impact,
};
pub(crate) use sweep::{
    Overlap, PENETRATION_FRACTION_MAX, PathSegment, Solid, Sweep, SweepGoal, Touch, ends_deep,
    find_touches, first_impact, passes, turned,
};
