//! Contacts: pairs of colliders that are close, and where exactly they touch.

mod manifold;
mod narrow_phase;
mod nearby;
mod pair;
mod placement;
mod store;

pub use manifold::{Contact, ContactManifold, ContactManifoldData, ContactPoints, SolverFlags};
pub use narrow_phase::NarrowPhase;
pub(crate) use nearby::Nearby;
pub use pair::{ContactPair, IntersectionPair};
pub(crate) use placement::{MotionSince, Placement, WidePlacement};
pub(crate) use store::{DUE, Pair, PairId, PairState, PairStore, StoreParts};
