//! What differs in 3D: rotations are unit quaternions `(x, y, z, w)`, angular quantities are vectors.

use super::binding::numbers::{array, finite, numbers};
use super::rapier::dynamics::{GenericJoint, PrismaticJointBuilder, RevoluteJointBuilder, SphericalJointBuilder};
use super::rapier::geometry::{ColliderBuilder, SharedShape};
use super::rapier::math::{AngVector, Real, Rotation, Vector};
use crate::errors::invalid;
use super::rapier::parry::utils::Array2;
use numpy::{PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// Numbers of a rotation.
pub const ROTATION: usize = 4;
/// Numbers of an angular velocity.
pub const ANGULAR: usize = 3;

/// A vector of a Python sequence with three numbers.
pub fn vector(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Vector> {
    Ok(Vector::from_array(numbers(name, value)?))
}

/// A quaternion of a Python sequence `(x, y, z, w)`.
pub fn rotation(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Rotation> {
    let [x, y, z, w] = numbers(name, value)?;
    let quaternion = Rotation::from_xyzw(x, y, z, w);
    match quaternion.length() > 1.0e-6 {
        true => Ok(quaternion.normalize()),
        false => Err(invalid(format!("{name} is {quaternion}, but a rotation is a quaternion (x, y, z, w) of unit length"))),
    }
}

/// An angular quantity of a Python sequence with three numbers.
pub fn angular(name: &str, value: &Bound<'_, PyAny>) -> PyResult<AngVector> {
    vector(name, value)
}

/// The numbers of a rotation.
pub fn rotation_numbers(rotation: &Rotation) -> [Real; ROTATION] {
    rotation.to_array()
}

/// The rotation with these numbers.
pub fn rotation_of(numbers: &[Real]) -> Option<Rotation> {
    let quaternion = Rotation::from_slice(numbers);
    let length = quaternion.length();
    (length > 1.0e-6 && length.is_finite()).then(|| quaternion.normalize())
}

/// The numbers of an angular quantity.
pub fn angular_numbers(value: AngVector) -> [Real; ANGULAR] {
    value.to_array()
}

/// The angular quantity with these numbers.
pub fn angular_of(numbers: &[Real]) -> AngVector {
    AngVector::from_slice(numbers)
}

/// A hinge about an axis.
pub fn revolute(axis: Option<Vector>) -> PyResult<GenericJoint> {
    Ok(RevoluteJointBuilder::new(unit(axis)?).build().into())
}

/// A slider along an axis.
pub fn prismatic(axis: Option<Vector>) -> PyResult<GenericJoint> {
    Ok(PrismaticJointBuilder::new(unit(axis)?).build().into())
}

/// A ball and socket.
pub fn spherical() -> PyResult<GenericJoint> {
    Ok(SphericalJointBuilder::new().build().into())
}

fn unit(axis: Option<Vector>) -> PyResult<Vector> {
    let axis = axis.unwrap_or(Vector::X);
    match axis.length() > 0.0 {
        true => Ok(axis.normalize()),
        false => Err(invalid(format!("axis is {axis}, but must have a length greater than 0"))),
    }
}

/// A box by its half extents.
pub fn cuboid(half: [Real; 3]) -> SharedShape {
    SharedShape::cuboid(half[0], half[1], half[2])
}

/// A cylinder along y.
pub fn cylinder(half_height: f64, radius: f64) -> PyResult<SharedShape> {
    Ok(SharedShape::cylinder(finite("half_height", half_height)?, finite("radius", radius)?))
}

/// A cone along y, with its tip up.
pub fn cone(half_height: f64, radius: f64) -> PyResult<SharedShape> {
    Ok(SharedShape::cone(finite("half_height", half_height)?, finite("radius", radius)?))
}

/// The heights over a grid: rows lie along z, columns along x.
pub fn height_field(heights: &Bound<'_, PyAny>, scale: Vector) -> PyResult<ColliderBuilder> {
    let array = array("heights", heights)?;
    let [rows, columns] = *array.shape() else {
        return Err(invalid(format!("heights has the shape {:?}, but must have (rows, columns)", array.shape())));
    };
    // The engine's arrays are in the order of columns.
    let (numbers, mut heights) = (array.to_vec()?, Array2::zeros(rows, columns));
    for (index, &height) in numbers.iter().enumerate() {
        heights[(index / columns, index % columns)] = height;
    }
    Ok(ColliderBuilder::heightfield(heights, scale))
}
