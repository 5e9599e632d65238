//! The PID controller: a PD controller with an integral term, which removes the steady-state error.

use super::pd::{PdController, PdErrors, pose_errors, sound, velocity_errors};
use crate::dim::mask::AxesMask;
use crate::dim::math::{ANG_ZERO, AngVector, Pose, Real, Rotation, Vector, ang_is_finite};
use crate::model::body::{RigidBody, RigidBodyVelocity};

/// A [`PdController`] with an integral term, which compensates constant forces such as gravity.
///
/// `change = PD + ki · ∫ error dt`. A PD controller that carries a body against gravity has a steady-state
/// error, because only an error causes a force; the integral term removes it.
///
/// ```
/// use rapier3d::prelude::*;
///
/// let mut world = PhysicsWorld::new();
/// let (lamp, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
/// let target = Pose::from_translation(vector![0.0, 2.0, 0.0]);
/// let dt = world.integration_parameters.dt;
///
/// let mut controller = PidController::new(10.0, 20.0, 0.8, AxesMask::all());
/// for _ in 0..600 {
///     let body = &mut world.bodies[lamp];
///     let change = controller.rigid_body_correction(dt, body, target, RigidBodyVelocity::zero());
///     let vels = body.vels();
///     body.set_vels(vels + change, true);
///     world.step();
/// }
/// assert!((world.bodies[lamp].translation().y - 2.0).abs() < 1.0e-3, "no sag");
/// ```
///
/// The integrals belong to one body: use one controller for each body.
#[derive(Copy, Clone, PartialEq, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct PidController {
    /// The proportional and derivative terms.
    pub pd: PdController,
    /// Integral of the position error over time (length·s).
    pub lin_integral: Vector,
    /// Integral of the rotation error over time (rad·s).
    pub ang_integral: AngVector,
    /// Velocity for each unit of the integral, per axis (1/s²).
    pub lin_ki: Vector,
    /// Angular velocity for each unit of the integral, per axis (1/s²).
    pub ang_ki: AngVector,
}

impl Default for PidController {
    /// `kp = 60`, `ki = 1`, `kd = 0.8`, all axes.
    fn default() -> Self {
        Self::new(60.0, 1.0, 0.8, AxesMask::all())
    }
}

impl PidController {
    /// A controller with the same gains for all axes (`kp` in 1/s, `ki` in 1/s², `kd` without a unit), and
    /// zero integrals.
    pub fn new(kp: Real, ki: Real, kd: Real, axes: AxesMask) -> Self {
        Self {
            pd: PdController::new(kp, kd, axes),
            lin_integral: Vector::ZERO,
            ang_integral: ANG_ZERO,
            lin_ki: Vector::ONE * ki,
            ang_ki: AxesMask::all().angular() * ki,
        }
    }

    /// The world axes along and about which the controller acts.
    pub fn axes(&self) -> AxesMask {
        self.pd.axes
    }

    /// Sets the world axes along and about which the controller acts. The state of other axes is reset.
    pub fn set_axes(&mut self, axes: AxesMask) {
        self.pd.axes = axes;
        self.lin_integral *= axes.linear();
        self.ang_integral *= axes.angular();
    }

    /// Resets the integrals to zero. Call this when the body is teleported or gets a distant new target.
    pub fn reset_integrals(&mut self) {
        self.lin_integral = Vector::ZERO;
        self.ang_integral = ANG_ZERO;
    }

    /// [`PdController::linear_rigid_body_correction`] with the integral term. `dt` is the length of the step
    /// in seconds.
    pub fn linear_rigid_body_correction(
        &mut self,
        dt: Real,
        rb: &RigidBody,
        target_pos: Vector,
        target_linvel: Vector,
    ) -> Vector {
        let target = Pose::from_parts(target_pos, *rb.rotation());
        let target_vels = RigidBodyVelocity::new(target_linvel, rb.angvel());
        self.rigid_body_correction(dt, rb, target, target_vels).linvel
    }

    /// [`PdController::angular_rigid_body_correction`] with the integral term. `dt` is the length of the step
    /// in seconds.
    pub fn angular_rigid_body_correction(
        &mut self,
        dt: Real,
        rb: &RigidBody,
        target_rot: Rotation,
        target_angvel: AngVector,
    ) -> AngVector {
        let target = Pose::from_parts(rb.translation(), target_rot);
        let target_vels = RigidBodyVelocity::new(rb.linvel(), target_angvel);
        self.rigid_body_correction(dt, rb, target, target_vels).angvel
    }

    /// [`PdController::rigid_body_correction`] with the integral term. `dt` is the length of the step in
    /// seconds.
    pub fn rigid_body_correction(
        &mut self,
        dt: Real,
        rb: &RigidBody,
        target_pose: Pose,
        target_vels: RigidBodyVelocity,
    ) -> RigidBodyVelocity {
        self.correction(dt, &pose_errors(rb, &target_pose), &velocity_errors(rb, &target_vels))
    }

    /// [`PdController::correction`] with the integral term. The pose errors during `dt` seconds are first
    /// added to the integrals.
    ///
    /// Errors and times that are not finite, and times that are not positive, are not integrated.
    pub fn correction(
        &mut self,
        dt: Real,
        pose_errors: &PdErrors,
        vel_errors: &PdErrors,
    ) -> RigidBodyVelocity {
        let axes = self.pd.axes;
        let lin_integral = self.lin_integral + pose_errors.linear * axes.linear() * dt;
        let ang_integral = self.ang_integral + pose_errors.angular * axes.angular() * dt;
        let is_sound = dt > 0.0 && lin_integral.is_finite() && ang_is_finite(ang_integral);
        if is_sound {
            (self.lin_integral, self.ang_integral) = (lin_integral, ang_integral);
        } else {
            log::warn!(
                "PidController: the errors {pose_errors:?} in {dt} s are not finite and are not integrated"
            );
        }
        let pd = self.pd.correction(pose_errors, vel_errors);
        sound(RigidBodyVelocity {
            linvel: pd.linvel + self.lin_ki * self.lin_integral,
            angvel: pd.angvel + self.ang_ki * self.ang_integral,
        })
    }
}
