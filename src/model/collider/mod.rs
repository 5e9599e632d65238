//! # Colliders
//!
//! A [`Collider`] is a shape in the world; a [`ColliderSet`] owns them. Shapes come from parry.
//! [`ColliderBuilder`] and the setters refuse everything that cannot be simulated (a negative radius, an
//! empty mesh, a coordinate that is not finite). The step therefore checks only shapes after `shape_mut`, and
//! boxes against the limits of the trees. Setters record each change, so that the next step processes changed
//! colliders alone.

mod interact;
mod journal;
mod accept;
mod active;
mod builder;
pub(crate) mod check;
mod decomposition;
mod error;
mod extent;
mod form;
mod grid;
mod groups;
mod handle;
mod mass;
mod material;
mod mesh_converter;
mod parts;
mod record;
#[cfg(feature = "serde-serialize")]
mod saved;
mod set;
mod setters;
#[cfg(feature = "serde-serialize")]
mod shape_table;
mod shapes;
mod spread;
mod widths;

pub use active::{ActiveCollisionTypes, ActiveEvents, ActiveHooks};
pub use builder::ColliderBuilder;
pub use error::InvalidCollider;
pub(crate) use form::ShapeForm;
pub use groups::{Group, InteractionGroups, InteractionTestMode};
pub use handle::ColliderHandle;
pub(crate) use interact::may_interact;
pub(crate) use journal::Bookmark;
pub use mass::ColliderMassProps;
pub use material::{CoefficientCombineRule, ColliderMaterial};
pub use mesh_converter::MeshConverter;
pub use parts::{ColliderChanges, ColliderEnabled, ColliderFlags, ColliderParent};
pub use record::Collider;
pub use set::ColliderSet;
pub(crate) use spread::MassSpread;
pub(crate) use widths::{Widths, thickness};

#[cfg(test)]
mod tests;
