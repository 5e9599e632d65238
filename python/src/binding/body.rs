//! Bodies.

use super::collider::Collider;
use super::garbage::traverse;
use super::identity::identify;
use super::numbers::{
    angular_velocity, coordinates, finite, non_negative, pose, vector, vector_out,
};
use super::options::Options;
use super::rapier::dynamics::{
    RigidBody, RigidBodyBuilder, RigidBodyHandle, RigidBodySet, RigidBodyType,
};
use super::rapier::math::{Pose, Real};
use super::space;
use super::world::World;
use crate::errors::{invalid, stale};
use numpy::PyArray1;
use pyo3::prelude::*;

/// The types of bodies with their names in Python.
const KINDS: [(&str, RigidBodyType); 4] = [
    ("dynamic", RigidBodyType::Dynamic),
    ("fixed", RigidBodyType::Fixed),
    ("kinematic_position", RigidBodyType::KinematicPositionBased),
    ("kinematic_velocity", RigidBodyType::KinematicVelocityBased),
];

fn kind_of(name: &str) -> PyResult<RigidBodyType> {
    let kind = KINDS.iter().find(|(known, _)| *known == name);
    kind.map(|(_, kind)| *kind).ok_or_else(|| {
        let names = KINDS.map(|(known, _)| known).join(", ");
        invalid(format!("kind is {name:?}, but must be one of {names}"))
    })
}

fn name_of(kind: RigidBodyType) -> &'static str {
    KINDS.iter().find(|(_, known)| *known == kind).map_or("unknown", |(name, _)| name)
}

/// A body of the arguments of `add_body`.
pub fn describe(kind: &str, options: &Options<'_>) -> PyResult<RigidBody> {
    let (position, rotation) = (options.any("position")?, options.any("rotation")?);
    let mut body = RigidBodyBuilder::new(kind_of(kind)?).pose(pose(
        Pose::IDENTITY,
        position.as_ref(),
        rotation.as_ref(),
    )?);
    if let Some(linvel) = options.any("linvel")? {
        body = body.linvel(coordinates("linvel", &linvel)?);
    }
    if let Some(angvel) = options.any("angvel")? {
        body = body.angvel(angular_velocity("angvel", &angvel)?);
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
    body = body
        .ccd_enabled(options.take("ccd")?.unwrap_or(false))
        .can_sleep(options.take("can_sleep")?.unwrap_or(true));
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

identify!(Body by handle);
traverse!(Body, body => body.world);

impl Body {
    /// The handle, if the body is in this world. `bodies` is the locked set of the world.
    pub fn handle_in(
        &self,
        world: &Bound<'_, World>,
        bodies: &RigidBodySet,
    ) -> PyResult<RigidBodyHandle> {
        if !self.world.is(world) {
            return Err(invalid("the body belongs to another world"));
        }
        match bodies.contains(self.handle) {
            true => Ok(self.handle),
            false => Err(stale("body")),
        }
    }

    fn read<R>(&self, py: Python<'_>, read: impl FnOnce(&RigidBody) -> R) -> PyResult<R> {
        self.world
            .get()
            .lock(py)?
            .simulation
            .world
            .bodies
            .get(self.handle)
            .map(read)
            .ok_or_else(|| stale("body"))
    }

    fn write<R>(&self, py: Python<'_>, change: impl FnOnce(&mut RigidBody) -> R) -> PyResult<R> {
        self.world
            .get()
            .lock(py)?
            .simulation
            .world
            .bodies
            .get_mut(self.handle)
            .map(change)
            .ok_or_else(|| stale("body"))
    }
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
    fn kind(&self, py: Python<'_>) -> PyResult<&'static str> {
        self.read(py, |body| name_of(body.body_type()))
    }

    #[setter]
    fn set_kind(&self, py: Python<'_>, kind: &str) -> PyResult<()> {
        let kind = kind_of(kind)?;
        self.write(py, |body| body.set_body_type(kind, true))
    }

    /// Position of the body's origin (m, world).
    #[getter]
    fn position<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        Ok(vector_out(py, self.read(py, |body| body.position().translation)?))
    }

    #[setter]
    fn set_position(&self, py: Python<'_>, position: &Bound<'_, PyAny>) -> PyResult<()> {
        let position = coordinates("position", position)?;
        self.write(py, |body| body.set_translation(position, true))
    }

    /// Rotation: a quaternion (x, y, z, w) in 3D, an angle (rad) in 2D.
    #[getter]
    fn rotation<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        out(py, &self.read(py, |body| space::rotation_numbers(body.rotation()))?)
    }

    #[setter]
    fn set_rotation(&self, py: Python<'_>, rotation: &Bound<'_, PyAny>) -> PyResult<()> {
        let rotation = space::rotation("rotation", rotation)?;
        self.write(py, |body| body.set_rotation(rotation, true))
    }

    /// Velocity of the centre of mass (m/s, world).
    #[getter]
    fn linvel<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        Ok(vector_out(py, self.read(py, RigidBody::linvel)?))
    }

    #[setter]
    fn set_linvel(&self, py: Python<'_>, linvel: &Bound<'_, PyAny>) -> PyResult<()> {
        let linvel = coordinates("linvel", linvel)?;
        self.write(py, |body| body.set_linvel(linvel, true))
    }

    /// Angular velocity (rad/s, world): an array in 3D, a float in 2D.
    #[getter]
    fn angvel<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        out(py, &self.read(py, |body| space::angular_numbers(body.angvel()))?)
    }

    #[setter]
    fn set_angvel(&self, py: Python<'_>, angvel: &Bound<'_, PyAny>) -> PyResult<()> {
        let angvel = angular_velocity("angvel", angvel)?;
        self.write(py, |body| body.set_angvel(angvel, true))
    }

    /// Mass (kg), colliders included.
    #[getter]
    fn mass(&self, py: Python<'_>) -> PyResult<Real> {
        self.read(py, RigidBody::mass)
    }

    /// The centre of mass (m, world).
    #[getter]
    fn center_of_mass<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<Real>>> {
        Ok(vector_out(py, self.read(py, RigidBody::center_of_mass)?))
    }

    /// Kinetic energy (J).
    #[getter]
    fn kinetic_energy(&self, py: Python<'_>) -> PyResult<Real> {
        self.read(py, RigidBody::kinetic_energy)
    }

    /// Factor of the world's gravity.
    #[getter]
    fn gravity_scale(&self, py: Python<'_>) -> PyResult<Real> {
        self.read(py, RigidBody::gravity_scale)
    }

    #[setter]
    fn set_gravity_scale(&self, py: Python<'_>, scale: f64) -> PyResult<()> {
        let scale = finite("gravity_scale", scale)?;
        self.write(py, |body| body.set_gravity_scale(scale, true))
    }

    /// Whether the body takes part in the simulation.
    #[getter]
    fn enabled(&self, py: Python<'_>) -> PyResult<bool> {
        self.read(py, RigidBody::is_enabled)
    }

    #[setter]
    fn set_enabled(&self, py: Python<'_>, enabled: bool) -> PyResult<()> {
        self.write(py, |body| body.set_enabled(enabled))
    }

    /// Whether the body sleeps.
    #[getter]
    fn sleeping(&self, py: Python<'_>) -> PyResult<bool> {
        self.read(py, RigidBody::is_sleeping)
    }

    /// Wakes the body.
    fn wake_up(&self, py: Python<'_>) -> PyResult<()> {
        self.write(py, |body| body.wake_up(true))
    }

    /// Adds a constant force (N, world) at the centre of mass. It acts in each step until
    /// `reset_forces`.
    fn add_force(&self, py: Python<'_>, force: &Bound<'_, PyAny>) -> PyResult<()> {
        let force = vector("force", force)?;
        self.write(py, |body| body.add_force(force, true))
    }

    /// Adds a constant torque (N·m, world). It acts in each step until `reset_forces`.
    fn add_torque(&self, py: Python<'_>, torque: &Bound<'_, PyAny>) -> PyResult<()> {
        let torque = space::angular("torque", torque)?;
        self.write(py, |body| body.add_torque(torque, true))
    }

    /// Ends the constant forces and torques.
    fn reset_forces(&self, py: Python<'_>) -> PyResult<()> {
        self.write(py, |body| {
            body.reset_forces(true);
            body.reset_torques(true);
        })
    }

    /// Changes the velocity at once by an impulse (N·s, world) at the centre of mass, or at a point
    /// (m, world).
    #[pyo3(signature = (impulse, point=None))]
    fn apply_impulse(
        &self,
        py: Python<'_>,
        impulse: &Bound<'_, PyAny>,
        point: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let impulse = vector("impulse", impulse)?;
        let point = point.map(|point| coordinates("point", point)).transpose()?;
        self.write(py, |body| match point {
            Some(point) => body.apply_impulse_at_point(impulse, point, true),
            None => body.apply_impulse(impulse, true),
        })
    }

    /// Changes the angular velocity at once by an angular impulse (N·m·s, world).
    fn apply_torque_impulse(&self, py: Python<'_>, impulse: &Bound<'_, PyAny>) -> PyResult<()> {
        let impulse = space::angular("impulse", impulse)?;
        self.write(py, |body| body.apply_torque_impulse(impulse, true))
    }

    /// Moves a "kinematic_position" body to a pose during the next step. An absent part stays as it
    /// is, or as an earlier call before the step sets it.
    ///
    /// position: of the body's origin (m, world). rotation: a quaternion (x, y, z, w) in 3D, an
    /// angle (rad) in 2D.
    #[pyo3(signature = (position=None, rotation=None))]
    fn move_to(
        &self,
        py: Python<'_>,
        position: Option<&Bound<'_, PyAny>>,
        rotation: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let (next, kind) = self.read(py, |body| (*body.next_position(), body.body_type()))?;
        if kind != RigidBodyType::KinematicPositionBased {
            return Err(invalid(format!(
                "the kind is {}, but move_to needs a kinematic_position body",
                name_of(kind)
            )));
        }
        let target = pose(next, position, rotation)?;
        self.write(py, |body| body.set_next_kinematic_position(target))
    }

    /// The colliders of the body.
    #[getter]
    fn colliders(&self, py: Python<'_>) -> PyResult<Vec<Collider>> {
        let handles = self.read(py, |body| body.colliders().to_vec())?;
        Ok(handles
            .into_iter()
            .map(|handle| Collider { world: self.world.clone_ref(py), handle })
            .collect())
    }

    /// Removes the body with its colliders and joints.
    fn remove(&self, py: Python<'_>) -> PyResult<()> {
        let mut state = self.world.get().lock(py)?;
        let world = &mut state.simulation.world;
        let colliders =
            world.bodies.get(self.handle).ok_or_else(|| stale("body"))?.colliders().to_vec();
        // The engine would remove them in the next step.
        for collider in colliders {
            world.remove_collider(collider);
        }
        world.remove_body(self.handle);
        Ok(())
    }

    /// Whether the body is still in its world.
    #[getter]
    fn alive(&self, py: Python<'_>) -> PyResult<bool> {
        Ok(self.world.get().lock(py)?.simulation.world.bodies.contains(self.handle))
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        match self.read(py, |body| {
            format!("<Body: {} at {}>", name_of(body.body_type()), body.translation())
        }) {
            Ok(text) => text,
            Err(_) => "<Body: removed>".into(),
        }
    }
}
