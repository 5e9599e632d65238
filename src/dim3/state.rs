//! The solver's data of a body, in 3D: two records of whole registers.
//!
//! A constraint gathers the records of its two bodies, one lane per constraint, and a gather reads whole
//! registers. Records are therefore arrays of numbers. Their meaning is stated here; `step/solver/states.rs`
//! relies on the order velocity, displacement.

use super::math::{AngVector, AngularInertia, Real, Rotation, Vector};
use super::rotation_vector::{unit_quaternion, wide_unit_quaternion};
use super::wide::{WideAngVector, WideRotation, WideSymmetric, WideVector};
use crate::base::wide::Wide;
use core::ops::Sub;

/// Marks a body index of a constraint whose body the constraint must not write: a fixed or kinematic
/// one, or the world. Such bodies may be in many constraints that are solved at the same time.
pub(crate) const READ_ONLY: u32 = 1 << 31;

/// Numbers in a velocity or displacement: three linear, three angular, two unused. After the displacement
/// they are the rotation as a quaternion: the scale from the rotation vector to its vector part, and its real
/// part.
pub(crate) const MOTION_LEN: usize = 8;
pub(crate) const STATE_LEN: usize = 2 * MOTION_LEN;
pub(crate) const POSE_LEN: usize = 16;

/// The part of a state that a write covers: its velocity.
pub(crate) const WRITTEN_LEN: usize = MOTION_LEN;

/// State that changes from substep to substep; read and written by every constraint in every pass.
///
/// One cache line in single precision.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct BodyState(pub [Real; STATE_LEN]);

const _: () = assert!(size_of::<BodyState>() == 16 * size_of::<Real>());

impl Default for BodyState {
    fn default() -> Self {
        Self::AT_REST
    }
}

impl BodyState {
    /// A body that neither moves nor has moved.
    pub const AT_REST: Self = {
        let mut numbers = [0.0; STATE_LEN];
        (numbers[STATE_LEN - 2], numbers[STATE_LEN - 1]) = (0.5, 1.0);
        Self(numbers)
    };

    /// Velocity of the centre of mass and angular velocity, in world space.
    #[inline]
    pub fn velocity(&self) -> (Vector, AngVector) {
        let s = &self.0;
        (Vector::new(s[0], s[1], s[2]), Vector::new(s[3], s[4], s[5]))
    }

    /// Replaces both velocities.
    #[inline]
    pub fn set_velocity(&mut self, linvel: Vector, angvel: AngVector) {
        self.0[0..3].copy_from_slice(&linvel.to_array());
        self.0[3..6].copy_from_slice(&angvel.to_array());
    }

    /// Displacement of the centre of mass, and rotation of the body, since the step began.
    #[inline]
    pub fn displacement(&self) -> (Vector, AngVector) {
        let s = &self.0[MOTION_LEN..];
        (Vector::new(s[0], s[1], s[2]), Vector::new(s[3], s[4], s[5]))
    }

    /// Replaces the displacement and the rotation, of which the state stores a second form.
    pub fn set_displacement(&mut self, at: Vector, rotvec: AngVector) {
        self.0[MOTION_LEN..][..3].copy_from_slice(&at.to_array());
        self.0[MOTION_LEN + 3..][..3].copy_from_slice(&rotvec.to_array());
        let (scale, real) = unit_quaternion(rotvec);
        (self.0[STATE_LEN - 2], self.0[STATE_LEN - 1]) = (scale, real);
    }

    /// Takes over the displacement of another.
    pub fn copy_displacement(&mut self, other: &Self) {
        self.0[MOTION_LEN..].copy_from_slice(&other.0[MOTION_LEN..]);
    }
}

/// Data that is constant during a step, except for the inertias of uneven bodies; read when constraints are
/// prepared.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct BodyPose(pub [Real; POSE_LEN]);

impl BodyPose {
    /// The index under which constraints find [`Self::WORLD`].
    pub const WORLD_INDEX: u32 = READ_ONLY;
    /// The world itself: at the origin, and of infinite mass.
    pub const WORLD: Self =
        Self([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);

    /// A body with its orientation, centre of mass, inverse mass per axis and inverse inertia, all in
    /// world space.
    pub fn new(
        rotation: Rotation,
        center_of_mass: Vector,
        inv_mass: Vector,
        inv_inertia: &AngularInertia,
    ) -> Self {
        let (q, x, m, i) = (rotation, center_of_mass, inv_mass, inv_inertia);
        Self([
            q.x, q.y, q.z, q.w, x.x, x.y, x.z, m.x, m.y, m.z, i.m11, i.m12, i.m13, i.m22, i.m23,
            i.m33,
        ])
    }

    /// Centre of mass when the step began.
    pub fn center(&self) -> Vector {
        Vector::new(self.0[4], self.0[5], self.0[6])
    }

    /// Inverse mass per axis.
    pub fn inv_mass(&self) -> Vector {
        Vector::new(self.0[7], self.0[8], self.0[9])
    }

    /// The inverse inertia for contacts, in world space.
    pub fn inv_inertia(&self) -> AngularInertia {
        let [m11, m12, m13, m22, m23, m33] = [10, 11, 12, 13, 14, 15].map(|k| self.0[k]);
        AngularInertia { m11, m12, m13, m22, m23, m33 }
    }

    /// Replaces the inverse inertia.
    pub fn set_inv_inertia(&mut self, inv_inertia: &AngularInertia) {
        let i = inv_inertia;
        self.0[10..].copy_from_slice(&[i.m11, i.m12, i.m13, i.m22, i.m23, i.m33]);
    }

    /// Returns whether some translations or some rotations of the body are locked, and others are free.
    pub fn has_locked_axis(&self) -> bool {
        let is_mixed = |numbers: [Real; 3]| {
            numbers.contains(&0.0) && numbers.into_iter().any(|number| number > 0.0)
        };
        let inv_inertia = self.inv_inertia();
        is_mixed(self.inv_mass().to_array())
            || is_mixed([inv_inertia.m11, inv_inertia.m22, inv_inertia.m33])
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
        Self { linear: WideVector::zero(), angular: WideVector::zero() }
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
    /// Rotation vector (rad).
    pub angular: WideAngVector<W>,
    /// The unit quaternion of the rotation: its vector part divided by the rotation vector, and its real
    /// part. They are computed once, when the body rotates: several joints of the body read them, many times.
    scale: W,
    real: W,
}

impl<W: Wide> WideDisplacement<W> {
    /// By a vector and a rotation vector.
    #[inline(always)]
    pub fn new(linear: WideVector<W>, angular: WideAngVector<W>) -> Self {
        let (scale, real) = wide_unit_quaternion(angular);
        Self { linear, angular, scale, real }
    }

    /// The vector and the angle alone.
    #[inline(always)]
    pub fn motion(&self) -> WideMotion<W> {
        WideMotion { linear: self.linear, angular: self.angular }
    }

    /// The rotation since the step began.
    #[inline(always)]
    pub fn rotation(&self) -> WideRotation<W> {
        let WideVector { x, y, z } = self.angular * self.scale;
        WideRotation { x, y, z, w: self.real }
    }

    /// The same in some lanes, and no rotation in the others.
    #[inline(always)]
    pub fn rotation_where(&self, mask: W::Mask) -> WideRotation<W> {
        let WideVector { x, y, z } = self.angular * W::select(mask, self.scale, W::zero());
        WideRotation { x, y, z, w: W::select(mask, self.real, W::splat(1.0)) }
    }
}

/// Velocity and displacement of one body per lane.
pub(crate) type WideState<W> = (WideMotion<W>, WideDisplacement<W>);

/// Velocity and displacement from the numbers of a state.
#[inline(always)]
pub(crate) fn motions<W: Wide>(s: [W; STATE_LEN]) -> WideState<W> {
    let velocity = motion([s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7]]);
    let moved = motion([s[8], s[9], s[10], s[11], s[12], s[13], s[14], s[15]]);
    (
        velocity,
        WideDisplacement {
            linear: moved.linear,
            angular: moved.angular,
            scale: s[14],
            real: s[15],
        },
    )
}

#[inline(always)]
fn motion<W: Wide>(s: [W; MOTION_LEN]) -> WideMotion<W> {
    WideMotion {
        linear: WideVector { x: s[0], y: s[1], z: s[2] },
        angular: WideVector { x: s[3], y: s[4], z: s[5] },
    }
}

/// The numbers of a state.
#[inline(always)]
pub(crate) fn numbers<W: Wide>((v, d): WideState<W>) -> [W; STATE_LEN] {
    let unused = W::zero();
    [
        v.linear.x,
        v.linear.y,
        v.linear.z,
        v.angular.x,
        v.angular.y,
        v.angular.z,
        unused,
        unused,
        d.linear.x,
        d.linear.y,
        d.linear.z,
        d.angular.x,
        d.angular.y,
        d.angular.z,
        d.scale,
        d.real,
    ]
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
        rotation: WideRotation { x: p[0], y: p[1], z: p[2], w: p[3] },
        center_of_mass: WideVector { x: p[4], y: p[5], z: p[6] },
        inv_mass: WideVector { x: p[7], y: p[8], z: p[9] },
        inv_inertia: WideSymmetric {
            m11: p[10],
            m12: p[11],
            m13: p[12],
            m22: p[13],
            m23: p[14],
            m33: p[15],
        },
    }
}
