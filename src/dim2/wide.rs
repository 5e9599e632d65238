//! Vectors, rotations and inertias of many bodies at a time, in 2D.
//!
//! Each type comes in two shapes. Filled with [`Lane`]s it is memory, a part of a constraint block, whose
//! lanes are filled one by one with `set_lane`. Filled with registers `W: Wide` it is the argument of
//! kernels. `load` and `store` go from one to the other.

use super::math::{AngVector, AngularInertia, Real, Rotation, Vector};
use crate::base::wide::{Lane, Wide};
use core::ops::{Add, Mul, Neg, Sub};

/// A vector per lane.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[repr(C)]
pub struct WideVector<W> {
    pub x: W,
    pub y: W,
}

/// An angular velocity or a moment per lane.
pub type WideAngVector<W> = W;

/// A moment of inertia, or its inverse, per lane.
pub type WideSymmetric<W> = W;

/// A rotation per lane, as a unit complex number.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[repr(C)]
pub struct WideRotation<W> {
    pub re: W,
    pub im: W,
}

impl WideVector<Lane> {
    /// The zero vector in every lane.
    pub const ZERO: Self = Self { x: Lane::ZERO, y: Lane::ZERO };
    /// The unit vector along the second axis in every lane.
    pub const Y: Self = Self { y: Lane::splat(1.0), ..Self::ZERO };

    /// Sets the vector of one lane.
    pub fn set_lane(&mut self, lane: usize, value: Vector) {
        (self.x.0[lane], self.y.0[lane]) = (value.x, value.y);
    }

    /// The vector of one lane.
    pub fn lane(&self, lane: usize) -> Vector {
        Vector::new(self.x.0[lane], self.y.0[lane])
    }
}

/// Sets the angular vector of one lane.
pub fn set_ang_lane(target: &mut WideAngVector<Lane>, lane: usize, value: AngVector) {
    target.0[lane] = value;
}

/// The angular vector of one lane.
pub fn ang_lane(source: &WideAngVector<Lane>, lane: usize) -> AngVector {
    source.0[lane]
}

/// Sets the inertia of one lane.
pub fn set_symmetric_lane(target: &mut WideSymmetric<Lane>, lane: usize, value: &AngularInertia) {
    target.0[lane] = *value;
}

/// The inertia of one lane.
pub fn symmetric_lane(source: &WideSymmetric<Lane>, lane: usize) -> AngularInertia {
    source.0[lane]
}

/// No angular vector in any lane.
pub const ANG_ZERO_LANES: WideAngVector<Lane> = Lane::ZERO;
/// No inverse inertia in any lane.
pub const ZERO_INERTIA: WideSymmetric<Lane> = Lane::ZERO;

impl WideRotation<Lane> {
    /// No rotation in any lane.
    pub const IDENTITY: Self = Self { re: Lane::splat(1.0), im: Lane::ZERO };

    /// Sets the rotation of one lane.
    pub fn set_lane(&mut self, lane: usize, value: &Rotation) {
        (self.re.0[lane], self.im.0[lane]) = (value.re, value.im);
    }
}

impl<W: Wide> WideVector<W> {
    /// Reads a vector per lane from memory.
    #[inline(always)]
    pub fn load(from: &WideVector<Lane>) -> Self {
        Self { x: W::load(&from.x), y: W::load(&from.y) }
    }

    /// Its components, in their order.
    #[inline(always)]
    pub fn components(self) -> [W; 2] {
        [self.x, self.y]
    }

    /// Writes a vector per lane to memory.
    #[inline(always)]
    pub fn store(self, to: &mut WideVector<Lane>) {
        self.x.store(&mut to.x);
        self.y.store(&mut to.y);
    }

    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(value: Vector) -> Self {
        Self { x: W::splat(value.x), y: W::splat(value.y) }
    }

    /// The zero vector in every lane.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { x: W::zero(), y: W::zero() }
    }

    /// The dot product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> W {
        self.x * other.x + self.y * other.y
    }

    /// The product of each component with the same component of `other`.
    #[inline(always)]
    pub fn component_mul(self, other: Self) -> Self {
        Self { x: self.x * other.x, y: self.y * other.y }
    }

    /// The smaller of each component.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self { x: self.x.min(other.x), y: self.y.min(other.y) }
    }

    /// The larger of each component.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self { x: self.x.max(other.x), y: self.y.max(other.y) }
    }

    /// The vector, shortened to this length where it is longer, and one bit per lane where it is.
    #[inline(always)]
    pub fn clamped(self, length_max: Real) -> (Self, u32) {
        let square = self.dot(self);
        let is_longer = W::splat(length_max * length_max).lt(square);
        if !W::any(is_longer) {
            return (self, 0);
        }
        let shortened = self * (W::splat(length_max) / square.sqrt());
        (Self::select(is_longer, shortened, self), W::bits(is_longer))
    }

    /// Returns whether no component is larger than that of the other.
    #[inline(always)]
    pub fn all_le(self, other: Self) -> W::Mask {
        self.x.le(other.x) & self.y.le(other.y)
    }

    /// `yes` in the lanes where the mask says yes, `no` in the others.
    #[inline(always)]
    pub fn select(mask: W::Mask, yes: Self, no: Self) -> Self {
        Self { x: W::select(mask, yes.x, no.x), y: W::select(mask, yes.y, no.y) }
    }
}

impl<W: Wide> Add for WideVector<W> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<W: Wide> Sub for WideVector<W> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<W: Wide> Neg for WideVector<W> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl<W: Wide> Mul<W> for WideVector<W> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: W) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}

/// Velocity `ω × r` of a point at `r` from the axis of a rotation at `ω` (rad/s).
#[inline(always)]
pub fn cross<W: Wide>(w: WideAngVector<W>, r: WideVector<W>) -> WideVector<W> {
    WideVector { x: -(w * r.y), y: w * r.x }
}

/// Moment `r × f` of a force applied at `r`.
#[inline(always)]
pub fn torque<W: Wide>(r: WideVector<W>, f: WideVector<W>) -> WideAngVector<W> {
    r.x * f.y - r.y * f.x
}

/// Dot product of two angular vectors.
#[inline(always)]
pub fn ang_dot<W: Wide>(a: WideAngVector<W>, b: WideAngVector<W>) -> W {
    a * b
}

/// Reads an angular vector per lane from memory.
#[inline(always)]
pub fn load_ang<W: Wide>(from: &WideAngVector<Lane>) -> WideAngVector<W> {
    W::load(from)
}

/// Writes an angular vector per lane to memory.
#[inline(always)]
pub fn store_ang<W: Wide>(value: WideAngVector<W>, to: &mut WideAngVector<Lane>) {
    value.store(to);
}

/// `yes` in the lanes where the mask says yes, `no` in the others.
#[inline(always)]
pub fn select_ang<W: Wide>(
    mask: W::Mask,
    yes: WideAngVector<W>,
    no: WideAngVector<W>,
) -> WideAngVector<W> {
    W::select(mask, yes, no)
}

/// Reads an inertia per lane from memory.
#[inline(always)]
pub fn load_symmetric<W: Wide>(from: &WideSymmetric<Lane>) -> WideSymmetric<W> {
    W::load(from)
}

/// Writes a symmetric matrix per lane to memory.
#[inline(always)]
pub fn store_symmetric<W: Wide>(value: WideSymmetric<W>, to: &mut WideSymmetric<Lane>) {
    value.store(to);
}

/// The angular velocity change `I⁻¹ τ` of an angular impulse `τ`.
#[inline(always)]
pub fn mul_inertia<W: Wide>(m: WideSymmetric<W>, torque: WideAngVector<W>) -> WideAngVector<W> {
    m * torque
}

impl<W: Wide> WideRotation<W> {
    /// Reads a rotation per lane from memory.
    #[inline(always)]
    pub fn load(from: &WideRotation<Lane>) -> Self {
        Self { re: W::load(&from.re), im: W::load(&from.im) }
    }

    /// Turns a vector: the product of the complex numbers.
    #[inline(always)]
    pub fn rotate(self, v: WideVector<W>) -> WideVector<W> {
        WideVector { x: self.re * v.x - self.im * v.y, y: self.im * v.x + self.re * v.y }
    }

    /// This rotation after another one: the product of the complex numbers.
    #[inline(always)]
    pub fn times(self, first: Self) -> Self {
        let (p, q) = (self, first);
        Self { re: p.re * q.re - p.im * q.im, im: p.im * q.re + p.re * q.im }
    }

    /// The rotation that turns `earlier` into this one.
    #[inline(always)]
    pub fn since(self, earlier: Self) -> Self {
        Self {
            re: self.re * earlier.re + self.im * earlier.im,
            im: self.im * earlier.re - self.re * earlier.im,
        }
    }

    /// Square of how far it moves the tip of a unit vector: of the angle, nearly.
    #[inline(always)]
    pub fn chord_squared(self) -> W {
        let less = self.re - W::splat(1.0);
        less * less + self.im * self.im
    }

    /// Displacement of a vector's tip, to full precision for any size.
    #[inline(always)]
    pub fn displacement(self, v: WideVector<W>) -> WideVector<W> {
        // cos φ - 1 = -sin² φ / (1 + cos φ), except for half a turn, where the difference is exact.
        let one = W::splat(1.0);
        let small = W::zero().lt(self.re);
        let sum = W::select(small, one + self.re, one);
        let less = W::select(small, -(self.im * self.im / sum), self.re - one);
        WideVector { x: less * v.x - self.im * v.y, y: self.im * v.x + less * v.y }
    }
}

#[cfg(test)]
mod tests {
    use super::super::math;
    use super::{
        Lane, Rotation, Vector, Wide, WideAngVector, WideRotation, WideSymmetric, WideVector,
        ang_dot, ang_lane, cross, load_ang, load_symmetric, mul_inertia, set_ang_lane,
        set_symmetric_lane, store_ang, torque,
    };
    use crate::base::wide::{Kernel, LANES, Simd};
    use parry::math::Real;

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

    fn vector(lane: usize, phase: Real) -> Vector {
        let t = lane as Real + phase;
        Vector::new(t.sin(), (2.0 * t).cos())
    }

    fn inputs(lane: usize) -> (Vector, Vector, math::AngVector, math::AngularInertia, Rotation) {
        let (a, b) = (vector(lane, 0.3), vector(lane, 1.1));
        let angular = vector(lane, 2.3).x;
        let inertia = 1.0 + b.y;
        (a, b, angular, inertia, math::rotation_from_angle(angular))
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
    fn lanes_compute_what_single_bodies_do() {
        let mut probe = Probe::default();
        for lane in 0..LANES {
            let (a, b, w, inertia, rotation) = inputs(lane);
            probe.a.set_lane(lane, a);
            probe.b.set_lane(lane, b);
            set_ang_lane(&mut probe.w, lane, w);
            set_symmetric_lane(&mut probe.inertia, lane, &inertia);
            probe.rotation.set_lane(lane, &rotation);
        }
        Simd::detect().run(&mut probe);
        for lane in 0..LANES {
            let (a, b, w, inertia, rotation) = inputs(lane);
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
}
