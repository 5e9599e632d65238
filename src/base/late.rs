//! A value that is completed at its first read, behind a shared reference.

use core::cell::UnsafeCell;
use std::panic::RefUnwindSafe;

/// A value with a part that may be written late. Its exclusive owner writes it; under a contract, so does the
/// holder of a shared reference before the first read.
#[derive(Debug, Default)]
#[repr(transparent)]
pub struct Late<T>(UnsafeCell<T>);

// SAFETY: through a shared `Late` a thread can access a value of another thread (`T: Send`), and several
// threads the same one for reading (`T: Sync`). The contract of `write` excludes reads meanwhile.
unsafe impl<T: Send + Sync> Sync for Late<T> {}

// A panic within `write` may leave a part unwritten, as it may behind a mutable reference.
impl<T: RefUnwindSafe> RefUnwindSafe for Late<T> {}

impl<T: Clone> Clone for Late<T> {
    fn clone(&self) -> Self {
        Self::new(self.get().clone())
    }

    fn clone_from(&mut self, source: &Self) {
        self.get_mut().clone_from(source.get());
    }
}

#[cfg(feature = "serde-serialize")]
impl<T: serde::Serialize> serde::Serialize for Late<T> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.get().serialize(serializer)
    }
}

#[cfg(feature = "serde-serialize")]
impl<'de, T: serde::Deserialize<'de>> serde::Deserialize<'de> for Late<T> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        T::deserialize(deserializer).map(Self::new)
    }
}

impl<T> Late<T> {
    /// A value whose late part is not written yet.
    pub fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// The value in its present state.
    #[inline(always)]
    pub fn get(&self) -> &T {
        // SAFETY: the contract of `write` excludes reads meanwhile.
        unsafe { &*self.0.get() }
    }

    /// Mutable access to the value.
    #[inline(always)]
    pub fn get_mut(&mut self) -> &mut T {
        self.0.get_mut()
    }

    /// Writes to the value behind a shared reference.
    ///
    /// # Safety
    /// No reference to the value exists, or is requested, until `write` returns.
    pub unsafe fn write(&self, write: impl FnOnce(&mut T)) {
        // SAFETY: the caller's promise.
        write(unsafe { &mut *self.0.get() });
    }

    /// Mutable access to several values.
    pub fn slice_mut(slice: &mut [Self]) -> &mut [T] {
        // SAFETY: `Late<T>` has the layout of `T`, and the slice is ours alone.
        unsafe { &mut *(core::ptr::from_mut(slice) as *mut [T]) }
    }
}
