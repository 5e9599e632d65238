//! Islands: bodies that touch, directly or through others, and so sleep and wake as one.

mod awake;
mod groups;
mod link;
mod manager;
mod motion;

pub(crate) use groups::BodyGroups;
pub(crate) use link::{BodyLink, NONE};
pub use manager::IslandManager;
pub(crate) use motion::{BodyMotion, rotation_bound};
