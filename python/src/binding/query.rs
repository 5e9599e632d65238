//! Queries of a world.

use super::collider::Collider;
use super::garbage::traverse;
use super::numbers::{points, pose, vector, vector_out};
use super::rapier::geometry::{ColliderHandle, ColliderSet, Ray};
use super::rapier::math::{DIM, Pose, Real, Vector};
use super::rapier::pipeline::{QueryFilter, QueryPipeline};
use super::shape::Shape;
use super::world::{State, World};
use crate::errors::invalid;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// The first collider that a ray hits.
#[pyclass(frozen, module = "rapier")]
pub struct RayHit {
    /// The collider.
    #[pyo3(get)]
    collider: Py<Collider>,
    /// The time of impact, in units of the direction: the point is `origin + direction * toi`.
    #[pyo3(get)]
    toi: Real,
    point: Vector,
    normal: Vector,
}

traverse!(RayHit, hit => hit.collider);

#[pymethods]
impl RayHit {
    /// The point (m, world).
    #[getter]
    fn point<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Real>> {
        vector_out(py, self.point)
    }

    /// The unit normal of the surface there.
    #[getter]
    fn normal<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Real>> {
        vector_out(py, self.normal)
    }

    fn __repr__(&self) -> String {
        format!("<RayHit: toi {}>", self.toi)
    }
}

/// The nearest point of the nearest collider.
#[pyclass(frozen, module = "rapier")]
pub struct PointProjection {
    /// The collider.
    #[pyo3(get)]
    collider: Py<Collider>,
    /// Whether the point is inside of the collider.
    #[pyo3(get)]
    inside: bool,
    point: Vector,
}

traverse!(PointProjection, projection => projection.collider);

#[pymethods]
impl PointProjection {
    /// The nearest point (m, world).
    #[getter]
    fn point<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Real>> {
        vector_out(py, self.point)
    }
}

/// Casts many rays: the times of impact (infinite without a hit) and the normals (zero without a
/// hit).
fn cast_all(state: &mut State, rays: &[Ray], longest: Real, solid: bool) -> (Vec<Real>, Vec<Real>) {
    let (queries, world) = state.queries();
    let mut times = Vec::with_capacity(rays.len());
    let mut normals = Vec::with_capacity(rays.len() * DIM);
    for ray in rays {
        let hit = queries.cast_ray_and_get_normal(
            &world.colliders,
            ray,
            longest,
            solid,
            QueryFilter::default(),
        );
        let (time, normal) =
            hit.map_or((Real::INFINITY, Vector::ZERO), |(_, hit)| (hit.time_of_impact, hit.normal));
        times.push(time);
        normals.extend(normal.to_array());
    }
    (times, normals)
}

/// A bound of times. Infinite is the largest number, with which the engine computes.
fn bound(max_toi: f64) -> PyResult<Real> {
    match max_toi >= 0.0 {
        true => Ok((max_toi as Real).min(Real::MAX)),
        false => Err(invalid(format!("max_toi is {max_toi}, but must not be negative"))),
    }
}

#[pymethods]
impl World {
    /// The first collider that a ray hits, or None. A ray that begins inside of a `solid` collider
    /// hits it at once.
    ///
    /// origin (m, world), direction (m per unit of `max_toi`): vectors. All queries find bodies that
    /// were moved since the last step at their new poses.
    #[pyo3(signature = (origin, direction, max_toi=f64::INFINITY, solid=true))]
    fn cast_ray(
        slf: &Bound<'_, Self>,
        origin: &Bound<'_, PyAny>,
        direction: &Bound<'_, PyAny>,
        max_toi: f64,
        solid: bool,
    ) -> PyResult<Option<RayHit>> {
        let ray = Ray::new(vector("origin", origin)?, vector("direction", direction)?);
        let longest = bound(max_toi)?;
        let hit = with_queries(slf, |queries, colliders| {
            queries.cast_ray_and_get_normal(colliders, &ray, longest, solid, QueryFilter::default())
        })?;
        let Some((handle, hit)) = hit else { return Ok(None) };
        let toi = hit.time_of_impact;
        Ok(Some(RayHit {
            collider: collider(slf, handle)?,
            toi,
            point: ray.origin + ray.dir * toi,
            normal: hit.normal,
        }))
    }

    /// Casts many rays: origins (m, world) and directions of the shape (n, DIM). Returns the times
    /// of impact (n), infinite without a hit, and the
    /// normals (n, DIM), zero without a hit. Releases the interpreter's lock.
    #[pyo3(signature = (origins, directions, max_toi=f64::INFINITY, solid=true))]
    fn cast_rays<'py>(
        &self,
        py: Python<'py>,
        origins: &Bound<'py, PyAny>,
        directions: &Bound<'py, PyAny>,
        max_toi: f64,
        solid: bool,
    ) -> PyResult<(Bound<'py, PyArray1<Real>>, Bound<'py, PyArray2<Real>>)> {
        let (origins, directions) =
            (points("origins", origins)?, points("directions", directions)?);
        if origins.len() != directions.len() {
            return Err(invalid(format!(
                "there are {} origins and {} directions",
                origins.len(),
                directions.len()
            )));
        }
        let rays: Vec<Ray> = origins
            .into_iter()
            .zip(directions)
            .map(|(origin, direction)| Ray::new(origin, direction))
            .collect();
        let longest = bound(max_toi)?;
        let (times, normals) = self.detached(py, |state| cast_all(state, &rays, longest, solid))?;
        let normals = PyArray1::from_vec(py, normals).reshape([rays.len(), DIM])?;
        Ok((PyArray1::from_vec(py, times), normals))
    }

    /// The nearest point of all colliders to a point (m, world), or None in an empty world.
    #[pyo3(signature = (point, solid=true))]
    fn project_point(
        slf: &Bound<'_, Self>,
        point: &Bound<'_, PyAny>,
        solid: bool,
    ) -> PyResult<Option<PointProjection>> {
        let point = vector("point", point)?;
        let found = with_queries(slf, |queries, colliders| {
            queries.project_point(colliders, &point, solid, QueryFilter::default())
        })?;
        let Some((handle, projection)) = found else { return Ok(None) };
        Ok(Some(PointProjection {
            collider: collider(slf, handle)?,
            inside: projection.is_inside,
            point: projection.point,
        }))
    }

    /// The colliders that a shape intersects at a pose (m, world; a quaternion in 3D, rad in 2D).
    #[pyo3(signature = (shape, position=None, rotation=None))]
    fn overlaps(
        slf: &Bound<'_, Self>,
        shape: &Shape,
        position: Option<&Bound<'_, PyAny>>,
        rotation: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Vec<Py<Collider>>> {
        let place = pose(Pose::IDENTITY, position, rotation)?;
        let mut handles = Vec::new();
        let push = |handle| {
            handles.push(handle);
            true
        };
        with_queries(slf, |queries, colliders| {
            queries.intersections_with_shape(
                colliders,
                &place,
                &*shape.shape,
                QueryFilter::default(),
                push,
            )
        })?;
        handles.into_iter().map(|handle| collider(slf, handle)).collect()
    }
}

/// The result of a query. The world is unlocked afterwards, before the result becomes Python
/// objects.
fn with_queries<R>(
    world: &Bound<'_, World>,
    query: impl FnOnce(&QueryPipeline, &ColliderSet) -> R,
) -> PyResult<R> {
    let mut state = world.get().lock(world.py())?;
    let (queries, world) = state.queries();
    Ok(query(queries, &world.colliders))
}

fn collider(world: &Bound<'_, World>, handle: ColliderHandle) -> PyResult<Py<Collider>> {
    Py::new(world.py(), Collider { world: world.clone().unbind(), handle })
}
