//! Coordinates of transmissions, and their rows.
//!
//! A transmission relates a coordinate of one body to a coordinate of another, each relative to the world
//! ([`Transmission`](crate::model::joint::Transmission)):
//!
//! ```text
//! q = r₁ q₁ + r₂ q₂          q̇ = Σ r J v
//!
//! angle       q = a·φ                              J = (0, a)
//! shift       q = a·(p - p₀)                       J = (a, L × a)
//! distance    q = |p - g|, n = (p - g)/q           J = (n, L × n)
//! ```
//!
//! with the axis `a` of the body's joint frame, the rotation vector `φ` of the body since the step began, the
//! anchor `p` with the moment arm `L`, and a point `g` of the world. Angles and shifts begin at 0 in each
//! step, along the axis at its start, which is exact for a fixed axis. The count of the earlier steps is
//! added.
//!
//! The direction of a distance is undefined at the point `g`, and a light body that a heavy one pulls there
//! would pass it in each substep and let the rope run out. Such an end is blocked: see [`End::is_blocked`].

use crate::dim::math::{
    ANG_ZERO, AngVector, Real, Rotation, SpatialVector, Vector, ang_dot, cross, integrate_rotation,
    torque,
};
use crate::dim::spatial::{ANG_AXES, angular, join, linear, turn_axis};
use crate::model::joint::{Transmission, TransmissionEnd};

/// Number of substeps before a point at which an end is blocked: the body may get faster in between.
const BLOCKED_SUBSTEPS: Real = 2.0;

/// One end when the step began, in world space.
#[derive(Copy, Clone, Debug)]
pub(super) struct End {
    kind: TransmissionEnd,
    ratio: Real,
    /// The centre of mass, and the way from it to the anchor.
    center: Vector,
    arm: Vector,
    /// The first axis of the joint frame, and the axis of rotation.
    axis: Vector,
    about: AngVector,
}

/// One end where its body is now.
#[derive(Copy, Clone, Debug)]
pub(super) struct EndNow {
    /// The coordinate times its ratio, without what was counted.
    pub coordinate: Real,
    /// The force of a unit impulse at the anchor, and the couple.
    pub force: Vector,
    pub couple: AngVector,
    /// From the centre of mass to the anchor.
    pub arm: Vector,
}

/// The motion of a body since the step began.
#[derive(Copy, Clone, Debug)]
pub(super) struct Moved {
    shift: Vector,
    turn: Rotation,
    rotvec: AngVector,
}

impl Moved {
    /// No motion.
    pub const NONE: Self = Self { shift: Vector::ZERO, turn: Rotation::IDENTITY, rotvec: ANG_ZERO };

    /// By a displacement.
    pub fn by((shift, rotvec): (Vector, AngVector)) -> Self {
        Self { shift, turn: integrate_rotation(Rotation::IDENTITY, rotvec), rotvec }
    }

    /// By these velocities for the time `h`, too.
    pub fn further(&self, (v, w): (Vector, AngVector), h: Real) -> Self {
        Self {
            shift: self.shift + v * h,
            turn: integrate_rotation(self.turn, w * h),
            rotvec: self.rotvec + w * h,
        }
    }
}

impl End {
    /// The end of a transmission on one side. When the step began, the body had its centre of mass there, the
    /// anchor at the end of this arm, and the joint frame this rotation.
    pub fn new(
        of: &Transmission,
        side: usize,
        center: Vector,
        arm: Vector,
        frame: Rotation,
    ) -> Self {
        let (axis, about) = (frame * Vector::X, turn_axis(frame, ANG_AXES[0]));
        Self { kind: of.ends[side], ratio: of.ratios[side], center, arm, axis, about }
    }

    /// The end after its body has moved.
    pub fn after(&self, moved: &Moved) -> EndNow {
        let Self { kind, ratio, center, arm, axis, about } = *self;
        let arm_now = moved.turn * arm;
        let (coordinate, force, couple) = match kind {
            TransmissionEnd::Angle => (ang_dot(about, moved.rotvec), Vector::ZERO, about),
            TransmissionEnd::Shift => (axis.dot(moved.shift + (arm_now - arm)), axis, ANG_ZERO),
            TransmissionEnd::Distance { from } => {
                let way = (center - from) + (moved.shift + arm_now);
                let distance = way.length();
                let direction = if distance > 0.0 { way / distance } else { axis };
                (distance, direction, ANG_ZERO)
            }
        };
        let (coordinate, force, couple) = (coordinate * ratio, force * ratio, couple * ratio);
        EndNow { coordinate, force, couple, arm: arm_now }
    }

    /// Returns whether an anchor with this speed can reach its point of the world within the time `h`. Then
    /// the other end alone is limited.
    pub fn is_blocked(&self, now: &EndNow, velocity: &SpatialVector, h: Real) -> bool {
        self.is_distance() && now.coordinate.abs() <= BLOCKED_SUBSTEPS * now.speed(velocity) * h
    }

    /// The angle (rad) by which a displacement rotates it; 0 of other coordinates.
    pub fn angle_after(&self, (_, rotvec): (Vector, AngVector)) -> Real {
        if self.is_angle() { ang_dot(self.about, rotvec) } else { 0.0 }
    }

    /// Returns whether its coordinate is an angle.
    pub fn is_angle(&self) -> bool {
        self.kind == TransmissionEnd::Angle
    }

    /// Returns whether its coordinate is measured in each step, and not counted.
    pub fn is_distance(&self) -> bool {
        matches!(self.kind, TransmissionEnd::Distance { .. })
    }
}

impl EndNow {
    /// The row `J` of the body: also the wrench of a unit impulse about its centre of mass.
    pub fn row(&self) -> SpatialVector {
        join(self.force, torque(self.arm, self.force) + self.couple)
    }

    /// The size of the velocity of the anchor, times the ratio of a coordinate that depends on it.
    pub fn speed(&self, velocity: &SpatialVector) -> Real {
        let at_anchor = linear(velocity) + cross(angular(velocity), self.arm);
        at_anchor.length() * self.force.length()
    }
}
