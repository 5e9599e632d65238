//! The angles of a joint's free axes.

use crate::base::trig::atan2;
use crate::dim3::joint_axes::{JointAxesMask, JointAxis, twist};
use crate::dim3::math::{AngVector, Real, Rotation, SpatialVector, Vector};

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
        self.count() == 1
    }

    fn count(&self) -> u32 {
        (self.free & JointAxesMask::ANG_AXES).bits().count_ones()
    }
}

/// The definition of the angle of an axis: see the head of `joint/`.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Angle {
    /// Twist of the second frame about this axis.
    Twist(Vector),
    /// The size of a turn.
    Size(Turn),
    /// The component of a turn about this axis.
    Component(Turn, Vector),
}

/// A rotation whose rotation vector has the angles.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Turn {
    /// The whole rotation.
    Whole,
    /// The swing: the shortest rotation that leads this axis where the second body has taken it.
    Swing(Vector),
}

impl Angle {
    /// The angle of an axis of a joint.
    pub(crate) fn of(axis: JointAxis, rotations: FreeRotations) -> Self {
        let coupled = rotations.coupled & rotations.free & JointAxesMask::ANG_AXES;
        let own = JointAxesMask::from_bits_truncate(1 << axis as u8);
        let alone = JointAxesMask::ANG_AXES - coupled;
        match (coupled.bits().count_ones(), rotations.count()) {
            (3, _) => Self::Size(Turn::Whole),
            (2, _) if coupled.contains(own) => Self::Size(Turn::Swing(unit(alone))),
            (2, _) | (_, 1) => Self::Twist(unit(own)),
            (_, 2) => Self::Component(Turn::Whole, unit(own)),
            _ if axis == JointAxis::AngX => Self::Twist(Vector::X),
            _ => Self::Component(Turn::Swing(Vector::X), unit(own)),
        }
    }
}

impl Turn {
    /// The sine of the angle `ρ` times the axis, the cosine, and the size of the turn as a multiple of `ρ`.
    fn parts(self, rotation: &Rotation) -> (Vector, Real, Real) {
        match self {
            Self::Whole => {
                // A quaternion and its negative are the same rotation.
                let sign = if rotation.w < 0.0 { -1.0 } else { 1.0 };
                let v = Vector::new(rotation.x, rotation.y, rotation.z);
                (v * sign, rotation.w * sign, 2.0)
            }
            Self::Swing(e) => {
                let f = *rotation * e;
                (e.cross(f), e.dot(f), 1.0)
            }
        }
    }

    /// The direction of a turn that has none.
    pub(crate) fn default_axis(self) -> AngVector {
        match self {
            Self::Whole => Vector::X,
            Self::Swing(e) => e.any_orthonormal_vector(),
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
        Angle::Twist(e) => twist_about(e, rotation),
        Angle::Size(turn) => size_of(turn, rotation),
        Angle::Component(turn, e) => component_of(turn, e, rotation),
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

/// The twist about `e`.
fn twist_about(e: Vector, rotation: &Rotation) -> (Real, AngVector) {
    let about = Vector::new(rotation.x, rotation.y, rotation.z).dot(e);
    let angle = twist(&Rotation::from_xyzw(about, 0.0, 0.0, rotation.w));
    let f = *rotation * e;
    let sum = 1.0 + e.dot(f);
    (angle, if sum > 1.0e-3 { (e + f) / sum } else { e })
}

fn size_of(turn: Turn, rotation: &Rotation) -> (Real, AngVector) {
    let (across, cos, multiple) = turn.parts(rotation);
    let sin = across.length();
    (multiple * atan2(sin, cos), if sin > 0.0 { across / sin } else { turn.default_axis() })
}

/// The component of a turn about `e`.
fn component_of(turn: Turn, e: Vector, rotation: &Rotation) -> (Real, AngVector) {
    let (across, cos, multiple) = turn.parts(rotation);
    let sin = across.length();
    if sin <= 0.0 {
        return (0.0, e);
    }
    let (n, angle) = (across / sin, atan2(sin, cos));
    let along = n.dot(e);
    let straight = angle * cos / sin;
    let direction = e * straight + n * (along * (1.0 - straight)) + n.cross(e) * angle;
    (multiple * angle * along, direction)
}

/// The angular part of a joint's impulses.
pub(crate) fn couple_of(impulses: &SpatialVector) -> AngVector {
    AngVector::new(impulses[3], impulses[4], impulses[5])
}

/// Sets the angular part of a joint's impulses.
pub(crate) fn set_couple(impulses: &mut SpatialVector, couple: AngVector) {
    impulses[3..].copy_from_slice(&couple.to_array());
}
