//! The solver's data of a body, in 2D: two records of whole registers.
//!
//! A constraint gathers the records of its two bodies, one lane per constraint, and a gather reads whole
//! registers. Records are therefore arrays of numbers. Their meaning is stated here; `step/solver/states.rs`
//! relies on the order velocity, displacement.

use super::math::{AngVector, AngularInertia, Real, Rotation, Vector, integrate_rotation};
use super::rotation_vector::rotation_by;
use super::wide::{WideAngVector, WideRotation, WideSymmetric, WideVector};
use crate::base::wide::{LANES, Wide};
use core::ops::Sub;

/// Marks a body index of a constraint whose body the constraint must not write: a fixed or kinematic
/// one, or the world. Such bodies may be in many constraints that are solved at the same time.
pub(crate) const READ_ONLY: u32 = 1 << 31;

/// Numbers in a velocity or displacement: two linear, one angular. The real part of the rotation follows the
/// velocity, the imaginary one the displacement.
pub(crate) const MOTION_LEN: usize = 4;
pub(crate) const STATE_LEN: usize = 2 * MOTION_LEN;
pub(crate) const POSE_LEN: usize = 8;

/// The part of a state that a write covers: its velocity and, where a register is longer than that (single
/// precision), the displacement behind it.
pub(crate) const WRITTEN_LEN: usize = if LANES > MOTION_LEN { LANES } else { MOTION_LEN };

/// State that changes from substep to substep; read and written by every constraint in every pass.
///
/// One register in single precision, one cache line in double precision.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(32))]
pub(crate) struct BodyState(pub [Real; STATE_LEN]);

const _: () = assert!(size_of::<BodyState>() == 8 * size_of::<Real>());

impl Default for BodyState {
    fn default() -> Self {
        Self::AT_REST
    }
}

impl BodyState {
    /// A body that neither moves nor has moved.
    pub const AT_REST: Self = Self([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);

    /// Velocity of the centre of mass and angular velocity, in world space.
    #[inline]
    pub fn velocity(&self) -> (Vector, AngVector) {
        let s = &self.0;
        (Vector::new(s[0], s[1]), s[2])
    }

    /// Replaces both velocities.
    #[inline]
    pub fn set_velocity(&mut self, linvel: Vector, angvel: AngVector) {
        self.0[0..2].copy_from_slice(&linvel.to_array());
        self.0[2] = angvel;
    }

    /// Displacement of the centre of mass, and rotation of the body, since the step began.
    #[inline]
    pub fn displacement(&self) -> (Vector, AngVector) {
        let s = &self.0[MOTION_LEN..];
        (Vector::new(s[0], s[1]), s[2])
    }

    /// Replaces the displacement and the rotation, of which the state stores a second form.
    pub fn set_displacement(&mut self, at: Vector, angle: AngVector) {
        self.0[MOTION_LEN..][..2].copy_from_slice(&at.to_array());
        self.0[MOTION_LEN + 2] = angle;
        let rotation = integrate_rotation(Rotation::IDENTITY, angle);
        (self.0[3], self.0[7]) = (rotation.re, rotation.im);
    }

    /// Takes over the displacement of another.
    pub fn copy_displacement(&mut self, other: &Self) {
        self.0[MOTION_LEN..].copy_from_slice(&other.0[MOTION_LEN..]);
        self.0[3] = other.0[3];
    }
}

/// Data that is constant during a step, except for the inertias of uneven bodies; read when constraints are
/// prepared.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(32))]
pub(crate) struct BodyPose(pub [Real; POSE_LEN]);

impl BodyPose {
    /// The index under which constraints find [`Self::WORLD`].
    pub const WORLD_INDEX: u32 = READ_ONLY;
    /// The world itself: at the origin, and of infinite mass.
    pub const WORLD: Self = Self([1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);

    /// A body with its orientation, centre of mass, inverse mass per axis and inverse inertia, all in
    /// world space.
    pub fn new(
        rotation: Rotation,
        center_of_mass: Vector,
        inv_mass: Vector,
        inv_inertia: &AngularInertia,
    ) -> Self {
        let (q, x, m) = (rotation, center_of_mass, inv_mass);
        Self([q.re, q.im, x.x, x.y, m.x, m.y, *inv_inertia, 0.0])
    }

    /// Centre of mass when the step began.
    pub fn center(&self) -> Vector {
        Vector::new(self.0[2], self.0[3])
    }

    /// Inverse mass per axis.
    pub fn inv_mass(&self) -> Vector {
        Vector::new(self.0[4], self.0[5])
    }

    /// The inverse inertia for contacts.
    pub fn inv_inertia(&self) -> AngularInertia {
        self.0[6]
    }

    /// Replaces the inverse inertia.
    pub fn set_inv_inertia(&mut self, inv_inertia: &AngularInertia) {
        self.0[6] = *inv_inertia;
    }

    /// Returns whether one translation of the body is locked, and the other one is free.
    pub fn has_locked_axis(&self) -> bool {
        let [x, y] = self.inv_mass().to_array();
        (x > 0.0) != (y > 0.0)
    }
}

/// Velocities, or displacements, of one body per lane.
#[derive(Copy, Clone)]
pub(crate) struct WideMotion<W> {
    pub linear: WideVector<W>,
    pub angular: WideAngVector<W>,
}

impl<W: Wide> WideMotion<W> {
    /// No motion in any lane.
    #[inline(always)]
    pub fn none() -> Self {
        Self { linear: WideVector::zero(), angular: W::zero() }
    }
}

impl<W: Wide> Sub for WideMotion<W> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { linear: self.linear - other.linear, angular: self.angular - other.angular }
    }
}

/// Displacement and rotation of one body per lane since the step began.
#[derive(Copy, Clone)]
pub(crate) struct WideDisplacement<W> {
    pub linear: WideVector<W>,
    /// Rotation angle (rad).
    pub angular: WideAngVector<W>,
    /// The rotation. It is computed once, when the body rotates: several joints of the body read it, many
    /// times.
    rotation: WideRotation<W>,
}

impl<W: Wide> WideDisplacement<W> {
    /// By a vector and an angle.
    #[inline(always)]
    pub fn new(linear: WideVector<W>, angular: WideAngVector<W>) -> Self {
        Self { linear, angular, rotation: rotation_by(angular) }
    }

    /// The vector and the angle alone.
    #[inline(always)]
    pub fn motion(&self) -> WideMotion<W> {
        WideMotion { linear: self.linear, angular: self.angular }
    }

    /// The rotation since the step began.
    #[inline(always)]
    pub fn rotation(&self) -> WideRotation<W> {
        self.rotation
    }
}

/// Velocity and displacement of one body per lane.
pub(crate) type WideState<W> = (WideMotion<W>, WideDisplacement<W>);

/// Velocity and displacement from the numbers of a state.
#[inline(always)]
pub(crate) fn motions<W: Wide>(s: [W; STATE_LEN]) -> WideState<W> {
    let velocity = WideMotion { linear: WideVector { x: s[0], y: s[1] }, angular: s[2] };
    let linear = WideVector { x: s[4], y: s[5] };
    (
        velocity,
        WideDisplacement { linear, angular: s[6], rotation: WideRotation { re: s[3], im: s[7] } },
    )
}

/// The numbers of a state.
#[inline(always)]
pub(crate) fn numbers<W: Wide>((v, d): WideState<W>) -> [W; STATE_LEN] {
    let WideRotation { re, im } = d.rotation;
    [v.linear.x, v.linear.y, v.angular, re, d.linear.x, d.linear.y, d.angular, im]
}

/// Poses and inverse masses of one body per lane.
#[derive(Copy, Clone)]
pub(crate) struct WidePose<W> {
    pub rotation: WideRotation<W>,
    pub center_of_mass: WideVector<W>,
    pub inv_mass: WideVector<W>,
    pub inv_inertia: WideSymmetric<W>,
}

/// A pose from its numbers.
#[inline(always)]
pub(crate) fn pose<W: Wide>(p: [W; POSE_LEN]) -> WidePose<W> {
    WidePose {
        rotation: WideRotation { re: p[0], im: p[1] },
        center_of_mass: WideVector { x: p[2], y: p[3] },
        inv_mass: WideVector { x: p[4], y: p[5] },
        inv_inertia: p[6],
    }
}
