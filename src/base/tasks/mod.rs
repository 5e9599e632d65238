//! Spreading work over threads. The only folder that uses the feature `parallel`.
//!
//! With the feature, work runs in the rayon pool of the thread that steps the simulation, or on the
//! [`Threads`] that the pipeline was given. Without it, or with one thread, all is a plain loop in order. The
//! assignment of items to threads differs from run to run. Each item is therefore processed once,
//! independently, and its result goes to a place that depends on the item alone.

#[cfg(feature = "parallel")]
mod team;
mod gather;
mod threads;

use super::disjoint::DisjointMut;
use core::marker::PhantomData;
use core::ops::Range;
#[cfg(feature = "parallel")]
use std::sync::Arc;
#[cfg(feature = "parallel")]
use team::WorkerTeam;

pub use gather::Gather;
pub use threads::{Threads, ThreadsError};

/// Number of pieces per thread, so that fast threads can take work of slow ones.
#[cfg(feature = "parallel")]
const PIECES_PER_THREAD: usize = 4;

/// The threads that a step may use. Only the thread that opened them can distribute work.
#[derive(Copy, Clone)]
pub struct Tasks<'a> {
    /// `None` for a single thread.
    #[cfg(feature = "parallel")]
    team: Option<(&'a WorkerTeam, &'a dyn Fn(usize))>,
    /// Neither sent to nor shared with another thread.
    unshared: PhantomData<(&'a (), *const ())>,
}

impl Tasks<'_> {
    /// The calling thread alone.
    pub const SERIAL: Self = Self {
        #[cfg(feature = "parallel")]
        team: None,
        unshared: PhantomData,
    };

    /// Calls `work` with the threads of the pool in which the caller runs.
    #[cfg(feature = "parallel")]
    pub fn open<R>(work: impl FnOnce(Tasks<'_>) -> R) -> R {
        let recruit = |team: Arc<WorkerTeam>, number| rayon::spawn(move || team.help(number));
        Self::open_with(rayon::current_num_threads(), recruit, work)
    }

    /// Calls `work` with a worker team of `count` threads, the calling thread included. `recruit` starts one
    /// worker for the team, with its number.
    #[cfg(feature = "parallel")]
    fn open_with<R>(
        count: usize,
        recruit: impl Fn(Arc<WorkerTeam>, usize),
        work: impl FnOnce(Tasks<'_>) -> R,
    ) -> R {
        if count <= 1 {
            return work(Tasks::SERIAL);
        }
        let team = Arc::new(WorkerTeam::new(count));
        // A scope of rayon would wait for workers that never start, or run other tasks meanwhile.
        let recruit = |number| recruit(Arc::clone(&team), number);
        let _owner = team.own();
        work(Tasks { team: Some((&team, &recruit)), unshared: PhantomData })
    }

    /// Calls `work` with the calling thread alone: there are others with the feature `parallel`.
    #[cfg(not(feature = "parallel"))]
    pub fn open<R>(work: impl FnOnce(Tasks<'_>) -> R) -> R {
        work(Tasks::SERIAL)
    }

    /// Returns whether there is only one thread.
    pub fn are_alone(&self) -> bool {
        #[cfg(feature = "parallel")]
        return self.team.is_none();
        #[cfg(not(feature = "parallel"))]
        true
    }

    /// Calls `work` with ranges that together are `0..count`, each item in one of them.
    ///
    /// `grain` is the smallest number of items that justifies a transfer to another thread (some microseconds
    /// of work). Ranges begin at multiples of the grain. With one thread, or at most one grain of work, there
    /// is one call with the whole range.
    pub fn par_for(&self, count: usize, grain: usize, work: impl Fn(Range<usize>) + Sync) {
        if count == 0 {
            return;
        }
        #[cfg(feature = "parallel")]
        if let Some((team, recruit)) = self.team.filter(|_| count > grain) {
            let pieces = team.threads() * PIECES_PER_THREAD;
            let piece = count.div_ceil(pieces).next_multiple_of(grain.max(1));
            // SAFETY: a `Tasks` stays with the thread that opened it, and work that can be shared does not
            // hold one.
            return unsafe { team.run(count, piece, &work, recruit) };
        }
        let _ = grain; // One thread needs no grain.
        work(0..count);
    }

    /// Fills each element with the result of `make` for its index. `grain` is that of [`Self::par_for`].
    pub fn par_fill<T: Send + Sync>(
        &self,
        places: &mut [T],
        grain: usize,
        make: impl Fn(usize) -> T + Sync,
    ) {
        let (count, places) = (places.len(), DisjointMut::new(places));
        self.par_for(count, grain, |range| {
            for index in range {
                // SAFETY: each index is handed out once.
                unsafe { *places.get_mut(index) = make(index) };
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::Tasks;
    use std::sync::Mutex;

    /// The ranges that `par_for` hands out, in order of their start.
    fn ranges(tasks: Tasks<'_>, count: usize, grain: usize) -> Vec<(usize, usize)> {
        let ranges = Mutex::new(Vec::new());
        tasks.par_for(count, grain, |range| ranges.lock().unwrap().push((range.start, range.end)));
        let mut ranges = ranges.into_inner().unwrap();
        ranges.sort_unstable();
        ranges
    }

    fn check_cover(tasks: Tasks<'_>) {
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
        assert_eq!(ranges(Tasks::SERIAL, 1000, 1), [(0, 1000)]);
        check_cover(Tasks::SERIAL);
    }

    #[test]
    fn every_item_is_worked_on_once() {
        Tasks::open(check_cover);
    }

    #[test]
    fn each_place_gets_its_own_value() {
        let mut places = vec![0; 1000];
        Tasks::open(|tasks| tasks.par_fill(&mut places, 3, |index| index * index));
        assert!(places.iter().enumerate().all(|(index, &place)| place == index * index));
    }

    #[cfg(feature = "parallel")]
    mod pools {
        use super::*;
        use crate::base::tasks::Threads;
        use std::panic::{AssertUnwindSafe, catch_unwind, panic_any};
        use std::sync::Arc;
        use std::sync::atomic::{AtomicUsize, Ordering};
        use std::sync::mpsc::channel;

        fn pool(threads: usize) -> rayon::ThreadPool {
            rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap()
        }

        #[test]
        fn work_runs_in_the_pool_of_the_caller() {
            for threads in [1, 2, 3, 70] {
                pool(threads).install(|| {
                    Tasks::open(|tasks| {
                        check_cover(tasks);
                        assert_eq!(ranges(tasks, 1000, 1).len() > 1, threads > 1);
                        tasks.par_for(1000, 1, |_| {
                            assert_eq!(rayon::current_num_threads(), threads);
                        });
                    });
                });
            }
        }

        #[test]
        fn threads_of_a_pipeline_help() {
            for count in [1, 2, 5] {
                Threads::new(count).unwrap().open(|tasks| {
                    check_cover(tasks);
                    assert_eq!(ranges(tasks, 1000, 1).len() > 1, count > 1);
                });
            }
            let pool = Arc::new(pool(2));
            Threads::of_pool(Arc::clone(&pool)).open(check_cover);
            pool.install(|| Threads::of_pool(Arc::clone(&pool)).open(check_cover));
        }

        /// Serial stretches between loops, longer and shorter than workers poll.
        #[test]
        fn loops_follow_each_other() {
            let mut sums = vec![0_usize; 500];
            pool(4).install(|| {
                Tasks::open(|tasks| {
                    for turn in 0..2000 {
                        let old = sums.clone();
                        tasks.par_fill(&mut sums, 8, |index| old[index] + index * turn);
                        if turn % 500 == 0 {
                            std::thread::sleep(core::time::Duration::from_millis(2));
                        }
                    }
                });
            });
            let turns: usize = (0..2000).sum();
            assert!(sums.iter().enumerate().all(|(index, &sum)| sum == index * turns));
        }

        #[test]
        fn a_panic_comes_back_when_the_others_are_done() {
            pool(3).install(|| {
                Tasks::open(|tasks| {
                    let visits = AtomicUsize::new(0);
                    let panic = catch_unwind(AssertUnwindSafe(|| {
                        tasks.par_for(64, 1, |range| {
                            visits.fetch_add(range.len(), Ordering::Relaxed);
                            assert!(!range.contains(&40), "found 40");
                        });
                    }));
                    assert!(panic.unwrap_err().downcast_ref::<&str>() == Some(&"found 40"));
                    assert_eq!(visits.into_inner(), 64);
                    check_cover(tasks);
                });
            });
        }

        /// A user's hook may use the pool in which the step runs.
        #[test]
        fn work_may_use_the_pool() {
            pool(3).install(|| {
                Tasks::open(|tasks| {
                    for _ in 0..100 {
                        tasks.par_for(30, 1, |range| {
                            let sum = rayon::join(|| range.start, || range.len());
                            assert_eq!(sum.0 + sum.1, range.end);
                        });
                    }
                });
            });
        }

        /// All threads of the pool wait for the step that was opened outside: it must not wait for them.
        #[test]
        fn a_step_does_not_wait_for_threads_that_are_busy() {
            let (release, gate) = channel::<()>();
            let gate = Arc::new(Mutex::new(gate));
            let (began, begun) = channel();
            for _ in 0..rayon::current_num_threads() {
                let (gate, began) = (Arc::clone(&gate), began.clone());
                rayon::spawn(move || {
                    began.send(()).unwrap();
                    let _ = gate.lock().unwrap().recv();
                });
            }
            (0..rayon::current_num_threads()).for_each(|_| begun.recv().unwrap());
            let (done, end) = channel();
            std::thread::spawn(move || {
                Tasks::open(check_cover);
                done.send(()).unwrap();
            });
            let in_time = end.recv_timeout(core::time::Duration::from_secs(20));
            drop(release);
            in_time.expect("the step waits for the pool");
        }

        /// The payload of a panic may panic when it is dropped. No thread may wait for pieces that ended so.
        #[test]
        fn panics_may_carry_anything() {
            struct Bomb;

            impl Drop for Bomb {
                fn drop(&mut self) {
                    assert!(std::thread::panicking(), "dropped");
                }
            }

            pool(2).install(|| {
                Tasks::open(|tasks| {
                    let work = |_| panic_any(Bomb);
                    let panic =
                        catch_unwind(AssertUnwindSafe(|| tasks.par_for(64, 1, work))).unwrap_err();
                    assert!(panic.is::<Bomb>());
                    core::mem::forget(panic);
                    check_cover(tasks);
                });
            });
        }

        /// Several worlds in one pool, each stepped by a thread of it.
        #[test]
        fn steps_share_a_pool() {
            pool(3).install(|| {
                rayon::scope(|scope| {
                    for _ in 0..20 {
                        scope.spawn(|_| Tasks::open(check_cover));
                    }
                });
            });
        }
    }
}
