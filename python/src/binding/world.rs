//! Worlds.

use super::body::{self, Body};
use super::collider::{self, Collider};
use super::events::{CollisionEvent, EventLog};
use super::hooks::{Callbacks, RunningCallbacks};
use super::joint::{self, Joint};
use super::numbers::{self, STATE, coordinates, non_negative, vector_out};
use super::options::Options;
use super::rapier::dynamics::RigidBodyHandle;
use super::rapier::geometry::ColliderHandle;
use super::rapier::math::{DIM, Real, Vector};
use super::rapier::pipeline::{
    DebugColor, DebugRenderBackend, DebugRenderObject, DebugRenderPipeline, PhysicsHooks,
    PhysicsWorld, QueryPipeline,
};
use super::scene::Artist;
use super::shape::Shape;
use super::simulation::{Simulation, replay};
use super::space::Vehicles;
use crate::errors::{SnapshotError, invalid};
use crate::shared::Shared;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayDyn, PyArrayMethods};
use pyo3::gc::{PyTraverseError, PyVisit};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A world: bodies, colliders and joints that move together. Lengths in metres, masses in
/// kilograms, times in seconds.
///
/// Two worlds are independent. A step releases the interpreter's lock, so worlds of several Python
/// threads step at the same time. A second thread that uses a
/// stepping world waits, and other Python threads continue.
#[pyclass(frozen, module = "rapier")]
pub struct World {
    state: Shared<State>,
    callbacks: Mutex<Option<Arc<Callbacks>>>,
}

/// A simulation with the data that its queries, events and pictures need.
pub struct State {
    pub simulation: Simulation,
    pub artist: Artist,
    queries: QueryPipeline,
    events: EventLog,
}

impl State {
    /// The tree of queries with the current colliders, at the poses of bodies that were moved since
    /// the last step. The update costs nothing for unchanged colliders.
    pub fn queries(&mut self) -> (&QueryPipeline, &mut PhysicsWorld) {
        let world = self.simulation.current();
        self.queries.update(&world.colliders);
        (&self.queries, world)
    }

    fn step(&mut self, hooks: &dyn PhysicsHooks) {
        self.simulation.step(hooks, &self.events.collector);
    }
}

impl World {
    pub fn of(simulation: Simulation) -> Self {
        let state = State {
            simulation,
            artist: Artist::default(),
            queries: QueryPipeline::new(),
            events: EventLog::new(),
        };
        Self { state: Shared::new(state), callbacks: Mutex::default() }
    }

    /// A copy of the world and its vehicles.
    pub fn simulation(&self, py: Python<'_>) -> PyResult<Simulation> {
        self.detached(py, |state| state.simulation.clone())
    }

    /// Locks the state for a short access without Python objects: see [`Shared::lock`].
    pub fn lock(&self, py: Python<'_>) -> PyResult<MutexGuard<'_, State>> {
        self.state.lock(py)
    }

    /// Runs a long computation on the state, detached from the interpreter.
    pub fn detached<R: Send>(
        &self,
        py: Python<'_>,
        compute: impl FnOnce(&mut State) -> R + Send,
    ) -> PyResult<R> {
        self.state.detached(py, compute)
    }

    /// Replaces the callables. The finalizers of the earlier ones run without the lock.
    fn replace_callbacks(&self, callbacks: Option<Arc<Callbacks>>) {
        let mut stored = self.callbacks.lock().unwrap_or_else(PoisonError::into_inner);
        let earlier = std::mem::replace(&mut *stored, callbacks);
        drop(stored);
        drop(earlier);
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
            world.gravity = coordinates("gravity", gravity)?;
        }
        world.integration_parameters.dt = non_negative("dt", dt)?;
        Ok(Self::of(Simulation::of(world)))
    }

    /// Gravity (m/s²).
    #[getter]
    fn gravity<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        let gravity = self.lock(py)?.simulation.world.gravity;
        Ok(vector_out(py, gravity))
    }

    #[setter]
    fn set_gravity(&self, py: Python<'_>, gravity: &Bound<'_, PyAny>) -> PyResult<()> {
        let gravity = coordinates("gravity", gravity)?;
        self.lock(py)?.simulation.world.gravity = gravity;
        Ok(())
    }

    /// Length of a step (s).
    #[getter]
    fn dt(&self, py: Python<'_>) -> PyResult<Real> {
        Ok(self.lock(py)?.simulation.world.integration_parameters.dt)
    }

    #[setter]
    fn set_dt(&self, py: Python<'_>, dt: f64) -> PyResult<()> {
        let dt = non_negative("dt", dt)?;
        self.lock(py)?.simulation.world.integration_parameters.dt = dt;
        Ok(())
    }

    /// Substeps of a step.
    #[getter]
    fn solver_iterations(&self, py: Python<'_>) -> PyResult<usize> {
        Ok(self.lock(py)?.simulation.world.integration_parameters.num_solver_iterations)
    }

    #[setter]
    fn set_solver_iterations(&self, py: Python<'_>, count: usize) -> PyResult<()> {
        if count == 0 {
            return Err(invalid("solver_iterations is 0, but must be at least 1"));
        }
        self.lock(py)?.simulation.world.integration_parameters.num_solver_iterations = count;
        Ok(())
    }

    /// Moves the world forward by some time steps. Releases the interpreter's lock.
    #[pyo3(signature = (count=1))]
    fn step(slf: &Bound<'_, Self>, count: usize) -> PyResult<()> {
        let (py, this) = (slf.py(), slf.get());
        let callbacks = this.callbacks.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let Some(callbacks) = callbacks else {
            return this.detached(py, |state| (0..count).for_each(|_| state.step(&())));
        };
        let world = slf.clone().unbind();
        let running = RunningCallbacks::new(&world, &callbacks);
        this.detached(py, |state| {
            for _ in (0..count).take_while(|_| !running.has_failed()) {
                state.step(&running);
            }
        })?;
        running.into_result()
    }

    /// Sets callables that filter pairs and change contacts in the steps of the world, for
    /// colliders with `hooks=True`. None removes a callable.
    ///
    /// filter_contact, filter_intersection: get a `Pair` and return whether the pair makes contact,
    /// or, with a sensor, intersects.
    /// modify_contact: gets a `Contact` of a touching pair and may change it for this step.
    ///
    /// A call costs up to half a microsecond besides the work of the callable, and holds the
    /// interpreter's lock. Collision groups are better where they suffice. A callable cannot use
    /// the world: its argument contains the data. An exception ends the step without other calls, and
    /// `step` raises it. Copies of the world have no callables.
    #[pyo3(signature = (*, filter_contact=None, filter_intersection=None, modify_contact=None))]
    fn set_hooks(
        &self,
        filter_contact: Option<Py<PyAny>>,
        filter_intersection: Option<Py<PyAny>>,
        modify_contact: Option<Py<PyAny>>,
    ) {
        let callbacks = Callbacks { filter_contact, filter_intersection, modify_contact };
        self.replace_callbacks((!callbacks.is_empty()).then(|| Arc::new(callbacks)));
    }

    /// Shows the callables to the garbage collector: they may refer to the world.
    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        // A locked mutex belongs to another thread, whose world is no garbage.
        let Ok(callbacks) = self.callbacks.try_lock() else { return Ok(()) };
        callbacks.as_ref().map_or(Ok(()), |callbacks| callbacks.traverse(&visit))
    }

    fn __clear__(&self) {
        self.replace_callbacks(None);
    }

    /// Inserts a body, and with `shape` its first collider. Returns the body.
    ///
    /// kind: "dynamic", "fixed", "kinematic_position" or "kinematic_velocity". shape: of the first
    /// collider. None inserts a body without colliders.
    ///
    /// position: of the body's origin (m, world), by default the origin of the world.
    /// rotation: a quaternion (x, y, z, w) in 3D, an angle (rad) in 2D.
    /// linvel: velocity of the centre of mass (m/s, world).
    /// angvel: angular velocity (rad/s, world), a vector in 3D, a number in 2D.
    /// gravity_scale: factor of the world's gravity, by default 1.
    /// linear_damping, angular_damping: relative decrease of the velocities per time (1/s), by
    /// default 0.
    /// additional_mass: mass (kg) besides that of the colliders, by default 0.
    /// ccd: whether continuous collision detection keeps a fast body from tunnelling, by default
    /// False.
    /// can_sleep: whether the body may sleep at rest, by default True.
    /// lock_translations, lock_rotations: whether the body keeps its position or its rotation, by
    /// default False.
    ///
    /// With a shape, the arguments of `add_collider` from `density` on are those of the first
    /// collider.
    #[pyo3(signature = (kind="dynamic", shape=None, **options))]
    fn add_body(
        slf: &Bound<'_, Self>,
        kind: &str,
        shape: Option<&Shape>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Body> {
        let options = Options::new("add_body", options)?;
        let body = body::describe(kind, &options)?;
        let collider = shape.map(|shape| collider::describe(shape, &options)).transpose()?;
        options.finish()?;
        let mut state = slf.get().lock(slf.py())?;
        let handle = state.simulation.world.insert_body(body);
        if let Some(collider) = collider {
            state.simulation.world.insert_collider(collider, Some(handle));
        }
        Ok(Body { world: slf.clone().unbind(), handle })
    }

    /// Inserts a collider: part of a body, or fixed in the world. Returns it.
    ///
    /// position, rotation: pose of the shape in the frame of the body (m; a quaternion in 3D, rad
    /// in 2D), or in the world without a body.
    /// density: mass per volume (kg/m³ in 3D, kg/m² in 2D), by default 1. mass: the mass (kg)
    /// instead of the density.
    /// friction: largest ratio of the tangential to the normal contact force, by default 0.5.
    /// restitution: ratio of the speeds of separation and approach, by default 0.
    /// friction_combine_rule, restitution_combine_rule: of the coefficients of two colliders: "average",
    /// "min", "multiply", "max", "clamped_sum" or "geometric_mean". The later one of both rules acts.
    /// contact_skin: thickness (m) of an invisible layer around the shape, by default 0.
    /// collision_groups, solver_groups: bit masks (memberships, filter). Two colliders make
    /// contact, or exert forces, if each is a member of the other's filter.
    /// events: whether steps report the collisions of the collider, by default False.
    /// hooks: whether the callables of `set_hooks` decide about its pairs, by default False.
    /// sensor: whether the collider reports intersections and exerts no forces, by default False.
    #[pyo3(signature = (shape, body=None, **options))]
    fn add_collider(
        slf: &Bound<'_, Self>,
        shape: &Shape,
        body: Option<&Body>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Collider> {
        let options = Options::new("add_collider", options)?;
        let collider = collider::describe_placed(shape, &options)?;
        options.finish()?;
        let mut state = slf.get().lock(slf.py())?;
        let parent =
            body.map(|body| body.handle_in(slf, &state.simulation.world.bodies)).transpose()?;
        let handle = state.simulation.world.insert_collider(collider, parent);
        Ok(Collider { world: slf.clone().unbind(), handle })
    }

    /// Joins two bodies. Returns the joint.
    ///
    /// kind: "fixed", "revolute", "prismatic", "spherical" (3D), "rope", "spring", "gear", "rack"
    /// or "pulley".
    ///
    /// anchor1, anchor2: points in the frames of the bodies (m), by default their origins.
    /// axis: of a revolute joint (3D) or a prismatic joint, in the frames of both bodies, by
    /// default x.
    /// limits: (smallest, largest) coordinate of a revolute (rad) or prismatic (m) joint.
    /// length: of a rope, or of a spring at rest (m). stiffness (N/m), damping (N·s/m): of a
    /// spring, by default 1000 and 10.
    /// axis1, axis2: of two gears (3D), or of a pinion (3D) and its rack, each in the frame of its
    /// body, by default x.
    /// ratio: of gears (teeth of the second by those of the first: angle1 + ratio · angle2 = 0) or
    /// of a pulley (distance1 + ratio · distance2 ≤ length), by default 1.
    /// backlash: the angle (rad) by which the first gear can rotate alone, by default 0.
    /// radius: displacement of a rack per radian of its pinion (m).
    /// over1, over2: points of the world (m) over which the rope of a pulley runs. Its length (m)
    /// is required.
    /// contacts: whether the two bodies collide with each other, by default True, but False for
    /// gears and racks.
    /// reduced: whether the joint is a link of a multibody, which has no drift, by default False.
    #[pyo3(signature = (kind, body1, body2, **options))]
    fn add_joint(
        slf: &Bound<'_, Self>,
        kind: &str,
        body1: &Body,
        body2: &Body,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Joint> {
        let options = Options::new("add_joint", options)?;
        let (joint, axis) = joint::describe(kind, &options)?;
        let reduced = options.take("reduced")?.unwrap_or(false);
        options.finish()?;
        let mut state = slf.get().lock(slf.py())?;
        let bodies = &state.simulation.world.bodies;
        let handles = [body1.handle_in(slf, bodies)?, body2.handle_in(slf, bodies)?];
        let key = joint::insert(&mut state.simulation.world, reduced, handles, joint)?;
        Ok(Joint { world: slf.clone().unbind(), key, axis })
    }

    /// The bodies, in the order of the rows of `state`.
    #[getter]
    fn bodies(slf: &Bound<'_, Self>) -> PyResult<Vec<Body>> {
        let handles: Vec<RigidBodyHandle> = slf
            .get()
            .lock(slf.py())?
            .simulation
            .world
            .bodies
            .iter()
            .map(|(handle, _)| handle)
            .collect();
        Ok(handles.into_iter().map(|handle| Body { world: slf.clone().unbind(), handle }).collect())
    }

    /// The colliders.
    #[getter]
    fn colliders(slf: &Bound<'_, Self>) -> PyResult<Vec<Collider>> {
        let handles: Vec<ColliderHandle> = slf
            .get()
            .lock(slf.py())?
            .simulation
            .world
            .colliders
            .iter()
            .map(|(handle, _)| handle)
            .collect();
        Ok(handles
            .into_iter()
            .map(|handle| Collider { world: slf.clone().unbind(), handle })
            .collect())
    }

    /// The number of bodies.
    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        Ok(self.lock(py)?.simulation.world.bodies.len())
    }

    /// The number of bodies that are awake.
    #[getter]
    fn awake(&self, py: Python<'_>) -> PyResult<usize> {
        Ok(self.lock(py)?.simulation.world.active_bodies().len())
    }

    /// Poses and velocities of all bodies: an array of the shape (bodies, 13) in 3D (position,
    /// quaternion x y z w, linear and angular velocity), (bodies, 6) in 2D.
    ///
    /// out: an array to fill instead of a new one.
    #[pyo3(signature = (out=None))]
    fn state<'py>(
        &self,
        py: Python<'py>,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
        // NumPy allocates without the guard: see `Shared::lock`.
        let count = self.lock(py)?.simulation.world.bodies.len();
        let out = numbers::output(py, out, &[count, STATE])?;
        let mut rows = out.try_readwrite()?;
        let rows = rows.as_slice_mut()?;
        let state = self.lock(py)?;
        if state.simulation.world.bodies.len() != count {
            return Err(invalid("another thread inserted or removed bodies during the call"));
        }
        for ((_, body), row) in
            state.simulation.world.bodies.iter().zip(rows.chunks_exact_mut(STATE))
        {
            numbers::write_state(body, row);
        }
        drop(state);
        Ok(out)
    }

    /// A hash of the simulated state. Equal bits give equal hashes on every machine.
    #[getter]
    fn hash(&self, py: Python<'_>) -> PyResult<u64> {
        self.detached(py, |state| state.simulation.hash())
    }

    /// The whole world as bytes, which `World.from_snapshot` of any machine reads. Vehicles and
    /// hooks are no part of it.
    fn snapshot<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.detached(py, |state| {
            state.simulation.world.to_snapshot().map_err(|error| error.to_string())
        })?;
        Ok(PyBytes::new(py, &bytes.map_err(SnapshotError::new_err)?))
    }

    /// A world that continues a snapshot bit by bit.
    #[staticmethod]
    fn from_snapshot(py: Python<'_>, snapshot: &[u8]) -> PyResult<Self> {
        let world =
            py.detach(|| PhysicsWorld::from_snapshot(snapshot).map_err(|error| error.to_string()));
        Ok(Self::of(Simulation::of(world.map_err(SnapshotError::new_err)?)))
    }

    /// Replays the recording of a native program, and compares the hash of every step. Returns the
    /// world after the last step. Raises `SnapshotError` if a hash differs.
    #[staticmethod]
    #[pyo3(name = "replay")]
    fn from_recording(py: Python<'_>, recording: &[u8]) -> PyResult<Self> {
        let world = py.detach(|| replay(recording).map_err(|error| error.to_string()));
        Ok(Self::of(Simulation::of(world.map_err(SnapshotError::new_err)?)))
    }

    /// A copy of the world with its vehicles, without its hooks.
    fn copy(&self, py: Python<'_>) -> PyResult<Self> {
        Ok(Self::of(self.simulation(py)?))
    }

    fn __copy__(&self, py: Python<'_>) -> PyResult<Self> {
        self.copy(py)
    }

    fn __deepcopy__(&self, py: Python<'_>, _memo: &Bound<'_, PyAny>) -> PyResult<Self> {
        self.copy(py)
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>, Bound<'py, PyBytes>))> {
        let py = slf.py();
        let bytes = slf.get().detached(py, |State { simulation, .. }| {
            let world = simulation.world.to_snapshot().map_err(|error| error.to_string())?;
            Ok((world, simulation.vehicles.to_bytes()?))
        })?;
        let (world, vehicles) = bytes.map_err(SnapshotError::new_err::<String>)?;
        let restore = slf.get_type().getattr("_restore")?;
        Ok((restore, (PyBytes::new(py, &world), PyBytes::new(py, &vehicles))))
    }

    /// The world of a pickle.
    #[staticmethod]
    fn _restore(py: Python<'_>, snapshot: &[u8], vehicles: &[u8]) -> PyResult<Self> {
        let world = Self::from_snapshot(py, snapshot)?;
        let vehicles = Vehicles::from_bytes(vehicles)?;
        world.lock(py)?.simulation.vehicles = vehicles;
        Ok(world)
    }

    /// The collisions that began or ended in the steps since the last call, of colliders with
    /// `events=True`.
    fn collision_events(slf: &Bound<'_, Self>) -> PyResult<Vec<CollisionEvent>> {
        let world = slf.clone().unbind();
        let events = slf.get().lock(slf.py())?.events.take();
        events.into_iter().map(|event| CollisionEvent::new(slf.py(), &world, event)).collect()
    }

    /// The debug lines of the world: an array of the shape (lines, 2, DIM), and the colours (lines,
    /// 4) as hue (degrees), saturation, lightness and opacity.
    fn debug_lines<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyArray3<Real>>, Bound<'py, PyArray2<f32>>)> {
        let mut lines = Lines::default();
        self.detached(py, |state| {
            let world = state.simulation.current();
            world.debug_render(&mut DebugRenderPipeline::default(), &mut lines)
        })?;
        let count = lines.colors.len() / 4;
        let ends = PyArray1::from_vec(py, lines.ends).reshape([count, 2, DIM])?;
        Ok((ends, PyArray1::from_vec(py, lines.colors).reshape([count, 4])?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let state = self.lock(py)?;
        let world = &state.simulation.world;
        Ok(format!("<World: {} bodies, {} colliders>", world.bodies.len(), world.colliders.len()))
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
