//! One slice, several writers: each element belongs to one of them at a time.
//!
//! The borrow checker treats a slice as a whole. Within one colour no two constraints have a common body, so
//! workers may each write the bodies of their own constraints. This type expresses that. The
//! compiler cannot check that; it is the safety contract of each function.

use super::wide::{prefetch, prefetch_front};
use core::cell::UnsafeCell;
use core::ops::Range;

/// A mutable slice whose elements can be borrowed one by one, by several threads.
pub struct DisjointMut<'a, T> {
    elements: &'a [UnsafeCell<T>],
}

// SAFETY: through a shared `DisjointMut` a thread can access elements of another thread (`T: Send`), and
// several threads the same element for reading (`T: Sync`). The contract of `get` and `get_mut` excludes
// concurrent writes.
unsafe impl<T: Send + Sync> Sync for DisjointMut<'_, T> {}

// SAFETY: as above; a copy in another thread is equivalent to a reference.
unsafe impl<T: Send + Sync> Send for DisjointMut<'_, T> {}

impl<T> Copy for DisjointMut<'_, T> {}

impl<T> Clone for DisjointMut<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<'a, T> DisjointMut<'a, T> {
    /// Takes the slice for as long as its elements are to be shared out.
    pub fn new(slice: &'a mut [T]) -> Self {
        let elements = core::ptr::from_mut(slice) as *const [UnsafeCell<T>];
        // SAFETY: `UnsafeCell<T>` has the layout of `T`, and the slice is ours alone for `'a`.
        Self { elements: unsafe { &*elements } }
    }

    /// The number of elements.
    pub fn len(&self) -> usize {
        self.elements.len()
    }

    /// Prefetches an element.
    #[inline(always)]
    pub fn prefetch(&self, index: usize) {
        if let Some(cell) = self.elements.get(index) {
            prefetch(cell);
        }
    }

    /// Prefetches the first bytes of an element.
    #[inline(always)]
    pub fn prefetch_front(&self, index: usize, bytes: usize) {
        if let Some(cell) = self.elements.get(index) {
            prefetch_front(cell, bytes);
        }
    }

    /// The cell of an element; the index is checked in debug builds.
    ///
    /// # Safety
    /// `index < self.len()`.
    #[inline(always)]
    unsafe fn cell(&self, index: usize) -> &'a UnsafeCell<T> {
        debug_assert!(index < self.len(), "element {index} of {}", self.len());
        // SAFETY: the caller promises that the index is in range.
        unsafe { self.elements.get_unchecked(index) }
    }

    /// An element, for reading. The index is checked in debug builds only.
    ///
    /// # Safety
    /// `index < self.len()`, and no thread writes the element while the reference lives.
    #[inline(always)]
    pub unsafe fn get(&self, index: usize) -> &'a T {
        // SAFETY: the caller promises the range, and that there is no `&mut` to the element.
        unsafe { &*self.cell(index).get() }
    }

    /// An element, for writing. The index is checked in debug builds only.
    ///
    /// # Safety
    /// `index < self.len()`, and no other reference to the element exists while this one lives.
    #[inline(always)]
    pub unsafe fn get_mut(&self, index: usize) -> &'a mut T {
        // SAFETY: the caller promises the range, and that there is no other reference to the element.
        unsafe { &mut *self.cell(index).get() }
    }

    /// Some elements, for writing. The range is checked in debug builds only.
    ///
    /// # Safety
    /// The range must be one of this slice, and no other reference to one of its elements exists while this
    /// one lives.
    #[inline(always)]
    pub unsafe fn range_mut(&self, range: Range<usize>) -> &'a mut [T] {
        debug_assert!(range.start <= range.end && range.end <= self.len(), "{range:?}");
        let first = self.elements.as_ptr().wrapping_add(range.start);
        // SAFETY: the caller guarantees the range, and owns its elements exclusively; cells have the layout
        // of their contents.
        unsafe { core::slice::from_raw_parts_mut(UnsafeCell::raw_get(first), range.len()) }
    }
}

#[cfg(test)]
mod tests {
    use super::DisjointMut;

    #[test]
    fn threads_write_to_elements_of_their_own() {
        let mut numbers: Vec<usize> = (0..1000).collect();
        let shared = DisjointMut::new(&mut numbers);
        assert_eq!(shared.len(), 1000);
        std::thread::scope(|scope| {
            for worker in 0..4 {
                scope.spawn(move || {
                    for index in (worker..shared.len()).step_by(4) {
                        // SAFETY: in range, and each index belongs to one worker.
                        unsafe { *shared.get_mut(index) += 10 * worker };
                    }
                });
            }
        });
        // SAFETY: in range, and the writers are done.
        assert_eq!(unsafe { *shared.get(7) }, 37);
        assert!(numbers.iter().enumerate().all(|(index, &n)| n == index + 10 * (index % 4)));
    }

    #[test]
    #[cfg(debug_assertions)]
    #[should_panic(expected = "element 3 of 3")]
    fn debug_builds_check_the_index() {
        let mut numbers = [1, 2, 3];
        // SAFETY: breaks the contract on purpose; the check panics before anything is read.
        unsafe { DisjointMut::new(&mut numbers).get(3) };
    }
}
