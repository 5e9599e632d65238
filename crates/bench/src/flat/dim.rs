//! What differs by dimension, in 2D: numbers and shapes in double precision, and where the worlds of growth put things.

use super::double_engine as double;
use super::ours::parry::mass_properties::MassProperties;
use super::ours::parry::shape::TypedShape;
use super::ours::prelude::*;
use double::math as wide;
use double::parry::shape as shapes;

/// A vector in double precision.
pub fn double_vector(v: Vector) -> wide::Vector {
    v.as_dvec2()
}

/// A vector in single precision.
pub fn vector_back(v: wide::Vector) -> Vector {
    v.as_vec2()
}

/// An angular velocity in double precision.
pub fn double_angular(velocity: AngVector) -> wide::AngVector {
    velocity.into()
}

/// A rotation in double precision. What was of unit length to seven digits is so to sixteen.
pub fn double_rotation(rotation: &Rotation) -> wide::Rotation {
    wide::Rotation { re: rotation.re.into(), im: rotation.im.into() }.normalize()
}

/// A rotation in single precision.
pub fn rotation_back(rotation: &wide::Rotation) -> Rotation {
    Rotation { re: rotation.re as Real, im: rotation.im as Real }
}

/// Mass properties in double precision.
pub fn double_mass(mass: &MassProperties) -> double::parry::mass_properties::MassProperties {
    double::parry::mass_properties::MassProperties::new(
        double_vector(mass.local_com),
        mass.mass().into(),
        mass.principal_inertia().into(),
    )
}

/// A shape that there is in 2D alone, or that is made of something else there.
pub fn double_shape(shape: &TypedShape<'_>) -> Option<shapes::SharedShape> {
    use double::prelude::ColliderBuilder as Builder;
    let builder = match shape {
        TypedShape::ConvexPolygon(s) => {
            let corners: Vec<_> = s.points().iter().map(|&p| double_vector(p)).collect();
            Builder::convex_hull(&corners)?
        }
        TypedShape::HeightField(s) => {
            let heights = s.heights().iter().map(|&height| f64::from(height)).collect();
            Builder::heightfield(heights, double_vector(s.scale()))
        }
        _ => return None,
    };
    Some(builder.build().shared_shape().clone())
}

/// A square.
pub fn cube(half_extent: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_extent, half_extent)
}

/// The middle of a cell in a square of so many by so many around the origin.
pub fn cell(index: usize, side: usize, spacing: Real) -> Vector {
    let middle = 0.5 * (side - 1) as Real;
    let [x, y] = [index % side, index / side].map(|n| spacing * (n as Real - middle));
    Vector::new(x, y)
}

/// A floor beneath each row of these cells, with its top where their middles are.
pub fn add_floors(world: &mut PhysicsWorld, side: usize, spacing: Real) {
    let half = 0.5 * spacing * (side + 1) as Real;
    for row in 0..side {
        let height = cell(row * side, side, spacing).y - 0.25;
        let floor = RigidBodyBuilder::fixed().translation(height * Vector::Y);
        world.insert(floor, ColliderBuilder::cuboid(half, 0.25));
    }
}

/// How many boxes a layer of a heap has, so many along its side.
pub fn layer_size(side: usize) -> usize {
    side
}

/// Where a box of a layer is, seen from its middle, in units of the distance between two boxes.
pub fn place_in_layer(index: usize, side: usize) -> Vector {
    Vector::X * (index as Real - 0.5 * (side - 1) as Real)
}
