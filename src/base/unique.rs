//! Numbers that occur once per process.
//!
//! They distinguish objects and moments whose contents may be equal. No result depends on their values, only
//! on whether two of them are equal: the values differ from run to run.

use core::sync::atomic::{AtomicU64, Ordering};

/// Returns a number that no earlier call has returned. It is neither 0 nor `u64::MAX`: the counter starts at
/// 1, and at one call per nanosecond it overflows after 584 years.
pub fn unique_number() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

#[cfg(test)]
mod tests {
    use super::unique_number;

    #[test]
    fn no_number_occurs_twice_on_any_thread() {
        let draw = || core::array::from_fn::<u64, 1000, _>(|_| unique_number());
        let mut numbers: Vec<u64> = std::thread::scope(|scope| {
            let threads = [(); 4].map(|()| scope.spawn(draw));
            threads.into_iter().flat_map(|thread| thread.join().expect("no panic")).collect()
        });
        numbers.sort_unstable();
        assert!(numbers.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(numbers[0] > 0 && numbers[numbers.len() - 1] < u64::MAX);
    }
}
