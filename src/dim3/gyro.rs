//! The tumbling of free bodies: torque-free rotation, in 3D.
//!
//! Between impulses a body keeps its angular momentum `L`, not its angular velocity: as it turns, its
//! inertia turns with it, and `ω = I⁻¹ L` changes. We take the velocity of the middle of the substep
//! (from the orientation that the old velocity reaches by then) through the solver and turn the body
//! by it. So `L` is constant to rounding and the energy error is of second order and bounded.
//!
//! An impulse acts where the substep begins: that is where joints take their levers and inertias from. A change `Δω`
//! of the middle's velocity is therefore one of `L` by `I Δω` with the inertia of the beginning. With that of the
//! middle, thin limbs that hang from each other gain some per cent of their energy in ten seconds.
//!
//! The implicit Euler step of Catto, "Numerical Methods" (GDC 2015), is as stable but dissipates;
//! explicit Euler, `ω ← ω - h I⁻¹ (ω × I ω)`, gains energy until it explodes.

use super::math::{AngVector, Real, Rotation, Vector, integrate_rotation};
use parry::mass_properties::MassProperties;

/// Moments that differ by less than this share make no visible difference.
const ISOTROPY: Real = 1.0e-3;
/// A body that turns by less than this (rad) in a substep does not tumble.
const TURN_MIN: Real = 1.0e-4;

/// What it takes to let a body tumble.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Gyroscope {
    inv_moments: Vector,
    frame: Rotation,
    /// Orientation at the beginning of the substep, where the solver's impulses act.
    start: Rotation,
    /// The angular momentum. It is carried from substep to substep rather than computed from the
    /// velocity each time: what rounding does to it on average goes in one direction, and 240 steps a
    /// second in `f32` made of it 5 % of the energy in a minute.
    momentum: AngVector,
    /// The angular velocity that goes with it.
    angvel: AngVector,
}

impl Gyroscope {
    /// `None` for bodies that need it not: round ones, and those that hardly turn in `h` seconds.
    pub fn new(mass: &MassProperties, angvel: AngVector, h: Real) -> Option<Self> {
        let inv_moments = mass.inv_principal_inertia;
        let (low, high) = (inv_moments.min_element(), inv_moments.max_element());
        if low <= 0.0 || high - low < ISOTROPY * high {
            return None;
        }
        if angvel.length_squared() * h * h < TURN_MIN * TURN_MIN {
            return None;
        }
        let (momentum, angvel) = (AngVector::ZERO, AngVector::ZERO);
        let (frame, start) = (mass.principal_inertia_local_frame, Rotation::IDENTITY);
        Some(Self { inv_moments, frame, start, momentum, angvel })
    }

    /// Somebody changed the angular velocity at the orientation `rotation`.
    fn take_in(&mut self, rotation: Rotation, angvel: AngVector) {
        let to_world = rotation * self.frame;
        let change = rotate(to_world.conjugate(), angvel - self.angvel) / self.inv_moments;
        self.momentum += rotate(to_world, change);
    }

    /// The angular velocity at the orientation `rotation`.
    fn turn_to(&mut self, rotation: Rotation) -> AngVector {
        let to_world = rotation * self.frame;
        let momentum = rotate(to_world.conjugate(), self.momentum);
        self.angvel = rotate(to_world, momentum * self.inv_moments);
        self.angvel
    }

    /// The angular velocity in the middle of a substep that begins with `angvel`.
    pub fn velocity_at_middle(
        &mut self,
        rotation: Rotation,
        angvel: AngVector,
        h: Real,
    ) -> AngVector {
        self.take_in(rotation, angvel);
        self.start = rotation;
        self.turn_to(integrate_rotation(rotation, angvel * (0.5 * h)))
    }

    /// The angular velocity at the end of the substep, at the orientation `end`, if it is `angvel` in
    /// the middle.
    pub fn velocity_at_end(&mut self, end: Rotation, angvel: AngVector) -> AngVector {
        self.take_in(self.start, angvel);
        self.turn_to(end)
    }
}

/// `q v q⁻¹` for a quaternion of any length.
///
/// Normalised quaternions are off from unit length by some rounding. A rotation that takes them for
/// units scales by their squared length.
fn rotate(q: Rotation, v: Vector) -> Vector {
    let axis = Vector::new(q.x, q.y, q.z);
    let t = axis.cross(v) * (2.0 / q.length_squared());
    v + t * q.w + axis.cross(t)
}
