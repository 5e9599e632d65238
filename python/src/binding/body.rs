//! Bodies.

use super::collider::Collider;
use super::numbers::{finite, non_negative, numbers, vector_out};
use super::options::Options;
use super::rapier::dynamics::{RigidBody, RigidBodyBuilder, RigidBodyHandle, RigidBodyType};
use super::rapier::math::{AngVector, DIM, Real, Vector};
use super::space;
use super::world::World;
use crate::errors::{invalid, stale};
use numpy::PyArray1;
use pyo3::prelude::*;

/// The type of a body by its name in Python.
fn kind_of(name: &str) -> PyResult<RigidBodyType> {
    match name {
        "dynamic" => Ok(RigidBodyType::Dynamic),
        "fixed" => Ok(RigidBodyType::Fixed),
        "kinematic_position" => Ok(RigidBodyType::KinematicPositionBased),
        "kinematic_velocity" => Ok(RigidBodyType::KinematicVelocityBased),
        _ => Err(invalid(format!("kind is {name:?}, but must be dynamic, fixed, kinematic_position or kinematic_velocity"))),
    }
}

fn name_of(kind: RigidBodyType) -> &'static str {
    match kind {
        RigidBodyType::Dynamic => "dynamic",
        RigidBodyType::Fixed => "fixed",
        RigidBodyType::KinematicPositionBased => "kinematic_position",
        RigidBodyType::KinematicVelocityBased => "kinematic_velocity",
    }
}

/// A body of the arguments of `add_body`.
pub fn describe(kind: &str, options: &Options<'_>) -> PyResult<RigidBody> {
    let (position, rotation) = (options.any("position")?, options.any("rotation")?);
    let mut body = RigidBodyBuilder::new(kind_of(kind)?).pose(super::numbers::pose(position.as_ref(), rotation.as_ref())?);
    if let Some(linvel) = options.any("linvel")? {
        body = body.linvel(space::vector("linvel", &linvel)?);
    }
    if let Some(angvel) = options.any("angvel")? {
        body = body.angvel(space::angular("angvel", &angvel)?);
    }
    if let Some(scale) = options.take("gravity_scale")? {
        body = body.gravity_scale(finite("gravity_scale", scale)?);
    }
    if let Some(damping) = options.take("linear_damping")? {
        body = body.linear_damping(non_negative("linear_damping", damping)?);
    }
    if let Some(damping) = options.take("angular_damping")? {
        body = body.angular_damping(non_negative("angular_damping", damping)?);
    }
    if let Some(mass) = options.take("additional_mass")? {
        body = body.additional_mass(non_negative("additional_mass", mass)?);
    }
    body = body.ccd_enabled(options.take("ccd")?.unwrap_or(false)).can_sleep(options.take("can_sleep")?.unwrap_or(true));
    if options.take("lock_translations")?.unwrap_or(false) {
        body = body.lock_translations();
    }
    if options.take("lock_rotations")?.unwrap_or(false) {
        body = body.lock_rotations();
    }
    body.try_build().map_err(invalid)
}

/// A rigid body of a world. After its removal, every use raises `StaleHandleError`.
#[pyclass(frozen, module = "rapier", eq, hash)]
pub struct Body {
    pub world: Py<World>,
    pub handle: RigidBodyHandle,
}

impl PartialEq for Body {
    fn eq(&self, other: &Self) -> bool {
        self.world.is(&other.world) && self.handle == other.handle
    }
}

impl std::hash::Hash for Body {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.handle.hash(state);
    }
}

impl Body {
    /// The handle, if the body is in this world.
    pub fn handle_in(&self, world: &Bound<'_, World>) -> PyResult<RigidBodyHandle> {
        if !self.world.is(world) {
            return Err(invalid("the body belongs to another world"));
        }
        match world.get().read().world.bodies.contains(self.handle) {
            true => Ok(self.handle),
            false => Err(stale("body")),
        }
    }

    fn read<R>(&self, read: impl FnOnce(&RigidBody) -> R) -> PyResult<R> {
        self.world.get().read().world.bodies.get(self.handle).map(read).ok_or_else(|| stale("body"))
    }

    fn write(&self, change: impl FnOnce(&mut RigidBody)) -> PyResult<()> {
        self.world.get().write().world.bodies.get_mut(self.handle).map(change).ok_or_else(|| stale("body"))
    }
}

/// Numbers of an angular quantity: a float in 2D, an array in 3D.
fn angular_out<'py>(py: Python<'py>, value: AngVector) -> PyResult<Bound<'py, PyAny>> {
    out(py, &space::angular_numbers(value))
}

/// A float of one number, or an array of several.
fn out<'py>(py: Python<'py>, numbers: &[Real]) -> PyResult<Bound<'py, PyAny>> {
    match numbers {
        [number] => Ok(number.into_pyobject(py)?.into_any()),
        _ => Ok(PyArray1::from_slice(py, numbers).into_any()),
    }
}

#[pymethods]
impl Body {
    /// The type: "dynamic", "fixed", "kinematic_position" or "kinematic_velocity".
    #[getter]
    fn kind(&self) -> PyResult<&'static str> {
        self.read(|body| name_of(body.body_type()))
    }

    #[setter]
    fn set_kind(&self, kind: &str) -> PyResult<()> {
        let kind = kind_of(kind)?;
        self.write(|body| body.set_body_type(kind, true))
    }

    /// Position of the body's origin (m, world).
    #[getter]
    fn position<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        Ok(vector_out(py, self.read(|body| body.position().translation)?))
    }

    #[setter]
    fn set_position(&self, position: &Bound<'_, PyAny>) -> PyResult<()> {
        let position = space::vector("position", position)?;
        self.write(|body| body.set_translation(position, true))
    }

    /// Rotation: a quaternion (x, y, z, w) in 3D, an angle (rad) in 2D.
    #[getter]
    fn rotation<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        out(py, &self.read(|body| space::rotation_numbers(body.rotation()))?)
    }

    #[setter]
    fn set_rotation(&self, rotation: &Bound<'_, PyAny>) -> PyResult<()> {
        let rotation = space::rotation("rotation", rotation)?;
        self.write(|body| body.set_rotation(rotation, true))
    }

    /// Velocity of the centre of mass (m/s, world).
    #[getter]
    fn linvel<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        Ok(vector_out(py, self.read(RigidBody::linvel)?))
    }

    #[setter]
    fn set_linvel(&self, linvel: &Bound<'_, PyAny>) -> PyResult<()> {
        let linvel = space::vector("linvel", linvel)?;
        self.write(|body| body.set_linvel(linvel, true))
    }

    /// Angular velocity (rad/s, world): an array in 3D, a float in 2D.
    #[getter]
    fn angvel<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        angular_out(py, self.read(RigidBody::angvel)?)
    }

    #[setter]
    fn set_angvel(&self, angvel: &Bound<'_, PyAny>) -> PyResult<()> {
        let angvel = space::angular("angvel", angvel)?;
        self.write(|body| body.set_angvel(angvel, true))
    }

    /// Mass (kg), colliders included.
    #[getter]
    fn mass(&self) -> PyResult<Real> {
        self.read(RigidBody::mass)
    }

    /// The centre of mass (m, world).
    #[getter]
    fn center_of_mass<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        Ok(vector_out(py, self.read(RigidBody::center_of_mass)?))
    }

    /// Kinetic energy (J).
    #[getter]
    fn kinetic_energy(&self) -> PyResult<Real> {
        self.read(RigidBody::kinetic_energy)
    }

    /// Factor of the world's gravity.
    #[getter]
    fn gravity_scale(&self) -> PyResult<Real> {
        self.read(RigidBody::gravity_scale)
    }

    #[setter]
    fn set_gravity_scale(&self, scale: f64) -> PyResult<()> {
        let scale = finite("gravity_scale", scale)?;
        self.write(|body| body.set_gravity_scale(scale, true))
    }

    /// Whether the body takes part in the simulation.
    #[getter]
    fn enabled(&self) -> PyResult<bool> {
        self.read(RigidBody::is_enabled)
    }

    #[setter]
    fn set_enabled(&self, enabled: bool) -> PyResult<()> {
        self.write(|body| body.set_enabled(enabled))
    }

    /// Whether the body sleeps.
    #[getter]
    fn sleeping(&self) -> PyResult<bool> {
        self.read(RigidBody::is_sleeping)
    }

    /// Wakes the body.
    fn wake_up(&self) -> PyResult<()> {
        self.write(|body| body.wake_up(true))
    }

    /// Adds a constant force (N, world) at the centre of mass. It acts in each step until `reset_forces`.
    fn add_force(&self, force: &Bound<'_, PyAny>) -> PyResult<()> {
        let force = space::vector("force", force)?;
        self.write(|body| body.add_force(force, true))
    }

    /// Adds a constant torque (N·m, world). It acts in each step until `reset_forces`.
    fn add_torque(&self, torque: &Bound<'_, PyAny>) -> PyResult<()> {
        let torque = space::angular("torque", torque)?;
        self.write(|body| body.add_torque(torque, true))
    }

    /// Ends the constant forces and torques.
    fn reset_forces(&self) -> PyResult<()> {
        self.write(|body| {
            body.reset_forces(true);
            body.reset_torques(true);
        })
    }

    /// Changes the velocity at once by an impulse (N·s, world) at the centre of mass, or at a point (m, world).
    #[pyo3(signature = (impulse, point=None))]
    fn apply_impulse(&self, impulse: &Bound<'_, PyAny>, point: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let impulse = space::vector("impulse", impulse)?;
        let point = point.map(|point| numbers::<DIM>("point", point)).transpose()?.map(Vector::from_array);
        self.write(|body| match point {
            Some(point) => body.apply_impulse_at_point(impulse, point, true),
            None => body.apply_impulse(impulse, true),
        })
    }

    /// Changes the angular velocity at once by an angular impulse (N·m·s, world).
    fn apply_torque_impulse(&self, impulse: &Bound<'_, PyAny>) -> PyResult<()> {
        let impulse = space::angular("impulse", impulse)?;
        self.write(|body| body.apply_torque_impulse(impulse, true))
    }

    /// Moves a "kinematic_position" body to a pose during the next step.
    #[pyo3(signature = (position=None, rotation=None))]
    fn move_to(&self, position: Option<&Bound<'_, PyAny>>, rotation: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let pose = super::numbers::pose(position, rotation)?;
        let (moves, turns) = (position.is_some(), rotation.is_some());
        self.write(|body| {
            let mut target = *body.position();
            if moves {
                target.translation = pose.translation;
            }
            if turns {
                target.rotation = pose.rotation;
            }
            body.set_next_kinematic_position(target);
        })
    }

    /// The colliders of the body.
    #[getter]
    fn colliders(&self, py: Python<'_>) -> PyResult<Vec<Collider>> {
        let handles = self.read(|body| body.colliders().to_vec())?;
        Ok(handles.into_iter().map(|handle| Collider { world: self.world.clone_ref(py), handle }).collect())
    }

    /// Removes the body with its colliders and joints.
    fn remove(&self) -> PyResult<()> {
        let world = &mut self.world.get().write().world;
        let colliders = world.bodies.get(self.handle).ok_or_else(|| stale("body"))?.colliders().to_vec();
        // The engine would remove them in the next step.
        for collider in colliders {
            world.remove_collider(collider);
        }
        world.remove_body(self.handle);
        Ok(())
    }

    /// Whether the body is still in its world.
    #[getter]
    fn alive(&self) -> bool {
        self.world.get().read().world.bodies.contains(self.handle)
    }

    fn __repr__(&self) -> String {
        match self.read(|body| format!("<Body: {} at {}>", name_of(body.body_type()), body.translation())) {
            Ok(text) => text,
            Err(_) => "<Body: removed>".into(),
        }
    }
}
