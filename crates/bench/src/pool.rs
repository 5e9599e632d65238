//! Threads of the stepped worlds.
//!
//! This engine and Rapier use the threads of the calling rayon pool, so each run is installed in a pool of
//! the right size. Box2D and Box3D start their own threads.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::io;

/// Creates a pool with this number of threads.
pub fn of(threads: usize) -> io::Result<ThreadPool> {
    ThreadPoolBuilder::new().num_threads(threads).build().map_err(io::Error::other)
}
