//! 2D rigid-body physics: fast, deterministic and robust.
//!
//! This is not the crate of the same name on the registry: the page "Coming from Rapier" of the guide lists
//! the differences.
//!
//! ```
//! use rapier2d::prelude::*;
//!
//! let mut world = PhysicsWorld::new();
//! world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::cuboid(50.0, 1.0));
//! let ball = RigidBodyBuilder::dynamic().translation(vector![0.0, 10.0]);
//! let (ball, _) = world.insert(ball, ColliderBuilder::ball(1.0));
//! for _ in 0..300 {
//!     world.step();
//! }
//! let y = world.bodies[ball].translation().y;
//! assert!((y - 2.0).abs() < 0.01, "the ball came to rest on the ground, not at {y}");
//! ```
//!
//! * A [`RigidBody`](dynamics::RigidBody) moves; [`Collider`](geometry::Collider)s give it shape, mass,
//!   friction and restitution. Builders describe both, sets own them, handles identify them.
//! * A [`PhysicsWorld`](pipeline::PhysicsWorld) owns all parts. A program that owns the parts itself
//!   passes them to [`PhysicsPipeline::step`](pipeline::PhysicsPipeline::step).
//! * [`IntegrationParameters`](dynamics::IntegrationParameters) set the length and the accuracy of a step.
//! * An [`EventHandler`](pipeline::EventHandler) receives events, [`PhysicsHooks`](pipeline::PhysicsHooks)
//!   filter and modify contacts.
//! * Any consistent units work: metres, kilograms and seconds, for example. Angles are in
//!   radians. Worlds whose bodies are not about 1 unit in size set
//!   [`length_unit`](dynamics::IntegrationParameters::length_unit).
//!
//! # Promises
//!
//! * The same world and the same calls give the same bits on every machine. The number of threads and the
//!   width of the registers have no effect.
//! * No value makes a function of this crate panic or corrupts other bodies. Invalid values are refused with
//!   an error, or ignored with a warning through the `log` crate. Only indexing a set with a stale handle
//!   panics. The re-exported constructors of the geometry library panic on some values;
//!   [`ColliderBuilder::try_shape`](geometry::ColliderBuilder::try_shape) is the checked way.
//!
//! # Features
//!
//! `f64` computes in double precision, `parallel` on several threads, `serde-serialize` makes data
//! types serialisable, `debug-render` draws debug lines. `dim2`, `f32`, `std`, `simd-stable` and
//! `enhanced-determinism` are accepted for compatibility and have no effect.

// No value panics: exceptions give their reason (docs/panics.md).
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable)]
#![warn(clippy::todo, clippy::unimplemented, clippy::exit, clippy::string_slice)]

#[cfg(feature = "parry2d-f64")]
pub extern crate parry2d_f64 as parry;
#[cfg(not(feature = "parry2d-f64"))]
pub use ::parry;

/// The vectors and poses under `Vector` and `Pose`, from the crate that the geometry library uses.
pub use self::parry::glamx;

mod dim2;
use dim2 as dim; // the one line that decides the dimension

mod base;
mod model;
mod multibody;
mod collide;
mod step;
mod query;
mod controllers;
#[cfg(feature = "debug-render")]
mod debug_render;
mod api;

pub use api::{control, data, dynamics, geometry, math, pipeline, prelude};
