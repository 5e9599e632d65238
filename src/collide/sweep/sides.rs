//! Sides of one-sided surfaces: oriented polylines, and meshes and height fields with parry's
//! `FIX_INTERNAL_EDGES`.
//!
//! Contacts push away from the front of such a surface only. A body from behind must not be stopped: no
//! contact would follow, and the body would hang in the air. The middle of a part decides on its side,
//! because the middle is what the search keeps from passing through. While a long body leaves a surface whose
//! back it has passed, its middle is in front, and the rest follows. So a body that moves toward the front is
//! not stopped either.

use super::body::Body;
use super::{MovingPart, Sweep};
use crate::dim::collide::{Flat, as_flat};
use crate::dim::math::{Real, Vector};

/// The front of a part that pushes toward one side: a point of its plane, and the normal.
struct Front {
    origin: Vector,
    normal: Vector,
}

impl Front {
    /// The front of a part at its pose after a fraction of the step; `None` if the part pushes toward both
    /// sides.
    fn of(moving: MovingPart<'_, '_>, fraction: Real) -> Option<Self> {
        let constraints = moving.part.constraints?;
        let flat = as_flat(moving.part.shape).and_then(Flat::new)?;
        let pushes = |side: Vector| constraints.project_local_normal(side).is_some();
        let local_normal = match [flat.normal(), -flat.normal()].map(pushes) {
            [true, false] => flat.normal(),
            [false, true] => -flat.normal(),
            _ => return None,
        };
        let pose = moving.sweep.at(fraction);
        Some(Self { origin: pose * flat.origin(), normal: pose.rotation * local_normal })
    }
}

/// Returns whether the centre of the first part, in its own frame, is behind the second part after a fraction
/// of the step, and the second part does not push toward that side.
pub(super) fn is_behind(
    [own, other]: [MovingPart<'_, '_>; 2],
    center: Vector,
    fraction: Real,
) -> bool {
    Front::of(other, fraction).is_some_and(|front| {
        let center = own.sweep.at(fraction) * center;
        (center - front.origin).dot(front.normal) < 0.0
    })
}

/// Returns whether a body of the first part moves toward the front of the second part after a fraction of the
/// step, so that its lowest point over the front rises.
pub(super) fn moves_to_front(
    [own, other]: [MovingPart<'_, '_>; 2],
    body: &Body<'_>,
    fraction: Real,
) -> bool {
    let Some(Front { normal, .. }) = Front::of(other, fraction) else { return false };
    let pose = own.sweep.at(fraction);
    let Some(lowest) = body.support_point(pose.rotation.inverse() * -normal) else { return false };
    let velocity = |sweep: &Sweep<'_>| sweep.velocity_at(pose * lowest, fraction);
    (velocity(own.sweep) - velocity(other.sweep)).dot(normal) > 0.0
}
