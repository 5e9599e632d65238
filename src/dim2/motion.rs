//! Free motion of bodies in 2D: a record of whole registers, and its integration lane by lane.
//!
//! # Gyroscopic motion
//! 2D has none, because it has only one axis of rotation.

use super::math::{AngVector, Real, Rotation, Vector};
use super::state::WideMotion;
use super::wide::{WideAngVector, WideVector};
use crate::base::wide::{Wide, gather_adjacent};
use parry::mass_properties::MassProperties;

/// The rotation at 0, the acceleration at 2, the damping at 5 and 6.
const RECORD_LEN: usize = 8;
const PILE_FLAG: usize = 7;

/// Data for the integration of a body; no constraint reads it.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(32))]
pub(crate) struct FreeMotion([Real; RECORD_LEN]);

impl FreeMotion {
    /// Neither accelerates nor is damped.
    pub fn at_rest(rotation: Rotation) -> Self {
        Self::new(rotation, Vector::ZERO, 0.0, [0.0; 2], true)
    }

    /// A body with this orientation, linear and angular acceleration by gravity and the user's forces
    /// (length/s², rad/s²), and linear and angular damping (1/s).
    ///
    /// `may_be_in_pile`: whether the body may be part or support of a pile. Gravity acts on its parts.
    pub fn new(
        rotation: Rotation,
        linear: Vector,
        angular: AngVector,
        [linear_damping, angular_damping]: [Real; 2],
        may_be_in_pile: bool,
    ) -> Self {
        let (q, a, flag) = (rotation, linear, if may_be_in_pile { 1.0 } else { 0.0 });
        Self([q.re, q.im, a.x, a.y, angular, linear_damping, angular_damping, flag])
    }

    /// Enables gyroscopic motion if necessary: never in 2D.
    pub fn with_gyroscope(self, _: &MassProperties, _: AngVector, _: Real) -> Self {
        self
    }

    /// Rotation of the body when the step began.
    pub fn rotation(&self) -> Rotation {
        Rotation { re: self.0[0], im: self.0[1] }
    }

    /// The acceleration by gravity and the user's forces (length/s²).
    pub fn linear_acceleration(&self) -> Vector {
        Vector::new(self.0[2], self.0[3])
    }

    /// Returns whether the angular velocity changes as the body rotates.
    pub fn is_gyroscopic(&self) -> bool {
        false
    }

    /// Returns whether the body may be part or support of a pile.
    pub fn may_be_in_pile(&self) -> bool {
        self.0[PILE_FLAG] != 0.0
    }

    /// Notes that joints hold the body, which only gyroscopic motion distinguishes.
    pub fn note_joint(&mut self) {}

    /// Rotates a gyroscopic body by this angle.
    pub fn rotate(&mut self, _: AngVector) {}
}

/// Returns whether the inertia of a body changes in a step: it never does, in the plane.
pub(crate) fn is_uneven(_: &MassProperties, _: AngVector, _: Real) -> bool {
    false
}

/// The velocities of up to `LANES` bodies after `h` seconds, if these are theirs and nothing holds them.
#[inline(always)]
pub(crate) fn accelerated<W: Wide>(
    bodies: &mut [FreeMotion],
    WideMotion { linear, angular }: WideMotion<W>,
    h: Real,
) -> WideMotion<W> {
    let own = gather_adjacent::<W, _, RECORD_LEN>(bodies, |body| &body.0);
    let (one, substep) = (W::splat(1.0), W::splat(h));
    let linear_acceleration = WideVector { x: own[2], y: own[3] };
    // Damping is integrated implicitly: v' = v + h a - h c v' never overshoots zero.
    let linear = (linear + linear_acceleration * substep) * (one / (one + substep * own[5]));
    let angular = (angular + own[4] * substep) * (one / (one + substep * own[6]));
    WideMotion { linear, angular }
}

/// The angular velocities of up to `LANES` bodies without the torques of a substep: those of its `start`.
#[inline(always)]
pub(crate) fn without_forces<W: Wide>(
    _: &[FreeMotion],
    start: WideAngVector<W>,
    _: WideAngVector<W>,
    _: Real,
) -> WideAngVector<W> {
    start
}

/// Rotates up to `LANES` gyroscopic bodies: there are none in 2D.
#[inline(always)]
pub(crate) fn gyroscopic<W: Wide>(
    _bodies: &mut [FreeMotion],
    _velocity: &mut WideAngVector<W>,
    _before: &mut WideAngVector<W>,
    _h: Real,
) {
}

/// The angular velocity of one body in a while, which may lie in the past, if nothing acts on it: the same.
pub(crate) fn angvel_at(
    _mass: &MassProperties,
    _turned: (Rotation, Rotation),
    angvel: AngVector,
    _h: Real,
) -> AngVector {
    angvel
}
