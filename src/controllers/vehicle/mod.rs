//! # Ray-cast vehicles
//!
//! Each wheel casts a ray from its position on the chassis. The forces of its suspension and tyre act on the
//! chassis and the ground. Wheels have no mass and no shape, so nothing can tear them off or make them shake,
//! and a car costs one ray per wheel. (A common model; an account of a game that uses it is Jared Cone, "It
//! IS Rocket Science! The Physics of Rocket League Detailed", GDC 2018.)
//!
//! One update, in this order:
//!
//! 1. [`place`](self::place): the pose of each wheel, and its ray-cast result.
//! 2. [`disturbance_observer`]: external loads on the chassis since the last update, such as gravity. They
//!    will probably act again.
//! 3. [`ground`]: the ground below the wheels, and its compliance.
//! 4. [`contact`], [`spring`], [`grip`]: per wheel on the ground one spring, which only pushes, and two rows
//!    of friction with one bound. They are solved together by projected Gauss–Seidel iteration ([`solve`]).
//! 5. [`spin`]: the wheels turn.
//! 6. The impulses become pushes: forces that last for the next step alone.
//!
//! A vehicle that sleeps does the first alone ([`rest`]).
//!
//! **Why pushes.** An impulse before a step acts at once, while gravity acts gradually. The impulses of a
//! standing car would be compensated only at the end of the step, and the body would report a wrong speed. A
//! force that acts as long as gravity does cancels it at all times, and a standing car has no velocity.
//!
//! **Why an observer.** Friction prevents motion that would begin *during* the step, so the solver needs the
//! external loads. The condition applies to the velocities at the end of the step.

mod check;
mod contact;
mod controller;
mod disturbance_observer;
mod grip;
mod ground;
mod place;
mod rest;
mod solve;
mod spin;
mod spring;
mod wheel;

pub use controller::DynamicRayCastVehicleController;
pub use wheel::{RayCastInfo, Wheel, WheelTuning};
