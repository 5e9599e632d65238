//! Elements of shapes that exist in three dimensions only, and their mass distribution.

use super::hull::signed_volume;
use super::mass::{mass_from_moments, no_mass, principal_axes, second_moment};
use super::math::{Matrix, Real, Rotation, Vector};
use crate::base::measure::Measure;
use crate::base::trig::sin_cos;
use arrayvec::ArrayVec;
use parry::mass_properties::MassProperties;
use parry::shape::{ConvexPolyhedron, Cylinder, RoundShape, Shape, TypedShape};
use parry::transformation::voxelization::VoxelSet;
use smallvec::{SmallVec, smallvec};

/// A volume below this fraction of the products of edges that it is the sum of is rounding: a flat surface.
const ROUNDING: Real = 4.0 * Real::EPSILON;
/// The volume from which a polyhedron counts as inside out, as a fraction of its size cubed.
const INVERSION_MIN: Real = 64.0 * Real::EPSILON;

/// The numbers that a shape is made of, for the shapes whose type depends on the dimension; nothing
/// for the others.
pub fn measures(shape: TypedShape<'_>) -> SmallVec<[Measure<'_>; 4]> {
    use Measure::{Coordinates, Lengths, Margin, Point, Points, Size};
    let cylinder =
        |c: &Cylinder| smallvec![Size("half_height", c.half_height), Size("radius", c.radius)];
    let (mut inner, border): (SmallVec<[Measure<'_>; 4]>, _) = match shape {
        TypedShape::Cylinder(c) => return cylinder(c),
        TypedShape::RoundCylinder(c) => (cylinder(&c.inner_shape), c.border_radius),
        TypedShape::Cone(c) => {
            return smallvec![Size("half_height", c.half_height), Size("radius", c.radius)];
        }
        TypedShape::RoundCone(c) => {
            let cone = &c.inner_shape;
            let inner =
                smallvec![Size("half_height", cone.half_height), Size("radius", cone.radius)];
            (inner, c.border_radius)
        }
        TypedShape::ConvexPolyhedron(c) => return smallvec![Points("points", c.points())],
        TypedShape::RoundConvexPolyhedron(c) => {
            (smallvec![Points("points", c.inner_shape.points())], c.border_radius)
        }
        TypedShape::HeightField(h) => {
            let heights = Coordinates("heights", h.heights().data());
            // Negative factors mirror, and the heights may be scaled to zero.
            let sides = h.scale().abs().with_y(1.0);
            return smallvec![heights, Point("scale", h.scale()), Lengths("scale", sides)];
        }
        _ => return SmallVec::new(),
    };
    inner.push(Margin("border_radius", border));
    inner
}

/// The sharp shape inside a round one, and the thickness of the layer around it; `None` for other shapes.
pub fn core_of_round(shape: TypedShape<'_>) -> Option<(&dyn Shape, Real)> {
    match shape {
        TypedShape::RoundCuboid(s) => Some((&s.inner_shape, s.border_radius)),
        TypedShape::RoundTriangle(s) => Some((&s.inner_shape, s.border_radius)),
        TypedShape::RoundCylinder(s) => Some((&s.inner_shape, s.border_radius)),
        TypedShape::RoundCone(s) => Some((&s.inner_shape, s.border_radius)),
        TypedShape::RoundConvexPolyhedron(s) => Some((&s.inner_shape, s.border_radius)),
        _ => None,
    }
}

/// Returns the reason why a convex shape cannot collide, if there is one: its kind and its defect.
///
/// Two faces back to back are a plate, which collides on both sides.
pub fn convex_defect(shape: TypedShape<'_>) -> Option<(&'static str, &'static str)> {
    let solid = match shape {
        TypedShape::ConvexPolyhedron(solid) => solid,
        TypedShape::RoundConvexPolyhedron(round) => &round.inner_shape,
        _ => return None,
    };
    if solid.faces().len() < 2 {
        return Some(("convex polyhedron", "its corners lie on a line, or its faces have no area"));
    }
    let (corners, triangles) = solid.to_trimesh();
    is_inside_out(&corners, &triangles)
        .then_some(("convex polyhedron", "its faces point toward the inside"))
}

/// Returns whether closed triangles are wound clockwise, seen from outside.
pub fn is_inside_out(corners: &[Vector], triangles: &[[u32; 3]]) -> bool {
    let Some(&origin) = corners.first() else { return false };
    let corners: Vec<Vector> = corners.iter().map(|corner| *corner - origin).collect();
    let size = farthest_point(&corners, Vector::ZERO);
    // The faces of a plate enclose nothing but rounding.
    signed_volume(&corners, triangles) < -INVERSION_MIN * size.powi(3)
}

/// The surface of this dimension's shapes without volume, as elements with the given corners.
pub fn for_each_element(shape: TypedShape<'_>, mut visit: impl FnMut(&[Vector])) {
    let mut triangle = |corners: [Vector; 3]| visit(&corners);
    match shape {
        TypedShape::HeightField(field) => {
            field.triangles().for_each(|t| triangle([t.a, t.b, t.c]));
        }
        TypedShape::TriMesh(mesh) => mesh.triangles().for_each(|t| triangle([t.a, t.b, t.c])),
        TypedShape::Triangle(t) => triangle([t.a, t.b, t.c]),
        TypedShape::RoundTriangle(t) => {
            let t = &t.inner_shape;
            triangle([t.a, t.b, t.c]);
        }
        TypedShape::Cuboid(c) => for_each_element_of_box(c.half_extents, visit),
        TypedShape::RoundCuboid(c) => for_each_element_of_box(c.inner_shape.half_extents, visit),
        TypedShape::Cylinder(c) => for_each_element_of_disc(c.half_height, c.radius, visit),
        TypedShape::RoundCylinder(RoundShape { inner_shape: c, .. }) => {
            for_each_element_of_disc(c.half_height, c.radius, visit);
        }
        TypedShape::Cone(c) => for_each_element_of_disc(c.half_height, c.radius, visit),
        TypedShape::RoundCone(RoundShape { inner_shape: c, .. }) => {
            for_each_element_of_disc(c.half_height, c.radius, visit);
        }
        TypedShape::ConvexPolyhedron(solid) => for_each_triangle_of_plate(solid, triangle),
        TypedShape::RoundConvexPolyhedron(round) => {
            for_each_triangle_of_plate(&round.inner_shape, triangle);
        }
        _ => {}
    }
}

/// The two triangles of a box without height, or the segment of one with a length alone.
fn for_each_element_of_box(half: Vector, mut visit: impl FnMut(&[Vector])) {
    let edges = Vector::AXES.map(|axis| axis * half).into_iter();
    let edges: ArrayVec<Vector, 3> = edges.filter(|edge| *edge != Vector::ZERO).collect();
    match edges[..] {
        [edge] => visit(&[-edge, edge]),
        [u, v] => {
            visit(&[-u - v, u - v, u + v]);
            visit(&[-u - v, u + v, v - u]);
        }
        _ => {}
    }
}

/// Number of triangles of a disc.
const DISC_TRIANGLES: usize = 32;

/// The triangles of a cylinder or cone without height, of the same area, or the segment of one without
/// radius.
fn for_each_element_of_disc(half_height: Real, radius: Real, mut visit: impl FnMut(&[Vector])) {
    if radius == 0.0 {
        return visit(&[-Vector::Y * half_height, Vector::Y * half_height]);
    }
    let angle = core::f64::consts::TAU as Real / DISC_TRIANGLES as Real;
    let reach = radius * (angle / sin_cos(angle).0).sqrt();
    let rim = |k: usize| {
        let (sine, cosine) = sin_cos(k as Real * angle);
        Vector::new(cosine, 0.0, sine) * reach
    };
    (0..DISC_TRIANGLES).for_each(|k| visit(&[Vector::ZERO, rim(k), rim(k + 1)]));
}

/// The triangles of one side of a hull without volume.
fn for_each_triangle_of_plate(plate: &ConvexPolyhedron, mut visit: impl FnMut([Vector; 3])) {
    let Some(first) = plate.faces().first() else { return };
    for face in plate.faces().iter().filter(|face| face.normal.dot(first.normal) > 0.0) {
        let start = face.first_vertex_or_edge as usize;
        let corners = start..start + face.num_vertices_or_edges as usize;
        let corners = &plate.vertices_adj_to_face()[corners];
        for pair in corners[1..].windows(2) {
            visit([corners[0], pair[0], pair[1]].map(|i| plate.points()[i as usize]));
        }
    }
}

/// Largest distance from `center` to any point of the shape, exactly, for those of this dimension's
/// shapes where that is easy.
pub fn farthest(shape: TypedShape<'_>, center: Vector) -> Option<Real> {
    match shape {
        TypedShape::Cylinder(c) => Some(farthest_of_cylinder(c, center)),
        TypedShape::RoundCylinder(c) => {
            Some(farthest_of_cylinder(&c.inner_shape, center) + c.border_radius)
        }
        TypedShape::ConvexPolyhedron(c) => Some(farthest_point(c.points(), center)),
        TypedShape::RoundConvexPolyhedron(c) => {
            Some(farthest_point(c.inner_shape.points(), center) + c.border_radius)
        }
        _ => None,
    }
}

fn farthest_of_cylinder(cylinder: &Cylinder, center: Vector) -> Real {
    let across = Vector::new(center.x, 0.0, center.z).length() + cylinder.radius;
    let along = center.y.abs() + cylinder.half_height;
    (across * across + along * along).sqrt()
}

fn farthest_point(points: &[Vector], center: Vector) -> Real {
    points.iter().map(|p| p.distance_squared(center)).fold(0.0, Real::max).sqrt()
}

/// Returns whether the shape is one of this dimension's shapes without thickness.
pub fn is_plate(shape: TypedShape<'_>) -> bool {
    match shape {
        TypedShape::Triangle(_) => true,
        TypedShape::RoundCuboid(c) => {
            c.border_radius == 0.0 && c.inner_shape.half_extents.min_element() == 0.0
        }
        TypedShape::Cylinder(c) => c.half_height == 0.0 || c.radius == 0.0,
        TypedShape::Cone(c) => c.half_height == 0.0 || c.radius == 0.0,
        // Two faces enclose a volume nowhere. Their normals are opposite but for rounding.
        TypedShape::ConvexPolyhedron(solid) => solid.faces().len() == 2,
        _ => false,
    }
}

/// Returns whether the shape is one of this dimension's shapes that can roll.
pub fn has_curved_surface(shape: TypedShape<'_>) -> bool {
    matches!(
        shape,
        TypedShape::Cylinder(_)
            | TypedShape::Cone(_)
            | TypedShape::RoundCylinder(_)
            | TypedShape::RoundCone(_)
            | TypedShape::RoundConvexPolyhedron(_)
    )
}

/// Mass properties of the shapes for which parry finds the principal axes with trigonometric functions. The
/// last bits of these functions differ between machines. `None` for the others.
pub fn mass_properties(shape: TypedShape<'_>, density: Real) -> Option<MassProperties> {
    let polyhedron = |solid: &ConvexPolyhedron| {
        let (vertices, triangles) = solid.to_trimesh();
        mass_inside(&vertices, &triangles, density)
    };
    match shape {
        TypedShape::ConvexPolyhedron(solid) => Some(polyhedron(solid)),
        TypedShape::RoundConvexPolyhedron(round) => Some(polyhedron(&round.inner_shape)),
        TypedShape::TriMesh(mesh) => Some(mass_inside(mesh.vertices(), mesh.indices(), density)),
        _ => None,
    }
}

/// Mass properties of the solid that triangles enclose, in either orientation; none if they enclose nothing.
/// For an open mesh, the result is that of the solid between its triangles and its first vertex.
///
/// The solid is summed up from tetrahedra with their tips at one vertex. About its tip, the second moments of
/// a tetrahedron of volume `V` and edges `a, b, c` are `V/20 (a aᵀ + b bᵀ + c cᵀ + s sᵀ)`, `s = a + b + c`.
/// Source: Blow and Binstock, "How to find the inertia tensor (or other mass properties) of a 3D solid body
/// represented by a triangle mesh" (2004).
fn mass_inside(vertices: &[Vector], triangles: &[[u32; 3]], density: Real) -> MassProperties {
    let Some(&tip) = vertices.first() else { return no_mass() };
    let (mut volume, mut moment, mut second) = (0.0, Vector::ZERO, Matrix::ZERO);
    let mut magnitude = 0.0;
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| vertices[i as usize] - tip);
        let sum = a + b + c;
        let part = a.dot(b.cross(c)) / 6.0;
        volume += part;
        magnitude += a.length() * b.length() * c.length();
        moment += sum * (part / 4.0);
        second += [a, b, c, sum].map(second_moment).into_iter().sum::<Matrix>() * (part / 20.0);
    }
    let mass = volume.abs() * density;
    if mass <= 0.0 || volume.abs() <= ROUNDING * magnitude {
        return no_mass();
    }
    let com = moment / volume;
    // About the centre of mass (parallel axes), and positive for either winding.
    let second = (second - second_moment(com) * volume) * (density * volume.signum());
    mass_from_moments(tip + com, mass, second)
}

/// The surface of triangles in the form of parry's convex decomposition: in 3D the triangles themselves.
pub fn surface_of(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    triangles.to_vec()
}

/// A rotation to the directions in which some points, not none, are spread out most and least.
pub fn spread_directions(points: &[Vector]) -> Rotation {
    let center = points.iter().copied().sum::<Vector>() / points.len() as Real;
    let spread = points.iter().fold(Matrix::ZERO, |sum, p| sum + second_moment(*p - center));
    Rotation::from_mat3(&principal_axes(spread).1).normalize()
}

/// The convex hull of the part of a surface that lies in one piece of its convex decomposition.
pub fn exact_hull(
    part: &VoxelSet,
    vertices: &[Vector],
    triangles: &[[u32; 3]],
) -> Option<ConvexPolyhedron> {
    let (corners, _) = part.compute_exact_convex_hull(vertices, triangles);
    super::hull::convex_hull(&corners)
}

/// Dimension-specific data of common tests.
#[cfg(test)]
pub mod tests {
    use crate::dim::math::{Real, Rotation, Vector};
    use parry::mass_properties::MassProperties;
    use parry::shape::Cuboid;
    use parry::shape::SharedShape;

    /// A closed surface around the box of half extents 1, of the elements that surfaces consist of.
    pub fn unit_box_surface() -> (Vec<Vector>, Vec<[u32; 3]>) {
        Cuboid::new(Vector::ONE).to_trimesh()
    }

    /// Triangles that make up the box of half extents 1.
    pub fn unit_box_mesh() -> (Vec<Vector>, Vec<[u32; 3]>) {
        unit_box_surface()
    }

    /// Solid convex shapes that only this dimension has.
    pub fn solids() -> Vec<SharedShape> {
        let sizes = [[0.5, 0.02], [0.02, 0.5], [0.3, 0.3]];
        let of = |[half_height, radius]: [Real; 2]| {
            [
                SharedShape::cylinder(half_height, radius),
                SharedShape::cone(half_height, radius),
                SharedShape::round_cylinder(half_height, radius, 0.05),
                SharedShape::round_cone(half_height, radius, 0.05),
            ]
        };
        sizes.into_iter().flat_map(of).collect()
    }

    /// The components of the inertia tensor about the centre of mass.
    pub fn inertia_components(properties: &MassProperties) -> Vec<Real> {
        properties.reconstruct_inertia_matrix().to_cols_array().to_vec()
    }

    /// A rotation that is not one, with all components scaled.
    pub fn scaled_rotation(rotation: Rotation, scale: Real) -> Rotation {
        rotation * scale
    }
}
