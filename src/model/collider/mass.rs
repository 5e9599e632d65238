//! Where a collider's mass comes from.

use crate::dim::mass::{mass_is_valid, no_mass};
use crate::dim::math::Real;
use parry::mass_properties::MassProperties;
use parry::shape::Shape;

/// Where a collider's mass comes from.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum ColliderMassProps {
    /// Mass per volume (in 2D: per area); mass and angular inertia follow from the shape.
    Density(Real),
    /// The mass, spread evenly over the shape.
    Mass(Real),
    /// Mass, centre of mass and angular inertia, whatever the shape.
    MassProperties(Box<MassProperties>),
}

impl Default for ColliderMassProps {
    /// Density 1.
    fn default() -> Self {
        Self::Density(1.0)
    }
}

impl From<MassProperties> for ColliderMassProps {
    fn from(properties: MassProperties) -> Self {
        Self::MassProperties(Box::new(properties))
    }
}

impl ColliderMassProps {
    /// Mass, centre of mass and angular inertia in the frame of the shape.
    ///
    /// Shapes without a volume (segments, polylines, open height fields, half-spaces) have no mass from
    /// a density, and no angular inertia from a mass.
    pub fn mass_properties(&self, shape: &dyn Shape) -> MassProperties {
        match self {
            Self::Density(density) if *density == 0.0 => no_mass(),
            Self::Density(density) => finite_or_zero(shape.mass_properties(*density)),
            Self::Mass(mass) if *mass == 0.0 => no_mass(),
            Self::Mass(mass) => {
                let mut properties = finite_or_zero(shape.mass_properties(1.0));
                properties.set_mass(*mass, true);
                finite_or_zero(properties)
            }
            Self::MassProperties(properties) => **properties,
        }
    }
}

/// A shape so large or small that its mass leaves the range of numbers has none that could be used.
fn finite_or_zero(properties: MassProperties) -> MassProperties {
    if mass_is_valid(&properties) {
        return properties;
    }
    log::warn!("a collider's mass properties {properties:?} are not usable: it counts as massless");
    no_mass()
}
