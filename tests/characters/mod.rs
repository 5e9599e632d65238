//! Characters: walking, standing, climbing and pushing.
//!
//! Each test states a user's complaint about character controllers, as a figure with the reason for its
//! tolerance. `table` prints the figures together
//! (`cargo test -p rapier3d --test suite characters::table -- --nocapture`).

mod descents;
mod feedback;
mod floors;
mod hooks;
mod nonsense;
mod platforms;
mod pushing;
mod slopes;
pub mod stage;
mod stairs;
mod standing;
mod table;
mod walls;
