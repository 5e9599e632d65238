//! Elements of shapes that exist in two dimensions only, and their mass distribution.

use super::mass::no_mass;
use super::math::{Real, Rotation, Vector};
use crate::base::hash::FastHashMap;
use crate::base::measure::Measure;
use parry::mass_properties::MassProperties;
use parry::shape::{ConvexPolygon, Polyline, RoundShape, Shape, Triangle, TypedShape};
use parry::transformation::voxelization::VoxelSet;
use smallvec::{SmallVec, smallvec};

/// The normals by which a polyline decides its inside; `None` if it has none.
#[cfg(not(feature = "parry026"))]
pub fn polyline_normals(line: &Polyline) -> Option<&[Vector]> {
    line.pseudo_normals()
}

/// Polylines of parry 0.26 have no normals.
#[cfg(feature = "parry026")]
pub fn polyline_normals(_line: &Polyline) -> Option<&[Vector]> {
    None
}

/// The numbers that a shape is made of, for the shapes whose type depends on the dimension; nothing
/// for the others.
pub fn measures(shape: TypedShape<'_>) -> SmallVec<[Measure<'_>; 4]> {
    use Measure::{Coordinates, Lengths, Margin, Point, Points};
    match shape {
        TypedShape::ConvexPolygon(c) => smallvec![Points("points", c.points())],
        TypedShape::RoundConvexPolygon(c) => smallvec![
            Points("points", c.inner_shape.points()),
            Margin("border_radius", c.border_radius)
        ],
        TypedShape::HeightField(h) => {
            // A negative factor mirrors, and the heights may be scaled to zero.
            smallvec![
                Coordinates("heights", h.heights()),
                Point("scale", h.scale()),
                Lengths("scale", h.scale().abs().with_y(1.0))
            ]
        }
        _ => SmallVec::new(),
    }
}

/// A polygon with a smaller area than this, as a fraction of its squared size, has none.
const AREA_MIN: Real = 1.0e-6;

/// The sharp shape inside a round one, and the thickness of the layer around it; `None` for other shapes.
pub fn core_of_round(shape: TypedShape<'_>) -> Option<(&dyn Shape, Real)> {
    match shape {
        TypedShape::RoundCuboid(s) => Some((&s.inner_shape, s.border_radius)),
        TypedShape::RoundTriangle(s) => Some((&s.inner_shape, s.border_radius)),
        TypedShape::RoundConvexPolygon(s) => Some((&s.inner_shape, s.border_radius)),
        _ => None,
    }
}

/// Returns the reason why a convex shape cannot collide, if there is one: its kind and its defect.
pub fn convex_defect(shape: TypedShape<'_>) -> Option<(&'static str, &'static str)> {
    let polygon = match shape {
        TypedShape::ConvexPolygon(polygon) => polygon,
        TypedShape::RoundConvexPolygon(round) => &round.inner_shape,
        _ => return None,
    };
    let points = polygon.points();
    let origin = *points.first()?;
    let fan = points.windows(2).map(|side| (side[0] - origin).perp_dot(side[1] - origin));
    let (area, size) = (0.5 * fan.sum::<Real>(), farthest_point(points, origin));
    let least = AREA_MIN * size * size;
    let reason = if area < -least {
        "its corners run clockwise"
    } else if area < least {
        "its corners lie on a line"
    } else {
        return None;
    };
    Some(("convex polygon", reason))
}

/// The surface of this dimension's shapes without volume, as elements with the given corners.
pub fn for_each_element(shape: TypedShape<'_>, mut visit: impl FnMut(&[Vector])) {
    match shape {
        TypedShape::HeightField(field) => {
            field.segments().for_each(|segment| visit(&[segment.a, segment.b]));
        }
        TypedShape::Cuboid(c) => visit(&[-c.half_extents, c.half_extents]),
        TypedShape::RoundCuboid(RoundShape { inner_shape: c, .. }) => {
            visit(&[-c.half_extents, c.half_extents]);
        }
        TypedShape::Triangle(t) => visit(&[t.a, t.b, t.c]),
        TypedShape::RoundTriangle(RoundShape { inner_shape: t, .. }) => visit(&[t.a, t.b, t.c]),
        _ => {}
    }
}

/// Largest distance from `center` to any point of the shape, exactly, for those of this dimension's
/// shapes where that is easy.
pub fn farthest(shape: TypedShape<'_>, center: Vector) -> Option<Real> {
    match shape {
        TypedShape::ConvexPolygon(c) => Some(farthest_point(c.points(), center)),
        TypedShape::RoundConvexPolygon(c) => {
            Some(farthest_point(c.inner_shape.points(), center) + c.border_radius)
        }
        _ => None,
    }
}

fn farthest_point(points: &[Vector], center: Vector) -> Real {
    points.iter().map(|p| p.distance_squared(center)).fold(0.0, Real::max).sqrt()
}

/// Returns whether the shape is one of this dimension's shapes without thickness.
pub fn is_plate(shape: TypedShape<'_>) -> bool {
    let border = |round: Real, half: Vector| round == 0.0 && half.min_element() == 0.0;
    match shape {
        TypedShape::RoundCuboid(c) => border(c.border_radius, c.inner_shape.half_extents),
        TypedShape::Triangle(t) => (t.b - t.a).perp_dot(t.c - t.a) == 0.0,
        _ => false,
    }
}

/// Returns whether the shape is one of this dimension's shapes that can roll.
pub fn has_curved_surface(shape: TypedShape<'_>) -> bool {
    matches!(shape, TypedShape::RoundConvexPolygon(_))
}

/// Mass properties of the shapes for which parry's inertia is not about the centre of mass; `None` for
/// the others.
pub fn mass_properties(shape: TypedShape<'_>, density: Real) -> Option<MassProperties> {
    let one = |t: &Triangle| mass_covered(&[t.a, t.b, t.c], &[[0, 1, 2]], density);
    match shape {
        TypedShape::Triangle(triangle) => Some(one(triangle)),
        TypedShape::RoundTriangle(round) => Some(one(&round.inner_shape)),
        TypedShape::TriMesh(mesh) => Some(mass_covered(mesh.vertices(), mesh.indices(), density)),
        _ => None,
    }
}

/// Mass properties of the union of triangles of any orientation.
///
/// About the origin, the second moment of a triangle of area `A` and corners `a, b, c` is
/// `A/12 (a² + b² + c² + s²)`, `s = a + b + c`.
fn mass_covered(vertices: &[Vector], triangles: &[[u32; 3]], density: Real) -> MassProperties {
    let Some(&origin) = vertices.first() else { return no_mass() };
    let (mut area, mut moment, mut second) = (0.0, Vector::ZERO, 0.0);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| vertices[i as usize] - origin);
        let sum = a + b + c;
        let part = 0.5 * (b - a).perp_dot(c - a).abs();
        let squares = a.length_squared() + b.length_squared() + c.length_squared();
        area += part;
        moment += sum * (part / 3.0);
        second += (squares + sum.length_squared()) * (part / 12.0);
    }
    if area * density <= 0.0 {
        return no_mass();
    }
    let com = moment / area;
    let inertia = (second - area * com.length_squared()).max(0.0) * density;
    MassProperties::new(origin + com, area * density, inertia)
}

/// The surface of the union of triangles, in the form of parry's convex decomposition. In 2D these are the
/// sides that belong to one triangle alone, in its orientation.
pub fn surface_of(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let sides = || triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let ordered = |[a, b]: [u32; 2]| (a.min(b), a.max(b));
    let mut uses: FastHashMap<(u32, u32), u32> = FastHashMap::default();
    for side in sides() {
        *uses.entry(ordered(side)).or_default() += 1;
    }
    sides().filter(|side| uses[&ordered(*side)] == 1).collect()
}

/// A rotation to the directions in which some points, not none, are spread out most and least.
///
/// Jacobi's rotation makes the second moments diagonal. Its tangent is `t = 1 / (h + sign(h) √(h² + 1))`, `h
/// = (m_yy - m_xx) / 2 m_xy`.
pub fn spread_directions(points: &[Vector]) -> Rotation {
    let center = points.iter().copied().sum::<Vector>() / points.len() as Real;
    let offsets = || points.iter().map(|p| *p - center);
    let mixed: Real = offsets().map(|v| v.x * v.y).sum();
    if mixed == 0.0 {
        return Rotation::IDENTITY;
    }
    let difference: Real = offsets().map(|v| v.y * v.y - v.x * v.x).sum();
    let h = difference / (2.0 * mixed);
    let tangent = 1.0 / (h + (h * h + 1.0).sqrt().copysign(h));
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    Rotation::from_cos_sin_unchecked(cosine, -tangent * cosine)
}

/// The convex hull of the part of a surface that lies in one piece of its convex decomposition.
pub fn exact_hull(
    part: &VoxelSet,
    vertices: &[Vector],
    segments: &[[u32; 2]],
) -> Option<ConvexPolygon> {
    super::hull::convex_hull(&part.compute_exact_convex_hull(vertices, segments))
}

/// Dimension-specific data of common tests.
#[cfg(test)]
pub mod tests {
    use crate::dim::math::{Real, Rotation, Vector};
    use parry::mass_properties::MassProperties;
    use parry::shape::SharedShape;

    /// A closed surface around the box of half extents 1, of the elements that surfaces consist of.
    pub fn unit_box_surface() -> (Vec<Vector>, Vec<[u32; 2]>) {
        (unit_box_mesh().0, vec![[0, 1], [1, 2], [2, 3], [3, 0]])
    }

    /// Triangles that make up the box of half extents 1.
    pub fn unit_box_mesh() -> (Vec<Vector>, Vec<[u32; 3]>) {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(Vector::from_array);
        (corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]])
    }

    /// Solid convex shapes that only this dimension has.
    pub fn solids() -> Vec<SharedShape> {
        Vec::new()
    }

    /// The components of the inertia tensor about the centre of mass, which has one.
    pub fn inertia_components(properties: &MassProperties) -> Vec<Real> {
        vec![properties.principal_inertia()]
    }

    /// A rotation that is not one, with all components scaled.
    pub fn scaled_rotation(rotation: Rotation, scale: Real) -> Rotation {
        Rotation::from_cos_sin_unchecked(rotation.cos() * scale, rotation.sin() * scale)
    }
}
