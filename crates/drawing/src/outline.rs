//! Outlines of highlighted instances: the edges between what faces the eye and what does not.

use crate::vector::{cross, dot, sub};
use crate::{Camera, Color, Drawing, Instance, Line, Mesh, Point};
use std::collections::BTreeMap;

/// Triangles of a mesh above which its instances get no outline: the edges are searched in each frame.
const TRIANGLES_MAX: usize = 20_000;
/// Steps of a mesh's extent. Corners of one step are one point, although they have several normals.
const STEPS: f32 = 16_384.0;

/// A corner in steps of the mesh's extent.
type Corner = [i32; 3];

/// The triangles that meet at an edge.
struct Edge {
    ends: [Point; 2],
    triangles: u32,
    facing: u32,
}

impl Drawing {
    /// Adds the outlines of highlighted instances, visible through all surfaces.
    pub fn outline_highlighted(&mut self, camera: &Camera, color: Color) {
        let mut lines = Vec::new();
        for batch in &self.batches {
            let highlighted = batch.instances.iter().filter(|instance| instance.highlighted);
            for instance in highlighted.filter(|_| batch.mesh.triangles.len() <= TRIANGLES_MAX) {
                lines.extend(outline(&batch.mesh, instance, camera));
            }
        }
        for [from, to] in lines {
            self.line(Line { from, to, color, on_top: true });
        }
    }
}

/// The edges between a triangle that faces the eye and one that does not, and the edges of single triangles.
fn outline(mesh: &Mesh, instance: &Instance, camera: &Camera) -> Vec<[Point; 2]> {
    let [min, max] = mesh.bounds;
    let extent = sub(max, min).into_iter().fold(f32::MIN_POSITIVE, f32::max);
    let corner_of = |at: Point| -> Corner {
        std::array::from_fn(|axis| ((at[axis] - min[axis]) / extent * STEPS).round() as i32)
    };
    let mut edges: BTreeMap<[Corner; 2], Edge> = BTreeMap::new();
    for triangle in &mesh.triangles {
        let Some(local) = points(mesh, triangle) else { continue };
        let corners = local.map(corner_of);
        // Borders of flat shapes have triangles without an area.
        if corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0] {
            continue;
        }
        let places = local.map(|at| instance.place(at));
        let [a, b, c] = places;
        let faces = dot(cross(sub(b, a), sub(c, a)), camera.toward_eye(a)) > 0.0;
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let key = [corners[i].min(corners[j]), corners[i].max(corners[j])];
            let ends = [places[i], places[j]];
            let edge = edges.entry(key).or_insert(Edge { ends, triangles: 0, facing: 0 });
            edge.triangles += 1;
            edge.facing += u32::from(faces);
        }
    }
    edges
        .into_values()
        .filter(|edge| edge.triangles == 1 || (edge.facing > 0 && edge.facing < edge.triangles))
        .map(|edge| edge.ends)
        .collect()
}

fn points(mesh: &Mesh, triangle: &[u32; 3]) -> Option<[Point; 3]> {
    let [a, b, c] = triangle.map(|index| mesh.vertices.get(index as usize).map(|v| v.position));
    Some([a?, b?, c?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Role, View};
    use std::sync::Arc;

    /// The outline of a box with corners at ±1 from a direction.
    fn outline_of_box(yaw: f32, pitch: f32) -> Vec<Line> {
        let points: Vec<Point> = (0..8)
            .map(|i| std::array::from_fn(|axis| if i >> axis & 1 == 0 { -1.0 } else { 1.0 }))
            .collect();
        let sides: [[u32; 4]; 6] =
            [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let triangles: Vec<_> =
            sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let mut drawing = Drawing::default();
        let instance = Instance {
            position: [3.0, 0.0, 0.0],
            rotation: [0.0, 0.0, 0.0, 1.0],
            scale: [1.0; 3],
            color: Color::from_hsl(0.0, 0.0, 1.0, 1.0),
            role: Role::Moving,
            id: 0,
            highlighted: true,
        };
        let mesh = Arc::new(Mesh::from_triangles(&points, &triangles));
        drawing.add(&mesh, instance);
        drawing.add(&mesh, Instance { highlighted: false, ..instance });
        let camera = drawing.camera(&View::orbit(yaw, pitch), [100, 100]);
        drawing.outline_highlighted(&camera, instance.color);
        drawing.lines
    }

    #[test]
    fn the_outline_of_a_box_is_a_hexagon_from_a_corner_and_a_square_from_the_front() {
        assert_eq!(outline_of_box(40.0, 30.0).len(), 6);
        assert_eq!(outline_of_box(0.0, 0.0).len(), 4);
    }
}
