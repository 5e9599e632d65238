//! Parts that depend on the dimension, in 2D: numbers and shapes in double precision, and positions in
//! growing worlds.

use super::double_engine as double;
use super::ours::parry::mass_properties::MassProperties;
use super::ours::parry::shape::TypedShape;
use super::ours::prelude::*;
use double::math as wide;
use double::parry::shape as shapes;

/// Converts a vector to double precision.
pub fn double_vector(v: Vector) -> wide::Vector {
    v.as_dvec2()
}

/// Converts a vector to single precision.
pub fn vector_back(v: wide::Vector) -> Vector {
    v.as_vec2()
}

/// Converts an angular velocity to double precision.
pub fn double_angular(velocity: AngVector) -> wide::AngVector {
    velocity.into()
}

/// Converts a rotation to double precision, normalised to sixteen digits instead of seven.
pub fn double_rotation(rotation: &Rotation) -> wide::Rotation {
    wide::Rotation { re: rotation.re.into(), im: rotation.im.into() }.normalize()
}

/// Converts a rotation to single precision.
pub fn rotation_back(rotation: &wide::Rotation) -> Rotation {
    Rotation { re: rotation.re as Real, im: rotation.im as Real }
}

/// Converts mass properties to double precision.
pub fn double_mass(mass: &MassProperties) -> double::parry::mass_properties::MassProperties {
    double::parry::mass_properties::MassProperties::new(
        double_vector(mass.local_com),
        mass.mass().into(),
        mass.principal_inertia().into(),
    )
}

/// Converts a shape that exists in 2D only, or has other parts there.
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

/// Returns a square.
pub fn cube(half_extent: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_extent, half_extent)
}

/// Returns a joint that holds a point.
pub fn pin(anchor1: Vector, anchor2: Vector) -> GenericJoint {
    hinge().local_anchor1(anchor1).local_anchor2(anchor2).contacts_enabled(false).into()
}

/// Returns a hinge.
pub fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}

/// Returns the middle of a cell in a square of `side` by `side` cells around the origin.
pub fn cell(index: usize, side: usize, spacing: Real) -> Vector {
    let middle = 0.5 * (side - 1) as Real;
    let [x, y] = [index % side, index / side].map(|n| spacing * (n as Real - middle));
    Vector::new(x, y)
}

/// Adds a floor beneath each row of these cells, with its top at the height of their middles.
pub fn add_floors(world: &mut PhysicsWorld, side: usize, spacing: Real) {
    let half = 0.5 * spacing * (side + 1) as Real;
    for row in 0..side {
        let height = cell(row * side, side, spacing).y - 0.25;
        let floor = RigidBodyBuilder::fixed().translation(height * Vector::Y);
        world.insert(floor, ColliderBuilder::cuboid(half, 0.25));
    }
}

/// Returns the number of boxes in a layer of a heap with `side` boxes along its side.
pub fn layer_size(side: usize) -> usize {
    side
}

/// Returns the position of a box relative to the middle of its layer, in units of the distance between two
/// boxes.
pub fn place_in_layer(index: usize, side: usize) -> Vector {
    Vector::X * (index as Real - 0.5 * (side - 1) as Real)
}
