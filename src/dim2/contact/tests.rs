//! The frame of the plane, and the friction row, which depends on heights only.
//!
//! Tests of both dimensions are in `step/solver/tests`, where the passes are called.

use super::friction::{self, WideFriction};
use super::pair::Pair;
use super::rows::Frame;
use crate::base::random::Random;
use crate::base::wide::{Kernel, LANES, Lane, Simd, Wide};
use crate::dim2::math::{MAX_MANIFOLD_POINTS, Real, Rotation, Vector, cross, tangents, torque};
use crate::dim2::state::WideMotion;
use crate::dim2::wide::WideVector;
use crate::model::contact::{ContactInput, Turning, WidePoint};

const ROUNDING: Real = 1000.0 * Real::EPSILON;

/// The lane of the tests.
const LANE: usize = LANES - 1;

fn random_vector(random: &mut Random) -> Vector {
    Vector::new(random.within(-1.0, 1.0), random.within(-1.0, 1.0))
}

struct TangentOf(Vector);

impl Kernel for TangentOf {
    type Output = Vector;

    #[inline(always)]
    fn run<W: Wide>(self) -> Vector {
        let mut tangent = WideVector::<Lane>::default();
        Frame::<W>::about(WideVector::splat(self.0)).t.store(&mut tangent);
        tangent.lane(LANE)
    }
}

#[test]
fn frames_are_those_of_single_vectors_and_right_handed() {
    let mut random = Random(1);
    for _ in 0..100 {
        let n = Rotation::new(random.within(-3.0, 3.0)) * Vector::X;
        let t = Simd::detect().run(TangentOf(n));
        assert_eq!([t], tangents(n));
        assert!((torque(t, n) - 1.0).abs() < ROUNDING, "not right-handed about {n}");
    }
}

/// Two bodies of mass 1 whose first centre of mass is the origin, and where they touch.
struct Touch {
    normal: Vector,
    offset: Vector,
    inv_inertia: [Real; 2],
    velocities: [(Vector, Real); 2],
    points: [Vector; MAX_MANIFOLD_POINTS],
    normal_impulse: Real,
}

/// One iteration of the friction row: the impulse in world space.
struct Iterate<'a>(&'a Touch);

impl Kernel for Iterate<'_> {
    type Output = Vector;

    #[inline(always)]
    fn run<W: Wide>(self) -> Vector {
        let touch = self.0;
        let frame = Frame::<W>::about(WideVector::splat(touch.normal));
        let (zero, one) = (W::zero(), W::splat(1.0));
        let point =
            WidePoint { local: WideVector::zero(), separation: zero, present: one, impulse: zero };
        let mut points = [point; MAX_MANIFOLD_POINTS];
        for (point, &at) in points.iter_mut().zip(&touch.points) {
            point.local = frame.local(WideVector::splat(at));
        }
        let [i1, i2] = touch.inv_inertia;
        let pair = Pair {
            frame,
            offset: frame.local(WideVector::splat(touch.offset)),
            inv_mass: [WideVector { x: one, y: one }; 2],
            inv_inertia: [W::splat(i1), W::splat(i2)],
        };
        let mut input = ContactInput::EMPTY;
        input.friction = Lane::splat(0.5);
        let [(v1, w1), (v2, w2)] = touch.velocities;
        let motions = [
            WideMotion { linear: WideVector::splat(v1), angular: W::splat(w1) },
            WideMotion { linear: WideVector::splat(v2), angular: W::splat(w2) },
        ];
        let turning = Turning { angvels: motions.map(|motion| motion.angular), half_step: zero };
        let mut row: WideFriction<W> =
            friction::prepare(&input, &pair, &points, W::splat(0.02), turning);
        let added = row.solve(&frame, pair.offset, motions, W::splat(touch.normal_impulse));
        let mut impulse = WideVector::<Lane>::default();
        (frame.t * added).store(&mut impulse);
        impulse.lane(LANE)
    }
}

fn random_touch(random: &mut Random) -> Touch {
    let normal = Rotation::new(random.within(-3.0, 3.0)) * Vector::X;
    let middle = random_vector(random);
    let [t] = tangents(normal);
    Touch {
        normal,
        offset: random_vector(random),
        inv_inertia: [random.within(0.0, 5.0), random.within(0.0, 5.0)],
        velocities: [(); 2].map(|()| (random_vector(random), random.within(-1.0, 1.0))),
        points: [middle - t * random.within(0.0, 1.0), middle + t * random.within(0.0, 1.0)],
        normal_impulse: 1000.0,
    }
}

/// The velocity along the tangent, which is the same at all points of one height.
#[test]
fn one_iteration_stops_the_sliding_of_all_points_of_a_height() {
    let mut random = Random(2);
    for _ in 0..100 {
        let touch = random_touch(&mut random);
        let impulse = Simd::detect().run(Iterate(&touch));
        let [(v1, w1), (v2, w2)] = touch.velocities;
        let (p, q) = (touch.points[0], touch.points[0] + touch.offset);
        let (v1, w1) = (v1 - impulse, w1 - touch.inv_inertia[0] * torque(p, impulse));
        let (v2, w2) = (v2 + impulse, w2 + touch.inv_inertia[1] * torque(q, impulse));
        for point in touch.points {
            let velocity = v2 + cross(w2, point + touch.offset) - v1 - cross(w1, point);
            let sliding = velocity.dot(tangents(touch.normal)[0]);
            assert!(sliding.abs() < ROUNDING, "{sliding} is left");
        }
    }
}

#[test]
fn friction_is_bounded_by_its_coefficient_times_the_load() {
    let mut random = Random(3);
    for _ in 0..100 {
        let mut touch = random_touch(&mut random);
        touch.normal_impulse = random.within(0.0, 0.1);
        let impulse = Simd::detect().run(Iterate(&touch));
        let limit = 0.5 * touch.normal_impulse;
        assert!(impulse.length() <= limit * (1.0 + 8.0 * Real::EPSILON));
        assert!(impulse.dot(touch.normal).abs() <= ROUNDING * limit);
    }
}
