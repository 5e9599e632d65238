//! The rows that 3D alone has: two tangents that are solved together, and torsional friction about the
//! normal.
//!
//! Tests of both dimensions are in `step/solver/tests`, where the passes are called.

use super::friction::{self, WideFriction};
use super::pair::Pair;
use super::rows::Frame;
use super::tangents::{PointTangentMass, TangentMass};
use crate::base::random::Random;
use crate::base::wide::{Kernel, LANES, Lane, Simd, Wide};
use crate::dim3::math::{
    AngularInertia, MAX_MANIFOLD_POINTS, Real, Rotation, Vector, cross, mul_inertia, tangents,
};
use crate::dim3::state::WideMotion;
use crate::dim3::wide::{WideSymmetric, WideVector, set_symmetric_lane};
use crate::model::contact::{ContactInput, Turning, WidePoint};
use parry::mass_properties::MassProperties;

const ROUNDING: Real = 1000.0 * Real::EPSILON;

/// The lane of the tests.
const LANE: usize = LANES - 1;

fn random_vector(random: &mut Random) -> Vector {
    Vector::new(random.within(-1.0, 1.0), random.within(-1.0, 1.0), random.within(-1.0, 1.0))
}

/// The same vector in every lane.
fn lanes(vector: Vector) -> WideVector<Lane> {
    WideVector { x: Lane::splat(vector.x), y: Lane::splat(vector.y), z: Lane::splat(vector.z) }
}

struct FrameAbout(Vector);

impl Kernel for FrameAbout {
    type Output = [Vector; 3];

    #[inline(always)]
    fn run<W: Wide>(self) -> Self::Output {
        let frame = Frame::<W>::about(WideVector::splat(self.0));
        let mut axes = [lanes(Vector::ZERO); 3];
        frame.t1.store(&mut axes[0]);
        frame.t2.store(&mut axes[1]);
        frame.n.store(&mut axes[2]);
        [axes[0].lane(LANE), axes[1].lane(LANE), axes[2].lane(LANE)]
    }
}

#[test]
fn frames_are_those_of_single_vectors_and_right_handed() {
    let mut random = Random(1);
    let mut normals = vec![Vector::X, -Vector::Y, Vector::Z, -Vector::Z];
    normals.extend((0..100).map(|_| random_vector(&mut random).normalize()));
    for n in normals {
        let [t1, t2, _] = Simd::detect().run(FrameAbout(n));
        let expected = tangents(n);
        assert!((t1 - expected[0]).length() < ROUNDING && (t2 - expected[1]).length() < ROUNDING);
        assert!((t1.cross(t2) - n).length() < ROUNDING, "not right-handed about {n}");
    }
}

/// Two bodies whose first centre of mass is the origin, and where they touch.
struct Touch {
    normal: Vector,
    offset: Vector,
    inv_inertia: [AngularInertia; 2],
    velocities: [(Vector, Vector); 2],
    points: Vec<Vector>,
    coefficient: Real,
    normal_impulse: Real,
}

impl Touch {
    /// A square of points with a half diagonal of 0.3 about a middle; any bodies, any velocities.
    fn random(random: &mut Random) -> Self {
        let normal = random_vector(random).normalize();
        let middle = random_vector(random);
        let [t1, t2] = tangents(normal);
        let points = [t1, t2, -t1, -t2].map(|arm| middle + arm * 0.3).to_vec();
        let mut body = || {
            let moments = random_vector(random).abs() + Vector::splat(0.3);
            let mass = MassProperties::new(Vector::ZERO, 1.0, moments);
            mass.world_inv_inertia(&Rotation::from_scaled_axis(random_vector(random) * 3.0))
        };
        let inv_inertia = [body(), body()];
        let mut motion = || (random_vector(random), random_vector(random));
        let velocities = [motion(), motion()];
        let offset = random_vector(random);
        let (coefficient, normal_impulse) = (0.5, 1000.0);
        Self { normal, offset, inv_inertia, velocities, points, coefficient, normal_impulse }
    }

    /// Their velocities after an impulse at a point and a torsional impulse about the normal. Both have mass
    /// 1.
    fn pushed(&self, impulse: Vector, torsion: Real, point: Vector) -> [(Vector, Vector); 2] {
        let [(v1, w1), (v2, w2)] = self.velocities;
        let [i1, i2] = &self.inv_inertia;
        let moment = self.normal * torsion;
        [
            (v1 - impulse, w1 - mul_inertia(i1, point.cross(impulse) + moment)),
            (v2 + impulse, w2 + mul_inertia(i2, (point + self.offset).cross(impulse) + moment)),
        ]
    }
}

/// Velocity of the second body relative to the first at a point: along the plane, and about the normal.
fn slip(
    touch: &Touch,
    [(v1, w1), (v2, w2)]: [(Vector, Vector); 2],
    point: Vector,
) -> (Vector, Real) {
    let v = v2 + cross(w2, point + touch.offset) - v1 - cross(w1, point);
    (v - touch.normal * touch.normal.dot(v), (w2 - w1).dot(touch.normal))
}

/// One iteration of the friction rows: the impulse in world space and the torsional impulse.
struct Iterate<'a>(&'a Touch);

impl Kernel for Iterate<'_> {
    type Output = (Vector, Real);

    #[inline(always)]
    fn run<W: Wide>(self) -> Self::Output {
        let touch = self.0;
        let frame = Frame::<W>::about(WideVector::splat(touch.normal));
        let mut inv_inertia = [WideSymmetric::default(); 2];
        let mut local = [frame.local_symmetric([WideVector::zero(); 3]); 2];
        for side in 0..2 {
            set_symmetric_lane(&mut inv_inertia[side], LANE, &touch.inv_inertia[side]);
            let world = crate::dim3::wide::load_symmetric(&inv_inertia[side]);
            local[side] = frame.local_symmetric(frame.columns(world));
        }
        let zero = W::zero();
        let mut points = [WidePoint {
            local: WideVector::zero(),
            separation: zero,
            present: zero,
            impulse: zero,
        }; MAX_MANIFOLD_POINTS];
        for (point, &at) in points.iter_mut().zip(&touch.points) {
            point.local = frame.local(WideVector::splat(at));
            point.present = W::splat(1.0);
        }
        let pair = Pair {
            frame,
            offset: frame.local(WideVector::splat(touch.offset)),
            inv_mass: [WideVector::splat(Vector::ONE); 2],
            inv_inertia: local,
        };
        let mut input = ContactInput::EMPTY;
        input.friction = Lane::splat(touch.coefficient);
        let [(v1, w1), (v2, w2)] = touch.velocities;
        let motions = [
            WideMotion { linear: WideVector::splat(v1), angular: WideVector::splat(w1) },
            WideMotion { linear: WideVector::splat(v2), angular: WideVector::splat(w2) },
        ];
        let turning = Turning { angvels: motions.map(|motion| motion.angular), half_step: zero };
        let mut rows: WideFriction<W> =
            friction::prepare(&input, &pair, &points, W::splat(0.02), turning);
        let [x, y, torsion] =
            rows.solve(&frame, pair.offset, motions, W::splat(touch.normal_impulse));
        let (mut impulse, mut about) = (lanes(Vector::ZERO), Lane::ZERO);
        (frame.t1 * x + frame.t2 * y).store(&mut impulse);
        torsion.store(&mut about);
        (impulse.lane(LANE), about.0[LANE])
    }
}

fn middle(points: &[Vector]) -> Vector {
    points.iter().sum::<Vector>() / points.len() as Real
}

#[test]
fn one_iteration_stops_the_sliding_of_the_friction_centre() {
    let mut random = Random(2);
    for _ in 0..100 {
        let touch = Touch::random(&mut random);
        let center = middle(&touch.points);
        let (impulse, torsion) = Simd::detect().run(Iterate(&touch));
        let (sliding, _) = slip(&touch, touch.pushed(impulse, torsion, center), center);
        assert!(sliding.length() < ROUNDING, "{sliding} is left");
        // The torsional row was solved first, and alone.
        let (_, spin) = slip(&touch, touch.pushed(Vector::ZERO, torsion, center), center);
        assert!(spin.abs() < ROUNDING, "{spin} is left");
    }
}

#[test]
fn torsional_friction_is_bounded_by_friction_times_load_times_radius() {
    let mut random = Random(3);
    for _ in 0..100 {
        let mut touch = Touch::random(&mut random);
        touch.normal_impulse = random.within(0.0, 0.01);
        let (impulse, torsion) = Simd::detect().run(Iterate(&touch));
        let limit = touch.coefficient * touch.normal_impulse;
        assert!(impulse.length() <= limit * (1.0 + 8.0 * Real::EPSILON));
        assert!(torsion.abs() <= limit * 0.3 * (1.0 + ROUNDING));
        // It spins fast enough that the bound is reached, against the spin.
        let (_, spin) = slip(&touch, touch.velocities, middle(&touch.points));
        assert!(
            spin.abs() < 0.1 || (torsion + spin.signum() * limit * 0.3).abs() < ROUNDING * limit
        );
    }
}

#[test]
fn a_single_point_has_no_torsional_friction() {
    let mut random = Random(4);
    let mut touch = Touch::random(&mut random);
    touch.points.truncate(1);
    let (impulse, torsion) = Simd::detect().run(Iterate(&touch));
    assert_eq!(torsion, 0.0);
    assert!(impulse.length() > 0.0);
}

/// A friction limit far below the necessary impulse is fully used against the sliding direction, although
/// the impulse that would stop the slip has another direction. (At one point, so without torsion.)
#[test]
fn friction_is_opposite_to_the_slip() {
    let mut random = Random(5);
    for _ in 0..100 {
        let mut touch = Touch::random(&mut random);
        touch.normal_impulse = 0.001;
        touch.points.truncate(1);
        let (sliding, _) = slip(&touch, touch.velocities, touch.points[0]);
        let (impulse, _) = Simd::detect().run(Iterate(&touch));
        let expected = -sliding.normalize() * (touch.coefficient * touch.normal_impulse);
        assert!((impulse - expected).length() < ROUNDING * expected.length());
    }
}

/// Two tangential rows at a point: the matrix `K` (11, 12, 22), and the slip without their impulse.
struct Rows {
    k: [Real; 3],
    slip: [Real; 2],
}

impl Rows {
    /// Rows with the eigenvalues 1 and `ratio`, in any direction.
    fn random(random: &mut Random, ratio: Real) -> Self {
        let (sin, cos) = random.within(-3.0, 3.0).sin_cos();
        let [large, small] = [ratio * cos * cos + sin * sin, ratio * sin * sin + cos * cos];
        let k = [large, (ratio - 1.0) * sin * cos, small];
        Self { k, slip: [random.within(-3.0, 3.0), random.within(-3.0, 3.0)] }
    }

    /// The slip under an impulse.
    fn slip(&self, [x, y]: [Real; 2]) -> [Real; 2] {
        let [k11, k12, k22] = self.k;
        [self.slip[0] + k11 * x + k12 * y, self.slip[1] + k12 * x + k22 * y]
    }

    /// The energy `½ sᵀ K⁻¹ s` of a slip.
    fn energy(&self, [x, y]: [Real; 2]) -> Real {
        let [k11, k12, k22] = self.k;
        0.5 * (k22 * x * x - 2.0 * k12 * x * y + k11 * y * y) / (k11 * k22 - k12 * k12)
    }

    fn mass(&self) -> PointTangentMass {
        let [k11, k12, k22] = self.k;
        PointTangentMass::of([k11, k22].map(|k| if k > 0.0 { 1.0 / k } else { 0.0 }), || k12)
    }

    /// Iterates from an impulse.
    fn iterated(&self, start: [Real; 2], limit: Real, iterations: usize) -> [Real; 2] {
        let mass = self.mass();
        (0..iterations).fold(start, |old, _| mass.friction(old, self.slip(old), limit))
    }
}

fn length([x, y]: [Real; 2]) -> Real {
    x.hypot(y)
}

/// From every impulse within the cone, the iteration converges to Coulomb's law: the slip stops, or friction
/// is opposite to it and as large as the cone allows. The distance decreases at least by `1 - 1/ratio` in an
/// iteration.
#[test]
fn iterations_converge_to_coulombs_law() {
    let mut random = Random(6);
    for ratio in [1.0, 2.5, 30.0, 500.0] {
        for _ in 0..50 {
            let rows = Rows::random(&mut random, ratio);
            let limit = random.within(0.01, 3.0);
            let angle = random.within(-3.0, 3.0);
            let start = [limit * angle.cos(), limit * angle.sin()];
            let [x, y] = rows.iterated(start, limit, 20 * ratio as usize);
            let [sx, sy] = rows.slip([x, y]);
            let size = limit * length([sx, sy]);
            let sticks = length([sx, sy]) < 1.0e-3;
            assert!(sticks || (length([x, y]) / limit - 1.0).abs() < ROUNDING, "{ratio}");
            let opposite = (x * sx + y * sy + size).abs() < 2.0e-3 * size;
            assert!(sticks || opposite, "{ratio}: {x} {y} at the slip {sx} {sy}");
        }
    }
}

/// After a belt reverses, the impulse of the last step acts along the slip. Friction changes its direction at
/// once.
#[test]
fn friction_along_the_slip_is_turned() {
    let rows = Rows { k: [1.0, 0.0, 100.0], slip: [4.0, 0.0] };
    let [x, y] = rows.mass().friction([1.0, 0.0], rows.slip([1.0, 0.0]), 1.0);
    assert!((x + 1.0).abs() < ROUNDING && y == 0.0, "{x} {y}");
}

/// The first impulse of a contact dissipates energy, however different the effective masses are.
#[test]
fn first_friction_impulses_dissipate() {
    let mut random = Random(7);
    for _ in 0..1000 {
        let ratio = random.within(1.0, 500.0);
        let rows = Rows::random(&mut random, ratio);
        let limit = random.within(0.0, 3.0);
        let impulse = rows.mass().friction([0.0; 2], rows.slip, limit);
        let [before, after] = [rows.slip, rows.slip(impulse)].map(|slip| rows.energy(slip));
        assert!(after <= before * (1.0 + ROUNDING), "{before} J become {after} J");
    }
}

/// No load, no mobility, and a mobility along one direction alone.
#[test]
fn extreme_friction_is_finite() {
    let slip = [3.0, -1.0];
    let free = Rows { k: [1.0, 0.5, 2.0], slip };
    assert_eq!(free.mass().friction([0.2, 0.1], slip, 0.0), [0.0; 2]);
    let fixed = Rows { k: [0.0; 3], slip };
    assert_eq!(fixed.mass().friction([0.0; 2], slip, 5.0), [0.0; 2]);
    // Along (1, 1). One iteration stops the slip.
    let line = Rows { k: [2.0, 2.0, 2.0], slip: [1.0, 1.0] };
    let [x, y] = line.slip(line.mass().friction([0.0; 2], line.slip, 5.0));
    assert!(x.abs() < ROUNDING && y.abs() < ROUNDING, "{x} {y} is left");
    // `λt - ρ s` is zero, and the stopping impulse is outside the cone.
    let rows = Rows { k: [1.0, 0.0, 8.0], slip: [48.0, 0.0] };
    let [x, y] = rows.mass().friction([6.0, 0.0], [48.0, 0.0], 6.0);
    assert!((x + 6.0).abs() < ROUNDING && y == 0.0, "{x} {y}");
}

/// The friction of rows in lanes.
struct InLanes<'a> {
    rows: &'a Rows,
    old: [Real; 2],
    limit: Real,
}

impl Kernel for InLanes<'_> {
    type Output = [Real; 2];

    #[inline(always)]
    fn run<W: Wide>(self) -> Self::Output {
        let [k11, k12, k22] = self.rows.k;
        let mass = TangentMass::of([W::splat(k11), W::splat(k12), W::splat(k22)]);
        let [x, y] = self.rows.slip(self.old);
        let old = [W::splat(self.old[0]), W::splat(self.old[1])];
        let [x, y] = mass.friction(old, [W::splat(x), W::splat(y)], W::splat(self.limit));
        let mut impulse = [Lane::ZERO; 2];
        x.store(&mut impulse[0]);
        y.store(&mut impulse[1]);
        impulse.map(|lane| lane.0[LANE])
    }
}

#[test]
fn friction_in_lanes_equals_that_of_single_points() {
    let mut random = Random(8);
    for _ in 0..1000 {
        let ratio = random.within(1.0, 500.0);
        let rows = Rows::random(&mut random, ratio);
        let limit = random.within(0.0, 3.0);
        let old = [random.within(-1.0, 1.0) * limit, 0.0];
        let single = rows.mass().friction(old, rows.slip(old), limit);
        let lane = Simd::detect().run(InLanes { rows: &rows, old, limit });
        let difference = length([single[0] - lane[0], single[1] - lane[1]]);
        assert!(difference <= 1.0e-3 * limit, "{single:?} and {lane:?}");
    }
}
