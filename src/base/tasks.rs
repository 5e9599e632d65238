//! Spreading work over threads. The only file that knows the feature `parallel`.
//!
//! With the feature, work runs in the rayon pool of the thread that steps the simulation: wrap the
//! step in `ThreadPool::install` to choose the pool. Without it, or in a pool of one thread, all is a
//! plain loop in order. Which thread does what differs from run to run, so tasks must not care: each
//! item is worked on once, by itself, and results go to a place that depends on the item alone.

use core::ops::Range;

/// How many pieces the work of one thread is cut into, so that the quick ones can help the slow.
#[cfg(feature = "parallel")]
const PIECES_PER_THREAD: usize = 4;

/// The threads that a step may use. Made anew for each step, because the caller's pool may change.
#[derive(Copy, Clone, Debug)]
pub struct Tasks {
    threads: usize,
}

impl Tasks {
    /// The calling thread alone.
    #[cfg(any(test, not(feature = "parallel")))]
    pub const fn serial() -> Self {
        Self { threads: 1 }
    }

    /// The threads of the pool in which the caller runs; the calling thread alone without `parallel`.
    #[cfg(feature = "parallel")]
    pub fn current() -> Self {
        Self { threads: rayon::current_num_threads() }
    }

    /// The threads of the pool in which the caller runs; the calling thread alone without `parallel`.
    #[cfg(not(feature = "parallel"))]
    pub fn current() -> Self {
        Self::serial()
    }

    /// How many threads there are.
    #[cfg(test)]
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// Calls `work` with ranges that together are `0..count`, each item in one of them.
    ///
    /// `grain` is the smallest number of items that is worth the handing over to another thread
    /// (some microseconds of work). Ranges begin at multiples of the grain. With one thread, or no
    /// more than one grain of work, there is one call with the whole range.
    pub fn par_for(&self, count: usize, grain: usize, work: impl Fn(Range<usize>) + Sync) {
        if count == 0 {
            return;
        }
        #[cfg(feature = "parallel")]
        if self.threads > 1 && count > grain {
            let grain = grain.max(1);
            let piece = count.div_ceil(self.threads * PIECES_PER_THREAD).next_multiple_of(grain);
            return split(0..count, piece, &work);
        }
        let _ = (grain, self.threads); // of no use to one thread
        work(0..count);
    }
}

impl Tasks {
    /// Gives each place what `make` makes of its index. `grain` as for [`Self::par_for`].
    pub fn par_fill<T: Send>(
        &self,
        places: &mut [T],
        grain: usize,
        make: impl Fn(usize) -> T + Sync,
    ) {
        #[cfg(feature = "parallel")]
        if self.threads > 1 && places.len() > grain {
            let piece = places.len().div_ceil(self.threads * PIECES_PER_THREAD).max(grain.max(1));
            return fill_split(places, 0, piece, &make);
        }
        let _ = (grain, self.threads); // of no use to one thread
        fill(places, 0, &make);
    }
}

fn fill<T>(places: &mut [T], first: usize, make: &impl Fn(usize) -> T) {
    for (index, place) in (first..).zip(places) {
        *place = make(index);
    }
}

/// Halves the places until they are one piece, and offers the second half to other threads.
#[cfg(feature = "parallel")]
fn fill_split<T: Send>(
    places: &mut [T],
    first: usize,
    piece: usize,
    make: &(impl Fn(usize) -> T + Sync),
) {
    if places.len() <= piece {
        return fill(places, first, make);
    }
    let middle = places.len() / 2;
    let (left, right) = places.split_at_mut(middle);
    rayon::join(
        || fill_split(left, first, piece, make),
        || fill_split(right, first + middle, piece, make),
    );
}

/// Halves the range until it is one piece, and offers the second half to other threads.
#[cfg(feature = "parallel")]
fn split(range: Range<usize>, piece: usize, work: &(impl Fn(Range<usize>) + Sync)) {
    let pieces = range.len().div_ceil(piece);
    if pieces <= 1 {
        return work(range);
    }
    let middle = range.start + pieces / 2 * piece;
    let (first, second) = (range.start..middle, middle..range.end);
    rayon::join(|| split(first, piece, work), || split(second, piece, work));
}

#[cfg(test)]
mod tests {
    use super::Tasks;
    use std::sync::Mutex;

    /// The ranges that `par_for` hands out, in order of their start.
    fn ranges(tasks: Tasks, count: usize, grain: usize) -> Vec<(usize, usize)> {
        let ranges = Mutex::new(Vec::new());
        tasks.par_for(count, grain, |range| ranges.lock().unwrap().push((range.start, range.end)));
        let mut ranges = ranges.into_inner().unwrap();
        ranges.sort_unstable();
        ranges
    }

    fn check_cover(tasks: Tasks) {
        for count in [0, 1, 2, 63, 64, 65, 1000, 4099] {
            for grain in [0, 1, 7, 64, 5000] {
                let ranges = ranges(tasks, count, grain);
                let mut next = 0;
                for &(start, end) in &ranges {
                    assert_eq!(start, next, "a gap or an overlap in {ranges:?}");
                    assert_eq!(start % grain.max(1), 0, "{start} is not a multiple of {grain}");
                    assert!(end > start, "an empty range in {ranges:?}");
                    next = end;
                }
                assert_eq!(next, count, "{ranges:?} does not reach {count}");
            }
        }
    }

    #[test]
    fn one_thread_makes_one_call() {
        assert_eq!(Tasks::serial().threads(), 1);
        assert_eq!(ranges(Tasks::serial(), 1000, 1), [(0, 1000)]);
        check_cover(Tasks::serial());
    }

    #[test]
    fn every_item_is_worked_on_once() {
        check_cover(Tasks::current());
    }

    #[test]
    #[cfg(feature = "parallel")]
    fn work_runs_in_the_pool_of_the_caller() {
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let tasks = Tasks::current();
                assert_eq!(tasks.threads(), threads);
                check_cover(tasks);
                assert_eq!(ranges(tasks, 1000, 1).len() > 1, threads > 1);
                tasks.par_for(1000, 1, |_| assert_eq!(rayon::current_num_threads(), threads));
            });
        }
    }
}
