//! # Multibody: dynamics of articulated bodies
//!
//! Dynamics of a single [`Multibody`](crate::model::multibody::Multibody): poses of its links, inertia and
//! response. It is independent of contacts and of the world, and of the time step except in [`Motion`]; the
//! solver combines them.
//!
//! ## Notation
//! The state is `q` (coordinates) and `q̇` (velocities of the degrees of freedom). A link's spatial velocity
//! `v` is that of its centre of mass and its angular velocity. Its wrench `f` is a force at the centre of
//! mass and a torque about it. Both are in world axes. In these, a link's inertia is `diag(m, m, m, I)`. The
//! only change of frame is a shift by the vector `r` from the parent's centre of mass to the link's:
//!
//! ```text
//! v = X v_parent + Σ sⱼ q̇ⱼ        X: (v, ω) ↦ (v + ω × r, ω)        Xᵀ: (F, N) ↦ (F, N + r × F)
//! ```
//!
//! with the *axis* `sⱼ` of each degree of freedom of the link's joint: the spatial velocity that `q̇ⱼ = 1`
//! gives the link. Moment arms are summed from rotations alone, so a robot far from the origin is as accurate
//! as one at the origin.
//!
//! ## Algorithms
//! | file | content | source |
//! |---|---|---|
//! | `kinematics.rs` | poses, moment arms, axes, velocities, Jacobians | |
//! | `factor.rs` | `M⁻¹ τ` in `O(n)`: the articulated-body algorithm, as a factorisation | Featherstone 2008, chapter 7 |
//! | `bias.rs` | `C(q, q̇) q̇` in `O(n)`: recursive Newton–Euler | Featherstone 2008, chapter 5 |
//! | `mass_matrix.rs` | `M` in `O(n²)`: composite rigid bodies | Featherstone 2008, chapter 6 |
//! | `motion/` | one substep without contacts | Hairer, Lubich, Wanner 2006, chapter VI |
//! | `locked_inertia.rs` | all links as one rigid body; a change of shape conserves its momentum | Marsden, Ratiu 1999 |
//! | `trajectory.rs` | motion of the links in a step, and its reversal up to a time of impact | |
//! | `inverse.rs` | `q` for a given pose of a link | Buss 2004 |
//!
//! Featherstone's articulated-body algorithm computes accelerations from forces in three passes. The engine
//! splits it into a part that depends on the configuration only and a part that depends on the forces. The
//! *factorisation* is made once per configuration. It then gives accelerations and velocities for any number
//! of forces and impulses, including contacts.
//!
//! Sources: Featherstone, "Rigid Body Dynamics Algorithms" (2008).

mod bias;
mod trajectory;
mod factor;
mod inverse;
mod kinematics;
mod mass_matrix;
mod motion;
mod spatial;
mod sync;
#[cfg(test)]
mod tests;
mod locked_inertia;

pub use inverse::InverseKinematicsOption;
pub(crate) use mass_matrix::usable;
pub(crate) use motion::{JointLoad, LinkForce, Motion};
pub(crate) use trajectory::LinkSample;
