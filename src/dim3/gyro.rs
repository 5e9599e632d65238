//! The tumbling of free bodies: torque-free rotation, in 3D.
//!
//! Between impulses a body keeps its angular momentum `L`, not its angular velocity: as it turns, its
//! inertia turns with it, and `ω = I⁻¹ L` changes. We take the velocity of the middle of the substep
//! (from the orientation that the old velocity reaches by then) through the solver and turn the body
//! by it. So `L` is constant to rounding and the energy error is of second order and bounded.
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
    moments: Vector,
    inv_moments: Vector,
    frame: Rotation,
    /// Orientation in the middle of the substep, for which the solver's angular velocity holds.
    middle: Rotation,
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
        let frame = mass.principal_inertia_local_frame;
        Some(Self { moments: inv_moments.recip(), inv_moments, frame, middle: Rotation::IDENTITY })
    }

    fn momentum(&self, rotation: Rotation, angvel: AngVector) -> AngVector {
        let to_world = rotation * self.frame;
        to_world * (self.moments * (to_world.inverse() * angvel))
    }

    fn velocity(&self, rotation: Rotation, momentum: AngVector) -> AngVector {
        let to_world = rotation * self.frame;
        to_world * (self.inv_moments * (to_world.inverse() * momentum))
    }

    /// The angular velocity in the middle of a substep that begins with `angvel`.
    pub fn velocity_at_middle(
        &mut self,
        rotation: Rotation,
        angvel: AngVector,
        h: Real,
    ) -> AngVector {
        let momentum = self.momentum(rotation, angvel);
        self.middle = integrate_rotation(rotation, angvel * (0.5 * h));
        self.velocity(self.middle, momentum)
    }

    /// The angular velocity at the end of the substep, at the orientation `end`.
    pub fn velocity_at_end(&self, end: Rotation, angvel: AngVector) -> AngVector {
        let momentum = self.momentum(self.middle, angvel);
        self.velocity(end, momentum)
    }
}
