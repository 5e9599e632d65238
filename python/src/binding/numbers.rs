//! Numbers on their way between Python and the engine.

use super::rapier::dynamics::{RigidBody, RigidBodyVelocity};
use super::rapier::math::{AngVector, DIM, Pose, Real, Vector};
use super::space;
use crate::errors::invalid;
use numpy::{
    Element, PyArray1, PyArrayDescr, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn,
    PyUntypedArrayMethods,
};
use pyo3::prelude::*;

/// Numbers of a pose: translation, rotation.
pub const POSE: usize = DIM + space::ROTATION;
/// Numbers of a body's state: pose, linear velocity, angular velocity.
pub const STATE: usize = POSE + DIM + space::ANGULAR;
/// Largest coordinate (m) and speed (m/s, rad/s) of the engine, which ignores larger ones.
const SIZE_MAX: Real = 1.0e15;

/// The type of the elements of arrays.
pub fn dtype(py: Python<'_>) -> PyResult<Bound<'_, PyArrayDescr>> {
    Ok(Real::get_dtype(py))
}

/// A finite number. The name is for the error.
pub fn finite(name: &str, value: f64) -> PyResult<Real> {
    let real = value as Real;
    match real.is_finite() {
        true => Ok(real),
        false => Err(invalid(format!("{name} is {value}, but must be finite"))),
    }
}

/// A finite number of at least 0.
pub fn non_negative(name: &str, value: f64) -> PyResult<Real> {
    match value < 0.0 {
        true => Err(invalid(format!("{name} is {value}, but must not be negative"))),
        false => finite(name, value),
    }
}

/// A coefficient of a material: at least 0 and at most [`SIZE_MAX`].
pub fn coefficient(name: &str, value: f64) -> PyResult<Real> {
    match non_negative(name, value)? {
        real if real <= SIZE_MAX => Ok(real),
        real => Err(too_large(name, real)),
    }
}

/// The finite numbers of a Python sequence.
pub fn numbers<const N: usize>(name: &str, value: &Bound<'_, PyAny>) -> PyResult<[Real; N]> {
    let list: Option<Vec<f64>> = value.extract().ok();
    let Some(list) = list.filter(|list| list.len() == N) else {
        return Err(invalid(format!("{name} is {value}, but must be a sequence of {N} numbers")));
    };
    let mut numbers = [0.0; N];
    for (number, &value) in numbers.iter_mut().zip(&list) {
        *number = finite(name, value)?;
    }
    Ok(numbers)
}

/// A finite vector of a Python sequence with [`DIM`] numbers.
pub fn vector(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Vector> {
    Ok(Vector::from_array(numbers(name, value)?))
}

/// A vector with the coordinates of a point (m), of a velocity (m/s) or of an acceleration (m/s²):
/// each at most [`SIZE_MAX`].
pub fn coordinates(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Vector> {
    let vector = vector(name, value)?;
    match is_point(vector) {
        true => Ok(vector),
        false => Err(too_large(name, vector)),
    }
}

/// An angular velocity (rad/s) of at most [`SIZE_MAX`].
pub fn angular_velocity(name: &str, value: &Bound<'_, PyAny>) -> PyResult<AngVector> {
    let angvel = space::angular(name, value)?;
    match is_angular_velocity(angvel) {
        true => Ok(angvel),
        false => Err(too_large(name, angvel)),
    }
}

fn is_point(vector: Vector) -> bool {
    vector.to_array().iter().all(|number| number.abs() <= SIZE_MAX)
}

fn is_angular_velocity(angvel: AngVector) -> bool {
    let squares = space::angular_numbers(angvel).map(|number| number * number);
    squares.iter().sum::<Real>() <= SIZE_MAX * SIZE_MAX
}

fn too_large(name: &str, value: impl std::fmt::Display) -> PyErr {
    invalid(format!("{name} is {value}, but must be at most {SIZE_MAX:e}"))
}

/// A contiguous array of anything that NumPy converts to the engine's numbers.
pub fn array<'py>(
    name: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<PyReadonlyArrayDyn<'py, Real>> {
    let py = value.py();
    let array = py.import("numpy")?.call_method1("ascontiguousarray", (value, dtype(py)?));
    let array = array
        .map_err(|_| invalid(format!("{name} is {value}, but must be an array of numbers")))?;
    Ok(array.cast_into::<PyArrayDyn<Real>>()?.try_readonly()?)
}

/// A contiguous array with a shape.
pub fn shaped_array<'py>(
    name: &str,
    value: &Bound<'py, PyAny>,
    shape: &[usize],
) -> PyResult<PyReadonlyArrayDyn<'py, Real>> {
    let array = array(name, value)?;
    match array.shape() == shape {
        true => Ok(array),
        false => Err(invalid(format!(
            "{name} has the shape {:?}, but must have {shape:?}",
            array.shape()
        ))),
    }
}

/// The elements of an array, all of them finite.
pub fn finite_elements<'a>(
    name: &str,
    array: &'a PyReadonlyArrayDyn<'_, Real>,
) -> PyResult<&'a [Real]> {
    let elements = array.as_slice()?;
    match elements.iter().find(|element| !element.is_finite()) {
        None => Ok(elements),
        Some(element) => {
            Err(invalid(format!("{name} has the element {element}, but must be finite")))
        }
    }
}

/// Finite points of an array with the shape (n, DIM).
pub fn points(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Vec<Vector>> {
    let array = array(name, value)?;
    let [_, DIM] = *array.shape() else {
        return Err(invalid(format!(
            "{name} has the shape {:?}, but must have (n, {DIM})",
            array.shape()
        )));
    };
    Ok(finite_elements(name, &array)?.chunks_exact(DIM).map(Vector::from_slice).collect())
}

/// An array of the numbers of a vector.
pub fn vector_out<'py>(py: Python<'py>, vector: Vector) -> Bound<'py, PyArray1<Real>> {
    PyArray1::from_slice(py, &vector.to_array())
}

/// A pose with a new position (m) and a new rotation. An absent one is that of the base.
pub fn pose(
    base: Pose,
    position: Option<&Bound<'_, PyAny>>,
    rotation: Option<&Bound<'_, PyAny>>,
) -> PyResult<Pose> {
    let translation =
        position.map_or(Ok(base.translation), |position| coordinates("position", position))?;
    let rotation =
        rotation.map_or(Ok(base.rotation), |rotation| space::rotation("rotation", rotation))?;
    Ok(Pose::from_parts(translation, rotation))
}

/// Writes the state of a body: [`STATE`] numbers.
pub fn write_state(body: &RigidBody, row: &mut [Real]) {
    let pose = body.position();
    row[..DIM].copy_from_slice(&pose.translation.to_array());
    row[DIM..POSE].copy_from_slice(&space::rotation_numbers(&pose.rotation));
    row[POSE..POSE + DIM].copy_from_slice(&body.linvel().to_array());
    row[POSE + DIM..].copy_from_slice(&space::angular_numbers(body.angvel()));
}

/// The state of a body with [`STATE`] numbers. `None` if the engine would refuse it.
pub fn parse_state(row: &[Real]) -> Option<(Pose, RigidBodyVelocity)> {
    let translation = Vector::from_slice(&row[..DIM]);
    let rotation = space::rotation_of(&row[DIM..POSE])?;
    let linvel = Vector::from_slice(&row[POSE..POSE + DIM]);
    let angvel = space::angular_of(&row[POSE + DIM..]);
    let is_state = is_point(translation) && is_point(linvel) && is_angular_velocity(angvel);
    is_state
        .then(|| (Pose::from_parts(translation, rotation), RigidBodyVelocity::new(linvel, angvel)))
}

/// An array to fill: the given one, if its shape and its layout fit, or a new one.
pub fn output<'py>(
    py: Python<'py>,
    given: Option<Bound<'py, PyAny>>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
    let Some(given) = given else { return Ok(PyArrayDyn::zeros(py, shape, false)) };
    let array = given.cast_into::<PyArrayDyn<Real>>().map_err(|error| {
        invalid(format!(
            "out is a {}, but must be an array of float{} numbers",
            error.into_inner().get_type(),
            size_of::<Real>() * 8
        ))
    })?;
    if array.shape() != shape || !array.is_c_contiguous() {
        return Err(invalid(format!(
            "out has the shape {:?}, but must be contiguous and have {shape:?}",
            array.shape()
        )));
    }
    Ok(array)
}
