//! # Controllers: characters, vehicles and PID
//!
//! A controller reads the world through queries and returns a motion: a velocity, a translation, an impulse.
//! The step is independent of controllers, and a controller uses only the public interface of the engine.
//!
//! * [`character`]: walking characters. The controller determines the admissible translation of a shape.
//! * [`pid`]: PD and PID controllers. They determine the change of velocity that moves a body to a target
//!   pose.
//! * `vehicle/`: ray-cast vehicles, in 3D only. `dim3/mod.rs` declares the module.
//!
//! Controllers contain settings, and state from call to call; they own no bodies, no colliders and no
//! handles. So one controller can move many characters, and a world can be saved without it.

pub mod character;
pub mod pid;
mod world_access;

pub use world_access::QueryPipelineMut;
