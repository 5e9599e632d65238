//! The tumbling of free bodies: in 2D there is none, since there is only one axis to turn about.

use super::math::{AngVector, Real, Rotation};
use parry::mass_properties::MassProperties;

/// Never made in 2D.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Gyroscope {}

impl Gyroscope {
    /// `None`: a 2D body keeps its angular velocity.
    pub fn new(_: &MassProperties, _: AngVector, _: Real) -> Option<Self> {
        None
    }

    /// The angular velocity in the middle of a substep that begins with `angvel`.
    pub fn velocity_at_middle(&mut self, _: Rotation, angvel: AngVector, _: Real) -> AngVector {
        angvel
    }

    /// The angular velocity at the end of the substep.
    pub fn velocity_at_end(&mut self, _: Rotation, angvel: AngVector) -> AngVector {
        angvel
    }
}
