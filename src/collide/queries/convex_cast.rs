//! Casts of two plain parts without a formula.
//!
//! parry computes the first time by a ray against the difference of the two shapes. That search ends when its
//! bounds stop to improve, which may be centimetres early for shapes with curved edges. Conservative
//! advancement then continues: at the distance `d` along the normal `n`, shapes cannot touch before
//! `t + d / (-v · n)`.

use super::pair_query::Found;
use super::plain::distance;
use crate::base::bvh::SlabProbe;
use crate::base::guard::guarded;
use crate::dim::math::{Pose, Real, Vector};
use parry::bounding_volume::BoundingVolume;
use parry::query::{DefaultQueryDispatcher, QueryDispatcher, ShapeCastOptions, ShapeCastStatus};
use parry::shape::Shape;

/// Largest distance at a hit, as a fraction of the smaller shape's size.
const GAP_FRACTION_MAX: Real = 5.0e-4;
/// Relative rounding error of coordinates.
const ROUNDING: Real = 32.0 * Real::EPSILON;
/// A cast over more than this number of sizes begins near the other shape.
const LONG_RATIO_MIN: Real = 64.0;
/// Largest number of steps after the search. Each halves the distance at least, or ends the cast.
const STEPS_MAX: usize = 32;

/// The cast of the second shape, which moves at a velocity relative to the first.
pub(super) fn cast_of_convex(
    pose12: &Pose,
    velocity: Vector,
    shapes: [&dyn Shape; 2],
    options: ShapeCastOptions,
) -> Option<Found> {
    let cast = Cast { pose12: *pose12, velocity, shapes, options };
    let start = cast.start()?;
    let found = cast.search(start)?;
    let is_exact = shapes.iter().any(|shape| shape.as_halfspace().is_some());
    if is_exact { Some(found) } else { cast.approach(found) }
}

struct Cast<'a> {
    pose12: Pose,
    velocity: Vector,
    shapes: [&'a dyn Shape; 2],
    options: ShapeCastOptions,
}

impl Cast<'_> {
    fn pose_at(&self, time: Real) -> Pose {
        let place = self.pose12.translation + self.velocity * time;
        Pose::from_parts(place, self.pose12.rotation)
    }

    /// The time at which the search begins: zero, or the time at which the boxes of distant shapes meet.
    /// `None` if these never do.
    fn start(&self) -> Option<Real> {
        let [own, other] =
            [self.shapes[0].compute_local_aabb(), self.shapes[1].compute_aabb(&self.pose12)];
        let coordinates = self.pose12.translation.abs().max_element();
        let size = own.half_extents().max_element() + other.half_extents().max_element();
        let is_distant = coordinates > LONG_RATIO_MIN * size;
        if !is_distant || !size.is_finite() {
            return Some(0.0);
        }
        let margin = self.options.target_distance + ROUNDING * coordinates;
        let half_extents = other.loosened(margin).half_extents();
        let path = SlabProbe::new(other.center(), self.velocity, half_extents);
        let [start, end] = path.span(&own);
        (start <= end && start <= self.options.max_time_of_impact).then_some(start)
    }

    /// parry's search from a time on.
    fn search(&self, start: Real) -> Option<Found> {
        let [shape1, shape2] = self.shapes;
        let max_time_of_impact = self.options.max_time_of_impact - start;
        let options = ShapeCastOptions { max_time_of_impact, ..self.options };
        let pose12 = self.pose_at(start);
        let cast =
            || DefaultQueryDispatcher.cast_shapes(&pose12, self.velocity, shape1, shape2, options);
        let mut found = Found::from(guarded(cast)?.ok()??);
        found.cost += start;
        Some(found)
    }

    /// Advances from a hit that may be early until the shapes touch. `None` if they do not.
    fn approach(&self, mut found: Found) -> Option<Found> {
        let [shape1, shape2] = self.shapes;
        let sizes =
            self.shapes.map(|shape| shape.compute_local_aabb().half_extents().max_element());
        let place = self.pose_at(found.cost).translation.abs().max_element();
        let tolerance =
            GAP_FRACTION_MAX * sizes[0].min(sizes[1]) + ROUNDING * (sizes[0].max(sizes[1]) + place);
        for _ in 0..STEPS_MAX {
            let pose12 = self.pose_at(found.cost);
            let gap = distance(&pose12, self.shapes)? - self.options.target_distance;
            if gap.is_nan() || gap <= tolerance {
                break;
            }
            let contact = || DefaultQueryDispatcher.contact(&pose12, shape1, shape2, Real::MAX);
            let contact = guarded(contact).and_then(|contact| contact.ok().flatten());
            // Without a normal, no point is faster than the whole shape.
            let closing = contact
                .map_or(self.velocity.length(), |contact| -self.velocity.dot(contact.normal1));
            let gap = contact.map_or(gap, |contact| contact.dist - self.options.target_distance);
            // A plane separates shapes that do not approach each other.
            let time = found.cost + gap.max(0.0) / closing;
            if closing <= 0.0 || time > self.options.max_time_of_impact {
                return None;
            }
            let (was, status) = (found, ShapeCastStatus::Converged);
            found = Found { cost: time, status, ..contact.map_or(was, Found::from) };
        }
        Some(found)
    }
}
