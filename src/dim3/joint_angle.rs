//! The angles of a joint's free axes.

use crate::base::trig::atan2;
use crate::dim3::joint_axes::{JointAxesMask, JointAxis, twist};
use crate::dim3::math::{AngVector, Real, Rotation, SpatialVector, Vector};

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
        Angle::Size(part) => {
            let HalfRotation { angle, axis, .. } = HalfRotation::of(part, rotation);
            (2.0 * angle, axis)
        }
        Angle::Component(part, k) => HalfRotation::of(part, rotation).component(k),
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

/// Half of the rotation vector of a part of a rotation: see the head of `joint/`.
struct HalfRotation {
    angle: Real,
    axis: AngVector,
    /// `a` of the derivative, and the multiple of the angle that is `ρ`.
    straight: Real,
    multiple: Real,
}

impl HalfRotation {
    fn of(part: Part, rotation: &Rotation) -> Self {
        let (e, v) = (part.swung(), Vector::new(rotation.x, rotation.y, rotation.z));
        let along = v.dot(e);
        let across = v - e * along;
        let (sin, cos) = (across.length(), (rotation.w * rotation.w + along * along).sqrt());
        let multiple = if matches!(part, Part::Whole) { 1.0 } else { 2.0 };
        if sin < SINE_MIN {
            return Self { angle: 0.0, axis: part.default_axis(), straight: 1.0, multiple };
        }
        let (c, s) = if cos < SINE_MIN { (1.0, 0.0) } else { (rotation.w / cos, along / cos) };
        let angle = atan2(sin, cos);
        let opposite = (multiple - 1.0) * sin / cos.max(COSINE_MIN);
        Self {
            angle,
            axis: (across * c + e.cross(across) * s) / sin,
            straight: angle * (cos / sin - opposite),
            multiple,
        }
    }

    /// The component about an axis, and its direction.
    fn component(self, k: Vector) -> (Real, AngVector) {
        let Self { angle, axis: n, straight, multiple } = self;
        let along = n.dot(k);
        let direction =
            k * straight + n * (along * (1.0 - straight)) + n.cross(k) * (angle * multiple);
        (2.0 * angle * along, direction)
    }
}

/// The angular part of a joint's impulses.
pub(crate) fn couple_of(impulses: &SpatialVector) -> AngVector {
    AngVector::new(impulses[3], impulses[4], impulses[5])
}

/// Sets the angular part of a joint's impulses.
pub(crate) fn set_couple(impulses: &mut SpatialVector, couple: AngVector) {
    impulses[3..].copy_from_slice(&couple.to_array());
}
