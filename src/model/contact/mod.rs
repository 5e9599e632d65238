//! Contacts: pairs of colliders that are close, and where exactly they touch.

mod manifold;
mod pair;

pub use manifold::{Contact, ContactManifold, ContactManifoldData, ContactPoints, SolverFlags};
pub use pair::{ContactPair, IntersectionPair};
