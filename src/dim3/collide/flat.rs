//! What surfaces are made of: triangles.

use super::polytope::Polytope;
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::{Shape, Triangle};

/// A flat shape.
pub type FlatShape = Triangle;

/// The flat shape that a shape is, if it is one.
pub fn as_flat(shape: &dyn Shape) -> Option<&FlatShape> {
    shape.as_triangle()
}

/// The corners of a flat shape.
pub fn flat_corners(flat: &FlatShape) -> [Vector; 3] {
    [flat.a, flat.b, flat.c]
}

/// A triangle and its unit normal.
#[derive(Copy, Clone, Debug)]
pub struct Flat {
    triangle: Triangle,
    normal: Vector,
}

impl Flat {
    /// A triangle; `None` if it has no normal.
    pub fn new(triangle: &Triangle) -> Option<Self> {
        Some(Self { triangle: *triangle, normal: triangle.normal()? })
    }

    /// As it is in the frame in which its own is at `pose`.
    pub fn at(&self, pose: &Pose) -> Self {
        Self { triangle: self.triangle.transformed(pose), normal: pose.rotation * self.normal }
    }

    pub fn as_polytope(&self) -> Polytope<'_> {
        Polytope::Triangle(&self.triangle, self.normal)
    }

    pub fn as_shape(&self) -> &dyn Shape {
        &self.triangle
    }

    /// How far it reaches along a direction.
    pub fn height(&self, direction: Vector) -> Real {
        let [a, b, c] = flat_corners(&self.triangle).map(|corner| corner.dot(direction));
        a.max(b).max(c)
    }
}
