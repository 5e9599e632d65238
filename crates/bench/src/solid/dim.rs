//! What differs by dimension, in 3D: numbers and shapes in double precision, and where the worlds of growth put things.

use super::double_engine as double;
use super::ours::parry::mass_properties::MassProperties;
use super::ours::parry::shape::TypedShape;
use super::ours::prelude::*;
use double::math as wide;
use double::parry::shape as shapes;

/// A vector in double precision.
pub fn double_vector(v: Vector) -> wide::Vector {
    v.as_dvec3()
}

/// A vector in single precision.
pub fn vector_back(v: wide::Vector) -> Vector {
    v.as_vec3()
}

/// An angular velocity in double precision.
pub fn double_angular(velocity: AngVector) -> wide::AngVector {
    double_vector(velocity)
}

/// A rotation in double precision. What was of unit length to seven digits is so to sixteen.
pub fn double_rotation(rotation: &Rotation) -> wide::Rotation {
    rotation.as_dquat().normalize()
}

/// A rotation in single precision.
pub fn rotation_back(rotation: &wide::Rotation) -> Rotation {
    rotation.as_quat()
}

/// Mass properties in double precision.
pub fn double_mass(mass: &MassProperties) -> double::parry::mass_properties::MassProperties {
    double::parry::mass_properties::MassProperties::with_principal_inertia_frame(
        double_vector(mass.local_com),
        mass.mass().into(),
        double_vector(mass.principal_inertia()),
        double_rotation(&mass.principal_inertia_local_frame),
    )
}

/// A shape that there is in 3D alone, or that is made of something else there.
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

/// A cube.
pub fn cube(half_extent: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_extent, half_extent, half_extent)
}

/// The middle of a cell in a square of so many by so many around the origin.
pub fn cell(index: usize, side: usize, spacing: Real) -> Vector {
    let middle = 0.5 * (side - 1) as Real;
    let [x, z] = [index % side, index / side].map(|n| spacing * (n as Real - middle));
    Vector::new(x, 0.0, z)
}

/// A floor beneath all these cells, with its top where their middles are.
pub fn add_floors(world: &mut PhysicsWorld, side: usize, spacing: Real) {
    let half = 0.5 * spacing * (side + 1) as Real;
    let floor = RigidBodyBuilder::fixed().translation(-0.25 * Vector::Y);
    world.insert(floor, ColliderBuilder::cuboid(half, 0.25, half));
}

/// How many boxes a layer of a heap has, so many along its side.
pub fn layer_size(side: usize) -> usize {
    side * side
}

/// Where a box of a layer is, seen from its middle, in units of the distance between two boxes.
pub fn place_in_layer(index: usize, side: usize) -> Vector {
    cell(index, side, 1.0)
}
