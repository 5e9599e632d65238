//! Islands: dynamic bodies that contacts or joints connect, directly or through other dynamic bodies. They
//! sleep and wake as one.

mod awake;
mod groups;
mod link;
mod manager;
mod motion;
mod pace;

pub(crate) use groups::{BodyGroups, GroupExclusions, GroupMember};
pub(crate) use link::{BodyLink, NONE};
pub use manager::IslandManager;
pub(crate) use motion::{BodyMotion, rotation_bound};
pub(crate) use pace::StepPace;
