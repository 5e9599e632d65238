//! Rotation by rotation vectors, lane by lane, in 3D.

use super::math::{ANGLE_SQUARED_MAX, AngVector, Real};
use super::wide::{WideAngVector, WideRotation, WideSymmetric, WideVector, cross};
use crate::base::trig::{ATAN_P, ATAN_Q};
use crate::base::turning::{cosine_and_sine, wide_cosine_and_sine};
use crate::base::wide::{Kernel, Simd, Wide};
use core::f64::consts::TAU;

/// Largest angle (rad) at which [`turned_further`] uses the series.
const SERIES_ANGLE_MAX: Real = 0.5;
/// A rotation vector that is shorter than this has no direction of its own.
const ANGLE_MIN: Real = 1.0e-3;

/// The unit quaternion of a rotation vector: its vector part divided by that vector, and its real part. See
/// [`integrate_rotation`](crate::dim3::math::integrate_rotation), which this repeats.
#[inline(always)]
pub(crate) fn wide_unit_quaternion<W: Wide>(rotvec: WideAngVector<W>) -> (W, W) {
    let square = rotvec.dot(rotvec);
    let (cosine, sine) = wide_cosine_and_sine::<W, 2>(square.min(W::splat(ANGLE_SQUARED_MAX)));
    let scale = W::splat(1.0) / (cosine * cosine + square * (sine * sine)).sqrt();
    (sine * scale, cosine * scale)
}

/// The same of one body.
pub(crate) fn unit_quaternion(rotvec: AngVector) -> (Real, Real) {
    let square = rotvec.length_squared();
    let (cosine, sine) = cosine_and_sine::<2>(square.min(ANGLE_SQUARED_MAX));
    let scale = 1.0 / (cosine * cosine + square * (sine * sine)).sqrt();
    (sine * scale, cosine * scale)
}

/// A frame of a body after a rotation of the body.
#[inline(always)]
pub(crate) fn turned_frame<W: Wide>(
    frame: WideRotation<W>,
    rotvec: WideAngVector<W>,
) -> WideRotation<W> {
    rotation_by(rotvec).times(frame)
}

/// The rotation that a rotation vector makes.
#[inline(always)]
fn rotation_by<W: Wide>(rotvec: WideAngVector<W>) -> WideRotation<W> {
    let (scale, real) = wide_unit_quaternion(rotvec);
    let WideVector { x, y, z } = rotvec * scale;
    WideRotation { x, y, z, w: real }
}

/// The rotation vector of a rotation, of at most half a turn.
///
/// A quarter of the angle belongs to the slope `|v| / (1 + w)` of the quaternion. An eighth of it belongs to
/// a slope below 0.42, the range of [`atan_excess`].
#[inline(always)]
pub(crate) fn rotation_vector<W: Wide>(rotation: WideRotation<W>) -> WideAngVector<W> {
    let WideRotation { x, y, z, w } = rotation;
    let (one, v) = (W::splat(1.0), WideVector { x, y, z });
    let sign = W::select(w.lt(W::zero()), -one, one);
    let to_quarter = one / (one + w * sign);
    let quarter_squared = v.dot(v) * (to_quarter * to_quarter);
    let to_eighth = one / (one + (one + quarter_squared).sqrt());
    let angle_per_slope = one + atan_excess(quarter_squared * (to_eighth * to_eighth));
    v * (sign * W::splat(8.0) * to_quarter * to_eighth * angle_per_slope)
}

/// Relative difference of the angle of a slope from the slope, given the slope's square: valid for slopes of
/// up to ±0.66. See [`ATAN_P`].
#[inline(always)]
pub(super) fn atan_excess<W: Wide>(square: W) -> W {
    let polynomial = |terms: &[f64]| {
        let add = |sum: W, &term: &f64| sum * square + W::splat(term as Real);
        terms.iter().rev().fold(W::zero(), add)
    };
    square * (polynomial(&ATAN_P) / polynomial(&ATAN_Q))
}

/// The rotation vector of a rotation by `rotvec` and then by `by`. The sum of two rotation vectors is off by
/// half of `by × rotvec`. Joints that are solved with the sum break when the bodies are rotated.
///
/// Small ones are composed to third order: the series of Baker, Campbell and Hausdorff. Beyond that it fails
/// (a wheel with a radian per substep vibrated off its axle), and the rotations themselves are composed.
#[inline(always)]
pub(crate) fn turned_further<W: Wide>(
    rotvec: WideAngVector<W>,
    by: WideAngVector<W>,
) -> WideAngVector<W> {
    let across = cross(by, rotvec);
    let correction = across * W::splat(0.5) + cross(by - rotvec, across) * W::splat(1.0 / 12.0);
    let sum = rotvec + by;
    let is_far = W::splat(SERIES_ANGLE_MAX * SERIES_ANGLE_MAX).lt(sum.dot(sum));
    if W::any(is_far) {
        WideVector::select(is_far, composed(rotvec, by), sum + correction)
    } else {
        sum + correction
    }
}

/// The rotation vector of a rotation of one body by `rotvec` and then by `by`, both of any size.
pub(crate) fn composed_rotation(rotvec: AngVector, by: AngVector) -> AngVector {
    Simd::baseline().run(Compose { rotvec, by })
}

/// See [`composed_rotation`].
struct Compose {
    rotvec: AngVector,
    by: AngVector,
}

impl Kernel for Compose {
    type Output = AngVector;

    #[inline(always)]
    fn run<W: Wide>(self) -> AngVector {
        let mut lanes = WideVector::ZERO;
        composed(WideVector::<W>::splat(self.rotvec), WideVector::splat(self.by)).store(&mut lanes);
        lanes.lane(0)
    }
}

/// The same for rotations of any size: of all rotation vectors that lead there the one that is nearest to the
/// sum.
#[inline(always)]
fn composed<W: Wide>(rotvec: WideAngVector<W>, by: WideAngVector<W>) -> WideAngVector<W> {
    let (one, whole) = (W::splat(1.0), W::splat(TAU as Real));
    let direction_of = |vector: WideVector<W>, otherwise: WideVector<W>| {
        let length = vector.dot(vector).sqrt();
        let has_one = W::splat(ANGLE_MIN).lt(length);
        WideVector::select(has_one, vector * (one / length), otherwise)
    };
    let sum = rotvec + by;
    let once = rotation_vector(rotation_by(by).times(rotation_by(rotvec)));
    let along = direction_of(once, direction_of(sum, WideVector::zero()));
    let missing = (sum - once).dot(along);
    once + along * (nearest_whole(missing * (one / whole)) * whole)
}

/// The nearest whole number, by adding and subtracting a number without fractional digits. (Numbers larger
/// than that themselves become some whole number.)
#[inline(always)]
pub(crate) fn nearest_whole<W: Wide>(number: W) -> W {
    let large = W::splat(1.5 / Real::EPSILON);
    (number + large) - large
}

/// The inverse inertia of a body after a rotation of the body: `R I⁻¹ Rᵀ`.
#[inline(always)]
pub(crate) fn turned_inertia<W: Wide>(
    inv_inertia: WideSymmetric<W>,
    rotation: WideRotation<W>,
) -> WideSymmetric<W> {
    let m = inv_inertia;
    // Each row of I⁻¹ is rotated, and then each column of the result.
    let x = rotation.rotate(WideVector { x: m.m11, y: m.m12, z: m.m13 });
    let y = rotation.rotate(WideVector { x: m.m12, y: m.m22, z: m.m23 });
    let z = rotation.rotate(WideVector { x: m.m13, y: m.m23, z: m.m33 });
    let first = rotation.rotate(WideVector { x: x.x, y: y.x, z: z.x });
    let second = rotation.rotate(WideVector { x: x.y, y: y.y, z: z.y });
    let third = rotation.rotate(WideVector { x: x.z, y: y.z, z: z.z });
    WideSymmetric {
        m11: first.x,
        m12: first.y,
        m13: first.z,
        m22: second.y,
        m23: second.z,
        m33: third.z,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;
    use crate::base::wide::{LANES, Lane};
    use crate::dim::math::{
        AngularInertia, Rotation, Vector, integrate_rotation, rotation_to_angle,
    };
    use crate::dim::state::WideDisplacement;
    use crate::dim::wide::{load_symmetric, set_symmetric_lane, store_symmetric, symmetric_lane};

    /// A rotation, a further one, and the rotated vectors.
    struct Turns {
        rotvec: WideVector<Lane>,
        by: WideVector<Lane>,
        arm: WideVector<Lane>,
        inertia: WideSymmetric<Lane>,
    }

    impl Kernel for &mut Turns {
        type Output = ();
        #[inline(always)]
        fn run<W: Wide>(self) {
            let (rotvec, by) = (WideVector::<W>::load(&self.rotvec), WideVector::load(&self.by));
            let rotation = WideDisplacement::new(WideVector::zero(), rotvec).rotation();
            rotation.rotate(WideVector::load(&self.arm)).store(&mut self.arm);
            let inertia = turned_inertia(load_symmetric::<W>(&self.inertia), rotation);
            store_symmetric(inertia, &mut self.inertia);
            turned_further(rotvec, by).store(&mut self.rotvec);
        }
    }

    fn vector(random: &mut Random, size: f64) -> Vector {
        Vector::from_array([0; 3].map(|_| random.within(-size, size)))
    }

    /// Moment arms and inertias rotate as the formulas for one body state, and successive rotations are
    /// composed. The method has third order, so for rotations of up to 0.35 and 0.035 rad the error stays
    /// below the next term, 2e-5.
    #[test]
    fn lanes_turn_as_single_bodies_do() {
        let mut random = Random(31);
        let (rotvec, by) = (vector(&mut random, 0.2), vector(&mut random, 0.02));
        let arm = vector(&mut random, 1.0);
        let (m, n) = (vector(&mut random, 1.0), vector(&mut random, 1.0));
        let inertia = AngularInertia { m11: m.x, m12: m.y, m13: m.z, m22: n.x, m23: n.y, m33: n.z };
        let zero = WideVector::ZERO;
        let mut turns = Turns { rotvec: zero, by: zero, arm: zero, inertia: Default::default() };
        for lane in 0..LANES {
            turns.rotvec.set_lane(lane, rotvec);
            turns.by.set_lane(lane, by);
            turns.arm.set_lane(lane, arm);
            set_symmetric_lane(&mut turns.inertia, lane, &inertia);
        }
        Simd::detect().run(&mut turns);

        let rotation = integrate_rotation(Rotation::IDENTITY, rotvec);
        assert!(turns.arm.lane(1).abs_diff_eq(rotation * arm, 1.0e-6));
        let turned = symmetric_lane(&turns.inertia, 1);
        let torque: AngVector = vector(&mut random, 1.0);
        let expected = rotation * inertia.mul_vec(rotation.inverse() * torque);
        assert!(turned.mul_vec(torque).abs_diff_eq(expected, 1.0e-6));

        let composed = integrate_rotation(rotation, by);
        let further = integrate_rotation(Rotation::IDENTITY, turns.rotvec.lane(1));
        let added = integrate_rotation(Rotation::IDENTITY, rotvec + by);
        let [missed, added] =
            [further, added].map(|found| rotation_to_angle(&(composed * found.inverse())).length());
        assert!(missed < 2.0e-5 && added > 20.0 * missed, "{missed} rad, added {added} rad");
    }

    /// Rotations of any size compose to their product, and their turns are counted. The body wobbles, and
    /// rotates by up to 9 rad in each of three steps.
    #[test]
    fn large_turns_are_composed_exactly() {
        let mut random = Random(32);
        for size in [0.1, 0.6, 1.0, 2.0, 3.0] {
            let zero = WideVector::ZERO;
            let mut turns =
                Turns { rotvec: zero, by: zero, arm: zero, inertia: Default::default() };
            let (mut expected, mut sum) = (Rotation::IDENTITY, Vector::ZERO);
            for _ in 0..3 {
                let by = Vector::X * size + vector(&mut random, 0.01);
                turns.by.set_lane(2, by);
                Simd::detect().run(&mut turns);
                (expected, sum) = (integrate_rotation(expected, by), sum + by);
            }
            let rotvec = turns.rotvec.lane(2);
            let missed = expected.inverse() * integrate_rotation(Rotation::IDENTITY, rotvec);
            let missed = rotation_to_angle(&missed).length();
            assert!(missed < 5.0e-4, "{missed} rad off after {sum}");
            // Near a whole turn a little aside is far aside.
            assert!((rotvec.x - sum.x).abs() < 0.15, "{rotvec}, not about {sum}");
        }
    }
}
