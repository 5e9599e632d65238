//! Differences of 3D: rotations are unit quaternions `(x, y, z, w)`, angular quantities are
//! vectors.

mod vehicle;

pub use vehicle::{Vehicles, fill};

use super::binding::joint::along;
use super::binding::numbers::{array, finite, numbers, vector};
use super::binding::transmission::{Axes, along_each};
use super::rapier::dynamics::{
    GearJoint, GenericJoint, RackJoint, RevoluteJointBuilder, SphericalJointBuilder,
};
use super::rapier::geometry::{ColliderBuilder, SharedShape};
use super::rapier::math::{AngVector, Real, Rotation, Vector};
use super::rapier::parry::utils::Array2;
use crate::errors::invalid;
use drawing::View;
use numpy::{PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// Numbers of a rotation.
pub const ROTATION: usize = 4;
/// Numbers of an angular velocity.
pub const ANGULAR: usize = 3;

/// A quaternion of a Python sequence `(x, y, z, w)`.
pub fn rotation(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Rotation> {
    let numbers = numbers::<ROTATION>(name, value)?;
    rotation_of(&numbers).ok_or_else(|| {
        invalid(format!(
            "{name} is {numbers:?}, but a rotation is a quaternion (x, y, z, w) of unit length"
        ))
    })
}

/// An angular quantity of a Python sequence with three numbers.
pub fn angular(name: &str, value: &Bound<'_, PyAny>) -> PyResult<AngVector> {
    vector(name, value)
}

/// The numbers of a rotation.
pub fn rotation_numbers(rotation: &Rotation) -> [Real; ROTATION] {
    rotation.to_array()
}

/// The rotation with these numbers. `None` if their length is almost 0 or overflows.
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
    along(RevoluteJointBuilder::new(Vector::X).build().into(), axis)
}

/// A ball and socket.
pub fn spherical() -> PyResult<GenericJoint> {
    Ok(SphericalJointBuilder::new().build().into())
}

/// Two gears about an axis each.
pub fn gear(axes: Axes, ratio: Real) -> PyResult<GenericJoint> {
    along_each(GearJoint::new(Vector::X, Vector::X, ratio).into(), axes)
}

/// A pinion about an axis, and a rack along one.
pub fn rack(axes: Axes, radius: Real) -> PyResult<GenericJoint> {
    along_each(RackJoint::new(Vector::X, Vector::X, radius).into(), axes)
}

/// The point of view of pictures, by the angles of the camera (degrees).
pub fn view(yaw: f32, pitch: f32) -> View {
    View::orbit(yaw, pitch)
}

/// The part of an angular quantity about the free axis of a joint.
pub fn about(angular: AngVector, axis: Vector) -> Real {
    angular.dot(axis)
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
        return Err(invalid(format!(
            "heights has the shape {:?}, but must have (rows, columns)",
            array.shape()
        )));
    };
    // The engine's arrays are in the order of columns.
    let (numbers, mut heights) = (array.to_vec()?, Array2::zeros(rows, columns));
    for (index, &height) in numbers.iter().enumerate() {
        heights[(index / columns, index % columns)] = height;
    }
    Ok(ColliderBuilder::heightfield(heights, scale))
}
