//! Vectors, rotations and inertias in lanes against those of single bodies.

use super::scene::{Body, random_vector};
use crate::base::random::Random;
use crate::base::wide::{Kernel, LANES, Lane, Simd, Wide};
use crate::dim::math::{self, Vector};
use crate::dim::wide::{
    WideAngVector, WideRotation, WideSymmetric, WideVector, ang_dot, ang_lane, cross, load_ang,
    load_symmetric, mul_inertia, set_ang_lane, set_symmetric_lane, store_ang, torque,
};

/// Input and output of the formulas below.
#[derive(Copy, Clone, Default)]
struct Probe {
    a: WideVector<Lane>,
    b: WideVector<Lane>,
    w: WideAngVector<Lane>,
    inertia: WideSymmetric<Lane>,
    rotation: WideRotation<Lane>,
    vectors: [WideVector<Lane>; 4],
    angular: [WideAngVector<Lane>; 2],
    numbers: [Lane; 2],
}

impl Kernel for &mut Probe {
    type Output = ();
    #[inline(always)]
    fn run<W: Wide>(self) {
        let (a, b) = (WideVector::<W>::load(&self.a), WideVector::<W>::load(&self.b));
        let w = load_ang::<W>(&self.w);
        cross(w, a).store(&mut self.vectors[0]);
        WideRotation::<W>::load(&self.rotation).rotate(a).store(&mut self.vectors[1]);
        (-(a - b) * a.dot(b) + WideVector::splat(Vector::X)).store(&mut self.vectors[2]);
        let less = WideVector::select(a.x.lt(b.x), a, WideVector::zero());
        less.component_mul(b).store(&mut self.vectors[3]);
        store_ang::<W>(torque(a, b), &mut self.angular[0]);
        let inertia = load_symmetric::<W>(&self.inertia);
        store_ang::<W>(mul_inertia(inertia, w), &mut self.angular[1]);
        a.dot(b).store(&mut self.numbers[0]);
        ang_dot::<W>(w, w).store(&mut self.numbers[1]);
    }
}

/// The inputs of one lane: two vectors, and the rotation, angular velocity and inertia of a body.
fn inputs(lane: usize) -> (Vector, Vector, Body) {
    let mut random = Random(lane as u64 + 1);
    (random_vector(&mut random, 1.0), random_vector(&mut random, 1.0), Body::random(&mut random))
}

#[track_caller]
fn assert_near(found: Vector, expected: Vector) {
    assert!((found - expected).length() < 1.0e-5, "{found} instead of {expected}");
}

#[track_caller]
fn assert_ang_near(found: math::AngVector, expected: math::AngVector) {
    let error = math::ang_length_squared(found - expected);
    assert!(error < 1.0e-10, "{found} instead of {expected}");
}

#[test]
fn lanes_equal_single_bodies() {
    let mut probe = Probe::default();
    for lane in 0..LANES {
        let (a, b, Body { angvel: w, inv_inertia: inertia, rotation, .. }) = inputs(lane);
        probe.a.set_lane(lane, a);
        probe.b.set_lane(lane, b);
        set_ang_lane(&mut probe.w, lane, w);
        set_symmetric_lane(&mut probe.inertia, lane, &inertia);
        probe.rotation.set_lane(lane, &rotation);
    }
    Simd::detect().run(&mut probe);
    for lane in 0..LANES {
        let (a, b, Body { angvel: w, inv_inertia: inertia, rotation, .. }) = inputs(lane);
        let less = if a.x < b.x { a } else { Vector::ZERO };
        assert_near(probe.vectors[0].lane(lane), math::cross(w, a));
        assert_near(probe.vectors[1].lane(lane), rotation * a);
        assert_near(probe.vectors[2].lane(lane), (b - a) * a.dot(b) + Vector::X);
        assert_near(probe.vectors[3].lane(lane), less * b);
        assert_ang_near(ang_lane(&probe.angular[0], lane), math::torque(a, b));
        assert_ang_near(ang_lane(&probe.angular[1], lane), math::mul_inertia(&inertia, w));
        assert!((probe.numbers[0].0[lane] - a.dot(b)).abs() < 1.0e-5);
        assert!((probe.numbers[1].0[lane] - math::ang_dot(w, w)).abs() < 1.0e-5);
    }
}
