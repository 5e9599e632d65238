//! Gears, racks and pulleys from the arguments of `add_joint`.

use super::numbers::{coordinates, finite, non_negative, vector};
use super::options::Options;
use super::rapier::dynamics::{GenericJoint, JointAxis, PulleyJoint};
use super::rapier::math::{Real, Vector};
use super::space;
use crate::errors::invalid;
use pyo3::prelude::*;

/// The axes of a transmission, each in the frame of its body.
pub type Axes = [Option<Vector>; 2];

/// The number, if the engine accepts it as the factor of a coordinate.
fn factor(name: &str, value: f64) -> PyResult<Real> {
    let real = finite(name, value)?;
    match (1.0e-6..=1.0e6).contains(&real.abs()) {
        true => Ok(real),
        false => Err(invalid(format!("{name} is {value}, but must be 1e-6 to 1e6 in size"))),
    }
}

/// A number that a kind of joint cannot do without.
fn required(kind: &str, name: &str, options: &Options<'_>) -> PyResult<f64> {
    let value = options.take(name)?;
    value.ok_or_else(|| invalid(format!("a {kind} joint needs a {name}")))
}

/// The axes of a gear or a rack.
fn axes(options: &Options<'_>) -> PyResult<Axes> {
    let axis = |name| options.any(name)?.map(|axis| vector(name, &axis)).transpose();
    Ok([axis("axis1")?, axis("axis2")?])
}

/// A transmission with the axes that are given.
pub fn along_each(mut joint: GenericJoint, axes: Axes) -> PyResult<GenericJoint> {
    if let Some(axis) = axes[0] {
        joint.try_set_local_axis1(axis).map_err(invalid)?;
    }
    if let Some(axis) = axes[1] {
        joint.try_set_local_axis2(axis).map_err(invalid)?;
    }
    Ok(joint)
}

fn gear(options: &Options<'_>) -> PyResult<GenericJoint> {
    let ratio = factor("ratio", options.take("ratio")?.unwrap_or(1.0))?;
    let mut gear = space::gear(axes(options)?, ratio)?;
    let half = 0.5 * non_negative("backlash", options.take("backlash")?.unwrap_or(0.0))?;
    gear.try_set_limits(JointAxis::LinX, [-half, half]).map_err(invalid)?;
    Ok(gear)
}

fn rack(options: &Options<'_>) -> PyResult<GenericJoint> {
    let radius = factor("radius", required("rack", "radius", options)?)?;
    space::rack(axes(options)?, radius)
}

fn pulley(options: &Options<'_>) -> PyResult<GenericJoint> {
    let point = |name| {
        let point = options.any(name)?;
        let point = point.ok_or_else(|| invalid(format!("a pulley joint needs {name}")))?;
        coordinates(name, &point)
    };
    let over = [point("over1")?, point("over2")?];
    let length = non_negative("length", required("pulley", "length", options)?)?;
    let ratio: f64 = options.take("ratio")?.unwrap_or(1.0);
    non_negative("ratio", ratio)?;
    let ratio = factor("ratio", ratio)?;
    Ok(PulleyJoint::new(over, length, ratio).into())
}

/// A joint of the arguments of `add_joint`; `None` of other kinds.
pub fn describe(kind: &str, options: &Options<'_>) -> PyResult<Option<GenericJoint>> {
    match kind {
        "gear" => gear(options).map(Some),
        "rack" => rack(options).map(Some),
        "pulley" => pulley(options).map(Some),
        _ => Ok(None),
    }
}
