//! Everything that most programs need: `use rapier3d::prelude::*;`.

// Globs: the prelude re-exports whole modules.
pub use super::control::*;
pub use super::dynamics::*;
pub use super::geometry::*;
pub use super::math::*;
pub use super::pipeline::*;
pub use crate::{point, vector};
