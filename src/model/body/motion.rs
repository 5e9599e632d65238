//! Pose and velocity of a body, and their prediction.

use super::{RigidBody, RigidBodyChanges, RigidBodyType, RigidBodyVelocity};
use crate::dim::axes::unlocked_velocity;
use crate::dim::math::{
    AngVector, Pose, Real, Rotation, Vector, ang_is_finite, mul_inertia, rotation_to_angle,
};
use crate::dim::motion::angvel_at;
use crate::model::check::{checked_pose, checked_rotation, refuse};

impl RigidBody {
    /// The body's frame in world space.
    pub fn position(&self) -> &Pose {
        &self.pose
    }

    /// The origin of the body's frame in world space.
    pub fn translation(&self) -> Vector {
        self.pose.translation
    }

    /// The angular velocity that the body will have in `h` seconds, which may lie in the past, turned to
    /// `there`, if nothing acts on it.
    pub(crate) fn angvel_at(&self, there: Rotation, h: Real) -> AngVector {
        if !self.gyroscopic_forces_enabled || !self.mprops.rotates_freely() {
            return self.vels.angvel;
        }
        let angvel =
            angvel_at(&self.mprops.local_mprops, (self.pose.rotation, there), self.vels.angvel, h);
        if ang_is_finite(angvel) { angvel } else { self.vels.angvel }
    }

    /// Rotation of the body's frame in world space.
    pub fn rotation(&self) -> &Rotation {
        &self.pose.rotation
    }

    /// Moves the body to a pose at once, without collisions on the way. Its velocity stays.
    ///
    /// To push bodies on the way, give the body a velocity, or make it kinematic and use
    /// [`Self::set_next_kinematic_position`].
    pub fn set_position(&mut self, pose: Pose, wake_up: bool) {
        let Some(pose) = checked_pose(pose) else {
            return refuse("the position of a rigid body", pose);
        };
        if pose != self.pose || self.next_position() != &pose {
            (self.pose, self.next_pose) = (pose, pose);
            self.changes.insert(RigidBodyChanges::POSITION);
            self.update_world_mass_properties();
            self.wake_if(wake_up);
        }
    }

    /// Moves the origin of the body's frame to a point in world space at once.
    pub fn set_translation(&mut self, translation: Vector, wake_up: bool) {
        if !translation.is_finite() {
            return refuse("the translation of a rigid body", translation);
        }
        self.set_position(Pose::from_parts(translation, self.pose.rotation), wake_up);
    }

    /// Sets the orientation of the body's frame at once. The origin of the frame stays.
    pub fn set_rotation(&mut self, rotation: Rotation, wake_up: bool) {
        let Some(rotation) = checked_rotation(rotation) else {
            return refuse("the rotation of a rigid body", rotation);
        };
        self.set_position(Pose::from_parts(self.pose.translation, rotation), wake_up);
    }

    /// The pose that a position-based kinematic body will have after the next step; the current one
    /// for all others.
    pub fn next_position(&self) -> &Pose {
        match self.body_type {
            RigidBodyType::KinematicPositionBased => &self.next_pose,
            _ => &self.pose,
        }
    }

    /// Sets the pose of the body after the next step. The step derives the velocity that reaches it, so that
    /// the body pushes and carries touching bodies.
    ///
    /// Only for position-based kinematic bodies; others ignore the call.
    pub fn set_next_kinematic_position(&mut self, pose: Pose) {
        if self.body_type != RigidBodyType::KinematicPositionBased {
            return log::debug!("a {:?} body has no next kinematic position", self.body_type);
        }
        let Some(pose) = checked_pose(pose) else {
            return refuse("the next kinematic position of a rigid body", pose);
        };
        if pose != self.next_pose {
            self.next_pose = pose;
            self.changes.insert(RigidBodyChanges::POSITION);
        }
        self.wake_if(self.next_pose != self.pose);
    }

    /// Sets the origin of the body's frame after the next step; its next rotation stays. See
    /// [`Self::set_next_kinematic_position`].
    pub fn set_next_kinematic_translation(&mut self, translation: Vector) {
        self.set_next_kinematic_position(Pose::from_parts(translation, self.next_pose.rotation));
    }

    /// Sets the orientation of the body's frame after the next step; its next translation stays. See
    /// [`Self::set_next_kinematic_position`].
    pub fn set_next_kinematic_rotation(&mut self, rotation: Rotation) {
        self.set_next_kinematic_position(Pose::from_parts(self.next_pose.translation, rotation));
    }

    /// The velocity that moves the body from its pose to the next one in `1 / inv_dt` seconds.
    pub(crate) fn velocity_to_next_position(&self, inv_dt: Real) -> RigidBodyVelocity {
        let next_pose = self.next_position();
        if next_pose == &self.pose {
            // Exactly at rest: the difference of two equal rotations has rounding in it.
            return RigidBodyVelocity::zero();
        }
        let next_com = next_pose * self.mprops.local_mprops.local_com;
        let rotation = next_pose.rotation * self.pose.rotation.inverse();
        RigidBodyVelocity {
            linvel: (next_com - self.mprops.world_com) * inv_dt,
            angvel: rotation_to_angle(&rotation) * inv_dt,
        }
    }

    // ---- Velocity ----

    /// World-space velocity of the centre of mass (length/s).
    pub fn linvel(&self) -> Vector {
        self.vels.linvel
    }

    /// World-space angular velocity (rad/s).
    pub fn angvel(&self) -> AngVector {
        self.vels.angvel
    }

    /// Linear and angular velocity together.
    #[cfg(not(feature = "upstream-signatures"))]
    pub fn vels(&self) -> RigidBodyVelocity {
        self.vels
    }

    /// Linear and angular velocity together.
    #[cfg(feature = "upstream-signatures")]
    pub fn vels(&self) -> &RigidBodyVelocity {
        &self.vels
    }

    /// Returns whether the body has a velocity.
    pub fn is_moving(&self) -> bool {
        !self.vels.is_zero()
    }

    /// Sets the world-space velocity of the centre of mass (length/s).
    ///
    /// Fixed bodies have no velocity, and the velocity of position-based kinematic bodies follows from their
    /// next position. Both ignore the call. A dynamic body has no velocity along locked axes: these
    /// components become zero.
    pub fn set_linvel(&mut self, linvel: Vector, wake_up: bool) {
        self.set_vels(RigidBodyVelocity::new(linvel, self.vels.angvel), wake_up);
    }

    /// Sets the world-space angular velocity (rad/s). Ignored by the same bodies as [`Self::set_linvel`], and
    /// without effect about locked axes of a dynamic body.
    pub fn set_angvel(&mut self, angvel: AngVector, wake_up: bool) {
        self.set_vels(RigidBodyVelocity::new(self.vels.linvel, angvel), wake_up);
    }

    /// Sets linear and angular velocity together. Ignored by the same bodies as [`Self::set_linvel`].
    pub fn set_vels(&mut self, vels: RigidBodyVelocity, wake_up: bool) {
        if !vels.is_usable() {
            return refuse("the velocity of a rigid body", vels);
        }
        let settable = matches!(
            self.body_type,
            RigidBodyType::Dynamic | RigidBodyType::KinematicVelocityBased
        );
        let old = self.vels;
        if settable && vels != old {
            self.set_velocity(vels);
            self.wake_if(wake_up && self.vels != old);
        }
    }

    /// Stores a velocity. A dynamic body has none along and about locked axes.
    pub(super) fn set_velocity(&mut self, vels: RigidBodyVelocity) {
        self.vels = vels;
        if self.is_dynamic() {
            let locked = self.mprops.locked_axes;
            (self.vels.linvel, self.vels.angvel) =
                unlocked_velocity(locked, vels.linvel, vels.angvel);
        }
    }

    /// World-space velocity (length/s) of the body's point that is at `point` in world space.
    pub fn velocity_at_point(&self, point: Vector) -> Vector {
        self.vels.velocity_at_point(point, self.mprops.world_com)
    }

    // ---- Prediction ----

    /// The pose in `dt` seconds at constant velocity.
    ///
    /// The rotation is about the centre of mass. If the result is not finite (a `dt` that is not finite), the
    /// current pose is returned.
    pub fn predict_position_using_velocity(&self, dt: Real) -> Pose {
        self.predict(&self.vels, dt)
    }

    /// The pose in `dt` seconds under constant forces and torques, with damping. Gravity, which the body does
    /// not store, and contacts are excluded.
    ///
    /// The result is one step of the symplectic Euler method: first the velocity changes, then the pose.
    pub fn predict_position_using_velocity_and_forces(&self, dt: Real) -> Pose {
        let pushed = RigidBodyVelocity {
            linvel: self.vels.linvel + self.force * self.mprops.inv_mass * dt,
            angvel: self.vels.angvel + mul_inertia(&self.mprops.inv_inertia, self.torque) * dt,
        };
        let slowed = pushed.apply_damping(dt, self.linear_damping, self.angular_damping);
        self.predict(&slowed, dt)
    }

    fn predict(&self, vels: &RigidBodyVelocity, dt: Real) -> Pose {
        let pose = vels.integrate(dt, &self.pose, self.mprops.local_mprops.local_com);
        checked_pose(pose).unwrap_or(self.pose)
    }

    /// Sets the velocity to zero without marking the body as changed.
    pub(super) fn halt(&mut self) {
        self.vels = RigidBodyVelocity::zero();
    }
}
