//! Triangles with normals, and the shapes that scenes share.

use crate::Point;
use crate::vector::{add_scaled, cross, dot, normalize, sub};
use std::collections::HashMap;
use std::f32::consts::TAU;
use std::sync::{Arc, OnceLock};

/// Faces that meet at less than this angle (its cosine) share a smooth normal.
const CREASE: f32 = 0.8;
/// Normals that agree in so many steps of their coordinates are equal.
const NORMAL_STEPS: f32 = 4096.0;
/// Pieces of a circle of any size, and of those with a radius below a number of pixels.
const PIECES: u32 = 32;
const COARSE: [(u32, f32); 3] = [(20, 48.0), (12, 16.0), (8, 6.0)];

/// A corner of a triangle.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Vertex {
    /// Its place.
    pub position: Point,
    /// The unit normal of a surface. In a flat shape: +z inside; zero on the border. In the plane of the
    /// shape where the renderer moves a vertex from the border inwards, by the width of the rim times this
    /// vector.
    pub normal: Point,
}

/// A surface of triangles.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Corners.
    pub vertices: Vec<Vertex>,
    /// Positions of three corners each.
    pub triangles: Vec<[u32; 3]>,
    /// Opposite corners of the box around it.
    pub bounds: [Point; 2],
    /// Whether the surface has an inside, which no eye reaches: triangles seen from there are not drawn.
    pub closed: bool,
    /// The same shape with fewer triangles, for radii below a number of pixels; the coarsest form last.
    pub coarse: Vec<(Arc<Mesh>, f32)>,
}

impl Mesh {
    /// A surface with these corners.
    pub fn new(vertices: Vec<Vertex>, triangles: Vec<[u32; 3]>) -> Self {
        let mut bounds = [[f32::MAX; 3], [f32::MIN; 3]];
        for vertex in &vertices {
            for axis in 0..3 {
                bounds[0][axis] = bounds[0][axis].min(vertex.position[axis]);
                bounds[1][axis] = bounds[1][axis].max(vertex.position[axis]);
            }
        }
        if vertices.is_empty() {
            bounds = [[0.0; 3]; 2];
        }
        Self { vertices, triangles, bounds, closed: false, coarse: Vec::new() }
    }

    /// A surface with normals from its triangles: smooth across shallow edges, sharp across steep ones.
    pub fn from_triangles(points: &[Point], triangles: &[[u32; 3]]) -> Self {
        let corner = |index: u32| points.get(index as usize).copied().unwrap_or_default();
        let scaled: Vec<Point> = triangles
            .iter()
            .map(|&[a, b, c]| cross(sub(corner(b), corner(a)), sub(corner(c), corner(a))))
            .collect();
        let mut faces_of: Vec<Vec<u32>> = vec![Vec::new(); points.len()];
        for (face, triangle) in triangles.iter().enumerate() {
            for &index in triangle {
                if let Some(faces) = faces_of.get_mut(index as usize) {
                    faces.push(face as u32);
                }
            }
        }
        // Corners with the same place and normal are one vertex: adapters in software spend most of a frame
        // on vertices.
        let (mut vertices, mut known) = (Vec::new(), HashMap::new());
        let mut indices = Vec::with_capacity(triangles.len());
        for (face, triangle) in triangles.iter().enumerate() {
            let own = normalize(scaled[face]);
            indices.push(triangle.map(|index| {
                let around = faces_of.get(index as usize).map_or(&[][..], Vec::as_slice);
                let near = around.iter().map(|&other| scaled[other as usize]);
                let near = near.filter(|&other| dot(normalize(other), own) > CREASE);
                let normal = near.fold(own, |sum, other| add_scaled(sum, other, 1.0));
                let normal = normalize(normal);
                let key = (index, normal.map(|c| (c * NORMAL_STEPS).round() as i32));
                *known.entry(key).or_insert_with(|| {
                    vertices.push(Vertex { position: corner(index), normal });
                    vertices.len() as u32 - 1
                })
            }));
        }
        Self::new(vertices, indices)
    }

    /// A flat convex shape with a rim, from its corners in counter-clockwise order.
    pub fn from_convex(corners: &[[f32; 2]]) -> Self {
        let mut parts = FlatParts::default();
        parts.convex(corners);
        parts.finish()
    }

    /// A flat shape of triangles; edges that belong to one triangle only get a rim.
    pub fn from_flat_triangles(points: &[[f32; 2]], triangles: &[[u32; 3]]) -> Self {
        let mut parts = FlatParts::default();
        parts.triangles(points, triangles);
        parts.finish()
    }

    /// Returns the index in `coarse` for an instance in a picture of this height in pixels; `None` for this
    /// mesh.
    pub fn detail(
        &self,
        camera: &crate::Camera,
        instance: &crate::Instance,
        height: f32,
    ) -> Option<usize> {
        if self.coarse.is_empty() {
            return None;
        }
        let largest = instance.scale.into_iter().fold(0.0, f32::max);
        let w = camera.see(instance.position).w.max(camera.nearest());
        let radius = largest / camera.pixel_at(w, height);
        self.coarse.iter().rposition(|(_, below)| radius < *below)
    }

    /// The form with the fewest triangles.
    pub(crate) fn coarsest(&self) -> &Self {
        self.coarse.last().map_or(self, |(mesh, _)| mesh)
    }

    /// The ball of radius 1.
    pub fn ball() -> &'static Arc<Self> {
        static MESH: OnceLock<Arc<Mesh>> = OnceLock::new();
        MESH.get_or_init(|| {
            Arc::new(with_coarse(true, |pieces| revolved(&arc_profile(pieces / 2), pieces, true)))
        })
    }

    /// The cube with half extents of 1.
    pub fn cube() -> &'static Arc<Self> {
        static MESH: OnceLock<Arc<Mesh>> = OnceLock::new();
        MESH.get_or_init(|| {
            let corners = crate::sheet::box_corners([[-1.0; 3], [1.0; 3]]);
            let sides = [
                [0, 4, 6, 2],
                [1, 3, 7, 5],
                [0, 1, 5, 4],
                [2, 6, 7, 3],
                [0, 2, 3, 1],
                [4, 5, 7, 6],
            ];
            let triangles: Vec<_> =
                sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
            Arc::new(Self { closed: true, ..Self::from_triangles(&corners, &triangles) })
        })
    }

    /// The cylinder of radius 1 about y, from y = -1 to 1.
    pub fn cylinder() -> &'static Arc<Self> {
        static MESH: OnceLock<Arc<Mesh>> = OnceLock::new();
        MESH.get_or_init(|| {
            let profile = [[0.0, -1.0], [1.0, -1.0], [1.0, 1.0], [0.0, 1.0]];
            Arc::new(with_coarse(true, |pieces| revolved(&profile, pieces, false)))
        })
    }

    /// The cone with a base of radius 1 at y = -1 and its tip at y = 1.
    pub fn cone() -> &'static Arc<Self> {
        static MESH: OnceLock<Arc<Mesh>> = OnceLock::new();
        MESH.get_or_init(|| {
            let profile = [[0.0, -1.0], [1.0, -1.0], [0.0, 1.0]];
            Arc::new(with_coarse(true, |pieces| revolved(&profile, pieces, false)))
        })
    }

    /// The flat disc of radius 1.
    pub fn disc() -> &'static Arc<Self> {
        static MESH: OnceLock<Arc<Mesh>> = OnceLock::new();
        MESH.get_or_init(|| Arc::new(with_coarse(false, flat_disc)))
    }

    /// The flat square with half extents of 1.
    pub fn square() -> &'static Arc<Self> {
        static MESH: OnceLock<Arc<Mesh>> = OnceLock::new();
        MESH.get_or_init(|| {
            Arc::new(Self::from_convex(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]))
        })
    }
}

/// Creates a mesh with its coarse forms, from a function of the number of pieces of a circle.
fn with_coarse(closed: bool, of: impl Fn(u32) -> Mesh) -> Mesh {
    let form = |pieces: u32| Mesh { closed, ..of(pieces) };
    let coarse = COARSE.map(|(pieces, below)| (Arc::new(form(pieces)), below));
    Mesh { coarse: coarse.into(), ..form(PIECES) }
}

/// Creates a disc with a spoke, which makes rotation visible.
fn flat_disc(pieces: u32) -> Mesh {
    let angle = |i: u32| TAU * i as f32 / pieces as f32;
    let corners: Vec<_> = (0..pieces).map(|i| [angle(i).cos(), angle(i).sin()]).collect();
    let mut parts = FlatParts::default();
    parts.convex(&corners);
    parts.spoke([0.0, 0.0], [1.0, 0.0]);
    parts.finish()
}

/// Returns half a circle from the lower pole to the upper one.
fn arc_profile(rings: u32) -> Vec<[f32; 2]> {
    let angle = |i: u32| std::f32::consts::PI * (i as f32 / rings as f32 - 0.5);
    let at = |i: u32| match i {
        0 => [0.0, -1.0],
        i if i == rings => [0.0, 1.0],
        i => [angle(i).cos(), angle(i).sin()],
    };
    (0..=rings).map(at).collect()
}

/// Returns the surface of revolution of a profile (distance from the axis, height) about y. With `round`,
/// positions on the unit sphere are the normals.
fn revolved(profile: &[[f32; 2]], pieces: u32, round: bool) -> Mesh {
    let count = profile.len() as u32;
    let mut points = Vec::new();
    for piece in 0..pieces {
        let angle = TAU * piece as f32 / pieces as f32;
        points.extend(profile.iter().map(|&[r, y]| [r * angle.cos(), y, r * angle.sin()]));
    }
    let mut triangles = Vec::new();
    for piece in 0..pieces {
        let [here, next] = [piece, (piece + 1) % pieces].map(|p| p * count);
        for i in 0..count - 1 {
            let [a, b, c, d] = [here + i, here + i + 1, next + i + 1, next + i];
            if profile[i as usize][0] > 0.0 {
                triangles.push([a, b, d]);
            }
            if profile[i as usize + 1][0] > 0.0 {
                triangles.push([d, b, c]);
            }
        }
    }
    if round {
        let vertices = points.iter().map(|&p| Vertex { position: p, normal: p }).collect();
        return Mesh::new(vertices, triangles);
    }
    Mesh::from_triangles(&points, &triangles)
}

/// A flat shape under construction: the inside, then the rim, which is painted over it.
#[derive(Default)]
struct FlatParts {
    vertices: Vec<Vertex>,
    inside: Vec<[u32; 3]>,
    rim: Vec<[u32; 3]>,
}

impl FlatParts {
    fn push(&mut self, [x, y]: [f32; 2], normal: Point) -> u32 {
        self.vertices.push(Vertex { position: [x, y, 0.0], normal });
        self.vertices.len() as u32 - 1
    }

    fn convex(&mut self, corners: &[[f32; 2]]) {
        let first = self.vertices.len() as u32;
        for &corner in corners {
            self.push(corner, [0.0, 0.0, 1.0]);
        }
        let count = corners.len();
        self.inside.extend((1..count.max(2) as u32 - 1).map(|i| [first, first + i, first + i + 1]));
        for i in 0..count {
            let [before, here, next, after] =
                [count - 1, 0, 1, 2].map(|step| corners[(i + step) % count]);
            let ends = [miter(before, here, next), miter(here, next, after)];
            self.rim([here, next], ends);
        }
    }

    fn triangles(&mut self, points: &[[f32; 2]], triangles: &[[u32; 3]]) {
        let first = self.vertices.len() as u32;
        for &point in points {
            self.push(point, [0.0, 0.0, 1.0]);
        }
        self.inside.extend(triangles.iter().map(|t| t.map(|i| first + i)));
        let mut sides: Vec<[u32; 2]> = Vec::new();
        for &[a, b, c] in triangles {
            sides.extend([[a, b], [b, c], [c, a]]);
        }
        let known: std::collections::HashSet<[u32; 2]> = sides.iter().copied().collect();
        for &[a, b] in sides.iter().filter(|[a, b]| !known.contains(&[*b, *a])) {
            let [from, to] = [points[a as usize], points[b as usize]];
            let inwards = left_of(from, to);
            self.rim([from, to], [inwards; 2]);
        }
    }

    /// Adds a band along a side, as wide as the rim, on the side of the vectors.
    fn rim(&mut self, [from, to]: [[f32; 2]; 2], [in_from, in_to]: [[f32; 2]; 2]) {
        let a = self.push(from, [0.0; 3]);
        let b = self.push(to, [0.0; 3]);
        let c = self.push(to, [in_to[0], in_to[1], 0.0]);
        let d = self.push(from, [in_from[0], in_from[1], 0.0]);
        self.rim.extend([[a, b, c], [a, c, d]]);
    }

    fn spoke(&mut self, from: [f32; 2], to: [f32; 2]) {
        let across = left_of(from, to).map(|c| 0.5 * c);
        self.rim([from, to], [across; 2]);
        self.rim([to, from], [across.map(|c| -c); 2]);
    }

    fn finish(mut self) -> Mesh {
        self.inside.append(&mut self.rim);
        Mesh::new(self.vertices, self.inside)
    }
}

/// The unit vector to the left of a direction.
fn left_of(from: [f32; 2], to: [f32; 2]) -> [f32; 2] {
    let d = [to[0] - from[0], to[1] - from[1]];
    let length = (d[0] * d[0] + d[1] * d[1]).sqrt().max(f32::MIN_POSITIVE);
    [-d[1] / length, d[0] / length]
}

/// The vector from a corner to the corner of the border that is parallel at distance 1 inside.
fn miter(before: [f32; 2], here: [f32; 2], next: [f32; 2]) -> [f32; 2] {
    let (m, n) = (left_of(before, here), left_of(here, next));
    // The limit keeps inner corners near sharp ones.
    let shared = (1.0 + m[0] * n[0] + m[1] * n[1]).max(0.3);
    [(m[0] + n[0]) / shared, (m[1] + n[1]) / shared]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_point_outwards() {
        for (name, mesh) in [
            ("ball", Mesh::ball()),
            ("cube", Mesh::cube()),
            ("cylinder", Mesh::cylinder()),
            ("cone", Mesh::cone()),
        ] {
            for vertex in &mesh.vertices {
                let length = dot(vertex.normal, vertex.normal);
                assert!((length - 1.0).abs() < 1.0e-3, "{name}: {vertex:?}");
            }
            for &[a, b, c] in &mesh.triangles {
                let [a, b, c] = [a, b, c].map(|i| mesh.vertices[i as usize]);
                let face = cross(sub(b.position, a.position), sub(c.position, a.position));
                assert!(dot(face, a.normal) > 0.0, "{name}: {a:?} {b:?} {c:?}");
                assert!(dot(face, a.position) > 0.0, "{name} turns inside out");
            }
        }
    }

    #[test]
    fn rims_lie_inside() {
        let mesh = Mesh::square();
        for vertex in &mesh.vertices {
            let moved = add_scaled(vertex.position, vertex.normal, 0.1);
            assert!(moved[0].abs() <= 1.0 + 1.0e-6 && moved[1].abs() <= 1.0 + 1.0e-6);
        }
        assert_eq!(mesh.triangles.len(), 2 + 8);
    }
}
