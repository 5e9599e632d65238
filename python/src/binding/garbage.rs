//! References for Python's garbage collector.

/// Shows the references of a class to the garbage collector, which frees a world whose hooks refer to
/// its objects. `World` breaks such a cycle.
macro_rules! traverse {
    ($class:ident, $this:ident => $($reference:expr),+) => {
        #[pymethods]
        impl $class {
            fn __traverse__(
                &self,
                visit: pyo3::gc::PyVisit<'_>,
            ) -> Result<(), pyo3::gc::PyTraverseError> {
                let $this = self;
                $(visit.call(&$reference)?;)+
                Ok(())
            }
        }
    };
}

pub(crate) use traverse;
