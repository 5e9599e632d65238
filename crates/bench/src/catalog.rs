//! Entries of the benchmark's catalogue.

use crate::engine::{Kind, Template};

/// A scene of the benchmark.
pub struct Scene {
    /// Name in the gallery.
    pub name: &'static str,
    /// `2d` or `3d`.
    pub dimension: &'static str,
    /// Number of steps.
    pub steps: usize,
    /// Whether the scene runs when the command line names no scene.
    pub by_default: bool,
    /// Builds the scene with this engine.
    pub build: Box<dyn Fn() -> Box<dyn Template> + Send + Sync>,
}

impl Scene {
    /// Returns dimension and name: `3d/large_pyramid`.
    pub fn title(&self) -> String {
        format!("{}/{}", self.dimension, self.name)
    }

    /// Returns the engine's name in this dimension.
    pub fn engine_name(&self, kind: Kind) -> &'static str {
        engine_name(kind, self.dimension)
    }
}

/// Returns the engine's name in this dimension.
pub fn engine_name(kind: Kind, dimension: &str) -> &'static str {
    match kind {
        Kind::This => "this engine",
        Kind::Rapier => "Rapier 0.36.1",
        Kind::Box if dimension == "2d" => "Box2D",
        Kind::Box => "Box3D",
        Kind::Double => "this engine, f64",
    }
}
