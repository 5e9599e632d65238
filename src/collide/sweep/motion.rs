//! Motions of shapes through a step.

use super::{Solid, box_of_core};
use crate::dim::math::{
    ANG_ZERO, AngVector, Pose, Real, Rotation, Vector, ang_length_squared, cross,
    integrate_rotation,
};
use core::slice;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::shape::Shape;

/// Rotation vectors of up to this length (rad) are integrated undivided, as those of joints.
const UNDIVIDED_ANGLE_MAX: Real = 1.0;
/// Longer ones are integrated in pieces of at most this length (rad).
const ANGLE_PER_PIECE_MAX: Real = 0.25;
/// Largest square of a rotation angle (rad²) at which the box around the initial and the final pose contains
/// the swept region.
const BOX_ANGLE_SQUARED_MAX: Real = 1.0e-4;

/// A piece of a motion, at constant velocity.
#[derive(Copy, Clone, Debug)]
pub(crate) struct PathSegment {
    /// The fractions of the step at which it begins and ends.
    pub from: Real,
    pub until: Real,
    /// Rotation of the moving frame when the segment begins, and its centre of rotation.
    pub rotation: Rotation,
    pub center: Vector,
    /// Displacement of the centre, and rotation vector (rad), per step.
    pub shift: Vector,
    pub rotvec: AngVector,
}

impl PathSegment {
    /// All the step at the origin.
    pub const AT_REST: Self = Self {
        from: 0.0,
        until: 1.0,
        rotation: Rotation::IDENTITY,
        center: Vector::ZERO,
        shift: Vector::ZERO,
        rotvec: ANG_ZERO,
    };

    /// Angular speed (rad per step).
    pub fn angle(&self) -> Real {
        match ang_length_squared(self.rotvec) {
            0.0 => 0.0,
            square => square.sqrt(),
        }
    }

    fn center_at(&self, fraction: Real) -> Vector {
        self.center + self.shift * (fraction - self.from)
    }
}

/// The segments of a motion, in order of time, from the beginning of the step to its end.
#[derive(Copy, Clone, Debug)]
enum Trajectory<'a> {
    Straight(PathSegment),
    Bent(&'a [PathSegment]),
}

/// The motion of a shape through a step, as far as `stop`.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Sweep<'a> {
    trajectory: Trajectory<'a>,
    /// Rotation of the shape relative to the moving frame, and the centre of rotation in the shape's frame.
    rotation: Rotation,
    pub(super) local_center: Vector,
    /// The executed fraction of the motion.
    pub(super) stop: Real,
}

impl<'a> Sweep<'a> {
    /// The motion of a shape at constant velocity from the pose `start`, with the centre of rotation at
    /// `center`.
    pub fn new(start: Pose, center: Vector, shift: Vector, rotvec: AngVector) -> Self {
        let segment =
            PathSegment { from: 0.0, until: 1.0, rotation: start.rotation, center, shift, rotvec };
        let local_center = start.inverse_transform_point(center);
        Self {
            trajectory: Trajectory::Straight(segment),
            rotation: Rotation::IDENTITY,
            local_center,
            stop: 1.0,
        }
    }

    /// The motion of a shape at `place` in a frame that moves by these segments, of which there is at least
    /// one. `local_center` is the centre of rotation in that frame.
    pub fn along(segments: &'a [PathSegment], place: &Pose, local_center: Vector) -> Self {
        debug_assert!(!segments.is_empty(), "a motion has a first segment");
        debug_assert!(segments.is_sorted_by(|one, two| one.until <= two.until));
        let local_center = place.inverse_transform_point(local_center);
        Self {
            trajectory: Trajectory::Bent(segments),
            rotation: place.rotation,
            local_center,
            stop: 1.0,
        }
    }

    /// The same motion, as far as `stop`.
    pub fn until(self, stop: Real) -> Self {
        debug_assert!((0.0..=1.0).contains(&stop));
        Self { stop, ..self }
    }

    /// A motion without displacement.
    pub fn at_rest(pose: Pose) -> Self {
        let zero = Vector::ZERO;
        Self::new(pose, pose.translation, zero, ANG_ZERO)
    }

    /// The segments, in order of time.
    pub fn segments(&self) -> &[PathSegment] {
        match &self.trajectory {
            Trajectory::Straight(segment) => slice::from_ref(segment),
            Trajectory::Bent(segments) => segments,
        }
    }

    /// The segment, if there is exactly one.
    pub(super) fn straight(&self) -> Option<&PathSegment> {
        match &self.trajectory {
            Trajectory::Straight(segment) => Some(segment),
            Trajectory::Bent(_) => None,
        }
    }

    /// The segment that begins or is in progress at a fraction of the step.
    pub fn segment(&self, fraction: Real) -> &PathSegment {
        let segments = self.segments();
        let over = segments.partition_point(|segment| segment.until <= fraction);
        &segments[over.min(segments.len() - 1)]
    }

    /// The speed of the centre (length units per step) at a fraction of the step.
    pub(super) fn velocity(&self, fraction: Real) -> Vector {
        if fraction < self.stop { self.segment(fraction).shift } else { Vector::ZERO }
    }

    /// The velocity (length units per step), at a fraction of the step, of the point that is at a place then.
    pub(super) fn velocity_at(&self, place: Vector, fraction: Real) -> Vector {
        if fraction >= self.stop {
            return Vector::ZERO;
        }
        let segment = self.segment(fraction);
        segment.shift + cross(segment.rotvec, place - segment.center_at(fraction))
    }

    /// The fraction of the step at which the velocity changes next; infinity after the last change.
    pub(super) fn next_change(&self, fraction: Real) -> Real {
        let end = self.segment(fraction).until;
        let next = if fraction < self.stop { end.min(self.stop) } else { Real::INFINITY };
        if next < 1.0 { next } else { Real::INFINITY }
    }

    /// The pose after a fraction of the motion.
    pub fn at(&self, fraction: Real) -> Pose {
        let fraction = fraction.min(self.stop);
        let segment = self.segment(fraction);
        let rotation =
            turned(segment.rotation, segment.rotvec * (fraction - segment.from)) * self.rotation;
        Pose::from_parts(segment.center_at(fraction) - rotation * self.local_center, rotation)
    }

    /// The same motion of an object at `place` in the moving frame.
    pub fn of_part(&self, place: &Pose) -> Self {
        let local_center = place.inverse_transform_point(self.local_center);
        Self { rotation: self.rotation * place.rotation, local_center, ..*self }
    }

    /// Returns whether it moves at all.
    pub fn moves(&self) -> bool {
        self.travel() != [0.0; 2]
    }

    /// Displacement of the centre, and rotation angle (rad) of the shape.
    pub(super) fn travel(&self) -> [Real; 2] {
        let lasts = |segment: &PathSegment| segment.until - segment.from;
        let trajectory =
            self.segments().iter().map(|segment| segment.shift.length() * lasts(segment)).sum();
        let angle = self.segments().iter().map(|segment| segment.angle() * lasts(segment)).sum();
        [trajectory, angle]
    }

    /// The centre when the step begins.
    pub(super) fn center(&self) -> Vector {
        self.segments()[0].center
    }

    /// A box around the swept region of a shape's core: the floor under the shape is outside.
    pub fn region_of_core(&self, solid: Solid<'_>) -> Aabb {
        self.region_of(solid.shape, &|pose| box_of_core(solid, pose))
    }

    /// A box around everything that a shape passes.
    pub fn region(&self, shape: &dyn Shape) -> Aabb {
        self.region_of(shape, &|pose| shape.compute_aabb(pose))
    }

    /// A box around everything that a shape passes, or a part of it with a box `box_at` a pose.
    fn region_of(&self, shape: &dyn Shape, box_at: &dyn Fn(&Pose) -> Aabb) -> Aabb {
        let regions = self.segments().iter().filter(|segment| segment.from <= self.stop);
        let regions = regions.map(|segment| self.region_of_segment(segment, shape, box_at));
        regions.reduce(|all, region| all.merged(&region)).unwrap_or_else(Aabb::new_invalid)
    }

    fn region_of_segment(
        &self,
        segment: &PathSegment,
        shape: &dyn Shape,
        box_at: &dyn Fn(&Pose) -> Aabb,
    ) -> Aabb {
        let end = segment.until.min(self.stop);
        let angle = segment.angle() * (segment.until - segment.from);
        if angle * angle < BOX_ANGLE_SQUARED_MAX {
            let boxes = [segment.from, end].map(|fraction| box_at(&self.at(fraction)));
            return boxes[0].merged(&boxes[1]);
        }
        let end = segment.center_at(end);
        let path = Aabb::new(segment.center.min(end), segment.center.max(end));
        path.loosened(reach_about(shape, self.local_center))
    }
}

/// The rotation after a rotation vector of any length (rad, world space).
pub(crate) fn turned(rotation: Rotation, angle: AngVector) -> Rotation {
    if ang_length_squared(angle) <= UNDIVIDED_ANGLE_MAX * UNDIVIDED_ANGLE_MAX {
        return integrate_rotation(rotation, angle);
    }
    let (mut angle, mut halvings) = (angle, 0);
    while ang_length_squared(angle) > ANGLE_PER_PIECE_MAX * ANGLE_PER_PIECE_MAX && halvings < 64 {
        (angle, halvings) = (angle * 0.5, halvings + 1);
    }
    let mut rotvec = integrate_rotation(Rotation::IDENTITY, angle);
    for _ in 0..halvings {
        rotvec = (rotvec * rotvec).normalize();
    }
    (rotvec * rotation).normalize()
}

/// The extent of a shape from a point of its frame.
pub(super) fn reach_about(shape: &dyn Shape, center: Vector) -> Real {
    let sphere = shape.compute_local_bounding_sphere();
    (sphere.center - center).length() + sphere.radius
}
