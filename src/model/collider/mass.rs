//! The mass of a collider: from a density, a mass, or given mass properties.

use super::grid::filled_cells;
use super::spread::MassSpread;
use crate::base::measure::is_margin;
use crate::dim::mass::{mass_is_valid, no_mass, total_mass};
use crate::dim::math::Real;
use crate::dim::shapes;
use parry::mass_properties::MassProperties;
use parry::math::IVector;
use parry::shape::{Shape, TypedShape, Voxels};

/// The source of a collider's mass.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum ColliderMassProps {
    /// Mass per volume (in 2D: per area); mass and angular inertia follow from the shape.
    Density(Real),
    /// The mass, spread evenly over the shape.
    Mass(Real),
    /// Mass, centre of mass and angular inertia, independent of the shape.
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
    /// Returns whether the setters accept the numbers.
    pub(crate) fn is_valid(&self) -> bool {
        match self {
            Self::Density(number) | Self::Mass(number) => is_margin(*number),
            Self::MassProperties(properties) => mass_is_valid(properties),
        }
    }

    /// Mass, centre of mass and angular inertia in the frame of the shape.
    ///
    /// A density gives no mass to shapes without volume: segments, polylines, height fields, flat hulls,
    /// half-spaces, and triangles in 3D. (It gives mass to a body that has no other colliders.) A mass is
    /// distributed evenly over their surface or length. Half-spaces have neither, and no angular inertia.
    pub fn mass_properties(&self, shape: &dyn Shape) -> MassProperties {
        match self {
            Self::Density(density) if *density == 0.0 => no_mass(),
            Self::Density(density) => volume_properties(shape, *density),
            Self::Mass(mass) if *mass == 0.0 => no_mass(),
            Self::Mass(mass) => finite_or_zero(match MassSpread::over(shape) {
                Some(spread) => spread.scaled_to(*mass),
                None => MassProperties { inv_mass: 1.0 / mass, ..no_mass() },
            }),
            Self::MassProperties(properties) => **properties,
        }
    }
}

/// Mass properties of the volume of a shape; zero mass if it has no volume.
pub(super) fn volume_properties(shape: &dyn Shape, density: Real) -> MassProperties {
    let typed = shape.as_typed_shape();
    if let TypedShape::Compound(compound) = typed {
        let parts = compound.shapes().iter();
        let parts: Vec<_> = parts
            .map(|(pose, part)| volume_properties(&**part, density).transform_by(pose))
            .collect();
        return finite_or_zero(total_mass(&parts));
    }
    if let TypedShape::Voxels(voxels) = typed {
        return finite_or_zero(of_voxels(voxels, density));
    }
    let ours = shapes::mass_properties(typed, density);
    finite_or_zero(ours.unwrap_or_else(|| shape.mass_properties(density)))
}

fn of_voxels(voxels: &Voxels, density: Real) -> MassProperties {
    let cell = MassProperties::from_cuboid(density, voxels.voxel_size() * 0.5);
    // The sum must not depend on the order of the voxels' tree, which edits change.
    let mut cells = filled_cells(voxels);
    cells.sort_unstable_by_key(IVector::to_array);
    let cells: Vec<_> = cells
        .into_iter()
        .map(|at| MassProperties { local_com: voxels.voxel_center(at), ..cell })
        .collect();
    total_mass(&cells)
}

/// Replaces mass properties beyond the range of numbers, as of extremely large or small shapes, by zero.
fn finite_or_zero(properties: MassProperties) -> MassProperties {
    if mass_is_valid(&properties) {
        return properties;
    }
    log::warn!(
        "the mass properties {properties:?} of a collider exceed the number type: the collider has no mass"
    );
    no_mass()
}
