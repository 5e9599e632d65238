//! Threads of the module: workers with the same memory run the threads of rayon's global pool.
//!
//! The thread that loads the module is one thread of the pool. It blocks on locks, so it is a worker's thread
//! or that of Node.js: browsers forbid the thread of a page to block. Each worker instantiates the module on
//! the shared memory, with a stack and thread-local storage of its own.

use crate::fault::{Fault, Kind};
use crate::rapier::pipeline::{PhysicsWorld, Threads};
use std::alloc::{Layout, alloc_zeroed};
use std::sync::{Condvar, Mutex, PoisonError};

/// Threads of the pool without a worker, and the signal that one was added.
static WAITING: Mutex<Vec<rayon::ThreadBuilder>> = Mutex::new(Vec::new());
static ADDED: Condvar = Condvar::new();

/// Steps a world on one thread while hooks exist: JavaScript runs on the thread that loads the module.
pub fn choose(world: &mut PhysicsWorld, has_hooks: bool) {
    let threads = match has_hooks {
        true => Threads::new(1).unwrap_or_default(),
        false => Threads::default(),
    };
    world.physics_pipeline.set_threads(threads.clone());
    world.collision_pipeline.set_threads(threads);
}

/// Returns whether a worker runs the calling thread. Such a thread does not use the cells of
/// [`memory`](crate::memory).
pub fn is_worker() -> bool {
    rayon::current_thread_index().is_some_and(|index| index != 0)
}

exports! {
    /// Creates the pool. The calling thread is one of its threads. Each other one is run by a worker, which
    /// is in `thread_run` already: the call returns when all threads run.
    fn threads_create(count: u32) {
        rayon::ThreadPoolBuilder::new()
            .num_threads(count as usize)
            .use_current_thread()
            .spawn_handler(|thread| {
                WAITING.lock().unwrap_or_else(PoisonError::into_inner).push(thread);
                ADDED.notify_one();
                Ok(())
            })
            .build_global()
            .map_err(|error| Fault::new(Kind::InvalidValue, format!("threads cannot be created: {error}")))?;
    }

    /// The number of threads that work on a step of the calling thread.
    fn threads_count() -> u32 {
        rayon::current_num_threads() as u32
    }

    /// Reserves memory for the stack or the thread-local storage of a worker, for as long as the module
    /// exists. Returns the address, or 0 if the memory cannot supply the bytes: the module may not be the
    /// engine yet, so nothing is thrown.
    fn thread_memory(bytes: u32, align: u32) -> u32 {
        // SAFETY: the size is at least one.
        Layout::from_size_align(bytes.max(1) as usize, align.max(1) as usize).map_or(0, |layout| unsafe { alloc_zeroed(layout) } as u32)
    }

    /// Waits for a thread of the pool, and runs it until the pool ends.
    fn thread_run() {
        let waiting = WAITING.lock().unwrap_or_else(PoisonError::into_inner);
        let mut waiting = ADDED.wait_while(waiting, |waiting| waiting.is_empty()).unwrap_or_else(PoisonError::into_inner);
        let thread = waiting.pop();
        drop(waiting);
        if let Some(thread) = thread {
            thread.run();
        }
    }
}
