//! Elements of surfaces: triangles.

use super::polytope::Polytope;
use crate::base::wide::Lane;
use crate::dim::math::{Pose, Real, Vector};
use crate::dim::wide::WideVector;
use parry::shape::{Shape, TriMesh, TriMeshFlags, Triangle};

/// A flat shape.
pub type FlatShape = Triangle;

/// Returns the shape as a flat shape, if it is one.
pub fn as_flat(shape: &dyn Shape) -> Option<&FlatShape> {
    shape.as_triangle()
}

/// The corners of a flat shape.
pub fn flat_corners(flat: &FlatShape) -> [Vector; 3] {
    [flat.a, flat.b, flat.c]
}

/// A surface of flat shapes.
pub type FlatMesh = TriMesh;

/// Returns the shape as a surface, if its pieces can be hit from both sides.
pub fn as_flat_mesh(shape: &dyn Shape) -> Option<&FlatMesh> {
    let is_free = |mesh: &&TriMesh| !mesh.flags().contains(TriMeshFlags::FIX_INTERNAL_EDGES);
    shape.as_trimesh().filter(is_free)
}

/// Returns whether the shape is a surface that encloses a solid inside.
pub fn has_inside(shape: &dyn Shape) -> bool {
    shape.as_trimesh().is_some_and(|mesh| mesh.flags().contains(TriMeshFlags::ORIENTED))
}

/// A piece of a surface.
pub fn flat_of(mesh: &FlatMesh, id: u32) -> FlatShape {
    mesh.triangle(id)
}

/// Triangles, a lane for each.
pub type FlatBlock = [WideVector<Lane>; 3];

/// Sets one lane of a block.
pub fn set_flat_lane(block: &mut FlatBlock, lane: usize, flat: &FlatShape) {
    for (corners, corner) in block.iter_mut().zip(flat_corners(flat)) {
        corners.set_lane(lane, corner);
    }
}

/// The triangle in one lane of a block.
pub fn flat_lane(block: &FlatBlock, lane: usize) -> FlatShape {
    let [a, b, c] = block.each_ref().map(|corners| corners.lane(lane));
    Triangle::new(a, b, c)
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

    /// Returns the shape in the frame in which its own frame has the pose `pose`.
    pub fn at(&self, pose: &Pose) -> Self {
        Self { triangle: self.triangle.transformed(pose), normal: pose.rotation * self.normal }
    }

    pub fn as_polytope(&self) -> Polytope<'_> {
        Polytope::Triangle(&self.triangle, self.normal)
    }

    pub fn as_shape(&self) -> &dyn Shape {
        &self.triangle
    }

    /// Its unit normal.
    pub fn normal(&self) -> Vector {
        self.normal
    }

    /// One of its corners.
    pub fn origin(&self) -> Vector {
        self.triangle.a
    }

    /// The extent along a direction.
    pub fn height(&self, direction: Vector) -> Real {
        let [a, b, c] = flat_corners(&self.triangle).map(|corner| corner.dot(direction));
        a.max(b).max(c)
    }
}
