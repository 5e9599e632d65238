//! The names that only two dimensions have, or that are made differently there.

#[cfg(not(feature = "parry026"))]
pub use parry::shape::CompoundEdgeCone;
pub use parry::shape::{ConvexPolygon, RoundConvexPolygon};
