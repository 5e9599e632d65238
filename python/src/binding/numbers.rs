//! Numbers on their way between Python and the engine.

use super::rapier::dynamics::RigidBody;
use super::rapier::math::{DIM, Pose, Real, Vector};
use super::space;
use crate::errors::invalid;
use numpy::{Element, PyArray1, PyArrayDescr, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// Numbers of a pose: translation, rotation.
pub const POSE: usize = DIM + space::ROTATION;
/// Numbers of a body's state: pose, linear velocity, angular velocity.
pub const STATE: usize = POSE + DIM + space::ANGULAR;

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

/// A number of at least 0.
pub fn non_negative(name: &str, value: f64) -> PyResult<Real> {
    match value >= 0.0 {
        true => finite(name, value),
        false => Err(invalid(format!("{name} is {value}, but must not be negative"))),
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

/// Anything that NumPy converts to an array of the engine's numbers.
pub fn array<'py>(name: &str, value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
    let py = value.py();
    let array = py.import("numpy")?.call_method1("ascontiguousarray", (value, dtype(py)?));
    let array = array.map_err(|_| invalid(format!("{name} is {value}, but must be an array of numbers")))?;
    Ok(array.cast_into::<PyArrayDyn<Real>>()?)
}

/// The elements of an array of a shape.
pub fn elements(name: &str, value: &Bound<'_, PyAny>, shape: &[usize]) -> PyResult<Vec<Real>> {
    let array = array(name, value)?;
    if array.shape() != shape {
        return Err(invalid(format!("{name} has the shape {:?}, but must have {shape:?}", array.shape())));
    }
    Ok(array.to_vec()?)
}

/// Points of an array of the shape (n, DIM).
pub fn points(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Vec<Vector>> {
    let array = array(name, value)?;
    let [_, DIM] = *array.shape() else {
        return Err(invalid(format!("{name} has the shape {:?}, but must have (n, {DIM})", array.shape())));
    };
    Ok(array.to_vec()?.chunks_exact(DIM).map(Vector::from_slice).collect())
}

/// An array of the numbers of a vector.
pub fn vector_out<'py>(py: Python<'py>, vector: Vector) -> Bound<'py, PyArray1<Real>> {
    PyArray1::from_slice(py, &vector.to_array())
}

/// A pose of optional parts.
pub fn pose(position: Option<&Bound<'_, PyAny>>, rotation: Option<&Bound<'_, PyAny>>) -> PyResult<Pose> {
    let mut pose = Pose::default();
    if let Some(position) = position {
        pose.translation = space::vector("position", position)?;
    }
    if let Some(rotation) = rotation {
        pose.rotation = space::rotation("rotation", rotation)?;
    }
    Ok(pose)
}

/// Writes the state of a body: [`STATE`] numbers.
pub fn write_state(body: &RigidBody, row: &mut [Real]) {
    let pose = body.position();
    row[..DIM].copy_from_slice(&pose.translation.to_array());
    row[DIM..POSE].copy_from_slice(&space::rotation_numbers(&pose.rotation));
    row[POSE..POSE + DIM].copy_from_slice(&body.linvel().to_array());
    row[POSE + DIM..].copy_from_slice(&space::angular_numbers(body.angvel()));
}

/// Changes a body to a state. Returns whether the numbers are a state.
pub fn read_state(body: &mut RigidBody, row: &[Real]) -> bool {
    let rotation = space::rotation_of(&row[DIM..POSE]);
    let Some(rotation) = rotation.filter(|_| row.iter().all(|number| number.is_finite())) else { return false };
    body.set_position(Pose::from_parts(Vector::from_slice(&row[..DIM]), rotation), true);
    body.set_linvel(Vector::from_slice(&row[POSE..POSE + DIM]), true);
    body.set_angvel(space::angular_of(&row[POSE + DIM..]), true);
    true
}

/// An array to fill: the given one, if its shape and its layout fit, or a new one.
pub fn output<'py>(py: Python<'py>, given: Option<Bound<'py, PyAny>>, shape: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
    let Some(given) = given else { return Ok(PyArrayDyn::zeros(py, shape, false)) };
    let array = given.cast_into::<PyArrayDyn<Real>>().map_err(|error| {
        invalid(format!("out is a {}, but must be an array of float{} numbers", error.into_inner().get_type(), size_of::<Real>() * 8))
    })?;
    if array.shape() != shape || !array.is_c_contiguous() {
        return Err(invalid(format!("out has the shape {:?}, but must be contiguous and have {shape:?}", array.shape())));
    }
    Ok(array)
}
