//! Solves all rows of all wheels together: projected Gauss–Seidel iteration, as contacts are solved
//! elsewhere, but to the end, because there are so few.

use super::contact::{Mover, WheelContact};
use super::ground::{Ground, Grounds};
use super::wheel::Wheel;
use crate::dim::math::{Real, Vector};

/// Largest number of iterations over the rows. Springs are compliant and couple weakly. The slowest case is a
/// car with all wheels locked, whose rows are redundant.
const ITERATIONS_MAX: usize = 50;
/// The iteration has converged when no row changes its velocity by more than this fraction of the
/// suspensions' effect in the step. Of the 0.2 m/s of a step of gravity, that is less than rounding.
const CONVERGENCE_TOLERANCE: Real = 1.0e-5;

/// Finds the impulses of all wheels.
pub(super) fn solve(contacts: &mut [WheelContact], chassis: &mut Mover, grounds: &mut Grounds) {
    for _ in 0..ITERATIONS_MAX {
        let (mut change, mut scale): (Real, Real) = (0.0, 0.0);
        for contact in contacts.iter_mut() {
            let ground = &mut grounds.all[contact.ground].mover;
            change = change.max(contact.press(chassis, ground));
            scale = scale.max(contact.normal.impulse * contact.normal.inv_mass);
        }
        for contact in contacts.iter_mut() {
            let ground = &mut grounds.all[contact.ground].mover;
            change = change.max(contact.hold(chassis, ground));
        }
        if change <= CONVERGENCE_TOLERANCE * scale {
            break;
        }
    }
}

impl WheelContact {
    /// Begins with the impulses of the last update, which are nearly right.
    pub fn warm_start(&mut self, impulses: [Real; 3], chassis: &mut Mover, ground: &mut Mover) {
        let rows = [&mut self.normal, &mut self.forward, &mut self.side];
        for (row, impulse) in rows.into_iter().zip(impulses) {
            if row.inv_mass > 0.0 {
                row.set_impulse(impulse, chassis, ground);
            }
        }
    }

    /// Applies the suspension. Returns the change of its velocity.
    fn press(&mut self, chassis: &mut Mover, ground: &mut Mover) -> Real {
        let row = &mut self.normal;
        let (old, inv_mass) = (row.impulse, row.inv_mass);
        let impulse = self.spring.solve(old, row.velocity(chassis, ground), inv_mass);
        row.set_impulse(impulse, chassis, ground);
        (impulse - old).abs() * inv_mass
    }

    /// Applies the friction of the tyre. Returns the changes of its velocities.
    fn hold(&mut self, chassis: &mut Mover, ground: &mut Mover) -> Real {
        let limit = self.friction * self.normal.impulse;
        let forward = self.forward.impulse_for(0.0, chassis, ground);
        let side = self.side.impulse_for(self.side_target, chassis, ground);
        let grip = self.drive.grip(forward, side, limit);
        let change = (grip.forward - self.forward.impulse).abs() * self.forward.inv_mass
            + (grip.side - self.side.impulse).abs() * self.side.inv_mass;
        self.forward.set_impulse(grip.forward, chassis, ground);
        self.side.set_impulse(grip.side, chassis, ground);
        self.is_sliding = grip.is_sliding;
        change
    }

    /// Returns whether all impulses are finite.
    pub fn is_finite(&self) -> bool {
        self.rows().iter().all(|row| row.impulse.is_finite())
    }

    /// Writes the results to the wheel.
    pub fn report(&self, wheel: &mut Wheel) {
        wheel.wheel_suspension_force = self.normal.impulse * self.spring.force_of_impulse;
        wheel.forward_impulse = self.forward.impulse;
        wheel.side_impulse = self.side.impulse;
        wheel.is_sliding = self.is_sliding;
        wheel.last_impulses = self.rows().map(|row| row.impulse);
    }
}

/// The impulse and its moment about the centre of mass that all wheels together bring to the chassis.
pub(super) fn on_chassis(contacts: &[WheelContact]) -> (Vector, Vector) {
    sum(contacts.iter().flat_map(|contact| contact.rows().map(|row| row.wrench(0))))
}

/// The same for the bodies below them.
pub(super) fn on_ground(contacts: &[WheelContact], index: usize) -> (Vector, Vector) {
    let those = contacts.iter().filter(|contact| contact.ground == index);
    sum(those.flat_map(|contact| contact.rows().map(|row| row.wrench(1))))
}

fn sum(wrenches: impl Iterator<Item = (Vector, Vector)>) -> (Vector, Vector) {
    wrenches.fold((Vector::ZERO, Vector::ZERO), |sum, part| (sum.0 + part.0, sum.1 + part.1))
}

impl Grounds {
    /// The movable bodies.
    pub fn dynamic(&self) -> impl Iterator<Item = (usize, &Ground)> {
        self.all.iter().enumerate().filter(|(_, ground)| ground.is_dynamic)
    }
}
