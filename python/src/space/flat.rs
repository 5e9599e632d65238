//! Differences of 2D: rotations and angular quantities are numbers (rad).

mod no_vehicle;

pub use no_vehicle::{Vehicles, fill};

use super::binding::numbers::{array, finite};
use super::binding::transmission::{Axes, along_each};
use super::rapier::dynamics::{GearJoint, GenericJoint, RackJoint, RevoluteJointBuilder};
use super::rapier::geometry::{ColliderBuilder, SharedShape};
use super::rapier::math::{AngVector, Real, Rotation, Vector, rotation_from_angle};
use crate::errors::invalid;
use drawing::View;
use numpy::{PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// Numbers of a rotation.
pub const ROTATION: usize = 1;
/// Numbers of an angular velocity.
pub const ANGULAR: usize = 1;

/// A rotation of an angle (rad).
pub fn rotation(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Rotation> {
    let angle = angular(name, value)?;
    rotation_of(&[angle])
        .ok_or_else(|| invalid(format!("{name} is {angle}, but must be an angle (rad)")))
}

/// An angular quantity of a number.
pub fn angular(name: &str, value: &Bound<'_, PyAny>) -> PyResult<AngVector> {
    finite(name, value.extract()?)
}

/// The numbers of a rotation.
pub fn rotation_numbers(rotation: &Rotation) -> [Real; ROTATION] {
    [rotation.angle()]
}

/// The rotation with these numbers.
pub fn rotation_of(numbers: &[Real]) -> Option<Rotation> {
    numbers[0].is_finite().then(|| rotation_from_angle(numbers[0]))
}

/// The numbers of an angular quantity.
pub fn angular_numbers(value: AngVector) -> [Real; ANGULAR] {
    [value]
}

/// The angular quantity with these numbers.
pub fn angular_of(numbers: &[Real]) -> AngVector {
    numbers[0]
}

/// A hinge. It has no axis in 2D.
pub fn revolute(axis: Option<Vector>) -> PyResult<GenericJoint> {
    match axis {
        None => Ok(RevoluteJointBuilder::new().build().into()),
        Some(_) => Err(invalid("a revolute joint in 2D has no axis")),
    }
}

/// A ball and socket: 3D only.
pub fn spherical() -> PyResult<GenericJoint> {
    Err(invalid("a spherical joint exists in 3D only: in 2D it is a revolute joint"))
}

/// Two gears. They have no axes in 2D.
pub fn gear(axes: Axes, ratio: Real) -> PyResult<GenericJoint> {
    match axes {
        [None, None] => Ok(GearJoint::new(ratio).into()),
        _ => Err(invalid("a gear joint in 2D has no axes")),
    }
}

/// A pinion, which has no axis in 2D, and a rack along one.
pub fn rack(axes: Axes, radius: Real) -> PyResult<GenericJoint> {
    match axes[0] {
        None => along_each(RackJoint::new(Vector::X, radius).into(), axes),
        Some(_) => Err(invalid("the pinion of a rack joint in 2D has no axis1")),
    }
}

/// The point of view of pictures. The angles are those of 3D.
pub fn view(_yaw: f32, _pitch: f32) -> View {
    View::flat()
}

/// The part of an angular quantity about the free axis of a joint.
pub fn about(angular: AngVector, _axis: Vector) -> Real {
    angular
}

/// A box by its half extents.
pub fn cuboid(half: [Real; 2]) -> SharedShape {
    SharedShape::cuboid(half[0], half[1])
}

/// A cylinder: 3D only.
pub fn cylinder(_half_height: f64, _radius: f64) -> PyResult<SharedShape> {
    Err(invalid("a cylinder exists in 3D only"))
}

/// A cone: 3D only.
pub fn cone(_half_height: f64, _radius: f64) -> PyResult<SharedShape> {
    Err(invalid("a cone exists in 3D only"))
}

/// The heights over a line.
pub fn height_field(heights: &Bound<'_, PyAny>, scale: Vector) -> PyResult<ColliderBuilder> {
    let array = array("heights", heights)?;
    match array.shape() {
        [_] => Ok(ColliderBuilder::heightfield(array.to_vec()?, scale)),
        shape => {
            Err(invalid(format!("heights has the shape {shape:?}, but must have one dimension")))
        }
    }
}
