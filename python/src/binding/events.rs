//! Events of steps.

use super::collider::Collider;
use super::rapier::dynamics::RigidBodySet;
use super::rapier::geometry::{ColliderSet, CollisionEvent as EngineEvent, ContactPair};
use super::rapier::pipeline::EventHandler;
use super::world::World;
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};

/// Events since they were last taken.
#[derive(Default)]
pub struct EventLog {
    collisions: Mutex<Vec<EngineEvent>>,
}

impl EventLog {
    /// Takes all events.
    pub fn take(&self) -> Vec<EngineEvent> {
        std::mem::take(&mut self.collisions.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl EventHandler for EventLog {
    fn handle_collision_event(&self, _: &RigidBodySet, _: &ColliderSet, event: &EngineEvent, _: Option<&ContactPair>) {
        self.collisions.lock().unwrap_or_else(PoisonError::into_inner).push(*event);
    }
}

/// Two colliders began or stopped to touch.
#[pyclass(frozen, module = "rapier", get_all)]
pub struct CollisionEvent {
    /// The first collider. It may have been removed since.
    collider1: Py<Collider>,
    /// The second collider.
    collider2: Py<Collider>,
    /// Whether they began to touch.
    started: bool,
    /// Whether one of them is a sensor.
    sensor: bool,
}

impl CollisionEvent {
    pub fn new(py: Python<'_>, world: &Py<World>, event: EngineEvent) -> PyResult<Self> {
        let collider = |handle| Py::new(py, Collider { world: world.clone_ref(py), handle });
        Ok(Self {
            collider1: collider(event.collider1())?,
            collider2: collider(event.collider2())?,
            started: event.started(),
            sensor: event.sensor(),
        })
    }
}

#[pymethods]
impl CollisionEvent {
    fn __repr__(&self) -> &'static str {
        if self.started { "<CollisionEvent: started>" } else { "<CollisionEvent: stopped>" }
    }
}
