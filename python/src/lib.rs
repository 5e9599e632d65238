//! The Python package `rapier`: one extension with four modules, one for each dimension and precision.
//!
//! The classes are one source (`binding`), compiled once for each engine. A module of this file selects the engine and the folder `space`,
//! which contains the differences between the dimensions.

mod errors;

macro_rules! engine {
    ($(#[$documentation:meta])* $name:ident, $engine:ident, $space:literal) => {
        $(#[$documentation])*
        mod $name {
            use $engine as rapier;
            #[path = $space]
            mod space;
            #[path = "../binding/mod.rs"]
            pub mod binding;
        }
    };
}

engine!(/// 2D in single precision.
    dim2, rapier2d, "../space/flat.rs");
engine!(/// 3D in single precision.
    dim3, rapier3d, "../space/solid.rs");
engine!(/// 2D in double precision.
    dim2_f64, rapier2d_f64, "../space/flat.rs");
engine!(/// 3D in double precision.
    dim3_f64, rapier3d_f64, "../space/solid.rs");

use pyo3::prelude::*;

/// The native part of the package.
#[pymodule]
fn _rapier(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("RapierError", py.get_type::<errors::RapierError>())?;
    module.add("StaleHandleError", py.get_type::<errors::StaleHandleError>())?;
    module.add("InvalidValueError", py.get_type::<errors::InvalidValueError>())?;
    module.add("SnapshotError", py.get_type::<errors::SnapshotError>())?;
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
