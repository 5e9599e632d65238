//! Conversions between this engine's numbers and those of an engine with the same types: identities.

use super::ours::parry::mass_properties::MassProperties;
use super::ours::prelude::*;
use crate::engine::Unsupported;

/// Converts a number.
pub fn real(number: f32) -> f32 {
    number
}

/// Converts a vector.
pub fn vector(v: Vector) -> Vector {
    v
}

/// Converts an angular velocity.
pub fn angular(velocity: AngVector) -> AngVector {
    velocity
}

/// Converts a pose.
pub fn pose(pose: &Pose) -> Pose {
    *pose
}

/// Converts a pose of the other engine to one of this engine.
pub fn pose_back(pose: &Pose) -> Pose {
    *pose
}

/// Converts mass properties.
pub fn mass(mass: MassProperties) -> MassProperties {
    mass
}

/// Conversion of shapes: both engines share one shape.
pub struct Shapes;

impl Shapes {
    /// Creates the conversion for one world.
    pub fn new() -> Self {
        Self
    }

    /// Returns the shape of a collider.
    pub fn shape(&mut self, shape: &SharedShape) -> Result<SharedShape, Unsupported> {
        Ok(shape.clone())
    }
}
