//! The second dimension: vectors, poses, and constructors whose parameters depend on the dimension.
//!
//! A body moves in the plane of x and y of its `Transform`. Its z coordinate belongs to the user.

use crate::collider::Collider;
use crate::joint::Joint;
use crate::precision::{Precision, Scalar};
use crate::scale::{by_parry, rounded};
use bevy::ecs::entity::Entity;
use bevy::math::{Quat, Vec3};
use bevy::transform::components::Transform;
use rapier::math as engine;
use rapier::parry::shape::{ConvexPolygon, TypedShape};
use rapier::prelude::{ColliderBuilder, InvalidCollider, PinSlotJoint, RevoluteJoint, SharedShape};

/// A vector: `Vec2`, or `DVec2` with the feature `f64`.
pub type Vector = <Scalar as Precision>::Vec2;
/// An angle (radians), an angular velocity or a torque.
pub type AngVector = Scalar;

/// The angular velocity of a body without rotation.
pub(crate) const ANG_ZERO: AngVector = 0.0;

/// The engine's vector.
pub(crate) fn to_engine(vector: Vector) -> engine::Vector {
    engine::Vector::from_array(vector.to_array())
}

/// Bevy's vector.
pub(crate) fn to_bevy(vector: engine::Vector) -> Vector {
    Vector::from_array(vector.to_array())
}

/// The engine's angular velocity.
pub(crate) fn ang_to_engine(angle: AngVector) -> engine::AngVector {
    angle
}

/// Bevy's angular velocity.
pub(crate) fn ang_to_bevy(angle: engine::AngVector) -> AngVector {
    angle
}

/// A vector of a `Transform` in the engine's precision.
pub(crate) fn from_transform(vector: Vec3) -> engine::Vector {
    engine::Vector::new(Scalar::from(vector.x), Scalar::from(vector.y))
}

/// The pose of a transform; its scale is left out, and so are rotations that leave the plane.
pub(crate) fn pose_of(transform: &Transform) -> engine::Pose {
    let [z, w] = [transform.rotation.z, transform.rotation.w].map(Scalar::from);
    // The double angle of the quaternion (z, w), without trigonometry: equal bits on all machines.
    let (cosine, sine) = (w * w - z * z, 2.0 * z * w);
    let length = (cosine * cosine + sine * sine).sqrt();
    let mut pose = engine::Pose::IDENTITY;
    pose.translation = from_transform(transform.translation);
    if length > 0.0 {
        pose.rotation = engine::Rotation { re: cosine / length, im: sine / length };
    }
    pose
}

/// Writes a pose to a transform; its scale and its z coordinate stay.
pub(crate) fn write_pose(pose: &engine::Pose, transform: &mut Transform) {
    transform.translation.x = pose.translation.x as f32;
    transform.translation.y = pose.translation.y as f32;
    let (cosine, sine) = (pose.rotation.cos(), pose.rotation.sin());
    // Half of the angle: the larger of the two components is the root, the other follows from it.
    let (z, w) = if cosine >= 0.0 {
        let w = (0.5 * (1.0 + cosine)).sqrt();
        (0.5 * sine / w, w)
    } else {
        let z = (0.5 * (1.0 - cosine)).sqrt().copysign(sine);
        (z, 0.5 * sine / z)
    };
    transform.rotation = Quat::from_xyzw(0.0, 0.0, z as f32, w as f32);
}

/// Returns whether two transforms have equal translations in the plane.
pub(crate) fn has_translation_of(transform: &Transform, other: &Transform) -> bool {
    transform.translation.truncate() == other.translation.truncate()
}

/// Copies the translation in the plane; the z coordinate stays.
pub(crate) fn set_translation(transform: &mut Transform, translation: Vec3) {
    transform.translation = translation.with_z(transform.translation.z);
}

/// The rotation in a space that `scale` mirrors.
pub(crate) fn mirrored_rotation(
    rotation: engine::Rotation,
    scale: engine::Vector,
) -> engine::Rotation {
    if scale.x * scale.y < 0.0 { rotation.inverse() } else { rotation }
}

/// The points of a convex shape that consists of points.
pub(crate) fn convex_points(shape: &SharedShape) -> Option<&[engine::Vector]> {
    shape.as_convex_polygon().map(ConvexPolygon::points)
}

/// The inner shape and the border, for the shapes of this dimension.
pub(crate) fn without_border(shape: TypedShape<'_>) -> Option<(SharedShape, Scalar)> {
    match shape {
        TypedShape::RoundConvexPolygon(round) => {
            Some((SharedShape::new(round.inner_shape.clone()), round.border_radius))
        }
        _ => None,
    }
}

/// A shape of this dimension with a border.
pub(crate) fn with_border(inner: TypedShape<'_>, border_radius: Scalar) -> Option<SharedShape> {
    match inner {
        TypedShape::ConvexPolygon(polygon) => Some(rounded(polygon.clone(), border_radius)),
        _ => None,
    }
}

/// Scales a shape of which only one dimension has a mirrored form.
pub(crate) fn scaled(
    shape: &SharedShape,
    scale: engine::Vector,
) -> Result<SharedShape, InvalidCollider> {
    by_parry(shape, scale)
}

/// A point of the engine in the space of gizmos.
#[cfg(feature = "debug-lines")]
pub(crate) fn to_gizmo(point: engine::Vector) -> Vec3 {
    Vec3::new(point.x as f32, point.y as f32, 0.0)
}

/// Shapes of two dimensions.
impl Collider {
    /// A rectangle around the origin, from its half extents.
    pub fn cuboid(hx: Scalar, hy: Scalar) -> Self {
        ColliderBuilder::cuboid(hx, hy).into()
    }

    /// A rectangle, enlarged and rounded by `border_radius` on all sides.
    pub fn round_cuboid(hx: Scalar, hy: Scalar, border_radius: Scalar) -> Self {
        ColliderBuilder::round_cuboid(hx, hy, border_radius).into()
    }

    /// A line over the x axis, from its heights at equal distances. `scale` holds its length and the factor
    /// of the heights.
    pub fn heightfield(heights: &[Scalar], scale: Vector) -> Self {
        ColliderBuilder::heightfield(heights.to_vec(), to_engine(scale)).into()
    }
}

/// Joints of two dimensions.
impl Joint {
    /// A hinge.
    pub fn revolute(body1: Entity, body2: Entity) -> Self {
        Self::generic(body1, body2, RevoluteJoint::new())
    }

    /// A pin in a slot: translation along an axis, and rotation.
    pub fn pin_slot(body1: Entity, body2: Entity, axis: Vector) -> Self {
        Self::generic(body1, body2, PinSlotJoint::new(to_engine(axis)))
    }
}
