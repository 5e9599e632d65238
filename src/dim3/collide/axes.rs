//! The axes that separate a box and triangles best, a triangle per lane.
//!
//! A box and a triangle are apart exactly if they are separated along one of 13 axes. These are the three of
//! the box, the normal of the triangle, and nine products of edges (Akenine-Möller 2001, "Fast 3D
//! triangle-box overlap testing"). If they are not, the axis of least overlap is the contact normal. A body
//! has dozens of mesh triangles around it and touches a few, and most of them are new candidates. So they
//! have no history, and one register tests one triangle per lane.

use super::flat::{FlatBlock, FlatShape, set_flat_lane};
use super::polytope::Polytope;
use crate::base::axis::{BestAxis, Side, apart};
use crate::base::wide::{Kernel, Lane, Simd, Wide};
use crate::dim::math::{Pose, Real, Vector};
use crate::dim::wide::{WideVector, cross};
use parry::bounding_volume::Aabb;

/// Tolerance on the overlap within which a face is preferred to another axis, as a fraction of the smallest
/// half extent.
const TOLERANCE: Real = 0.01;
/// Preference of the triangle among equal faces, as a fraction of the tolerance.
const FIRST_FACE_FRACTION: Real = 0.1;
/// Least cosine of an axis and the last normal at which the axis counts as the last one.
const AXIS_COSINE_MIN: Real = 0.98;
/// Edges whose directions have a smaller sine (squared) than this are parallel: their product equals a face
/// normal.
const PARALLEL_SINE_SQUARED_MAX: Real = 1.0e-4;

/// The best axis of each kind: of the box, of the triangle, of an edge of each. In the frame of the box.
#[derive(Copy, Clone, Debug, Default)]
pub struct FlatAxes {
    gaps: [Lane; 3],
    normals: [WideVector<Lane>; 3],
}

impl FlatAxes {
    /// The best of one lane. `half` are the half extents of the box, `hint` is the normal of last time, or
    /// zero.
    pub fn best(&self, lane: usize, half: Vector, hint: Vector) -> BestAxis {
        let tolerance = TOLERANCE * half.min_element();
        let penalties = [FIRST_FACE_FRACTION * tolerance, 0.0, tolerance];
        let faces = [Some(Side::First), Some(Side::Second), None];
        let axis = |kind: usize| BestAxis {
            gap: self.gaps[kind].0[lane],
            normal: self.normals[kind].lane(lane),
            face: faces[kind],
        };
        let score = |kind: usize| {
            let axis = axis(kind);
            let is_same = axis.normal.dot(hint) > AXIS_COSINE_MIN;
            axis.gap - penalties[kind] + if is_same { tolerance } else { 0.0 }
        };
        let mut best = (1, score(1));
        for kind in [0, 2] {
            let score = score(kind);
            if score > best.1 {
                best = (kind, score);
            }
        }
        axis(best.0)
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
        axes.best(0, half, hint)
    };
    match (polytope1, polytope2) {
        (Polytope::Cuboid(cuboid), Polytope::Triangle(triangle, _)) => {
            Some(of(cuboid.half_extents, triangle, pos12, hint))
        }
        (Polytope::Triangle(triangle, _), Polytope::Cuboid(cuboid)) => {
            let pos21 = pos12.inverse();
            let best = of(cuboid.half_extents, triangle, &pos21, pos21.rotation * -hint);
            Some(best.exchanged(pos12))
        }
        _ => None,
    }
}

/// A box, and the prediction distance.
pub struct TriangleCulling {
    half: Vector,
    reach: Real,
    /// The axes of the triangles' frame and its origin, as seen from the middle of the box.
    axes: [Vector; 3],
    origin: Vector,
}

impl TriangleCulling {
    /// For triangles in a frame at `pose` in the frame of the box.
    pub fn new(around: &Aabb, pose: &Pose, reach: Real) -> Self {
        Self {
            half: around.half_extents(),
            reach,
            axes: Vector::AXES.map(|axis| pose.rotation * axis),
            origin: pose.translation - around.center(),
        }
    }

    /// Finds the axes of each triangle. Returns a bit for each that is no farther than `reach` along any.
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
        let [a, b, c] = [self.corner(0), self.corner(1), self.corner(2)];
        let edges = [b - a, c - b, a - c];
        let of_box = Axis::of_box(half, [a, b, c]);
        let of_triangle = Axis::of_triangle(half, [a, b, c], cross(edges[0], edges[1]));
        let mut of_edges =
            Axis { gap: W::splat(Real::NEG_INFINITY), normal: WideVector::splat(Vector::Y) };
        // Along a product with an edge, both ends of the edge are at the same height.
        of_edges.or_of_edge(half, edges[0], a, c);
        of_edges.or_of_edge(half, edges[1], b, a);
        of_edges.or_of_edge(half, edges[2], c, b);
        of_box.store(0, self.axes);
        of_triangle.store(1, self.axes);
        of_edges.store(2, self.axes);
        let gap = of_box.gap.max(of_triangle.gap).max(of_edges.gap);
        W::bits(gap.le(W::splat(self.culling.reach)))
    }
}

impl Pass<'_> {
    /// A corner of each triangle, as seen from the middle of the box.
    #[inline(always)]
    fn corner<W: Wide>(&self, index: usize) -> WideVector<W> {
        let corner = WideVector::load(&self.flats[index]);
        let [x, y, z] = self.culling.axes;
        WideVector::splat(self.culling.origin)
            + WideVector::splat(x) * corner.x
            + WideVector::splat(y) * corner.y
            + WideVector::splat(z) * corner.z
    }
}

/// An axis per lane, from the box to the triangle, and the distance of the two along it.
#[derive(Copy, Clone)]
struct Axis<W> {
    gap: W,
    normal: WideVector<W>,
}

impl<W: Wide> Axis<W> {
    /// The best of the box's own axes.
    #[inline(always)]
    fn of_box(half: WideVector<W>, [a, b, c]: [WideVector<W>; 3]) -> Self {
        let (zero, one) = (W::zero(), W::splat(1.0));
        let [x, y, z] = [
            apart(a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x), half.x),
            apart(a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y), half.y),
            apart(a.z.min(b.z).min(c.z), a.z.max(b.z).max(c.z), half.z),
        ];
        let mut best = Self { gap: x.0, normal: WideVector { x: x.1, y: zero, z: zero } };
        best.or(y.0, WideVector { x: zero, y: y.1, z: zero }, one);
        best.or(z.0, WideVector { x: zero, y: zero, z: z.1 }, one);
        best
    }

    /// The triangle's normal. All corners have one height along it, except for needles, whose normal consists
    /// of rounding.
    #[inline(always)]
    fn of_triangle(
        half: WideVector<W>,
        [a, b, c]: [WideVector<W>; 3],
        normal: WideVector<W>,
    ) -> Self {
        let normal = normal * (W::splat(1.0) / normal.dot(normal).sqrt());
        let size = WideVector { x: normal.x.abs(), y: normal.y.abs(), z: normal.z.abs() };
        let [a, b, c] = [normal.dot(a), normal.dot(b), normal.dot(c)];
        let (gap, sign) = apart(a.min(b).min(c), a.max(b).max(c), half.dot(size));
        Self { gap, normal: normal * sign }
    }

    /// Takes the products of an edge of the triangle and those of the box, if they are better.
    #[inline(always)]
    fn or_of_edge(
        &mut self,
        half: WideVector<W>,
        edge: WideVector<W>,
        on_edge: WideVector<W>,
        opposite: WideVector<W>,
    ) {
        let (zero, least) = (W::zero(), W::splat(PARALLEL_SINE_SQUARED_MAX) * edge.dot(edge));
        let x = Product::new([edge.y, edge.z], [on_edge.y, on_edge.z], [half.y, half.z]);
        let normal = WideVector { x: zero, y: -edge.z, z: edge.y };
        self.or_of_product(x, [opposite.y, opposite.z], normal, least);
        let y = Product::new([edge.z, edge.x], [on_edge.z, on_edge.x], [half.z, half.x]);
        let normal = WideVector { x: edge.z, y: zero, z: -edge.x };
        self.or_of_product(y, [opposite.z, opposite.x], normal, least);
        let z = Product::new([edge.x, edge.y], [on_edge.x, on_edge.y], [half.x, half.y]);
        let normal = WideVector { x: -edge.y, y: edge.x, z: zero };
        self.or_of_product(z, [opposite.x, opposite.y], normal, least);
    }

    #[inline(always)]
    fn or_of_product(
        &mut self,
        product: Product<W>,
        opposite: [W; 2],
        normal: WideVector<W>,
        least: W,
    ) {
        let other = product.height(opposite);
        let (low, high) = (product.on_edge.min(other), product.on_edge.max(other));
        let (gap, sign) = apart(low, high, product.radius);
        let scale = W::splat(1.0) / product.length_squared.sqrt();
        let none = W::splat(Real::NEG_INFINITY);
        let gap = W::select(least.lt(product.length_squared), gap * scale, none);
        self.or(gap, normal * scale, sign);
    }

    /// Takes another axis, with a sign, if it is better.
    #[inline(always)]
    fn or(&mut self, gap: W, normal: WideVector<W>, sign: W) {
        let is_better = self.gap.lt(gap);
        self.gap = W::select(is_better, gap, self.gap);
        self.normal = WideVector::select(is_better, normal * sign, self.normal);
    }

    #[inline(always)]
    fn store(self, kind: usize, axes: &mut FlatAxes) {
        self.gap.store(&mut axes.gaps[kind]);
        self.normal.store(&mut axes.normals[kind]);
    }
}

/// The product of an axis of the box and an edge, projected along the axis: perpendicular to the edge's
/// projection, with the same length.
#[derive(Copy, Clone)]
struct Product<W> {
    edge: [W; 2],
    length_squared: W,
    /// Height of the edge along it, and extent of the box.
    on_edge: W,
    radius: W,
}

impl<W: Wide> Product<W> {
    #[inline(always)]
    fn new(edge: [W; 2], on_edge: [W; 2], half: [W; 2]) -> Self {
        let [u, v] = edge;
        Self {
            edge,
            length_squared: u * u + v * v,
            on_edge: u * on_edge[1] - v * on_edge[0],
            radius: half[1] * u.abs() + half[0] * v.abs(),
        }
    }

    #[inline(always)]
    fn height(&self, point: [W; 2]) -> W {
        self.edge[0] * point[1] - self.edge[1] * point[0]
    }
}

#[cfg(test)]
mod tests {
    use super::{FlatAxes, FlatBlock, TriangleCulling, set_flat_lane};
    use crate::base::random::Random;
    use crate::base::wide::{LANES, Simd};
    use crate::dim::math::{Pose, Real, Vector};
    use crate::dim3::collide::samples;
    use parry::bounding_volume::Aabb;
    use parry::shape::Triangle;

    /// Distance of a box and a triangle along the best of all axes, in sequence.
    fn gap(half: Vector, pose: &Pose, triangle: &Triangle) -> Real {
        let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| *pose * corner);
        let edges = [b - a, c - b, a - c];
        let products = Vector::AXES.into_iter().flat_map(|axis| edges.map(|edge| axis.cross(edge)));
        let axes = Vector::AXES.into_iter().chain([edges[0].cross(edges[1])]).chain(products);
        let apart = |axis: Vector| {
            let heights = [a, b, c].map(|corner| axis.dot(corner));
            let (low, high) =
                (heights.into_iter().reduce(Real::min), heights.into_iter().reduce(Real::max));
            let reach = axis.abs().dot(half);
            (low.unwrap() - reach).max(-reach - high.unwrap())
        };
        let gaps = axes.filter_map(|axis| axis.try_normalize()).map(apart);
        gaps.fold(Real::NEG_INFINITY, Real::max)
    }

    #[test]
    fn lanes_find_the_best_axis_of_each_triangle() {
        let mut random = Random(7);
        for _ in 0..500 {
            let half = Vector::from_array([(); 3].map(|()| random.within(0.1, 1.0)));
            let pose = samples::pose(&mut random, 1.0);
            let mut corner = || samples::vector(&mut random, 1.5);
            let triangles: [Triangle; LANES] =
                core::array::from_fn(|_| Triangle::new(corner(), corner(), corner()));
            let mut block = FlatBlock::default();
            for (lane, triangle) in triangles.iter().enumerate() {
                set_flat_lane(&mut block, lane, triangle);
            }
            let reach = 0.05;
            let culling =
                TriangleCulling::new(&Aabb::from_half_extents(Vector::ZERO, half), &pose, reach);
            let (mut wide, mut baseline) = (FlatAxes::default(), FlatAxes::default());
            let near = culling.near(&block, Simd::detect(), &mut wide);
            assert_eq!(near, culling.near(&block, Simd::baseline(), &mut baseline));
            for (lane, triangle) in triangles.iter().enumerate() {
                let expected = gap(half, &pose, triangle);
                let found = wide.gaps.iter().map(|gap| gap.0[lane]).fold(Real::MIN, Real::max);
                assert!((found - expected).abs() < 1.0e-4, "{found} instead of {expected}");
                assert_eq!(near >> lane & 1 == 1, found <= reach);
                for kind in 0..3 {
                    assert_eq!(
                        wide.gaps[kind].0[lane].to_bits(),
                        baseline.gaps[kind].0[lane].to_bits()
                    );
                }
                // A face may be preferred that is worse by a hundredth of the smallest half extent.
                let best = wide.best(lane, half, Vector::ZERO);
                assert!(best.gap > found - 0.011 * half.min_element());
                assert!((best.normal.length() - 1.0).abs() < 1.0e-4);
            }
        }
    }

    /// The normal of a needle consists of rounding, and must not separate touching shapes.
    #[test]
    fn needles_are_as_near_as_segments() {
        let mut random = Random(8);
        let mut near = 0;
        for round in 0..20_000 {
            let half = Vector::from_array([(); 3].map(|()| random.within(0.1, 1.0)));
            let pose = samples::pose(&mut random, 1.0);
            let (a, b) = (samples::vector(&mut random, 1.5), samples::vector(&mut random, 1.5));
            let between: Real = random.within(-1.0, 2.0);
            let needle = Triangle::new(a, b, a + (b - a) * between.clamp(0.0, 1.0));
            let mut block = FlatBlock::default();
            set_flat_lane(&mut block, 0, &needle);
            let culling =
                TriangleCulling::new(&Aabb::from_half_extents(Vector::ZERO, half), &pose, 0.05);
            let found = culling.near(&block, Simd::detect(), &mut FlatAxes::default());
            let cuboid = parry::shape::Cuboid::new(half);
            let segment = parry::shape::Segment::new(a, b);
            let distance = parry::query::distance(&Pose::IDENTITY, &cuboid, &pose, &segment);
            if distance.is_ok_and(|found| found.distance < 0.049) {
                assert_eq!(found & 1, 1, "round {round}: {needle:?}");
                near += 1;
            }
        }
        assert!(near > 5_000, "{near}");
    }
}
