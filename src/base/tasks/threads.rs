//! Threads of a step: a setting of the pipelines.

use super::Tasks;
#[cfg(feature = "parallel")]
use super::team::{THREADS_MAX, WorkerTeam};
#[cfg(feature = "parallel")]
use std::sync::Arc;

/// Threads of a step.
///
/// The default is the rayon pool of the thread that calls the step. Outside of any pool, that is rayon's
/// global pool, by default with one thread per core. Batches of thousands of rays always use this default.
/// The number of threads does not change a bit of the results. Without the feature `parallel`, the calling
/// thread alone runs the step.
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut world = PhysicsWorld::new();
/// world.physics_pipeline.set_threads(Threads::new(2)?);
/// world.step();
/// # Ok::<(), ThreadsError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Threads {
    #[cfg(feature = "parallel")]
    selection: Option<Selection>,
}

/// The selected threads.
#[cfg(feature = "parallel")]
#[derive(Clone, Debug)]
enum Selection {
    CallingThread,
    /// A pool, and the number of threads including the calling thread.
    Pool(Arc<rayon::ThreadPool>, usize),
}

/// Error of the system when it creates threads.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{count} threads cannot be created: {reason}")]
pub struct ThreadsError {
    /// The requested number.
    pub count: usize,
    /// The system's error.
    pub reason: String,
}

impl Threads {
    /// A worker team of its own with `count` threads, the calling thread included; 0 selects one per core. At
    /// most 64 threads are used.
    ///
    /// The workers live as long as this value and its clones, and sleep between steps.
    ///
    /// # Errors
    /// If the system cannot create the threads.
    #[cfg(feature = "parallel")]
    pub fn new(count: usize) -> Result<Self, ThreadsError> {
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        let count = if count == 0 { cores() } else { count }.min(THREADS_MAX);
        if count == 1 {
            return Ok(Self { selection: Some(Selection::CallingThread) });
        }
        let workers = rayon::ThreadPoolBuilder::new().num_threads(count - 1);
        let pool = workers.thread_name(|index| format!("physics {}", index + 1)).build();
        let pool = pool.map_err(|error| ThreadsError { count, reason: error.to_string() })?;
        Ok(Self { selection: Some(Selection::Pool(Arc::new(pool), count)) })
    }

    /// The calling thread alone. Other threads require the feature `parallel`.
    ///
    /// # Errors
    /// None.
    #[cfg(not(feature = "parallel"))]
    pub fn new(_count: usize) -> Result<Self, ThreadsError> {
        Ok(Self {})
    }

    /// As many threads as a pool has: the calling thread, which need not belong to the pool, and workers of
    /// the pool. Idle workers take part in a step; a step does not wait for busy ones.
    #[cfg(feature = "parallel")]
    pub fn of_pool(pool: Arc<rayon::ThreadPool>) -> Self {
        let count = pool.current_num_threads();
        Self { selection: Some(Selection::Pool(pool, count)) }
    }

    /// Calls `work` with these threads.
    pub(crate) fn open<R>(&self, work: impl FnOnce(Tasks<'_>) -> R) -> R {
        #[cfg(feature = "parallel")]
        match &self.selection {
            Some(Selection::CallingThread) => return work(Tasks::SERIAL),
            Some(Selection::Pool(pool, count)) => {
                let recruit = |team: Arc<WorkerTeam>, number| pool.spawn(move || team.help(number));
                return Tasks::open_with(*count, recruit, work);
            }
            None => {}
        }
        Tasks::open(work)
    }
}
