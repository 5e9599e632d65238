//! The Python package `rapier`: one extension with four modules, one for each dimension and
//! precision.
//!
//! The classes are one source (`binding`), compiled once for each engine. `dim2`, `dim3` and their
//! twins of double precision select the engine and the file of
//! `space`, which contains the differences between the dimensions.

mod errors;
mod pictures;
mod shared;

mod dim2;
mod dim2_f64;
mod dim3;
mod dim3_f64;

use pyo3::prelude::*;

/// The native part of the package.
#[pymodule]
fn _rapier(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("RapierError", py.get_type::<errors::RapierError>())?;
    module.add("StaleHandleError", py.get_type::<errors::StaleHandleError>())?;
    module.add("InvalidValueError", errors::invalid_value_error(py)?)?;
    module.add("SnapshotError", py.get_type::<errors::SnapshotError>())?;
    module.add_function(wrap_pyfunction!(pictures::encode_png, module)?)?;
    module.add_function(wrap_pyfunction!(pictures::encode_apng, module)?)?;
    for (name, fill) in [
        ("dim2", dim2::binding::fill as fn(&Bound<'_, PyModule>) -> PyResult<()>),
        ("dim3", dim3::binding::fill),
        ("dim2_f64", dim2_f64::binding::fill),
        ("dim3_f64", dim3_f64::binding::fill),
    ] {
        let part = PyModule::new(py, name)?;
        fill(&part)?;
        module.add_submodule(&part)?;
    }
    Ok(())
}
