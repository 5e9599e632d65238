//! Events of steps.

use super::collider::Collider;
use super::garbage::traverse;
use super::rapier::geometry::CollisionEvent as EngineEvent;
use super::rapier::pipeline::ChannelEventCollector;
use super::world::World;
use pyo3::prelude::*;
use std::sync::mpsc::{Receiver, channel};

/// Events since they were last taken.
pub struct EventLog {
    pub collector: ChannelEventCollector,
    collisions: Receiver<EngineEvent>,
}

impl EventLog {
    pub fn new() -> Self {
        let (send_collision, collisions) = channel();
        // The collector discards contact forces, because their receiver is dropped here.
        let (send_force, _) = channel();
        Self { collector: ChannelEventCollector::new(send_collision, send_force), collisions }
    }

    /// Takes all events.
    pub fn take(&mut self) -> Vec<EngineEvent> {
        self.collisions.try_iter().collect()
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

traverse!(CollisionEvent, event => event.collider1, event.collider2);

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
