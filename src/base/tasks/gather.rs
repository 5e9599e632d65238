//! Lists that are filled by several threads.

use super::Tasks;
use crate::base::pool::Pool;
use core::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Concatenates the results of threads for ranges of a loop, in the order of the ranges. Keeps its memory.
#[derive(Debug)]
pub struct Gather<T> {
    idle: Pool<Vec<T>>,
    /// Results, with the first index of each range.
    found: Mutex<Vec<(usize, Vec<T>)>>,
}

impl<T> Default for Gather<T> {
    fn default() -> Self {
        Self { idle: Pool::default(), found: Mutex::default() }
    }
}

impl<T: Send> Gather<T> {
    /// Appends to `list` the elements that `find` adds for each range, in the order of the ranges: see
    /// [`Tasks::par_for`].
    pub fn run(
        &mut self,
        tasks: Tasks<'_>,
        (count, grain): (usize, usize),
        find: impl Fn(Range<usize>, &mut Vec<T>) + Sync,
        list: &mut Vec<T>,
    ) {
        if tasks.are_alone() {
            return find(0..count, list);
        }
        // Results of a panicked loop may be left.
        self.found.get_mut().unwrap_or_else(PoisonError::into_inner).clear();
        let Self { idle, found } = &*self;
        tasks.par_for(count, grain, |range| {
            let mut part = idle.take();
            let start = range.start;
            find(range, &mut part);
            lock(found).push((start, part));
        });
        let mut found = lock(found);
        found.sort_unstable_by_key(|&(start, _)| start);
        for (_, mut part) in found.drain(..) {
            list.append(&mut part);
            idle.put(part);
        }
    }
}

fn lock<T>(of_all: &Mutex<T>) -> MutexGuard<'_, T> {
    of_all.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::super::Tasks;
    use super::Gather;

    #[test]
    fn results_are_in_order() {
        let (mut gather, mut list) = (Gather::default(), vec![7]);
        for _ in 0..3 {
            list.truncate(1);
            let odd = |range: core::ops::Range<usize>, part: &mut Vec<usize>| {
                part.extend(range.filter(|n| n % 2 == 1));
            };
            Tasks::open(|tasks| gather.run(tasks, (1001, 10), odd, &mut list));
            assert!(list.iter().copied().eq([7].into_iter().chain((1..1001).step_by(2))));
        }
    }
}
