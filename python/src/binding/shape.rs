//! Shapes.

use super::numbers::{finite, numbers, points, pose, vector};
use super::rapier::geometry::{ColliderBuilder, InvalidCollider, SharedShape};
use super::rapier::math::{DIM, Pose};
use super::space;
use crate::errors::invalid;
use pyo3::prelude::*;

/// A shape, which any number of colliders share. Lengths in metres, in the frame of the collider.
#[pyclass(frozen, module = "rapier")]
pub struct Shape {
    pub shape: SharedShape,
}

impl Shape {
    fn of(shape: SharedShape) -> PyResult<Self> {
        Self::built(ColliderBuilder::new(shape))
    }

    fn built(builder: ColliderBuilder) -> PyResult<Self> {
        builder.try_shape().map(|shape| Self { shape }).map_err(invalid)
    }

    fn checked(builder: Result<ColliderBuilder, InvalidCollider>) -> PyResult<Self> {
        builder.map_err(invalid).and_then(Self::built)
    }
}

#[pymethods]
impl Shape {
    /// A ball around the origin.
    #[staticmethod]
    fn ball(radius: f64) -> PyResult<Self> {
        Self::built(ColliderBuilder::ball(finite("radius", radius)?))
    }

    /// A box around the origin, by half of its sides.
    #[staticmethod]
    fn r#box(half_extents: &Bound<'_, PyAny>) -> PyResult<Self> {
        Self::of(space::cuboid(numbers::<DIM>("half_extents", half_extents)?))
    }

    /// A capsule along y: all points at most `radius` from a segment of twice the half height.
    #[staticmethod]
    fn capsule(half_height: f64, radius: f64) -> PyResult<Self> {
        Self::built(ColliderBuilder::capsule_y(
            finite("half_height", half_height)?,
            finite("radius", radius)?,
        ))
    }

    /// A cylinder along y. 3D only.
    #[staticmethod]
    fn cylinder(half_height: f64, radius: f64) -> PyResult<Self> {
        Self::of(space::cylinder(half_height, radius)?)
    }

    /// A cone along y, with its tip up. 3D only.
    #[staticmethod]
    fn cone(half_height: f64, radius: f64) -> PyResult<Self> {
        Self::of(space::cone(half_height, radius)?)
    }

    /// The solid side of a plane through the origin. The normal points out of it.
    #[staticmethod]
    fn halfspace(normal: &Bound<'_, PyAny>) -> PyResult<Self> {
        let normal = vector("normal", normal)?;
        let unit = normal.try_normalize();
        let unit = unit.ok_or_else(|| {
            invalid(format!("normal is {normal}, but must have a finite length greater than 0"))
        })?;
        Self::built(ColliderBuilder::halfspace(unit))
    }

    /// The convex hull of points, an array of the shape (n, DIM).
    #[staticmethod]
    fn convex_hull(vertices: &Bound<'_, PyAny>) -> PyResult<Self> {
        Self::checked(ColliderBuilder::try_convex_hull(&points("vertices", vertices)?))
    }

    /// Triangles: vertices of the shape (n, DIM), and triples of their indices.
    #[staticmethod]
    fn mesh(vertices: &Bound<'_, PyAny>, indices: Vec<[u32; 3]>) -> PyResult<Self> {
        Self::checked(ColliderBuilder::trimesh(points("vertices", vertices)?, indices))
    }

    /// Segments: vertices of the shape (n, DIM), and pairs of their indices. Without indices, each
    /// vertex is joined to the next.
    #[staticmethod]
    #[pyo3(signature = (vertices, indices=None))]
    fn polyline(vertices: &Bound<'_, PyAny>, indices: Option<Vec<[u32; 2]>>) -> PyResult<Self> {
        Self::built(ColliderBuilder::polyline(points("vertices", vertices)?, indices))
    }

    /// A surface of heights: an array over z and x in 3D, over x in 2D. scale: the whole size along
    /// each axis.
    #[staticmethod]
    fn heightfield(heights: &Bound<'_, PyAny>, scale: &Bound<'_, PyAny>) -> PyResult<Self> {
        Self::built(space::height_field(heights, vector("scale", scale)?)?)
    }

    /// Shapes as one: tuples (shape, position, rotation), of which position and rotation may be
    /// None.
    #[staticmethod]
    fn compound(
        parts: Vec<(Bound<'_, Shape>, Option<Bound<'_, PyAny>>, Option<Bound<'_, PyAny>>)>,
    ) -> PyResult<Self> {
        let place = |(shape, position, rotation): (
            Bound<'_, Shape>,
            Option<Bound<'_, PyAny>>,
            Option<Bound<'_, PyAny>>,
        )| {
            Ok((
                pose(Pose::IDENTITY, position.as_ref(), rotation.as_ref())?,
                shape.get().shape.clone(),
            ))
        };
        let parts = parts.into_iter().map(place).collect::<PyResult<Vec<_>>>()?;
        Self::built(ColliderBuilder::compound(parts))
    }

    fn __repr__(&self) -> String {
        format!("<Shape: {:?}>", self.shape.shape_type())
    }
}
