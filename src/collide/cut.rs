//! Large flat parts, cut to the neighbourhood of the other part for the search of closest points.
//!
//! The search works with differences of support points. On a floor of a kilometre, these have an error of a
//! tenth of a millimetre in single precision. The direction between two points a millimetre apart is then
//! wrong, and an overlap of a centimetre may be missed. A box, a triangle and a segment remain convex when
//! they are cut by the planes of a box around the other part. The search then works with lengths of the size
//! of the other part.
//!
//! The planes are so far from the other part that no closest points of separated parts are on them. If the
//! other part is deep in the large one, the direction of least overlap may lead through a plane. The search
//! is then repeated with the whole parts.

use crate::base::closest::{Closest, closest};
use crate::dim::collide::Polytope;
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::shape::SupportMap;
use parry::utils::point_cloud_support_point;
use smallvec::{SmallVec, smallvec};

/// Parts are large if they are longer than the reach of the search by this factor: 10 m in a world of metres.
const LARGE_RATIO: Real = 500.0;
/// Points that are nearer to a plane than this fraction of its distance from the other part are on it.
const PLANE_TOLERANCE: Real = 1.0e-3;

/// Corners of a cut polygon. Each plane adds at most one to those of a triangle.
type Corners = SmallVec<[Vector; 3 + 2 * DIM]>;

/// A box, a polygon or a segment that is large, in its own frame.
enum Large {
    /// The half extents.
    Box(Vector),
    Polygon(Corners),
}

impl Large {
    /// The polytope, if it is large.
    fn of(polytope: Option<&Polytope<'_>>, reach: Real) -> Option<Self> {
        let size = LARGE_RATIO * reach;
        let corners: Corners = match polytope? {
            Polytope::Cuboid(cuboid) => {
                let half = cuboid.half_extents;
                return (half.max_element() >= size).then_some(Self::Box(half));
            }
            Polytope::Triangle(triangle, _) => smallvec![triangle.a, triangle.b, triangle.c],
            Polytope::Segment(segment) => smallvec![segment.a, segment.b],
            Polytope::Hull(_) => return None,
        };
        let is_far = |corner: &Vector| (*corner - corners[0]).abs().max_element() >= size;
        corners.iter().any(is_far).then_some(Self::Polygon(corners))
    }

    /// The part of it in a region; `None` if it is not cut, or nothing is left.
    fn cut(self, region: Region) -> Option<Cut> {
        let Region { low, high, .. } = region;
        let part = match self {
            Self::Box(half) => {
                let is_cut = low.cmpgt(-half).any() || high.cmplt(half).any();
                let (low, high) = (low.max(-half), high.min(half));
                (is_cut && low.cmplt(high).all()).then_some(Part::Box { low, high })?
            }
            Self::Polygon(mut corners) => {
                for axis in 0..DIM {
                    corners = cut_polygon(&corners, axis, low[axis], 1.0);
                    corners = cut_polygon(&corners, axis, high[axis], -1.0);
                }
                (!corners.is_empty()).then_some(Part::Polygon(corners))?
            }
        };
        Some(Cut { part, region })
    }
}

/// A box around the other part, in the frame of the large one.
#[derive(Copy, Clone)]
struct Region {
    low: Vector,
    high: Vector,
    /// Distance of its planes from the other part.
    margin: Real,
}

impl Region {
    /// The region around a shape at a pose. It contains the closest points of all that is within `reach`.
    fn around(shape: &dyn SupportMap, pose: &Pose, reach: Real) -> Self {
        let (mut low, mut high) = (Vector::ZERO, Vector::ZERO);
        for axis in 0..DIM {
            let mut direction = Vector::ZERO;
            direction[axis] = 1.0;
            high[axis] = shape.support_point(pose, direction)[axis];
            low[axis] = shape.support_point(pose, -direction)[axis];
        }
        let margin = (high - low).max_element() + reach;
        Self { low: low - Vector::splat(margin), high: high + Vector::splat(margin), margin }
    }
}

/// The part of a large polytope in a region, in the frame of the whole.
struct Cut {
    part: Part,
    region: Region,
}

enum Part {
    Box {
        low: Vector,
        high: Vector,
    },
    /// At least one corner.
    Polygon(Corners),
}

impl Cut {
    /// Returns whether a point of the part is on a plane that cuts it. Its uncut sides are elsewhere.
    fn is_on_plane(&self, point: Vector) -> bool {
        let tolerance = Vector::splat(PLANE_TOLERANCE * self.region.margin);
        let Region { low, high, .. } = self.region;
        point.cmplt(low + tolerance).any() || point.cmpgt(high - tolerance).any()
    }
}

impl SupportMap for Cut {
    fn local_support_point(&self, direction: Vector) -> Vector {
        match &self.part {
            Part::Box { low, high } => Vector::select(direction.cmpge(Vector::ZERO), *high, *low),
            Part::Polygon(corners) => point_cloud_support_point(direction, corners),
        }
    }
}

/// Finds the closest points of two parts, without the layers around them, as [`closest`] does. `polytopes`
/// are those parts that are polytopes.
pub(super) fn closest_of_parts(
    pos12: &Pose,
    [shape1, shape2]: [&dyn SupportMap; 2],
    polytopes: [Option<&Polytope<'_>>; 2],
    reach: Real,
    last_normal: Vector,
) -> Closest {
    let [large1, large2] = polytopes.map(|polytope| Large::of(polytope, reach));
    let cut1 = large1.and_then(|large| large.cut(Region::around(shape2, pos12, reach)));
    let cut2 = large2.and_then(|large| large.cut(Region::around(shape1, &pos12.inverse(), reach)));
    let found = match (&cut1, &cut2) {
        (None, None) => closest(pos12, shape1, shape2, reach, last_normal),
        (Some(cut1), None) => closest(pos12, cut1, shape2, reach, last_normal),
        (None, Some(cut2)) => closest(pos12, shape1, cut2, reach, last_normal),
        (Some(cut1), Some(cut2)) => closest(pos12, cut1, cut2, reach, last_normal),
    };
    let Closest::Near { point1, point2, dist, .. } = found else { return found };
    let is_on_plane = |cut: &Option<Cut>, point: &dyn Fn() -> Vector| {
        cut.as_ref().is_some_and(|cut| cut.is_on_plane(point()))
    };
    let leads_through_plane = dist < 0.0
        && (is_on_plane(&cut1, &|| point1)
            || is_on_plane(&cut2, &|| pos12.inverse_transform_point(point2)));
    if leads_through_plane {
        return closest(pos12, shape1, shape2, reach, last_normal);
    }
    found
}

/// The part of a convex polygon on one side of a plane across an axis: above it for the sign 1, below it for
/// -1 (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974).
fn cut_polygon(corners: &[Vector], axis: usize, plane: Real, sign: Real) -> Corners {
    let mut kept = Corners::new();
    for (k, &corner) in corners.iter().enumerate() {
        let next = corners[(k + 1) % corners.len()];
        let [here, there] = [corner, next].map(|corner| sign * (corner[axis] - plane));
        if here >= 0.0 {
            kept.push(corner);
        }
        if (here >= 0.0) != (there >= 0.0) {
            let mut crossing = corner + (next - corner) * (here / (here - there));
            crossing[axis] = plane;
            kept.push(crossing);
        }
    }
    kept
}
