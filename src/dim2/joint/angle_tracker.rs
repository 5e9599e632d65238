//! The angle of a free axis while the bodies move, lane by lane.

use crate::base::wide::{Lane, Wide};
use crate::dim2::joint_angle::FreeRotations;
use crate::dim2::joint_axes::JointAxis;
use crate::dim2::math::Real;
use crate::dim2::wide::{WideAngVector, WideRotation};

/// Measures one angle of each lane's joint.
#[derive(Clone, Debug)]
pub(crate) struct AngleTracker {
    /// One in lanes that have an angle, zero in others.
    turns: Lane,
    /// The angle when the step began.
    angle: Lane,
}

impl AngleTracker {
    /// No angle in any lane.
    pub const NONE: Self = Self { turns: Lane::ZERO, angle: Lane::ZERO };

    /// Measures the angle of an axis, of this size when the step begins.
    pub fn set_lane(
        &mut self,
        lane: usize,
        _axis: JointAxis,
        _rotations: FreeRotations,
        angle: Real,
    ) {
        (self.turns.0[lane], self.angle.0[lane]) = (1.0, angle);
    }

    /// The gradient of the angle, and the angle, after a relative rotation of the bodies by `rotvec`. There
    /// is one axis only, and rotations about it add up.
    #[inline(always)]
    pub fn measure<W: Wide>(
        &self,
        _between: WideRotation<W>,
        rotvec: WideAngVector<W>,
    ) -> (WideAngVector<W>, W) {
        let turns = W::load(&self.turns);
        let rotvec = W::select(W::zero().lt(turns), rotvec, W::zero());
        (turns, W::load(&self.angle) + rotvec)
    }
}
