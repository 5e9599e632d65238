//! The empty counterpart of vehicles in 2D.

use super::super::rapier::pipeline::PhysicsWorld;
use drawing::Drawing;
use pyo3::prelude::*;

/// The vehicles of a world: none in 2D.
#[derive(Clone, Default)]
pub struct Vehicles(());

impl Vehicles {
    /// Changes nothing.
    pub fn update(&mut self, _world: &mut PhysicsWorld) {}

    /// No bytes.
    pub fn to_bytes(&self) -> Result<Vec<u8>, String> {
        Ok(Vec::new())
    }

    /// No vehicles.
    pub fn from_bytes(_bytes: &[u8]) -> PyResult<Self> {
        Ok(Self(()))
    }

    /// No wheels.
    pub fn wheel_counts(&self) -> Vec<Option<usize>> {
        Vec::new()
    }

    /// Adds nothing.
    pub fn draw(&self, _world: &PhysicsWorld, _drawing: &mut Drawing) {}
}

/// Adds no class.
pub fn fill(_module: &Bound<'_, PyModule>) -> PyResult<()> {
    Ok(())
}
