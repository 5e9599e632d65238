//! The surfaces of shapes as instances of meshes.

use crate::common::{BORDER_PIECES, Look, Surfaces};
use crate::rapier::prelude::*;
use drawing::{Drawing, Instance, Mesh};
use std::sync::Arc;

/// Pieces of a full circle, for shapes without a shared mesh.
const PIECES: u32 = 24;
/// Half the side of the square that stands for an endless plane.
const PLANE_EXTENT: Real = 500.0;

/// A point of the world in the coordinates of drawings.
#[allow(clippy::unnecessary_cast, reason = "`Real` may be `f64`")]
pub fn point(p: Vector) -> drawing::Point {
    [p.x as f32, p.y as f32, p.z as f32]
}

/// A place for a mesh, and its look.
struct Brush<'a> {
    out: &'a mut Drawing,
    pose: Pose,
    look: &'a Look,
}

impl Brush<'_> {
    #[allow(clippy::unnecessary_cast, reason = "`Real` may be `f64`")]
    fn add(&mut self, mesh: &Arc<Mesh>, offset: Vector, scale: [Real; 3]) {
        let Look { color, role, id, highlighted } = *self.look;
        let rotation = self.pose.rotation;
        let instance = Instance {
            position: point(self.pose * offset),
            rotation: [rotation.x, rotation.y, rotation.z, rotation.w].map(|c| c as f32),
            scale: scale.map(|c| c as f32),
            color,
            role,
            id,
            highlighted,
        };
        self.out.add(mesh, instance);
    }
}

impl Surfaces {
    /// Adds the surface of a collider. Shapes without a surface, such as segments, add nothing.
    pub(crate) fn add(&mut self, out: &mut Drawing, collider: &Collider, look: &Look) {
        let mut brush = Brush { out, pose: *collider.position(), look };
        self.shape(&mut brush, collider.shared_shape());
    }

    fn shape(&mut self, brush: &mut Brush, shape: &SharedShape) {
        match shape.as_typed_shape() {
            TypedShape::Ball(s) => brush.add(Mesh::ball(), Vector::ZERO, [s.radius; 3]),
            TypedShape::Cuboid(s) => brush.add(Mesh::cube(), Vector::ZERO, s.half_extents.into()),
            TypedShape::Cylinder(s) => {
                brush.add(Mesh::cylinder(), Vector::ZERO, [s.radius, s.half_height, s.radius]);
            }
            TypedShape::Cone(s) => {
                brush.add(Mesh::cone(), Vector::ZERO, [s.radius, s.half_height, s.radius]);
            }
            TypedShape::Capsule(s) => capsule(brush, s),
            TypedShape::Compound(s) => {
                let whole = brush.pose;
                for (pose, part) in s.shapes() {
                    brush.pose = whole * *pose;
                    self.shape(brush, part);
                }
                brush.pose = whole;
            }
            TypedShape::Segment(_) | TypedShape::Polyline(_) | TypedShape::Custom(_) => {}
            _ => {
                let mesh = self.kept(shape);
                brush.add(&mesh, Vector::ZERO, [1.0; 3]);
            }
        }
    }
}

/// A capsule: two balls and the cylinder between them.
fn capsule(brush: &mut Brush, capsule: &Capsule) {
    let Capsule { segment, radius } = *capsule;
    let (whole, axis) = (brush.pose, segment.b - segment.a);
    for end in [segment.a, segment.b] {
        brush.add(Mesh::ball(), end, [radius; 3]);
    }
    let upright = Rotation::from_rotation_arc(Vector::Y, axis.normalize_or(Vector::Y));
    brush.pose = whole * Pose::from_parts((segment.a + segment.b) * 0.5, upright);
    brush.add(Mesh::cylinder(), Vector::ZERO, [radius, 0.5 * axis.length(), radius]);
    brush.pose = whole;
}

/// The mesh of a shape in its own coordinates.
pub(crate) fn mesh(shape: &TypedShape) -> Mesh {
    match shape {
        TypedShape::Triangle(s) => surface((vec![s.a, s.b, s.c], vec![[0, 1, 2]])),
        TypedShape::Voxels(s) => surface(s.to_trimesh()),
        TypedShape::TriMesh(s) => surface((s.vertices().to_vec(), s.indices().to_vec())),
        TypedShape::HeightField(s) => surface(s.to_trimesh()),
        TypedShape::ConvexPolyhedron(s) => surface(s.to_trimesh()),
        TypedShape::RoundCuboid(s) => hull(&s.to_outline(BORDER_PIECES).0),
        TypedShape::RoundCylinder(s) => hull(&s.to_outline(PIECES, BORDER_PIECES).0),
        TypedShape::RoundCone(s) => hull(&s.to_outline(PIECES, BORDER_PIECES).0),
        TypedShape::RoundConvexPolyhedron(s) => hull(&s.to_outline(BORDER_PIECES).0),
        TypedShape::RoundTriangle(s) => {
            let normal = s.inner_shape.scaled_normal().normalize_or_zero() * s.border_radius;
            let corners = s.inner_shape.vertices();
            hull(&[corners.map(|c| c + normal), corners.map(|c| c - normal)].concat())
        }
        TypedShape::HalfSpace(s) => plane(s.normal),
        _ => surface((Vec::new(), Vec::new())),
    }
}

fn surface((vertices, triangles): (Vec<Vector>, Vec<[u32; 3]>)) -> Mesh {
    let points: Vec<_> = vertices.into_iter().map(point).collect();
    Mesh::from_triangles(&points, &triangles)
}

fn hull(points: &[Vector]) -> Mesh {
    let hull = SharedShape::convex_hull(points);
    let polyhedron = hull.as_ref().and_then(|hull| hull.as_convex_polyhedron());
    surface(polyhedron.map_or_else(Default::default, |polyhedron| polyhedron.to_trimesh()))
}

fn plane(normal: Vector) -> Mesh {
    let (u, v) = normal.any_orthonormal_pair();
    let (u, v) = (u * PLANE_EXTENT, v * PLANE_EXTENT);
    surface((vec![-u - v, u - v, u + v, v - u], vec![[0, 1, 2], [0, 2, 3]]))
}
