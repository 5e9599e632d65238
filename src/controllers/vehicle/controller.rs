//! The vehicle: its wheels, and one update.

use super::contact::{Mover, Vehicle, WheelContact};
use super::disturbance_observer::{DisturbanceObserver, linvel_after_forces};
use super::ground::{GroundCompliance, Grounds};
use super::place::{velocities_ahead, with_ground_alone};
use super::rest::{WheelState, is_disturbed, is_driven};
use super::solve::{on_chassis, on_ground, solve};
use super::wheel::{Wheel, WheelTuning};
use crate::base::measure::is_margin;
use crate::controllers::QueryPipelineMut;
use crate::dim::math::{Real, Vector, mul_inertia};
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::collider::ColliderSet;

/// A vehicle: a dynamic chassis whose wheels are rays.
///
/// Once a step, before or after it, [`Self::update_vehicle`] casts a ray for each wheel. Suspension, engine,
/// brakes and tyres then apply impulses to the chassis during the next step, and opposite ones to the ground.
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut world = PhysicsWorld::new();
/// world.insert_collider(ColliderBuilder::cuboid(50.0, 0.1, 50.0).translation(-0.1 * Vector::Y), None);
/// let body = RigidBodyBuilder::dynamic().translation(0.84 * Vector::Y);
/// let (chassis, _) = world.insert(body, ColliderBuilder::cuboid(2.0, 0.3, 0.9).mass(1000.0));
///
/// let mut car = DynamicRayCastVehicleController::new(chassis);
/// let tuning = WheelTuning { suspension_stiffness: 40.0, friction_slip: 1.0, ..Default::default() };
/// for (x, z) in [(1.3, -0.8), (1.3, 0.8), (-1.3, -0.8), (-1.3, 0.8)] {
///     let wheel = car.add_wheel(Vector::new(x, -0.2, z), -Vector::Y, Vector::Z, 0.4, 0.3, &tuning);
///     wheel.engine_force = 500.0; // newtons at each wheel: 1000 kg gain 2 m/s every second
/// }
///
/// let dt = world.integration_parameters.dt;
/// for _ in 0..60 {
///     car.update_vehicle(dt, world.query_pipeline_mut(QueryFilter::default()));
///     world.step();
/// }
/// assert!((world.bodies[chassis].linvel().x - 2.0).abs() < 0.1);
/// ```
///
/// # Frames and units
///
/// The rolling direction of a wheel follows from its axle: up × axle is forward. The fields of [`Wheel`]
/// document their units. Forces act at the ground, and are not torques.
///
/// # Guarantees of an update
///
/// * A suspension pushes and never pulls. It is integrated implicitly, and stiff springs are stable at any
///   rate.
/// * Drive, brake and lateral grip of a wheel are together at most [`Wheel::friction_slip`] times its load.
///   No brake stops a car on ice.
/// * Brakes stop a standing car, on a slope as well, within their force and the tyres' grip; it does not
///   creep.
/// * Rays hit neither the chassis nor sensors, with any filter.
/// * The ground gets opposite impulses. Wheels take the velocity of moving ground into account.
/// * A sleeping chassis stays asleep until a wheel's controls or its ground change. On dynamic ground no
///   chassis sleeps.
///
/// # Limitations
///
/// The wheels are lines: they sink into steps between their middle and their rim. Tyres do not heat or wear,
/// and have no self-aligning torque. If the chassis is not dynamic, its wheels detect the ground and rotate,
/// and no impulses act.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct DynamicRayCastVehicleController {
    wheels: Vec<Wheel>,
    /// Speed of the chassis at the last update (length/s), negative if against its forward axis.
    pub current_vehicle_speed: Real,
    /// The chassis.
    pub chassis: RigidBodyHandle,
    /// The up axis of the chassis: 0, 1 or 2 for x, y or z. 1 by default.
    pub index_up_axis: usize,
    /// The forward axis of the chassis. 0 by default. Only for the sign of [`Self::current_vehicle_speed`].
    pub index_forward_axis: usize,
    observer: DisturbanceObserver,
    ground_compliances: Vec<GroundCompliance>,
    seen: Vec<WheelState>,
    is_reported: bool,
}

impl DynamicRayCastVehicleController {
    /// A vehicle on this chassis, without wheels.
    pub fn new(chassis: RigidBodyHandle) -> Self {
        Self {
            wheels: Vec::new(),
            current_vehicle_speed: 0.0,
            chassis,
            index_up_axis: 1,
            index_forward_axis: 0,
            observer: DisturbanceObserver::default(),
            ground_compliances: Vec::new(),
            seen: Vec::new(),
            is_reported: false,
        }
    }

    /// Adds a wheel and returns it.
    ///
    /// Its suspension starts at `chassis_connection_cs`, points along `direction_cs` (down), and has the
    /// length `suspension_rest_length` without load. Its axle without steering is `axle_cs`. All are in the
    /// frame of the chassis. [`Wheel`], whose fields have these names, documents the treatment of invalid
    /// values.
    pub fn add_wheel(
        &mut self,
        chassis_connection_cs: Vector,
        direction_cs: Vector,
        axle_cs: Vector,
        suspension_rest_length: Real,
        radius: Real,
        tuning: &WheelTuning,
    ) -> &mut Wheel {
        let index = self.wheels.len();
        self.wheels.push(Wheel {
            chassis_connection_point_cs: chassis_connection_cs,
            direction_cs,
            axle_cs,
            suspension_rest_length,
            radius,
            ..Wheel::tuned(tuning)
        });
        &mut self.wheels[index]
    }

    /// The wheels, in the order in which they were added.
    pub fn wheels(&self) -> &[Wheel] {
        &self.wheels
    }

    /// Mutable access to the wheels.
    pub fn wheels_mut(&mut self) -> &mut [Wheel] {
        &mut self.wheels
    }

    /// Applies the wheels to the chassis and the ground during the next step of `dt` seconds.
    ///
    /// `queries` contains the bodies, and the colliders of the ground as selected by its filter. Call this
    /// once for each step. With a `dt` of 0 the call only places the wheels. The call has no effect if the
    /// chassis is missing or disabled, or an axis is out of range. The same holds if `dt` is negative, NaN or
    /// above 10¹⁵. Except for a disabled chassis, `log` contains one warning.
    pub fn update_vehicle(&mut self, dt: Real, queries: QueryPipelineMut<'_>) {
        let Some(chassis) = self.checked_chassis(dt, queries.bodies) else { return };
        if !chassis.is_enabled() {
            return self.observer.skip();
        }
        let forward = chassis.rotation() * Vector::AXES[self.index_forward_axis];
        let speed = chassis.linvel().length();
        let backwards = forward.dot(chassis.linvel()) < 0.0;
        self.current_vehicle_speed = if backwards { -speed } else { speed };

        self.place_wheels(dt, &queries);
        let QueryPipelineMut { bodies, colliders, .. } = queries;
        if dt > 0.0 && self.is_awake(bodies, colliders) {
            self.drive(dt, bodies, colliders);
        }
    }

    /// The chassis, if it exists and the other input is valid. Logs a warning otherwise.
    fn checked_chassis<'a>(&mut self, dt: Real, bodies: &'a RigidBodySet) -> Option<&'a RigidBody> {
        let axis = self.index_up_axis.max(self.index_forward_axis);
        let chassis = bodies.get(self.chassis);
        let problem = if !is_margin(dt) {
            Some(format!("its time step cannot be {dt}"))
        } else if axis >= Vector::AXES.len() {
            Some(format!("there is no axis {axis}"))
        } else if chassis.is_none() {
            Some(format!("{:?} finds no chassis", self.chassis))
        } else {
            None
        };
        if let Some(problem) = &problem
            && !self.is_reported
        {
            log::warn!("a vehicle is not updated: {problem}");
        }
        self.is_reported = problem.is_some();
        chassis.filter(|_| problem.is_none())
    }

    fn place_wheels(&mut self, dt: Real, queries: &QueryPipelineMut<'_>) {
        let Some(chassis) = queries.bodies.get(self.chassis) else { return };
        let view = queries.as_ref();
        let wheels = &mut self.wheels;
        with_ground_alone(view.filter, self.chassis, |filter| {
            let view = view.with_filter(filter);
            wheels.iter_mut().for_each(|wheel| wheel.place(chassis, dt, &view));
        });
    }

    /// Returns whether the chassis is awake, or there is a reason to wake it.
    fn is_awake(&mut self, bodies: &mut RigidBodySet, colliders: &ColliderSet) -> bool {
        let Some(chassis) = bodies.get(self.chassis) else { return false };
        let is_asleep = chassis.is_sleeping();
        let must_wake = match is_asleep {
            true => is_disturbed(&self.wheels, &self.seen, bodies, colliders),
            false => is_driven(&self.wheels),
        };
        let chassis = bodies.get_mut(self.chassis);
        if let Some(chassis) = chassis {
            if is_asleep {
                // It fell asleep before they acted.
                chassis.drop_push();
                self.observer.skip();
            }
            if must_wake {
                chassis.wake_up(true);
            }
        }
        !is_asleep || must_wake
    }

    /// Applies the impulses, and rotates the wheels.
    fn drive(&mut self, dt: Real, bodies: &mut RigidBodySet, colliders: &ColliderSet) {
        let Some(chassis) = bodies.get(self.chassis) else { return };
        let stepped = !chassis.is_pushed();
        let acceleration = self.observer.observe(chassis);
        if stepped {
            GroundCompliance::observe(&mut self.ground_compliances, bodies);
        }
        let vehicle = Vehicle {
            up: chassis.rotation() * Vector::AXES[self.index_up_axis],
            mass: chassis.mass_properties().mass(),
            dt,
        };
        let mut mover = mover_of_chassis(chassis, acceleration, dt);
        let (mut contacts, mut grounds) = self.contacts(&mut mover, &vehicle, bodies, colliders);
        solve(&mut contacts, &mut mover, &mut grounds);
        if !contacts.iter().all(WheelContact::is_finite) {
            log::error!("the forces on the wheels of a vehicle left the range of numbers");
            contacts.clear();
        }
        self.turn_wheels(&contacts, &mover, &grounds, &vehicle);
        self.push(&contacts, &grounds, bodies, dt);
    }

    /// The wheels on the ground, ready to be solved, and the bodies below them.
    fn contacts(
        &self,
        chassis: &mut Mover,
        vehicle: &Vehicle,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
    ) -> (Vec<WheelContact>, Grounds) {
        let mut grounds = Grounds::default();
        let mut contacts = Vec::with_capacity(self.wheels.len());
        for (index, wheel) in self.wheels.iter().enumerate() {
            let Some(below) = wheel.below else { continue };
            let ground = grounds.index_of(
                below.collider,
                bodies,
                colliders,
                &self.ground_compliances,
                vehicle.dt,
            );
            let movers = [&*chassis, &grounds.all[ground].mover];
            contacts.extend(WheelContact::new(index, wheel, &below, ground, movers, vehicle));
        }
        for contact in &mut contacts {
            let ground = &mut grounds.all[contact.ground].mover;
            contact.warm_start(self.wheels[contact.wheel].last_impulses, chassis, ground);
        }
        (contacts, grounds)
    }

    fn turn_wheels(
        &mut self,
        contacts: &[WheelContact],
        chassis: &Mover,
        grounds: &Grounds,
        vehicle: &Vehicle,
    ) {
        let mut contacts = contacts.iter().peekable();
        for (index, wheel) in self.wheels.iter_mut().enumerate() {
            wheel.last_impulses = [0.0; 3];
            match contacts.next_if(|contact| contact.wheel == index) {
                Some(contact) => {
                    contact.report(wheel);
                    let movers = [chassis, &grounds.all[contact.ground].mover];
                    contact.turn(wheel, movers, vehicle.mass, vehicle.dt);
                }
                None if wheel.is_usable() => wheel.turn_in_air(vehicle.mass, vehicle.dt),
                None => {}
            }
        }
        self.seen.clear();
        self.seen.extend(self.wheels.iter().map(WheelState::of));
    }

    /// Applies the impulses to the bodies, as forces for the next step.
    fn push(
        &mut self,
        contacts: &[WheelContact],
        grounds: &Grounds,
        bodies: &mut RigidBodySet,
        dt: Real,
    ) {
        let Some(chassis) = bodies.get_mut(self.chassis) else { return };
        if !chassis.is_dynamic() {
            return;
        }
        let (impulse, moment) = on_chassis(contacts);
        chassis.push(impulse / dt, moment / dt);
        self.observer.expect(chassis, dt);
        for (index, ground) in grounds.dynamic() {
            let Some(body) = ground.handle.and_then(|handle| bodies.get_mut(handle)) else {
                continue;
            };
            if body.is_sleeping() {
                body.drop_push();
            }
            body.wake_up(true);
            let (impulse, moment) = on_ground(contacts, index);
            body.push(impulse / dt, moment / dt);
        }
        GroundCompliance::expect(&mut self.ground_compliances, grounds, bodies, dt);
    }
}

/// The chassis as it will be at the end of the step if no wheel pushes.
fn mover_of_chassis(chassis: &RigidBody, acceleration: Vector, dt: Real) -> Mover {
    let mprops = chassis.mass_properties();
    let (inv_mass, inv_inertia) =
        (mprops.effective_inv_mass(), *mprops.effective_world_inv_inertia());
    let (old_linvel, old_angvel) = velocities_ahead(chassis, dt);
    let (mut linvel, mut angvel) = (old_linvel, old_angvel);
    if chassis.is_dynamic() {
        let torque = chassis.user_torque() + chassis.pending_push().1;
        linvel = linvel_after_forces(chassis, dt) + acceleration * dt;
        angvel += mul_inertia(&inv_inertia, torque) * dt;
    }
    Mover {
        center: mprops.world_com(),
        inv_mass,
        inv_inertia,
        old_linvel,
        old_angvel,
        linvel,
        angvel,
    }
}
