//! Vectors, rotations and inertias of many bodies at a time, in 3D.
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

record_of_lanes!(WideVector of Vector { x, y, z });
vector_of_lanes!(WideVector of Vector { x, y, z });
record_of_lanes!(WideRotation of &Rotation { x, y, z, w });
record_of_lanes!(WideSymmetric of &AngularInertia { m11, m12, m13, m22, m23, m33 });

impl WideVector<Lane> {
    /// The unit vector along the second axis in every lane.
    pub const Y: Self = Self { y: Lane::splat(1.0), ..Self::ZERO };
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
    target.set_lane(lane, value);
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
pub const ZERO_INERTIA: WideSymmetric<Lane> = WideSymmetric::ZERO;

impl WideRotation<Lane> {
    /// No rotation in any lane.
    pub const IDENTITY: Self = Self { w: Lane::splat(1.0), ..Self::ZERO };
}

impl<W: Wide> WideVector<W> {
    /// Its components, in their order.
    #[inline(always)]
    pub fn components(self) -> [W; 3] {
        [self.x, self.y, self.z]
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

/// `yes` in the lanes where the mask is set, `no` in the others.
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
    WideSymmetric::load(from)
}

/// Writes a symmetric matrix per lane to memory.
#[inline(always)]
pub fn store_symmetric<W: Wide>(value: WideSymmetric<W>, to: &mut WideSymmetric<Lane>) {
    value.store(to);
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

    /// Squared displacement of the tip of a unit vector perpendicular to the axis, approximately the squared
    /// angle.
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
