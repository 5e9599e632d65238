//! When do two shapes that move first touch?
//!
//! Conservative advancement (Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996): two convex
//! parts that are `d` apart along the direction `n` between their closest points cannot touch before
//!
//! ```text
//! t + d / ((v1 - v2)·n + |ω1| r1 + |ω2| r2)
//! ```
//!
//! because until then a plane across `n` parts them; `r` is how far points of a part are from the centre about which
//! it turns. So the search jumps ahead by that, and ends where the parts are within a tolerance or cannot meet any
//! more. Shapes of several parts are searched part by part, those that the path comes near.
//!
//! Root finding on a chosen pair of features (Catto, "Continuous Collision", GDC 2013) takes fewer steps where a
//! thing spins; jumps need no features, so that everything with a support function takes part.
//!
//! ## Cores
//! What slides over a floor of many pieces touches the next piece all the time, and must not be stopped by it; and what
//! sinks into something at the end of a step is pushed out by its contacts, to where it came from as long as its middle
//! is still outside. What must never happen is that the middle gets through. So it is the *core* that is searched with
//! first: the shape without an outer layer as deep as one can get ([`CORE_DEPTH`]). Where the core would hit, the body is
//! stopped, and then not so late but where its surface touches, if it did not do so from the beginning. What has no
//! inside, a mesh or a segment, has no core and is not stopped.

use super::parts::{Line, Near, Part, Parts};
use crate::base::closest::{Closest, closest};
use crate::dim::math::{
    ANG_ZERO, AngVector, DIM, Pose, Real, Rotation, Vector, ang_length_squared, integrate_rotation,
};
use crate::model::collider::thickness;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::shape::{Shape, SupportMap, TypedShape};

/// How deep below its surface a shape's core begins, as a share of the shape's thickness: of a ball a point is left, of a
/// capsule its axis, of a board a thin one.
const CORE_DEPTH: Real = 0.98;
/// How near a core comes to what it hits, as a share of the shape's thickness.
const CORE_TOLERANCE: Real = 0.05;
/// Jumps after which a search ends where it is: more than it takes to come near, at the tolerance, by turning through
/// hundreds of times the thickness.
const MAX_JUMPS: usize = 256;
/// A rotation vector this long (rad) is integrated as one, as joints do it; a longer one in pieces of this length.
const WHOLE_TURN: Real = 1.0;
const PIECE: Real = 0.25;

/// The motion of a shape through a step, at constant velocity, as far as `stop`.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Sweep {
    /// Where the shape stands at the beginning.
    start: Pose,
    /// The centre about which it turns at the beginning, and that in the shape's frame.
    center: Vector,
    local_center: Vector,
    /// How far the centre moves, and the rotation vector of the turn (rad).
    shift: Vector,
    turn: AngVector,
    /// The share of the motion that happens.
    stop: Real,
}

/// What the search is to find.
#[derive(Copy, Clone, Debug)]
pub(crate) struct SweepGoal {
    /// The gap at which shapes touch (length units).
    pub gap: Real,
    /// Is what is in contact from the beginning stopped, too, before its middle gets in?
    pub on_penetration: bool,
}

impl Sweep {
    /// `center` is where the centre of rotation is at the beginning.
    pub fn new(start: Pose, center: Vector, shift: Vector, turn: AngVector) -> Self {
        let local_center = start.inverse_transform_point(center);
        Self { start, center, local_center, shift, turn, stop: 1.0 }
    }

    /// The same motion, as far as `stop`.
    pub fn until(self, stop: Real) -> Self {
        Self { stop, ..self }
    }

    /// Stands still.
    pub fn at_rest(pose: Pose) -> Self {
        let zero = Vector::ZERO;
        Self::new(pose, pose.translation, zero, ANG_ZERO)
    }

    /// The pose after a share of the motion.
    pub fn at(&self, share: Real) -> Pose {
        let share = share.min(self.stop);
        let rotation = turned(self.start.rotation, self.turn * share);
        let center = self.center + self.shift * share;
        Pose::from_parts(center - rotation * self.local_center, rotation)
    }

    /// The same motion of something that stands at `place` in the frame of what moves.
    pub fn of_part(&self, place: &Pose) -> Self {
        Self {
            stop: self.stop,
            ..Self::new(self.start * *place, self.center, self.shift, self.turn)
        }
    }

    /// A box around everything that a shape's core passes, and no larger than the shape's own: what lies on a floor does not
    /// find it.
    pub fn region_of_core(&self, shape: &dyn Shape) -> Aabb {
        let region = self.region(shape);
        let less = Vector::splat(layer_of(shape)).min(region.half_extents());
        Aabb::new(region.mins + less, region.maxs - less)
    }

    /// A box around everything that a shape passes.
    pub fn region(&self, shape: &dyn Shape) -> Aabb {
        // Without much turning both ends say all.
        if ang_length_squared(self.turn) < 1.0e-4 {
            return shape.compute_aabb(&self.start).merged(&shape.compute_aabb(&self.at(1.0)));
        }
        let end = self.center + self.shift * self.stop;
        let path = Aabb::new(self.center.min(end), self.center.max(end));
        path.loosened(reach_about(shape, self.local_center))
    }
}

/// The rotation after it was turned by a rotation vector of any length (rad, world space).
pub(crate) fn turned(rotation: Rotation, angle: AngVector) -> Rotation {
    if ang_length_squared(angle) <= WHOLE_TURN * WHOLE_TURN {
        return integrate_rotation(rotation, angle);
    }
    let (mut angle, mut halvings) = (angle, 0);
    while ang_length_squared(angle) > PIECE * PIECE && halvings < 64 {
        (angle, halvings) = (angle * 0.5, halvings + 1);
    }
    let mut turn = integrate_rotation(Rotation::IDENTITY, angle);
    for _ in 0..halvings {
        turn = (turn * turn).normalize();
    }
    (turn * rotation).normalize()
}

/// When the first shape is stopped by the second, as a share of the step; `None` if not before `until`.
pub(crate) fn first_impact(
    shapes: [&dyn Shape; 2],
    sweeps: [&Sweep; 2],
    goal: SweepGoal,
    until: Real,
) -> Option<Real> {
    let mut first = None;
    let mut visit = |parts: [(&Part<'_>, &Sweep); 2]| {
        let until = first.unwrap_or(until);
        if let Some(share) = impact_of_parts(parts, goal, until) {
            first = Some(share);
        }
    };
    let parts = shapes.map(Parts::of);
    // What of one shape may be met by the whole of the other.
    let near = [0, 1].map(|side| match parts[side] {
        Parts::Convex(_) => Near::Inside(Aabb::new_invalid()), // its only part, wherever the other goes
        _ => path_of_other(shapes, sweeps, side),
    });
    parts[0].for_each_part(&near[0], &mut |part1| {
        let sweep1 = sweeps[0].of_part(&part1.pose());
        parts[1].for_each_part(&near[1], &mut |part2| {
            let sweep2 = sweeps[1].of_part(&part2.pose());
            visit([(&part1, &sweep1), (&part2, &sweep2)]);
        });
    });
    first
}

/// A region, in the frame of the shape on a side, around all places of the other shape.
fn path_of_other(shapes: [&dyn Shape; 2], sweeps: [&Sweep; 2], side: usize) -> Near {
    let (own, other, shape) = (sweeps[side], sweeps[1 - side], shapes[1 - side]);
    let stays = own.shift == Vector::ZERO;
    if ang_length_squared(own.turn) == 0.0 && (stays || own.stop == other.stop) {
        let region = other.region(shape).loosened(own.shift.length());
        let region = region.transform_by(&own.start.inverse());
        let start = own.start.inverse_transform_point(other.center);
        let way = own.start.rotation.inverse() * ((other.shift - own.shift) * other.stop);
        let radius = reach_about(shape, other.local_center);
        let line = Line::new(start, way, radius, region);
        return line.map_or(Near::Inside(region), Near::Along);
    }
    // As seen from something that turns, the other moves by no more than both do.
    let away = own.start.inverse_transform_point(other.center).length() + other.shift.length();
    let turn = ang_length_squared(own.turn).sqrt() * (away + own.local_center.length());
    let region = other.region(shape).loosened(own.shift.length());
    Near::Inside(region.transform_by(&own.start.inverse()).loosened(turn))
}

/// When the first part is stopped by the second.
fn impact_of_parts(
    [(part1, sweep1), (part2, sweep2)]: [(&Part<'_>, &Sweep); 2],
    goal: SweepGoal,
    until: Real,
) -> Option<Real> {
    let sweeps = [sweep1, sweep2];
    let thickness = thickness(part1.shape);
    if thickness == Real::INFINITY {
        return None;
    }
    let (whole, other) = (Body::whole(part1.shape)?, Body::whole(part2.shape)?);
    let core = Body::core(part1.shape, CORE_DEPTH * thickness)?;
    let tolerance = (CORE_TOLERANCE * thickness).max(goal.gap);
    let core_goal = Goal { gap: 0.0, tolerance, counts_at_once: true };
    let Meeting::At(latest) = advance([&core, &other], sweeps, core_goal, until) else {
        return None;
    };
    let goal_of_whole = Goal { gap: goal.gap, tolerance: 0.5 * goal.gap, counts_at_once: false };
    match advance([&whole, &other], sweeps, goal_of_whole, latest) {
        Meeting::At(share) => Some(share),
        Meeting::Never => Some(latest),
        Meeting::FromTheBeginning => goal.on_penetration.then_some(latest),
    }
}

/// Within what distance parts have met.
#[derive(Copy, Clone, Debug)]
struct Goal {
    gap: Real,
    tolerance: Real,
    /// Does it count as a meeting, if parts that are near from the beginning come nearer?
    counts_at_once: bool,
}

/// How two parts come together.
#[derive(Copy, Clone, Debug, PartialEq)]
enum Meeting {
    /// They do not.
    Never,
    /// They have met when the step begins.
    FromTheBeginning,
    /// After this share of the step.
    At(Real),
}

/// Jumps ahead until two bodies have met.
fn advance(bodies: [&Body<'_>; 2], sweeps: [&Sweep; 2], goal: Goal, until: Real) -> Meeting {
    let turns = [0, 1].map(|k| match ang_length_squared(sweeps[k].turn) {
        0.0 => 0.0,
        square => square.sqrt() * bodies[k].reach_about(sweeps[k].local_center),
    });
    let turning = turns[0] + turns[1];
    let closing_max = (sweeps[0].shift - sweeps[1].shift).length() + turning;
    let (mut share, mut last_normal) = (0.0, Vector::ZERO);
    for _ in 0..MAX_JUMPS {
        let poses = sweeps.map(|sweep| sweep.at(share));
        let reach = goal.gap + goal.tolerance + closing_max * (until - share);
        let Some((normal, dist)) = bodies[0].distance(bodies[1], &poses, reach, last_normal) else {
            return Meeting::Never;
        };
        last_normal = normal;
        let across = poses[0].rotation * normal;
        let nearing = (shift_left(sweeps[0], share) - shift_left(sweeps[1], share)).dot(across);
        if dist <= goal.gap + goal.tolerance {
            let counts = share > 0.0 || goal.counts_at_once && dist > goal.gap && nearing > 0.0;
            return if counts { Meeting::At(share) } else { Meeting::FromTheBeginning };
        }
        let closing = nearing + turning;
        // Not so far that they would touch: closest points of what touches are not always found.
        share += (dist - goal.gap - 0.5 * goal.tolerance) / closing.max(0.0);
        // Not if they part, and the quotient is infinite; nor if it is no number.
        let may_meet = share < until;
        if !may_meet {
            return Meeting::Never;
        }
    }
    Meeting::At(share)
}

/// The shift of a body, as long as it moves: a motion that was stopped does not come back.
fn shift_left(sweep: &Sweep, share: Real) -> Vector {
    if share < sweep.stop { sweep.shift } else { Vector::ZERO }
}

/// A convex part: a sharp body and a layer of some thickness around it.
struct Body<'a> {
    sharp: Sharp<'a>,
    radius: Real,
    /// The part, if nothing was taken off.
    whole: Option<&'a dyn Shape>,
}

#[derive(Copy, Clone)]
enum Sharp<'a> {
    Convex(Shrunk<'a>),
    /// Everything behind the plane through the origin with this normal.
    Plane(Vector),
}

/// A convex shape, drawn together along its axes towards a point inside.
#[derive(Copy, Clone)]
struct Shrunk<'a> {
    shape: &'a dyn SupportMap,
    center: Vector,
    scale: Vector,
}

impl SupportMap for Shrunk<'_> {
    fn local_support_point(&self, direction: Vector) -> Vector {
        let scaled = direction * self.scale;
        // Drawn together to nothing along that direction: all points are as good, but none lies that way.
        let ahead = if scaled == Vector::ZERO { direction } else { scaled };
        let point = self.shape.local_support_point(ahead);
        self.center + (point - self.center) * self.scale
    }
}

impl<'a> Body<'a> {
    /// A part as it is; `None` if nothing is known of where it ends.
    fn whole(part: &'a dyn Shape) -> Option<Self> {
        let center = Vector::ZERO;
        let sharp = |shape, scale| Sharp::Convex(Shrunk { shape, center, scale });
        let (sharp, radius) = match part.as_typed_shape() {
            TypedShape::HalfSpace(plane) => (Sharp::Plane(plane.normal), 0.0),
            TypedShape::Ball(ball) => (sharp(ball, Vector::ZERO), ball.radius),
            TypedShape::Capsule(capsule) => (sharp(&capsule.segment, Vector::ONE), capsule.radius),
            _ => (sharp(part.as_support_map()?, Vector::ONE), 0.0),
        };
        Some(Self { sharp, radius, whole: Some(part) })
    }

    /// The point that is left of a ball, or of the core of one.
    fn as_point(&self) -> Option<Vector> {
        match &self.sharp {
            Sharp::Convex(shape) if shape.scale == Vector::ZERO => Some(shape.center),
            _ => None,
        }
    }

    /// A part without its outer layer of this depth.
    fn core(shape: &'a dyn Shape, depth: Real) -> Option<Self> {
        let Self { sharp, radius, .. } = Self::whole(shape)?;
        let Sharp::Convex(shrunk) = sharp else { return None };
        if depth <= radius {
            return Some(Self { sharp, radius: radius - depth, whole: None });
        }
        let half_extents = shape.compute_local_aabb().half_extents();
        let scale = (half_extents - Vector::splat(depth)).max(Vector::ZERO) / half_extents;
        // Along an axis in which the shape has no thickness there is nothing to take off.
        let scale = Vector::select(half_extents.cmpgt(Vector::ZERO), scale, Vector::ONE);
        let sharp = Sharp::Convex(Shrunk { center: middle(shrunk.shape), scale, ..shrunk });
        Some(Self { sharp, radius: 0.0, whole: None })
    }

    /// The direction to another body, in the frame of this one, and the distance; `None` if it is farther than `reach`.
    fn distance(
        &self,
        other: &Self,
        [pose, other_pose]: &[Pose; 2],
        reach: Real,
        last_normal: Vector,
    ) -> Option<(Vector, Real)> {
        let radius = self.radius + other.radius;
        let pos12 = pose.inv_mul(other_pose);
        if let Some((point, shape)) = self.as_point().zip(other.whole) {
            let found = nearest(&pos12, point, shape, last_normal);
            return Some(found)
                .filter(|&(_, dist)| dist - self.radius <= reach)
                .map(|(normal, dist)| (normal, dist - self.radius));
        }
        let (normal, dist) = match (&self.sharp, &other.sharp) {
            (Sharp::Convex(shape1), Sharp::Convex(shape2)) => {
                match closest(&pos12, shape1, shape2, reach + radius, last_normal) {
                    Closest::Near { normal, dist, .. } => (normal, dist),
                    Closest::Apart(_) => return None,
                }
            }
            (Sharp::Convex(shape), Sharp::Plane(normal)) => {
                let down = -(pos12.rotation * *normal);
                let lowest = shape.local_support_point(down);
                (down, (pos12.translation - lowest).dot(down))
            }
            (Sharp::Plane(normal), Sharp::Convex(shape)) => {
                let down = -(pos12.rotation.inverse() * *normal);
                (*normal, (pos12 * shape.local_support_point(down)).dot(*normal))
            }
            (Sharp::Plane(_), Sharp::Plane(_)) => return None,
        };
        Some((normal, dist - radius)).filter(|&(_, dist)| dist <= reach)
    }

    /// How fast a turn by an angle of one moves the body's points (length units), about a centre.
    fn reach_about(&self, center: Vector) -> Real {
        let Sharp::Convex(shape) = &self.sharp else { return Real::MAX };
        let farthest = directions().map(|direction| {
            (shape.local_support_point(direction) - center).dot(direction).max(0.0)
        });
        // The body lies within the box that these make.
        let square: Real = farthest.chunks(2).map(|pair| pair[0].max(pair[1])).map(|r| r * r).sum();
        square.sqrt() + self.radius
    }
}

/// The direction from a point to a part at `pos12`, and its distance: exact where a search of closest points has its
/// tolerances. 0 if it is inside.
fn nearest(pos12: &Pose, point: Vector, part: &dyn Shape, last_normal: Vector) -> (Vector, Real) {
    let local = pos12.inverse_transform_point(point);
    let way = part.project_local_point(local, true).point - local;
    let dist = way.length();
    let normal = if dist > 0.0 { pos12.rotation * (way / dist) } else { last_normal };
    (normal, dist)
}

/// The axes, there and back.
fn directions() -> [Vector; 2 * DIM] {
    core::array::from_fn(|k| {
        let mut direction = Vector::ZERO;
        direction[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
        direction
    })
}

/// A point inside a convex shape, in the middle of what has one: the mean of its farthest points along all diagonals.
/// (Along the axes the farthest points of a box are whole faces, and it may say any of their corners.)
fn middle(shape: &dyn SupportMap) -> Vector {
    let corners = 1 << DIM;
    let diagonal = |corner: usize| {
        let mut direction = Vector::ONE;
        (0..DIM).filter(|k| corner >> k & 1 == 1).for_each(|k| direction[k] = -1.0);
        shape.local_support_point(direction)
    };
    (0..corners).map(diagonal).sum::<Vector>() / corners as Real
}

/// How much smaller a box around a shape's core is at least on all sides, with what the search tolerates.
fn layer_of(shape: &dyn Shape) -> Real {
    let thickness = thickness(shape);
    if thickness == Real::INFINITY {
        return 0.0;
    }
    let share = match shape.as_typed_shape() {
        TypedShape::Ball(_) | TypedShape::Capsule(_) | TypedShape::Cuboid(_) => CORE_DEPTH,
        TypedShape::HalfSpace(_) => 0.0,
        // Drawn together towards the middle, which need not be that of its box.
        _ => 0.5 * CORE_DEPTH,
    };
    ((share - CORE_TOLERANCE) * thickness).max(0.0)
}

/// How far a shape reaches from a point of its frame.
fn reach_about(shape: &dyn Shape, center: Vector) -> Real {
    let sphere = shape.compute_local_bounding_sphere();
    (sphere.center - center).length() + sphere.radius
}
