//! Time at which a part touches a half-space that rotates. For queries, as all of `touch.rs`.
//!
//! A half-space reaches everywhere, so no speed bounds its rotation. But the part has a largest distance `D`
//! from the centre of that rotation. The height of the part above the plane decreases at a rate of at most
//! `ω D`, beside the motion of the part itself, where `ω` is the speed of the tip of the normal. `D`
//! increases with the relative velocity, so the bound is quadratic in time.

use super::MovingPart;
use super::motion::{PathSegment, reach_about};
use super::touch::JUMPS_MAX;
use crate::dim::math::{Real, Vector, cross};
use parry::shape::{HalfSpace, SupportMap};

/// A half-space that rotates, and the other part.
pub(super) struct RotatingPlane<'a, 'b> {
    plane: &'b HalfSpace,
    own: MovingPart<'a, 'b>,
    other: MovingPart<'a, 'b>,
    /// The motions of the two.
    segments: [&'a PathSegment; 2],
    shape: &'b dyn SupportMap,
}

impl<'a, 'b> RotatingPlane<'a, 'b> {
    /// The first of two parts that is a half-space and rotates; `None` if there is none.
    pub fn of(pair: [MovingPart<'a, 'b>; 2]) -> Option<Self> {
        let planes = pair.map(|moving| moving.part.shape.as_halfspace());
        let side = planes.iter().position(Option::is_some)?;
        let [own, other] = [pair[side], pair[1 - side]];
        let segments = [own.sweep.straight()?, other.sweep.straight()?];
        let shape = other.part.shape.as_support_map()?;
        let rotates = segments[0].angle() > 0.0;
        rotates.then_some(Self { plane: planes[side]?, own, other, segments, shape })
    }

    /// Returns the fraction of the step at which the two touch, if it is at most `until`. A height below
    /// `tolerance` counts as touching. Parts that touch from the beginning touch `at_once`, or only when the
    /// middle enters.
    pub fn first_touch(&self, tolerance: Real, at_once: bool, until: Real) -> Option<Real> {
        let is_whole = at_once || self.height(0.0, true) > tolerance;
        let reach = reach_about(self.other.part.shape, self.other.sweep.local_center);
        if self.height_min(reach) > tolerance {
            return None;
        }
        let (angle, other_angle) = (self.tilt(), self.segments[1].angle());
        let speed = (self.segments[1].shift - self.segments[0].shift).length();
        let growth = angle * speed;
        let mut fraction = 0.0;
        for _ in 0..JUMPS_MAX {
            let height = self.height(fraction, is_whole);
            if height <= tolerance {
                return (is_whole || fraction > 0.0).then_some(fraction);
            }
            let closing =
                speed + angle * (self.center_distance(fraction) + reach) + other_angle * reach;
            let drop = height - 0.5 * tolerance;
            fraction += 2.0 * drop / (closing + (closing * closing + 4.0 * growth * drop).sqrt());
            let may_touch = fraction <= until;
            if !may_touch {
                return None;
            }
        }
        Some(fraction)
    }

    /// Path of the tip of the normal. (A rotation about the normal itself leaves the plane where it is.)
    fn tilt(&self) -> Real {
        let normal = self.own.sweep.at(0.0).rotation * self.plane.normal;
        cross(self.segments[0].rotvec, normal).length()
    }

    /// Height of the lowest point of the part, or of its middle, above the plane.
    fn height(&self, fraction: Real, is_whole: bool) -> Real {
        let [pose, place] = [self.own, self.other].map(|moving| moving.sweep.at(fraction));
        let normal = pose.rotation * self.plane.normal;
        let lowest = if is_whole {
            self.shape.local_support_point(place.rotation.inverse() * -normal)
        } else {
            self.other.part.shape.compute_local_aabb().center()
        };
        normal.dot(place * lowest - pose.translation)
    }

    /// Distance of the centres of rotation.
    fn center_distance(&self, fraction: Real) -> Real {
        let center = |segment: &PathSegment| segment.center + segment.shift * fraction;
        center(self.segments[1]).distance(center(self.segments[0]))
    }

    /// Lower bound of the height at all times. The part stays within a ball around the centre of the plane's
    /// rotation, and that centre has a constant height.
    fn height_min(&self, reach: Real) -> Real {
        let pose = self.own.sweep.at(0.0);
        let to_center: Vector = self.segments[0].center - pose.translation;
        let of_center = (pose.rotation * self.plane.normal).dot(to_center);
        of_center - self.center_distance(0.0).max(self.center_distance(1.0)) - reach
    }
}
