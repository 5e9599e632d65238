//! Controllers that move bodies by queries: characters and feedback controllers.

pub use crate::controllers::character::{
    CharacterAutostep, CharacterCollision, CharacterContacts, CharacterGround, CharacterHooks,
    CharacterLength, CharacterSlopeSpeed, EffectiveCharacterMovement, KinematicCharacterController,
};
pub use crate::controllers::pid::{PdController, PdErrors, PidController};
pub use crate::dim::mask::AxesMask;
// A glob, because only one of the two dimensions has vehicles.
#[allow(unused_imports, reason = "the other one has none")]
pub use crate::dim::vehicle::*;
