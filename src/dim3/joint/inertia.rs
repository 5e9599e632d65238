//! The inertias of jointed bodies.

use crate::base::wide::{Lane, Wide};
use crate::dim3::math::{AngularInertia, Real};
use crate::dim3::rotation_vector::turned_inertia;
use crate::dim3::state::WideDisplacement;
use crate::dim3::wide::{
    WideSymmetric, ZERO_INERTIA, load_symmetric, set_symmetric_lane, store_symmetric,
    symmetric_lane,
};

/// The harmonic mean of the moments of inertia of a body with this inverse; `None` if it cannot rotate.
pub(crate) fn inertia_about(inv_inertia: &AngularInertia) -> Option<Real> {
    let sum = inv_inertia.m11 + inv_inertia.m22 + inv_inertia.m33;
    (sum > 0.0).then(|| 3.0 / sum)
}

/// Least relative difference of two moments of inertia that counts.
const MOMENT_DIFFERENCE_MIN: Real = 1.0e-3;

/// Returns whether the moments of inertia about all axes are equal.
pub(crate) fn is_round(inv_inertia: &AngularInertia) -> bool {
    let m = inv_inertia;
    let differences = [m.m11 - m.m22, m.m22 - m.m33, m.m33 - m.m11, m.m12, m.m13, m.m23];
    let largest =
        differences.into_iter().fold(0.0, |largest: Real, value| largest.max(value.abs()));
    largest <= MOMENT_DIFFERENCE_MIN * (m.m11 + m.m22 + m.m33)
}

/// The inverse inertias of the two bodies of each lane's joint.
#[derive(Clone, Debug)]
pub(crate) struct JointedInertias {
    /// Inertias when the step began.
    start: [WideSymmetric<Lane>; 2],
    /// Inertias at the last relax pass.
    now: [WideSymmetric<Lane>; 2],
    /// One where a body rotates so much that its inertia must be rotated, otherwise zero. The result is
    /// independent of the other lanes, and all joints of a body get the same inertia to the last bit.
    is_gyroscopic: [Lane; 2],
    /// Whether any lane is gyroscopic.
    any_gyroscopic: bool,
}

impl JointedInertias {
    /// No body in any lane.
    pub const NONE: Self = Self {
        start: [ZERO_INERTIA; 2],
        now: [ZERO_INERTIA; 2],
        is_gyroscopic: [Lane::ZERO; 2],
        any_gyroscopic: false,
    };

    /// Sets the inverse inertia of one lane's first (0) or second (1) body, and whether it will turn with the
    /// body.
    pub fn set_lane(
        &mut self,
        side: usize,
        lane: usize,
        value: &AngularInertia,
        is_gyroscopic: bool,
    ) {
        set_symmetric_lane(&mut self.start[side], lane, value);
        set_symmetric_lane(&mut self.now[side], lane, value);
        if is_gyroscopic {
            self.is_gyroscopic[side].0[lane] = 1.0;
            self.any_gyroscopic = true;
        }
    }

    /// Returns whether the world-space inertia of a body of this lane changes with its rotation.
    pub fn is_gyroscopic(&self, lane: usize) -> bool {
        self.is_gyroscopic.iter().any(|is_gyroscopic| is_gyroscopic.0[lane] != 0.0)
    }

    /// The current inertia of one lane's first or second body.
    pub fn lane(&self, side: usize, lane: usize) -> AngularInertia {
        symmetric_lane(&self.now[side], lane)
    }

    /// The current inertias of all lanes, in memory.
    #[inline(always)]
    pub fn lanes(&self) -> &[WideSymmetric<Lane>; 2] {
        &self.now
    }

    /// The current inertias of all lanes.
    #[inline(always)]
    pub fn load<W: Wide>(&self) -> [WideSymmetric<W>; 2] {
        [load_symmetric(&self.now[0]), load_symmetric(&self.now[1])]
    }

    /// Rotates the inertias by the displacements since the step began.
    #[inline(always)]
    pub fn rotate<W: Wide>(&mut self, displacements: &[WideDisplacement<W>; 2]) {
        if !self.any_gyroscopic {
            return;
        }
        for side in 0..2 {
            let is_gyroscopic = W::zero().lt(W::load(&self.is_gyroscopic[side]));
            let rotation = displacements[side].rotation_where(is_gyroscopic);
            let turned = turned_inertia(load_symmetric::<W>(&self.start[side]), rotation);
            store_symmetric(turned, &mut self.now[side]);
        }
    }
}

/// The inertia of a body whose moments are all 1.
#[cfg(test)]
pub(crate) fn unit_inertia() -> AngularInertia {
    AngularInertia { m11: 1.0, m22: 1.0, m33: 1.0, ..AngularInertia::zero() }
}
