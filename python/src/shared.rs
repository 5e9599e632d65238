//! Values that Python threads share.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A value behind a mutex. A thread that waits for the mutex is detached from the interpreter, so
/// other Python threads continue.
pub struct Shared<T> {
    value: Mutex<T>,
    /// The [mark](thread_mark) of the thread with a long computation, or 0.
    computing: AtomicUsize,
}

impl<T: Send> Shared<T> {
    pub fn new(value: T) -> Self {
        Self { value: Mutex::new(value), computing: AtomicUsize::new(0) }
    }

    /// Locks the value for a short access.
    ///
    /// No Python object may be created or released while the guard exists: the interpreter may then
    /// run finalizers, which may lock the same value.
    ///
    /// # Errors
    /// This thread computes with the value already: Python code that the computation calls would
    /// wait for itself.
    pub fn lock(&self, py: Python<'_>) -> PyResult<MutexGuard<'_, T>> {
        self.check_thread()?;
        Ok(self.value.lock_py_attached(py).unwrap_or_else(PoisonError::into_inner))
    }

    /// Runs a long computation on the value, detached from the interpreter.
    ///
    /// # Errors
    /// The errors of [`Self::lock`].
    pub fn detached<R: Send>(
        &self,
        py: Python<'_>,
        compute: impl FnOnce(&mut T) -> R + Send,
    ) -> PyResult<R> {
        self.check_thread()?;
        Ok(py.detach(|| {
            let mut value = self.value.lock().unwrap_or_else(PoisonError::into_inner);
            let _mark = Mark::set(&self.computing);
            compute(&mut value)
        }))
    }

    fn check_thread(&self) -> PyResult<()> {
        match self.computing.load(Ordering::Relaxed) == thread_mark() {
            false => Ok(()),
            true => Err(PyRuntimeError::new_err(
                "a hook cannot use the world that calls it: its arguments contain the data",
            )),
        }
    }
}

/// A number of this thread, which no other living thread has.
fn thread_mark() -> usize {
    thread_local!(static MARK: u8 = const { 0 });
    MARK.with(|mark| std::ptr::from_ref(mark).addr())
}

/// The mark of a thread during a computation, also if it panics.
struct Mark<'a>(&'a AtomicUsize);

impl<'a> Mark<'a> {
    fn set(place: &'a AtomicUsize) -> Self {
        place.store(thread_mark(), Ordering::Relaxed);
        Self(place)
    }
}

impl Drop for Mark<'_> {
    fn drop(&mut self) {
        self.0.store(0, Ordering::Relaxed);
    }
}
