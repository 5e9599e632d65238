//! Colliders.

use super::body::Body;
use super::garbage::traverse;
use super::identity::identify;
use super::numbers::{coefficient, non_negative, pose, vector_out};
use super::options::Options;
use super::rapier::dynamics::CoefficientCombineRule;
use super::rapier::geometry::{
    Collider as EngineCollider, ColliderBuilder, ColliderHandle, ContactPair, Group,
    InteractionGroups,
};
use super::rapier::math::{Pose, Real};
use super::rapier::pipeline::{ActiveEvents, ActiveHooks, PhysicsWorld};
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
    let place = pose(Pose::IDENTITY, position.as_ref(), rotation.as_ref())?;
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
    if let Some(rule) = options.take::<String>("friction_combine_rule")? {
        collider = collider.friction_combine_rule(combine_rule(&rule)?);
    }
    if let Some(rule) = options.take::<String>("restitution_combine_rule")? {
        collider = collider.restitution_combine_rule(combine_rule(&rule)?);
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
    if options.take("hooks")?.unwrap_or(false) {
        collider = collider.active_hooks(ActiveHooks::all());
    }
    if options.take("events")?.unwrap_or(false) {
        collider = collider.active_events(ActiveEvents::COLLISION_EVENTS);
    }
    collider.sensor(options.take("sensor")?.unwrap_or(false)).try_build().map_err(invalid)
}

/// The rules of two coefficients by their names in Python.
const COMBINE_RULES: [(&str, CoefficientCombineRule); 6] = [
    ("average", CoefficientCombineRule::Average),
    ("min", CoefficientCombineRule::Min),
    ("multiply", CoefficientCombineRule::Multiply),
    ("max", CoefficientCombineRule::Max),
    ("clamped_sum", CoefficientCombineRule::ClampedSum),
    ("geometric_mean", CoefficientCombineRule::GeometricMean),
];

fn combine_rule(name: &str) -> PyResult<CoefficientCombineRule> {
    let rule = COMBINE_RULES.into_iter().find(|(own, _)| *own == name).map(|(_, rule)| rule);
    let names = || COMBINE_RULES.map(|(name, _)| name).join(", ");
    rule.ok_or_else(|| {
        invalid(format!("the combine rule is {name}, but must be one of {}", names()))
    })
}

fn groups_of((memberships, filter): (u32, u32)) -> InteractionGroups {
    InteractionGroups {
        memberships: Group::from_bits_retain(memberships),
        filter: Group::from_bits_retain(filter),
        ..InteractionGroups::default()
    }
}

/// A collider of a world: a shape with a material. After its removal, every use raises
/// `StaleHandleError`.
#[pyclass(frozen, module = "rapier", eq, hash)]
pub struct Collider {
    pub world: Py<World>,
    pub handle: ColliderHandle,
}

identify!(Collider by handle);
traverse!(Collider, collider => collider.world);

impl Collider {
    fn read<R>(&self, py: Python<'_>, read: impl FnOnce(&EngineCollider) -> R) -> PyResult<R> {
        self.world
            .get()
            .lock(py)?
            .simulation
            .world
            .colliders
            .get(self.handle)
            .map(read)
            .ok_or_else(|| stale("collider"))
    }

    fn write(&self, py: Python<'_>, change: impl FnOnce(&mut EngineCollider)) -> PyResult<()> {
        self.world
            .get()
            .lock(py)?
            .simulation
            .world
            .colliders
            .get_mut(self.handle)
            .map(change)
            .ok_or_else(|| stale("collider"))
    }

    /// The pose in the world, also if the body was moved since the last step.
    fn pose_in(&self, world: &PhysicsWorld) -> Option<Pose> {
        let collider = world.colliders.get(self.handle)?;
        let body = collider.parent().and_then(|handle| world.bodies.get(handle));
        let attached = body.zip(collider.position_wrt_parent());
        Some(attached.map_or(*collider.position(), |(body, local)| body.position() * local))
    }

    fn touching_handles(&self, world: &PhysicsWorld) -> PyResult<Vec<ColliderHandle>> {
        if !world.colliders.contains(self.handle) {
            return Err(stale("collider"));
        }
        let pairs =
            world.contact_pairs_with(self.handle).filter(|pair| pair.has_any_active_contact());
        let other = |pair: &ContactPair| {
            if pair.collider1 == self.handle { pair.collider2 } else { pair.collider1 }
        };
        Ok(pairs.map(other).collect())
    }
}

#[pymethods]
impl Collider {
    /// The body of the collider, or None for a part of the world.
    #[getter]
    fn body(&self, py: Python<'_>) -> PyResult<Option<Body>> {
        let parent = self.read(py, EngineCollider::parent)?;
        Ok(parent.map(|handle| Body { world: self.world.clone_ref(py), handle }))
    }

    /// Position of the shape's origin (m, world).
    #[getter]
    fn position<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        let pose = self.pose_in(&self.world.get().lock(py)?.simulation.world);
        Ok(vector_out(py, pose.ok_or_else(|| stale("collider"))?.translation))
    }

    /// Largest ratio of the tangential to the normal contact force.
    #[getter]
    fn friction(&self, py: Python<'_>) -> PyResult<Real> {
        self.read(py, EngineCollider::friction)
    }

    #[setter]
    fn set_friction(&self, py: Python<'_>, friction: f64) -> PyResult<()> {
        let friction = coefficient("friction", friction)?;
        self.write(py, |collider| collider.set_friction(friction))
    }

    /// Ratio of the speeds of separation and approach.
    #[getter]
    fn restitution(&self, py: Python<'_>) -> PyResult<Real> {
        self.read(py, EngineCollider::restitution)
    }

    #[setter]
    fn set_restitution(&self, py: Python<'_>, restitution: f64) -> PyResult<()> {
        let restitution = coefficient("restitution", restitution)?;
        self.write(py, |collider| collider.set_restitution(restitution))
    }

    /// Whether the collider reports intersections and exerts no forces.
    #[getter]
    fn sensor(&self, py: Python<'_>) -> PyResult<bool> {
        self.read(py, EngineCollider::is_sensor)
    }

    /// The colliders with which it has contact, as of the last step.
    #[getter]
    fn touching(&self, py: Python<'_>) -> PyResult<Vec<Collider>> {
        let handles = self.touching_handles(&self.world.get().lock(py)?.simulation.world)?;
        Ok(handles
            .into_iter()
            .map(|handle| Collider { world: self.world.clone_ref(py), handle })
            .collect())
    }

    /// Removes the collider.
    fn remove(&self, py: Python<'_>) -> PyResult<()> {
        self.world
            .get()
            .lock(py)?
            .simulation
            .world
            .remove_collider(self.handle)
            .map(drop)
            .ok_or_else(|| stale("collider"))
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        match self.read(py, |collider| format!("<Collider: {:?}>", collider.shape().shape_type())) {
            Ok(text) => text,
            Err(_) => "<Collider: removed>".into(),
        }
    }
}
