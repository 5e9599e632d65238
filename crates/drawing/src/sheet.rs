//! The content of a picture: instances of meshes, lines, labels.

use crate::mesh::Mesh;
use crate::vector::{add_scaled, rotate, sub};
use crate::{Color, Point};
use std::collections::HashMap;
use std::sync::Arc;

/// Role of an instance: it determines framing and the look of the surface.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Role {
    /// Belongs to a body that can move. The camera frames these.
    Moving,
    /// Fixed among the moving instances. The camera frames these too.
    Fixed,
    /// Surrounds all other instances. The camera ignores it.
    Scenery,
    /// Like scenery, but level: it has a grid, fades out with distance, and is visible from its front only.
    Ground,
}

/// Placed mesh.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Instance {
    /// Translation.
    pub position: Point,
    /// Rotation: a unit quaternion (x, y, z, w).
    pub rotation: [f32; 4],
    /// Scales along the axes of the mesh, applied first.
    pub scale: Point,
    /// Colour of the surface in full light.
    pub color: Color,
    /// Role of the instance.
    pub role: Role,
    /// Number of the object, for picking and for tests.
    pub id: u32,
    /// Whether the surface is brightened, as that of a selected object.
    pub highlighted: bool,
}

impl Instance {
    /// A point of the mesh in world space.
    pub fn place(&self, point: Point) -> Point {
        let scaled = std::array::from_fn(|axis| point[axis] * self.scale[axis]);
        add_scaled(self.position, rotate(self.rotation, scaled), 1.0)
    }

    fn is_finite(&self) -> bool {
        let Self { position, rotation, scale, .. } = self;
        position.iter().chain(rotation).chain(scale).all(|c| c.is_finite())
    }
}

/// All instances of one mesh.
#[derive(Clone, Debug)]
pub struct Batch {
    /// The mesh.
    pub mesh: Arc<Mesh>,
    /// Instances of the mesh.
    pub instances: Vec<Instance>,
}

/// A straight line.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Line {
    /// One end.
    pub from: Point,
    /// The other end.
    pub to: Point,
    /// Its colour.
    pub color: Color,
    /// Whether the line is visible through surfaces.
    pub on_top: bool,
}

/// Short text with its middle at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The middle of the text.
    pub at: Point,
    /// The text.
    pub text: String,
}

/// The content of a picture.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// Instances, by mesh, in the order in which the meshes came first.
    pub batches: Vec<Batch>,
    /// Lines.
    pub lines: Vec<Line>,
    /// Labels.
    pub labels: Vec<Label>,
    /// Positions in `batches` by the address of the mesh.
    index: HashMap<usize, usize>,
}

impl Drawing {
    /// Adds an instance; one with a value that is not finite is ignored.
    pub fn add(&mut self, mesh: &Arc<Mesh>, instance: Instance) {
        if !instance.is_finite() {
            return;
        }
        let address = Arc::as_ptr(mesh) as usize;
        let batch = *self.index.entry(address).or_insert_with(|| {
            self.batches.push(Batch { mesh: mesh.clone(), instances: Vec::new() });
            self.batches.len() - 1
        });
        self.batches[batch].instances.push(instance);
    }

    /// Adds a line; one with a value that is not finite is ignored.
    pub fn line(&mut self, line: Line) {
        if [line.from, line.to].as_flattened().iter().all(|c| c.is_finite()) {
            self.lines.push(line);
        }
    }

    /// Adds a label; one at a place that is not finite is ignored.
    pub fn label(&mut self, at: Point, text: &str) {
        if at.iter().all(|c| c.is_finite()) {
            self.labels.push(Label { at, text: text.to_owned() });
        }
    }

    /// All instances, with their meshes.
    pub fn instances(&self) -> impl Iterator<Item = (&Mesh, &Instance)> {
        self.batches.iter().flat_map(|batch| {
            batch.instances.iter().map(|instance| (batch.mesh.as_ref(), instance))
        })
    }

    /// Returns the points that a camera has to frame. These are the corners of the boxes of all moving
    /// instances and of the fixed ones between them, or of all instances if none moves.
    pub fn points_to_frame(&self) -> Vec<Point> {
        let gather = |wanted: fn(Role) -> bool| -> Vec<Point> {
            let instances = self.instances().filter(|(_, instance)| wanted(instance.role));
            let corners = instances.flat_map(|(mesh, instance)| {
                box_corners(mesh.bounds).map(|corner| instance.place(corner))
            });
            corners.chain(self.labels.iter().map(|label| label.at)).collect()
        };
        let near = gather(|role| matches!(role, Role::Moving | Role::Fixed));
        if near.is_empty() { gather(|_| true) } else { near }
    }

    /// The middle and the radius of the moving instances, without the farthest hundredth of them.
    pub fn moving_extent(&self) -> Option<(Point, f32)> {
        let moving = self.instances().filter(|(_, instance)| instance.role == Role::Moving);
        let places: Vec<Point> = moving.map(|(_, instance)| instance.position).collect();
        let count = places.len();
        if count == 0 {
            return None;
        }
        let middle = std::array::from_fn(|axis| {
            let mut values: Vec<f32> = places.iter().map(|place| place[axis]).collect();
            *values.select_nth_unstable_by(count / 2, f32::total_cmp).1
        });
        let mut distances: Vec<f32> = places
            .iter()
            .map(|&place| sub(place, middle).iter().map(|c| c * c).sum::<f32>().sqrt())
            .collect();
        let last = (count * 99 / 100).min(count - 1);
        let radius = *distances.select_nth_unstable_by(last, f32::total_cmp).1;
        Some((middle, radius.max(1.0)))
    }
}

/// The corners of the box between two opposite ones.
pub(crate) fn box_corners([min, max]: [Point; 2]) -> [Point; 8] {
    std::array::from_fn(|corner| {
        std::array::from_fn(|axis| if corner >> axis & 1 == 0 { min[axis] } else { max[axis] })
    })
}
