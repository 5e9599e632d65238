//! Vehicles on rays.

use crate::fault::{Fault, finite, non_negative};
use crate::handle::{Handle, optional};
use crate::memory::{self, Single, put_vector, vector};
use crate::query::filter;
use crate::rapier::control::{DynamicRayCastVehicleController, Wheel, WheelTuning};
use crate::rapier::dynamics::RigidBodyHandle;
use crate::rapier::geometry::{Collider, ColliderHandle};
use crate::rapier::math::Real;
use crate::registry::{Registry, body, controlled};

static VEHICLES: Single<Registry<DynamicRayCastVehicleController>> = Single::new(Registry::new());

fn vehicle(number: u32) -> Result<&'static mut DynamicRayCastVehicleController, Fault> {
    // SAFETY: an exported function gets one controller, once.
    unsafe { VEHICLES.get().get(number) }.ok_or_else(|| Fault::freed("vehicle controller"))
}

/// Numbers of a wheel, in the order of `WheelNumber` in TypeScript: first the settable ones.
fn wheel_number(wheel: &mut Wheel, number: u32) -> Option<&mut Real> {
    Some(match number {
        0 => &mut wheel.suspension_rest_length,
        1 => &mut wheel.max_suspension_travel,
        2 => &mut wheel.radius,
        3 => &mut wheel.suspension_stiffness,
        4 => &mut wheel.damping_compression,
        5 => &mut wheel.damping_relaxation,
        6 => &mut wheel.max_suspension_force,
        7 => &mut wheel.brake,
        8 => &mut wheel.steering,
        9 => &mut wheel.engine_force,
        10 => &mut wheel.friction_slip,
        11 => &mut wheel.side_friction_stiffness,
        12 => &mut wheel.rotation,
        13 => &mut wheel.forward_impulse,
        14 => &mut wheel.side_impulse,
        15 => &mut wheel.wheel_suspension_force,
        _ => return None,
    })
}

/// Numbers of a wheel that can be set.
const SETTABLE: u32 = 12;
/// The names of these numbers in TypeScript.
const NAMES: [&str; SETTABLE as usize] = [
    "wheelSuspensionRestLength",
    "wheelMaxSuspensionTravel",
    "wheelRadius",
    "wheelSuspensionStiffness",
    "wheelSuspensionCompression",
    "wheelSuspensionRelaxation",
    "wheelMaxSuspensionForce",
    "wheelBrake",
    "wheelSteering",
    "wheelEngineForce",
    "wheelFrictionSlip",
    "wheelSideFrictionStiffness",
];
/// Settings that may be negative: steering and engine force.
const SIGNED: [u32; 2] = [8, 9];

exports! {
    /// Creates a vehicle.
    fn vehicle_new(world: u32, chassis: f64) -> u32 {
        body(world, chassis)?;
        let controller = DynamicRayCastVehicleController::new(RigidBodyHandle::of_number(chassis));
        // SAFETY: the reference ends with the statement.
        unsafe { VEHICLES.get().insert(controller) }
    }

    /// Frees a vehicle.
    fn vehicle_free(number: u32) {
        // SAFETY: the reference ends with the statement.
        drop(unsafe { VEHICLES.get().remove(number) });
    }

    /// Updates a vehicle. The integers are the handles, in halves, of colliders that are not ground.
    fn vehicle_update(number: u32, world: u32, dt: f64) {
        let dt = non_negative("dt", dt)? as Real;
        let vehicle = vehicle(number)?;
        body(world, vehicle.chassis.to_number())?;
        let mut left_out: Vec<u64> = memory::groups::<2>("the colliders that are left out")?
            .into_iter()
            .map(|[low, high]| u64::from(low) | u64::from(high) << 32)
            .collect();
        left_out.sort_unstable();
        let is_ground = |handle: ColliderHandle, _: &Collider| left_out.binary_search(&handle.to_number().to_bits()).is_err();
        let mut selection = filter();
        selection.predicate = if left_out.is_empty() { None } else { Some(&is_ground) };
        let (world, queries) = controlled(world)?;
        vehicle.update_vehicle(dt, queries.view_mut(&mut world.bodies, &world.colliders, selection));
    }

    /// The speed along the forward axis.
    fn vehicle_speed(number: u32) -> f64 {
        vehicle(number)?.current_vehicle_speed.into()
    }

    /// The up axis (0) or the forward axis (1).
    fn vehicle_axis(number: u32, which: u32) -> usize {
        let vehicle = vehicle(number)?;
        if which == 0 { vehicle.index_up_axis } else { vehicle.index_forward_axis }
    }

    /// Sets the up axis (0) or the forward axis (1).
    fn vehicle_set_axis(number: u32, which: u32, axis: u32) {
        if axis > 2 {
            return Err(Fault::number("the axis", axis.into(), "0, 1 or 2"));
        }
        let vehicle = vehicle(number)?;
        let index = if which == 0 { &mut vehicle.index_up_axis } else { &mut vehicle.index_forward_axis };
        *index = axis as usize;
    }

    /// Adds a wheel: connection, direction and axle in places 0 to 2.
    fn vehicle_add_wheel(number: u32, rest_length: f64, radius: f64) {
        let (connection, direction) = (vector(0, "chassisConnectionCs")?, memory::direction(1, "directionCs")?);
        let axle = memory::direction(2, "axleCs")?;
        let (rest_length, radius) = (non_negative("suspensionRestLength", rest_length)?, non_negative("radius", radius)?);
        let (rest_length, radius) = (rest_length as Real, radius as Real);
        vehicle(number)?.add_wheel(connection, direction, axle, rest_length, radius, &WheelTuning::default());
    }

    /// The number of wheels.
    fn vehicle_wheels(number: u32) -> usize {
        vehicle(number)?.wheels().len()
    }

    /// A number of a wheel. NaN if there is no such wheel.
    fn wheel_get(vehicle_number: u32, index: usize, what: u32) -> f64 {
        let Some(wheel) = vehicle(vehicle_number)?.wheels_mut().get_mut(index) else { return Ok(f64::NAN) };
        if what == SETTABLE + 4 {
            return Ok(wheel.raycast_info().suspension_length.into());
        }
        wheel_number(wheel, what).map_or(f64::NAN, |number| (*number).into())
    }

    /// Sets a number of a wheel.
    fn wheel_set(vehicle_number: u32, index: usize, what: u32, value: f64) {
        let Some(&name) = NAMES.get(what as usize) else {
            return Err(Fault::number("the number of the wheel", what.into(), "one that can be set"));
        };
        let value = if SIGNED.contains(&what) { finite(name, value)? } else { non_negative(name, value)? };
        if let Some(number) = wheel_number(wheel(vehicle_number, index)?, what) {
            *number = value as Real;
        }
    }

    /// Writes a vector of a wheel: connection, direction, axle, contact normal, contact point, hard point.
    /// Returns whether the wheel exists.
    fn wheel_vector(vehicle_number: u32, index: usize, what: u32) -> bool {
        let Some(wheel) = vehicle(vehicle_number)?.wheels().get(index) else { return Ok(false) };
        let contact = wheel.raycast_info();
        put_vector(0, match what {
            0 => wheel.chassis_connection_point_cs,
            1 => wheel.direction_cs,
            2 => wheel.axle_cs,
            3 => contact.contact_normal_ws,
            4 => contact.contact_point_ws,
            _ => contact.hard_point_ws,
        });
        true
    }

    /// Sets a vector of a wheel: connection, direction, axle.
    fn wheel_set_vector(vehicle_number: u32, index: usize, what: u32) {
        let value = match what {
            0 => vector(0, "wheelChassisConnectionPointCs")?,
            1 => memory::direction(0, "wheelDirectionCs")?,
            _ => memory::direction(0, "wheelAxleCs")?,
        };
        let wheel = wheel(vehicle_number, index)?;
        match what {
            0 => wheel.chassis_connection_point_cs = value,
            1 => wheel.direction_cs = value,
            _ => wheel.axle_cs = value,
        }
    }

    /// Returns whether a wheel is on the ground. The scratch block is not used.
    fn wheel_is_in_contact(vehicle_number: u32, index: usize) -> bool {
        vehicle(vehicle_number)?.wheels().get(index).is_some_and(|wheel| wheel.raycast_info().is_in_contact)
    }

    /// The collider under a wheel, or NaN.
    fn wheel_ground(vehicle_number: u32, index: usize) -> f64 {
        let wheel = vehicle(vehicle_number)?.wheels().get(index);
        optional(wheel.and_then(|wheel| wheel.raycast_info().ground_object))
    }
}

fn wheel(vehicle_number: u32, index: usize) -> Result<&'static mut Wheel, Fault> {
    let wheels = vehicle(vehicle_number)?.wheels_mut();
    let count = wheels.len();
    wheels.get_mut(index).ok_or_else(|| {
        Fault::number("the index of the wheel", index as f64, &format!("less than {count}"))
    })
}
