//! How a body moves without any constraint.

use crate::dim::axes::{LockedAxes, inv_mass_per_axis};
use crate::dim::gyro::Gyroscope;
use crate::dim::math::{
    ANG_ZERO, AngVector, Real, Rotation, Vector, integrate_rotation, mul_inertia,
};
use crate::dim::state::BodyState;
use crate::model::body::RigidBody;

/// What integrates a body; no constraint reads it.
#[derive(Copy, Clone, Debug)]
pub(super) struct Motion {
    pub rotation: Rotation,
    /// Acceleration by gravity and the user's forces (length/s², rad/s²).
    pub linear_acceleration: Vector,
    pub angular_acceleration: AngVector,
    pub linear_damping: Real,
    pub angular_damping: Real,
    /// Does gravity pull it, so that it may be part of a pile? What holds piles up counts, too.
    pub bears_weight: bool,
    /// Was it faster than the user allows?
    pub is_limited: bool,
    /// For a body that tumbles.
    pub gyroscope: Option<Gyroscope>,
}

impl Motion {
    /// Neither accelerates nor is damped.
    pub const AT_REST: Self = Self {
        rotation: Rotation::IDENTITY,
        linear_acceleration: Vector::ZERO,
        angular_acceleration: ANG_ZERO,
        linear_damping: 0.0,
        angular_damping: 0.0,
        bears_weight: true,
        is_limited: false,
        gyroscope: None,
    };

    pub fn of(body: &mut RigidBody, gravity: Vector, substep: Real) -> Self {
        let (force, torque) = body.take_forces();
        let mprops = &body.mprops;
        // Gravity accelerates whatever can move, with or without mass.
        let free = inv_mass_per_axis(mprops.locked_axes, 1.0);
        let turns_freely = !mprops.locked_axes.intersects(LockedAxes::ROTATION_LOCKED);
        let gyroscope = if body.gyroscopic_forces_enabled && turns_freely {
            Gyroscope::new(&mprops.local, body.angvel, substep)
        } else {
            None
        };
        Self {
            rotation: body.pose.rotation,
            linear_acceleration: gravity * body.gravity_scale * free + force * mprops.inv_mass,
            angular_acceleration: mul_inertia(&mprops.inv_inertia, torque),
            linear_damping: body.linear_damping,
            angular_damping: body.angular_damping,
            bears_weight: gravity * body.gravity_scale != Vector::ZERO,
            is_limited: false,
            gyroscope,
        }
    }

    /// The velocities after `h` seconds without any constraint.
    pub fn accelerated(
        &mut self,
        v: Vector,
        w: AngVector,
        h: Real,
        speed_max: Real,
    ) -> (Vector, AngVector) {
        // Damping is integrated implicitly: v' = v + h a - h c v' never overshoots zero.
        let v = (v + self.linear_acceleration * h) / (1.0 + h * self.linear_damping);
        let mut w = (w + self.angular_acceleration * h) / (1.0 + h * self.angular_damping);
        if let Some(gyroscope) = &mut self.gyroscope {
            w = gyroscope.velocity_at_middle(self.rotation, w, h);
        }
        if speed_max == Real::MAX {
            return (v, w);
        }
        self.is_limited |= v.length_squared() > speed_max * speed_max;
        (v.clamp_length_max(speed_max), w)
    }

    /// Turns a tumbling body by this rotation vector.
    pub fn turn(&mut self, turn: AngVector) {
        if self.gyroscope.is_some() {
            self.rotation = integrate_rotation(self.rotation, turn);
        }
    }

    /// Turns a tumbling body, and its angular velocity as its inertia turns.
    pub fn tumble(&mut self, state: &mut BodyState, before: &mut BodyState, h: Real) {
        let Some(gyroscope) = &mut self.gyroscope else { return };
        let (v, w) = state.velocity();
        self.rotation = integrate_rotation(self.rotation, w * h);
        let end = gyroscope.velocity_at_end(self.rotation, w);
        state.set_velocity(v, end);
        // What turned the velocity was no impulse: the next substep must not start with it, nor with the
        // rounding of it. Where there was no impulse, `before` becomes `end` to the last bit.
        let (before_v, before_w) = before.velocity();
        before.set_velocity(before_v, end - (w - before_w));
    }
}
