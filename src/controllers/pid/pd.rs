//! The controller without state: springs and dampers.

use crate::dim::mask::AxesMask;
use crate::dim::math::{
    ANG_ZERO, AngVector, Pose, Real, Rotation, Vector, ang_is_finite, rotation_to_angle,
};
use crate::model::body::{RigidBody, RigidBodyVelocity};

/// Error of a pose or of a velocity.
#[derive(Copy, Clone, PartialEq, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct PdErrors {
    /// Target position minus actual position (length), or target velocity minus actual velocity (length/s).
    pub linear: Vector,
    /// The rotation vector from the actual to the target rotation in world space (rad), or target minus
    /// actual angular velocity (rad/s).
    pub angular: AngVector,
}

impl Default for PdErrors {
    fn default() -> Self {
        Self { linear: Vector::ZERO, angular: ANG_ZERO }
    }
}

impl From<RigidBodyVelocity> for PdErrors {
    fn from(vels: RigidBodyVelocity) -> Self {
        Self { linear: vels.linvel, angular: vels.angvel }
    }
}

/// A controller that moves a dynamic body to a pose. It computes the change of velocity to apply before the
/// next step.
///
/// `change = kp · (target pose - pose) + kd · (target velocity - velocity)`, along and about the
/// [`axes`](Self::axes) only. The body keeps colliding on its path, unlike a kinematic one.
///
/// ```
/// use rapier3d::prelude::*;
///
/// let mut world = PhysicsWorld::new();
/// world.gravity = Vector::ZERO;
/// let (hand, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
/// let target = Pose::from_translation(vector![3.0, 1.0, 0.0]);
///
/// let controller = PdController::default();
/// for _ in 0..60 {
///     let body = &mut world.bodies[hand];
///     let change = controller.rigid_body_correction(body, target, RigidBodyVelocity::zero());
///     let vels = body.vels();
///     body.set_vels(vels + change, true);
///     world.step();
/// }
/// assert!((world.bodies[hand].translation() - target.translation).length() < 1.0e-3);
/// ```
///
/// The gains are per axis, and independent of the mass. At a time step `dt`, `kp = (1 - √(1 - kd))² / dt`
/// gives critical damping. With `kd = 1` and `kp = 1 / dt` the body reaches the target in one step. All gains
/// with `0 < kd < 2` and `0 < kp·dt < 2·(2 - kd)` converge to the target.
#[derive(Copy, Clone, PartialEq, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct PdController {
    /// Velocity for each unit of distance, per axis (1/s).
    pub lin_kp: Vector,
    /// Fraction of the velocity error that one correction removes, per axis.
    pub lin_kd: Vector,
    /// Angular velocity for each radian of error, per axis (1/s).
    pub ang_kp: AngVector,
    /// Fraction of the angular velocity error that one correction removes, per axis.
    pub ang_kd: AngVector,
    /// The world axes along and about which the controller acts.
    pub axes: AxesMask,
}

impl Default for PdController {
    /// `kp = 60`, `kd = 0.8`, all axes: the body reaches the target within a few steps at 60 steps a second.
    fn default() -> Self {
        Self::new(60.0, 0.8, AxesMask::all())
    }
}

impl PdController {
    /// A controller with the same gains for all axes: `kp` in 1/s, `kd` without a unit.
    pub fn new(kp: Real, kd: Real, axes: AxesMask) -> Self {
        let (lin, ang) = (Vector::ONE, AxesMask::all().angular());
        Self { lin_kp: lin * kp, lin_kd: lin * kd, ang_kp: ang * kp, ang_kd: ang * kd, axes }
    }

    /// The change of the body's linear velocity that moves its origin to `target_pos` (world space) with
    /// `target_linvel` (length/s) there.
    pub fn linear_rigid_body_correction(
        &self,
        rb: &RigidBody,
        target_pos: Vector,
        target_linvel: Vector,
    ) -> Vector {
        let target = Pose::from_parts(target_pos, *rb.rotation());
        let target_vels = RigidBodyVelocity::new(target_linvel, rb.angvel());
        self.rigid_body_correction(rb, target, target_vels).linvel
    }

    /// The change of the body's angular velocity that rotates it to `target_rot` with `target_angvel` (rad/s)
    /// there.
    pub fn angular_rigid_body_correction(
        &self,
        rb: &RigidBody,
        target_rot: Rotation,
        target_angvel: AngVector,
    ) -> AngVector {
        let target = Pose::from_parts(rb.translation(), target_rot);
        let target_vels = RigidBodyVelocity::new(rb.linvel(), target_angvel);
        self.rigid_body_correction(rb, target, target_vels).angvel
    }

    /// The change of the body's velocity that moves it to a pose with `target_vels` there.
    ///
    /// Poses are those of the body's frame; `target_vels.linvel` is the velocity of its origin. Zero where a
    /// number is not finite.
    pub fn rigid_body_correction(
        &self,
        rb: &RigidBody,
        target_pose: Pose,
        target_vels: RigidBodyVelocity,
    ) -> RigidBodyVelocity {
        self.correction(&pose_errors(rb, &target_pose), &velocity_errors(rb, &target_vels))
    }

    /// The change of velocity for given errors of pose and velocity. Zero where a number is not finite.
    pub fn correction(&self, pose_errors: &PdErrors, vel_errors: &PdErrors) -> RigidBodyVelocity {
        let linear = self.lin_kp * pose_errors.linear + self.lin_kd * vel_errors.linear;
        let angular = self.ang_kp * pose_errors.angular + self.ang_kd * vel_errors.angular;
        sound(RigidBodyVelocity::new(linear * self.axes.linear(), angular * self.axes.angular()))
    }
}

/// The difference of a pose and the frame of a body.
pub(super) fn pose_errors(rb: &RigidBody, target: &Pose) -> PdErrors {
    PdErrors {
        linear: target.translation - rb.translation(),
        angular: rotation_to_angle(&(target.rotation * rb.rotation().inverse())),
    }
}

/// The difference of these velocities and those of a body's origin.
pub(super) fn velocity_errors(rb: &RigidBody, target: &RigidBodyVelocity) -> PdErrors {
    PdErrors {
        linear: target.linvel - rb.velocity_at_point(rb.translation()),
        angular: target.angvel - rb.angvel(),
    }
}

/// The velocity, with zeros in place of a part that is not finite.
pub(super) fn sound(vels: RigidBodyVelocity) -> RigidBodyVelocity {
    let linvel = if vels.linvel.is_finite() { vels.linvel } else { Vector::ZERO };
    let angvel = if ang_is_finite(vels.angvel) { vels.angvel } else { ANG_ZERO };
    if linvel != vels.linvel || angvel != vels.angvel {
        log::warn!(
            "PdController: the velocity change {vels:?} is not finite and is replaced by zero"
        );
    }
    RigidBodyVelocity { linvel, angvel }
}
