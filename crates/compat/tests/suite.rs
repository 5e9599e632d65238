//! Programs written for Rapier 0.32 and 0.36, with the results that formulas give.

mod contacts;
mod hooks;
mod joints;
mod programs;
mod queries;
mod removal;
mod version;
mod world;
