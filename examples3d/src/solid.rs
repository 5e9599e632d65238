//! The surfaces of shapes as triangles, for pictures.

use crate::rapier::prelude::*;

/// Triangles in the world, as the gallery wants them.
#[derive(Default)]
pub(crate) struct Solid {
    pub triangles: Vec<[gallery::Point; 3]>,
}

/// Pieces of a full circle.
const PIECES: u32 = 24;
/// Pieces of the quarter turn of a rounded border.
const BORDER_PIECES: u32 = 5;
/// Half the side of the square that stands for an endless plane.
const PLANE_EXTENT: Real = 500.0;

/// A point in the gallery's coordinates.
#[allow(clippy::unnecessary_cast, reason = "`Real` may be `f64`")]
pub(crate) fn point(p: Vector) -> gallery::Point {
    [p.x as f32, p.y as f32, p.z as f32]
}

/// Adds the surface of a shape. Those without any, such as segments, add nothing.
pub(crate) fn solid(out: &mut Solid, pose: &Pose, shape: &TypedShape) {
    match shape {
        TypedShape::Ball(s) => out.mesh(pose, s.to_trimesh(PIECES, PIECES / 2)),
        TypedShape::Cuboid(s) => out.mesh(pose, s.to_trimesh()),
        TypedShape::Capsule(s) => out.mesh(pose, s.to_trimesh(PIECES, PIECES / 2)),
        TypedShape::Triangle(s) => out.mesh(pose, (vec![s.a, s.b, s.c], vec![[0, 1, 2]])),
        TypedShape::Voxels(s) => out.mesh(pose, s.to_trimesh()),
        TypedShape::TriMesh(s) => out.mesh(pose, (s.vertices().to_vec(), s.indices().to_vec())),
        TypedShape::HeightField(s) => out.mesh(pose, s.to_trimesh()),
        TypedShape::ConvexPolyhedron(s) => out.mesh(pose, s.to_trimesh()),
        TypedShape::Cylinder(s) => out.mesh(pose, s.to_trimesh(PIECES)),
        TypedShape::Cone(s) => out.mesh(pose, s.to_trimesh(PIECES)),
        TypedShape::RoundCuboid(s) => out.hull(pose, &s.to_outline(BORDER_PIECES).0),
        TypedShape::RoundCylinder(s) => out.hull(pose, &s.to_outline(PIECES, BORDER_PIECES).0),
        TypedShape::RoundCone(s) => out.hull(pose, &s.to_outline(PIECES, BORDER_PIECES).0),
        TypedShape::RoundConvexPolyhedron(s) => out.hull(pose, &s.to_outline(BORDER_PIECES).0),
        TypedShape::RoundTriangle(s) => {
            let normal = s.inner_shape.scaled_normal().normalize_or_zero() * s.border_radius;
            let corners = s.inner_shape.vertices();
            out.hull(pose, &[corners.map(|c| c + normal), corners.map(|c| c - normal)].concat());
        }
        TypedShape::HalfSpace(s) => out.plane(pose, s.normal),
        TypedShape::Compound(s) => {
            for (part_pose, part) in s.shapes() {
                solid(out, &(*pose * *part_pose), &part.as_typed_shape());
            }
        }
        TypedShape::Segment(_) | TypedShape::Polyline(_) | TypedShape::Custom(_) => {}
    }
}

impl Solid {
    fn mesh(&mut self, pose: &Pose, (vertices, triangles): (Vec<Vector>, Vec<[u32; 3]>)) {
        let places: Vec<_> = vertices.into_iter().map(|vertex| point(*pose * vertex)).collect();
        self.triangles.extend(triangles.iter().map(|t| t.map(|i| places[i as usize])));
    }

    fn hull(&mut self, pose: &Pose, points: &[Vector]) {
        if let Some(hull) = SharedShape::convex_hull(points)
            && let Some(polyhedron) = hull.as_convex_polyhedron()
        {
            self.mesh(pose, polyhedron.to_trimesh());
        }
    }

    fn plane(&mut self, pose: &Pose, normal: Vector) {
        let (u, v) = normal.any_orthonormal_pair();
        let (u, v) = (u * PLANE_EXTENT, v * PLANE_EXTENT);
        self.mesh(pose, (vec![-u - v, u - v, u + v, v - u], vec![[0, 1, 2], [0, 2, 3]]));
    }
}
