//! Buffers that threads borrow and return.

use std::sync::{Mutex, PoisonError};

/// Buffers that are expensive to make, each used by one thread at a time. Their number is the largest number
/// that was in use at the same time.
#[derive(Debug, Default)]
pub(crate) struct Pool<T> {
    idle: Mutex<Vec<T>>,
}

impl<T: Default> Pool<T> {
    /// One of the idle buffers, or a new one.
    pub fn take(&self) -> T {
        let mut idle = self.idle.lock().unwrap_or_else(PoisonError::into_inner);
        idle.pop().unwrap_or_default()
    }

    /// Visits the idle buffers.
    pub fn for_each(&mut self, visit: impl FnMut(&mut T)) {
        self.idle.get_mut().unwrap_or_else(PoisonError::into_inner).iter_mut().for_each(visit);
    }

    /// Returns a buffer to the pool.
    pub fn put(&self, buffer: T) {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner).push(buffer);
    }
}
