//! Programs written for Rapier 0.32, with the results that formulas give.

#[cfg(feature = "dim2")]
extern crate rapier2d as rapier;
#[cfg(feature = "dim3")]
extern crate rapier3d as rapier;

mod contacts;
mod hooks;
mod joints;
mod queries;
mod removal;
mod world;
