//! Persistent forces, impulses, and energies of a body.
//!
//! Forces and impulses act on dynamic bodies only; other bodies ignore them.

use super::{RigidBody, RigidBodyVelocity};
use crate::base::measure::is_point;
use crate::dim::axes::inv_mass_per_axis;
use crate::dim::mass::angular_momentum;
use crate::dim::math::{
    ANG_ZERO, AngVector, Real, Vector, ang_dot, ang_is_finite, mul_inertia, torque,
};
use crate::model::check::refuse;

impl RigidBody {
    /// The sum of the forces added by [`Self::add_force`] and [`Self::add_force_at_point`] (mass·length/s²).
    /// Gravity and contacts are excluded.
    pub fn user_force(&self) -> Vector {
        self.force
    }

    /// The sum of the torques added by [`Self::add_torque`] and [`Self::add_force_at_point`]
    /// (mass·length²/s²).
    pub fn user_torque(&self) -> AngVector {
        self.torque
    }

    /// Sets the user force to zero.
    pub fn reset_forces(&mut self, wake_up: bool) {
        if self.force != Vector::ZERO {
            self.force = Vector::ZERO;
            self.wake_if(wake_up);
        }
    }

    /// Sets the user torque to zero, including the torques of forces added at a point.
    pub fn reset_torques(&mut self, wake_up: bool) {
        if self.torque != ANG_ZERO {
            self.torque = ANG_ZERO;
            self.wake_if(wake_up);
        }
    }

    /// Adds a world-space force on the centre of mass (mass·length/s²). It acts in every step until
    /// [`Self::reset_forces`].
    pub fn add_force(&mut self, force: Vector, wake_up: bool) {
        self.add_force_and_torque(force, ANG_ZERO, wake_up);
    }

    /// Adds a world-space torque (mass·length²/s²). It acts in every step until
    /// [`Self::reset_torques`].
    pub fn add_torque(&mut self, torque: AngVector, wake_up: bool) {
        self.add_force_and_torque(Vector::ZERO, torque, wake_up);
    }

    /// Adds a world-space force at a point in world space. The force acts on the centre of mass, with its
    /// current torque about it. Both act in every step until they are reset.
    pub fn add_force_at_point(&mut self, force: Vector, point: Vector, wake_up: bool) {
        if !is_point(point) {
            return refuse("the point where a force acts on a rigid body", point);
        }
        let arm = point - self.mprops.world_com;
        self.add_force_and_torque(force, torque(arm, force), wake_up);
    }

    fn add_force_and_torque(&mut self, force: Vector, torque: AngVector, wake_up: bool) {
        if !self.is_dynamic() || (force == Vector::ZERO && torque == ANG_ZERO) {
            return;
        }
        let (new_force, new_torque) = (self.force + force, self.torque + torque);
        if !new_force.is_finite() || !ang_is_finite(new_torque) {
            return refuse("the force and torque on a rigid body", (new_force, new_torque));
        }
        (self.force, self.torque) = (new_force, new_torque);
        self.wake_if(wake_up);
    }

    /// Applies a world-space impulse (mass·length/s) at the centre of mass. The velocity changes at once.
    pub fn apply_impulse(&mut self, impulse: Vector, wake_up: bool) {
        self.apply_push(impulse, ANG_ZERO, wake_up);
    }

    /// Applies a world-space angular impulse (mass·length²/s). The angular velocity changes at once.
    pub fn apply_torque_impulse(&mut self, torque_impulse: AngVector, wake_up: bool) {
        self.apply_push(Vector::ZERO, torque_impulse, wake_up);
    }

    /// Applies a world-space impulse (mass·length/s) at a point in world space. The velocity changes at once.
    pub fn apply_impulse_at_point(&mut self, impulse: Vector, point: Vector, wake_up: bool) {
        if !is_point(point) {
            return refuse("the point where an impulse strikes a rigid body", point);
        }
        let arm = point - self.mprops.world_com;
        self.apply_push(impulse, torque(arm, impulse), wake_up);
    }

    fn apply_push(&mut self, impulse: Vector, torque_impulse: AngVector, wake_up: bool) {
        if !self.is_dynamic() || (impulse == Vector::ZERO && torque_impulse == ANG_ZERO) {
            return;
        }
        let pushed = RigidBodyVelocity {
            linvel: self.vels.linvel + impulse * self.mprops.inv_mass,
            angvel: self.vels.angvel + mul_inertia(&self.mprops.inv_inertia, torque_impulse),
        };
        if !pushed.is_usable() {
            return refuse("the impulses on a rigid body", (impulse, torque_impulse));
        }
        let wakes = wake_up && pushed != self.vels;
        self.set_velocity(pushed);
        self.wake_if(wakes);
    }

    // ---- Energy ----

    /// The kinetic energy, `½ m v² + ½ ω·I ω` (mass·length²/s²).
    pub fn kinetic_energy(&self) -> Real {
        let momentum =
            angular_momentum(&self.mprops.local_mprops, self.pose.rotation, self.vels.angvel);
        let linear = self.mass() * self.vels.linvel.length_squared();
        0.5 * (linear + ang_dot(self.vels.angvel, momentum))
    }

    /// The potential energy (mass·length²/s²) in the given gravity (length/s²), zero at the world's origin.
    ///
    /// Each substep moves a body with the velocity at its end, so pose and velocity belong to times half a
    /// substep apart. Pass the length of a substep as `dt` (seconds): that of a step divided by the number of
    /// solver iterations. The result is then the energy half a substep before. The sum with
    /// [`Self::kinetic_energy`] is then constant in free fall. With 0, the result is the energy at the
    /// current pose.
    pub fn gravitational_potential_energy(&self, dt: Real, gravity: Vector) -> Real {
        let center_of_mass = self.mprops.world_com - self.vels.linvel * (dt * 0.5);
        -self.mass() * self.gravity_scale * gravity.dot(center_of_mass)
    }

    /// The acceleration by gravity along the axes that are not locked. Gravity is a force: without mass a
    /// body has no weight, and no force accelerates it.
    pub(crate) fn gravitational_acceleration(&self, gravity: Vector) -> Vector {
        if self.mprops.local_mprops.inv_mass == 0.0 {
            return Vector::ZERO;
        }
        gravity * self.gravity_scale * inv_mass_per_axis(self.mprops.locked_axes, 1.0)
    }
}

/// Forces for one step alone.
#[allow(dead_code, reason = "only the 3D vehicle calls it")]
impl RigidBody {
    /// Pushes the body throughout the next step, and in that step alone, with a world-space force and torque
    /// on its centre of mass. Pushes add up. The body does not wake.
    ///
    /// The push acts together with gravity, unlike an impulse before the step. A push that balances gravity
    /// leaves no velocity and moves nothing.
    pub(crate) fn push(&mut self, force: Vector, torque: AngVector) {
        let (old_force, old_torque) = self.push;
        let (new_force, new_torque) = (old_force + force, old_torque + torque);
        if !self.is_dynamic() || !new_force.is_finite() || !ang_is_finite(new_torque) {
            return;
        }
        self.push = (new_force, new_torque);
        self.pushed = true;
    }

    /// The force and torque of the pushes for the next step.
    pub(crate) fn pending_push(&self) -> (Vector, AngVector) {
        self.push
    }

    /// Returns whether there are pushes for the next step.
    pub(crate) fn is_pushed(&self) -> bool {
        self.pushed
    }

    /// Removes the pushes for the next step.
    pub(crate) fn drop_push(&mut self) {
        self.push = (Vector::ZERO, ANG_ZERO);
        self.pushed = false;
    }

    /// Clears the pushes after a step has applied them.
    #[inline]
    pub(crate) fn use_up_push(&mut self) {
        if self.pushed {
            self.drop_push();
        }
    }

    /// All forces and torques of the next step except gravity.
    pub(crate) fn forces(&self) -> (Vector, AngVector) {
        if !self.pushed {
            return (self.force, self.torque);
        }
        let (force, torque) = self.push;
        (self.force + force, self.torque + torque)
    }
}
