//! The angles of free axes while the bodies move, lane by lane.
//!
//! A *twist* about `e` is twice the angle of the point `(w, v·e)` on a circle. The tracker adds the twist
//! since the start of the step to the initial one. For two points with the complex numbers `z₀` and `z`, it
//! is the angle of `z z₀*`. So turns that were counted stay counted, and small angles keep their digits.
//!
//! That is ambiguous by whole turns. A wheel that rotates by 5 rad in a step has the same pose as after -1.3
//! rad. The sum of the rotations of all substeps is a second estimate of the bodies' relative rotation. With
//! one free rotation and counted turns, this estimate selects among these values. It needs an error of less
//! than half a turn only, so a rotation of the axis itself does no harm.
//!
//! The lengths and components of rotation vectors have no counted turns.

use crate::base::trig::sin_cos;
use crate::base::wide::{Lane, Wide};
use crate::dim3::joint_angle::{Angle, COSINE_MIN, FreeRotations, Part, SINE_MIN};
use crate::dim3::joint_axes::JointAxis;
use crate::dim3::math::{Real, Vector};
use crate::dim3::rotation_vector::{atan_excess, nearest_whole, rotation_vector};
use crate::dim3::wide::{WideAngVector, WideRotation, WideVector, cross};

const TURN: Real = 2.0 * core::f64::consts::PI as Real;
/// Largest number of turns in a step that can be counted.
const TURNS_MAX: Real = 1.0e6;

/// Measures one angle of each lane's joint.
#[derive(Clone, Debug)]
pub(crate) struct AngleTracker {
    /// The axis of a twist or of a component, or the direction of a rotation vector without length.
    axis: WideVector<Lane>,
    /// The axis that swings. Zero in lanes that measure a whole rotation.
    swung: WideVector<Lane>,
    /// One for twists, and one for rotation vectors: both zero in lanes that have no angle.
    twists: Lane,
    vectors: Lane,
    /// One where the length of a rotation vector is measured, and not a component.
    sizes: Lane,
    /// One where turns are counted.
    counts: Lane,
    /// The twist when the step began, and its point.
    angle: Lane,
    cos: Lane,
    sin: Lane,
    /// Whether any lane measures a twist, and whether any measures a rotation vector.
    has_twists: bool,
    has_vectors: bool,
}

impl AngleTracker {
    /// No angle in any lane.
    pub const NONE: Self = Self {
        axis: WideVector::ZERO,
        swung: WideVector::ZERO,
        twists: Lane::ZERO,
        vectors: Lane::ZERO,
        sizes: Lane::ZERO,
        counts: Lane::ZERO,
        angle: Lane::ZERO,
        cos: Lane::splat(1.0),
        sin: Lane::ZERO,
        has_twists: false,
        has_vectors: false,
    };

    /// Measures the angle of an axis, of this size when the step begins.
    pub fn set_lane(
        &mut self,
        lane: usize,
        axis: JointAxis,
        rotations: FreeRotations,
        angle: Real,
    ) {
        match Angle::of(axis, rotations) {
            Angle::Twist(e) => self.set_twist(lane, e, rotations.is_single(), angle),
            Angle::Size(part) => self.set_vector(lane, part, part.default_axis(), true),
            Angle::Component(part, e) => self.set_vector(lane, part, e, false),
        }
    }

    fn set_twist(&mut self, lane: usize, axis: Vector, is_counted: bool, angle: Real) {
        self.axis.set_lane(lane, axis);
        self.twists.0[lane] = 1.0;
        self.counts.0[lane] = if is_counted { 1.0 } else { 0.0 };
        (self.sin.0[lane], self.cos.0[lane]) = sin_cos(angle * 0.5);
        self.angle.0[lane] = angle;
        self.has_twists = true;
    }

    fn set_vector(&mut self, lane: usize, part: Part, axis: Vector, is_size: bool) {
        self.axis.set_lane(lane, axis);
        self.swung.set_lane(lane, part.swung());
        self.vectors.0[lane] = 1.0;
        self.sizes.0[lane] = if is_size { 1.0 } else { 0.0 };
        self.has_vectors = true;
    }

    /// The direction, in the first frame, along which the relative angular velocity changes the angle, and
    /// the angle. `between` is the second frame relative to the first. `rotvec` is the approximate rotation
    /// since the start of the step, in the first frame, with all turns.
    #[inline(always)]
    pub fn measure<W: Wide>(
        &self,
        between: WideRotation<W>,
        rotvec: WideAngVector<W>,
    ) -> (WideAngVector<W>, W) {
        let zero = W::zero();
        let (mut direction, mut angle) = (WideVector::zero(), zero);
        if self.has_twists {
            let (of_twist, turned) = self.twist(between);
            let is_twist = zero.lt(W::load(&self.twists));
            let counted = W::load(&self.angle) + self.with_turns(turned, rotvec);
            direction = WideVector::select(is_twist, of_twist, direction);
            angle = W::select(is_twist, counted, angle);
        }
        if self.has_vectors {
            let (of_vector, size) = self.part(between);
            let is_vector = zero.lt(W::load(&self.vectors));
            direction = WideVector::select(is_vector, of_vector, direction);
            angle = W::select(is_vector, size, angle);
        }
        (direction, angle)
    }

    /// The angle of a twist, given modulo whole turns.
    #[inline(always)]
    fn with_turns<W: Wide>(&self, turned: W, rotvec: WideAngVector<W>) -> W {
        let about = rotvec.dot(WideVector::load(&self.axis));
        let turns = nearest_whole((about - turned) * W::splat(1.0 / TURN));
        let counts = W::zero().lt(W::load(&self.counts)) & turns.abs().lt(W::splat(TURNS_MAX));
        W::select(counts, turned + turns * W::splat(TURN), turned)
    }

    /// The direction of a twist, and the twist since the start of the step: at most half a turn.
    #[inline(always)]
    fn twist<W: Wide>(&self, between: WideRotation<W>) -> (WideAngVector<W>, W) {
        let one = W::splat(1.0);
        let v = WideVector { x: between.x, y: between.y, z: between.z };
        let e = WideVector::load(&self.axis);
        let f = between.rotate(e);
        let sum = one + e.dot(f);
        let fair = W::splat(1.0e-3).lt(sum);
        let shared = (e + f) * (one / W::select(fair, sum, one));
        let (cos, sin) = (between.w, v.dot(e));
        let (old_cos, old_sin) = (W::load(&self.cos), W::load(&self.sin));
        let (x, y) = (cos * old_cos + sin * old_sin, sin * old_cos - cos * old_sin);
        // A point and its opposite are the same twist.
        let sign = W::select(x.lt(W::zero()), -one, one);
        let half = angle_of(y * sign, x * sign);
        (WideVector::select(fair, shared, e), half + half)
    }

    /// The direction of the length or of a component of a rotation vector, and its angle.
    #[inline(always)]
    fn part<W: Wide>(&self, between: WideRotation<W>) -> (WideAngVector<W>, W) {
        let (zero, one, least) = (W::zero(), W::splat(1.0), W::splat(SINE_MIN));
        let (k, e) = (WideVector::load(&self.axis), WideVector::load(&self.swung));
        let (is_swing, is_size) = (e.dot(e), zero.lt(W::load(&self.sizes)));
        // Without the twist, of which a whole rotation keeps the sign of its real part.
        let along = WideVector { x: between.x, y: between.y, z: between.z }.dot(e);
        let length = (between.w * between.w + along * along).sqrt();
        let has_twist = least.lt(length);
        let scale = one / W::select(has_twist, length, one);
        let WideVector { x, y, z } = e * (along * scale);
        let w = W::select(has_twist, between.w * scale, one);
        let part = between.since(WideRotation { x, y, z, w });

        let rotvec = rotation_vector(part);
        let across = WideVector { x: part.x, y: part.y, z: part.z };
        let (sin, cos) = (across.dot(across).sqrt(), part.w);
        let has_axis = least.lt(sin);
        let inv_sin = one / W::select(has_axis, sin, one);
        let n = across * inv_sin;
        let half = rotvec.dot(n) * W::splat(0.5);
        let opposite = is_swing * sin * (one / cos.max(W::splat(COSINE_MIN)));
        let straight = half * (cos * inv_sin - opposite);
        let of_component = k * straight
            + n * (n.dot(k) * (one - straight))
            + cross(n, k) * (half + half * is_swing);
        let direction = WideVector::select(is_size, n, of_component);
        let angle = W::select(is_size, half + half, rotvec.dot(k));
        (WideVector::select(has_axis, direction, k), W::select(has_axis, angle, zero))
    }
}

/// The angle of a point on a circle, of at most a right angle.
///
/// The tangent of half the angle is `sin / (1 + cos)`. A quarter of it belongs to a slope below 0.42, the
/// range of [`atan_excess`].
#[inline(always)]
fn angle_of<W: Wide>(sin: W, cos: W) -> W {
    let half = sin / ((cos * cos + sin * sin).sqrt() + cos).max(W::splat(SINE_MIN));
    let quarter = half / (W::splat(1.0) + (W::splat(1.0) + half * half).sqrt());
    (quarter + quarter * atan_excess(quarter * quarter)) * W::splat(4.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;
    use crate::base::wide::{Kernel, LANES, Simd};
    use crate::dim3::joint::angle_about;
    use crate::dim3::joint_axes::JointAxesMask;
    use crate::dim3::math::{DIM, Rotation, integrate_rotation};

    /// An angle tracker and its measured angles.
    struct Reading {
        angle_tracker: AngleTracker,
        between: WideRotation<Lane>,
        rotvec: WideVector<Lane>,
        direction: WideVector<Lane>,
        angle: Lane,
    }

    impl Kernel for &mut Reading {
        type Output = ();
        #[inline(always)]
        fn run<W: Wide>(self) {
            let between = WideRotation::<W>::load(&self.between);
            let rotvec = WideVector::load(&self.rotvec);
            let (direction, angle) = self.angle_tracker.measure(between, rotvec);
            direction.store(&mut self.direction);
            angle.store(&mut self.angle);
        }
    }

    fn vector(random: &mut Random, size: f64) -> Vector {
        Vector::from_array([0; DIM].map(|_| random.within(-size, size)))
    }

    /// Different kinds in one tracker measure the same as a direct computation, for any rotation of the
    /// bodies, also for half a turn. Single precision has a relative error of 1e-7, and derivatives are
    /// quotients of small numbers near the end of a swing.
    #[test]
    fn lanes_equal_single_measurements() {
        let mut random = Random(11);
        let (none, all) = (JointAxesMask::empty(), JointAxesMask::ANG_AXES);
        let kinds = [
            (JointAxis::AngX, none, JointAxesMask::ANG_X),
            (JointAxis::AngZ, none, JointAxesMask::ANG_Z),
            (JointAxis::AngX, none, all),
            (JointAxis::AngY, none, all),
            (JointAxis::AngZ, none, all),
            (JointAxis::AngX, none, JointAxesMask::ANG_X | JointAxesMask::ANG_Y),
            (JointAxis::AngZ, none, JointAxesMask::ANG_Y | JointAxesMask::ANG_Z),
            (JointAxis::AngY, JointAxesMask::ANG_Y | JointAxesMask::ANG_Z, all),
            (JointAxis::AngX, all, all),
        ];
        let pi = core::f64::consts::PI as Real;
        let ends = [0.0, 1.0e-12, 1.0e-8, 1.0e-4, 1.0e-3, 0.1].map(|before| pi - before);
        for round in 0..300 {
            let mut reading = Reading {
                angle_tracker: AngleTracker::NONE,
                between: WideRotation::IDENTITY,
                rotvec: WideVector::ZERO,
                direction: WideVector::ZERO,
                angle: Lane::ZERO,
            };
            let mut expected = [(0.0, Vector::ZERO); LANES];
            for (lane, expected) in expected.iter_mut().enumerate() {
                let (axis, coupled, free) = kinds[(round + lane) % kinds.len()];
                let rotations = FreeRotations::new(free, coupled);
                let start = match rotations.is_single() {
                    true => Rotation::from_axis_angle(axis_of(axis), random.within(-2.0, 2.0)),
                    false => integrate_rotation(Rotation::IDENTITY, vector(&mut random, 0.8)),
                };
                let (angle, _) = angle_about(axis, rotations, &start);
                reading.angle_tracker.set_lane(lane, axis, rotations, angle);
                let by = match rotations.is_single() {
                    true => axis_of(axis) * random.within(-1.0, 1.0),
                    false => vector(&mut random, 0.5),
                };
                let end = integrate_rotation(start, by);
                let end = match rotations.is_single() || axis == JointAxis::AngX {
                    false if round % 3 == 0 => {
                        let end = ends[random.below(ends.len())];
                        Rotation::from_axis_angle(Vector::new(0.0, 0.6, 0.8), end)
                    }
                    _ => end,
                };
                // A quaternion and its negative are the same rotation.
                let end = if random.below(2) == 0 { end } else { -end };
                reading.between.set_lane(lane, &end);
                reading.rotvec.set_lane(lane, by);
                *expected = angle_about(axis, rotations, &end);
            }
            Simd::detect().run(&mut reading);
            for (lane, (angle, direction)) in expected.into_iter().enumerate() {
                let found = reading.angle.0[lane];
                assert!((found - angle).abs() < 1.0e-5, "lane {lane}: {found}, not {angle}");
                let off = (reading.direction.lane(lane) - direction).length();
                assert!(off < 1.0e-4 * (1.0 + direction.length()), "lane {lane}: {direction}");
            }
        }
    }

    fn axis_of(axis: JointAxis) -> Vector {
        if axis == JointAxis::AngX { Vector::X } else { Vector::Z }
    }

    /// Turns are counted on from those that were counted before.
    #[test]
    fn turns_stay_counted() {
        let mut angle_tracker = AngleTracker::NONE;
        let rotations = FreeRotations::new(JointAxesMask::ANG_X, JointAxesMask::empty());
        angle_tracker.set_lane(0, JointAxis::AngX, rotations, 40.0);
        let mut between = WideRotation::IDENTITY;
        between.set_lane(0, &Rotation::from_axis_angle(Vector::X, 40.5));
        let (direction, angle) = (WideVector::ZERO, Lane::ZERO);
        let mut reading = Reading { angle_tracker, between, rotvec: direction, direction, angle };
        Simd::detect().run(&mut reading);
        assert!((reading.angle.0[0] - 40.5).abs() < 1.0e-5, "{}", reading.angle.0[0]);
    }

    /// Turns of one step are counted, too. The approximate rotation selects the number of turns, and the pose
    /// gives the rest. That does not apply to joints with several free rotations, which have no turns.
    #[test]
    fn turns_of_one_step_are_counted() {
        let mut random = Random(12);
        for (free, counts) in [(JointAxesMask::ANG_Z, true), (JointAxesMask::ANG_AXES, false)] {
            let rotations = FreeRotations::new(free, JointAxesMask::empty());
            let axis = if counts { JointAxis::AngZ } else { JointAxis::AngX };
            for by in [-40.0, -7.0, -3.2, -3.0, 3.1, 3.2, 5.0, 13.3, 100.0] {
                let start = random.within(-1.0, 1.0);
                let mut angle_tracker = AngleTracker::NONE;
                angle_tracker.set_lane(2, axis, rotations, start);
                let (mut between, mut rotvec) = (WideRotation::IDENTITY, WideVector::ZERO);
                between.set_lane(2, &Rotation::from_axis_angle(axis_of(axis), start + by));
                rotvec.set_lane(2, axis_of(axis) * (by + random.within(-2.0, 2.0)));
                let (direction, angle) = (WideVector::ZERO, Lane::ZERO);
                let mut reading = Reading { angle_tracker, between, rotvec, direction, angle };
                Simd::detect().run(&mut reading);
                let once = Real::sin(by).atan2(Real::cos(by));
                let expected = start + if counts { by } else { once };
                let found = reading.angle.0[2];
                assert!((found - expected).abs() < 2.0e-5, "{found}, not {expected}");
            }
        }
    }

    /// Without a finite rate the turns are unknown, and other lanes are unaffected.
    #[test]
    fn non_finite_angles_count_no_revolutions() {
        for no_number in [Real::NAN, Real::INFINITY, -Real::MAX] {
            let mut angle_tracker = AngleTracker::NONE;
            let rotations = FreeRotations::new(JointAxesMask::ANG_X, JointAxesMask::empty());
            angle_tracker.set_lane(0, JointAxis::AngX, rotations, 0.5);
            let mut rotvec = WideVector::ZERO;
            rotvec.set_lane(0, Vector::X * no_number);
            let (direction, angle) = (WideVector::ZERO, Lane::ZERO);
            let between = WideRotation::IDENTITY;
            let mut reading = Reading { angle_tracker, between, rotvec, direction, angle };
            Simd::detect().run(&mut reading);
            assert!(reading.angle.0.iter().all(|angle| angle.abs() < 1.0e-5), "{no_number}");
        }
    }
}
