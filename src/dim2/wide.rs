//! Vectors, rotations and inertias of many bodies at a time, in 2D.
//!
//! Each type comes in two shapes. Filled with [`Lane`]s it is memory, a part of a constraint block, whose
//! lanes are filled one by one with `set_lane`. Filled with registers `W: Wide` it is the argument of
//! kernels. `load` and `store` go from one to the other.

use super::math::{AngVector, AngularInertia, Real, Rotation, Vector};
use crate::base::wide::{Lane, Wide, record_of_lanes, vector_of_lanes};
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

record_of_lanes!(WideVector of Vector { x, y });
vector_of_lanes!(WideVector of Vector { x, y });
record_of_lanes!(WideRotation of &Rotation { re, im });

impl WideVector<Lane> {
    /// The unit vector along the second axis in every lane.
    pub const Y: Self = Self { y: Lane::splat(1.0), ..Self::ZERO };
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
    pub const IDENTITY: Self = Self { re: Lane::splat(1.0), ..Self::ZERO };
}

impl<W: Wide> WideVector<W> {
    /// Its components, in their order.
    #[inline(always)]
    pub fn components(self) -> [W; 2] {
        [self.x, self.y]
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

/// `yes` in the lanes where the mask is set, `no` in the others.
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

    /// Squared displacement of the tip of a unit vector, approximately the squared angle.
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
