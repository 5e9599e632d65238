//! Mass properties of composite bodies, in 2D.

use crate::base::measure::is_point;
use crate::dim::math::{AngVector, Real, Rotation, Vector};
use parry::mass_properties::MassProperties;

/// The mass properties of a body without mass.
pub fn no_mass() -> MassProperties {
    MassProperties { local_com: Vector::ZERO, inv_mass: 0.0, inv_principal_inertia: 0.0 }
}

/// Second moments of a mass about a point: in the plane their trace `∫ r² dm` is all that matters.
pub type SecondMoment = Real;

/// The second moment of a unit mass at `r`.
pub fn second_moment(r: Vector) -> SecondMoment {
    r.length_squared()
}

/// The sum of `moment` and a spherical distribution with `fraction` of its trace along each axis.
pub fn thickened(moment: SecondMoment, fraction: Real) -> SecondMoment {
    moment * (1.0 + 2.0 * fraction)
}

/// The moment of a distribution on a line.
pub fn narrow_moment(moment: SecondMoment) -> Real {
    moment.max(0.0)
}

/// Mass properties from a mass, its centre, and its second moments about the centre.
///
/// The inertia is their trace.
pub fn mass_from_moments(com: Vector, mass: Real, second: SecondMoment) -> MassProperties {
    MassProperties::new(com, mass, second.max(0.0))
}

/// Returns whether all values and stored inverses are finite, and none is negative where that is impossible.
pub fn mass_is_valid(mass: &MassProperties) -> bool {
    is_point(mass.local_com)
        && mass.inv_mass >= 0.0
        && mass.inv_mass.is_finite()
        && mass.mass().is_finite()
        && mass.inv_principal_inertia >= 0.0
        && mass.inv_principal_inertia.is_finite()
        && mass.principal_inertia().is_finite()
}

/// The inverse of the smallest principal moment of inertia; zero without one.
pub fn largest_inverse_moment(mass: &MassProperties) -> Real {
    mass.inv_principal_inertia
}

/// The mass properties of all parts together. All of them in one frame.
pub fn total_mass(parts: &[MassProperties]) -> MassProperties {
    if let [only] = parts {
        return *only;
    }
    let mass: Real = parts.iter().map(MassProperties::mass).sum();
    let moment: Vector = parts.iter().map(|part| part.local_com * part.mass()).sum();
    let com = if mass > 0.0 { moment / mass } else { Vector::ZERO };
    // The parallel axis theorem.
    let inertia_about_com = |part: &MassProperties| {
        part.principal_inertia() + part.mass() * (com - part.local_com).length_squared()
    };
    MassProperties::new(com, mass, parts.iter().map(inertia_about_com).sum())
}

/// The angular momentum about the centre of mass (mass·length²/s) of a body with the angular
/// velocity `angvel` (rad/s).
pub fn angular_momentum(mass: &MassProperties, _: Rotation, angvel: AngVector) -> AngVector {
    mass.principal_inertia() * angvel
}
