//! Values that Python threads share.

use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A value behind a mutex. A thread that waits for the mutex is detached from the interpreter, so other Python threads continue.
pub struct Shared<T>(Mutex<T>);

impl<T: Send> Shared<T> {
    pub fn new(value: T) -> Self {
        Self(Mutex::new(value))
    }

    /// Locks the value for a short access.
    ///
    /// No Python object may be created or released while the guard exists: the interpreter may then run finalizers, which may lock the same value.
    pub fn lock(&self, py: Python<'_>) -> MutexGuard<'_, T> {
        self.0.lock_py_attached(py).unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs a long computation on the value, detached from the interpreter.
    pub fn detached<R: Send>(&self, py: Python<'_>, compute: impl FnOnce(&mut T) -> R + Send) -> R {
        py.detach(|| compute(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner)))
    }
}
