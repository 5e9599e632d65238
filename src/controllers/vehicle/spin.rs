//! Spin of the wheels.
//!
//! Wheels have no mass, so their spin has no effect on the chassis. On the ground a wheel rolls. Its spin is
//! the ground velocity of the chassis divided by its radius, and its angle integrates the velocities before
//! and after the step. A locked wheel does not rotate. In the air it continues to rotate. If the engine
//! exceeds the grip of the tyre, or the wheel is in the air, the rest of its force accelerates the wheel. The
//! wheel is a solid disc of a [`WHEEL_MASS_FRACTION`] of the mass of the chassis. The brake slows it in the
//! air in the same way.

use super::contact::{Mover, WheelContact};
use super::wheel::Wheel;
use crate::dim::math::Real;

/// Mass of a wheel, with its part of the rotating engine, relative to the chassis.
const WHEEL_MASS_FRACTION: Real = 0.1;
/// A spin (rad/s) at which no engine goes any faster.
const SPIN_MAX: Real = 1.0e4;

impl Wheel {
    /// Change of spin per impulse at the rim: r / I with I = ½ M r².
    fn spin_of_impulse(&self, chassis_mass: Real) -> Real {
        let change = 2.0 / (WHEEL_MASS_FRACTION * chassis_mass * self.radius);
        if change.is_finite() { change } else { 0.0 }
    }

    fn turn(&mut self, spin: Real, dt: Real) {
        let spin = if spin.is_finite() { spin.clamp(-SPIN_MAX, SPIN_MAX) } else { 0.0 };
        self.spin = spin;
        let rotation = self.rotation + spin * dt;
        if rotation.is_finite() {
            self.rotation = rotation;
        }
    }

    /// Rotates the wheel in the air for `dt` seconds.
    pub(super) fn turn_in_air(&mut self, chassis_mass: Real, dt: Real) {
        let per_impulse = self.spin_of_impulse(chassis_mass);
        let driven = self.spin + self.engine_force * dt * per_impulse;
        // An infinite brake stops every wheel, including the wheels of a chassis without mass. No impulse
        // rotates those, and infinity times zero would be NaN.
        let braked = if self.brake.is_finite() { self.brake * per_impulse } else { self.brake };
        self.turn(driven - driven.clamp(-braked, braked), dt);
    }
}

impl WheelContact {
    /// Rotates a wheel on the ground for `dt` seconds.
    pub fn turn(&self, wheel: &mut Wheel, movers: [&Mover; 2], chassis_mass: Real, dt: Real) {
        let [chassis, ground] = movers;
        let before = self.forward.old_velocity(chassis, ground);
        let after = self.forward.velocity(chassis, ground);
        let rolling = 0.5 * (before + after) / wheel.radius;
        let given = self.forward.impulse;
        let excess = self.drive.excess(given);
        let spin = if !self.is_sliding {
            rolling
        } else if self.drive.is_locked(given) {
            0.0
        } else if excess != 0.0 {
            // Never slower than the ground below it.
            let faster = wheel.spin + excess * wheel.spin_of_impulse(chassis_mass);
            if excess > 0.0 { faster.max(rolling) } else { faster.min(rolling) }
        } else {
            rolling
        };
        wheel.turn(spin, dt);
    }
}
