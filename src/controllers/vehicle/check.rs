//! Validation of wheels: their fields are public, so each update checks them.

use super::wheel::Wheel;
use crate::base::measure::{is_coordinate, is_length, is_margin, is_point};
use crate::dim::math::{Real, Vector};

/// The shortest vector that has a direction, and the least sine of the angle between axle and suspension,
/// whose plane must be a plane.
const LENGTH_MIN: Real = 1.0e-3;

/// The directions of a wheel in the frame of the chassis, of unit length.
#[derive(Copy, Clone, Debug)]
pub(super) struct Directions {
    pub suspension: Vector,
    pub axle: Vector,
}

/// The directions of a usable wheel; otherwise the unusable field, and its value.
pub(super) fn directions(wheel: &Wheel) -> Result<Directions, String> {
    check_numbers(wheel)?;
    let suspension = direction("direction", wheel.direction_cs)?;
    let axle = direction("axle", wheel.axle_cs)?;
    if suspension.cross(axle).length_squared() < LENGTH_MIN * LENGTH_MIN {
        return Err(format!("axle along its suspension, {:?}", wheel.axle_cs));
    }
    Ok(Directions { suspension, axle })
}

fn direction(name: &str, vector: Vector) -> Result<Vector, String> {
    let unit = if is_point(vector) { vector.try_normalize() } else { None };
    unit.ok_or_else(|| format!("{name} of {vector:?}"))
}

/// Whether a number is usable.
type Check = fn(Real) -> bool;

fn check_numbers(wheel: &Wheel) -> Result<(), String> {
    let is_fraction: Check = |value| (0.0..=1.0).contains(&value);
    let is_bound: Check = |value| value >= 0.0;
    let checks: [(&str, Real, Check); 14] = [
        ("radius", wheel.radius, is_length),
        ("suspension rest length", wheel.suspension_rest_length, is_margin),
        ("largest suspension travel", wheel.max_suspension_travel, is_bound),
        ("suspension stiffness", wheel.suspension_stiffness, is_margin),
        ("damping of compression", wheel.damping_compression, is_margin),
        ("damping of relaxation", wheel.damping_relaxation, is_margin),
        ("largest suspension force", wheel.max_suspension_force, is_bound),
        ("friction slip", wheel.friction_slip, is_margin),
        ("side friction stiffness", wheel.side_friction_stiffness, is_margin),
        ("roll influence", wheel.roll_influence, is_fraction),
        ("steering", wheel.steering, is_coordinate),
        ("engine force", wheel.engine_force, is_coordinate),
        ("brake", wheel.brake, is_bound),
        ("rotation", wheel.rotation, is_coordinate),
    ];
    for (name, value, is_usable) in checks {
        if !is_usable(value) {
            return Err(format!("{name} of {value}"));
        }
    }
    let place = wheel.chassis_connection_point_cs;
    if is_point(place) { Ok(()) } else { Err(format!("place of {place:?}")) }
}
