//! The third dimension: vectors, poses, and constructors whose parameters depend on the dimension.

use crate::collider::Collider;
use crate::joint::Joint;
use crate::precision::{Precision, Scalar};
use crate::scale::{by_parry, hull, rounded};
use bevy::ecs::entity::Entity;
use bevy::math::{Quat, Vec3};
use bevy::transform::components::Transform;
use rapier::math as engine;
use rapier::parry::shape::{ConvexPolyhedron, TypedShape};
use rapier::parry::utils::Array2;
use rapier::prelude::{
    ColliderBuilder, GenericJoint, HeightFieldFlags, InvalidCollider, RevoluteJoint, SharedShape,
    SphericalJoint,
};

/// A vector: `Vec3`, or `DVec3` with the feature `f64`.
pub type Vector = <Scalar as Precision>::Vec3;
/// A rotation vector, an angular velocity or a torque: `Vec3`, or `DVec3` with the feature `f64`.
pub type AngVector = Vector;

/// The angular velocity of a body without rotation.
pub(crate) const ANG_ZERO: AngVector = AngVector::ZERO;

/// The engine's vector.
pub(crate) fn to_engine(vector: Vector) -> engine::Vector {
    engine::Vector::from_array(vector.to_array())
}

/// Bevy's vector.
pub(crate) fn to_bevy(vector: engine::Vector) -> Vector {
    Vector::from_array(vector.to_array())
}

/// The engine's angular vector.
pub(crate) fn ang_to_engine(vector: AngVector) -> engine::AngVector {
    to_engine(vector)
}

/// Bevy's angular vector.
pub(crate) fn ang_to_bevy(vector: engine::AngVector) -> AngVector {
    to_bevy(vector)
}

/// A vector of a `Transform` in the engine's precision.
pub(crate) fn from_transform(vector: Vec3) -> engine::Vector {
    engine::Vector::from_array(vector.to_array().map(Scalar::from))
}

/// The pose of a transform; its scale is left out.
pub(crate) fn pose_of(transform: &Transform) -> engine::Pose {
    let [x, y, z, w] = transform.rotation.to_array().map(Scalar::from);
    engine::Pose::from_parts(
        from_transform(transform.translation),
        engine::Rotation::from_xyzw(x, y, z, w),
    )
}

/// Writes a pose to a transform; its scale stays.
pub(crate) fn write_pose(pose: &engine::Pose, transform: &mut Transform) {
    transform.translation = Vec3::from_array(pose.translation.to_array().map(|x| x as f32));
    transform.rotation = Quat::from_array(pose.rotation.to_array().map(|x| x as f32));
}

/// Returns whether two transforms have equal translations.
pub(crate) fn has_translation_of(transform: &Transform, other: &Transform) -> bool {
    transform.translation == other.translation
}

/// Copies the translation.
pub(crate) fn set_translation(transform: &mut Transform, translation: Vec3) {
    transform.translation = translation;
}

/// The rotation in a space that `scale` mirrors.
pub(crate) fn mirrored_rotation(
    rotation: engine::Rotation,
    scale: engine::Vector,
) -> engine::Rotation {
    let signs = scale.signum();
    let [x, y, z] = (signs * (signs.x * signs.y * signs.z)).to_array();
    engine::Rotation::from_xyzw(rotation.x * x, rotation.y * y, rotation.z * z, rotation.w)
}

/// The points of a convex shape that consists of points.
pub(crate) fn convex_points(shape: &SharedShape) -> Option<&[engine::Vector]> {
    shape.as_convex_polyhedron().map(ConvexPolyhedron::points)
}

/// The inner shape and the border, for the shapes of this dimension.
pub(crate) fn without_border(shape: TypedShape<'_>) -> Option<(SharedShape, Scalar)> {
    match shape {
        TypedShape::RoundConvexPolyhedron(round) => {
            Some((SharedShape::new(round.inner_shape.clone()), round.border_radius))
        }
        TypedShape::RoundCylinder(round) => {
            Some((SharedShape::new(round.inner_shape), round.border_radius))
        }
        TypedShape::RoundCone(round) => {
            Some((SharedShape::new(round.inner_shape), round.border_radius))
        }
        _ => None,
    }
}

/// A shape of this dimension with a border.
pub(crate) fn with_border(inner: TypedShape<'_>, border_radius: Scalar) -> Option<SharedShape> {
    match inner {
        TypedShape::ConvexPolyhedron(hull) => Some(rounded(hull.clone(), border_radius)),
        TypedShape::Cylinder(cylinder) => Some(rounded(*cylinder, border_radius)),
        TypedShape::Cone(cone) => Some(rounded(*cone, border_radius)),
        _ => None,
    }
}

/// Number of segments of the base of a cone whose tip points down. Its mass is 0.6 % too small.
const CONE_SEGMENTS: u32 = 32;

/// Scales a shape of which only one dimension has a mirrored form.
pub(crate) fn scaled(
    shape: &SharedShape,
    scale: engine::Vector,
) -> Result<SharedShape, InvalidCollider> {
    match shape.as_typed_shape() {
        TypedShape::Cylinder(_) => by_parry(shape, scale.abs()),
        // A cone is symmetric about its axis. Its tip points down under a negative factor of y.
        TypedShape::Cone(_) if scale.y > 0.0 => by_parry(shape, scale.abs()),
        TypedShape::Cone(cone) => hull(&cone.to_trimesh(CONE_SEGMENTS).0, scale),
        _ => by_parry(shape, scale),
    }
}

/// A point of the engine in the space of gizmos.
#[cfg(feature = "debug-lines")]
pub(crate) fn to_gizmo(point: engine::Vector) -> Vec3 {
    Vec3::from_array(point.to_array().map(|x| x as f32))
}

/// Shapes of three dimensions.
impl Collider {
    /// A box around the origin, from its half extents.
    pub fn cuboid(hx: Scalar, hy: Scalar, hz: Scalar) -> Self {
        ColliderBuilder::cuboid(hx, hy, hz).into()
    }

    /// A box, enlarged and rounded by `border_radius` on all sides.
    pub fn round_cuboid(hx: Scalar, hy: Scalar, hz: Scalar, border_radius: Scalar) -> Self {
        ColliderBuilder::round_cuboid(hx, hy, hz, border_radius).into()
    }

    /// A capsule along the z axis.
    pub fn capsule_z(half_height: Scalar, radius: Scalar) -> Self {
        ColliderBuilder::capsule_z(half_height, radius).into()
    }

    /// A cylinder around the y axis.
    pub fn cylinder(half_height: Scalar, radius: Scalar) -> Self {
        ColliderBuilder::cylinder(half_height, radius).into()
    }

    /// A cone around the y axis with its tip up.
    pub fn cone(half_height: Scalar, radius: Scalar) -> Self {
        ColliderBuilder::cone(half_height, radius).into()
    }

    /// A surface over a rectangle of the x-z plane, from `rows` × `columns` heights in row order: rows along
    /// z, columns along x. `scale` holds the sides of the rectangle and the factor of the heights.
    pub fn heightfield(heights: &[Scalar], rows: usize, columns: usize, scale: Vector) -> Self {
        let height = |row: usize, column: usize| {
            heights.get(row * columns + column).copied().unwrap_or(Scalar::NAN)
        };
        let heights = Array2::from_fn(rows, columns, height);
        let flags = HeightFieldFlags::FIX_INTERNAL_EDGES;
        ColliderBuilder::heightfield_with_flags(heights, to_engine(scale), flags).into()
    }
}

/// Joints of three dimensions.
impl Joint {
    /// A hinge about an axis, in the local space of both bodies.
    pub fn revolute(body1: Entity, body2: Entity, axis: Vector) -> Self {
        Self::generic(body1, body2, RevoluteJoint::new(to_engine(axis)))
    }

    /// A ball-and-socket joint.
    pub fn spherical(body1: Entity, body2: Entity) -> Self {
        Self::generic(body1, body2, GenericJoint::from(SphericalJoint::new()))
    }
}
