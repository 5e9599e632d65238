//! Contacts: pairs of colliders that are close, and where exactly they touch.

mod input;
mod lanes;
mod manifold;
mod narrow_phase;
mod nearby;
mod pair;
mod placement;
mod report;
mod store;

pub(crate) use input::ContactInput;
pub(crate) use lanes::{ContactLanes, LaneBlock, Rooms, reserve_blocks};
pub use manifold::{Contact, ContactManifold, ContactManifoldData, ContactPoints, SolverFlags};
pub use narrow_phase::NarrowPhase;
pub(crate) use nearby::Nearby;
pub use pair::{ContactPair, IntersectionPair};
pub(crate) use placement::{MotionSince, Placement};
pub(crate) use report::{ContactReport, WideReport};
pub(crate) use store::{DUE, Pair, PairId, PairState, PairStore, StoreParts};
