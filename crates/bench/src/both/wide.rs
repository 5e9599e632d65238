//! Conversions between this engine's numbers and those of its double precision.

use super::dim::{double_angular, double_mass, double_rotation, double_shape, rotation_back};
use super::double_engine as double;
use super::ours::parry::mass_properties::MassProperties;
use super::ours::prelude::*;
use crate::engine::Unsupported;
use double::parry::shape as wide;
use std::collections::HashMap;
use std::sync::Arc;

pub use super::dim::double_vector as vector;

/// Converts a number.
pub fn real(number: f32) -> f64 {
    number.into()
}

/// Converts an angular velocity.
pub fn angular(velocity: AngVector) -> double::math::AngVector {
    double_angular(velocity)
}

/// Converts a pose.
pub fn pose(pose: &Pose) -> double::math::Pose {
    double::math::Pose::from_parts(vector(pose.translation), double_rotation(&pose.rotation))
}

/// Converts a pose in double precision to one of this engine.
pub fn pose_back(pose: &double::math::Pose) -> Pose {
    Pose::from_parts(super::dim::vector_back(pose.translation), rotation_back(&pose.rotation))
}

/// Converts mass properties.
pub fn mass(mass: MassProperties) -> double::parry::mass_properties::MassProperties {
    double_mass(&mass)
}

/// Conversion of shapes. Shapes that several colliders share stay shared.
pub struct Shapes {
    /// Converted shapes, by the addresses of their originals.
    known: HashMap<usize, wide::SharedShape>,
}

impl Shapes {
    /// Creates the conversion for one world.
    pub fn new() -> Self {
        Self { known: HashMap::new() }
    }

    /// Returns the shape of a collider.
    pub fn shape(&mut self, shape: &SharedShape) -> Result<wide::SharedShape, Unsupported> {
        let address = Arc::as_ptr(&shape.0).cast::<u8>() as usize;
        if let Some(known) = self.known.get(&address) {
            return Ok(known.clone());
        }
        let rebuilt = self.rebuilt(shape)?;
        self.known.insert(address, rebuilt.clone());
        Ok(rebuilt)
    }

    fn rebuilt(&mut self, shape: &SharedShape) -> Result<wide::SharedShape, Unsupported> {
        let triangle = |t: &Triangle| wide::Triangle::new(vector(t.a), vector(t.b), vector(t.c));
        let cuboid = |c: &Cuboid| wide::Cuboid::new(vector(c.half_extents));
        Ok(match shape.as_typed_shape() {
            TypedShape::Ball(s) => wide::SharedShape::new(wide::Ball::new(real(s.radius))),
            TypedShape::Capsule(s) => {
                let [a, b] = [s.segment.a, s.segment.b].map(vector);
                wide::SharedShape::new(wide::Capsule::new(a, b, real(s.radius)))
            }
            TypedShape::Cuboid(s) => wide::SharedShape::new(cuboid(s)),
            TypedShape::RoundCuboid(s) => {
                let inner_shape = cuboid(&s.inner_shape);
                let border_radius = real(s.border_radius);
                wide::SharedShape::new(wide::RoundShape { inner_shape, border_radius })
            }
            TypedShape::Triangle(s) => wide::SharedShape::new(triangle(s)),
            TypedShape::HalfSpace(s) => {
                wide::SharedShape::new(wide::HalfSpace::new(vector(s.normal)))
            }
            TypedShape::TriMesh(s) => {
                let vertices = s.vertices().iter().map(|&v| vector(v)).collect();
                let flags = wide::TriMeshFlags::from_bits_truncate(s.flags().bits());
                let mesh = wide::TriMesh::with_flags(vertices, s.indices().to_vec(), flags);
                wide::SharedShape::new(mesh.map_err(|error| Unsupported(error.to_string()))?)
            }
            TypedShape::Compound(s) => {
                let parts = s.shapes().iter();
                let parts = parts.map(|(at, part)| Ok((pose(at), self.shape(part)?)));
                wide::SharedShape::new(wide::Compound::new(parts.collect::<Result<_, _>>()?))
            }
            other => double_shape(&other).ok_or_else(|| {
                let kind = shape.shape_type();
                Unsupported::because(format!("shape {kind:?} is not transcribed"))
            })?,
        })
    }
}
