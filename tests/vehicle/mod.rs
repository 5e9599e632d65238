//! Vehicles: the physics of cars.
//!
//! As in `tests/physics/`, each test states a formula and how far from it an update of a given length may be,
//! and prints what came out.

mod stage;

mod grip;
mod ground;
mod hostile;
mod parking;
mod rolling;
mod rough;
mod sleeping;
mod suspension;
