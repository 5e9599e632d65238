//! The grip of a tyre: drive, brake and lateral grip within one friction circle.
//!
//! Friction at a wheel under the load N is at most µ N in all. (Coulomb's law is the "friction circle" of
//! tyres: Milliken and Milliken, "Race Car Vehicle Dynamics", 1995, chapter 2.) Its direction depends on the
//! state of the wheel. The wheel has no mass, so its torques balance. The impulse f of the ground along the
//! direction of rolling equals that of engine and brake. Let E be the impulse of the engine, and B the
//! maximum of the brake:
//!
//! * *It stands still, or is locked* while the brake is not at its maximum: |f − E| ≤ B. The tyre is then a
//!   block on the ground. It sticks if the impulse that stops it is within the circle, and otherwise slides
//!   with µ N against its velocity.
//! * *It rolls* otherwise, with f = E ± B. The rest of the circle is available for lateral grip: √((µ N)² −
//!   f²).
//! * *It spins* if E alone is more than the circle, and then has no lateral grip at all.

use crate::dim::math::Real;

/// Demand of engine and brake on the ground in one update, as impulses.
#[derive(Copy, Clone, Debug)]
pub(super) struct Drive {
    /// Impulse of the engine.
    pub engine: Real,
    /// Maximum impulse of the brake.
    pub brake: Real,
}

/// Friction impulse of the ground.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) struct Grip {
    /// The impulse along the direction of rolling.
    pub forward: Real,
    /// The impulse along the axle.
    pub side: Real,
    /// Whether the tyre is at the limit of its grip.
    pub is_sliding: bool,
}

impl Drive {
    /// The friction impulse if `forward` and `side` would stop the tyre, and `limit` is µ N.
    pub fn grip(&self, forward: Real, side: Real, limit: Real) -> Grip {
        let Self { engine, brake } = *self;
        let target = forward.clamp(engine - brake, engine + brake);
        let length = (target * target + side * side).sqrt();
        if length <= limit {
            return Grip { forward: target, side, is_sliding: false };
        }
        // As a block: against the slip, in the direction of the impulse that would stop it.
        let stop = (forward * forward + side * side).sqrt();
        let as_block = if stop > limit { forward * (limit / stop) } else { forward };
        let forward = as_block.clamp(engine - brake, engine + brake).clamp(-limit, limit);
        let rest = (limit * limit - forward * forward).max(0.0).sqrt();
        Grip { forward, side: side.clamp(-rest, rest), is_sliding: true }
    }

    /// The rest of the engine's impulse after braking, and the friction impulse.
    pub fn excess(&self, forward: Real) -> Real {
        let left = (self.engine.abs() - self.brake - forward.abs()).max(0.0);
        if self.engine < 0.0 { -left } else { left }
    }

    /// Returns whether the brake locks the wheel against the friction of the ground.
    pub fn is_locked(&self, forward: Real) -> bool {
        (forward - self.engine).abs() < self.brake
    }
}

#[cfg(test)]
mod tests {
    use super::{Drive, Grip};

    #[test]
    fn within_the_circle_all_is_given() {
        let drive = Drive { engine: 2.0, brake: 0.0 };
        let grip = drive.grip(-50.0, 3.0, 4.0);
        assert_eq!(grip, Grip { forward: 2.0, side: 3.0, is_sliding: false });
    }

    #[test]
    fn a_brake_takes_no_more_than_it_needs_and_holds_no_more_than_it_can() {
        let drive = Drive { engine: 0.0, brake: 5.0 };
        assert_eq!(drive.grip(-3.0, 0.0, 10.0).forward, -3.0);
        assert_eq!(drive.grip(-8.0, 0.0, 10.0).forward, -5.0);
        assert!(drive.is_locked(-3.0) && !drive.is_locked(-5.0));
    }

    #[test]
    fn a_locked_wheel_slides_against_its_velocity() {
        let drive = Drive { engine: 0.0, brake: 100.0 };
        let grip = drive.grip(-30.0, 40.0, 5.0);
        assert_eq!(grip, Grip { forward: -3.0, side: 4.0, is_sliding: true });
        assert!(drive.is_locked(grip.forward));
    }

    #[test]
    fn the_side_gets_the_remainder() {
        let rolling = Drive { engine: 3.0, brake: 0.0 }.grip(0.0, 40.0, 5.0);
        assert_eq!(rolling, Grip { forward: 3.0, side: 4.0, is_sliding: true });
        let spinning = Drive { engine: 9.0, brake: 0.0 }.grip(0.0, 40.0, 5.0);
        assert_eq!(spinning, Grip { forward: 5.0, side: 0.0, is_sliding: true });
        let in_the_air = Drive { engine: 9.0, brake: 1.0 }.grip(1.0, 1.0, 0.0);
        assert_eq!(in_the_air, Grip { forward: 0.0, side: 0.0, is_sliding: true });
        let straight = Drive { engine: 9.0, brake: 0.0 }.grip(0.0, 0.0, 5.0);
        assert_eq!(straight, Grip { forward: 5.0, side: 0.0, is_sliding: true });
    }
}
