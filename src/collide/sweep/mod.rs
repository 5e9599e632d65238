//! Time of impact of two moving shapes.
//!
//! Conservative advancement (Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996). Two
//! convex parts at the distance `d`, along the direction `n` between their closest points, cannot touch
//! before
//!
//! ```text
//! t + d / ((v1 - v2)·n + |ω1| r1 + |ω2| r2)
//! ```
//!
//! because until then a plane across `n` separates them. `r` is the largest distance of a part's points from
//! its centre of rotation. So the search jumps ahead by that, and ends where the parts are within a tolerance
//! or cannot meet any more. Shapes of several parts are searched part by part. Only parts near the path are
//! searched.
//!
//! Root finding on a selected pair of features (Catto, "Continuous Collision", GDC 2013) takes fewer steps
//! for fast rotations. Conservative advancement needs no features, so every shape with a support function
//! works.
//!
//! ## Cores
//! A body that slides over a floor of many pieces touches the next piece all the time, and must not be
//! stopped by it. Contacts push a body that penetrates something at the end of a step out to the original
//! side, as long as its middle is outside. The middle must never pass through. The search therefore uses the
//! *core* first: the shape without an outer layer nearly as deep as its thickness, half its minimum width
//! ([`CORE_DEPTH_FRACTION`], [`Widths`]). If the core would hit, the body is stopped where its surface
//! touches, unless it touched from the beginning. In that case it is stopped where it is a quarter deep
//! ([`PENETRATION_FRACTION_MAX`]), so that contacts push a deeply penetrating body out on the original side.
//!
//! A rod may have an end of its core in the wall already, by its rotation. Then the search uses the middle
//! half of the core, and if that is inside, the centre.
//!
//! A triangle or a segment has no inside and no core. It is stopped at its first new contact of the step.
//! If one of its corners touched before, the search uses its middle half, and then its centre.
//!
//! ## Sides
//! Surfaces with one side stop what comes from their front, which their contacts push back ([`sides`]).
//!
//! ## Sensors
//! Sensors stop nothing, but crossings are reported: [`passes`] returns whether two shapes are apart at both
//! ends of the motion, and meet in between.

mod body;
mod motion;
mod plane;
mod sides;
mod touch;

pub(crate) use motion::{PathSegment, Sweep, turned};
pub(crate) use touch::{Touch, find_touches};

use super::part::Part;
use super::parts::{Line, Near, Parts};
use super::queries::shapes_intersect;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::{Collider, Widths};
use body::Body;
use motion::reach_about;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::shape::Shape;
use sides::{is_behind, moves_to_front};

/// Depth of a shape's core below its surface, as a fraction of the shape's thickness. The core of a ball is
/// nearly a point. The core of a capsule is nearly its axis, and the core of a board is a thinner board.
const CORE_DEPTH_FRACTION: Real = 0.98;
/// Sizes of the searched cores, as fractions of the first. A body with one end in a collider must still keep
/// its middle outside.
const CORES: [Real; 3] = [1.0, 0.5, 0.0];
/// Depth of contacts, as a fraction of the shape's thickness, above which CCD limits the motion.
pub(crate) const PENETRATION_FRACTION_MAX: Real = 0.25;
/// A deeper body moves by this fraction of the path that is left until its middle is inside. A body that
/// spins while deep in a wall must be able to rotate, or it would stop for ever.
const REMAINING_FRACTION: Real = 0.5;
/// Final distance of a core from the other shape, as a fraction of the shape's thickness.
const CORE_TOLERANCE: Real = 0.05;
/// A core that is initially nearer than this fraction of it, and approaches, is stopped at once. Repeated
/// halving would be lost in rounding, and the core would be inside.
const GAP_FRACTION_MIN: Real = 0.6;
/// Largest number of jumps of a search: more than an approach at the tolerance needs that rotates through
/// hundreds of times the thickness. Each segment allows one more.
const JUMPS_MAX: usize = 256;

/// Goal of the search.
#[derive(Copy, Clone, Debug)]
pub(crate) struct SweepGoal {
    /// The gap at which shapes touch (length units).
    pub gap: Real,
    /// Treatment of parts in contact at the beginning.
    pub overlap: Overlap,
}

/// A shape, and the widths of its parts where these are kept.
#[derive(Copy, Clone)]
pub(crate) struct Solid<'a> {
    pub shape: &'a dyn Shape,
    pub widths: Option<&'a [Widths]>,
}

impl<'a> Solid<'a> {
    /// The shape of a collider.
    pub fn of(collider: &'a Collider) -> Self {
        Self { shape: collider.shape(), widths: collider.widths.as_deref() }
    }

    /// The same, computed once for all pairs of a part: these follow each other. `last` are the part and the
    /// widths of the last call.
    fn widths_once(&self, part: &Part<'_>, last: &mut Option<(u32, Widths)>) -> Widths {
        let known = last.filter(|(id, _)| *id == part.id).map(|(_, widths)| widths);
        let widths = known.unwrap_or_else(|| self.widths_of(part));
        *last = Some((part.id, widths));
        widths
    }

    fn widths_of(&self, part: &Part<'_>) -> Widths {
        let known = self.widths.and_then(|widths| widths.get(part.id as usize));
        known.copied().unwrap_or_else(|| Widths::of(part.shape))
    }
}

/// Treatment of a core that penetrates while its surface has touched since the start of the step.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Overlap {
    /// Contacts alone limit the penetration.
    Passes,
    /// It is stopped where its core arrives.
    StopsMiddle,
    /// It is stopped before contacts would be deeper than [`PENETRATION_FRACTION_MAX`]: deeper contacts may
    /// push it out on the wrong side.
    StopsEarly,
    /// It is stopped after [`REMAINING_FRACTION`] of the path to where its core arrives.
    StopsHalfway,
}

/// The fraction of the step at which the second shape stops the first; `None` if not before `until`.
pub(crate) fn first_impact(
    solid: Solid<'_>,
    other: &dyn Shape,
    sweeps: [&Sweep<'_>; 2],
    goal: SweepGoal,
    until: Real,
) -> Option<Real> {
    let (mut first, mut last) = (None, None);
    for_each_pair([solid.shape, other], sweeps, &mut |parts| {
        let until = first.unwrap_or(until);
        let widths = solid.widths_once(parts[0].part, &mut last);
        if is_behind(parts, widths.center, 0.0) {
            return;
        }
        first = impact_of_parts(parts, &widths, goal, until).or(first);
    });
    first
}

/// A part of a shape, and its motion.
#[derive(Copy, Clone)]
struct MovingPart<'a, 'b> {
    part: &'a Part<'b>,
    sweep: &'a Sweep<'b>,
}

/// Calls `visit` with the parts of two shapes that may meet, and their motions.
fn for_each_pair(
    shapes: [&dyn Shape; 2],
    sweeps: [&Sweep<'_>; 2],
    visit: &mut dyn FnMut([MovingPart<'_, '_>; 2]),
) {
    // The parts of one shape that the whole of the other may meet.
    let near = [0, 1].map(|side| match Parts::of(shapes[side]) {
        Parts::Convex(_) => Near::Inside(Aabb::new_invalid()), // The only part is always in.
        _ => path_of_other(shapes, sweeps, side),
    });
    for_each_pair_near(shapes, sweeps, near, visit);
}

/// Calls `visit` with the parts of two shapes in a region of each, and their motions.
fn for_each_pair_near(
    shapes: [&dyn Shape; 2],
    sweeps: [&Sweep<'_>; 2],
    near: [Near; 2],
    visit: &mut dyn FnMut([MovingPart<'_, '_>; 2]),
) {
    let parts = shapes.map(Parts::of);
    parts[0].for_each_part(&near[0], &mut |part1| {
        let sweep1 = sweeps[0].of_part(&part1.pose());
        parts[1].for_each_part(&near[1], &mut |part2| {
            let sweep2 = sweeps[1].of_part(&part2.pose());
            visit([
                MovingPart { part: &part1, sweep: &sweep1 },
                MovingPart { part: &part2, sweep: &sweep2 },
            ]);
        });
    });
}

/// Returns whether two shapes meet during their motion although they are apart at both ends. A distance below
/// `tolerance` counts as meeting.
pub(crate) fn passes(
    shapes: [&dyn Shape; 2],
    sweeps: [&Sweep<'_>; 2],
    until: Real,
    tolerance: Real,
) -> bool {
    let goal = Goal::new(0.0, tolerance, true);
    let (mut meet, mut met) = (false, false);
    for_each_pair(shapes, sweeps, &mut |parts| {
        let bodies = Body::whole(parts[0].part.shape).zip(other_of(parts, tolerance));
        let Some((body1, body2)) = bodies.filter(|_| !met) else { return };
        match advance([&body1, &body2], parts.map(|moving| moving.sweep), goal, until) {
            Meeting::FromTheBeginning => met = true,
            Meeting::At(_) => meet = true,
            Meeting::Never => {}
        }
    });
    let [end1, end2] = sweeps.map(|sweep| sweep.at(until));
    meet && !met && !shapes_intersect(&end1.inv_mul(&end2), shapes[0], shapes[1])
}

/// Returns whether the first shape is deeper in the second than [`PENETRATION_FRACTION_MAX`] at the end of
/// its motion.
pub(crate) fn ends_deep(solid: Solid<'_>, other: &dyn Shape, sweeps: [&Sweep<'_>; 2]) -> bool {
    let ends = sweeps.map(|sweep| Sweep::at_rest(sweep.at(1.0)));
    let (mut deep, mut last) = (false, None);
    let shapes = [solid.shape, other];
    for_each_pair(shapes, [&ends[0], &ends[1]], &mut |parts| {
        if deep {
            return;
        }
        let part = parts[0].part;
        let widths = solid.widths_once(part, &mut last);
        let thickness = widths.thickness;
        let is_surface = thickness == 0.0 || thickness == Real::INFINITY;
        if is_surface || is_behind(parts, widths.center, 1.0) {
            return;
        }
        let own = Body::core(part.shape, &widths, PENETRATION_FRACTION_MAX);
        let Some((own, other)) = own.zip(other_of(parts, 0.0)) else { return };
        let poses = parts.map(|moving| moving.sweep.at(1.0));
        deep = own.distance(&other, &poses, 0.0, Vector::ZERO).is_some();
    });
    deep
}

/// A region, in the frame of the shape on a side, around all places of the other shape.
fn path_of_other(shapes: [&dyn Shape; 2], sweeps: [&Sweep<'_>; 2], side: usize) -> Near {
    let (own, other, shape) = (sweeps[side], sweeps[1 - side], shapes[1 - side]);
    let start = own.at(0.0);
    let center = start.inverse_transform_point(other.center());
    let [distance, angle] = own.travel();
    let region = other.region(shape).loosened(distance).transform_by(&start.inverse());
    if angle == 0.0 {
        let together = distance == 0.0 || own.stop == other.stop;
        let straight = own.straight().zip(other.straight()).filter(|_| together);
        let line = straight.and_then(|(own, segment)| {
            let displacement =
                start.rotation.inverse() * ((segment.shift - own.shift) * other.stop);
            Line::new(center, displacement, reach_about(shape, other.local_center), region)
        });
        return line.map_or(Near::Inside(region), Near::Along);
    }
    if let Some(chord_error) = chord_error_of_other(own, other) {
        // The region grows by the path's chord error in the rotating frame.
        let end = own.at(1.0).inverse_transform_point(other.at(1.0) * other.local_center);
        let path = Aabb::new(center.min(end), center.max(end));
        return Near::Inside(path.loosened(chord_error + reach_about(shape, other.local_center)));
    }
    // In a rotating frame, the other shape moves by at most the sum of both motions.
    let away = center.length() + other.travel()[0];
    Near::Inside(region.loosened(angle * (away + own.local_center.length())))
}

/// The second part, as far as the first comes within `near` of it. The moving shape is treated as a whole.
fn other_of<'b>([moving, other]: [MovingPart<'_, 'b>; 2], near: Real) -> Option<Body<'b>> {
    let body = Body::whole(other.part.shape)?;
    if other.sweep.travel() != [0.0; 2] {
        return Some(body);
    }
    let region = moving.sweep.region(moving.part.shape).loosened(near);
    Some(body.within(&region.transform_by(&other.sweep.at(0.0).inverse())))
}

/// Deviation of one centre from its chord, in the frame of the other that rotates by `θ`, if both move
/// straight. With `d` from one centre of rotation to the other, `p = R(-θs) d(s)` has a second derivative of
/// at most `θ² d + 2 θ ḋ`. A curve is within an eighth of that from its chord.
fn chord_error_of_other(own: &Sweep<'_>, other: &Sweep<'_>) -> Option<Real> {
    let (segment, other_segment) = own.straight().zip(other.straight())?;
    let speed = (other_segment.shift - segment.shift).length();
    let away = (other_segment.center - segment.center).length() + speed;
    let is_whole = own.stop >= 1.0 && other.stop >= 1.0;
    is_whole.then(|| segment.angle() * (segment.angle() * away + 2.0 * speed) / 8.0)
}

/// Returns the time (fraction of the step) at which the second part stops the first.
fn impact_of_parts(
    parts: [MovingPart<'_, '_>; 2],
    widths: &Widths,
    goal: SweepGoal,
    until: Real,
) -> Option<Real> {
    let (own_shape, sweeps) = (parts[0].part.shape, parts.map(|moving| moving.sweep));
    let thickness = widths.thickness;
    if thickness == Real::INFINITY {
        return None;
    }
    let whole = Body::whole(own_shape)?;
    let other = other_of(parts, goal.gap)?;
    let goal_of_whole = Goal::new(goal.gap, 0.5 * goal.gap, false);
    if thickness == 0.0 {
        return CORES.iter().find_map(|&fraction| {
            let own = Body::middle(own_shape, widths, fraction)?;
            match advance([&own, &other], sweeps, goal_of_whole, until) {
                Meeting::FromTheBeginning => None,
                Meeting::At(fraction) if moves_to_front(parts, &own, fraction) => None,
                meeting => Some(meeting.fraction()),
            }
        })?;
    }
    let tolerance = (CORE_TOLERANCE * thickness).max(goal.gap);
    let core_goal = Goal::new(0.0, tolerance, true);
    let latest = CORES.iter().find_map(|&fraction| {
        let core = Body::core(own_shape, widths, CORE_DEPTH_FRACTION)?.shrunk(fraction);
        match advance([&core, &other], sweeps, core_goal, until) {
            Meeting::FromTheBeginning => None,
            Meeting::At(fraction) if moves_to_front(parts, &core, fraction) => None,
            meeting => Some(meeting.fraction()),
        }
    })??;
    match advance([&whole, &other], sweeps, goal_of_whole, latest) {
        Meeting::At(fraction) if moves_to_front(parts, &whole, fraction) => Some(latest),
        Meeting::At(fraction) => Some(fraction),
        Meeting::Never => Some(latest),
        Meeting::FromTheBeginning => match goal.overlap {
            Overlap::Passes => None,
            Overlap::StopsMiddle => Some(latest),
            Overlap::StopsHalfway => Some(REMAINING_FRACTION * latest),
            Overlap::StopsEarly => {
                let shallow = Body::core(own_shape, widths, PENETRATION_FRACTION_MAX)?;
                let goal = Goal::new(0.0, goal_of_whole.tolerance, true);
                Some(match advance([&shallow, &other], sweeps, goal, latest) {
                    Meeting::At(fraction) => fraction,
                    Meeting::Never => latest,
                    Meeting::FromTheBeginning => REMAINING_FRACTION * latest,
                })
            }
        },
    }
}

/// Distance at which parts have met.
#[derive(Copy, Clone, Debug)]
struct Goal {
    gap: Real,
    tolerance: Real,
    /// Whether initially near parts count as meeting when they come half as near, or nearer than
    /// [`GAP_FRACTION_MIN`].
    counts_at_once: bool,
    /// The fraction of the step at which the search begins.
    from: Real,
    jumps_max: usize,
}

impl Goal {
    /// From the beginning of the step.
    fn new(gap: Real, tolerance: Real, counts_at_once: bool) -> Self {
        Self { gap, tolerance, counts_at_once, from: 0.0, jumps_max: JUMPS_MAX }
    }
}

/// Closing motion of two parts.
#[derive(Copy, Clone, Debug, PartialEq)]
enum Meeting {
    /// The parts do not meet.
    Never,
    /// They have met when the step begins.
    FromTheBeginning,
    /// After this fraction of the step.
    At(Real),
}

impl Meeting {
    /// The fraction of the step after which separated parts meet.
    fn fraction(self) -> Option<Real> {
        match self {
            Self::At(fraction) => Some(fraction),
            Self::Never | Self::FromTheBeginning => None,
        }
    }
}

/// Jumps ahead until two bodies have met.
fn advance(
    bodies: [&Body<'_>; 2],
    sweeps: [&Sweep<'_>; 2],
    mut goal: Goal,
    until: Real,
) -> Meeting {
    let reaches = [0, 1].map(|k| bodies[k].reach_about(sweeps[k].local_center));
    let closing_max = closing_max(sweeps, reaches, until);
    let jumps = goal.jumps_max + sweeps[0].segments().len() + sweeps[1].segments().len();
    let (mut fraction, mut last_normal, tolerance) = (goal.from, Vector::ZERO, goal.tolerance);
    for _ in 0..jumps {
        let poses = sweeps.map(|sweep| sweep.at(fraction));
        let reach = goal.gap + goal.tolerance + closing_max * (until - fraction);
        let Some((normal, dist)) = bodies[0].distance(bodies[1], &poses, reach, last_normal) else {
            return Meeting::Never;
        };
        last_normal = normal;
        let across = poses[0].rotation * normal;
        let nearing = (sweeps[0].velocity(fraction) - sweeps[1].velocity(fraction)).dot(across);
        let closing =
            nearing + turning(sweeps.map(|sweep| sweep.segment(fraction).angle()), reaches);
        if dist <= goal.gap + goal.tolerance {
            if fraction > goal.from {
                return Meeting::At(fraction);
            }
            let may_come_nearer = goal.counts_at_once && dist > goal.gap;
            if !may_come_nearer {
                return Meeting::FromTheBeginning;
            }
            let half = 0.5 * (dist - goal.gap);
            if half < 0.5 * GAP_FRACTION_MIN * goal.tolerance && closing > 0.0 {
                let soon = (fraction + half / closing).min(until);
                let poses = sweeps.map(|sweep| sweep.at(soon));
                let then = bodies[0].distance(bodies[1], &poses, reach, normal);
                // The centre of a rod may approach a wall while its rotation takes the near end away. Such a
                // rod must not be stopped.
                if then.is_some_and(|(_, then)| then < dist) {
                    return Meeting::At(goal.from);
                }
            }
            goal.tolerance = half;
        } else if dist > goal.gap + tolerance {
            // It has left the initially near part, and may be stopped early again.
            goal.tolerance = tolerance;
        }
        // The distance is less than contact: closest points of touching shapes are not always found.
        let next = fraction + (dist - goal.gap - 0.5 * goal.tolerance) / closing.max(0.0);
        let change = sweeps[0].next_change(fraction).min(sweeps[1].next_change(fraction));
        // The bound holds up to the next change of velocity.
        fraction = if next > change { change } else { next };
        // The quotient is infinite if the shapes separate. A comparison with NaN is false.
        let may_meet = fraction < until;
        if !may_meet {
            return Meeting::Never;
        }
    }
    Meeting::At(fraction)
}

/// Bound on the closing speed of two bodies (length units per step), until a fraction of the step.
fn closing_max(sweeps: [&Sweep<'_>; 2], reaches: [Real; 2], until: Real) -> Real {
    let [straight1, straight2] =
        sweeps.map(|sweep| sweep.straight().filter(|_| sweep.stop >= until));
    if let Some((segment1, segment2)) = straight1.zip(straight2) {
        let turning = turning([segment1.angle(), segment2.angle()], reaches);
        return (segment1.shift - segment2.shift).length() + turning;
    }
    let fastest = |speed: fn(&PathSegment) -> Real| {
        sweeps.map(|sweep| sweep.segments().iter().map(speed).fold(0.0, Real::max))
    };
    let shifts = fastest(|segment| segment.shift.length());
    shifts[0] + shifts[1] + turning(fastest(PathSegment::angle), reaches)
}

/// Bound on the closing speed by rotation of bodies with this extent. A shape without rotation may be
/// infinite.
fn turning(angles: [Real; 2], reaches: [Real; 2]) -> Real {
    let of = |k: usize| if angles[k] > 0.0 { angles[k] * reaches[k] } else { 0.0 };
    of(0) + of(1)
}

/// A box around a shape's core at a pose, plus the tolerance of the search. It is the box of the shape if
/// that has several parts.
fn box_of_core(solid: Solid<'_>, pose: &Pose) -> Aabb {
    let whole = || solid.shape.compute_aabb(pose);
    let Parts::Convex(shape) = Parts::of(solid.shape) else { return whole() };
    let widths = solid.widths_of(&Part::whole(shape));
    let core = Body::core(shape, &widths, CORE_DEPTH_FRACTION);
    core.filter(|_| widths.thickness > 0.0)
        .map_or_else(whole, |core| core.aabb(pose).loosened(CORE_TOLERANCE * widths.thickness))
}
