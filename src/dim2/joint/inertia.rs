//! The inertias of jointed bodies.

use crate::base::wide::{Lane, Wide};
use crate::dim2::math::{AngularInertia, Real};
use crate::dim2::state::WideDisplacement;
use crate::dim2::wide::{
    WideSymmetric, ZERO_INERTIA, load_symmetric, set_symmetric_lane, symmetric_lane,
};

/// The moment of inertia of a body with this inverse; `None` if it cannot rotate.
pub(crate) fn inertia_about(inv_inertia: &AngularInertia) -> Option<Real> {
    (*inv_inertia > 0.0).then(|| 1.0 / inv_inertia)
}

/// Returns whether the moments of inertia about all axes are equal. In 2D there is one.
pub(crate) fn is_round(_inv_inertia: &AngularInertia) -> bool {
    true
}

/// The inverse inertias of the two bodies of each lane's joint. In 2D they stay the same when the bodies
/// turn.
#[derive(Clone, Debug)]
pub(crate) struct JointedInertias([WideSymmetric<Lane>; 2]);

impl JointedInertias {
    /// No body in any lane.
    pub const NONE: Self = Self([ZERO_INERTIA; 2]);

    /// Sets the inverse inertia of one lane's first (0) or second (1) body.
    pub fn set_lane(
        &mut self,
        side: usize,
        lane: usize,
        value: &AngularInertia,
        _is_gyroscopic: bool,
    ) {
        set_symmetric_lane(&mut self.0[side], lane, value);
    }

    /// Returns whether the world-space inertia of a body of this lane changes with its rotation: never in 2D.
    pub fn is_gyroscopic(&self, _lane: usize) -> bool {
        false
    }

    /// The current inertia of one lane's first or second body.
    pub fn lane(&self, side: usize, lane: usize) -> AngularInertia {
        symmetric_lane(&self.0[side], lane)
    }

    /// The inertias of all lanes, in memory.
    #[inline(always)]
    pub fn lanes(&self) -> &[WideSymmetric<Lane>; 2] {
        &self.0
    }

    /// The inertias of all lanes.
    #[inline(always)]
    pub fn load<W: Wide>(&self) -> [WideSymmetric<W>; 2] {
        [load_symmetric(&self.0[0]), load_symmetric(&self.0[1])]
    }

    /// The bodies have turned since the step began.
    #[inline(always)]
    pub fn rotate<W: Wide>(&mut self, _displacements: &[WideDisplacement<W>; 2]) {}
}

/// The inertia of a body whose moment is 1.
#[cfg(test)]
pub(crate) fn unit_inertia() -> AngularInertia {
    1.0
}
