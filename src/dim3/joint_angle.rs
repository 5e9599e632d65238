//! The angles of a joint's free axes.

use crate::dim3::joint_axes::{JointAxesMask, JointAxis, twist};
use crate::dim3::math::{AngVector, Real, Rotation, SpatialVector, Vector, rotation_to_angle};

/// Least sine of half a rotation that has an axis.
pub(crate) const SINE_MIN: Real = 1.0e-12;
/// Least cosine of half a swing in derivatives: a swing of half a turn has an infinite one.
pub(crate) const COSINE_MIN: Real = 5.0e-4;

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
    /// The length of the rotation vector.
    Size(Part),
    /// The component of the rotation vector about this axis.
    Component(Part, Vector),
}

/// The part of a rotation whose rotation vector is measured.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Part {
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
            (3, _) => Self::Size(Part::Whole),
            (2, _) if coupled.contains(own) => Self::Size(Part::Swing(unit(alone))),
            (2, _) | (_, 1) => Self::Twist(unit(own)),
            (_, 2) => Self::Component(Part::Whole, unit(own)),
            _ if axis == JointAxis::AngX => Self::Twist(Vector::X),
            _ => Self::Component(Part::Swing(Vector::X), unit(own)),
        }
    }
}

impl Part {
    /// The axis that swings: zero for the whole rotation.
    pub(crate) fn swung(self) -> Vector {
        match self {
            Self::Whole => Vector::ZERO,
            Self::Swing(e) => e,
        }
    }

    /// The direction of a rotation vector without length.
    pub(crate) fn default_axis(self) -> AngVector {
        match self {
            Self::Whole => Vector::X,
            Self::Swing(e) => e.any_orthonormal_vector(),
        }
    }

    /// This part of a rotation: a swing is the rotation without the twist.
    fn of(self, rotation: &Rotation) -> Rotation {
        let Self::Swing(e) = self else { return *rotation };
        let twist = e * rotation.xyz().dot(e);
        let length = (rotation.w * rotation.w + twist.length_squared()).sqrt();
        if length < SINE_MIN {
            return *rotation;
        }
        *rotation * (Rotation::from_xyzw(-twist.x, -twist.y, -twist.z, rotation.w) * (1.0 / length))
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
        Angle::Size(part) => size_of(part, rotation),
        Angle::Component(part, k) => component_of(part, k, rotation),
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

fn size_of(part: Part, rotation: &Rotation) -> (Real, AngVector) {
    let rotvec = rotation_to_angle(&part.of(rotation));
    let angle = rotvec.length();
    (angle, if angle > 0.0 { rotvec / angle } else { part.default_axis() })
}

/// The component of a part about `k`.
fn component_of(part: Part, k: Vector, rotation: &Rotation) -> (Real, AngVector) {
    let turned = part.of(rotation);
    let rotvec = rotation_to_angle(&turned);
    let (sin, cos) = (turned.xyz().length(), turned.w.abs());
    if sin < SINE_MIN {
        return (0.0, k);
    }
    let half = 0.5 * rotvec.length();
    let n = rotvec / (2.0 * half);
    let (straight, around) = match part {
        Part::Whole => (half * cos / sin, half),
        Part::Swing(_) => (half * (cos / sin - sin / cos.max(COSINE_MIN)), 2.0 * half),
    };
    let direction = k * straight + n * (n.dot(k) * (1.0 - straight)) + n.cross(k) * around;
    (rotvec.dot(k), direction)
}

/// The angular part of a joint's impulses.
pub(crate) fn couple_of(impulses: &SpatialVector) -> AngVector {
    AngVector::new(impulses[3], impulses[4], impulses[5])
}

/// Sets the angular part of a joint's impulses.
pub(crate) fn set_couple(impulses: &mut SpatialVector, couple: AngVector) {
    impulses[3..].copy_from_slice(&couple.to_array());
}
