//! Worlds.

use super::body::{self, Body};
use super::collider::{self, Collider};
use super::events::{CollisionEvent, EventLog};
use super::joint::{self, Joint};
use super::numbers::{self, STATE, non_negative, vector_out};
use super::options::Options;
use super::rapier::geometry::ColliderHandle;
use super::rapier::math::Real;
use super::rapier::pipeline::{DebugColor, DebugRenderBackend, DebugRenderObject, DebugRenderPipeline, PhysicsWorld, QueryPipeline};
use super::rapier::math::Vector;
use super::shape::Shape;
use super::space;
use crate::errors::{SnapshotError, invalid};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A world: bodies, colliders and joints that move together. Lengths in metres, masses in kilograms, times in seconds.
///
/// Two worlds are independent. A step releases the interpreter's lock, so worlds of several Python threads step at the same time. A second thread that uses a
/// stepping world waits.
#[pyclass(frozen, module = "rapier")]
pub struct World {
    state: Mutex<State>,
}

/// A world with what belongs to it.
pub struct State {
    pub world: PhysicsWorld,
    /// The tree of queries, until the world changes.
    queries: Option<QueryPipeline>,
    pub events: EventLog,
}

impl State {
    fn new(world: PhysicsWorld) -> Self {
        Self { world, queries: None, events: EventLog::default() }
    }

    /// The tree of queries, up to date.
    pub fn queries(&mut self) -> (&QueryPipeline, &PhysicsWorld) {
        let world = &self.world;
        let queries = self.queries.get_or_insert_with(|| {
            let mut queries = QueryPipeline::new();
            queries.update(&world.colliders);
            queries
        });
        (queries, world)
    }

    fn step(&mut self, count: usize) {
        self.queries = None;
        for _ in 0..count {
            self.world.step_with_events(&(), &self.events);
        }
    }
}

impl World {
    pub fn of(world: PhysicsWorld) -> Self {
        Self { state: Mutex::new(State::new(world)) }
    }

    /// The world, to read.
    pub fn read(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The world, to change.
    pub fn write(&self) -> MutexGuard<'_, State> {
        let mut state = self.read();
        state.queries = None;
        state
    }
}

#[pymethods]
impl World {
    /// World(*, gravity=None, dt=1/60)
    ///
    /// gravity: acceleration (m/s²), by default 9.81 along -y. dt: length of a step (s).
    #[new]
    #[pyo3(signature = (*, gravity=None, dt=1.0/60.0))]
    fn new(gravity: Option<&Bound<'_, PyAny>>, dt: f64) -> PyResult<Self> {
        let mut world = PhysicsWorld::new();
        if let Some(gravity) = gravity {
            world.gravity = space::vector("gravity", gravity)?;
        }
        world.integration_parameters.dt = non_negative("dt", dt)?;
        Ok(Self::of(world))
    }

    /// Gravity (m/s²).
    #[getter]
    fn gravity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Real>> {
        vector_out(py, self.read().world.gravity)
    }

    #[setter]
    fn set_gravity(&self, gravity: &Bound<'_, PyAny>) -> PyResult<()> {
        self.write().world.gravity = space::vector("gravity", gravity)?;
        Ok(())
    }

    /// Length of a step (s).
    #[getter]
    fn dt(&self) -> Real {
        self.read().world.integration_parameters.dt
    }

    #[setter]
    fn set_dt(&self, dt: f64) -> PyResult<()> {
        self.write().world.integration_parameters.dt = non_negative("dt", dt)?;
        Ok(())
    }

    /// Substeps of a step.
    #[getter]
    fn solver_iterations(&self) -> usize {
        self.read().world.integration_parameters.num_solver_iterations
    }

    #[setter]
    fn set_solver_iterations(&self, count: usize) -> PyResult<()> {
        if count == 0 {
            return Err(invalid("solver_iterations is 0, but must be at least 1"));
        }
        self.write().world.integration_parameters.num_solver_iterations = count;
        Ok(())
    }

    /// Moves the world forward by some time steps. Releases the interpreter's lock.
    #[pyo3(signature = (count=1))]
    fn step(&self, py: Python<'_>, count: usize) {
        py.detach(|| self.write().step(count));
    }

    /// Inserts a body, and with `shape` its first collider. Returns the body.
    ///
    /// kind: "dynamic", "fixed", "kinematic_position" or "kinematic_velocity". The other arguments are those of the properties of `Body` and `Collider`.
    #[pyo3(signature = (kind="dynamic", shape=None, **options))]
    fn add_body(slf: &Bound<'_, Self>, kind: &str, shape: Option<&Shape>, options: Option<&Bound<'_, PyDict>>) -> PyResult<Body> {
        let options = Options::new("add_body", options)?;
        let body = body::describe(kind, &options)?;
        let collider = shape.map(|shape| collider::describe(shape, &options)).transpose()?;
        options.finish()?;
        let mut state = slf.get().write();
        let handle = state.world.insert_body(body);
        if let Some(collider) = collider {
            state.world.insert_collider(collider, Some(handle));
        }
        Ok(Body { world: slf.clone().unbind(), handle })
    }

    /// Inserts a collider: part of a body, or fixed in the world. Returns it.
    #[pyo3(signature = (shape, body=None, **options))]
    fn add_collider(slf: &Bound<'_, Self>, shape: &Shape, body: Option<&Body>, options: Option<&Bound<'_, PyDict>>) -> PyResult<Collider> {
        let options = Options::new("add_collider", options)?;
        let collider = collider::describe_placed(shape, &options)?;
        options.finish()?;
        let parent = body.map(|body| body.handle_in(slf)).transpose()?;
        let handle = slf.get().write().world.insert_collider(collider, parent);
        Ok(Collider { world: slf.clone().unbind(), handle })
    }

    /// Joins two bodies. Returns the joint.
    ///
    /// kind: "fixed", "revolute", "prismatic", "spherical" (3D), "rope" or "spring". Anchors are points in the frames of the bodies (m). axis: of a revolute
    /// or prismatic joint, in the frames of both bodies. limits: (smallest, largest) coordinate (rad or m). length: of a rope, or of a spring at rest.
    /// reduced: the joint is a link of a multibody, which has no drift.
    #[pyo3(signature = (kind, body1, body2, **options))]
    fn add_joint(slf: &Bound<'_, Self>, kind: &str, body1: &Body, body2: &Body, options: Option<&Bound<'_, PyDict>>) -> PyResult<Joint> {
        let options = Options::new("add_joint", options)?;
        let (joint, axis) = joint::describe(kind, &options)?;
        let reduced = options.take("reduced")?.unwrap_or(false);
        options.finish()?;
        let (first, second) = (body1.handle_in(slf)?, body2.handle_in(slf)?);
        let key = joint::insert(&mut slf.get().write().world, reduced, [first, second], joint)?;
        Ok(Joint { world: slf.clone().unbind(), key, axis })
    }

    /// The bodies, in the order of the rows of `state`.
    #[getter]
    fn bodies(slf: &Bound<'_, Self>) -> Vec<Body> {
        let body = |handle| Body { world: slf.clone().unbind(), handle };
        slf.get().read().world.bodies.iter().map(|(handle, _)| body(handle)).collect()
    }

    /// The colliders.
    #[getter]
    fn colliders(slf: &Bound<'_, Self>) -> Vec<Collider> {
        let collider = |handle: ColliderHandle| Collider { world: slf.clone().unbind(), handle };
        slf.get().read().world.colliders.iter().map(|(handle, _)| collider(handle)).collect()
    }

    /// The number of bodies.
    fn __len__(&self) -> usize {
        self.read().world.bodies.len()
    }

    /// The number of bodies that are awake.
    #[getter]
    fn awake(&self) -> usize {
        self.read().world.active_bodies().len()
    }

    /// Poses and velocities of all bodies: an array of the shape (bodies, 13) in 3D (position, quaternion x y z w, linear and angular velocity), (bodies, 6) in 2D.
    ///
    /// out: an array to fill instead of a new one.
    #[pyo3(signature = (out=None))]
    fn state<'py>(&self, py: Python<'py>, out: Option<Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
        let state = self.read();
        let out = numbers::output(py, out, &[state.world.bodies.len(), STATE])?;
        let mut rows = out.try_readwrite()?;
        let rows = rows.as_slice_mut()?;
        for ((_, body), row) in state.world.bodies.iter().zip(rows.chunks_exact_mut(STATE)) {
            numbers::write_state(body, row);
        }
        Ok(out)
    }

    /// A hash of the simulated state. Equal bits give equal hashes on every machine.
    #[getter]
    fn hash(&self) -> u64 {
        self.read().world.hash()
    }

    /// The whole world as bytes, which `World.from_snapshot` of any machine reads.
    fn snapshot<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.read().world.to_snapshot().map_err(|error| SnapshotError::new_err(error.to_string()))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// A world that continues a snapshot bit by bit.
    #[staticmethod]
    fn from_snapshot(snapshot: &[u8]) -> PyResult<Self> {
        let world = PhysicsWorld::from_snapshot(snapshot).map_err(|error| SnapshotError::new_err(error.to_string()))?;
        Ok(Self::of(world))
    }

    /// A copy of the world.
    fn copy(&self) -> Self {
        Self::of(self.read().world.clone())
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.copy()
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let restore = slf.get_type().getattr("from_snapshot")?;
        Ok((restore, (slf.get().snapshot(slf.py())?,)))
    }

    /// The collisions that began or ended in the steps since the last call, of colliders with `events=True`.
    fn collision_events(slf: &Bound<'_, Self>) -> PyResult<Vec<CollisionEvent>> {
        let world = slf.clone().unbind();
        let events = slf.get().read().events.take();
        events.into_iter().map(|event| CollisionEvent::new(slf.py(), &world, event)).collect()
    }

    /// The debug lines of the world: an array of the shape (lines, 2, DIM), and the colours (lines, 4) as hue (degrees), saturation, lightness and opacity.
    fn debug_lines<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyArray3<Real>>, Bound<'py, PyArray2<f32>>)> {
        let mut lines = Lines::default();
        self.read().world.debug_render(&mut DebugRenderPipeline::default(), &mut lines);
        let count = lines.colors.len() / 4;
        let ends = PyArray1::from_vec(py, lines.ends).reshape([count, 2, super::rapier::math::DIM])?;
        Ok((ends, PyArray1::from_vec(py, lines.colors).reshape([count, 4])?))
    }

    fn __repr__(&self) -> String {
        let state = self.read();
        let world = &state.world;
        format!("<World: {} bodies, {} colliders>", world.bodies.len(), world.colliders.len())
    }
}

/// Collects debug lines.
#[derive(Default)]
struct Lines {
    ends: Vec<Real>,
    colors: Vec<f32>,
}

impl DebugRenderBackend for Lines {
    fn draw_line(&mut self, _: DebugRenderObject<'_>, a: Vector, b: Vector, color: DebugColor) {
        self.ends.extend(a.to_array().into_iter().chain(b.to_array()));
        self.colors.extend(color);
    }
}
