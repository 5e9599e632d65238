//! Motions of shapes through a step.

use super::{Solid, box_of_core};
use crate::dim::math::{
    ANG_ZERO, AngVector, Pose, Real, Rotation, Vector, ang_length_squared, integrate_rotation,
};
use core::slice;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::shape::Shape;

/// A rotation vector this long (rad) is integrated as one, as joints do it; a longer one in pieces of this length.
const WHOLE_TURN: Real = 1.0;
const PIECE: Real = 0.25;
/// Without turning more than this (rad², squared) what a shape passes is around where it begins and ends.
const LITTLE_TURN: Real = 1.0e-4;

/// A piece of a motion, at constant velocity.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Leg {
    /// The shares of the step between which it lasts.
    pub from: Real,
    pub until: Real,
    /// How what moves is turned when the leg begins, and where the centre is about which it turns.
    pub rotation: Rotation,
    pub center: Vector,
    /// How far the centre moves, and the rotation vector of the turn (rad), per step.
    pub shift: Vector,
    pub turn: AngVector,
}

impl Leg {
    /// All the step at the origin.
    pub const AT_REST: Self = Self {
        from: 0.0,
        until: 1.0,
        rotation: Rotation::IDENTITY,
        center: Vector::ZERO,
        shift: Vector::ZERO,
        turn: ANG_ZERO,
    };

    /// How fast it turns (rad per step).
    pub fn angle(&self) -> Real {
        match ang_length_squared(self.turn) {
            0.0 => 0.0,
            square => square.sqrt(),
        }
    }

    fn center_at(&self, share: Real) -> Vector {
        self.center + self.shift * (share - self.from)
    }
}

/// The legs of a motion, in the order of time, from the beginning of the step to its end.
#[derive(Copy, Clone, Debug)]
enum Way<'a> {
    Straight(Leg),
    Bent(&'a [Leg]),
}

/// The motion of a shape through a step, as far as `stop`.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Sweep<'a> {
    way: Way<'a>,
    /// How the shape is turned against what moves, and the centre of rotation in the shape's frame.
    rotation: Rotation,
    pub(super) local_center: Vector,
    /// The share of the motion that happens.
    pub(super) stop: Real,
}

impl<'a> Sweep<'a> {
    /// The motion at constant velocity of a shape that stands at `start` when the step begins, with the centre of rotation at
    /// `center`.
    pub fn new(start: Pose, center: Vector, shift: Vector, turn: AngVector) -> Self {
        let leg = Leg { from: 0.0, until: 1.0, rotation: start.rotation, center, shift, turn };
        let local_center = start.inverse_transform_point(center);
        Self { way: Way::Straight(leg), rotation: Rotation::IDENTITY, local_center, stop: 1.0 }
    }

    /// The motion of a shape that stands at `place` in the frame of what moves by these legs, of which there is at least one.
    /// `local_center` is the centre of rotation in that frame.
    pub fn along(legs: &'a [Leg], place: &Pose, local_center: Vector) -> Self {
        let local_center = place.inverse_transform_point(local_center);
        Self { way: Way::Bent(legs), rotation: place.rotation, local_center, stop: 1.0 }
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

    /// The legs, in the order of time.
    pub fn legs(&self) -> &[Leg] {
        match &self.way {
            Way::Straight(leg) => slice::from_ref(leg),
            Way::Bent(legs) => legs,
        }
    }

    /// The only leg, if there is one only.
    pub(super) fn straight(&self) -> Option<&Leg> {
        match &self.way {
            Way::Straight(leg) => Some(leg),
            Way::Bent(_) => None,
        }
    }

    /// The leg that begins or is under way after a share of the step.
    pub fn leg(&self, share: Real) -> &Leg {
        let legs = self.legs();
        let over = legs.partition_point(|leg| leg.until <= share);
        &legs[over.min(legs.len() - 1)]
    }

    /// How fast the centre moves (length units per step) after a share of the step.
    pub(super) fn velocity(&self, share: Real) -> Vector {
        if share < self.stop { self.leg(share).shift } else { Vector::ZERO }
    }

    /// When it changes its velocity next: infinity if it does not any more.
    pub(super) fn next_change(&self, share: Real) -> Real {
        let end = self.leg(share).until;
        let next = if share < self.stop { end.min(self.stop) } else { Real::INFINITY };
        if next < 1.0 { next } else { Real::INFINITY }
    }

    /// The pose after a share of the motion.
    pub fn at(&self, share: Real) -> Pose {
        let share = share.min(self.stop);
        let leg = self.leg(share);
        let rotation = turned(leg.rotation, leg.turn * (share - leg.from)) * self.rotation;
        Pose::from_parts(leg.center_at(share) - rotation * self.local_center, rotation)
    }

    /// The same motion of something that stands at `place` in the frame of what moves.
    pub fn of_part(&self, place: &Pose) -> Self {
        let local_center = place.inverse_transform_point(self.local_center);
        Self { rotation: self.rotation * place.rotation, local_center, ..*self }
    }

    /// Returns whether it moves at all.
    pub fn moves(&self) -> bool {
        self.travel() != [0.0; 2]
    }

    /// How far the centre goes, and by what angle (rad) the shape turns.
    pub(super) fn travel(&self) -> [Real; 2] {
        let lasts = |leg: &Leg| leg.until - leg.from;
        let way = self.legs().iter().map(|leg| leg.shift.length() * lasts(leg)).sum();
        let angle = self.legs().iter().map(|leg| leg.angle() * lasts(leg)).sum();
        [way, angle]
    }

    /// Where the centre is when the step begins.
    pub(super) fn center(&self) -> Vector {
        self.legs()[0].center
    }

    /// A box around everything that a shape's core passes: a floor that the shape lies on is outside.
    pub fn region_of_core(&self, solid: Solid<'_>) -> Aabb {
        self.region_of(solid.shape, &|pose| box_of_core(solid, pose))
    }

    /// A box around everything that a shape passes.
    pub fn region(&self, shape: &dyn Shape) -> Aabb {
        self.region_of(shape, &|pose| shape.compute_aabb(pose))
    }

    /// A box around everything that a shape passes, or a part of it with a box `box_at` a pose.
    fn region_of(&self, shape: &dyn Shape, box_at: &dyn Fn(&Pose) -> Aabb) -> Aabb {
        let regions = self.legs().iter().filter(|leg| leg.from <= self.stop);
        let regions = regions.map(|leg| self.region_of_leg(leg, shape, box_at));
        regions.reduce(|all, region| all.merged(&region)).unwrap_or_else(Aabb::new_invalid)
    }

    fn region_of_leg(&self, leg: &Leg, shape: &dyn Shape, box_at: &dyn Fn(&Pose) -> Aabb) -> Aabb {
        let end = leg.until.min(self.stop);
        let angle = leg.angle() * (leg.until - leg.from);
        if angle * angle < LITTLE_TURN {
            let boxes = [leg.from, end].map(|share| box_at(&self.at(share)));
            return boxes[0].merged(&boxes[1]);
        }
        let end = leg.center_at(end);
        let path = Aabb::new(leg.center.min(end), leg.center.max(end));
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

/// How far a shape reaches from a point of its frame.
pub(super) fn reach_about(shape: &dyn Shape, center: Vector) -> Real {
    let sphere = shape.compute_local_bounding_sphere();
    (sphere.center - center).length() + sphere.radius
}
