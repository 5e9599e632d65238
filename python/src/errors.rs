//! The exceptions of the package.

use pyo3::exceptions::{PyException, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{IntoPyDict, PyType};
use pyo3::{PyErr, create_exception};

create_exception!(rapier, RapierError, PyException, "The base of the engine's exceptions.");
create_exception!(rapier, StaleHandleError, RapierError, "The object was removed from its world.");
create_exception!(
    rapier,
    SnapshotError,
    RapierError,
    "Bytes that are no snapshot of this dimension, precision and version."
);

/// The class `InvalidValueError`, which is a `RapierError` and a `ValueError`. `create_exception!`
/// allows one base only.
pub fn invalid_value_error(py: Python<'_>) -> PyResult<&Bound<'_, PyType>> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let class = CLASS.get_or_try_init(py, || {
        let bases = (py.get_type::<RapierError>(), py.get_type::<PyValueError>());
        let doc =
            "A value that the engine refuses. The message names it, and the world is unchanged.";
        let members = [("__doc__", doc), ("__module__", "rapier")].into_py_dict(py)?;
        let class = py.get_type::<PyType>().call1(("InvalidValueError", bases, members))?;
        PyResult::Ok(class.cast_into::<PyType>()?.unbind())
    })?;
    Ok(class.bind(py))
}

/// An `InvalidValueError` with the text of an error.
pub fn invalid(error: impl ToString) -> PyErr {
    Python::attach(|py| match invalid_value_error(py) {
        Ok(class) => PyErr::from_type(class.clone(), error.to_string()),
        Err(failure) => failure,
    })
}

/// A [`StaleHandleError`] for an object.
pub fn stale(what: &str) -> PyErr {
    StaleHandleError::new_err(format!("the {what} was removed from its world"))
}
