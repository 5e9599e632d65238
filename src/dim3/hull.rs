//! Convex polyhedra from points.
//!
//! parry finds hulls by quickhull, with tolerances for points about the size of the unit box. It merges
//! neighbouring triangles into faces by their angle alone, which dissolves a finely rounded surface. So
//! points are scaled to the unit box first, and a polyhedron whose faces came out crooked is made again from
//! fewer points.

use super::flat_hull::flat_hull;
use super::math::{Real, Vector};
use crate::base::guard::guarded;
use crate::base::hash::FastHashMap;
use parry::shape::ConvexPolyhedron;
use parry::transformation::try_convex_hull;
use parry::utils::remove_unused_points;

/// The type of convex hulls.
pub type ConvexShape = ConvexPolyhedron;

/// The reason why points have no hull.
pub const DEGENERATE_REASON: &str = "its points lie on a line, or too close to one";

/// Least thickness of a box of points that span a volume, as a fraction of its length.
const THICKNESS_FRACTION_MIN: Real = 1.0e-6;
/// A polyhedron with a smaller volume than this, in parts of its box, has none.
const VOLUME_MIN: Real = 1.0e-4;
/// Largest distance of the corners of a face from its plane, as a fraction of half the length of the box. The
/// tolerance of parry for merged triangles is 1.5°, so large faces reach it.
const CROOKEDNESS_MAX: Real = 0.1;
/// Half the number of steps along an edge of the cube of directions that [`thin_out`] uses, for each attempt:
/// some 400, 150 and 50 directions.
const DIRECTION_STEPS: [i8; 3] = [4, 2, 1];

/// The smallest convex polyhedron around finite points; `None` if they lie in a plane.
pub fn convex_hull(points: &[Vector]) -> Option<ConvexPolyhedron> {
    let frame = UnitBox::around(points)?;
    let scaled: Vec<Vector> = points.iter().map(|p| frame.scale(*p)).collect();
    let of_few = |steps: i8| {
        let few = thin_out(&scaled, steps);
        let originals: Vec<Vector> = few.iter().map(|i| points[*i]).collect();
        let scaled: Vec<Vector> = few.iter().map(|i| scaled[*i]).collect();
        hull_of_scaled(&scaled, &originals, &frame)
    };
    hull_of_scaled(&scaled, points, &frame).or_else(|| DIRECTION_STEPS.into_iter().find_map(of_few))
}

/// The polyhedron with the given finite corners and triangles, which must enclose a convex solid, all with
/// the same winding; a plate if they lie in a plane; `None` if they enclose nothing. The indices must be in
/// range.
pub fn convex_mesh(mut points: Vec<Vector>, triangles: &[[u32; 3]]) -> Option<ConvexPolyhedron> {
    let in_range = |corner: &u32| (*corner as usize) < points.len();
    if !triangles.iter().flatten().all(in_range) || !is_closed(triangles) {
        return None;
    }
    let mut triangles = triangles.to_vec();
    remove_unused_points(&mut points, &mut triangles); // They would count as corners of the solid.
    let Some(frame) = UnitBox::around(&points) else { return flat_hull(&points) };
    match solid(&points, &triangles, &frame) {
        Solid::Fine(solid) => Some(*solid),
        Solid::Empty => flat_hull(&points),
        Solid::Crooked => convex_hull(&points),
    }
}

/// The hull, with the corners taken from `originals`, which have the same order as `scaled`.
fn hull_of_scaled(
    scaled: &[Vector],
    originals: &[Vector],
    frame: &UnitBox,
) -> Option<ConvexPolyhedron> {
    let (corners, triangles) = guarded(|| try_convex_hull(scaled))?.ok()?;
    // The hull contains its corners' coordinates, not the indices of the points.
    let key = |p: &Vector| p.to_array().map(Real::to_bits);
    let by_place: FastHashMap<_, usize> =
        scaled.iter().enumerate().rev().map(|(i, p)| (key(p), i)).collect();
    let corners: Option<Vec<Vector>> =
        corners.iter().map(|c| by_place.get(&key(c)).map(|i| originals[*i])).collect();
    if !is_closed(&triangles) {
        return None;
    }
    match solid(&corners?, &triangles, frame) {
        Solid::Fine(solid) => Some(*solid),
        Solid::Empty | Solid::Crooked => None,
    }
}

/// Moves the box around some points to the origin and makes its half extents 1.
///
/// A different scale along each axis does not change which points are corners of the hull.
struct UnitBox {
    center: Vector,
    half_extents: Vector,
}

impl UnitBox {
    fn around(points: &[Vector]) -> Option<Self> {
        let lowest = points.iter().copied().reduce(Vector::min)?;
        let highest = points.iter().copied().reduce(Vector::max)?;
        let half_extents = (highest - lowest) * 0.5;
        let is_flat =
            half_extents.min_element() <= THICKNESS_FRACTION_MIN * half_extents.max_element();
        (!is_flat).then_some(Self { center: lowest + half_extents, half_extents })
    }

    fn scale(&self, point: Vector) -> Vector {
        (point - self.center) / self.half_extents
    }
}

/// New indices of corners and triangles.
enum Solid {
    Fine(Box<ConvexPolyhedron>),
    /// No volume.
    Empty,
    /// Triangles in different planes were merged into one face.
    Crooked,
}

fn solid(points: &[Vector], triangles: &[[u32; 3]], frame: &UnitBox) -> Solid {
    let scaled: Vec<Vector> = points.iter().map(|p| frame.scale(*p)).collect();
    let volume = signed_volume(&scaled, triangles);
    let triangles: Vec<[u32; 3]> = if volume < 0.0 {
        triangles.iter().map(|t| [t[0], t[2], t[1]]).collect()
    } else {
        triangles.to_vec()
    };
    if volume.abs() < 8.0 * VOLUME_MIN {
        return Solid::Empty;
    }
    let built = guarded(|| ConvexPolyhedron::from_convex_mesh(points.to_vec(), &triangles));
    match built.flatten() {
        Some(solid) if has_plane_faces(&solid, frame) => Solid::Fine(Box::new(solid)),
        _ => Solid::Crooked,
    }
}

/// Returns whether each side of a triangle is the reversed side of exactly one other triangle.
fn is_closed(triangles: &[[u32; 3]]) -> bool {
    let mut sides: FastHashMap<(u32, u32), bool> = FastHashMap::default();
    for &[a, b, c] in triangles {
        for side in [(a, b), (b, c), (c, a)] {
            if side.0 == side.1 || sides.insert(side, true).is_some() {
                return false;
            }
        }
    }
    triangles.iter().all(|&[a, b, c]| {
        [(b, a), (c, b), (a, c)].iter().all(|opposite| sides.contains_key(opposite))
    })
}

/// The volume that triangles enclose: positive if they are wound counter-clockwise seen from outside.
pub fn signed_volume(points: &[Vector], triangles: &[[u32; 3]]) -> Real {
    let tetrahedra = triangles.iter().map(|t| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        a.dot(b.cross(c))
    });
    tetrahedra.sum::<Real>() / 6.0
}

/// Returns whether all corners of each face lie in its plane. Two faces must be left: the sides of a thin
/// lens.
fn has_plane_faces(solid: &ConvexPolyhedron, frame: &UnitBox) -> bool {
    let tolerance = CROOKEDNESS_MAX * frame.half_extents.max_element();
    solid.faces().len() >= 2
        && solid.faces().iter().all(|face| {
            let first = face.first_vertex_or_edge as usize;
            let corners = first..first + face.num_vertices_or_edges as usize;
            let corners = &solid.vertices_adj_to_face()[corners];
            let origin = solid.points()[corners[0] as usize];
            corners.iter().all(|corner| {
                let corner = solid.points()[*corner as usize];
                (corner - origin).dot(face.normal).abs() <= tolerance
            })
        })
}

/// The outermost points in directions spread over the sphere, `2 steps + 1` along each edge of a cube,
/// in rising order.
fn thin_out(scaled: &[Vector], steps: i8) -> Vec<usize> {
    let along = |step: i8| Real::from(step) / Real::from(steps);
    let mut directions = Vec::new();
    for u in (-steps..=steps).map(along) {
        for v in (-steps..=steps).map(along) {
            for side in [1.0, -1.0] {
                directions.push(Vector::new(side, u, v));
                directions.push(Vector::new(u, side, v));
                directions.push(Vector::new(u, v, side));
            }
        }
    }
    let mut found: Vec<usize> = directions
        .into_iter()
        .filter_map(|direction| {
            let reach = |i: &usize| scaled[*i].dot(direction);
            (0..scaled.len()).max_by(|i, j| reach(i).total_cmp(&reach(j)).then(j.cmp(i)))
        })
        .collect();
    found.sort_unstable();
    found.dedup();
    found
}
