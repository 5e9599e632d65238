//! Closest points of two convex shapes, also of shapes that overlap a little.
//!
//! For shapes that are apart this is parry's GJK. When they overlap, the direction of least overlap needs a
//! search ten times as expensive (EPA, expanding polytopes). But bodies in contact overlap hardly, and touch
//! almost as they did a step ago. The second shape is therefore first moved out along the last normal, until
//! the shapes are separated. Then the closest points are searched and moved back. The nearest point of a
//! polytope from close outside lies on the same face as from close inside. The result is therefore the
//! direction of least overlap near the last normal.

use parry::math::{DIM, Pose, Real, Vector};
use parry::query::epa::EPA;
use parry::query::gjk::{CsoPoint, GJKResult, VoronoiSimplex, closest_points};
use parry::shape::SupportMap;

/// Shapes that overlap by more than this fraction of their thickness are searched again.
const OVERLAP_RATIO_MAX: Real = 0.25;
/// Separation of the shapes for the search, as a fraction of their thickness: much more than GJK's tolerance,
/// much less than any relevant feature.
const SEPARATION_FRACTION: Real = 0.02;

/// Typical prediction distance in a world of metres (length units).
const PREDICTION_DISTANCE: Real = 0.02;
/// Worlds that are smaller than that by this factor are enlarged.
const SCALE_RATIO_MIN: Real = 8.0;

/// Result for two shapes, all in the frame of the first.
#[derive(Copy, Clone, Debug)]
pub enum Closest {
    /// They are farther apart than the prediction distance, along this unit vector.
    Apart(Vector),
    /// The closest points, or those of least overlap.
    Near {
        /// The point of the first shape.
        point1: Vector,
        /// The point of the second shape.
        point2: Vector,
        /// Unit vector from the first shape to the second.
        normal: Vector,
        /// Distance of the points along the normal, negative if the shapes overlap.
        dist: Real,
    },
}

/// The support points of two shapes along a direction.
pub struct Extents {
    /// Distance of the shapes along the direction; negative if they overlap.
    pub gap: Real,
    /// The smaller of the extents of the two along the direction.
    pub thickness: Real,
}

/// The extents of two shapes along the unit vector `direction`, of the first frame.
pub fn extents(
    pos12: &Pose,
    shape1: &(impl SupportMap + ?Sized),
    shape2: &(impl SupportMap + ?Sized),
    direction: Vector,
) -> Extents {
    let direction2 = pos12.rotation.inverse() * direction;
    let along = |shape: &dyn Fn(Vector) -> Vector, direction: Vector| {
        (shape(direction).dot(direction), shape(-direction).dot(direction))
    };
    let (high1, low1) = along(&|d| shape1.local_support_point(d), direction);
    let (high2, low2) = along(&|d| shape2.local_support_point(d), direction2);
    Extents {
        gap: pos12.translation.dot(direction) + low2 - high1,
        thickness: (high1 - low1).min(high2 - low2),
    }
}

/// Finds where two convex shapes are closest, if they are within `reach`. `last_normal` is the normal
/// of last time, or zero.
///
/// The search has tolerances that are lengths, made for shapes of a metre. A prediction distance of a
/// fraction of a millimetre indicates a world of millimetres: the shapes are enlarged for the search.
pub fn closest(
    pos12: &Pose,
    shape1: &(impl SupportMap + ?Sized),
    shape2: &(impl SupportMap + ?Sized),
    reach: Real,
    last_normal: Vector,
) -> Closest {
    let scale = PREDICTION_DISTANCE / reach;
    if !(scale > SCALE_RATIO_MIN && scale.is_finite()) {
        return closest_as_is(pos12, shape1, shape2, reach, last_normal);
    }
    let pose = Pose::from_parts(pos12.translation * scale, pos12.rotation);
    let (shape1, shape2) = (Scaled { shape: shape1, scale }, Scaled { shape: shape2, scale });
    match closest_as_is(&pose, &shape1, &shape2, PREDICTION_DISTANCE, last_normal) {
        Closest::Near { point1, point2, normal, dist } => Closest::Near {
            point1: point1 / scale,
            point2: point2 / scale,
            normal,
            dist: dist / scale,
        },
        apart => apart,
    }
}

/// A shape, enlarged.
struct Scaled<'a, S: ?Sized> {
    shape: &'a S,
    scale: Real,
}

impl<S: SupportMap + ?Sized> SupportMap for Scaled<'_, S> {
    fn local_support_point(&self, direction: Vector) -> Vector {
        self.shape.local_support_point(direction) * self.scale
    }
}

fn closest_as_is(
    pos12: &Pose,
    shape1: &(impl SupportMap + ?Sized),
    shape2: &(impl SupportMap + ?Sized),
    reach: Real,
    last_normal: Vector,
) -> Closest {
    if let Some(normal) = last_normal.try_normalize() {
        let extents = extents(pos12, shape1, shape2, normal);
        if extents.gap > reach {
            return Closest::Apart(normal);
        }
        if extents.gap < 0.0 && -extents.gap < OVERLAP_RATIO_MAX * extents.thickness {
            let shift = normal * (SEPARATION_FRACTION * extents.thickness - extents.gap);
            if let Some(found) = closest_apart(pos12, shape1, shape2, shift) {
                return found;
            }
        }
    }
    let simplex = &mut VoronoiSimplex::new();
    let start = last_normal.try_normalize().or(pos12.translation.try_normalize());
    let start = start.unwrap_or(Vector::X);
    simplex.reset(CsoPoint::from_shapes(pos12, shape1, shape2, start));
    match closest_points(pos12, shape1, shape2, reach, true, simplex) {
        GJKResult::ClosestPoints(point1, point2, normal) => {
            Closest::Near { point1, point2, normal, dist: (point2 - point1).dot(normal) }
        }
        GJKResult::NoIntersection(direction) => Closest::Apart(direction),
        GJKResult::Intersection => least_overlap(pos12, shape1, shape2, simplex),
        // Not returned when points are required.
        GJKResult::Proximity(_) => Closest::Apart(Vector::ZERO),
    }
}

/// The points of least overlap, from the final simplex of the closest-point search.
fn least_overlap(
    pos12: &Pose,
    shape1: &(impl SupportMap + ?Sized),
    shape2: &(impl SupportMap + ?Sized),
    simplex: &mut VoronoiSimplex,
) -> Closest {
    // EPA searches a third point across an edge, and reads that even if the edge is too long for a finite
    // direction.
    if simplex.dimension() <= 1 && !spans_numbers(pos12, shape1, shape2) {
        return Closest::Apart(Vector::X);
    }
    if simplex.dimension() == 1 {
        // An edge between equal points has no finite direction either. From a single point EPA finds a second
        // one at another position.
        let [first, second] = [0, 1].map(|k| *simplex.point(k));
        if (second.point - first.point).try_normalize().is_none() {
            simplex.reset(first);
        }
    }
    match EPA::new().closest_points(pos12, shape1, shape2, simplex) {
        Some((point1, point2, normal)) => {
            Closest::Near { point1, point2, normal, dist: (point2 - point1).dot(normal) }
        }
        None => Closest::Apart(Vector::X),
    }
}

/// Returns whether the squared distances of any two points of the shapes are finite.
fn spans_numbers(
    pos12: &Pose,
    shape1: &(impl SupportMap + ?Sized),
    shape2: &(impl SupportMap + ?Sized),
) -> bool {
    let is_sound = |direction: Vector| {
        let point = CsoPoint::from_shapes(pos12, shape1, shape2, direction).point;
        (point * 4.0).length_squared().is_finite()
    };
    (0..DIM).all(|k| {
        let mut axis = Vector::ZERO;
        axis[k] = 1.0;
        is_sound(axis) && is_sound(-axis)
    })
}

/// The closest points after moving the second shape by `shift`, which takes the shapes apart.
fn closest_apart(
    pos12: &Pose,
    shape1: &(impl SupportMap + ?Sized),
    shape2: &(impl SupportMap + ?Sized),
    shift: Vector,
) -> Option<Closest> {
    let moved = Pose::from_parts(pos12.translation + shift, pos12.rotation);
    let simplex = &mut VoronoiSimplex::new();
    simplex.reset(CsoPoint::from_shapes(&moved, shape1, shape2, shift.try_normalize()?));
    let found = closest_points(&moved, shape1, shape2, Real::MAX, true, simplex);
    let GJKResult::ClosestPoints(point1, moved2, normal) = found else { return None };
    let point2 = moved2 - shift;
    Some(Closest::Near { point1, point2, normal, dist: (point2 - point1).dot(normal) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;

    /// The hull of some points.
    struct Hull(Vec<Vector>);

    impl SupportMap for Hull {
        fn local_support_point(&self, direction: Vector) -> Vector {
            let farther = |a: Vector, b: Vector| {
                if b.dot(direction) > a.dot(direction) { b } else { a }
            };
            self.0.iter().copied().reduce(farther).expect("a hull has points")
        }
    }

    fn vector(random: &mut Random, sizes: [Real; DIM]) -> Vector {
        Vector::from_array(sizes.map(|size| random.within(-1.0, 1.0) * size))
    }

    /// Hulls of any size, needles and flakes among them, in a world of any unit. The search ends with a
    /// result as long as squares are finite. (EPA read a third point beside edges without a direction in
    /// numbers, as those of 10²⁰ m are, and there was none.)
    #[test]
    fn hulls_of_any_size_are_searched_to_an_end() {
        let mut random = Random(51);
        let power = |exponent: Real| (10.0 as Real).powf(exponent);
        let largest = Real::MAX.log10();
        for _ in 0..20_000 {
            let size = random.within(-9.0, f64::from(largest) - 1.0);
            let sizes = [(); DIM].map(|()| power(size - 4.0 * random.below(2) as Real));
            let points = [(); 2].map(|()| (0..8).map(|_| vector(&mut random, sizes)).collect());
            let [first, second] = points.map(Hull);
            let pose = Pose::from_translation(vector(&mut random, sizes));
            let unit = random.within(-12.0, 0.0);
            let last_normal = vector(&mut random, [1.0; DIM]) * random.below(2) as Real;
            let found = closest(&pose, &first, &second, power(unit), last_normal);
            let (Closest::Near { normal, .. } | Closest::Apart(normal)) = found;
            let has_squares = size - unit < largest / 2.0 - 2.0;
            assert!(normal.is_finite() || !has_squares, "size {size}, unit {unit}: {found:?}");
        }
    }
}
