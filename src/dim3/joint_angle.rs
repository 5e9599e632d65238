//! The angles of a joint's free axes.

use crate::base::trig::atan2;
use crate::dim3::joint_axes::{JointAxesMask, JointAxis, twist};
use crate::dim3::math::{AngVector, Real, Rotation, SpatialVector, Vector, rotation_to_angle};

/// Free rotations of a joint, and groups of them that are measured together.
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

    /// Returns whether this is the only free rotation. Then its turns can be counted.
    pub fn is_single(&self) -> bool {
        (self.free & JointAxesMask::ANG_AXES).bits().count_ones() == 1
    }
}

/// The definition of the angle of an axis: see the head of `joint/`.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Angle {
    /// The angle of the whole rotation.
    Whole,
    /// Twist of the second frame about this axis.
    Twist(Vector),
    /// Swing of this axis, in any direction.
    Swing(Vector),
    /// Swing of X towards this axis.
    Tilt(Vector),
}

impl Angle {
    /// The angle of an axis of a joint.
    pub(crate) fn of(axis: JointAxis, rotations: FreeRotations) -> Self {
        let coupled = rotations.coupled & rotations.free & JointAxesMask::ANG_AXES;
        let own = JointAxesMask::from_bits_truncate(1 << axis as u8);
        let alone = JointAxesMask::ANG_AXES - coupled;
        let is_twist = rotations.is_single() || axis == JointAxis::AngX;
        match coupled.bits().count_ones() {
            3 => Self::Whole,
            2 if coupled.contains(own) => Self::Swing(unit(alone)),
            2 => Self::Twist(unit(own)),
            _ if is_twist => Self::Twist(unit(own)),
            // A turn about Y leads X to -Z, one about Z to Y.
            _ if axis == JointAxis::AngY => Self::Tilt(-Vector::Z),
            _ => Self::Tilt(Vector::Y),
        }
    }
}

/// The angle of a free axis of rotation (radians), and the direction, in the first frame, along which the
/// relative angular velocity changes it. `rotation` is the second frame's, seen from the first.
pub(crate) fn angle_about(
    axis: JointAxis,
    rotations: FreeRotations,
    rotation: &Rotation,
) -> (Real, AngVector) {
    match Angle::of(axis, rotations) {
        Angle::Whole => whole_angle(rotation),
        Angle::Twist(e) => twist_about(e, rotation),
        Angle::Swing(e) => swing_of(e, rotation),
        Angle::Tilt(g) => tilt_towards(g, rotation),
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
    let rotvec = rotation_to_angle(rotation);
    let angle = rotvec.length();
    (angle, if angle > 0.0 { rotvec / angle } else { AngVector::X })
}

/// The twist about `e`.
fn twist_about(e: Vector, rotation: &Rotation) -> (Real, AngVector) {
    let about = Vector::new(rotation.x, rotation.y, rotation.z).dot(e);
    let angle = twist(&Rotation::from_xyzw(about, 0.0, 0.0, rotation.w));
    let f = *rotation * e;
    let sum = 1.0 + e.dot(f);
    (angle, if sum > 1.0e-3 { (e + f) / sum } else { e })
}

/// Swing of `e`, in any direction.
fn swing_of(e: Vector, rotation: &Rotation) -> (Real, AngVector) {
    let f = *rotation * e;
    let across = e.cross(f);
    let (sin, cos) = (across.length(), e.dot(f));
    (atan2(sin, cos), if sin > 0.0 { across / sin } else { e.any_orthonormal_vector() })
}

/// Swing of X towards `g`.
fn tilt_towards(g: Vector, rotation: &Rotation) -> (Real, AngVector) {
    let f = *rotation * Vector::X;
    let (sin, cos) = (f.dot(g), f.x);
    let length_squared = sin * sin + cos * cos;
    if length_squared < 1.0e-6 {
        return (0.0, Vector::X.cross(g));
    }
    (atan2(sin, cos), (f.cross(g) * cos - f.cross(Vector::X) * sin) / length_squared)
}

/// The angular part of a joint's impulses.
pub(crate) fn couple_of(impulses: &SpatialVector) -> AngVector {
    AngVector::new(impulses[3], impulses[4], impulses[5])
}

/// Sets the angular part of a joint's impulses.
pub(crate) fn set_couple(impulses: &mut SpatialVector, couple: AngVector) {
    impulses[3..].copy_from_slice(&couple.to_array());
}
