//! # Query — asks the world
//!
//! Ray casts, point projections, shape casts and overlap tests. [`QueryView`] answers out of trees of boxes
//! that somebody else keeps: the broad phase
//! ([`as_query_pipeline`](crate::model::tree::BroadPhaseBvh::as_query_pipeline), as of the last step), or a
//! [`QueryPipeline`] (as of its last `update`, without a step).
//!
//! Two rules hold for all questions. *The nearest answer is the one that a look at every collider would
//! give*, to the last bit: trees only spare us those that cannot matter, and of colliders that are equally near the
//! one with the lower slot is meant, whatever the shape of the tree. *A question that makes no sense has no answer*: a ray or a
//! pose that is not finite, a direction of no length, a time that is not a number.

mod filter;
mod hits;
mod nearest;
mod owned;
mod points;
mod rays;
mod shapes;
mod view;

pub use filter::{QueryFilter, QueryFilterFlags, QueryPredicate};
pub use owned::QueryPipeline;
pub use view::QueryView;
