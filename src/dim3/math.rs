//! Vectors, rotations and poses in 3D, and the few formulas whose shape depends on the dimension.

use crate::base::trig::{atan2, sin_cos};
use crate::base::turning::cosine_and_sine;
pub use parry::math::{
    AngVector, AngularInertia, DIM, Int, Matrix, Orientation, Pose, Real, Rotation, Vector,
};

/// A position in space. The same type as [`Vector`].
pub type Point = Vector;
/// A rigid motion. The same type as [`Pose`].
pub type Isometry = Pose;
/// Number of rotational degrees of freedom.
pub const ANG_DIM: usize = 3;
/// Number of degrees of freedom of a free rigid body.
pub const SPATIAL_DIM: usize = 6;
/// A number per degree of freedom: the linear ones first.
pub type SpatialVector = [Real; SPATIAL_DIM];
/// Most points that one contact manifold carries.
pub const MAX_MANIFOLD_POINTS: usize = 4;

/// Velocity `ω × r` of a point at `r` from the axis of a rotation at `ω` (rad/s).
#[inline]
pub fn cross(w: AngVector, r: Vector) -> Vector {
    w.cross(r)
}

/// Moment `r × f` of a force applied at `r`.
#[inline]
pub fn torque(r: Vector, f: Vector) -> AngVector {
    r.cross(f)
}

/// The angular velocity or rotation that does nothing.
pub const ANG_ZERO: AngVector = AngVector::ZERO;

/// Squared length of an angular vector.
#[inline]
pub fn ang_length_squared(w: AngVector) -> Real {
    w.length_squared()
}

/// Dot product of two angular vectors.
#[inline]
pub fn ang_dot(a: AngVector, b: AngVector) -> Real {
    a.dot(b)
}

/// Returns whether all components of the angular vector are finite.
#[inline]
pub fn ang_is_finite(w: AngVector) -> bool {
    w.is_finite()
}

/// The rotation by `angle.length()` radians about the direction of `angle`.
#[inline]
pub fn rotation_from_angle(angle: AngVector) -> Rotation {
    let length = angle.length();
    if length == 0.0 {
        return Rotation::IDENTITY;
    }
    let (sine, cosine) = sin_cos(0.5 * length);
    let v = angle * (sine / length);
    Rotation::from_xyzw(v.x, v.y, v.z, cosine)
}

/// The rotation vector of a rotation (radians): at most half a turn.
#[inline]
pub fn rotation_to_angle(rotation: &Rotation) -> AngVector {
    // A quaternion and its negative are the same rotation; the one with w < 0 has the larger angle.
    let q = if rotation.w < 0.0 { -*rotation } else { *rotation };
    let v = Vector::new(q.x, q.y, q.z);
    let length = v.length();
    if length == 0.0 { v * 2.0 } else { v * (2.0 * atan2(length, q.w) / length) }
}

/// Largest square of a rotation angle (rad²). Larger ones are clamped, because the series loses all digits.
pub const ANGLE_SQUARED_MAX: Real = 1.0e4;

/// Rotates `rotation` by the world-space rotation vector `angle` (radians), by the series of
/// [`turning`](crate::base::turning). The error is zero at 1 rad, 10⁻⁵ rad at one revolution, and 0.003 at
/// two.
#[inline]
pub fn integrate_rotation(rotation: Rotation, angle: AngVector) -> Rotation {
    let square = angle.length_squared().min(ANGLE_SQUARED_MAX);
    // Cosine and sine of half the angle.
    let (cosine, sine) = cosine_and_sine::<2>(square);
    let (q, a) = (rotation, angle * sine);
    Rotation::from_xyzw(
        q.x * cosine + (a.x * q.w + a.y * q.z - a.z * q.y),
        q.y * cosine + (a.y * q.w + a.z * q.x - a.x * q.z),
        q.z * cosine + (a.z * q.w + a.x * q.y - a.y * q.x),
        q.w * cosine - (a.x * q.x + a.y * q.y + a.z * q.z),
    )
    .normalize()
}

/// Two unit vectors that complete the unit vector `n` to a right-handed basis `(t1, t2, n)`.
///
/// Duff et al. 2017, "Building an Orthonormal Basis, Revisited": no branch but the sign, no
/// cancellation near the pole.
#[inline]
pub fn tangents(n: Vector) -> [Vector; DIM - 1] {
    let sign = if n.z >= 0.0 { 1.0 } else { -1.0 };
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    [
        Vector::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x),
        Vector::new(b, sign + n.y * n.y * a, -n.y),
    ]
}

/// The angular velocity change `I⁻¹ τ` of an angular impulse `τ`.
#[inline]
pub fn mul_inertia(inv_inertia: &AngularInertia, torque: AngVector) -> AngVector {
    inv_inertia.mul_vec(torque)
}

/// The inertia of which this is the inverse; zero about locked axes.
pub fn inertia_of(inv_inertia: &AngularInertia) -> AngularInertia {
    // The determinant of the inverse itself might overflow.
    let scale = 1.0 / (inv_inertia.m11 + inv_inertia.m22 + inv_inertia.m33);
    let mut inverse = *inv_inertia * scale;
    let locked = [inverse.m11, inverse.m22, inverse.m33].map(|moment| moment <= 0.0);
    let set_locked = |inertia: &mut AngularInertia, moment: Real| {
        for (own, is_locked) in
            [&mut inertia.m11, &mut inertia.m22, &mut inertia.m33].into_iter().zip(locked)
        {
            *own = if is_locked { moment } else { *own };
        }
    };
    set_locked(&mut inverse, 1.0);
    let mut inertia = inverse.inverse_unchecked() * scale;
    set_locked(&mut inertia, 0.0);
    let is_valid = inertia.m11.is_finite() && inertia.m22.is_finite() && inertia.m33.is_finite();
    if is_valid { inertia } else { zero_inertia() }
}

/// The inertia of a body that no torque can rotate.
#[inline]
pub fn zero_inertia() -> AngularInertia {
    AngularInertia::zero()
}

/// Returns whether the rotation is finite and of unit length (within rounding).
#[inline]
pub fn rotation_is_valid(rotation: &Rotation) -> bool {
    rotation.is_finite() && (rotation.length_squared() - 1.0).abs() < 1.0e-2
}
