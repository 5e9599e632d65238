//! The engine as a WebAssembly module with plain exported functions, for the npm packages `rapier2d` and
//! `rapier3d`.
//!
//! One source serves both dimensions and both precisions: the features `dim2`, `dim3` and `f64` select them.
//! The TypeScript side is in `javascript/src`.
//!
//! The rules of the boundary:
//!
//! * Numbers are passed as numbers. Vectors, rotations and records travel through the scratch block of
//!   [`memory`], lists through its lists.
//! * A world, a shape, an event queue or a controller is a number that [`registry`] resolves. Handles of
//!   bodies, colliders and joints are the 64 bits of slot and generation, read as a number of JavaScript
//!   ([`handle`]).
//! * A function that fails ends in [`fault::Fault`], which the importing side throws as a `RapierError`. A
//!   failed call changes nothing.
//! * JavaScript runs while a world is borrowed only in callbacks: hooks of a step, and predicates and
//!   visitors of queries. [`registry`] refuses calls that would change the world meanwhile.

#[cfg(feature = "dim2")]
use rapier2d as rapier;
#[cfg(all(feature = "dim3", not(feature = "dim2")))]
use rapier3d as rapier;

#[macro_use]
mod exports;
#[cfg(target_arch = "wasm32")]
mod allocator;
mod fault;
mod handle;
mod host;
mod memory;
mod registry;
mod start;
mod body;
mod body_motion;
mod body_mass;
mod collider;
mod decomposition;
mod shape;
mod voxels;
mod query;
mod subject;
mod contact;
mod joint;
mod transmission;
mod controller;
#[cfg(not(feature = "dim2"))]
mod vehicle;
mod debug;
mod batch;
mod snapshot;
mod events;
mod hooks;
mod mirror;
mod world;
#[cfg_attr(not(feature = "threads"), path = "one_thread.rs")]
mod threads;
