//! Bevy's mathematics in the precision of the engine.

use bevy::math::{DVec2, DVec3, Vec2, Vec3};
pub use rapier::math::Real as Scalar;

/// Bevy's vectors in one precision. The engine's number type selects the implementation, so no code depends
/// on the feature `f64`.
pub trait Precision {
    /// The vector with two components.
    type Vec2;
    /// The vector with three components.
    type Vec3;
}

impl Precision for f32 {
    type Vec2 = Vec2;
    type Vec3 = Vec3;
}

impl Precision for f64 {
    type Vec2 = DVec2;
    type Vec3 = DVec3;
}
