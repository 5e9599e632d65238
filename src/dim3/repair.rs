//! Copies of shapes whose stored directions contradict their points.
//!
//! parry scales normals like points, which is wrong for uneven factors. It keeps the winding under negative
//! factors, which is then that of the inside. Height fields with a negative scale find none of their cells.

use super::flat_hull::flat_hull;
use super::hull::{convex_hull, convex_mesh};
use super::math::{Real, Vector};
use super::shapes::is_inside_out;
use crate::base::hash::FastHashMap;
use parry::shape::{
    ConvexPolyhedron, HeightField, HeightFieldCellStatus, RoundShape, SharedShape, TriMesh,
    TriMeshBuilderError, TriMeshFlags, TypedShape,
};
use parry::utils::Array2;

/// Largest sine of the angle between a plane and a line in it, for each triangle of a face beyond rounding.
/// parry merges neighbouring triangles up to 1.5° into one face, with the normal of one of them.
const MERGED_SINE_MAX: Real = 0.03;
/// Largest sine of the angle between a face and a line in it.
const FACE_SINE_MAX: Real = 0.5;
/// Rounding of a height above a plane, as a fraction of the coordinates.
const ROUNDING: Real = 64.0 * Real::EPSILON;

/// A copy of a convex shape or a height field that is consistent; `None` if the shape is.
pub fn repaired(shape: TypedShape<'_>) -> Option<SharedShape> {
    match shape {
        TypedShape::ConvexPolyhedron(solid) => repaired_hull(solid).map(SharedShape::new),
        TypedShape::RoundConvexPolyhedron(round) => {
            let border_radius = round.border_radius;
            let inner = repaired_hull(&round.inner_shape)?;
            Some(SharedShape::new(RoundShape { inner_shape: inner, border_radius }))
        }
        TypedShape::HeightField(field) => repaired_field(field).map(SharedShape::new),
        _ => None,
    }
}

fn repaired_hull(solid: &ConvexPolyhedron) -> Option<ConvexPolyhedron> {
    let (points, triangles) = solid.to_trimesh();
    let is_consistent = has_own_normals(solid) && !is_inside_out(&points, &triangles);
    if solid.faces().len() < 2 || is_consistent {
        return None;
    }
    let hull = convex_mesh(points, &triangles).or_else(|| convex_hull(solid.points()));
    hull.or_else(|| flat_hull(solid.points()))
}

/// Returns whether all normals are those of their faces, and point outward.
fn has_own_normals(solid: &ConvexPolyhedron) -> bool {
    let points = solid.points();
    let size = points.iter().map(|point| point.abs().max_element()).fold(0.0, Real::max);
    solid.faces().iter().all(|face| {
        let first = face.first_vertex_or_edge as usize;
        let count = face.num_vertices_or_edges as usize;
        let corners = &solid.vertices_adj_to_face()[first..first + count];
        let corner = |at: usize| points[corners[at % count] as usize];
        let sine_max = (MERGED_SINE_MAX * (count - 2) as Real).min(FACE_SINE_MAX);
        let mut area = Vector::ZERO;
        let is_plane = (0..count).all(|at| {
            let along = corner(at + 1) - corner(at);
            area += (corner(at) - corner(0)).cross(along);
            along.dot(face.normal).abs() <= sine_max * along.length() + ROUNDING * size
        });
        is_plane && area.dot(face.normal) >= -ROUNDING * size * size
    })
}

/// The same surface with a positive scale.
fn repaired_field(field: &HeightField) -> Option<HeightField> {
    let scale = field.scale();
    if scale.min_element() > 0.0 {
        return None;
    }
    let (rows, columns) = (field.nrows() + 1, field.ncols() + 1);
    let height = scale.y.signum() * if scale.y == 0.0 { 0.0 } else { 1.0 };
    let [flip_x, flip_z] = [scale.x, scale.z].map(|factor| factor < 0.0);
    let at = |index: usize, count: usize, flips: bool| {
        if flips { count - 1 - index } else { index }
    };
    let heights = Array2::from_fn(rows, columns, |i, j| {
        field.heights()[(at(i, rows, flip_z), at(j, columns, flip_x))] * height
    });
    let positive =
        Vector::new(scale.x.abs(), if height == 0.0 { 1.0 } else { scale.y.abs() }, scale.z.abs());
    let mut copy = HeightField::with_flags(heights, positive, field.flags());
    for i in 0..rows - 1 {
        for j in 0..columns - 1 {
            let cell = (at(i, rows - 1, flip_z), at(j, columns - 1, flip_x));
            let status = mirrored(field.cell_status(cell.0, cell.1), flip_x, flip_z);
            copy.set_cell_status(i, j, status);
        }
    }
    Some(copy)
}

/// The status of a mirrored cell. Each mirror exchanges the diagonals, and one along x the two triangles.
fn mirrored(
    mut status: HeightFieldCellStatus,
    flip_x: bool,
    flip_z: bool,
) -> HeightFieldCellStatus {
    use HeightFieldCellStatus as Status;
    if flip_x != flip_z {
        status.toggle(Status::ZIGZAG_SUBDIVISION);
    }
    if flip_x {
        let [left, right] = [Status::LEFT_TRIANGLE_REMOVED, Status::RIGHT_TRIANGLE_REMOVED];
        let removed = [left, right].map(|side| status.contains(side));
        status.set(left, removed[1]);
        status.set(right, removed[0]);
    }
    status
}

/// A copy of a mesh with consistent winding and normals; `None` if the mesh is consistent.
///
/// # Errors
/// If parry refuses the copy.
pub fn repaired_mesh(mesh: &TriMesh) -> Result<Option<TriMesh>, TriMeshBuilderError> {
    let Some(normals) = mesh.pseudo_normals() else { return Ok(None) };
    let (mut is_own, mut outward) = (true, 0.0);
    for (triangle, edges) in mesh.triangles().zip(&normals.edges_pseudo_normal) {
        let [a, b, c] = [triangle.a, triangle.b, triangle.c];
        let area = (b - a).cross(c - a);
        for (along, normal) in [b - a, c - b, a - c].into_iter().zip(edges) {
            outward += area.dot(*normal);
            is_own &= along.dot(*normal).abs() <= MERGED_SINE_MAX * along.length();
        }
    }
    let is_inside_out = mesh.flags().contains(TriMeshFlags::ORIENTED) && encloses_outside(mesh);
    let is_mirrored = outward < 0.0;
    if is_own && !is_mirrored && !is_inside_out {
        return Ok(None);
    }
    let flips = is_mirrored != (is_inside_out && !is_mirrored);
    let flip = |[a, b, c]: [u32; 3]| if flips { [a, c, b] } else { [a, b, c] };
    let indices = mesh.indices().iter().copied().map(flip).collect();
    TriMesh::with_flags(mesh.vertices().to_vec(), indices, mesh.flags()).map(Some)
}

/// Returns whether the triangles are closed and wound the wrong way.
fn encloses_outside(mesh: &TriMesh) -> bool {
    let mut sides = FastHashMap::<(u32, u32), i32>::default();
    for &[a, b, c] in mesh.indices() {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            *sides.entry((from.min(to), from.max(to))).or_default() +=
                if from < to { 1 } else { -1 };
        }
    }
    let is_closed = sides.values().all(|uses| *uses == 0);
    is_closed && is_inside_out(mesh.vertices(), mesh.indices())
}
