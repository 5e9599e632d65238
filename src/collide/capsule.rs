//! Two capsules: the closest points of their axes, or both ends of the common interval of parallel axes.

use crate::base::feature;
use crate::base::segments::Segments;
use crate::dim::collide::{RawManifold, RawPoint};
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::Capsule;

/// Axes whose directions have a smaller sine (squared) than this lie along each other: about 3°.
const PARALLEL_SINE_SQUARED_MAX: Real = 3.0e-3;
/// Parallel capsules touch at one point only if the overlap is shorter than this fraction of the shorter
/// axis.
const OVERLAP_RATIO_MIN: Real = 1.0e-2;
/// Axes that are closer than this fraction of the radii do not define a separating direction.
const AXIS_DISTANCE_RATIO_MIN: Real = 1.0e-3;

/// Two segments in the frame of the first capsule.
struct Axes {
    start1: Vector,
    along1: Vector,
    start2: Vector,
    along2: Vector,
    /// `along1 · along1`, `along1 · along2`, `along2 · along2`.
    products: [Real; 3],
}

/// Computes the contacts of two capsules into `raw`. Returns their distance, 0 if they overlap; `None`
/// if their axes cross, so that the direction is a matter of all of their geometry.
pub(super) fn capsule_capsule(
    pos12: &Pose,
    capsule1: &Capsule,
    capsule2: &Capsule,
    prediction: Real,
    raw: &mut RawManifold,
) -> Option<Real> {
    let axes = Axes::of(pos12, capsule1, capsule2);
    let fractions = axes.closest();
    let radius = capsule1.radius + capsule2.radius;
    let offset = axes.point2(fractions[1]) - axes.point1(fractions[0]);
    let length = offset.length();
    // Written so that NaN is refused.
    let is_apart = length > AXIS_DISTANCE_RATIO_MIN * radius && length > 0.0;
    if !is_apart {
        return None;
    }
    let local_n1 = offset / length;
    let local_n2 = pos12.rotation.inverse() * -local_n1;
    (raw.local_n1, raw.local_n2) = (local_n1, local_n2);
    let pos21 = pos12.inverse();
    let mut add = |fractions: [Real; 2], name: u32| {
        let (p1, p2) = (axes.point1(fractions[0]), axes.point2(fractions[1]));
        let dist = (p2 - p1).dot(local_n1) - radius;
        if dist <= prediction {
            let local_p1 = p1 + local_n1 * capsule1.radius;
            let local_p2 = pos21 * p2 + local_n2 * capsule2.radius;
            let id = feature::face(name);
            raw.points.push(RawPoint::new(local_p1, local_p2, id, id, dist));
        }
    };
    match axes.common_range() {
        Some(ends) => {
            add(ends[0], 1);
            add(ends[1], 2);
        }
        None => add(fractions, 0),
    }
    Some((axes.distance(length) - radius).max(0.0))
}

impl Axes {
    fn of(pos12: &Pose, capsule1: &Capsule, capsule2: &Capsule) -> Self {
        let (segment1, segment2) = (&capsule1.segment, &capsule2.segment);
        let along1 = segment1.b - segment1.a;
        let along2 = pos12.rotation * (segment2.b - segment2.a);
        Self {
            start1: segment1.a,
            along1,
            start2: *pos12 * segment2.a,
            along2,
            products: [along1.dot(along1), along1.dot(along2), along2.dot(along2)],
        }
    }

    fn point1(&self, fraction: Real) -> Vector {
        self.start1 + self.along1 * fraction
    }

    fn point2(&self, fraction: Real) -> Vector {
        self.start2 + self.along2 * fraction
    }

    fn segments(&self) -> Segments {
        Segments::new([self.start1, self.start2], [self.along1, self.along2])
    }

    /// Closest points on the axes, as fractions of their lengths.
    fn closest(&self) -> [Real; 2] {
        let segments = self.segments();
        segments.nearest_from(if self.is_parallel() { 0.5 } else { segments.crossing() })
    }

    /// The distance of the axes, which are `length` apart at [`Self::closest`]. For nearly parallel axes it
    /// is within their common interval; one of the four ends may be nearer.
    fn distance(&self, length: Real) -> Real {
        if !self.is_parallel() {
            return length;
        }
        let segments = self.segments();
        let of_first = [0.0, 1.0].map(|end| [end, segments.on_second(end)]);
        let of_second = [0.0, 1.0].map(|end| [segments.on_first(end), end]);
        let at = |[fraction1, fraction2]: [Real; 2]| {
            self.point1(fraction1).distance(self.point2(fraction2))
        };
        of_first.into_iter().chain(of_second).map(at).fold(length, Real::min)
    }

    fn is_parallel(&self) -> bool {
        let [a, b, c] = self.products;
        a * c - b * b <= PARALLEL_SINE_SQUARED_MAX * a * c
    }

    /// The two ends of the common interval of parallel axes, each as fractions of the lengths.
    fn common_range(&self) -> Option<[[Real; 2]; 2]> {
        let [a, b, c] = self.products;
        if !self.is_parallel() || a == 0.0 || c == 0.0 {
            return None;
        }
        // The ends of the second axis, seen on the first.
        let start = self.along1.dot(self.start2 - self.start1) / a;
        let end = start + b / a;
        let (low, high) = (start.min(end).max(0.0), start.max(end).min(1.0));
        if (high - low) * a.sqrt() <= OVERLAP_RATIO_MIN * a.min(c).sqrt() {
            return None;
        }
        let on_second = |fraction: Real| ((fraction - start) / (end - start)).clamp(0.0, 1.0);
        Some([[low, on_second(low)], [high, on_second(high)]])
    }
}
