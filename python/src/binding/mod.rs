//! The classes of a module, one source for all four engines.

use super::rapier;
use super::scene;
use super::space;

pub mod batch;
pub mod body;
mod character;
mod collider;
mod events;
pub mod garbage;
mod hooks;
mod identity;
pub mod joint;
mod motors;
pub mod numbers;
pub mod options;
mod picture;
mod query;
mod shape;
mod simulation;
pub mod transmission;
pub mod world;

use pyo3::prelude::*;

/// Fills a module with the classes of its engine.
pub fn fill(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("DIM", rapier::math::DIM)?;
    module.add("STATE", numbers::STATE)?;
    module.add("dtype", numbers::dtype(module.py())?)?;
    module.add_class::<world::World>()?;
    module.add_class::<body::Body>()?;
    module.add_class::<collider::Collider>()?;
    module.add_class::<shape::Shape>()?;
    module.add_class::<joint::Joint>()?;
    module.add_class::<query::RayHit>()?;
    module.add_class::<query::PointProjection>()?;
    module.add_class::<events::CollisionEvent>()?;
    module.add_class::<batch::WorldBatch>()?;
    module.add_class::<character::CharacterController>()?;
    module.add_class::<character::CharacterMovement>()?;
    module.add_class::<hooks::Pair>()?;
    module.add_class::<hooks::Contact>()?;
    space::fill(module)
}
