//! Large flat parts, cut to the neighbourhood of the other part for the search of closest points.
//!
//! The search works with differences of support points. On a floor of a kilometre, these have an error of a
//! tenth of a millimetre in single precision. The direction between two points a millimetre apart is then
//! wrong, and an overlap of a centimetre may be missed. A box, a triangle and a segment remain convex when
//! they are cut by the planes of a box around the other part. The cut part has its size.
//!
//! The planes are far enough from the other part that the closest points are not on them. If the other part
//! is deep in the large one, the direction of least overlap may lead through a plane. Then the whole part is
//! deeper along that direction, and the search is repeated with the whole parts.

use crate::base::closest::{Closest, closest, extents};
use crate::dim::collide::Polytope;
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::shape::SupportMap;
use smallvec::{SmallVec, smallvec};

/// Parts are large if they are longer than the reach of the search by this factor: 10 m in a world of metres.
const LARGE_RATIO: Real = 500.0;

/// Corners of a cut polygon. Each plane adds at most one to those of a triangle.
type Corners = SmallVec<[Vector; 3 + 2 * DIM]>;

/// A part of a box, a polygon or a segment, in the frame of the whole.
enum Cut {
    Box { center: Vector, half: Vector },
    Polygon(Corners),
}

impl SupportMap for Cut {
    fn local_support_point(&self, direction: Vector) -> Vector {
        match self {
            Self::Box { center, half } => *center + half.copysign(direction),
            Self::Polygon(corners) => {
                let farther = |a: Vector, b: Vector| {
                    if b.dot(direction) > a.dot(direction) { b } else { a }
                };
                corners.iter().copied().reduce(farther).unwrap_or(Vector::ZERO)
            }
        }
    }
}

/// As [`closest`], for parts without their layers. `polytopes` are the parts that are polytopes.
pub(super) fn closest_of_parts(
    pos12: &Pose,
    shapes: [&dyn SupportMap; 2],
    polytopes: [Option<&Polytope<'_>>; 2],
    reach: Real,
    last_normal: Vector,
) -> Closest {
    let [shape1, shape2] = shapes;
    let whole = || closest(pos12, shape1, shape2, reach, last_normal);
    let cuts = [
        cut(polytopes[0], shape2, pos12, reach),
        cut(polytopes[1], shape1, &pos12.inverse(), reach),
    ];
    let found = match &cuts {
        [None, None] => return whole(),
        [Some(cut1), None] => closest(pos12, cut1, shape2, reach, last_normal),
        [None, Some(cut2)] => closest(pos12, shape1, cut2, reach, last_normal),
        [Some(cut1), Some(cut2)] => closest(pos12, cut1, cut2, reach, last_normal),
    };
    let is_through_plane = |normal: Vector, dist: Real| {
        extents(pos12, shape1, shape2, normal).gap < 2.0 * dist - reach
    };
    match found {
        Closest::Near { normal, dist, .. } if is_through_plane(normal, dist) => whole(),
        found => found,
    }
}

/// The part of a large polytope that is near another shape at a pose; `None` if it is not large or not cut.
fn cut(
    polytope: Option<&Polytope<'_>>,
    other: &dyn SupportMap,
    pose: &Pose,
    reach: Real,
) -> Option<Cut> {
    let large = LARGE_RATIO * reach;
    let corners: Corners = match polytope? {
        Polytope::Cuboid(cuboid) => {
            let half = cuboid.half_extents;
            if half.max_element() < large {
                return None;
            }
            let [low, high] = neighbourhood(other, pose, reach);
            let (low, high) = (low.max(-half), high.min(half));
            let is_cut = low.cmplt(high).all() && (high - low).max_element() < half.max_element();
            let (center, half) = ((low + high) * 0.5, (high - low) * 0.5);
            return is_cut.then_some(Cut::Box { center, half });
        }
        Polytope::Triangle(triangle, _) => smallvec![triangle.a, triangle.b, triangle.c],
        Polytope::Segment(segment) => smallvec![segment.a, segment.b],
        Polytope::Hull(_) => return None,
    };
    let length = corners.iter().map(|corner| (*corner - corners[0]).abs().max_element());
    if length.fold(0.0, Real::max) < large {
        return None;
    }
    let [low, high] = neighbourhood(other, pose, reach);
    let mut corners = corners;
    for axis in 0..DIM {
        corners = cut_polygon(&corners, |corner| corner[axis] - low[axis]);
        corners = cut_polygon(&corners, |corner| high[axis] - corner[axis]);
    }
    (!corners.is_empty()).then_some(Cut::Polygon(corners))
}

/// A box around a shape at a pose, in which the closest points of anything within `reach` are.
fn neighbourhood(shape: &dyn SupportMap, pose: &Pose, reach: Real) -> [Vector; 2] {
    let (mut low, mut high) = (Vector::ZERO, Vector::ZERO);
    for axis in 0..DIM {
        let mut direction = Vector::ZERO;
        direction[axis] = 1.0;
        high[axis] = shape.support_point(pose, direction)[axis];
        low[axis] = shape.support_point(pose, -direction)[axis];
    }
    let margin = (high - low).max_element() + reach;
    [low - Vector::splat(margin), high + Vector::splat(margin)]
}

/// The part of a convex polygon where `depth` is positive (Sutherland and Hodgman, "Reentrant Polygon
/// Clipping", 1974).
fn cut_polygon(corners: &[Vector], depth: impl Fn(Vector) -> Real) -> Corners {
    let mut kept = Corners::new();
    for (k, &corner) in corners.iter().enumerate() {
        let next = corners[(k + 1) % corners.len()];
        let [here, there] = [corner, next].map(&depth);
        if here >= 0.0 {
            kept.push(corner);
        }
        if (here >= 0.0) != (there >= 0.0) {
            kept.push(corner + (next - corner) * (here / (here - there)));
        }
    }
    kept
}
