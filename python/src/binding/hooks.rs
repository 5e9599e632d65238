//! Hooks: Python callables that filter pairs and change contacts in a step.

use super::body::Body;
use super::collider::Collider;
use super::garbage::traverse;
use super::numbers::{coefficient, coordinates, finite, vector, vector_out};
use super::rapier::dynamics::{RigidBodyHandle, RigidBodySet};
use super::rapier::geometry::{ColliderHandle, SolverFlags};
use super::rapier::math::{DIM, Real, Vector};
use super::rapier::pipeline::{ContactModificationContext, PairFilterContext, PhysicsHooks};
use super::world::World;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::gc::{PyTraverseError, PyVisit};
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};

/// The callables of a world.
#[derive(Default)]
pub struct Callbacks {
    pub filter_contact: Option<Py<PyAny>>,
    pub filter_intersection: Option<Py<PyAny>>,
    pub modify_contact: Option<Py<PyAny>>,
}

impl Callbacks {
    fn all(&self) -> [&Option<Py<PyAny>>; 3] {
        [&self.filter_contact, &self.filter_intersection, &self.modify_contact]
    }

    /// Returns whether there is no callable.
    pub fn is_empty(&self) -> bool {
        self.all().into_iter().all(Option::is_none)
    }

    /// Shows the callables to the garbage collector.
    pub fn traverse(&self, visit: &PyVisit<'_>) -> Result<(), PyTraverseError> {
        self.all().into_iter().flatten().try_for_each(|callback| visit.call(callback))
    }
}

/// The callables during the steps of a world. After the first exception, no other callable runs.
pub struct RunningCallbacks<'a> {
    world: &'a Py<World>,
    callbacks: &'a Callbacks,
    failure: Mutex<Option<PyErr>>,
}

impl<'a> RunningCallbacks<'a> {
    pub fn new(world: &'a Py<World>, callbacks: &'a Callbacks) -> Self {
        Self { world, callbacks, failure: Mutex::new(None) }
    }

    /// Returns whether a callable raised an exception.
    pub fn has_failed(&self) -> bool {
        self.failure.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }

    /// The exception of a callable.
    pub fn into_result(self) -> PyResult<()> {
        self.failure.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
    }

    /// Runs a callable attached to the interpreter. `None` without a callable, or after an
    /// exception.
    fn call<R>(
        &self,
        callback: &Option<Py<PyAny>>,
        call: impl FnOnce(&Bound<'_, PyAny>) -> PyResult<R>,
    ) -> Option<R> {
        let callback = callback.as_ref().filter(|_| !self.has_failed())?;
        let result = Python::attach(|py| call(callback.bind(py)));
        result
            .map_err(|error| {
                *self.failure.lock().unwrap_or_else(PoisonError::into_inner) = Some(error)
            })
            .ok()
    }

    /// Both sides of a pair.
    fn sides(
        &self,
        py: Python<'_>,
        bodies: &RigidBodySet,
        colliders: [ColliderHandle; 2],
        handles: [Option<RigidBodyHandle>; 2],
    ) -> [Side; 2] {
        [0, 1].map(|side| {
            let data = handles[side].and_then(|handle| bodies.get(handle));
            Side {
                world: self.world.clone_ref(py),
                collider: colliders[side],
                body: handles[side],
                position: data.map(|body| body.translation()),
                linvel: data.map(|body| body.linvel()),
            }
        })
    }

    fn filter(&self, callback: &Option<Py<PyAny>>, context: &PairFilterContext<'_>) -> bool {
        let allowed = self.call(callback, |callback| {
            let colliders = [context.collider1, context.collider2];
            let bodies = [context.rigid_body1, context.rigid_body2];
            let sides = self.sides(callback.py(), context.bodies, colliders, bodies);
            callback.call1((Pair { sides },))?.is_truthy()
        });
        allowed.unwrap_or(true)
    }
}

impl PhysicsHooks for RunningCallbacks<'_> {
    fn filter_contact_pair(&self, context: &PairFilterContext<'_>) -> bool {
        self.filter(&self.callbacks.filter_contact, context)
    }

    fn filter_intersection_pair(&self, context: &PairFilterContext<'_>) -> bool {
        self.filter(&self.callbacks.filter_intersection, context)
    }

    fn modify_solver_contact(&self, context: &mut ContactModificationContext<'_>) {
        self.call(&self.callbacks.modify_contact, |callback| {
            let colliders = [context.collider1, context.collider2];
            let bodies = [context.rigid_body1, context.rigid_body2];
            let sides = self.sides(callback.py(), context.bodies, colliders, bodies);
            let contact = Bound::new(callback.py(), Contact::of(context, sides))?;
            callback.call1((&contact,))?;
            contact.borrow().apply(context);
            Ok(())
        });
    }
}

/// One side of a pair: copies of the data that a callable may need, because the world is locked
/// meanwhile.
struct Side {
    world: Py<World>,
    collider: ColliderHandle,
    body: Option<RigidBodyHandle>,
    position: Option<Vector>,
    linvel: Option<Vector>,
}

impl Side {
    fn collider(&self, py: Python<'_>) -> Collider {
        Collider { world: self.world.clone_ref(py), handle: self.collider }
    }

    fn body(&self, py: Python<'_>) -> Option<Body> {
        self.body.map(|handle| Body { world: self.world.clone_ref(py), handle })
    }
}

/// Two colliders about which a filter decides. The data are copies: a hook cannot use the world
/// that steps.
#[pyclass(frozen, module = "rapier")]
pub struct Pair {
    sides: [Side; 2],
}

/// The getters of both sides, for a class with the field `sides`.
macro_rules! getters_of_sides {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The first collider.
            #[getter]
            fn collider1(&self, py: Python<'_>) -> Collider {
                self.sides[0].collider(py)
            }

            /// The second collider.
            #[getter]
            fn collider2(&self, py: Python<'_>) -> Collider {
                self.sides[1].collider(py)
            }

            /// The body of the first collider, or None.
            #[getter]
            fn body1(&self, py: Python<'_>) -> Option<Body> {
                self.sides[0].body(py)
            }

            /// The body of the second collider, or None.
            #[getter]
            fn body2(&self, py: Python<'_>) -> Option<Body> {
                self.sides[1].body(py)
            }

            /// Position of the first body (m, world), or None.
            #[getter]
            fn position1<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<Real>>> {
                self.sides[0].position.map(|position| vector_out(py, position))
            }

            /// Position of the second body (m, world), or None.
            #[getter]
            fn position2<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<Real>>> {
                self.sides[1].position.map(|position| vector_out(py, position))
            }

            /// Velocity of the first body (m/s, world), or None.
            #[getter]
            fn linvel1<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<Real>>> {
                self.sides[0].linvel.map(|linvel| vector_out(py, linvel))
            }

            /// Velocity of the second body (m/s, world), or None.
            #[getter]
            fn linvel2<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<Real>>> {
                self.sides[1].linvel.map(|linvel| vector_out(py, linvel))
            }
        }
    };
}

getters_of_sides!(Pair);
getters_of_sides!(Contact);
traverse!(Pair, pair => pair.sides[0].world, pair.sides[1].world);
traverse!(Contact, contact => contact.sides[0].world, contact.sides[1].world);

/// The contact of two colliders, which a hook may change before it is solved. Changes act in this
/// step.
#[pyclass(module = "rapier")]
pub struct Contact {
    sides: [Side; 2],
    normal: Vector,
    points: Vec<Real>,
    friction: Real,
    restitution: Real,
    tangent_velocity: Vector,
    /// Whether the bodies push each other. Otherwise they pass, and the contact is reported.
    #[pyo3(get, set)]
    solid: bool,
    one_way: Option<(Vector, Real)>,
}

impl Contact {
    fn of(context: &ContactModificationContext<'_>, sides: [Side; 2]) -> Self {
        Self {
            sides,
            normal: context.normal(),
            points: context
                .contacts()
                .iter()
                .flat_map(|contact| contact.point.to_array())
                .collect(),
            friction: context.friction(),
            restitution: context.restitution(),
            tangent_velocity: context.tangent_velocity(),
            solid: context.solver_flags().contains(SolverFlags::COMPUTE_RIGID_IMPULSES),
            one_way: None,
        }
    }

    fn apply(&self, context: &mut ContactModificationContext<'_>) {
        context.set_friction(self.friction);
        context.set_restitution(self.restitution);
        context.set_tangent_velocity(self.tangent_velocity);
        let mut flags = context.solver_flags();
        flags.set(SolverFlags::COMPUTE_RIGID_IMPULSES, self.solid);
        context.set_solver_flags(flags);
        if let Some((normal, angle)) = self.one_way {
            context.update_as_oneway_platform(normal, angle);
        }
    }
}

#[pymethods]
impl Contact {
    /// Unit normal (world), from the first collider to the second.
    #[getter]
    fn normal<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Real>> {
        vector_out(py, self.normal)
    }

    /// The contact points (m, world), of the shape (n, DIM).
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<Real>>> {
        PyArray1::from_slice(py, &self.points).reshape([self.points.len() / DIM, DIM])
    }

    /// Largest ratio of the tangential to the normal force.
    #[getter]
    fn friction(&self) -> Real {
        self.friction
    }

    #[setter]
    fn set_friction(&mut self, friction: f64) -> PyResult<()> {
        self.friction = coefficient("friction", friction)?;
        Ok(())
    }

    /// Ratio of the speeds of separation and approach.
    #[getter]
    fn restitution(&self) -> Real {
        self.restitution
    }

    #[setter]
    fn set_restitution(&mut self, restitution: f64) -> PyResult<()> {
        self.restitution = coefficient("restitution", restitution)?;
        Ok(())
    }

    /// Velocity of the second surface relative to the first (m/s, world) that friction aims at, as
    /// for a conveyor belt.
    #[getter]
    fn tangent_velocity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Real>> {
        vector_out(py, self.tangent_velocity)
    }

    #[setter]
    fn set_tangent_velocity(&mut self, velocity: &Bound<'_, PyAny>) -> PyResult<()> {
        self.tangent_velocity = coordinates("tangent_velocity", velocity)?;
        Ok(())
    }

    /// Makes the contact solid from one side only, as for a platform. Call it in each step.
    ///
    /// normal: the solid side, in the frame of the first collider. angle: the contact is solid
    /// while its normal is within this angle (rad) of it.
    fn one_way(&mut self, normal: &Bound<'_, PyAny>, angle: f64) -> PyResult<()> {
        self.one_way = Some((vector("normal", normal)?, finite("angle", angle)?));
        Ok(())
    }
}
