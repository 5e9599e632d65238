//! Feedback controllers of a body's pose by its velocity: proportional, derivative and integral.
//!
//! Both controllers return a *change of velocity* that the user adds before the next step. With `e` the error
//! of the pose (target minus body) and `v` that of the velocity, a step of length `dt` does
//!
//! ```text
//! v' = (1 - kd) v - kp e        e' = e + v' dt
//! ```
//!
//! so `kp` is in 1/s and `kd` has no unit. The matrix of this recurrence has the trace `2 - kp dt - kd` and
//! the determinant `1 - kd`. Both eigenvalues are equal, and the body reaches the target as fast as possible
//! without swinging, if the squared trace is four times the determinant:
//!
//! ```text
//! kp dt = (1 - √(1 - kd))²
//! ```
//!
//! With `kd = 1` and `kp = 1 / dt` both eigenvalues are zero: the body reaches the target in one step. They
//! are inside the unit circle while `0 < kd < 2` and `0 < kp dt < 2 (2 - kd)`.

mod pd;
#[expect(clippy::module_inception, reason = "one file for each of the two controllers")]
mod pid;

pub use pd::{PdController, PdErrors};
pub use pid::PidController;
