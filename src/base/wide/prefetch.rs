//! Prefetches memory before it is needed.

/// Size of a cache line (bytes).
#[cfg(target_arch = "x86_64")]
const LINE: usize = 64;

/// Prefetch distance of loops with little work per record, in list positions.
pub const PREFETCH_DISTANCE: usize = 4;

/// Begins to load a record into the caches, without a delay. It affects the running time only.
#[inline(always)]
pub fn prefetch<T>(record: &T) {
    prefetch_front(record, size_of::<T>());
}

/// As [`prefetch`], of the record's first bytes alone.
#[inline(always)]
pub fn prefetch_front<T>(record: &T, bytes: usize) {
    #[cfg(target_arch = "x86_64")]
    {
        use core::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        let start = core::ptr::from_ref(record).cast::<i8>();
        let mut offset = 0;
        while offset < bytes {
            // SAFETY: a prefetch reads and writes nothing that a program can see, and never faults.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(start.wrapping_add(offset)) };
            offset += LINE;
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (record, bytes);
}
