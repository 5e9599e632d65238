//! # Query: ray casts, shape casts, projections and overlap tests
//!
//! Ray casts, point projections, shape casts and overlap tests. [`QueryView`] borrows the trees of boxes of
//! their owner. The owner is the broad phase
//! ([`as_query_pipeline`](crate::model::tree::BroadPhaseBvh::as_query_pipeline), as of the last step), or a
//! [`QueryPipeline`] (as of its last `update`, without a step).
//!
//! Two rules hold for all queries. *The nearest result is that of a search of all colliders*, to the last
//! bit. Trees only exclude irrelevant ones, and of equally near colliders the one with the lower slot is
//! returned, independent of the tree. *An invalid query has no result*. A query is invalid if its ray or pose
//! is not finite, or its limit is negative or NaN.

mod filter;
mod nearest;
mod owned;
mod points;
mod rays;
mod shapes;
#[cfg(test)]
mod tests;
mod view;

pub use filter::{QueryFilter, QueryFilterFlags, QueryPredicate};
pub use owned::QueryPipeline;
pub use rays::cast_ray_on_shape;
pub use view::QueryView;
