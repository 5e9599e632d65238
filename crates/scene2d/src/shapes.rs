//! The insides of shapes as instances of flat meshes.

use crate::common::{BORDER_PIECES, Look, Surfaces};
use crate::rapier::prelude::*;
use drawing::{Drawing, Instance, Mesh};
use std::collections::HashMap;
use std::sync::Arc;

/// Pieces of a full circle, for shapes without a shared mesh.
const PIECES: u32 = 32;
/// Half the length of the border of a half-plane, and its depth.
const PLANE_EXTENT: Real = 1000.0;

/// Converts a point of the world to the coordinates of drawings.
#[allow(clippy::unnecessary_cast, reason = "`Real` may be `f64`")]
pub fn point(p: Vector) -> drawing::Point {
    [p.x as f32, p.y as f32, 0.0]
}

impl Surfaces {
    /// Adds the inside of a collider. Shapes without an inside, such as segments, add nothing.
    pub(crate) fn add(&mut self, out: &mut Drawing, collider: &Collider, look: &Look) {
        self.shape(out, *collider.position(), collider.shared_shape(), look);
    }

    fn shape(&mut self, out: &mut Drawing, pose: Pose, shape: &SharedShape, look: &Look) {
        match shape.as_typed_shape() {
            TypedShape::Ball(s) => add(out, pose, Mesh::disc(), [s.radius; 2], look),
            TypedShape::Cuboid(s) => add(out, pose, Mesh::square(), s.half_extents.into(), look),
            TypedShape::Compound(s) => {
                for (part_pose, part) in s.shapes() {
                    self.shape(out, pose * *part_pose, part, look);
                }
            }
            TypedShape::Segment(_) | TypedShape::Polyline(_) | TypedShape::Custom(_) => {}
            _ => {
                let mesh = self.kept(shape);
                add(out, pose, &mesh, [1.0; 2], look);
            }
        }
    }
}

#[allow(clippy::unnecessary_cast, reason = "`Real` may be `f64`")]
fn add(out: &mut Drawing, pose: Pose, mesh: &Arc<Mesh>, scale: [Real; 2], look: &Look) {
    let Look { color, role, id, highlighted } = *look;
    let half = 0.5 * pose.rotation.angle() as f32;
    let instance = Instance {
        position: point(pose.translation),
        rotation: [0.0, 0.0, half.sin(), half.cos()],
        scale: [scale[0] as f32, scale[1] as f32, 1.0],
        color,
        role,
        id,
        highlighted,
    };
    out.add(mesh, instance);
}

/// The mesh of a shape in its own coordinates.
pub(crate) fn mesh(shape: &TypedShape) -> Mesh {
    match shape {
        TypedShape::Capsule(s) => convex(&s.to_polyline(PIECES / 2)),
        TypedShape::Triangle(s) => convex(&[s.a, s.b, s.c]),
        TypedShape::ConvexPolygon(s) => convex(s.points()),
        TypedShape::RoundCuboid(s) => convex(&s.to_polyline(BORDER_PIECES)),
        TypedShape::RoundConvexPolygon(s) => convex(&s.to_polyline(BORDER_PIECES)),
        TypedShape::RoundTriangle(s) => {
            let hull = ConvexPolygon::from_convex_hull(s.inner_shape.vertices());
            let round = hull.map(|inner_shape| RoundConvexPolygon {
                inner_shape,
                border_radius: s.border_radius,
            });
            convex(&round.map_or_else(Vec::new, |round| round.to_polyline(BORDER_PIECES)))
        }
        TypedShape::HalfSpace(s) => {
            let along = Vector::new(s.normal.y, -s.normal.x) * PLANE_EXTENT;
            let down = s.normal * -PLANE_EXTENT;
            convex(&[along, -along, down - along, along + down])
        }
        TypedShape::TriMesh(s) => {
            let points: Vec<_> = s.vertices().iter().map(|&p| flat(p)).collect();
            Mesh::from_flat_triangles(&points, s.indices())
        }
        TypedShape::Voxels(s) => voxels(s),
        TypedShape::HeightField(s) => height_field(s),
        _ => convex(&[]),
    }
}

#[allow(clippy::unnecessary_cast, reason = "`Real` may be `f64`")]
fn flat(p: Vector) -> [f32; 2] {
    [p.x as f32, p.y as f32]
}

/// Returns the mesh of a convex shape, with corners in either order.
fn convex(corners: &[Vector]) -> Mesh {
    let mut points: Vec<_> = corners.iter().map(|&corner| flat(corner)).collect();
    let next = |i: usize| points[(i + 1) % points.len()];
    let area: f32 =
        (0..points.len()).map(|i| points[i][0] * next(i)[1] - points[i][1] * next(i)[0]).sum();
    if area < 0.0 {
        points.reverse();
    }
    Mesh::from_convex(&points)
}

/// Returns the mesh of squares with shared corners, so that only the outline has a rim.
fn voxels(voxels: &Voxels) -> Mesh {
    let (mut index, mut points, mut triangles) = (HashMap::new(), Vec::new(), Vec::new());
    let half = voxels.voxel_size() * 0.5;
    for voxel in voxels.voxels().filter(|voxel| !voxel.state.is_empty()) {
        let [x, y] = <[Int; 2]>::from(voxel.grid_coords);
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(dx, dy)| {
            let side = |d: Int, half: Real| if d == 0 { -half } else { half };
            let place = voxel.center + Vector::new(side(dx, half.x), side(dy, half.y));
            *index.entry((x + dx, y + dy)).or_insert_with(|| {
                points.push(flat(place));
                points.len() as u32 - 1
            })
        });
        let [a, b, c, d] = corners;
        triangles.extend([[a, b, c], [a, c, d]]);
    }
    Mesh::from_flat_triangles(&points, &triangles)
}

/// Returns the mesh of a height field, filled down to its lowest point, as a ground.
fn height_field(field: &HeightField) -> Mesh {
    let floor = field.root_aabb().mins.y;
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for piece in field.segments() {
        let first = points.len() as u32;
        let foot = |p: Vector| Vector::new(p.x, floor);
        points.extend([piece.a, foot(piece.a), foot(piece.b), piece.b].map(flat));
        triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    Mesh::from_flat_triangles(&points, &triangles)
}
