//! Everything that most programs need: `use rapier3d::prelude::*;`.

// Whole modules: the prelude has no names of its own to decide on.
pub use super::control::*;
pub use super::dynamics::*;
pub use super::geometry::*;
pub use super::math::*;
pub use super::pipeline::*;
pub use crate::{point, vector};
