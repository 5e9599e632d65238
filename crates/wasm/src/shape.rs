//! Shapes: made from numbers and lists, and described by them.
//!
//! The scratch block holds vectors in places 0 to 2 (half extents, corners, normal, scale), and in place 3
//! radius, half height and border radius.

use crate::decomposition;
use crate::fault::{Fault, finite};
use crate::memory::{
    self, Single, number, put_integers, put_number, put_reals, put_vector, vector,
};
use crate::rapier::geometry::{ColliderBuilder, SharedShape, TriMeshFlags, TypedShape};
use crate::rapier::math::{DIM, Pose, Real, Vector};
use crate::rapier::parry::math::IVector;
use crate::rapier::parry::shape::{Compound, CompoundFlags, PolylineFlags};
use crate::registry::Registry;
use core::fmt::Display;

/// The kinds of shapes: the numbers of `Code` in TypeScript.
#[allow(dead_code, reason = "two dimensions have fewer shapes")]
pub mod kind {
    pub const BALL: u32 = 0;
    pub const CUBOID: u32 = 1;
    pub const CAPSULE: u32 = 2;
    pub const SEGMENT: u32 = 3;
    pub const POLYLINE: u32 = 4;
    pub const TRIANGLE: u32 = 5;
    pub const TRIMESH: u32 = 6;
    pub const HEIGHTFIELD: u32 = 7;
    pub const COMPOUND: u32 = 8;
    pub const CONVEX: u32 = 9;
    pub const CYLINDER: u32 = 10;
    pub const CONE: u32 = 11;
    pub const ROUND_CUBOID: u32 = 12;
    pub const ROUND_TRIANGLE: u32 = 13;
    pub const ROUND_CYLINDER: u32 = 14;
    pub const ROUND_CONE: u32 = 15;
    pub const ROUND_CONVEX: u32 = 16;
    pub const HALFSPACE: u32 = 17;
    pub const VOXELS: u32 = 18;
    pub const DECOMPOSITION: u32 = 19;
    pub const UNKNOWN: u32 = 99;
}

/// The place of radius, half height and border radius.
const SIZES: usize = 3;
const RADIUS: usize = 0;
const HALF_HEIGHT: usize = 1;
const BORDER: usize = 2;

static SHAPES: Single<Registry<SharedShape>> = Single::new(Registry::new());

/// The shape of a number.
pub fn shape(number: u32) -> Result<SharedShape, Fault> {
    // SAFETY: the reference ends with the statement.
    unsafe { SHAPES.get().get(number) }.cloned().ok_or_else(|| Fault::freed("shape"))
}

fn register(shape: SharedShape) -> u32 {
    // SAFETY: the reference ends with the statement.
    unsafe { SHAPES.get().insert(shape) }
}

fn radius() -> Real {
    number(SIZES, RADIUS)
}

fn half_height() -> Real {
    number(SIZES, HALF_HEIGHT)
}

fn border() -> Real {
    number(SIZES, BORDER)
}

/// The optional indices of a list.
fn optional_groups<const N: usize>(given: bool) -> Result<Option<Vec<[u32; N]>>, Fault> {
    given.then(|| memory::groups("indices")).transpose()
}

/// The outward normal of a half-space, with unit length.
fn normal() -> Result<Vector, Fault> {
    Ok(memory::direction(0, "normal")?.normalize())
}

/// A shape of both dimensions. `indexed` is set if there are indices.
fn builder(kind: u32, flags: u32, indexed: bool) -> Result<ColliderBuilder, Fault> {
    Ok(match kind {
        kind::BALL => ColliderBuilder::ball(radius()),
        kind::CAPSULE => ColliderBuilder::capsule_y(half_height(), radius()),
        kind::SEGMENT => ColliderBuilder::segment(vector(0, "a")?, vector(1, "b")?),
        kind::TRIANGLE => {
            ColliderBuilder::triangle(vector(0, "a")?, vector(1, "b")?, vector(2, "c")?)
        }
        kind::ROUND_TRIANGLE => ColliderBuilder::round_triangle(
            vector(0, "a")?,
            vector(1, "b")?,
            vector(2, "c")?,
            border(),
        ),
        kind::HALFSPACE => ColliderBuilder::halfspace(normal()?),
        kind::POLYLINE => {
            let flags = PolylineFlags::from_bits_truncate(flags as _);
            ColliderBuilder::polyline_with_flags(
                memory::vectors("vertices")?,
                optional_groups(indexed)?,
                flags,
            )
        }
        kind::TRIMESH => {
            let flags = TriMeshFlags::from_bits_truncate(flags as _);
            let indices = memory::groups("indices")?;
            ColliderBuilder::trimesh_with_flags(memory::vectors("vertices")?, indices, flags)
                .map_err(Fault::invalid)?
        }
        kind::COMPOUND => ColliderBuilder::compound(parts()?),
        kind::VOXELS => voxels(indexed)?,
        kind::DECOMPOSITION => decomposition::builder()?,
        _ => dimension::builder(kind, flags, indexed)?,
    })
}

/// The parts of a compound: the integers are shapes, the real numbers their poses.
fn parts() -> Result<Vec<(Pose, SharedShape)>, Fault> {
    let (shapes, poses) = (memory::integers(), memory::reals());
    let stride = poses.len() / shapes.len().max(1);
    let mut parts = Vec::with_capacity(shapes.len());
    for (number, numbers) in shapes.into_iter().zip(poses.chunks_exact(stride.max(1))) {
        for (at, value) in numbers.iter().enumerate() {
            let (place, component) = if at < DIM { (0, at) } else { (1, at - DIM) };
            put_number(place, component, *value);
        }
        parts.push((memory::pose(0)?, shape(number)?));
    }
    Ok(parts)
}

/// Gives a compound its flags. Other shapes have constructors with flags.
fn with_compound_flags(shape: SharedShape, flags: u32) -> SharedShape {
    let flags = CompoundFlags::from_bits_truncate(flags as _);
    match shape.as_compound() {
        Some(compound) if !flags.is_empty() => {
            SharedShape::new(Compound::with_flags(compound.shapes().to_vec(), flags, None))
        }
        _ => shape,
    }
}

/// Voxels at grid coordinates (integers) or around points (real numbers).
fn voxels(by_coordinates: bool) -> Result<ColliderBuilder, Fault> {
    let size = vector(0, "voxelSize")?;
    for value in size.to_array() {
        if value <= 0.0 {
            return Err(Fault::number("voxelSize", value.into(), "greater than 0"));
        }
    }
    if !by_coordinates {
        return Ok(ColliderBuilder::voxels_from_points(size, &memory::vectors("voxels")?));
    }
    let cells = memory::groups::<DIM>("voxels")?
        .into_iter()
        .map(|cell| IVector::from_array(cell.map(|c| c as i32 as _)));
    Ok(ColliderBuilder::voxels(size, &cells.collect::<Vec<_>>()))
}

/// The shapes of 2D.
#[cfg(feature = "dim2")]
mod dimension {
    use super::{
        BORDER, Fault, SIZES, border, kind, memory, put_number, put_reals, put_vector, vector,
    };
    use crate::rapier::geometry::{ColliderBuilder, SharedShape, TypedShape};
    use crate::rapier::math::Real;

    pub fn builder(kind: u32, flags: u32, _indexed: bool) -> Result<ColliderBuilder, Fault> {
        let skip_hull = flags & 1 != 0;
        Ok(match kind {
            kind::CUBOID => {
                let extents = vector(0, "halfExtents")?;
                ColliderBuilder::cuboid(extents.x, extents.y)
            }
            kind::ROUND_CUBOID => {
                let extents = vector(0, "halfExtents")?;
                ColliderBuilder::round_cuboid(extents.x, extents.y, border())
            }
            kind::HEIGHTFIELD => ColliderBuilder::heightfield(memory::reals(), vector(0, "scale")?),
            kind::CONVEX if skip_hull => {
                ColliderBuilder::try_convex_polyline(memory::vectors("vertices")?)
                    .map_err(Fault::invalid)?
            }
            kind::CONVEX => ColliderBuilder::try_convex_hull(&memory::vectors("points")?)
                .map_err(Fault::invalid)?,
            kind::ROUND_CONVEX if skip_hull => {
                let points = memory::vectors("vertices")?;
                ColliderBuilder::round_convex_polyline(points, border())
                    .ok_or_else(|| Fault::invalid("the vertices of the round convex polygon are not those of a convex outline with an area"))?
            }
            kind::ROUND_CONVEX => {
                ColliderBuilder::try_round_convex_hull(&memory::vectors("points")?, border())
                    .map_err(Fault::invalid)?
            }
            _ => return Err(Fault::number("the shape type", kind.into(), "a ShapeType")),
        })
    }

    /// Writes the numbers of a shape that only this dimension has.
    pub fn describe(shape: &SharedShape) -> u32 {
        let put_points = |points: &[crate::rapier::math::Vector]| {
            put_reals(points.iter().flat_map(|point| point.to_array()))
        };
        match shape.as_typed_shape() {
            TypedShape::HeightField(field) => {
                put_vector(0, field.scale());
                put_reals(field.heights().iter().map(|height| *height as Real));
                kind::HEIGHTFIELD
            }
            TypedShape::ConvexPolygon(polygon) => {
                put_points(polygon.points());
                kind::CONVEX
            }
            TypedShape::RoundConvexPolygon(polygon) => {
                put_points(polygon.inner_shape.points());
                put_number(SIZES, BORDER, polygon.border_radius);
                kind::ROUND_CONVEX
            }
            _ => kind::UNKNOWN,
        }
    }
}

/// The shapes of 3D.
#[cfg(not(feature = "dim2"))]
mod dimension {
    use super::{
        BORDER, Fault, HALF_HEIGHT, RADIUS, SIZES, border, half_height, kind, memory,
        optional_groups, put_integers, put_number, put_reals, put_vector, radius, vector,
    };
    use crate::rapier::geometry::{
        Array2, ColliderBuilder, ConvexPolyhedron, HeightFieldFlags, SharedShape, TypedShape,
    };
    use crate::rapier::math::Real;

    pub fn builder(kind: u32, flags: u32, indexed: bool) -> Result<ColliderBuilder, Fault> {
        Ok(match kind {
            kind::CUBOID => {
                let extents = vector(0, "halfExtents")?;
                ColliderBuilder::cuboid(extents.x, extents.y, extents.z)
            }
            kind::ROUND_CUBOID => {
                let extents = vector(0, "halfExtents")?;
                ColliderBuilder::round_cuboid(extents.x, extents.y, extents.z, border())
            }
            kind::CYLINDER => ColliderBuilder::cylinder(half_height(), radius()),
            kind::CONE => ColliderBuilder::cone(half_height(), radius()),
            kind::ROUND_CYLINDER => {
                ColliderBuilder::round_cylinder(half_height(), radius(), border())
            }
            kind::ROUND_CONE => ColliderBuilder::round_cone(half_height(), radius(), border()),
            kind::HEIGHTFIELD => heightfield(flags)?,
            kind::CONVEX | kind::ROUND_CONVEX => convex(kind == kind::ROUND_CONVEX, indexed)?,
            _ => return Err(Fault::number("the shape type", kind.into(), "a ShapeType")),
        })
    }

    fn convex(round: bool, indexed: bool) -> Result<ColliderBuilder, Fault> {
        let indices = optional_groups(indexed)?;
        let points = memory::vectors("points")?;
        match (indices, round) {
            (None, false) => ColliderBuilder::try_convex_hull(&points).map_err(Fault::invalid),
            (None, true) => ColliderBuilder::try_round_convex_hull(&points, border()).map_err(Fault::invalid),
            (Some(indices), false) => ColliderBuilder::try_convex_mesh(points, &indices).map_err(Fault::invalid),
            (Some(indices), true) => ColliderBuilder::round_convex_mesh(points, &indices, border()).ok_or_else(|| {
                Fault::invalid("the vertices and indices of the round convex mesh do not enclose a volume, or its border is negative")
            }),
        }
    }

    /// Heights by columns: the integers are the numbers of cells along z and x.
    fn heightfield(flags: u32) -> Result<ColliderBuilder, Fault> {
        let (cells, heights) = (memory::integers(), memory::reals());
        let [rows, columns] =
            [0, 1].map(|at| cells.get(at).map_or(0, |count| *count as usize).saturating_add(1));
        if rows.checked_mul(columns) != Some(heights.len()) {
            let text = format_args!(
                "heights holds {} numbers, but {rows} times {columns} are needed",
                heights.len()
            );
            return Err(Fault::invalid(text));
        }
        let scale = vector(0, "scale")?;
        let flags = HeightFieldFlags::from_bits_truncate(flags as _);
        Ok(ColliderBuilder::heightfield_with_flags(
            Array2::new(rows, columns, heights),
            scale,
            flags,
        ))
    }

    /// Writes points and triangles. A plate has its points alone: their hull is the plate again.
    fn put_polyhedron(polyhedron: &ConvexPolyhedron) {
        let (points, indices) = polyhedron.to_trimesh();
        let is_plate = polyhedron.faces().len() <= 2;
        put_reals(points.iter().flat_map(|point| point.to_array()));
        put_integers(indices.into_iter().flatten().filter(|_| !is_plate));
    }

    fn put_sizes(half_height: Real, radius: Real, border: Real) {
        put_number(SIZES, HALF_HEIGHT, half_height);
        put_number(SIZES, RADIUS, radius);
        put_number(SIZES, BORDER, border);
    }

    /// Writes the numbers of a shape that only this dimension has.
    pub fn describe(shape: &SharedShape) -> u32 {
        match shape.as_typed_shape() {
            TypedShape::HeightField(field) => {
                put_vector(0, field.scale());
                put_reals(field.heights().data().iter().copied());
                put_integers([
                    field.nrows() as u32,
                    field.ncols() as u32,
                    field.flags().bits().into(),
                ]);
                kind::HEIGHTFIELD
            }
            TypedShape::ConvexPolyhedron(polyhedron) => {
                put_polyhedron(polyhedron);
                kind::CONVEX
            }
            TypedShape::RoundConvexPolyhedron(polyhedron) => {
                put_polyhedron(&polyhedron.inner_shape);
                put_number(SIZES, BORDER, polyhedron.border_radius);
                kind::ROUND_CONVEX
            }
            TypedShape::Cylinder(cylinder) => {
                put_sizes(cylinder.half_height, cylinder.radius, 0.0);
                kind::CYLINDER
            }
            TypedShape::RoundCylinder(round) => {
                put_sizes(
                    round.inner_shape.half_height,
                    round.inner_shape.radius,
                    round.border_radius,
                );
                kind::ROUND_CYLINDER
            }
            TypedShape::Cone(cone) => {
                put_sizes(cone.half_height, cone.radius, 0.0);
                kind::CONE
            }
            TypedShape::RoundCone(round) => {
                put_sizes(
                    round.inner_shape.half_height,
                    round.inner_shape.radius,
                    round.border_radius,
                );
                kind::ROUND_CONE
            }
            _ => kind::UNKNOWN,
        }
    }
}

fn put_vectors<const N: usize>(vectors: [Vector; N]) {
    for (place, vector) in vectors.into_iter().enumerate() {
        put_vector(place, vector);
    }
}

fn put_points(points: &[Vector]) {
    put_reals(points.iter().flat_map(|point| point.to_array()));
}

/// Writes the numbers and lists of a shape. Returns its kind.
pub fn describe(shape: &SharedShape) -> u32 {
    put_integers([]);
    match shape.as_typed_shape() {
        TypedShape::Ball(ball) => {
            put_number(SIZES, RADIUS, ball.radius);
            kind::BALL
        }
        TypedShape::Cuboid(cuboid) => {
            put_vector(0, cuboid.half_extents);
            kind::CUBOID
        }
        TypedShape::RoundCuboid(round) => {
            put_vector(0, round.inner_shape.half_extents);
            put_number(SIZES, BORDER, round.border_radius);
            kind::ROUND_CUBOID
        }
        TypedShape::Capsule(capsule) => {
            put_vectors([capsule.segment.a, capsule.segment.b]);
            put_number(SIZES, HALF_HEIGHT, capsule.half_height());
            put_number(SIZES, RADIUS, capsule.radius);
            kind::CAPSULE
        }
        TypedShape::Segment(segment) => {
            put_vectors([segment.a, segment.b]);
            kind::SEGMENT
        }
        TypedShape::Triangle(triangle) => {
            put_vectors([triangle.a, triangle.b, triangle.c]);
            kind::TRIANGLE
        }
        TypedShape::RoundTriangle(round) => {
            let triangle = &round.inner_shape;
            put_vectors([triangle.a, triangle.b, triangle.c]);
            put_number(SIZES, BORDER, round.border_radius);
            kind::ROUND_TRIANGLE
        }
        TypedShape::HalfSpace(halfspace) => {
            put_vector(0, halfspace.normal);
            kind::HALFSPACE
        }
        TypedShape::Polyline(polyline) => {
            put_points(polyline.vertices());
            put_integers(polyline.indices().iter().flatten().copied());
            put_number(SIZES, 3, polyline.flags().bits() as Real);
            kind::POLYLINE
        }
        TypedShape::TriMesh(mesh) => {
            put_points(mesh.vertices());
            put_integers(mesh.indices().iter().flatten().copied());
            put_number(SIZES, 3, mesh.flags().bits() as Real);
            kind::TRIMESH
        }
        TypedShape::Compound(compound) => describe_compound(compound),
        TypedShape::Voxels(voxels) => {
            put_vector(0, voxels.voxel_size());
            let filled = voxels.voxels().filter(|voxel| !voxel.state.is_empty());
            put_integers(
                filled.flat_map(|voxel| voxel.grid_coords.to_array()).map(|c| c as i32 as u32),
            );
            kind::VOXELS
        }
        _ => dimension::describe(shape),
    }
}

/// Registers the parts of a compound: the integers are their numbers, the real numbers their poses.
fn describe_compound(compound: &Compound) -> u32 {
    let numbers: Vec<u32> =
        compound.shapes().iter().map(|(_, part)| register(part.clone())).collect();
    put_integers(numbers);
    put_number(SIZES, 3, compound.flags().bits() as Real);
    put_reals(compound.shapes().iter().flat_map(|(pose, _)| {
        memory::put_rotation(1, pose.rotation);
        let rotation: Vec<Real> =
            (0..if DIM == 2 { 1 } else { 4 }).map(|at| number(1, at)).collect();
        pose.translation.to_array().into_iter().chain(rotation)
    }));
    kind::COMPOUND
}

/// An error of the engine with the names that sizes have in JavaScript.
fn in_javascript(error: impl Display) -> Fault {
    let text = error.to_string();
    Fault::invalid(
        text.replace("half_height", "halfHeight").replace("border_radius", "borderRadius"),
    )
}

exports! {
    /// Makes a shape from the scratch block and the lists. Returns its number.
    fn shape_new(kind: u32, flags: u32, indexed: u32) -> u32 {
        for (component, name) in [(RADIUS, "radius"), (HALF_HEIGHT, "halfHeight"), (BORDER, "borderRadius")] {
            finite(name, number(SIZES, component))?;
        }
        let shape = builder(kind, flags, indexed != 0)?.try_shape().map_err(in_javascript)?;
        register(with_compound_flags(shape, flags))
    }

    /// Frees a shape. Colliders keep their shapes.
    fn shape_free(number: u32) {
        // SAFETY: the reference ends with the statement.
        drop(unsafe { SHAPES.get().remove(number) });
    }

    /// Writes the numbers and lists of a shape. Returns its kind.
    fn shape_describe(number: u32) -> u32 {
        describe(&shape(number)?)
    }
}
