//! Time at which a moving shape touches another one, and the parts that touch. For queries: nothing is
//! stopped here, and a graze counts as much as an impact.
//!
//! The motion may contain a million revolutions. Three rules bound the search for motions of any length:
//!
//! * No point of a part gets farther from its centre of rotation than at the start. Shapes can touch only
//!   while a box around this ball overlaps the box of the shape at rest.
//! * A shape that rotates in place has swept its full region after one revolution.
//! * After [`JUMPS_MAX`] jumps the search ends at its current time, before which it found no contact.

use super::body::Body;
use super::motion::reach_about;
use super::plane::RotatingPlane;
use super::{
    Goal, Meeting, MovingPart, Overlap, Sweep, SweepGoal, advance, impact_of_parts, other_of,
};
use crate::base::bvh::SlabProbe;
use crate::collide::part::Part;
use crate::collide::parts::Near;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::Widths;
use parry::bounding_volume::BoundingVolume;
use parry::shape::Shape;

/// Maximum number of jumps. It is sufficient for a rotation of one radian about a shape of the same length,
/// at a tenth of its speed. The remaining relative distance is 10⁻⁵.
pub(super) const JUMPS_MAX: usize = 1024;
/// A full revolution and the rounding error (rad).
const TURN_ANGLE_MAX: Real = 6.3;

/// Two shapes that touch during their motion.
pub(crate) struct Touch<'a> {
    /// The fraction of the motions at which they touch.
    pub fraction: Real,
    pub sides: [TouchedPart<'a>; 2],
}

/// A part that is touched.
pub(crate) struct TouchedPart<'a> {
    pub id: u32,
    pub shape: &'a dyn Shape,
    /// Its place in the frame of the shape.
    pub place: Pose,
}

impl<'a> TouchedPart<'a> {
    fn new(part: &Part<'a>) -> Self {
        Self { id: part.id, shape: part.shape, place: part.pose() }
    }
}

/// Calls `found` with touches, each earlier than the one before it: the last one is the first of all. A
/// distance below `tolerance` counts as touching. Shapes that touch from the beginning touch `at_once`, or
/// only when its middle penetrates.
pub(crate) fn find_touches(
    shapes: [&dyn Shape; 2],
    sweeps: [&Sweep<'_>; 2],
    tolerance: Real,
    at_once: bool,
    found: &mut dyn FnMut(Touch<'_>),
) {
    let mut until = 1.0;
    let mut visit = |pair: [MovingPart<'_, '_>; 2]| {
        if let Some(fraction) = touch_of_parts(pair, tolerance, at_once, until) {
            debug_assert!(
                (0.0..=until).contains(&fraction),
                "each touch is earlier than the last one"
            );
            until = fraction;
            let sides = pair.map(|moving| TouchedPart::new(moving.part));
            found(Touch { fraction, sides });
        }
    };
    let rotates = |side: usize| sweeps[side].travel()[1] > 0.0;
    if [0, 1].into_iter().any(|side| shapes[side].as_halfspace().is_some() && rotates(side)) {
        // The half-space may touch any part.
        let all = shapes.map(|shape| {
            let aabb = shape.compute_local_aabb();
            Near::Inside(aabb.loosened(aabb.half_extents().max_element()))
        });
        super::for_each_pair_near(shapes, sweeps, all, &mut visit);
    } else {
        super::for_each_pair(shapes, sweeps, &mut visit);
    }
}

/// Returns the fraction of the step at which two parts touch, if it is at most `until`.
fn touch_of_parts(
    pair: [MovingPart<'_, '_>; 2],
    tolerance: Real,
    at_once: bool,
    until: Real,
) -> Option<Real> {
    if let Some(plane) = RotatingPlane::of(pair) {
        return plane.first_touch(tolerance, at_once, until);
    }
    let part1 = pair[0].part;
    let [from, until] = window(pair, tolerance, until)?;
    let (body1, body2) = (Body::whole(part1.shape)?, other_of(pair, tolerance)?);
    let goal = Goal { gap: 0.0, tolerance, counts_at_once: false, from, jumps_max: JUMPS_MAX };
    match advance([&body1, &body2], pair.map(|moving| moving.sweep), goal, until) {
        Meeting::At(fraction) => Some(fraction),
        Meeting::Never => None,
        Meeting::FromTheBeginning if at_once || from > 0.0 => Some(from),
        Meeting::FromTheBeginning => {
            let goal = SweepGoal { gap: tolerance, overlap: Overlap::StopsMiddle };
            impact_of_parts(pair, &Widths::of(part1.shape), goal, until)
        }
    }
}

/// The fractions between which two parts may touch.
fn window([one, two]: [MovingPart<'_, '_>; 2], tolerance: Real, until: Real) -> Option<[Real; 2]> {
    let (Some(segment), true) = (one.sweep.straight(), two.sweep.travel() == [0.0; 2]) else {
        return Some([0.0, until]);
    };
    let reach = reach_about(one.part.shape, one.sweep.local_center) + tolerance;
    if !reach.is_finite() {
        return Some([0.0, until]);
    }
    let other = two.part.shape.compute_aabb(&two.sweep.at(0.0));
    let probe = SlabProbe::new(segment.center, segment.shift, Vector::splat(reach));
    let [enter, leave] = probe.span(&other);
    let turned = if segment.shift == Vector::ZERO {
        TURN_ANGLE_MAX / segment.angle()
    } else {
        Real::INFINITY
    };
    let until = until.min(leave).min(turned);
    (enter <= until).then_some([enter.max(0.0), until])
}
