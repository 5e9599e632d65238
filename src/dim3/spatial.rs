//! Spatial vectors in 3D: linear and angular part in one list of six numbers, the linear ones first.
//!
//! Velocities, forces and accelerations of a link are such lists, in world axes, about the link's centre of
//! mass.

use super::axes::LockedAxes;
use super::joint_axes::JointAxesMask;
use super::math::{ANG_DIM, AngVector, Real, Rotation, SpatialVector, Vector};
use crate::base::trig::{atan2, sin_cos};
use parry::mass_properties::MassProperties;

/// The axes of rotation.
pub const ANG_AXES: [AngVector; ANG_DIM] = [AngVector::X, AngVector::Y, AngVector::Z];

/// Both parts in one.
#[inline]
pub fn join(linear: Vector, angular: AngVector) -> SpatialVector {
    [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
}

/// The linear part.
#[inline]
pub fn linear(s: &SpatialVector) -> Vector {
    Vector::new(s[0], s[1], s[2])
}

/// The angular part.
#[inline]
pub fn angular(s: &SpatialVector) -> AngVector {
    AngVector::new(s[3], s[4], s[5])
}

/// The components of an angular vector.
#[inline]
pub fn ang_components(a: AngVector) -> [Real; ANG_DIM] {
    a.to_array()
}

/// The components of a rotation: those of its unit quaternion, the scalar last.
#[inline]
pub fn rotation_components(rotation: &Rotation) -> [Real; 4] {
    rotation.to_array()
}

/// The rate of change of the direction `b` under the angular velocity `a` (rad/s).
#[inline]
pub fn ang_cross(a: AngVector, b: AngVector) -> AngVector {
    a.cross(b)
}

/// An axis of rotation as the rotation takes it along.
#[inline]
pub fn turn_axis(rotation: Rotation, axis: AngVector) -> AngVector {
    rotation * axis
}

/// The rotation by an angle (radians) about one of [`ANG_AXES`].
#[inline]
pub fn rotation_about(axis: usize, angle: Real) -> Rotation {
    let (sine, cosine) = sin_cos(0.5 * angle);
    let v = ANG_AXES[axis] * sine;
    Rotation::from_xyzw(v.x, v.y, v.z, cosine)
}

/// The twist (radians, at most half a turn) of a rotation about one of [`ANG_AXES`], after the swing of this
/// axis.
pub fn angle_about(axis: usize, rotation: Rotation) -> Real {
    let (along, w) = ([rotation.x, rotation.y, rotation.z][axis], rotation.w);
    let (along, w) = if w < 0.0 { (-along, -w) } else { (along, w) };
    2.0 * atan2(along, w)
}

/// The angles by which a rotation turns about the second axis and then about the first, if it does nothing
/// else.
pub fn angles_about([a, b]: [usize; 2], rotation: Rotation) -> [Real; 2] {
    let (a, b) = (ANG_AXES[a], ANG_AXES[b]);
    let c = a.cross(b);
    let (turned_b, turned_a) = (rotation * b, rotation.inverse() * a);
    [atan2(c.dot(turned_b), b.dot(turned_b)), atan2(c.dot(turned_a), a.dot(turned_a))]
}

/// The axes of the world along and about which a body can move, as those of a joint.
pub fn free_axes(locked: LockedAxes) -> JointAxesMask {
    JointAxesMask::from_bits_truncate(!locked.bits())
}

/// The angular inertia about the centre of mass in world axes, row after row.
pub fn world_inertia(mass: &MassProperties, rotation: Rotation) -> [[Real; ANG_DIM]; ANG_DIM] {
    let frame = rotation * mass.principal_inertia_local_frame;
    let moments = mass.principal_inertia();
    let axes = ANG_AXES.map(|axis| frame * axis);
    let mut inertia = [[0.0; ANG_DIM]; ANG_DIM];
    for (k, axis) in axes.iter().enumerate() {
        for row in 0..ANG_DIM {
            for column in 0..ANG_DIM {
                inertia[row][column] += moments[k] * axis[row] * axis[column];
            }
        }
    }
    inertia
}

/// By axis: the error if the rotation about it is locked, and its gradient. The gradient is the direction of
/// the relative angular velocity, in the first frame, that changes the error. `rotation` is the second
/// frame's, seen from the first. The gradients of joints between bodies, `locked_rotations`, do not vanish at
/// half a turn; these do. A loop of links that is off by half a turn is not closed.
pub fn locked_angles(rotation: Rotation) -> [(Real, AngVector); ANG_DIM] {
    let (x, y, z, w) = (rotation.x, rotation.y, rotation.z, rotation.w);
    [
        (2.0 * x, AngVector::new(w, z, -y)),
        (2.0 * y, AngVector::new(-z, w, x)),
        (2.0 * z, AngVector::new(y, -x, w)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_angles_are_found_again() {
        for [a, b] in [[0, 1], [0, 2], [1, 2]] {
            let rotation = rotation_about(a, 1.1) * rotation_about(b, -0.6);
            let [p, q] = angles_about([a, b], rotation);
            assert!((p - 1.1).abs() < 1.0e-5 && (q + 0.6).abs() < 1.0e-5, "{p} {q}");
        }
    }

    #[test]
    fn an_angle_is_found_again() {
        for axis in 0..3 {
            let angle = angle_about(axis, rotation_about(axis, -2.5));
            assert!((angle + 2.5).abs() < 1.0e-5, "{angle}");
        }
    }
}
