//! What moves bodies by asking the world: feedback controllers.

pub use crate::controllers::pid::{PdController, PdErrors, PidController};
pub use crate::dim::mask::AxesMask;
