//! Characters: admissible moves of a shape that walks.
//!
//! A character is kinematic: the user moves it, and no force does.
//! [`KinematicCharacterController::move_shape`] computes the part of a desired translation that keeps an
//! offset from all obstacles. It uses *planes*, a method that Quake made popular and that Box2D 3 describes
//! as its "plane solver":
//!
//! 1. **Recover** ([`recover`]). If the shape is closer to an obstacle than the offset, because the obstacle
//!    moved, push it out by the smallest sufficient translation.
//! 2. **Contacts** ([`obstacles`], [`touch`], [`planes`]). Every contact manifold near the shape is a plane
//!    that the shape must stay in front of. `plane_pruning.rs` removes redundant planes, so that level tiles
//!    and the triangles of a mesh have no internal edges.
//! 3. **Solve** ([`solve`]). Direct the desired translation along the floor, remove its components into
//!    walls, and project it onto the polyhedron of all planes ([`polyhedron`], exactly).
//! 4. **Sweep** ([`sweep`]). Move until a new obstacle, and repeat with the rest of the desired translation.
//! 5. **Step up** ([`stairs`]) at low obstacles, and **step down** ([`descent`]) to a floor a little below
//!    the one just left.
//!
//! This has three consequences. *A resting character does not move*: planes at the offset, within a
//! tolerance, count as exactly there. A standing character therefore moves by zero and not by a rounding
//! error. *Floors support vertically*: on a walkable floor, gravity has no component along the slope.
//! *Unwalkable walls count as upright*, independent of their slope, for horizontal motion.
//!
//! References: E. Catto, "Character mover" (Box2D 3.1 documentation); M. Abrash and J. Carmack's clip planes
//! as described in K. Fauerby, "Improved Collision detection and Response" (2003), whose sliding loop this
//! is, with contacts in place of ellipsoids.

mod descent;
mod hooks;
mod impulses;
mod length;
mod mover;
mod moves;
mod movement;
mod obstacles;
mod plane_pruning;
mod planes;
mod polyhedron;
mod recover;
mod resolved;
mod settings;
mod solve;
mod stairs;
mod sweep;
mod touch;

pub use hooks::{CharacterContacts, CharacterHooks};
pub use length::CharacterLength;
pub use movement::{CharacterCollision, CharacterGround, EffectiveCharacterMovement};
pub use settings::{CharacterAutostep, CharacterSlopeSpeed, KinematicCharacterController};
