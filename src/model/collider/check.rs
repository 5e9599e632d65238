//! Validation of shapes.
//!
//! All shapes are validated here, independent of their source: a constructor of the builder, parry's
//! constructors, or an edit through [`Collider::shape_mut`](super::Collider::shape_mut).

use super::InvalidCollider;
use crate::base::measure::{
    Measure, SHAPE_MAX, SHAPE_RANGE, is_coordinate, is_length, is_margin, is_point, is_size,
};
use crate::dim::math::{Pose, Real, Vector, rotation_is_valid};
use crate::dim::shapes;
use parry::shape::{Shape, SharedShape, TypedShape, Voxels};
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

type Verdict = Result<(), InvalidCollider>;

/// Refuses shapes with sizes that are negative or not finite, coordinates that are not finite, indices out of
/// range, no elements, or convex faces that cannot collide.
pub(crate) fn check_shape(raw: &dyn Shape) -> Verdict {
    check_numbers(raw)?;
    check_extent(raw)?;
    match raw.as_typed_shape() {
        TypedShape::HalfSpace(h) => check_unit("outward_normal", h.normal),
        TypedShape::HeightField(_) => check_box(raw),
        TypedShape::Voxels(v) => check_voxels(v),
        TypedShape::Compound(c) => check_parts(c.shapes()),
        TypedShape::Custom(custom) => check_box(custom),
        other => match shapes::convex_defect(other) {
            Some((shape, reason)) => degenerate(shape, reason),
            None => Ok(()),
        },
    }
}

/// Refuses shapes with sizes or coordinates that are no usable numbers, and indices out of range.
pub(crate) fn check_numbers(raw: &dyn Shape) -> Verdict {
    let shape = raw.as_typed_shape();
    for measure in measures(shape) {
        check_measure(measure)?;
    }
    match shape {
        TypedShape::Polyline(p) => check_elements("indices", p.indices(), p.vertices().len()),
        TypedShape::TriMesh(m) => check_elements("indices", m.indices(), m.vertices().len()),
        _ => Ok(()),
    }
}

/// The defining numbers of a shape.
fn measures(shape: TypedShape<'_>) -> SmallVec<[Measure<'_>; 4]> {
    use Measure::{Lengths, Margin, Point, Points, Size, Sizes};
    match shape {
        TypedShape::Ball(b) => smallvec![Size("radius", b.radius)],
        TypedShape::Cuboid(c) => smallvec![Sizes("half_extents", c.half_extents)],
        TypedShape::RoundCuboid(c) => smallvec![
            Sizes("half_extents", c.inner_shape.half_extents),
            Margin("border_radius", c.border_radius)
        ],
        TypedShape::Capsule(c) => {
            smallvec![Point("a", c.segment.a), Point("b", c.segment.b), Size("radius", c.radius)]
        }
        TypedShape::Segment(s) => smallvec![Point("a", s.a), Point("b", s.b)],
        TypedShape::Triangle(t) => smallvec![Point("a", t.a), Point("b", t.b), Point("c", t.c)],
        TypedShape::RoundTriangle(t) => smallvec![
            Point("a", t.inner_shape.a),
            Point("b", t.inner_shape.b),
            Point("c", t.inner_shape.c),
            Margin("border_radius", t.border_radius)
        ],
        TypedShape::Polyline(p) => smallvec![Points("vertices", p.vertices())],
        TypedShape::TriMesh(m) => smallvec![Points("vertices", m.vertices())],
        TypedShape::Voxels(v) => smallvec![Lengths("voxel_size", v.voxel_size())],
        other => shapes::measures(other),
    }
}

/// Returns whether two shapes are known to be the same: they share their data, or have the same type and the
/// same few numbers. Meshes, hulls and other shapes with lists are compared by their address.
pub(super) fn is_same_shape(one: &SharedShape, other: &SharedShape) -> bool {
    let is_list =
        |measure: &Measure<'_>| matches!(measure, Measure::Points(..) | Measure::Coordinates(..));
    if Arc::ptr_eq(&one.0, &other.0) {
        return true;
    }
    let is_primitive = |shape: &[Measure<'_>]| !shape.is_empty() && !shape.iter().any(is_list);
    let numbers = [one, other].map(|shape| measures(shape.as_typed_shape()));
    one.shape_type() == other.shape_type()
        && one.as_voxels().is_none()
        && is_primitive(&numbers[0])
        && numbers[0] == numbers[1]
}

fn check_measure(measure: Measure<'_>) -> Verdict {
    match measure {
        Measure::Size(name, value) => check_size(name, value),
        Measure::Margin(name, value) => check_margin(name, value),
        Measure::Sizes(name, values) => {
            values.to_array().into_iter().try_for_each(|value| check_size(name, value))
        }
        Measure::Lengths(name, values) => {
            values.to_array().into_iter().try_for_each(|value| check_length(name, value))
        }
        Measure::Point(name, value) => check_points(name, &[value]),
        Measure::Points(name, points) => check_points(name, points),
        Measure::Coordinates(name, values) => match values.iter().find(|v| !is_coordinate(**v)) {
            None => Ok(()),
            Some(&value) => number(name, value, "finite and at most 1e15"),
        },
    }
}

pub(crate) fn check_length(parameter: &'static str, value: Real) -> Verdict {
    if is_length(value) { Ok(()) } else { number(parameter, value, "between 1e-15 and 1e15") }
}

fn check_size(parameter: &'static str, value: Real) -> Verdict {
    if is_size(value) { Ok(()) } else { number(parameter, value, "0, or between 1e-15 and 1e15") }
}

pub(crate) fn check_margin(parameter: &'static str, value: Real) -> Verdict {
    if is_margin(value) { Ok(()) } else { number(parameter, value, "between 0 and 1e15") }
}

fn number(parameter: &'static str, value: Real, expected: &'static str) -> Verdict {
    Err(InvalidCollider::Number { parameter, value, expected })
}

fn degenerate(shape: &'static str, reason: &'static str) -> Verdict {
    Err(InvalidCollider::Degenerate { shape, reason })
}

pub(crate) fn check_points(parameter: &'static str, points: &[Vector]) -> Verdict {
    match points.iter().position(|point| !is_point(*point)) {
        None => Ok(()),
        Some(position) => {
            Err(InvalidCollider::Point { parameter, position, value: points[position] })
        }
    }
}

fn check_unit(parameter: &'static str, direction: Vector) -> Verdict {
    if (0.99..=1.01).contains(&direction.length()) {
        Ok(())
    } else {
        Err(InvalidCollider::Direction { parameter, value: direction })
    }
}

pub(crate) fn check_pose(pose: &Pose) -> Verdict {
    if is_point(pose.translation) && rotation_is_valid(&pose.rotation) {
        Ok(())
    } else {
        Err(InvalidCollider::Pose { value: *pose })
    }
}

/// Refuses an empty list of elements, and indices out of range.
pub(crate) fn check_elements<const N: usize>(
    parameter: &'static str,
    elements: &[[u32; N]],
    count: usize,
) -> Verdict {
    if elements.is_empty() {
        return Err(InvalidCollider::TooFew { parameter, count: 0, least: 1 });
    }
    for (position, element) in elements.iter().enumerate() {
        if let Some(&index) = element.iter().find(|index| **index as usize >= count) {
            return Err(InvalidCollider::IndexOutOfRange { parameter, position, index, count });
        }
    }
    Ok(())
}

fn check_voxels(voxels: &Voxels) -> Verdict {
    check_box(voxels)?;
    if voxels.voxels().any(|voxel| !voxel.state.is_empty()) {
        Ok(())
    } else {
        Err(InvalidCollider::TooFew { parameter: "voxels", count: 0, least: 1 })
    }
}

/// Refuses compounds without parts, and with parts that are themselves composite.
pub(super) fn check_kinds(parts: &[(Pose, SharedShape)]) -> Verdict {
    if parts.is_empty() {
        return Err(InvalidCollider::TooFew { parameter: "shapes", count: 0, least: 1 });
    }
    let is_composite = |(_, shape): &(Pose, SharedShape)| {
        shape.as_composite_shape().is_some() || shape.as_heightfield().is_some()
    };
    match parts.iter().position(is_composite) {
        Some(part) => Err(InvalidCollider::NestedCompound { part }),
        None => Ok(()),
    }
}

/// Refuses compounds without parts, with invalid ones, and with parts that are themselves composite.
pub(crate) fn check_parts(parts: &[(Pose, SharedShape)]) -> Verdict {
    check_kinds(parts)?;
    for (part, (pose, shape)) in parts.iter().enumerate() {
        check_pose(pose)
            .and_then(|()| check_shape(&**shape))
            .map_err(|reason| InvalidCollider::Part { part, reason: Box::new(reason) })?;
    }
    Ok(())
}

/// Refuses a shape that is too large for the precision. A half-space has no end.
fn check_extent(shape: &dyn Shape) -> Verdict {
    let aabb = shape.compute_local_aabb();
    let coordinates = [aabb.mins.to_array(), aabb.maxs.to_array()];
    let largest =
        coordinates.as_flattened().iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()));
    match largest {
        Some(size) if size.abs() > SHAPE_MAX && shape.as_halfspace().is_none() => {
            number("a coordinate of the bounding box", size, SHAPE_RANGE)
        }
        _ => Ok(()),
    }
}

/// Refuses a shape without a valid bounding box. User-defined shapes have no other check.
fn check_box(shape: &dyn Shape) -> Verdict {
    let aabb = shape.compute_local_aabb();
    check_points("bounding box", &[aabb.mins, aabb.maxs])?;
    if aabb.mins.cmple(aabb.maxs).all() {
        Ok(())
    } else {
        degenerate("shape", "its bounding box is inside out")
    }
}
