//! Parts that depend on the dimension, in 3D: numbers and shapes in double precision, and positions in
//! growing worlds.

use super::double_engine as double;
use super::ours::parry::mass_properties::MassProperties;
use super::ours::parry::shape::TypedShape;
use super::ours::prelude::*;
use double::math as wide;
use double::parry::shape as shapes;

/// Converts a vector to double precision.
pub fn double_vector(v: Vector) -> wide::Vector {
    v.as_dvec3()
}

/// Converts a vector to single precision.
pub fn vector_back(v: wide::Vector) -> Vector {
    v.as_vec3()
}

/// Converts an angular velocity to double precision.
pub fn double_angular(velocity: AngVector) -> wide::AngVector {
    double_vector(velocity)
}

/// Converts a rotation to double precision, normalised to sixteen digits instead of seven.
pub fn double_rotation(rotation: &Rotation) -> wide::Rotation {
    rotation.as_dquat().normalize()
}

/// Converts a rotation to single precision.
pub fn rotation_back(rotation: &wide::Rotation) -> Rotation {
    rotation.as_quat()
}

/// Converts mass properties to double precision.
pub fn double_mass(mass: &MassProperties) -> double::parry::mass_properties::MassProperties {
    double::parry::mass_properties::MassProperties::with_principal_inertia_frame(
        double_vector(mass.local_com),
        mass.mass().into(),
        double_vector(mass.principal_inertia()),
        double_rotation(&mass.principal_inertia_local_frame),
    )
}

/// Converts a shape that exists in 3D only, or has other parts there.
pub fn double_shape(shape: &TypedShape<'_>) -> Option<shapes::SharedShape> {
    use double::prelude::ColliderBuilder as Builder;
    let builder = match shape {
        TypedShape::Cylinder(s) => Builder::cylinder(s.half_height.into(), s.radius.into()),
        TypedShape::Cone(s) => Builder::cone(s.half_height.into(), s.radius.into()),
        TypedShape::ConvexPolyhedron(s) => {
            let corners: Vec<_> = s.points().iter().map(|&p| double_vector(p)).collect();
            Builder::convex_hull(&corners)?
        }
        TypedShape::HeightField(s) => {
            let heights = s.heights();
            let (rows, columns) = (heights.nrows(), heights.ncols());
            let wide = heights.data().iter().map(|&height| f64::from(height)).collect();
            let heights = double::parry::utils::Array2::new(rows, columns, wide);
            Builder::heightfield(heights, double_vector(s.scale()))
        }
        _ => return None,
    };
    Some(builder.build().shared_shape().clone())
}

/// Returns a cube.
pub fn cube(half_extent: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_extent, half_extent, half_extent)
}

/// Returns a joint that holds a point.
pub fn pin(anchor1: Vector, anchor2: Vector) -> GenericJoint {
    let joint = SphericalJointBuilder::new().local_anchor1(anchor1).local_anchor2(anchor2);
    joint.contacts_enabled(false).into()
}

/// Returns a hinge.
pub fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new(Vector::Z)
}

/// Returns the middle of a cell in a square of `side` by `side` cells around the origin.
pub fn cell(index: usize, side: usize, spacing: Real) -> Vector {
    let middle = 0.5 * (side - 1) as Real;
    let [x, z] = [index % side, index / side].map(|n| spacing * (n as Real - middle));
    Vector::new(x, 0.0, z)
}

/// Adds a floor beneath all these cells, with its top at the height of their middles.
pub fn add_floors(world: &mut PhysicsWorld, side: usize, spacing: Real) {
    let half = 0.5 * spacing * (side + 1) as Real;
    let floor = RigidBodyBuilder::fixed().translation(-0.25 * Vector::Y);
    world.insert(floor, ColliderBuilder::cuboid(half, 0.25, half));
}

/// Returns the number of boxes in a layer of a heap with `side` boxes along its side.
pub fn layer_size(side: usize) -> usize {
    side * side
}

/// Returns the position of a box relative to the middle of its layer, in units of the distance between two
/// boxes.
pub fn place_in_layer(index: usize, side: usize) -> Vector {
    cell(index, side, 1.0)
}
