//! The angles of a joint's free axes.

use crate::base::trig::atan2;
use crate::dim3::joint_axes::{JointAxesMask, JointAxis, twist};
use crate::dim3::math::{AngVector, Real, Rotation, SpatialVector, Vector, rotation_to_angle};

/// Which rotations of a joint are free, and which of these are measured together.
#[derive(Copy, Clone, Debug)]
pub(crate) struct FreeRotations {
    free: JointAxesMask,
    coupled: JointAxesMask,
}

impl FreeRotations {
    /// With these axes of a joint free, and these measured together.
    pub fn new(free: JointAxesMask, coupled: JointAxesMask) -> Self {
        Self { free, coupled }
    }

    /// Is this the only free one? Then its turns can be counted.
    pub fn is_single(&self) -> bool {
        (self.free & JointAxesMask::ANG_AXES).bits().count_ones() == 1
    }
}

/// The angle of a free axis of rotation (radians), and the direction, in the first frame, along which the
/// relative angular velocity changes it. `rotation` is the second frame's, seen from the first.
pub(crate) fn angle_about(
    axis: JointAxis,
    rotations: FreeRotations,
    rotation: &Rotation,
) -> (Real, AngVector) {
    let coupled = rotations.coupled & rotations.free & JointAxesMask::ANG_AXES;
    let own = JointAxesMask::from_bits_truncate(1 << axis as u8);
    let alone = JointAxesMask::ANG_AXES - coupled;
    match coupled.bits().count_ones() {
        3 => whole_angle(rotation),
        2 if coupled.contains(own) => swing_of(unit(alone), rotation),
        2 => twist_about(unit(own), rotation),
        _ if rotations.is_single() || axis == JointAxis::AngX => twist_about(unit(own), rotation),
        _ => swing_about(axis, rotation),
    }
}

/// The axis that is the only one in this set.
fn unit(mask: JointAxesMask) -> Vector {
    match mask {
        JointAxesMask::ANG_Y => Vector::Y,
        JointAxesMask::ANG_Z => Vector::Z,
        _ => Vector::X,
    }
}

fn whole_angle(rotation: &Rotation) -> (Real, AngVector) {
    let turn = rotation_to_angle(rotation);
    let angle = turn.length();
    (angle, if angle > 0.0 { turn / angle } else { AngVector::X })
}

/// The twist about `e`.
fn twist_about(e: Vector, rotation: &Rotation) -> (Real, AngVector) {
    let about = Vector::new(rotation.x, rotation.y, rotation.z).dot(e);
    let angle = twist(&Rotation::from_xyzw(about, 0.0, 0.0, rotation.w));
    let f = *rotation * e;
    let sum = 1.0 + e.dot(f);
    (angle, if sum > 1.0e-3 { (e + f) / sum } else { e })
}

/// How far `e` was swung, in any direction.
fn swing_of(e: Vector, rotation: &Rotation) -> (Real, AngVector) {
    let f = *rotation * e;
    let across = e.cross(f);
    let (sin, cos) = (across.length(), e.dot(f));
    (atan2(sin, cos), if sin > 0.0 { across / sin } else { e.any_orthonormal_vector() })
}

/// How far X was swung about another axis of the first frame.
fn swing_about(axis: JointAxis, rotation: &Rotation) -> (Real, AngVector) {
    let f = *rotation * Vector::X;
    let (sin, cos, sin_row) = match axis {
        JointAxis::AngY => (-f.z, f.x, Vector::Z.cross(f)),
        _ => (f.y, f.x, f.cross(Vector::Y)),
    };
    let cos_row = f.cross(Vector::X);
    let length_squared = sin * sin + cos * cos;
    if length_squared < 1.0e-6 {
        return (0.0, if axis == JointAxis::AngY { Vector::Y } else { Vector::Z });
    }
    (atan2(sin, cos), (sin_row * cos - cos_row * sin) / length_squared)
}

/// The angular part of a joint's impulses.
pub(crate) fn couple_of(impulses: &SpatialVector) -> AngVector {
    AngVector::new(impulses[3], impulses[4], impulses[5])
}

/// Sets the angular part of a joint's impulses.
pub(crate) fn set_couple(impulses: &mut SpatialVector, couple: AngVector) {
    impulses[3..].copy_from_slice(&couple.to_array());
}
