//! The kinetic energy of a multibody, and its limits.
//!
//! Energy is removed from the change of shape first, so that linear and angular momentum stay. A large gain
//! of contacts is removed from all velocities alike: scaled velocities still lead out of a contact.

use super::super::kinematics::LinkFrame;
use super::super::spatial::{ZERO, angular_momentum};
use super::{JointLoad, Motion};
use crate::dim::math::{ANG_ZERO, Real, SpatialVector, Vector, ang_dot};
use crate::dim::spatial::{angular, linear};

/// Rotation (rad) of a link per step beyond which its contact rows are rebuilt in each substep. Other rows
/// are built once, at the beginning of the step. (Four hundred rods on long arms were thrown on the ground.
/// With a comparison of the angle per substep, eighteen gained energy, up to a factor of two. With the angle
/// per step, none did.)
const CONTACT_ANGLE_MAX: Real = 0.1;
/// The largest angle (rad) that a joint rotates in a substep with a non-converged piece.
const JOINT_ANGLE_MAX: Real = 0.5;
/// Joints that rotate by a larger angle (rad) in a substep are not limited. Such input is beyond the
/// simulated range, and a [`QuarantineEvent`](crate::model::event::QuarantineEvent) reports it.
const ANGLE_MEANINGFUL_MAX: Real = 1.0e6;
/// If at least this fraction of the energy is kept, the excess is removed from the change of shape.
const SHAPE_REDUCTION_FRACTION_MIN: Real = 0.9;
/// Relative rounding error of a comparison of energies.
const ROUNDING: Real = 32.0 * Real::EPSILON;

impl Motion {
    /// The energy that free motion conserves; `None` if something drives the links: a rotating root, or a
    /// prescribed joint.
    pub(super) fn free_motion_energy(&mut self) -> Option<Real> {
        if angular(&self.root) != ANG_ZERO || self.is_driven() {
            return None;
        }
        self.update_velocities();
        Some(self.energy_seen_from(self.frame_velocity()))
    }

    /// Returns whether a joint moves at a velocity set by the user.
    fn is_driven(&self) -> bool {
        let is_driven = |(load, rate): (&JointLoad, &Real)| load.is_prescribed() && *rate != 0.0;
        self.joint_loads.iter().zip(self.rates.iter()).any(is_driven)
    }

    /// The velocity of the centre-of-mass frame of the multibody along the free axes of its root, at the last
    /// velocities of the links.
    pub(super) fn frame_velocity(&self) -> Vector {
        if self.root_dofs() == 0 {
            return linear(&self.root);
        }
        let links = self.kinematics.links.iter().zip(&self.velocities);
        let add = |(mass, momentum): (Real, Vector), (link, velocity): (&LinkFrame, _)| {
            (mass + link.mass, momentum + linear(velocity) * link.mass)
        };
        let (mass, momentum) = links.fold((0.0, Vector::ZERO), add);
        let axes = self.kinematics.axes[..self.root_dofs()].iter().map(linear);
        let moving = axes.map(|axis| axis * axis.dot(momentum)).sum::<Vector>();
        if mass > 0.0 { moving / mass } else { Vector::ZERO }
    }

    /// Returns whether a link rotates so far in `dt` seconds that its contacts change.
    pub fn turns_far(&self, dt: Real) -> bool {
        self.has_diverged || self.fastest_turn * dt > CONTACT_ANGLE_MAX
    }

    /// Limits the kinetic energy. Returns the fraction of it that is kept.
    ///
    /// A small energy gain, or that of joints alone, is removed from the change of shape, so that the
    /// momentum from other bodies is conserved. For a large one all velocities are scaled: scaled velocities
    /// still lead out of all contacts.
    pub(super) fn limit_energy(&mut self, energy_max: Real, touches: bool) -> Real {
        let energy = self.kinetic_energy();
        let kept = energy_max.max(0.0) / energy;
        if kept >= 1.0 || !kept.is_finite() {
            return 1.0;
        }
        if (kept > SHAPE_REDUCTION_FRACTION_MIN || !touches) && self.root_dofs() > 0 {
            self.keep_momentum(self.kinematics.links[0].center);
            let energy_gain = self.kinetic_energy() - energy_max;
            let own = self.free_motion_energy();
            self.limit_free_energy(own.map(|own| (own - energy_gain).max(0.0)));
        }
        let left = energy_max.max(0.0) / self.kinetic_energy();
        if left < 1.0 - ROUNDING {
            self.slow_down(left.sqrt());
        }
        kept
    }

    /// The mass of all links.
    pub(super) fn mass(&self) -> Real {
        self.kinematics.links.iter().map(|link| link.mass).sum()
    }

    /// Scales all velocities except prescribed velocities by this fraction.
    fn slow_down(&mut self, fraction: Real) {
        self.ledger.is_hit = true;
        for (rate, load) in self.rates.iter_mut().zip(&self.joint_loads) {
            *rate *= if load.is_prescribed() { 1.0 } else { fraction };
        }
        self.follow_momentum();
    }

    /// Limits the energy of the links: it reduces the change of shape and, if that is not sufficient, the
    /// rotation of the locked body. If links move far at once, their configuration may be too compact for
    /// their angular momentum and energy.
    pub(super) fn limit_free_energy(&mut self, most: Option<Real>) {
        let Some(most) = most else { return };
        self.update_velocities();
        let frame = self.frame_velocity();
        let energy = self.energy_seen_from(frame);
        if energy <= most {
            return;
        }
        let own = self.copy_of_rates();
        self.slow_to_locked();
        self.update_velocities();
        let of_locked = self.energy_seen_from(frame);
        if of_locked < most {
            self.blend(&own, ((most - of_locked) / (energy - of_locked)).sqrt());
        } else {
            let locked_rates = self.copy_of_rates();
            self.slow_to(frame);
            self.blend(
                &locked_rates,
                if of_locked > 0.0 { (most / of_locked).sqrt() } else { 0.0 },
            );
            self.return_buffer(locked_rates);
        }
        self.restore_prescribed_rates(&own);
        self.return_buffer(own);
        self.follow_momentum();
    }

    /// Limits the rotation of joints to [`JOINT_ANGLE_MAX`] in `h` seconds by reducing the change of shape.
    pub(super) fn limit_joint_rates(&mut self, h: Real) {
        let axes = self.kinematics.axes.iter().zip(self.rates.iter()).skip(self.root_dofs());
        let turns = axes.filter(|(axis, _)| angular(axis) != ANG_ZERO);
        let fastest = turns.map(|(_, rate)| (rate * h).abs()).fold(0.0, Real::max);
        if fastest > JOINT_ANGLE_MAX && fastest < ANGLE_MEANINGFUL_MAX {
            let own = self.copy_of_rates();
            self.slow_to_locked();
            self.blend(&own, JOINT_ANGLE_MAX / fastest);
            self.restore_prescribed_rates(&own);
            self.return_buffer(own);
        }
    }

    /// Adds a fraction of the difference to these velocities.
    fn blend(&mut self, to: &[Real], fraction: Real) {
        let fraction = fraction.clamp(0.0, 1.0);
        for (rate, to) in self.rates.iter_mut().zip(to) {
            *rate += (to - *rate) * fraction;
        }
    }

    /// Sets the velocities of prescribed degrees of freedom.
    fn restore_prescribed_rates(&mut self, prescribed: &[Real]) {
        for ((rate, load), prescribed) in
            self.rates.iter_mut().zip(&self.joint_loads).zip(prescribed)
        {
            *rate = if load.is_prescribed() { *prescribed } else { *rate };
        }
    }

    /// Keeps the motion of the locked body only.
    fn slow_to_locked(&mut self) {
        let momentum = self.root_momentum();
        self.rates.fill(0.0);
        let of_root = self.locked_inertia.rates_at(&momentum);
        for (rate, &axis) in self.rates.iter_mut().zip(&self.kinematics.root_axes) {
            *rate = of_root[axis];
        }
    }

    /// Leaves a common translation of all links at this velocity.
    fn slow_to(&mut self, velocity: Vector) {
        self.rates.fill(0.0);
        let count = self.root_dofs();
        for (rate, axis) in self.rates[..count].iter_mut().zip(&self.kinematics.axes) {
            *rate = linear(axis).dot(velocity);
        }
    }

    /// Slows all degrees of freedom down alike if they move a link faster than this.
    pub(super) fn limit_speed(&mut self, speed_max: Real) {
        if speed_max >= Real::MAX {
            return;
        }
        if self.root == ZERO {
            self.update_velocities();
        } else {
            self.rates.touch();
            self.kinematics.velocities(&self.rates, &ZERO, &mut self.velocities);
        }
        let fastest = self.velocities.iter().map(|v| speed(linear(v))).fold(0.0, Real::max);
        if fastest > speed_max {
            self.is_limited = true;
            self.slow_down(speed_max / fastest);
        }
    }

    /// The kinetic energy of all links.
    pub fn kinetic_energy(&mut self) -> Real {
        self.update_velocities();
        self.energy_seen_from(Vector::ZERO)
    }

    /// The same at other rates of the degrees of freedom.
    pub fn energy_at(&mut self, rates: &[Real]) -> Real {
        let own = self.copy_of_rates();
        self.rates.copy_from_slice(rates);
        let energy = self.kinetic_energy();
        self.rates.copy_from_slice(&own);
        self.return_buffer(own);
        energy
    }

    /// A copy of the velocities, in a buffer that [`Self::return_buffer`] takes back.
    pub(super) fn copy_of_rates(&mut self) -> Vec<Real> {
        let mut copy = self.buffers.pop().unwrap_or_default();
        copy.clear();
        copy.extend_from_slice(&self.rates);
        copy
    }

    /// Keeps a buffer for its next use.
    pub fn return_buffer(&mut self, buffer: Vec<Real>) {
        self.buffers.push(buffer);
    }

    /// The kinetic energy of all links at the velocities that they had last, seen from a frame with this
    /// velocity.
    pub(super) fn energy_seen_from(&self, frame: Vector) -> Real {
        let of = |(link, velocity): (&LinkFrame, &SpatialVector)| {
            let (v, w) = (linear(velocity) - frame, angular(velocity));
            0.5 * (link.mass * v.length_squared() + ang_dot(w, angular_momentum(&link.inertia, w)))
        };
        let of_links: Real = self.kinematics.links.iter().zip(&self.velocities).map(of).sum();
        let of_armature = |(load, rate): (&JointLoad, &Real)| {
            if load.is_prescribed() { 0.0 } else { 0.5 * load.armature * rate * rate }
        };
        of_links + self.joint_loads.iter().zip(self.rates.iter()).map(of_armature).sum::<Real>()
    }
}

/// The length of a velocity, whose square may be beyond all numbers.
fn speed(velocity: Vector) -> Real {
    let size = velocity.abs().max_element();
    if size > 0.0 { (velocity / size).length() * size } else { 0.0 }
}
