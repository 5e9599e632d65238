//! The way between this engine's numbers and those of an engine that has the same: there is none to go.

use super::ours::parry::mass_properties::MassProperties;
use super::ours::prelude::*;
use crate::engine::Unsupported;

/// A number.
pub fn real(number: f32) -> f32 {
    number
}

/// A vector.
pub fn vector(v: Vector) -> Vector {
    v
}

/// An angular velocity.
pub fn angular(velocity: AngVector) -> AngVector {
    velocity
}

/// A pose.
pub fn pose(pose: &Pose) -> Pose {
    *pose
}

/// A pose of this engine's, from one of the other's.
pub fn pose_back(pose: &Pose) -> Pose {
    *pose
}

/// The mass of a collider.
pub fn mass(mass: MassProperties) -> MassProperties {
    mass
}

/// Hands over shapes: both engines can use one and the same.
pub struct Shapes;

impl Shapes {
    /// For one world.
    pub fn new() -> Self {
        Self
    }

    /// The shape of a collider.
    pub fn shape(&mut self, shape: &SharedShape) -> Result<SharedShape, Unsupported> {
        Ok(shape.clone())
    }
}
