//! Keyword arguments of a call.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Keyword arguments that were not read yet.
pub struct Options<'py> {
    function: &'static str,
    left: Option<Bound<'py, PyDict>>,
}

impl<'py> Options<'py> {
    /// The arguments of a call of a function.
    pub fn new(function: &'static str, options: Option<&Bound<'py, PyDict>>) -> PyResult<Self> {
        Ok(Self { function, left: options.map(|options| options.copy()).transpose()? })
    }

    /// Takes an argument as it is. None counts as absent.
    pub fn any(&self, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(left) = &self.left else { return Ok(None) };
        let Some(value) = left.get_item(name)? else { return Ok(None) };
        left.del_item(name)?;
        Ok((!value.is_none()).then_some(value))
    }

    /// Takes an argument of a type. None counts as absent.
    pub fn take<T: for<'a> FromPyObject<'a, 'py>>(&self, name: &str) -> PyResult<Option<T>> {
        let Some(value) = self.any(name)? else { return Ok(None) };
        let extracted = value.extract().ok();
        match extracted {
            Some(extracted) => Ok(Some(extracted)),
            None => Err(PyTypeError::new_err(format!(
                "{}() got {name}={value}, which has the wrong type",
                self.function
            ))),
        }
    }

    /// Fails if an argument is left: the function has no such one.
    pub fn finish(self) -> PyResult<()> {
        match self.left.and_then(|left| left.keys().iter().next()) {
            None => Ok(()),
            Some(name) => Err(PyTypeError::new_err(format!(
                "{}() got an unexpected keyword argument '{name}'",
                self.function
            ))),
        }
    }
}
