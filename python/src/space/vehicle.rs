//! Vehicles: a chassis whose wheels are rays. 3D only.

use super::super::binding::batch::WorldBatch;
use super::super::binding::body::Body;
use super::super::binding::garbage::traverse;
use super::super::binding::numbers::{
    coordinates, finite, finite_elements, non_negative, shaped_array, vector,
};
use super::super::binding::options::Options;
use super::super::binding::world::World;
use super::super::rapier::control::{DynamicRayCastVehicleController, WheelTuning};
use super::super::rapier::dynamics::RigidBodyHandle;
use super::super::rapier::math::{DIM, Real, Rotation, Vector};
use super::super::rapier::pipeline::{PhysicsWorld, QueryFilter, QueryPipelineMut};
use crate::errors::{SnapshotError, invalid, stale};
use drawing::{Color, Drawing, Instance, Mesh, Role};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Numbers of the controls of a wheel: engine force, brake force, steering.
const CONTROLS: usize = 3;
/// Colour of wheels in pictures (hue in degrees, saturation, lightness).
const WHEEL_COLOR: [f32; 3] = [218.0, 0.12, 0.22];
/// Half of the width of a wheel in pictures, as a fraction of the radius.
const WHEEL_HALF_WIDTH: f32 = 0.35;

/// The vehicles of a world, by their index. A removed vehicle leaves a gap.
#[derive(Clone, Default)]
pub struct Vehicles(Vec<Option<Braked>>);

/// A vehicle with the brake forces (N) of its wheels. Brakes of the engine are impulses in one step, which
/// depend on its length.
#[derive(Clone)]
struct Braked {
    controller: DynamicRayCastVehicleController,
    brakes: Vec<Real>,
}

impl Braked {
    fn new(chassis: RigidBodyHandle) -> Self {
        Self { controller: DynamicRayCastVehicleController::new(chassis), brakes: Vec::new() }
    }

    /// The controls of the wheels, with [`CONTROLS`] numbers each.
    fn controls(&self) -> Vec<Real> {
        let rows = self.controller.wheels().iter().zip(&self.brakes);
        rows.flat_map(|(wheel, &brake)| [wheel.engine_force, brake, wheel.steering]).collect()
    }

    /// Sets the controls of the wheels, with [`CONTROLS`] numbers each.
    fn set_controls(&mut self, rows: &[Real]) {
        let wheels = self.controller.wheels_mut().iter_mut().zip(&mut self.brakes);
        for ((wheel, brake), row) in wheels.zip(rows.chunks_exact(CONTROLS)) {
            (wheel.engine_force, *brake, wheel.steering) = (row[0], row[1], row[2]);
        }
    }

    /// Applies the wheels to the bodies for the next step.
    fn update(&mut self, dt: Real, queries: QueryPipelineMut<'_>) {
        for (wheel, force) in self.controller.wheels_mut().iter_mut().zip(&self.brakes) {
            wheel.brake = force * dt;
        }
        self.controller.update_vehicle(dt, queries);
    }
}

impl Vehicles {
    /// Applies the wheels to the bodies for the next step.
    pub fn update(&mut self, world: &mut PhysicsWorld) {
        let dt = world.integration_parameters.dt;
        for vehicle in self.0.iter_mut().flatten() {
            vehicle.update(dt, world.query_pipeline_mut(QueryFilter::default()));
        }
    }

    /// The vehicles as bytes.
    pub fn to_bytes(&self) -> Result<Vec<u8>, String> {
        let vehicles = self.0.iter().map(|vehicle| {
            let Braked { controller, brakes } = vehicle.as_ref()?;
            Some((controller, brakes))
        });
        let vehicles: Vec<_> = vehicles.collect();
        postcard::to_allocvec(&vehicles).map_err(|error| error.to_string())
    }

    /// The vehicles of [`Self::to_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> PyResult<Self> {
        let vehicles: Vec<Option<(DynamicRayCastVehicleController, Vec<Real>)>> =
            postcard::from_bytes(bytes)
                .map_err(|error| SnapshotError::new_err(error.to_string()))?;
        let fits = |vehicle: &(DynamicRayCastVehicleController, Vec<Real>)| {
            vehicle.0.wheels().len() == vehicle.1.len()
        };
        if !vehicles.iter().flatten().all(fits) {
            return Err(SnapshotError::new_err("the vehicles have other wheels than brakes"));
        }
        let whole = |(controller, brakes)| Braked { controller, brakes };
        Ok(Self(vehicles.into_iter().map(|vehicle| vehicle.map(whole)).collect()))
    }

    /// Adds the wheels to a drawing.
    pub fn draw(&self, world: &PhysicsWorld, drawing: &mut Drawing) {
        for vehicle in self.0.iter().flatten().map(|vehicle| &vehicle.controller) {
            let Some(chassis) = world.bodies.get(vehicle.chassis) else { continue };
            for wheel in vehicle.wheels() {
                let pose = *chassis.position();
                let axle =
                    Rotation::from_rotation_arc(Vector::Y, wheel.axle_cs.normalize_or(Vector::Z));
                let rotation = pose.rotation * wheel.rotation_cs() * axle;
                let radius = wheel.radius as f32;
                drawing.add(
                    Mesh::cylinder(),
                    Instance {
                        position: (pose * wheel.center_cs()).to_array().map(|c| c as f32),
                        rotation: rotation.to_array().map(|c| c as f32),
                        scale: [radius, WHEEL_HALF_WIDTH * radius, radius],
                        color: Color::from_hsl(WHEEL_COLOR[0], WHEEL_COLOR[1], WHEEL_COLOR[2], 1.0),
                        role: Role::Moving,
                        id: 0,
                        highlighted: false,
                    },
                );
            }
        }
    }

    /// The numbers of wheels. `None` for a removed vehicle.
    pub fn wheel_counts(&self) -> Vec<Option<usize>> {
        self.0.iter().map(|vehicle| vehicle.as_ref().map(|vehicle| vehicle.brakes.len())).collect()
    }

    fn get(&mut self, index: usize) -> PyResult<&mut Braked> {
        self.0.get_mut(index).and_then(Option::as_mut).ok_or_else(|| stale("vehicle"))
    }
}

/// Returns an error for a negative brake force.
fn check_brakes(rows: &[Real]) -> PyResult<()> {
    match rows.chunks_exact(CONTROLS).find(|row| row[1] < 0.0) {
        None => Ok(()),
        Some(row) => {
            Err(invalid(format!("the brake force is {}, but must not be negative", row[1])))
        }
    }
}

fn tuning(options: &Options<'_>) -> PyResult<WheelTuning> {
    let mut tuning = WheelTuning::default();
    for (name, value) in [
        ("stiffness", &mut tuning.suspension_stiffness),
        ("compression", &mut tuning.suspension_compression),
        ("relaxation", &mut tuning.suspension_damping),
        ("travel", &mut tuning.max_suspension_travel),
        ("grip", &mut tuning.friction_slip),
        ("side_grip", &mut tuning.side_friction_stiffness),
        ("max_force", &mut tuning.max_suspension_force),
    ] {
        if let Some(given) = options.take(name)? {
            *value = non_negative(name, given)?;
        }
    }
    Ok(tuning)
}

/// A vehicle of a world: a dynamic chassis whose wheels are rays. Its wheels act in each step of
/// the world. 3D only.
///
/// Copies of the world, pickles and batches contain the vehicle. Snapshots contain the chassis
/// without the wheels.
#[pyclass(frozen, module = "rapier")]
pub struct Vehicle {
    world: Py<World>,
    index: usize,
}

traverse!(Vehicle, vehicle => vehicle.world);

impl Vehicle {
    fn with<R>(&self, py: Python<'_>, read: impl FnOnce(&mut Braked) -> R) -> PyResult<R> {
        self.world.get().lock(py)?.simulation.vehicles.get(self.index).map(read)
    }
}

#[pymethods]
impl Vehicle {
    /// Adds a wheel and returns its index.
    ///
    /// connection: start of the suspension (m, frame of the chassis). rest_length: distance to the
    /// middle of the wheel without load (m). radius: of the wheel (m).
    ///
    /// direction: of the suspension, by default -y. axle: by default +z. Up × axle is the direction
    /// of driving: +x by default.
    /// stiffness: force of the spring per compression and per mass of the chassis (1/s²), by
    /// default 5.88. A family car has 25 to 50.
    /// compression, relaxation: force of the damper per speed and per mass of the chassis (1/s), by
    /// default 0.83 and 0.88.
    /// travel: largest compression (m), by default 5. max_force: of the suspension (N), by default
    /// 6000.
    /// grip: coefficient of friction of the tyre, by default 10.5. side_grip: fraction of the
    /// lateral slip that a step removes, by default 1.
    /// roll_influence: fraction of lateral grip that makes the car roll, from 0 to 1, by default
    /// 0.1.
    #[pyo3(signature = (connection, *, rest_length, radius, **options))]
    fn add_wheel(
        &self,
        py: Python<'_>,
        connection: &Bound<'_, PyAny>,
        rest_length: f64,
        radius: f64,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<usize> {
        let options = Options::new("add_wheel", options)?;
        let connection = coordinates("connection", connection)?;
        let (rest_length, radius) =
            (non_negative("rest_length", rest_length)?, non_negative("radius", radius)?);
        let axis = |name: &str, default: Vector| -> PyResult<Vector> {
            let Some(value) = options.any(name)? else { return Ok(default) };
            let axis = vector(name, &value)?.try_normalize();
            axis.ok_or_else(|| {
                invalid(format!("{name} is {value}, but must have a length greater than 0"))
            })
        };
        let (direction, axle) = (axis("direction", -Vector::Y)?, axis("axle", Vector::Z)?);
        let tuning = tuning(&options)?;
        let roll = options
            .take("roll_influence")?
            .map(|roll| non_negative("roll_influence", roll))
            .transpose()?;
        options.finish()?;
        self.with(py, |vehicle| {
            let controller = &mut vehicle.controller;
            let wheel =
                controller.add_wheel(connection, direction, axle, rest_length, radius, &tuning);
            wheel.roll_influence = roll.unwrap_or(wheel.roll_influence);
            vehicle.brakes.push(0.0);
            vehicle.brakes.len() - 1
        })
    }

    /// The number of wheels.
    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        self.with(py, |vehicle| vehicle.brakes.len())
    }

    /// The controls of the wheels, of the shape (wheels, 3): engine force (N), brake force (N),
    /// steering (rad, positive to the left). They act until they change.
    #[getter]
    fn controls<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<Real>>> {
        let rows = self.with(py, |vehicle| vehicle.controls())?;
        let count = rows.len() / CONTROLS;
        PyArray1::from_vec(py, rows).reshape([count, CONTROLS])
    }

    #[setter]
    fn set_controls(&self, py: Python<'_>, controls: &Bound<'_, PyAny>) -> PyResult<()> {
        let count = self.__len__(py)?;
        let rows = shaped_array("controls", controls, &[count, CONTROLS])?;
        let rows = finite_elements("controls", &rows)?;
        check_brakes(rows)?;
        self.with(py, |vehicle| vehicle.set_controls(rows))
    }

    /// Sets the controls of one wheel: engine force (N), brake force (N), steering (rad, positive
    /// to the left). An absent one keeps its value.
    #[pyo3(signature = (wheel, *, engine=None, brake=None, steering=None))]
    fn control(
        &self,
        py: Python<'_>,
        wheel: usize,
        engine: Option<f64>,
        brake: Option<f64>,
        steering: Option<f64>,
    ) -> PyResult<()> {
        let engine = engine.map(|force| finite("engine", force)).transpose()?;
        let brake = brake.map(|force| non_negative("brake", force)).transpose()?;
        let steering = steering.map(|angle| finite("steering", angle)).transpose()?;
        let changed = self.with(py, |vehicle| {
            let mut wheels = vehicle.controller.wheels_mut().iter_mut().zip(&mut vehicle.brakes);
            let (wheel, force) = wheels.nth(wheel)?;
            wheel.engine_force = engine.unwrap_or(wheel.engine_force);
            *force = brake.unwrap_or(*force);
            wheel.steering = steering.unwrap_or(wheel.steering);
            Some(())
        })?;
        changed.ok_or_else(|| invalid(format!("wheel is {wheel}, which the vehicle does not have")))
    }

    /// Speed of the chassis (m/s) as of the last step: negative backwards.
    #[getter]
    fn speed(&self, py: Python<'_>) -> PyResult<Real> {
        self.with(py, |vehicle| vehicle.controller.current_vehicle_speed)
    }

    /// Whether each wheel is on the ground, as of the last step.
    #[getter]
    fn on_ground(&self, py: Python<'_>) -> PyResult<Vec<bool>> {
        self.with(py, |vehicle| {
            let wheels = vehicle.controller.wheels().iter();
            wheels.map(|wheel| wheel.raycast_info().is_in_contact).collect()
        })
    }

    /// The middles of the wheels in the frame of the chassis (m), of the shape (wheels, 3).
    #[getter]
    fn wheel_positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<Real>>> {
        let rows: Vec<Real> = self.with(py, |vehicle| {
            let wheels = vehicle.controller.wheels().iter();
            wheels.flat_map(|wheel| wheel.center_cs().to_array()).collect()
        })?;
        let count = rows.len() / DIM;
        PyArray1::from_vec(py, rows).reshape([count, DIM])
    }

    /// Removes the wheels. The chassis stays.
    fn remove(&self, py: Python<'_>) -> PyResult<()> {
        let mut state = self.world.get().lock(py)?;
        state.simulation.vehicles.get(self.index)?;
        state.simulation.vehicles.0[self.index] = None;
        Ok(())
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        match self.__len__(py) {
            Ok(count) => format!("<Vehicle: {count} wheels>"),
            Err(_) => "<Vehicle: removed>".into(),
        }
    }
}

#[pymethods]
impl World {
    /// Puts a dynamic body on wheels: see `Vehicle.add_wheel`. 3D only.
    fn add_vehicle(slf: &Bound<'_, Self>, chassis: &Body) -> PyResult<Vehicle> {
        let mut state = slf.get().lock(slf.py())?;
        let chassis = chassis.handle_in(slf, &state.simulation.world.bodies)?;
        if !state.simulation.world.bodies[chassis].is_dynamic() {
            return Err(invalid("the chassis of a vehicle must be a dynamic body"));
        }
        state.simulation.vehicles.0.push(Some(Braked::new(chassis)));
        Ok(Vehicle { world: slf.clone().unbind(), index: state.simulation.vehicles.0.len() - 1 })
    }
}

#[pymethods]
impl WorldBatch {
    /// Sets the controls of a vehicle in all worlds: an array of the shape (count, wheels, 3), with
    /// the rows of `Vehicle.controls`. The vehicle is one of the original.
    fn set_vehicle_controls(
        &self,
        py: Python<'_>,
        vehicle: &Vehicle,
        controls: &Bound<'_, PyAny>,
    ) -> PyResult<()> {
        self.check_source(&vehicle.world, "vehicle")?;
        let original = self.original().vehicles.0.get(vehicle.index).and_then(Option::as_ref);
        let wheels = original.ok_or_else(|| stale("vehicle"))?.brakes.len();
        let rows = shaped_array("controls", controls, &[self.count(), wheels, CONTROLS])?;
        let rows = finite_elements("controls", &rows)?.to_vec();
        check_brakes(&rows)?;
        self.change(py, &rows, wheels * CONTROLS, |simulation, rows| {
            if let Some(Some(vehicle)) = simulation.vehicles.0.get_mut(vehicle.index) {
                vehicle.set_controls(rows);
            }
        })
    }
}

/// Adds the classes of 3D to a module.
pub fn fill(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Vehicle>()
}
