//! The threads that worlds are stepped with.
//!
//! This engine and Rapier use those of the rayon pool in which they are called, so whoever runs them does it in one of the right size.
//! Box2D and Box3D start threads of their own.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::io;

/// A pool of so many threads.
pub fn of(threads: usize) -> io::Result<ThreadPool> {
    ThreadPoolBuilder::new().num_threads(threads).build().map_err(io::Error::other)
}
