//! # Controllers: characters, vehicles and PID
//!
//! A controller reads the world through queries. Characters and PID controllers return a motion: a
//! translation, a velocity. Vehicles apply impulses. The step is independent of controllers. Controllers use
//! the public interface of the engine, and characters also its contact generation.
//!
//! * [`character`]: walking characters. The controller determines the admissible translation of a shape.
//! * [`pid`]: PD and PID controllers. They determine the change of velocity that moves a body to a target
//!   pose.
//! * `vehicle/`: ray-cast vehicles, in 3D only. `dim3/mod.rs` declares the module.
//!
//! Controllers contain settings, and state from call to call. They own no bodies and no colliders; a vehicle
//! stores the handles of its chassis and of the ground. So one character controller can move many characters,
//! and a world can be saved without controllers.

pub mod character;
pub mod pid;
mod world_access;

pub use world_access::QueryPipelineMut;
