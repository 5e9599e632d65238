//! Vehicles: the physics of cars.
//!
//! As in `tests/physics/`, each test states a formula and a tolerance for each length of an update, and
//! prints the figures.

mod stage;

mod grip;
mod ground;
mod hostile;
mod parking;
mod rolling;
mod rough;
mod sleeping;
mod suspension;
