//! The general form of every joint: frames, and the constraint of each axis.

use super::motor::check_threshold;
use super::{
    InvalidJoint, JointLimits, JointMotor, JointSoftness, MotorModel, STIFFEST, SpringCoefficients,
    Transmission, spring_of,
};
use crate::base::measure::is_point;
use crate::dim::joint_axes::{JointAxesMask, JointAxis, frame_along};
use crate::dim::math::{DIM, Pose, Real, Rotation, SPATIAL_DIM, Vector};
use crate::model::check::checked_pose;

/// Whether a joint acts.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum JointEnabled {
    /// The joint acts.
    #[default]
    Enabled,
    /// The joint does not act, because one of its bodies is disabled. It acts again when the body is enabled.
    DisabledByAttachedBody,
    /// The joint does not act: it was switched off, or it broke.
    Disabled,
}

/// A joint between two bodies in full generality: each axis can be locked, limited or driven.
///
/// The joint has a frame on each body, and its axes are those of the first frame. A position along an axis is
/// that of the second frame's origin. An angle is that of the second frame relative to the first. Where all
/// rotations are free, the *swing* tilts the second frame's X axis relative to the first's, and the *twist*
/// rotates about it. `AngX` is the twist, `AngY` and `AngZ` are the components of the swing. Where two are
/// free, their angles are the components of the whole rotation vector: [`GenericJoint::angle`].
///
/// Setters refuse unusable values: they log a warning, and the old value stays. The methods called `try_…`
/// return the error instead.
///
/// ```
/// # use rapier3d::prelude::*;
/// // A joint that lets one body slide a metre along X and turn about it: a piston.
/// let piston = GenericJointBuilder::new(
///     JointAxesMask::LOCKED_FIXED_AXES - JointAxesMask::LIN_X - JointAxesMask::ANG_X,
/// )
/// .limits(JointAxis::LinX, [0.0, 1.0])
/// .build();
/// assert_eq!(piston.limits(JointAxis::LinX).map(|limits| limits.max), Some(1.0));
/// ```
//
// The order of the fields is fixed (`repr(C)`): limits and motors are large, and few joints have them.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct GenericJoint {
    /// The joint's frame on the first body, in that body's frame.
    pub local_frame1: Pose,
    /// The joint's frame on the second body, in that body's frame.
    pub local_frame2: Pose,
    /// Axes along or about which relative motion of the bodies is locked.
    pub locked_axes: JointAxesMask,
    /// Axes whose [`Self::limits`](#structfield.limits) are active.
    pub limit_axes: JointAxesMask,
    /// Axes whose [`Self::motors`] are active.
    pub motor_axes: JointAxesMask,
    /// Axes that are measured together: two or three translations as one distance, two or three rotations as
    /// one angle. The limits and the motor of the first of these axes apply to the common distance or angle.
    pub coupled_axes: JointAxesMask,
    /// Softness of the locked axes (default `None`: as stiff as possible, see
    /// [`joint_erp`](crate::model::params::IntegrationParameters::joint_erp)).
    pub softness: JointSoftness,
    /// Force between the bodies above which the joint breaks (mass·length/s²; default: infinite).
    pub break_force: Real,
    /// Torque between the bodies above which the joint breaks (mass·length²/s²; default: infinite).
    pub break_torque: Real,
    /// Whether the colliders of the two bodies collide with each other (default: yes).
    pub contacts_enabled: bool,
    /// Whether the joint acts.
    pub enabled: JointEnabled,
    /// Limits by axis (length units or radians).
    pub limits: [JointLimits; SPATIAL_DIM],
    /// Motors by axis.
    pub motors: [JointMotor; SPATIAL_DIM],
    /// The transmission of gears and pulleys; `None` of other joints.
    pub transmission: Option<Transmission>,
    /// User data.
    pub user_data: u128,
}

impl Default for GenericJoint {
    fn default() -> Self {
        Self {
            local_frame1: Pose::IDENTITY,
            local_frame2: Pose::IDENTITY,
            locked_axes: JointAxesMask::empty(),
            limit_axes: JointAxesMask::empty(),
            motor_axes: JointAxesMask::empty(),
            coupled_axes: JointAxesMask::empty(),
            limits: [JointLimits::default(); SPATIAL_DIM],
            motors: [JointMotor::default(); SPATIAL_DIM],
            transmission: None,
            softness: STIFFEST,
            break_force: Real::INFINITY,
            break_torque: Real::INFINITY,
            contacts_enabled: true,
            enabled: JointEnabled::Enabled,
            user_data: 0,
        }
    }
}

/// The axis as a set of axes.
pub(crate) fn mask_of(axis: JointAxis) -> JointAxesMask {
    JointAxesMask::from_bits_truncate(1 << axis as u8)
}

/// Treatment of a refused value in a plain setter.
#[cold]
pub(super) fn log_refusal(error: InvalidJoint) {
    log::warn!("{error}; the old value stays");
}

/// The direction of an axis that a user gave.
fn direction(axis: Vector) -> Result<Vector, InvalidJoint> {
    let unit = if is_point(axis) { axis.normalize_or_zero() } else { Vector::ZERO };
    if unit == Vector::ZERO { Err(InvalidJoint::Axis { axis }) } else { Ok(unit) }
}

impl GenericJoint {
    /// A joint that locks some axes and leaves the others free.
    pub fn new(locked_axes: JointAxesMask) -> Self {
        Self { locked_axes, ..Self::default() }
    }

    /// Locks more axes.
    pub fn lock_axes(&mut self, axes: JointAxesMask) -> &mut Self {
        self.locked_axes |= axes;
        self
    }

    /// Returns whether the joint acts.
    pub fn is_enabled(&self) -> bool {
        self.enabled == JointEnabled::Enabled
    }

    /// Switches the joint on or off. An enabled joint does not act while one of its bodies is disabled.
    pub fn set_enabled(&mut self, enabled: bool) {
        self.enabled = match (self.enabled, enabled) {
            (JointEnabled::Disabled, true) => JointEnabled::Enabled,
            (unchanged, true) => unchanged,
            (_, false) => JointEnabled::Disabled,
        };
    }

    // ---- Frames ----

    /// Sets the joint's frame on the first body, in that body's frame.
    pub fn set_local_frame1(&mut self, frame: Pose) -> &mut Self {
        set_frame(&mut self.local_frame1, frame);
        self
    }

    /// Sets the joint's frame on the second body, in that body's frame.
    pub fn set_local_frame2(&mut self, frame: Pose) -> &mut Self {
        set_frame(&mut self.local_frame2, frame);
        self
    }

    /// The joint's first axis on the first body, in that body's frame: of unit length.
    pub fn local_axis1(&self) -> Vector {
        self.local_frame1.rotation * Vector::X
    }

    /// The joint's first axis on the second body, in that body's frame: of unit length.
    pub fn local_axis2(&self) -> Vector {
        self.local_frame2.rotation * Vector::X
    }

    /// Sets the joint's first axis on the first body, in that body's frame. Its length does not matter.
    pub fn set_local_axis1(&mut self, axis: Vector) -> &mut Self {
        let _ = self.try_set_local_axis1(axis).map_err(log_refusal);
        self
    }

    /// Sets the joint's first axis on the second body, in that body's frame. Its length does not matter.
    pub fn set_local_axis2(&mut self, axis: Vector) -> &mut Self {
        let _ = self.try_set_local_axis2(axis).map_err(log_refusal);
        self
    }

    /// [`Self::set_local_axis1`].
    ///
    /// # Errors
    /// If the axis has no direction; the old one stays.
    pub fn try_set_local_axis1(&mut self, axis: Vector) -> Result<(), InvalidJoint> {
        self.local_frame1.rotation = frame_along(direction(axis)?);
        Ok(())
    }

    /// [`Self::set_local_axis2`].
    ///
    /// # Errors
    /// If the axis has no direction; the old one stays.
    pub fn try_set_local_axis2(&mut self, axis: Vector) -> Result<(), InvalidJoint> {
        self.local_frame2.rotation = frame_along(direction(axis)?);
        Ok(())
    }

    /// The rotation of a joint frame whose first axis is this one, as [`Self::set_local_axis1`] sets it. An
    /// axis without direction gives no rotation.
    pub fn complete_ang_frame(axis: Vector) -> Rotation {
        direction(axis).map_or(Rotation::IDENTITY, frame_along)
    }

    /// The anchor on the first body, in that body's frame.
    pub fn local_anchor1(&self) -> Vector {
        self.local_frame1.translation
    }

    /// The anchor on the second body, in that body's frame.
    pub fn local_anchor2(&self) -> Vector {
        self.local_frame2.translation
    }

    /// Sets the anchor on the first body, in that body's frame (length units).
    pub fn set_local_anchor1(&mut self, anchor: Vector) -> &mut Self {
        let _ = self.try_set_local_anchor1(anchor).map_err(log_refusal);
        self
    }

    /// Sets the anchor on the second body, in that body's frame (length units).
    pub fn set_local_anchor2(&mut self, anchor: Vector) -> &mut Self {
        let _ = self.try_set_local_anchor2(anchor).map_err(log_refusal);
        self
    }

    /// [`Self::set_local_anchor1`].
    ///
    /// # Errors
    /// If a coordinate is not finite, or too large to calculate with; the old anchor stays.
    pub fn try_set_local_anchor1(&mut self, anchor: Vector) -> Result<(), InvalidJoint> {
        set_anchor(&mut self.local_frame1, anchor)
    }

    /// [`Self::set_local_anchor2`].
    ///
    /// # Errors
    /// If a coordinate is not finite, or too large to calculate with; the old anchor stays.
    pub fn try_set_local_anchor2(&mut self, anchor: Vector) -> Result<(), InvalidJoint> {
        set_anchor(&mut self.local_frame2, anchor)
    }

    /// Exchanges the roles of the two bodies.
    ///
    /// Positions, angles, limits and targets change their signs.
    pub fn flip(&mut self) {
        core::mem::swap(&mut self.local_frame1, &mut self.local_frame2);
        if let Some(transmission) = &mut self.transmission {
            return transmission.flip();
        }
        for axis in JointAxis::ALL {
            if self.coupled_axes.contains(mask_of(axis)) {
                continue; // distances have no sign
            }
            let limits = &mut self.limits[axis as usize];
            (limits.min, limits.max) = (-limits.max, -limits.min);
            limits.impulse = -limits.impulse;
            let motor = &mut self.motors[axis as usize];
            motor.target_pos = -motor.target_pos;
            motor.target_vel = -motor.target_vel;
            motor.impulse = -motor.impulse;
        }
    }

    // ---- Contacts, softness, breaking ----

    /// Returns whether the colliders of the two bodies collide with each other.
    pub fn contacts_enabled(&self) -> bool {
        self.contacts_enabled
    }

    /// Sets whether the colliders of the two bodies collide with each other (default: yes). Sensors of one
    /// body detect the other body in both cases.
    ///
    /// If several joints join the same bodies, one with `false` suffices to disable the contacts. A disabled
    /// joint disables none. Switched off at run time, contacts end in the next step: with a `Stopped` event,
    /// and bodies that they held wake.
    pub fn set_contacts_enabled(&mut self, enabled: bool) -> &mut Self {
        self.contacts_enabled = enabled;
        self
    }

    /// Softness of the locked axes.
    pub fn softness(&self) -> JointSoftness {
        self.softness
    }

    /// The spring of the locked axes; `None` for a joint that is as stiff as the solver allows.
    pub(crate) fn spring(&self) -> Option<SpringCoefficients> {
        spring_of(self.softness)
    }

    /// Sets the softness of the locked axes: a spring, or `None` for the stiffest joint of the solver.
    pub fn set_softness(&mut self, softness: impl Into<JointSoftness>) -> &mut Self {
        let softness = softness.into();
        match spring_of(softness).map_or(Ok(()), |spring| spring.check()) {
            Ok(()) => self.softness = softness,
            Err(error) => log_refusal(error),
        }
        self
    }

    /// Sets the largest force (first number) and torque (second number), above which the joint breaks.
    ///
    /// They are compared after each step with [`ImpulseJoint::force`](super::ImpulseJoint::force) and
    /// [`ImpulseJoint::torque`](super::ImpulseJoint::torque), the mean values over that step. A joint that
    /// breaks is disabled, and the [`EventHandler`](crate::model::event::EventHandler) is called.
    pub fn set_break_thresholds(&mut self, force: Real, torque: Real) -> &mut Self {
        let force_is_usable = check_threshold("the force at which a joint breaks", force);
        match force_is_usable
            .and_then(|()| check_threshold("the torque at which a joint breaks", torque))
        {
            Ok(()) => (self.break_force, self.break_torque) = (force, torque),
            Err(error) => log_refusal(error),
        }
        self
    }

    // ---- Limits and motors ----

    /// The range of an axis; `None` if it has no limits.
    pub fn limits(&self, axis: JointAxis) -> Option<&JointLimits> {
        let has_limits = self.limit_axes.contains(mask_of(axis));
        has_limits.then(|| &self.limits[axis as usize])
    }

    /// Sets the range of an axis (length units or radians).
    pub fn set_limits(&mut self, axis: JointAxis, limits: [Real; 2]) -> &mut Self {
        let _ = self.try_set_limits(axis, limits).map_err(log_refusal);
        self
    }

    /// [`Self::set_limits`].
    ///
    /// # Errors
    /// If the first limit is above the second, or one is NaN; the old limits stay.
    pub fn try_set_limits(
        &mut self,
        axis: JointAxis,
        limits: [Real; 2],
    ) -> Result<(), InvalidJoint> {
        let limits = JointLimits::from(limits);
        limits.check(axis)?;
        let impulse = self.limits[axis as usize].impulse;
        self.limits[axis as usize] = JointLimits { impulse, ..limits };
        self.limit_axes |= mask_of(axis);
        Ok(())
    }

    /// The motor of an axis; `None` if it has no motor.
    pub fn motor(&self, axis: JointAxis) -> Option<&JointMotor> {
        self.motor_axes.contains(mask_of(axis)).then(|| &self.motors[axis as usize])
    }

    /// The motor model of an axis; `None` if it has no motor.
    pub fn motor_model(&self, axis: JointAxis) -> Option<MotorModel> {
        self.motor(axis).map(|motor| motor.model)
    }

    /// Sets the motor model of an axis.
    pub fn set_motor_model(&mut self, axis: JointAxis, model: MotorModel) -> &mut Self {
        self.motors[axis as usize].model = model;
        self
    }

    /// Drives an axis at a velocity (length/s or rad/s). `factor` is the damping of the motor.
    pub fn set_motor_velocity(
        &mut self,
        axis: JointAxis,
        target_vel: Real,
        factor: Real,
    ) -> &mut Self {
        let target_pos = self.motors[axis as usize].target_pos;
        self.set_motor(axis, target_pos, target_vel, 0.0, factor)
    }

    /// Drives an axis to a position (length units or radians), like a spring with a damper.
    pub fn set_motor_position(
        &mut self,
        axis: JointAxis,
        target_pos: Real,
        stiffness: Real,
        damping: Real,
    ) -> &mut Self {
        self.set_motor(axis, target_pos, 0.0, stiffness, damping)
    }

    /// Sets the largest force (or torque) of an axis's motor.
    pub fn set_motor_max_force(&mut self, axis: JointAxis, max_force: Real) -> &mut Self {
        match check_threshold("the maximum force of a motor", max_force) {
            Ok(()) => self.motors[axis as usize].max_force = max_force,
            Err(error) => log_refusal(error),
        }
        self
    }

    /// Drives an axis to a position with `stiffness`, and at a velocity with `damping`.
    pub fn set_motor(
        &mut self,
        axis: JointAxis,
        target_pos: Real,
        target_vel: Real,
        stiffness: Real,
        damping: Real,
    ) -> &mut Self {
        let old = self.motors[axis as usize];
        let motor = JointMotor { target_pos, target_vel, stiffness, damping, ..old };
        let _ = self.try_set_motor(axis, motor).map_err(log_refusal);
        self
    }

    /// Replaces an axis's motor.
    ///
    /// # Errors
    /// If one of its numbers is out of its range; the old motor stays.
    pub fn try_set_motor(
        &mut self,
        axis: JointAxis,
        motor: JointMotor,
    ) -> Result<(), InvalidJoint> {
        motor.check()?;
        self.motors[axis as usize] = motor;
        self.motor_axes |= mask_of(axis);
        Ok(())
    }

    /// Checks that every number is usable. The setters guarantee it, but assignments to the fields are
    /// unchecked.
    ///
    /// An invalid joint does not act until its values are valid.
    ///
    /// # Errors
    /// If a value is unusable. The error contains the first one.
    pub fn validate(&self) -> Result<(), InvalidJoint> {
        for frame in [self.local_frame1, self.local_frame2] {
            checked_pose(frame).ok_or(InvalidJoint::Frame { frame })?;
        }
        for axes in [self.locked_axes, self.limit_axes, self.motor_axes, self.coupled_axes] {
            let unknown = axes.bits() & !JointAxesMask::all().bits();
            (unknown == 0).then_some(()).ok_or(InvalidJoint::UnknownAxes { axes })?;
        }
        for axis in JointAxis::ALL {
            self.limits(axis).map_or(Ok(()), |limits| limits.check(axis))?;
            self.motor(axis).map_or(Ok(()), JointMotor::check)?;
        }
        self.check_transmission()?;
        self.spring().map_or(Ok(()), |spring| spring.check())?;
        check_threshold("the force at which a joint breaks", self.break_force)?;
        check_threshold("the torque at which a joint breaks", self.break_torque)
    }

    /// Returns whether the axis is measured together with others, as one distance or angle.
    pub(crate) fn is_measured_together(&self, axis: JointAxis) -> bool {
        let linear = (axis as usize) < DIM;
        let group = if linear { JointAxesMask::LIN_AXES } else { JointAxesMask::ANG_AXES };
        let coupled = self.coupled_axes & !self.locked_axes & group;
        coupled.contains(mask_of(axis)) && coupled.bits().count_ones() > 1
    }

    /// The free axes that have a motor or limits: of coupled ones the first.
    pub(crate) fn driven_axes(&self) -> impl Iterator<Item = JointAxis> + use<> {
        let free = !self.locked_axes;
        let driven = free & (self.limit_axes | self.motor_axes);
        let coupled_axes = self.coupled_axes;
        let (linear, angular) = (JointAxesMask::LIN_AXES, JointAxesMask::ANG_AXES);
        JointAxis::ALL.into_iter().filter(move |&axis| {
            let group = if (axis as usize) < DIM { linear } else { angular };
            let coupled = coupled_axes & free & group;
            let is_first = mask_of(axis).bits() == coupled.bits() & coupled.bits().wrapping_neg();
            driven.contains(mask_of(axis)) && (!coupled.contains(mask_of(axis)) || is_first)
        })
    }
}

fn set_frame(target: &mut Pose, frame: Pose) {
    match checked_pose(frame) {
        Some(frame) => *target = frame,
        None => log_refusal(InvalidJoint::Frame { frame }),
    }
}

fn set_anchor(frame: &mut Pose, anchor: Vector) -> Result<(), InvalidJoint> {
    if !is_point(anchor) {
        return Err(InvalidJoint::Anchor { anchor });
    }
    frame.translation = anchor;
    Ok(())
}

/// The rotation of a frame against another: `rotation1⁻¹ · rotation2`.
pub(crate) fn relative_rotation(rotation1: &Rotation, rotation2: &Rotation) -> Rotation {
    rotation1.inverse() * *rotation2
}
