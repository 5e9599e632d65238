//! Casts of two plain parts without a formula of their own.
//!
//! A half-space is touched by the lowest point of the other shape. Two shapes with support functions touch
//! where a line enters their difference ([`Line`]). parry's own search, a ray against that difference, misses
//! some shapes from a distance of a hundred sizes. Conservative advancement depends on a search for closest
//! points, which fails for shapes that just touch.

use super::entry::{Entry, Line};
use super::pair_query::Found;
use super::plain::{contact, status_of, time_until_touch};
use crate::base::bvh::SlabProbe;
use crate::dim::math::{Pose, Real, Vector};
use parry::bounding_volume::BoundingVolume;
use parry::query::ShapeCastOptions;
use parry::shape::{HalfSpace, Shape, SupportMap};

/// Relative rounding error of positions.
const ROUNDING: Real = 8.0 * Real::EPSILON;
/// Largest error of the path, as a fraction of the size of the smaller shape. The angle of the normal between
/// round shapes has the square root of that.
const PATH_ERROR_FRACTION_MAX: Real = 1.0e-6;
/// The direction of least overlap of shapes that overlap by less than some rounding errors is the one in
/// which they met.
const SHALLOW_RATIO_MAX: Real = 16.0;

/// The cast of the second shape, which moves at a velocity relative to the first.
pub(super) fn cast_of_convex(
    pose12: &Pose,
    velocity: Vector,
    shapes: [&dyn Shape; 2],
    options: ShapeCastOptions,
) -> Option<Found> {
    let [shape1, shape2] = shapes;
    if let Some(plane) = shape1.as_halfspace() {
        return cast_at_plane(pose12, velocity, plane, shape2.as_support_map()?, options);
    }
    if let Some(plane) = shape2.as_halfspace() {
        let velocity = pose12.rotation.inverse() * -velocity;
        let other = shape1.as_support_map()?;
        return cast_at_plane(&pose12.inverse(), velocity, plane, other, options)
            .map(Found::swapped);
    }
    let supports = [shape1.as_support_map()?, shape2.as_support_map()?];
    let cast = Cast { pose12: *pose12, velocity, shapes, supports, options };
    cast.first_touch()
}

/// The cast of a shape at a half-space.
fn cast_at_plane(
    pose12: &Pose,
    velocity: Vector,
    plane: &HalfSpace,
    shape: &dyn SupportMap,
    options: ShapeCastOptions,
) -> Option<Found> {
    let normals = [plane.normal, pose12.rotation.inverse() * -plane.normal];
    let lowest = shape.local_support_point(normals[1]);
    let place = *pose12 * lowest;
    let gap = plane.normal.dot(place) - options.target_distance;
    let time = time_until_touch(gap, -velocity.dot(plane.normal), &options)?;
    let touched = place + velocity * time;
    let points = [touched - plane.normal * plane.normal.dot(touched), lowest];
    Some(Found { points, normals, status: status_of(gap), ..Found::at(time) })
}

struct Cast<'a> {
    pose12: Pose,
    velocity: Vector,
    shapes: [&'a dyn Shape; 2],
    supports: [&'a dyn SupportMap; 2],
    options: ShapeCastOptions,
}

impl Cast<'_> {
    fn first_touch(&self) -> Option<Found> {
        let boxes = self.shapes.map(Shape::compute_local_aabb);
        let extents = boxes.map(|aabb| (aabb.center().abs() + aabb.half_extents()).max_element());
        let place = self.pose12.translation.abs().max_element();
        let size = extents[0] + extents[1] + self.options.target_distance;
        let rounding = ROUNDING * (size + place);
        let start = self.start(rounding)?;
        let at_start = self.pose12.translation + self.velocity * start;
        // The squares of very small and very large velocities are no numbers.
        let fastest = self.velocity.abs().max_element();
        let (direction, speed) = (self.velocity / fastest).normalize_and_length();
        let line = Line {
            shapes: self.supports,
            pose12: Pose::from_parts(at_start, self.pose12.rotation),
            direction,
            distance: self.options.target_distance,
            rounding,
            precision: PATH_ERROR_FRACTION_MAX
                * smaller(boxes.map(|aabb| aabb.half_extents().max_element())),
            size,
        };
        let entry = line.enter()?;
        if entry.path > 0.0 || start > 0.0 {
            let cost = start + entry.path.max(0.0) / speed / fastest;
            return Some(Found { cost, ..self.found(&entry) });
        }
        // Along the opposite direction the line enters where it leaves otherwise.
        let exit = Line { direction: -direction, ..line }.enter();
        if exit.is_some_and(|exit| exit.path > SHALLOW_RATIO_MAX * rounding) {
            return None; // The shapes have passed each other before the start.
        }
        self.touch_at_start(&entry, entry.path * direction.dot(entry.normal), rounding)
    }

    /// The time right before the boxes of the shapes meet; `None` if these never do.
    fn start(&self, rounding: Real) -> Option<Real> {
        let own = self.shapes[0].compute_local_aabb();
        let other = self.shapes[1].compute_aabb(&self.pose12);
        let other = other.loosened(self.options.target_distance + rounding);
        let path = SlabProbe::new(other.center(), self.velocity, other.half_extents());
        let [start, end] = path.span(&own);
        // The span of boxes that have passed each other ends at zero, too.
        let meet = start <= end && (start > 0.0 || own.intersects(&other));
        (meet && start <= self.options.max_time_of_impact).then_some(start)
    }

    /// The result for shapes that touch at the start, or have touched before. The line enters the difference
    /// before the start, and the overlap along the normal there has a depth.
    fn touch_at_start(&self, entry: &Entry, depth: Real, rounding: Real) -> Option<Found> {
        let distance = self.options.target_distance;
        let entered = Found { cost: distance - depth, ..self.found(entry) };
        let deepest = || contact(&self.pose12, self.shapes, Real::MAX).map(Found::from);
        // parry's search fails for shapes that just touch.
        let is_shallow = depth <= SHALLOW_RATIO_MAX * rounding;
        let touch = if is_shallow { entered } else { deepest().unwrap_or(entered) };
        let gap = touch.cost - distance;
        let closing = -self.velocity.dot(touch.normals[0]);
        if gap > SHALLOW_RATIO_MAX * rounding {
            return None; // The shapes touched before the start.
        }
        let cost = time_until_touch(gap, closing, &self.options)?;
        Some(Found { cost, status: status_of(gap), ..touch })
    }

    fn found(&self, entry: &Entry) -> Found {
        let normals = [entry.normal, self.pose12.rotation.inverse() * -entry.normal];
        Found { points: entry.points, normals, ..Found::at(0.0) }
    }
}

/// The smaller of two sizes, or the larger if the other one is zero.
fn smaller([size1, size2]: [Real; 2]) -> Real {
    if size1.min(size2) > 0.0 { size1.min(size2) } else { size1.max(size2) }
}
