//! The axes that separate a box and segments best, a segment per lane.
//!
//! A box and a segment are apart exactly if they are separated along one of three axes. These are the two of
//! the box and the normal of the segment. If they are not, the axis of least overlap is the contact normal.
//! Chains and height fields consist of segments, and most of those near a body are new candidates. So they
//! have no history, and one register tests one segment per lane.

use super::flat::{FlatBlock, FlatShape, set_flat_lane};
use super::polytope::Polytope;
use crate::base::axis::{BestAxis, Side, apart};
use crate::base::wide::{Kernel, Lane, Simd, Wide};
use crate::dim::math::{Pose, Real, Vector};
use crate::dim::wide::WideVector;
use parry::bounding_volume::Aabb;

/// Tolerance on the overlap within which the segment's axis is preferred, as a fraction of the smallest half
/// extent.
const TOLERANCE: Real = 0.001;
/// Preference of the last axis, in the same measure.
const LAST_AXIS_BONUS: Real = 0.01;
/// Least cosine of an axis and the last normal at which the axis counts as the last one.
const AXIS_COSINE_MIN: Real = 0.98;

/// The best axis of each kind: of the box, of the segment. In the frame of the box.
#[derive(Copy, Clone, Debug, Default)]
pub struct FlatAxes {
    gaps: [Lane; 2],
    normals: [WideVector<Lane>; 2],
}

impl FlatAxes {
    /// The best of one lane. `half` are the half extents of the box, `hint` is the normal of last time, or
    /// zero.
    pub fn best(&self, lane: usize, half: Vector, hint: Vector) -> BestAxis {
        let axis = |kind: usize, face: Side| BestAxis {
            gap: self.gaps[kind].0[lane],
            normal: self.normals[kind].lane(lane),
            face: Some(face),
        };
        let (of_box, of_segment) = (axis(0, Side::First), axis(1, Side::Second));
        let score = |axis: &BestAxis, bonus: Real| {
            let is_same = axis.normal.dot(hint) > AXIS_COSINE_MIN;
            let bonus = bonus + if is_same { LAST_AXIS_BONUS } else { 0.0 };
            axis.gap + bonus * half.min_element()
        };
        if score(&of_segment, TOLERANCE) >= score(&of_box, 0.0) { of_segment } else { of_box }
    }
}

/// The best axis; `None` if this is not known of such polytopes without a search. `hint` is the normal of
/// last time, or zero.
pub fn best_axis(
    pos12: &Pose,
    polytope1: &Polytope<'_>,
    polytope2: &Polytope<'_>,
    hint: Vector,
) -> Option<BestAxis> {
    let of = |half: Vector, flat: &FlatShape, pose: &Pose, hint: Vector| {
        let (mut block, mut axes) = (FlatBlock::default(), FlatAxes::default());
        set_flat_lane(&mut block, 0, flat);
        let culling = TriangleCulling::new(&Aabb::from_half_extents(Vector::ZERO, half), pose, 0.0);
        culling.near(&block, Simd::baseline(), &mut axes);
        flat.normal().map(|_| axes.best(0, half, hint))
    };
    match (polytope1, polytope2) {
        (Polytope::Cuboid(cuboid), Polytope::Segment(segment)) => {
            of(cuboid.half_extents, segment, pos12, hint)
        }
        (Polytope::Segment(segment), Polytope::Cuboid(cuboid)) => {
            let pos21 = pos12.inverse();
            let best = of(cuboid.half_extents, segment, &pos21, pos21.rotation * -hint)?;
            Some(best.exchanged(pos12))
        }
        _ => None,
    }
}

/// A box, and the prediction distance.
pub struct TriangleCulling {
    half: Vector,
    reach: Real,
    /// The axes of the segments' frame and its origin, as seen from the middle of the box.
    axes: [Vector; 2],
    origin: Vector,
}

impl TriangleCulling {
    /// For segments in a frame at `pose` in the frame of the box.
    pub fn new(around: &Aabb, pose: &Pose, reach: Real) -> Self {
        Self {
            half: around.half_extents(),
            reach,
            axes: Vector::AXES.map(|axis| pose.rotation * axis),
            origin: pose.translation - around.center(),
        }
    }

    /// Finds the axes of each segment. Returns a bit for each that is no farther than `reach` along any.
    pub fn near(&self, flats: &FlatBlock, simd: Simd, axes: &mut FlatAxes) -> u32 {
        simd.run(Pass { culling: self, flats, axes })
    }
}

struct Pass<'a> {
    culling: &'a TriangleCulling,
    flats: &'a FlatBlock,
    axes: &'a mut FlatAxes,
}

impl Kernel for Pass<'_> {
    type Output = u32;

    #[inline(always)]
    fn run<W: Wide>(self) -> u32 {
        let half = WideVector::<W>::splat(self.culling.half);
        let (a, b): (WideVector<W>, WideVector<W>) = (self.end(0), self.end(1));
        // An axis of the box.
        let (x, sign_x) = apart(a.x.min(b.x), a.x.max(b.x), half.x);
        let (y, sign_y) = apart(a.y.min(b.y), a.y.max(b.y), half.y);
        let (is_y, zero) = (x.lt(y), W::zero());
        let of_box = W::select(is_y, y, x);
        let normal =
            WideVector { x: W::select(is_y, zero, sign_x), y: W::select(is_y, sign_y, zero) };
        of_box.store(&mut self.axes.gaps[0]);
        normal.store(&mut self.axes.normals[0]);
        // The normal of the segment: the box is on the side of its centre.
        let along = b - a;
        let scale = W::splat(1.0) / along.dot(along).sqrt();
        let normal = WideVector { x: -along.y, y: along.x } * scale;
        let height = normal.dot(a);
        let outward = WideVector::select(height.lt(zero), -normal, normal);
        let of_segment = height.abs() - (half.x * normal.x.abs() + half.y * normal.y.abs());
        of_segment.store(&mut self.axes.gaps[1]);
        outward.store(&mut self.axes.normals[1]);
        W::bits(of_segment.max(of_box).le(W::splat(self.culling.reach)))
    }
}

impl Pass<'_> {
    /// An end of each segment, as seen from the middle of the box.
    #[inline(always)]
    fn end<W: Wide>(&self, index: usize) -> WideVector<W> {
        let end = WideVector::load(&self.flats[index]);
        let [x, y] = self.culling.axes;
        WideVector::splat(self.culling.origin)
            + WideVector::splat(x) * end.x
            + WideVector::splat(y) * end.y
    }
}

#[cfg(test)]
mod tests {
    use super::{FlatAxes, FlatBlock, TriangleCulling, set_flat_lane};
    use crate::base::random::Random;
    use crate::base::wide::{LANES, Simd};
    use crate::dim::math::{Pose, Real, Vector};
    use crate::dim2::collide::samples;
    use parry::bounding_volume::Aabb;
    use parry::shape::Segment;

    /// Distance of a box and a segment along the best of all axes, in sequence.
    fn gap(half: Vector, pose: &Pose, segment: &Segment) -> Real {
        let [a, b] = [segment.a, segment.b].map(|end| *pose * end);
        let normal = (b - a).perp().normalize();
        let apart = |axis: Vector| {
            let (first, second) = (axis.dot(a), axis.dot(b));
            let reach = axis.abs().dot(half);
            (first.min(second) - reach).max(-reach - first.max(second))
        };
        Vector::AXES.into_iter().chain([normal]).map(apart).fold(Real::MIN, Real::max)
    }

    #[test]
    fn lanes_find_the_best_axis_of_each_segment() {
        let mut random = Random(7);
        for _ in 0..500 {
            let half = Vector::new(random.within(0.1, 1.0), random.within(0.1, 1.0));
            let pose = samples::pose(&mut random, 1.0);
            let mut end = || samples::vector(&mut random, 1.5);
            let segments: [Segment; LANES] = core::array::from_fn(|_| Segment::new(end(), end()));
            let mut block = FlatBlock::default();
            for (lane, segment) in segments.iter().enumerate() {
                set_flat_lane(&mut block, lane, segment);
            }
            let reach = 0.05;
            let culling =
                TriangleCulling::new(&Aabb::from_half_extents(Vector::ZERO, half), &pose, reach);
            let (mut wide, mut baseline) = (FlatAxes::default(), FlatAxes::default());
            let near = culling.near(&block, Simd::detect(), &mut wide);
            assert_eq!(near, culling.near(&block, Simd::baseline(), &mut baseline));
            for (lane, segment) in segments.iter().enumerate() {
                let expected = gap(half, &pose, segment);
                let found = wide.gaps.iter().map(|gap| gap.0[lane]).fold(Real::MIN, Real::max);
                assert!((found - expected).abs() < 1.0e-4, "{found} instead of {expected}");
                assert_eq!(near >> lane & 1 == 1, found <= reach);
                for kind in 0..2 {
                    assert_eq!(
                        wide.gaps[kind].0[lane].to_bits(),
                        baseline.gaps[kind].0[lane].to_bits()
                    );
                }
            }
        }
    }
}
