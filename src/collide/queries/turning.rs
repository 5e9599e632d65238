//! Casts of rotating shapes.
//!
//! They use the step's search for impacts (`collide/sweep`), which ends after a limited number of jumps. The
//! search of parry bisects between two times, and does not end for fast and long rotations.

use super::dispatcher::Dispatcher;
use super::pair_query::PairQuery;
use super::plain::box_of_unknown;
use crate::base::parry_version::shape_cast_hit;
use crate::collide::{Sweep, Touch, find_touches};
use crate::dim::collide::has_inside;
use crate::dim::math::{Pose, Real, Vector};
use parry::query::{
    Contact, NonlinearRigidMotion, ShapeCastHit, ShapeCastOptions, ShapeCastStatus,
};
use parry::shape::{Cuboid, Shape};

/// Touching distance, as a fraction of the smaller shape's size.
const TOUCH_TOLERANCE: Real = 1.0e-4;
/// Relative rounding error of the positions.
const ROUNDING: Real = 32.0 * Real::EPSILON;

/// The first touch of two shapes between two times, and its time.
pub fn first_touch(
    motions: [&NonlinearRigidMotion; 2],
    shapes: [&dyn Shape; 2],
    [start, end]: [Real; 2],
    stop_at_penetration: bool,
) -> Option<ShapeCastHit> {
    let sweeps = motions.map(|motion| sweep(motion, start, end));
    let poses12 =
        [0.0, 1.0].map(|fraction| sweeps[0].at(fraction).inv_mul(&sweeps[1].at(fraction)));
    if let [Some(_), Some(_)] = shapes.map(|shape| shape.as_halfspace()) {
        return touch_of_planes(poses12, shapes, [start, end], stop_at_penetration);
    }
    if stop_at_penetration && is_inside(&poses12[0], shapes) {
        return hit_at(&poses12[0], shapes, start);
    }
    let boxes = shapes.map(box_of_unknown);
    if boxes.iter().any(Option::is_some) {
        return touch_of_boxes(motions, shapes, boxes, [start, end], stop_at_penetration);
    }
    let tolerance = tolerance(shapes, [&sweeps[0], &sweeps[1]]);
    if !tolerance.is_finite() {
        return None;
    }
    let mut first = None;
    let mut found = |touch: Touch<'_>| {
        first = hit(&touch, [&sweeps[0], &sweeps[1]], tolerance, [start, end]).or(first);
    };
    find_touches(shapes, [&sweeps[0], &sweeps[1]], tolerance, stop_at_penetration, &mut found);
    first
}

/// Returns whether one of the shapes is in the solid that the surface of the other encloses. The search
/// visits neither that inside nor voxels without a free face.
fn is_inside(pose12: &Pose, shapes: [&dyn Shape; 2]) -> bool {
    shapes.iter().any(|shape| has_inside(*shape) || shape.as_voxels().is_some())
        && PairQuery::Intersection.least(pose12, shapes, 0.0).is_some()
}

/// The hit of shapes that touch at a pose.
fn hit_at(pose12: &Pose, shapes: [&dyn Shape; 2], time: Real) -> Option<ShapeCastHit> {
    let found = PairQuery::Contact.least(pose12, shapes, Real::MAX)?;
    let status = ShapeCastStatus::PenetratingOrWithinTargetDist;
    Some(shape_cast_hit(time, found.points, found.normals, status, found.ids))
}

/// The first touch of two half-spaces. They are apart only while their normals are opposite, so they touch as
/// soon as one rotates. Otherwise the distance changes linearly.
fn touch_of_planes(
    [first, last]: [Pose; 2],
    shapes: [&dyn Shape; 2],
    [start, end]: [Real; 2],
    stop_at_penetration: bool,
) -> Option<ShapeCastHit> {
    let options = ShapeCastOptions { stop_at_penetration, ..ShapeCastOptions::default() };
    let rotates = (last.rotation * Vector::ONE - first.rotation * Vector::ONE).length() > ROUNDING;
    if rotates {
        return PairQuery::Intersection
            .least(&last, shapes, 0.0)
            .and_then(|_| hit_at(&first, shapes, start));
    }
    let query = PairQuery::Cast { velocity: last.translation - first.translation, options };
    let found = query.least(&first, shapes, 1.0)?;
    let time = start + (end - start) * found.cost;
    Some(shape_cast_hit(time, found.points, found.normals, found.status, found.ids))
}

/// The first touch of shapes of which at least one counts as its bounding box.
fn touch_of_boxes(
    motions: [&NonlinearRigidMotion; 2],
    shapes: [&dyn Shape; 2],
    boxes: [Option<(Pose, Cuboid)>; 2],
    times: [Real; 2],
    stop_at_penetration: bool,
) -> Option<ShapeCastHit> {
    let pose = |side: usize| boxes[side].as_ref().map_or(Pose::IDENTITY, |(pose, _)| *pose);
    let shape = |side: usize| match &boxes[side] {
        Some((_, cuboid)) => cuboid as &dyn Shape,
        None => shapes[side],
    };
    let moved = |side: usize| {
        let NonlinearRigidMotion { start, local_center, linvel, angvel } = *motions[side];
        let local_center = pose(side).inverse_transform_point(local_center);
        NonlinearRigidMotion { start: start * pose(side), local_center, linvel, angvel }
    };
    let hit =
        first_touch([&moved(0), &moved(1)], [shape(0), shape(1)], times, stop_at_penetration)?;
    Some(hit.transform1_by(&pose(0)).swapped().transform1_by(&pose(1)).swapped())
}

fn sweep(motion: &NonlinearRigidMotion, start: Real, end: Real) -> Sweep<'static> {
    let pose = motion.position_at_time(start);
    let lasts = end - start;
    Sweep::new(pose, pose * motion.local_center, motion.linvel * lasts, motion.angvel * lasts)
}

fn tolerance(shapes: [&dyn Shape; 2], sweeps: [&Sweep<'_>; 2]) -> Real {
    let sizes = shapes.map(|shape| shape.compute_local_aabb().half_extents().max_element());
    let places = sweeps.map(|sweep| sweep.at(0.0).translation.abs().max_element());
    let size = sizes[0].min(sizes[1]);
    TOUCH_TOLERANCE * size + ROUNDING * (size + places[0].max(places[1]))
}

/// Result of a touch.
fn hit(
    Touch { fraction, sides }: &Touch<'_>,
    sweeps: [&Sweep<'_>; 2],
    tolerance: Real,
    [start, end]: [Real; 2],
) -> Option<ShapeCastHit> {
    let [side1, side2] = sides;
    let pose12 = sweeps[0].at(*fraction).inv_mul(&sweeps[1].at(*fraction));
    let parts12 = side1.place.inv_mul(&(pose12 * side2.place));
    let contact = contact(&parts12, [side1.shape, side2.shape], tolerance)?;
    let status = match *fraction {
        0.0 => ShapeCastStatus::PenetratingOrWithinTargetDist,
        _ if contact.dist > 2.0 * tolerance => ShapeCastStatus::OutOfIterations,
        _ => ShapeCastStatus::Converged,
    };
    let point = |place: &Pose, point: Vector| *place * point;
    let time = (start + (end - start) * fraction).min(end);
    let witnesses = [point(&side1.place, contact.point1), point(&side2.place, contact.point2)];
    let normals = [side1.place.rotation * contact.normal1, side2.place.rotation * contact.normal2];
    Some(shape_cast_hit(time, witnesses, normals, status, [side1.id, side2.id]))
}

/// The closest points of two shapes that touch, to this tolerance. parry's search may diverge at such small
/// distances. It is then repeated from the other side, and with the shapes a tolerance farther apart in
/// several directions.
fn contact(pose12: &Pose, [shape1, shape2]: [&dyn Shape; 2], tolerance: Real) -> Option<Contact> {
    let contact_after = |shift: Vector| {
        let mut pose = *pose12;
        pose.translation += shift;
        let from_here = Dispatcher.contact_of(&pose, [shape1, shape2], Real::MAX);
        let from_there = || Dispatcher.contact_of(&pose.inverse(), [shape2, shape1], Real::MAX);
        from_here.or_else(|| from_there().map(Contact::flipped))
    };
    let shifts = Vector::AXES.into_iter().flat_map(|axis| [axis * tolerance, axis * -tolerance]);
    core::iter::once(Vector::ZERO).chain(shifts).find_map(contact_after)
}
