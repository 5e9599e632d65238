//! Code common to the 2D and the 3D scenes. Both crates compile these files, each against its own engine,
//! which their roots import under the name `rapier`.

mod dice;
mod jansen;
mod kit;
pub mod plays;
pub mod stands;
mod strider;
mod walker;

#[cfg(test)]
mod framing;
#[cfg(test)]
mod tests;

pub use crate::scene::{Controls, Law, Scene, SceneInfo};
pub use dice::Dice;
pub(crate) use kit::{add, add_fixed};
pub use strider::{Strider, turns};
pub use walker::Walker;
