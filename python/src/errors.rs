//! The exceptions of the package.

use pyo3::exceptions::{PyException, PyValueError};
use pyo3::{PyErr, create_exception};

create_exception!(rapier, RapierError, PyException, "The base of the engine's exceptions.");
create_exception!(rapier, StaleHandleError, RapierError, "The object was removed from its world.");
create_exception!(rapier, InvalidValueError, PyValueError, "A value that the engine refuses. The message names it, and the world is unchanged.");
create_exception!(rapier, SnapshotError, RapierError, "Bytes that are no snapshot of this dimension, precision and version.");

/// An [`InvalidValueError`] with the text of an error.
pub fn invalid(error: impl ToString) -> PyErr {
    InvalidValueError::new_err(error.to_string())
}

/// A [`StaleHandleError`] for an object.
pub fn stale(what: &str) -> PyErr {
    StaleHandleError::new_err(format!("the {what} was removed from its world"))
}
