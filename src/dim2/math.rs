//! Vectors, rotations and poses in 2D, and the few formulas whose shape depends on the dimension.

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
pub const ANG_DIM: usize = 1;
/// Number of degrees of freedom of a free rigid body.
pub const SPATIAL_DIM: usize = 3;
/// A number per degree of freedom: the linear ones first.
pub type SpatialVector = [Real; SPATIAL_DIM];
/// Most points that one contact manifold carries.
pub const MAX_MANIFOLD_POINTS: usize = 2;

/// Velocity `ω × r` of a point at `r` from the axis of a rotation at `ω` (rad/s).
#[inline]
pub fn cross(w: AngVector, r: Vector) -> Vector {
    Vector::new(-w * r.y, w * r.x)
}

/// Moment `r × f` of a force applied at `r`.
#[inline]
pub fn torque(r: Vector, f: Vector) -> AngVector {
    r.x * f.y - r.y * f.x
}

/// The angular velocity or rotation that does nothing.
pub const ANG_ZERO: AngVector = 0.0;

/// Squared length of an angular vector.
#[inline]
pub fn ang_length_squared(w: AngVector) -> Real {
    w * w
}

/// Dot product of two angular vectors.
#[inline]
pub fn ang_dot(a: AngVector, b: AngVector) -> Real {
    a * b
}

/// Returns whether all components of the angular vector are finite.
#[inline]
pub fn ang_is_finite(w: AngVector) -> bool {
    w.is_finite()
}

/// The rotation by `angle` radians, counter-clockwise.
#[inline]
pub fn rotation_from_angle(angle: AngVector) -> Rotation {
    let (sine, cosine) = sin_cos(angle);
    Rotation::from_cos_sin_unchecked(cosine, sine)
}

/// The angle of a rotation (radians, in `-π..=π`).
#[inline]
pub fn rotation_to_angle(rotation: &Rotation) -> AngVector {
    atan2(rotation.im, rotation.re)
}

/// Largest square of a rotation angle (rad²). Larger ones are clamped, because the series loses all digits.
pub const ANGLE_SQUARED_MAX: Real = 1.0e4;

/// Rotates `rotation` by the angle `angle` (radians), by the series of [`turning`](crate::base::turning). The
/// error is zero at 1 rad, 10⁻⁵ rad at one revolution, and 0.003 at two.
#[inline]
pub fn integrate_rotation(rotation: Rotation, angle: AngVector) -> Rotation {
    let square = (angle * angle).min(ANGLE_SQUARED_MAX);
    let (cosine, sine) = cosine_and_sine::<3>(square);
    let sine = angle * sine;
    Rotation::from_cos_sin_unchecked(
        cosine * rotation.re - sine * rotation.im,
        cosine * rotation.im + sine * rotation.re,
    )
    .normalize()
}

/// The unit vector that completes the unit vector `n` to a basis: `n` turned by -90°.
#[inline]
pub fn tangents(n: Vector) -> [Vector; DIM - 1] {
    [Vector::new(n.y, -n.x)]
}

/// The angular velocity change `I⁻¹ τ` of an angular impulse `τ`.
#[inline]
pub fn mul_inertia(inv_inertia: &AngularInertia, torque: AngVector) -> AngVector {
    inv_inertia * torque
}

/// The inertia of which this is the inverse; zero if rotations are locked.
pub fn inertia_of(inv_inertia: &AngularInertia) -> AngularInertia {
    if *inv_inertia > 0.0 { 1.0 / *inv_inertia } else { zero_inertia() }
}

/// The inertia of a body that no torque can rotate.
#[inline]
pub fn zero_inertia() -> AngularInertia {
    0.0
}

/// Returns whether the rotation is finite and of unit length (within rounding).
#[inline]
pub fn rotation_is_valid(rotation: &Rotation) -> bool {
    rotation.is_finite() && (rotation.length_squared() - 1.0).abs() < 1.0e-2
}
