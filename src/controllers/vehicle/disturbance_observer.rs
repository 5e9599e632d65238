//! External loads on the chassis: gravity, a trailer, a wall.
//!
//! The controller has no input for gravity. It predicts the velocity of the chassis from its own impulses and
//! the user's forces. The difference is an external load that will probably persist (a "disturbance
//! observer": Kouhei Ohnishi, "A new servo method in mechatronics", 1987). Impacts are singular. Along each
//! axis, the estimate is therefore the smaller acceleration of the last two updates, or zero if their signs
//! differ.

use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBody;

/// State of the chassis from update to update.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct DisturbanceObserver {
    /// The expected velocity of the chassis after the step, and the length of the step (s).
    expected: Option<(Vector, Real)>,
    /// The last missing acceleration (length/s²).
    last: Vector,
    /// The common part of the last two.
    steady: Vector,
}

impl DisturbanceObserver {
    /// Compares the chassis with the prediction. Returns the acceleration that does not come from forces on
    /// the body (length/s²).
    pub fn observe(&mut self, chassis: &RigidBody) -> Vector {
        // Pending pushes mean that no step ran, so there is no new measurement.
        if chassis.is_pushed() {
            return self.steady;
        }
        if let Some((linvel, dt)) = self.expected.take() {
            let missing = (chassis.linvel() - linvel) / dt;
            if missing.is_finite() {
                self.steady = agreement(missing, self.last);
                self.last = missing;
            }
        }
        self.steady
    }

    /// Predicts the effect of forces and impulses on the chassis within `dt` seconds.
    pub fn expect(&mut self, chassis: &RigidBody, dt: Real) {
        self.expected = Some((linvel_after_forces(chassis, dt), dt));
    }

    /// Resets the prediction.
    pub fn skip(&mut self) {
        self.expected = None;
    }
}

/// The velocity of the centre of mass after `dt` seconds of nothing but the forces on the body.
pub(super) fn linvel_after_forces(body: &RigidBody, dt: Real) -> Vector {
    let force = body.user_force() + body.pending_push().0;
    body.linvel() + force * body.mass_properties().effective_inv_mass() * dt
}

/// The common part of both, per axis.
fn agreement(a: Vector, b: Vector) -> Vector {
    let agree = |a: Real, b: Real| match a * b > 0.0 {
        true if a.abs() < b.abs() => a,
        true => b,
        false => 0.0,
    };
    Vector::new(agree(a.x, b.x), agree(a.y, b.y), agree(a.z, b.z))
}

#[cfg(test)]
mod tests {
    use super::agreement;
    use crate::dim::math::Vector;

    #[test]
    fn only_repeated_loads_count() {
        let gravity = Vector::new(0.0, -9.81, 0.0);
        let impact = Vector::new(600.0, -9.0, 0.0);
        assert_eq!(agreement(gravity, gravity), gravity);
        assert_eq!(agreement(gravity, impact), Vector::new(0.0, -9.0, 0.0));
        assert_eq!(agreement(gravity, -gravity), Vector::ZERO);
    }
}
