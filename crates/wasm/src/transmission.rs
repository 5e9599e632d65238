//! Gears, racks and pulleys: their descriptions, kinds and parameters.

use crate::fault::{Fault, non_negative};
use crate::joint::{IMPULSE, change, data, kind};
use crate::memory::{self, number, put_vector, vector};
use crate::rapier::dynamics::{
    GearJoint, GenericJoint, JointAxis, PulleyJoint, RackJoint, Transmission, TransmissionEnd,
};
use crate::rapier::math::Real;

/// The number, if the engine accepts it as the factor of a coordinate.
fn factor(name: &str, value: Real) -> Result<Real, Fault> {
    match (1.0e-6..=1.0e6).contains(&value.abs()) {
        true => Ok(value),
        false => Err(Fault::number(name, value.into(), "1e-6 to 1e6 in size")),
    }
}

/// The same for a rope, which does not push.
fn positive_factor(name: &str, value: Real) -> Result<Real, Fault> {
    match value > 0.0 {
        true => factor(name, value),
        false => Err(Fault::number(name, value.into(), "1e-6 to 1e6")),
    }
}

/// Gears. In 3D their axes are in places 2 and 3.
fn gear(ratio: Real) -> Result<GenericJoint, Fault> {
    let ratio = factor("ratio", ratio)?;
    #[cfg(feature = "dim2")]
    let gear = GearJoint::new(ratio);
    #[cfg(not(feature = "dim2"))]
    let gear =
        GearJoint::new(memory::direction(2, "axis1")?, memory::direction(3, "axis2")?, ratio);
    Ok(gear.data)
}

/// A pinion and a rack. The axis of the rack is in place 3, and in 3D that of the pinion in place 2.
fn rack(radius: Real) -> Result<GenericJoint, Fault> {
    let radius = factor("radius", radius)?;
    #[cfg(feature = "dim2")]
    let rack = RackJoint::new(memory::direction(3, "axis")?, radius);
    #[cfg(not(feature = "dim2"))]
    let rack =
        RackJoint::new(memory::direction(2, "axis1")?, memory::direction(3, "axis2")?, radius);
    Ok(rack.data)
}

/// A rope over two points of the world, which are in places 6 and 7.
fn pulley(length: Real, ratio: Real) -> Result<GenericJoint, Fault> {
    let over = [vector(6, "over1")?, vector(7, "over2")?];
    let (length, ratio) = (non_negative("length", length)?, positive_factor("ratio", ratio)?);
    Ok(PulleyJoint::new(over, length, ratio).data)
}

/// A transmission from the scratch block, without its anchors. `None` of other kinds.
pub fn description(kind_number: u32, length: Real) -> Result<Option<GenericJoint>, Fault> {
    let (ratio, radius) = (number(4, 3), number(5, 2));
    match kind_number {
        kind::GEAR => gear(ratio).map(Some),
        kind::RACK => rack(radius).map(Some),
        kind::PULLEY => pulley(length, ratio).map(Some),
        _ => Ok(None),
    }
}

/// The kind of a transmission. Rust can combine other ends and factors, which have no kind of their own.
pub fn kind_of(transmission: &Transmission) -> u32 {
    use TransmissionEnd::{Angle, Distance, Shift};
    match (transmission.ends, transmission.ratios) {
        ([Angle, Angle], [1.0, _]) => kind::GEAR,
        ([Angle, Shift], [_, -1.0]) => kind::RACK,
        ([Distance { .. }, Distance { .. }], [1.0, _]) => kind::PULLEY,
        _ => kind::GENERIC,
    }
}

/// The joint's transmission, for methods of the classes that have one.
fn transmission(joint: &GenericJoint) -> Result<&Transmission, Fault> {
    joint.transmission().ok_or_else(|| Fault::invalid("the joint is no gear, rack or pulley"))
}

/// Changes the transmission of an impulse joint.
fn change_transmission(
    world: u32,
    handle: f64,
    edit: impl FnOnce(&mut Transmission) -> Result<(), Fault>,
) -> Result<(), Fault> {
    change(world, IMPULSE, handle, |joint| {
        let mut changed = *transmission(joint)?;
        edit(&mut changed)?;
        joint.try_set_transmission(changed).map_err(Fault::invalid)
    })
}

/// Sets the range of the sum of both coordinates.
fn set_range(world: u32, handle: f64, range: [Real; 2]) -> Result<(), Fault> {
    change(world, IMPULSE, handle, |joint| {
        transmission(joint)?;
        joint.try_set_limits(JointAxis::LinX, range).map_err(Fault::invalid)
    })
}

/// The range of the sum of both coordinates.
fn range(world: u32, handle: f64) -> Result<[Real; 2], Fault> {
    let limits = data(world, IMPULSE, handle)?.limits(JointAxis::LinX);
    Ok(limits.map_or([-Real::MAX, Real::MAX], |limits| [limits.min, limits.max]))
}

exports! {
    /// The ratio of a gear or a pulley.
    fn joint_ratio(world: u32, handle: f64) -> f64 {
        transmission(data(world, IMPULSE, handle)?)?.ratios[1].into()
    }

    /// Sets the ratio of a gear or a pulley.
    fn joint_set_ratio(world: u32, handle: f64, ratio: f64) {
        change_transmission(world, handle, |transmission| {
            let is_rope = matches!(transmission.ends[1], TransmissionEnd::Distance { .. });
            let check = if is_rope { positive_factor } else { factor };
            transmission.ratios[1] = check("ratio", ratio as Real)?;
            Ok(())
        })?;
    }

    /// The radius of a pinion.
    fn joint_radius(world: u32, handle: f64) -> f64 {
        transmission(data(world, IMPULSE, handle)?)?.ratios[0].into()
    }

    /// Sets the radius of a pinion.
    fn joint_set_radius(world: u32, handle: f64, radius: f64) {
        let radius = factor("radius", radius as Real)?;
        change_transmission(world, handle, |transmission| {
            transmission.ratios[0] = radius;
            Ok(())
        })?;
    }

    /// The backlash of a gear.
    fn joint_backlash(world: u32, handle: f64) -> f64 {
        let [min, max] = range(world, handle)?;
        (max - min).into()
    }

    /// Sets the backlash of a gear.
    fn joint_set_backlash(world: u32, handle: f64, angle: f64) {
        let half = 0.5 * non_negative("angle", angle)? as Real;
        set_range(world, handle, [-half, half])?;
    }

    /// The length of the rope of a pulley.
    fn joint_length(world: u32, handle: f64) -> f64 {
        range(world, handle)?[1].into()
    }

    /// Sets the length of the rope of a pulley.
    fn joint_set_length(world: u32, handle: f64, length: f64) {
        let length = non_negative("length", length)? as Real;
        set_range(world, handle, [-Real::MAX, length])?;
    }

    /// Writes the first (0) or second (1) point over which the rope of a pulley runs.
    fn joint_over(world: u32, handle: f64, side: usize) {
        let ends = transmission(data(world, IMPULSE, handle)?)?.ends;
        if let TransmissionEnd::Distance { from } = ends[side & 1] {
            put_vector(0, from);
        }
    }

    /// Sets the first (0) or second (1) point over which the rope of a pulley runs.
    fn joint_set_over(world: u32, handle: f64, side: usize) {
        let from = vector(0, "over")?;
        change_transmission(world, handle, |transmission| {
            transmission.ends[side & 1] = TransmissionEnd::Distance { from };
            Ok(())
        })?;
    }
}
