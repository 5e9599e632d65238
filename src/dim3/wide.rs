//! Vectors, rotations and inertias of many bodies at a time, in 3D.
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
    pub z: W,
}

/// An angular velocity, an axis, or a moment per lane.
pub type WideAngVector<W> = WideVector<W>;

/// A symmetric 3×3 matrix per lane, such as an inverse inertia in world space.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[repr(C)]
pub struct WideSymmetric<W> {
    pub m11: W,
    pub m12: W,
    pub m13: W,
    pub m22: W,
    pub m23: W,
    pub m33: W,
}

/// A rotation per lane, as a unit quaternion.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[repr(C)]
pub struct WideRotation<W> {
    pub x: W,
    pub y: W,
    pub z: W,
    pub w: W,
}

impl WideVector<Lane> {
    /// The zero vector in every lane.
    pub const ZERO: Self = Self { x: Lane::ZERO, y: Lane::ZERO, z: Lane::ZERO };
    /// The unit vector along the second axis in every lane.
    pub const Y: Self = Self { y: Lane::splat(1.0), ..Self::ZERO };

    /// Sets the vector of one lane.
    pub fn set_lane(&mut self, lane: usize, value: Vector) {
        (self.x.0[lane], self.y.0[lane], self.z.0[lane]) = (value.x, value.y, value.z);
    }

    /// The vector of one lane.
    pub fn lane(&self, lane: usize) -> Vector {
        Vector::new(self.x.0[lane], self.y.0[lane], self.z.0[lane])
    }
}

/// Sets the angular vector of one lane.
pub fn set_ang_lane(target: &mut WideAngVector<Lane>, lane: usize, value: AngVector) {
    target.set_lane(lane, value);
}

/// The angular vector of one lane.
pub fn ang_lane(source: &WideAngVector<Lane>, lane: usize) -> AngVector {
    source.lane(lane)
}

/// Sets the matrix of one lane.
pub fn set_symmetric_lane(target: &mut WideSymmetric<Lane>, lane: usize, value: &AngularInertia) {
    target.m11.0[lane] = value.m11;
    target.m12.0[lane] = value.m12;
    target.m13.0[lane] = value.m13;
    target.m22.0[lane] = value.m22;
    target.m23.0[lane] = value.m23;
    target.m33.0[lane] = value.m33;
}

/// The matrix of one lane.
pub fn symmetric_lane(source: &WideSymmetric<Lane>, lane: usize) -> AngularInertia {
    AngularInertia {
        m11: source.m11.0[lane],
        m12: source.m12.0[lane],
        m13: source.m13.0[lane],
        m22: source.m22.0[lane],
        m23: source.m23.0[lane],
        m33: source.m33.0[lane],
    }
}

/// No angular vector in any lane.
pub const ANG_ZERO_LANES: WideAngVector<Lane> = WideVector::ZERO;
/// No inverse inertia in any lane.
pub const ZERO_INERTIA: WideSymmetric<Lane> = {
    let zero = Lane::ZERO;
    WideSymmetric { m11: zero, m12: zero, m13: zero, m22: zero, m23: zero, m33: zero }
};

impl WideRotation<Lane> {
    /// No rotation in any lane.
    pub const IDENTITY: Self =
        Self { x: Lane::ZERO, y: Lane::ZERO, z: Lane::ZERO, w: Lane::splat(1.0) };

    /// Sets the rotation of one lane.
    pub fn set_lane(&mut self, lane: usize, value: &Rotation) {
        (self.x.0[lane], self.y.0[lane]) = (value.x, value.y);
        (self.z.0[lane], self.w.0[lane]) = (value.z, value.w);
    }
}

impl<W: Wide> WideVector<W> {
    /// Reads a vector per lane from memory.
    #[inline(always)]
    pub fn load(from: &WideVector<Lane>) -> Self {
        Self { x: W::load(&from.x), y: W::load(&from.y), z: W::load(&from.z) }
    }

    /// Its components, in their order.
    #[inline(always)]
    pub fn components(self) -> [W; 3] {
        [self.x, self.y, self.z]
    }

    /// Writes a vector per lane to memory.
    #[inline(always)]
    pub fn store(self, to: &mut WideVector<Lane>) {
        self.x.store(&mut to.x);
        self.y.store(&mut to.y);
        self.z.store(&mut to.z);
    }

    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(value: Vector) -> Self {
        Self { x: W::splat(value.x), y: W::splat(value.y), z: W::splat(value.z) }
    }

    /// The zero vector in every lane.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { x: W::zero(), y: W::zero(), z: W::zero() }
    }

    /// The dot product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> W {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The product of each component with the same component of `other`.
    #[inline(always)]
    pub fn component_mul(self, other: Self) -> Self {
        Self { x: self.x * other.x, y: self.y * other.y, z: self.z * other.z }
    }

    /// The smaller of each component.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self { x: self.x.min(other.x), y: self.y.min(other.y), z: self.z.min(other.z) }
    }

    /// The larger of each component.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self { x: self.x.max(other.x), y: self.y.max(other.y), z: self.z.max(other.z) }
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
        self.x.le(other.x) & self.y.le(other.y) & self.z.le(other.z)
    }

    /// `yes` in the lanes where the mask says yes, `no` in the others.
    #[inline(always)]
    pub fn select(mask: W::Mask, yes: Self, no: Self) -> Self {
        Self {
            x: W::select(mask, yes.x, no.x),
            y: W::select(mask, yes.y, no.y),
            z: W::select(mask, yes.z, no.z),
        }
    }
}

impl<W: Wide> Add for WideVector<W> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<W: Wide> Sub for WideVector<W> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl<W: Wide> Neg for WideVector<W> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}

impl<W: Wide> Mul<W> for WideVector<W> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: W) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}

/// Velocity `ω × r` of a point at `r` from the axis of a rotation at `ω` (rad/s).
#[inline(always)]
pub fn cross<W: Wide>(w: WideAngVector<W>, r: WideVector<W>) -> WideVector<W> {
    WideVector { x: w.y * r.z - w.z * r.y, y: w.z * r.x - w.x * r.z, z: w.x * r.y - w.y * r.x }
}

/// Moment `r × f` of a force applied at `r`.
#[inline(always)]
pub fn torque<W: Wide>(r: WideVector<W>, f: WideVector<W>) -> WideAngVector<W> {
    cross(r, f)
}

/// Dot product of two angular vectors.
#[inline(always)]
pub fn ang_dot<W: Wide>(a: WideAngVector<W>, b: WideAngVector<W>) -> W {
    a.dot(b)
}

/// Reads an angular vector per lane from memory.
#[inline(always)]
pub fn load_ang<W: Wide>(from: &WideAngVector<Lane>) -> WideAngVector<W> {
    WideVector::load(from)
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
    WideVector::select(mask, yes, no)
}

/// Reads a symmetric matrix per lane from memory.
#[inline(always)]
pub fn load_symmetric<W: Wide>(from: &WideSymmetric<Lane>) -> WideSymmetric<W> {
    WideSymmetric {
        m11: W::load(&from.m11),
        m12: W::load(&from.m12),
        m13: W::load(&from.m13),
        m22: W::load(&from.m22),
        m23: W::load(&from.m23),
        m33: W::load(&from.m33),
    }
}

/// Writes a symmetric matrix per lane to memory.
#[inline(always)]
pub fn store_symmetric<W: Wide>(value: WideSymmetric<W>, to: &mut WideSymmetric<Lane>) {
    value.m11.store(&mut to.m11);
    value.m12.store(&mut to.m12);
    value.m13.store(&mut to.m13);
    value.m22.store(&mut to.m22);
    value.m23.store(&mut to.m23);
    value.m33.store(&mut to.m33);
}

/// The angular velocity change `I⁻¹ τ` of an angular impulse `τ`.
#[inline(always)]
pub fn mul_inertia<W: Wide>(m: WideSymmetric<W>, torque: WideAngVector<W>) -> WideAngVector<W> {
    WideVector {
        x: m.m11 * torque.x + m.m12 * torque.y + m.m13 * torque.z,
        y: m.m12 * torque.x + m.m22 * torque.y + m.m23 * torque.z,
        z: m.m13 * torque.x + m.m23 * torque.y + m.m33 * torque.z,
    }
}

impl<W: Wide> WideRotation<W> {
    /// Reads a rotation per lane from memory.
    #[inline(always)]
    pub fn load(from: &WideRotation<Lane>) -> Self {
        Self { x: W::load(&from.x), y: W::load(&from.y), z: W::load(&from.z), w: W::load(&from.w) }
    }

    /// Turns a vector: `v + 2 u × (u × v + w v)` for the quaternion with vector part `u` and
    /// scalar part `w`.
    #[inline(always)]
    pub fn rotate(self, v: WideVector<W>) -> WideVector<W> {
        let u = WideVector { x: self.x, y: self.y, z: self.z };
        let half = cross(u, cross(u, v) + v * self.w);
        v + half + half
    }

    /// Turns a vector by a quaternion of any length.
    ///
    /// Normalised quaternions are off from unit length by some rounding. A rotation that takes them for
    /// units scales by their squared length.
    #[inline(always)]
    pub fn rotate_unscaled(self, v: WideVector<W>) -> WideVector<W> {
        let axis = WideVector { x: self.x, y: self.y, z: self.z };
        let length_squared = axis.dot(axis) + self.w * self.w;
        let t = cross(axis, v) * (W::splat(2.0) / length_squared);
        v + t * self.w + cross(axis, t)
    }

    /// This rotation after another one: `q p`.
    #[inline(always)]
    pub fn times(self, first: Self) -> Self {
        let (q, p) = (self, first);
        Self {
            x: q.w * p.x + q.x * p.w + q.y * p.z - q.z * p.y,
            y: q.w * p.y - q.x * p.z + q.y * p.w + q.z * p.x,
            z: q.w * p.z + q.x * p.y - q.y * p.x + q.z * p.w,
            w: q.w * p.w - q.x * p.x - q.y * p.y - q.z * p.z,
        }
    }

    /// The rotation back.
    #[inline(always)]
    pub fn conjugate(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z, w: self.w }
    }

    /// The rotation that turns `earlier` into this one: `q p*`.
    #[inline(always)]
    pub fn since(self, earlier: Self) -> Self {
        let (q, p) = (self, earlier);
        Self {
            x: q.x * p.w - q.w * p.x + q.z * p.y - q.y * p.z,
            y: q.y * p.w - q.w * p.y + q.x * p.z - q.z * p.x,
            z: q.z * p.w - q.w * p.z + q.y * p.x - q.x * p.y,
            w: q.w * p.w + q.x * p.x + q.y * p.y + q.z * p.z,
        }
    }

    /// Square of how far it moves the tip of a unit vector that is perpendicular to the axis: of the angle,
    /// nearly.
    #[inline(always)]
    pub fn chord_squared(self) -> W {
        W::splat(4.0) * (self.x * self.x + self.y * self.y + self.z * self.z)
    }

    /// Displacement of a vector's tip, to full precision for any size.
    #[inline(always)]
    pub fn displacement(self, v: WideVector<W>) -> WideVector<W> {
        let u = WideVector { x: self.x, y: self.y, z: self.z };
        let half = cross(u, cross(u, v) + v * self.w);
        half + half
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
        Vector::new(t.sin(), (2.0 * t).cos(), (3.0 * t).sin())
    }

    fn inputs(lane: usize) -> (Vector, Vector, math::AngVector, math::AngularInertia, Rotation) {
        let (a, b) = (vector(lane, 0.3), vector(lane, 1.1));
        let angular = vector(lane, 2.3);
        let inertia =
            math::AngularInertia { m11: a.x, m12: a.y, m13: a.z, m22: b.x, m23: b.y, m33: b.z };
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
