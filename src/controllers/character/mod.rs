//! Somebody who walks: where may a shape go that wants to go somewhere?
//!
//! A character is kinematic: no force moves it, the user does. [`KinematicCharacterController::move_shape`] says which part
//! of a wished translation is possible without coming closer to anything than an offset. It moves on *planes*, in the
//! manner that Quake made popular and Box2D 3 describes as its "plane solver":
//!
//! 1. **Recover** ([`recover`]). Where the shape is closer to something than the offset, because that moved, push it out by
//!    the smallest translation that does.
//! 2. **Look** ([`obstacles`], [`touch`], [`planes`]). Every contact manifold near the shape is a plane that the shape must stay
//!    in front of. `plane_pruning.rs` leaves out planes that another one makes needless: that is what keeps flush tiles and the
//!    triangles of a mesh from being felt.
//! 3. **Solve** ([`solve`]). Turn the wish along the floor, take away what goes into walls, and project it onto the polyhedron
//!    of all planes ([`polyhedron`], exactly).
//! 4. **Sweep** ([`sweep`]). Go there until something new is in the way; then look again, with what is left of the wish.
//! 5. **Step up** ([`stairs`]) where what blocks is low, and **snap** down to a floor that was just lost.
//!
//! Three things follow. *Who has nothing to do does nothing*: planes at the offset, give or take a tolerance, count as
//! exactly there, so that a standing character moves by zero and not by a rounding error. *Floors hold up vertically*: on a
//! floor that one can stand on, gravity has no part along the slope. *Walls that one cannot climb are
//! upright*, whatever their slope, for whoever walks into them.
//!
//! References: E. Catto, "Character mover" (Box2D 3.1 documentation); M. Abrash and J. Carmack's clip planes as described in
//! K. Fauerby, "Improved Collision detection and Response" (2003), whose sliding loop this is, with contacts in place of
//! ellipsoids.

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
