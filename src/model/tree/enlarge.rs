//! Margin of a collider's fat AABB.
//!
//! A larger margin means fewer updates and more pairs. Pairs dominate the cost in piles, updates in the air.
//! The margin on all sides is therefore small, and a moving collider gets a margin ahead of it for the next
//! few steps.

use super::TreeKind;
use crate::base::measure::BOX_COORDINATE_MAX;
use crate::dim::math::{Real, Vector};
use parry::bounding_volume::{Aabb, BoundingVolume};

/// Margin on all sides, as a fraction of the smallest half extent of the box. A tenth costs a pile of boxes
/// no further neighbours, and a body that rocks a little does not leave it.
const MARGIN_FRACTION: Real = 0.1;
/// Number of steps of motion that the margin ahead covers. More would pair falling piles with everything
/// below them.
const STEPS_AHEAD: Real = 2.0;
/// The margin ahead is limited to this many half extents. A faster collider leaves its box in every step
/// anyway, and a long box would only find more neighbours.
const MOTION_MARGIN_FRACTION_MAX: Real = 0.5;
/// A box this large represents an infinite one, as of a half-space, and is cut at the limit.
const EXTENT_UNBOUNDED_MIN: Real = Real::MAX * 0.25;

/// Input of the margin.
#[derive(Copy, Clone, Debug)]
pub(crate) struct BoxMargin {
    /// Distance at which contacts must be found, per collider: half the prediction distance plus the
    /// contact skin (length units).
    pub reach: Real,
    /// Expected motion during the next step (length units, world space).
    pub travel: Vector,
}

impl BoxMargin {
    /// The box in which contacts must be found; `None` if it is not finite or beyond the limits.
    pub fn needed(&self, tight: &Aabb) -> Option<Aabb> {
        let size = tight.mins.abs().max(tight.maxs.abs()).max_element();
        let is_finite = tight.mins.is_finite() && tight.maxs.is_finite() && self.reach.is_finite();
        if !is_finite || (size > BOX_COORDINATE_MAX && size < EXTENT_UNBOUNDED_MIN) {
            return None;
        }
        Some(limited(tight.loosened(self.reach.max(0.0))))
    }

    /// The box that goes into the tree.
    pub fn enlarged(&self, needed: &Aabb, kind: TreeKind) -> Aabb {
        if kind == TreeKind::Fixed {
            return *needed; // seldom moves, so any margin would only find more neighbours
        }
        let half = needed.half_extents();
        let margin = Vector::splat((MARGIN_FRACTION * half.min_element()).max(self.reach));
        let travel = if self.travel.is_finite() { self.travel } else { Vector::ZERO };
        let limit = Vector::splat(MOTION_MARGIN_FRACTION_MAX * half.max_element());
        let ahead = (travel * STEPS_AHEAD).clamp(-limit, limit);
        let (back, forth) = (ahead.min(Vector::ZERO), ahead.max(Vector::ZERO));
        limited(Aabb::new(needed.mins - margin + back, needed.maxs + margin + forth))
    }
}

/// The box within the limits of the world.
fn limited(aabb: Aabb) -> Aabb {
    let limit = Vector::splat(BOX_COORDINATE_MAX);
    Aabb::new(aabb.mins.clamp(-limit, limit), aabb.maxs.clamp(-limit, limit))
}
