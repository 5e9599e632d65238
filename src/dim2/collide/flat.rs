//! Elements of surfaces: segments.

use super::polytope::Polytope;
use crate::base::wide::Lane;
use crate::dim::math::{Pose, Real, Vector};
use crate::dim::shapes::polyline_normals;
use crate::dim::wide::WideVector;
use parry::shape::{Polyline, Segment, Shape};

/// A flat shape.
pub type FlatShape = Segment;

/// Returns the shape as a flat shape, if it is one.
pub fn as_flat(shape: &dyn Shape) -> Option<&FlatShape> {
    shape.as_segment()
}

/// The ends of a flat shape.
pub fn flat_corners(flat: &FlatShape) -> [Vector; 2] {
    [flat.a, flat.b]
}

/// A line of flat shapes.
pub type FlatMesh = Polyline;

/// Returns the shape as a line, if its pieces can be hit from both sides.
pub fn as_flat_mesh(shape: &dyn Shape) -> Option<&FlatMesh> {
    shape.as_polyline().filter(|line| polyline_normals(line).is_none())
}

/// Returns whether the shape is a line that encloses a solid inside.
pub fn has_inside(shape: &dyn Shape) -> bool {
    shape.as_polyline().is_some_and(|line| polyline_normals(line).is_some())
}

/// A piece of a line.
pub fn flat_of(mesh: &FlatMesh, id: u32) -> FlatShape {
    mesh.segment(id)
}

/// Segments, a lane for each.
pub type FlatBlock = [WideVector<Lane>; 2];

/// Sets one lane of a block.
pub fn set_flat_lane(block: &mut FlatBlock, lane: usize, flat: &FlatShape) {
    for (ends, end) in block.iter_mut().zip(flat_corners(flat)) {
        ends.set_lane(lane, end);
    }
}

/// The segment in one lane of a block.
pub fn flat_lane(block: &FlatBlock, lane: usize) -> FlatShape {
    let [a, b] = block.each_ref().map(|ends| ends.lane(lane));
    Segment::new(a, b)
}

/// A segment and its unit normal.
#[derive(Copy, Clone, Debug)]
pub struct Flat {
    segment: Segment,
    normal: Vector,
}

impl Flat {
    /// A segment; `None` if it has no normal.
    pub fn new(segment: &Segment) -> Option<Self> {
        Some(Self { segment: *segment, normal: segment.normal()? })
    }

    /// Returns the shape in the frame in which its own frame has the pose `pose`.
    pub fn at(&self, pose: &Pose) -> Self {
        Self { segment: self.segment.transformed(pose), normal: pose.rotation * self.normal }
    }

    pub fn as_polytope(&self) -> Polytope<'_> {
        Polytope::Segment(&self.segment)
    }

    pub fn as_shape(&self) -> &dyn Shape {
        &self.segment
    }

    /// Its unit normal.
    pub fn normal(&self) -> Vector {
        self.normal
    }

    /// One of its corners.
    pub fn origin(&self) -> Vector {
        self.segment.a
    }

    /// The extent along a direction.
    pub fn height(&self, direction: Vector) -> Real {
        let [a, b] = flat_corners(&self.segment).map(|corner| corner.dot(direction));
        a.max(b)
    }
}
