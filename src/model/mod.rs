//! # Model: data types of the world
//!
//! Plain data, sets and handles, the operations that keep their lists consistent (`structure/`), and the
//! traits that a user implements. No stage lives here: stages of [`crate::step`] act on these types and never
//! on each other.

pub mod body;
pub(crate) mod check;
pub mod collider;
pub(crate) mod constraint_graph;
pub mod contact;
pub mod counters;
pub(crate) mod edit_mark;
pub mod event;
pub(crate) mod frozen;
pub mod hooks;
pub mod island;
pub mod joint;
pub mod multibody;
pub mod params;
pub(crate) mod stamp;
pub(crate) mod state_hash;
pub(crate) mod structure;
pub mod tree;
#[cfg(feature = "upstream-036")]
pub mod upstream036;
