//! Programs written for Rapier 0.32, with the results that formulas give.

mod contacts;
mod hooks;
mod joints;
mod queries;
mod removal;
mod world;
