//! Dimension-specific contact generation of the common shapes.

mod axes;
mod capsule_triangle;
mod cells;
mod clip;
mod cuboid;
mod edges;
mod features;
mod flat;
mod hull_nearest;
mod polytope;
mod reduce;
mod revolved;
mod rims;
#[cfg(test)]
pub mod samples;

pub use axes::{FlatAxes, TriangleCulling, best_axis};
pub use capsule_triangle::capsule_triangle;
pub use cells::{
    all_cells, box_of_cells, cell_count, for_each_cell, for_each_free_cell, for_each_of_cell,
    has_free_cells, with_cell,
};
pub use clip::{FaceContact, clip_faces};
pub use cuboid::cuboid_cuboid;
pub use edges::edge_normal;
pub use features::box_feature;
pub use flat::{
    Flat, FlatBlock, FlatShape, as_flat, as_flat_mesh, flat_corners, flat_lane, flat_of,
    has_inside, set_flat_lane,
};
pub use hull_nearest::nearest_on_hull;
pub use polytope::{Face, Polytope};
pub use reduce::reduce;
pub use revolved::feature_contacts;
pub use rims::Rims;

/// Points and normal as the contact generators deliver them, in the frames of the two convex parts.
pub type RawManifold = parry::query::ContactManifold<(), ()>;
/// A point of a [`RawManifold`].
pub type RawPoint = parry::query::TrackedContact<()>;
