//! The insides of shapes as triangles, for pictures.

use crate::rapier::prelude::*;

/// Triangles in the world, as the gallery wants them.
#[derive(Default)]
pub(crate) struct Solid {
    pub triangles: Vec<[gallery::Point; 3]>,
}

/// Pieces of a full circle.
const PIECES: u32 = 32;
/// Pieces of the quarter turn of a rounded border.
const BORDER_PIECES: u32 = 5;
/// Half the length of the border of an endless plane, and how deep it is painted.
const PLANE_EXTENT: Real = 1000.0;

/// A point in the gallery's coordinates.
#[allow(clippy::unnecessary_cast, reason = "`Real` may be `f64`")]
pub(crate) fn point(p: Vector) -> gallery::Point {
    [p.x as f32, p.y as f32, 0.0]
}

/// Adds the inside of a shape. Those without any, such as segments, add nothing.
pub(crate) fn solid(out: &mut Solid, pose: &Pose, shape: &TypedShape) {
    match shape {
        TypedShape::Ball(s) => out.convex(pose, &s.to_polyline(PIECES)),
        TypedShape::Cuboid(s) => out.convex(pose, &s.to_polyline()),
        TypedShape::Capsule(s) => out.convex(pose, &s.to_polyline(PIECES / 2)),
        TypedShape::Triangle(s) => out.convex(pose, &[s.a, s.b, s.c]),
        TypedShape::Voxels(s) => {
            for voxel in s.voxels().filter(|voxel| !voxel.state.is_empty()) {
                let half = s.voxel_size() * 0.5;
                let corners = Cuboid::new(half).to_polyline();
                out.convex(&(*pose * Pose::from_translation(voxel.center)), &corners);
            }
        }
        TypedShape::TriMesh(s) => {
            let corner = |i: u32| s.vertices()[i as usize];
            s.indices().iter().for_each(|t| out.convex(pose, &t.map(corner)));
        }
        TypedShape::ConvexPolygon(s) => out.convex(pose, s.points()),
        TypedShape::RoundCuboid(s) => out.convex(pose, &s.to_polyline(BORDER_PIECES)),
        TypedShape::RoundConvexPolygon(s) => out.convex(pose, &s.to_polyline(BORDER_PIECES)),
        TypedShape::RoundTriangle(s) => {
            if let Some(inner_shape) = ConvexPolygon::from_convex_hull(s.inner_shape.vertices()) {
                let round = RoundConvexPolygon { inner_shape, border_radius: s.border_radius };
                out.convex(pose, &round.to_polyline(BORDER_PIECES));
            }
        }
        TypedShape::HalfSpace(s) => {
            let along = Vector::new(s.normal.y, -s.normal.x) * PLANE_EXTENT;
            let down = s.normal * -PLANE_EXTENT;
            out.convex(pose, &[-along, along, along + down, down - along]);
        }
        TypedShape::HeightField(s) => {
            // Painted down to the lowest point, as the ground that it usually is.
            let floor = s.root_aabb().mins.y;
            for piece in s.segments() {
                let foot = |p: Vector| Vector::new(p.x, floor);
                out.convex(pose, &[piece.a, piece.b, foot(piece.b), foot(piece.a)]);
            }
        }
        TypedShape::Compound(s) => {
            for (part_pose, part) in s.shapes() {
                solid(out, &(*pose * *part_pose), &part.as_typed_shape());
            }
        }
        TypedShape::Segment(_) | TypedShape::Polyline(_) | TypedShape::Custom(_) => {}
    }
}

impl Solid {
    /// Adds a convex polygon: triangles from its first corner to all sides.
    fn convex(&mut self, pose: &Pose, corners: &[Vector]) {
        let places: Vec<_> = corners.iter().map(|&corner| point(*pose * corner)).collect();
        let [first, rest @ ..] = places.as_slice() else { return };
        self.triangles.extend(rest.windows(2).map(|side| [*first, side[0], side[1]]));
    }
}
