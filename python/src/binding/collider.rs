//! Colliders.

use super::body::Body;
use super::numbers::{finite, non_negative, pose, vector_out};
use super::options::Options;
use super::rapier::geometry::{Collider as EngineCollider, ColliderBuilder, ColliderHandle, Group, InteractionGroups};
use super::rapier::math::Real;
use super::rapier::pipeline::ActiveEvents;
use super::shape::Shape;
use super::world::World;
use crate::errors::{invalid, stale};
use numpy::PyArray1;
use pyo3::prelude::*;

/// A collider of the arguments of `add_body`: without a pose of its own.
pub fn describe(shape: &Shape, options: &Options<'_>) -> PyResult<EngineCollider> {
    build(ColliderBuilder::new(shape.shape.clone()), options)
}

/// A collider of the arguments of `add_collider`.
pub fn describe_placed(shape: &Shape, options: &Options<'_>) -> PyResult<EngineCollider> {
    let (position, rotation) = (options.any("position")?, options.any("rotation")?);
    let place = pose(position.as_ref(), rotation.as_ref())?;
    build(ColliderBuilder::new(shape.shape.clone()).position(place), options)
}

fn build(mut collider: ColliderBuilder, options: &Options<'_>) -> PyResult<EngineCollider> {
    if let Some(density) = options.take("density")? {
        collider = collider.density(non_negative("density", density)?);
    }
    if let Some(mass) = options.take("mass")? {
        collider = collider.mass(non_negative("mass", mass)?);
    }
    if let Some(friction) = options.take("friction")? {
        collider = collider.friction(non_negative("friction", friction)?);
    }
    if let Some(restitution) = options.take("restitution")? {
        collider = collider.restitution(non_negative("restitution", restitution)?);
    }
    if let Some(skin) = options.take("contact_skin")? {
        collider = collider.contact_skin(non_negative("contact_skin", skin)?);
    }
    if let Some(groups) = options.take::<(u32, u32)>("collision_groups")? {
        collider = collider.collision_groups(groups_of(groups));
    }
    if let Some(groups) = options.take::<(u32, u32)>("solver_groups")? {
        collider = collider.solver_groups(groups_of(groups));
    }
    if options.take("events")?.unwrap_or(false) {
        collider = collider.active_events(ActiveEvents::COLLISION_EVENTS);
    }
    collider.sensor(options.take("sensor")?.unwrap_or(false)).try_build().map_err(invalid)
}

fn groups_of((memberships, filter): (u32, u32)) -> InteractionGroups {
    InteractionGroups { memberships: Group::from_bits_retain(memberships), filter: Group::from_bits_retain(filter), ..InteractionGroups::default() }
}

/// A collider of a world: a shape with a material. After its removal, every use raises `StaleHandleError`.
#[pyclass(frozen, module = "rapier", eq, hash)]
pub struct Collider {
    pub world: Py<World>,
    pub handle: ColliderHandle,
}

impl PartialEq for Collider {
    fn eq(&self, other: &Self) -> bool {
        self.world.is(&other.world) && self.handle == other.handle
    }
}

impl std::hash::Hash for Collider {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.handle.hash(state);
    }
}

impl Collider {
    fn read<R>(&self, read: impl FnOnce(&EngineCollider) -> R) -> PyResult<R> {
        self.world.get().read().world.colliders.get(self.handle).map(read).ok_or_else(|| stale("collider"))
    }

    fn write(&self, change: impl FnOnce(&mut EngineCollider)) -> PyResult<()> {
        self.world.get().write().world.colliders.get_mut(self.handle).map(change).ok_or_else(|| stale("collider"))
    }
}

#[pymethods]
impl Collider {
    /// The body of the collider, or None for a part of the world.
    #[getter]
    fn body(&self, py: Python<'_>) -> PyResult<Option<Body>> {
        let parent = self.read(EngineCollider::parent)?;
        Ok(parent.map(|handle| Body { world: self.world.clone_ref(py), handle }))
    }

    /// Position of the shape's origin (m, world), as of the last step.
    #[getter]
    fn position<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        Ok(vector_out(py, self.read(|collider| collider.position().translation)?))
    }

    /// Largest ratio of the tangential to the normal contact force.
    #[getter]
    fn friction(&self) -> PyResult<Real> {
        self.read(EngineCollider::friction)
    }

    #[setter]
    fn set_friction(&self, friction: f64) -> PyResult<()> {
        let friction = non_negative("friction", friction)?;
        self.write(|collider| collider.set_friction(friction))
    }

    /// Ratio of the speeds of separation and approach.
    #[getter]
    fn restitution(&self) -> PyResult<Real> {
        self.read(EngineCollider::restitution)
    }

    #[setter]
    fn set_restitution(&self, restitution: f64) -> PyResult<()> {
        let restitution = finite("restitution", restitution)?;
        self.write(|collider| collider.set_restitution(restitution))
    }

    /// Whether the collider reports intersections and exerts no forces.
    #[getter]
    fn sensor(&self) -> PyResult<bool> {
        self.read(EngineCollider::is_sensor)
    }

    /// The colliders with which it has contact, as of the last step.
    #[getter]
    fn touching(&self, py: Python<'_>) -> PyResult<Vec<Collider>> {
        let world = self.world.get().read();
        if !world.world.colliders.contains(self.handle) {
            return Err(stale("collider"));
        }
        let pairs = world.world.contact_pairs_with(self.handle).filter(|pair| pair.has_any_active_contact());
        let other = |pair: &super::rapier::geometry::ContactPair| if pair.collider1 == self.handle { pair.collider2 } else { pair.collider1 };
        Ok(pairs.map(|pair| Collider { world: self.world.clone_ref(py), handle: other(pair) }).collect())
    }

    /// Removes the collider.
    fn remove(&self) -> PyResult<()> {
        self.world.get().write().world.remove_collider(self.handle).map(drop).ok_or_else(|| stale("collider"))
    }

    fn __repr__(&self) -> String {
        match self.read(|collider| format!("<Collider: {:?}>", collider.shape().shape_type())) {
            Ok(text) => text,
            Err(_) => "<Collider: removed>".into(),
        }
    }
}
