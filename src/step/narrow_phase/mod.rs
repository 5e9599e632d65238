//! # Narrow phase: contact manifolds of pairs
//!
//! Reads:   collider poses and shapes, bounds on the motion of bodies, last step's manifolds
//! Writes:  manifolds of awake pairs; notes of computed pairs and of bodies deep in a wall
//! Runs:    parallel over pairs; notes of pairs are in the order of the colliders, notes of bodies in any
//!     order
//! Never:   moves a body; links islands; assigns colours
//!
//! Most pairs of a settled pile have moved little since their manifolds were computed. Each awake pair has
//! *slack*: the relative motion of its bodies up to which it need not be computed again. Each step subtracts
//! a bound on the relative motion of the two bodies, which costs two loads. Only pairs whose slack is used up
//! are checked: [`update`].

mod contact;
mod faults;
mod anchors;
mod recycle;
mod ghost_contacts;
mod sensor;
mod update;
mod view;

pub(crate) use update::{NarrowPhaseContext, NarrowPhaseScratch, update};
