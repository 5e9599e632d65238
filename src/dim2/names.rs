//! The names that only two dimensions have, or that are made differently there.

pub use parry::shape::{CompoundEdgeCone, ConvexPolygon, RoundConvexPolygon};
