//! # Controllers: characters, vehicles and PID
//!
//! A controller reads the world through queries and returns a motion: a velocity, a translation, an impulse.
//! It is a user of the engine that happens to live in it. The step is independent of controllers, and a
//! controller uses only the public interface of the step.
//!
//! * [`character`]: walking characters. It determines the admissible translation of a shape.
//! * [`pid`]: a hand that leads a body to a pose. It determines the velocity for a target.
//!
//! Controllers contain settings, and state from call to call; they own no bodies, no colliders and no
//! handles. So one controller can lead a crowd, and a world can be saved without it.

pub mod character;
pub mod pid;
mod world_access;

pub use world_access::QueryPipelineMut;
