//! Contacts: pairs of nearby colliders, and their contact points.

mod input;
mod lanes;
mod manifold;
mod narrow_phase;
mod triangle_cache;
mod turning;
mod pair;
mod anchor_frame;
mod report;
mod store;

pub(crate) use anchor_frame::{AnchorFrame, MotionSince, WidePoint};
pub(crate) use input::ContactInput;
pub(crate) use lanes::{ContactLanes, LaneBlock, LaneCapacity, reserve_blocks};
pub use manifold::{Contact, ContactManifold, ContactManifoldData, ContactPoints, SolverFlags};
pub use narrow_phase::NarrowPhase;
pub use pair::{ContactPair, IntersectionPair};
pub(crate) use report::{ContactReport, WideReport};
pub(crate) use store::{Pair, PairId, PairState, PairStore, SLACK_DUE, StoreParts};
pub(crate) use triangle_cache::TriangleCache;
pub(crate) use turning::Turning;
