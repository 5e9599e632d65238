//! Operations on vehicles.

use super::both::groups::OTHERS;
use super::both::play::Play;
use super::both::values::{some_positive, some_real, some_vector};
use super::rapier::prelude::*;
use crate::choices::Choices;

/// Builds, tunes or moves a vehicle.
pub fn drive(play: &mut Play<'_>) {
    let chassis = play.body();
    let Play { choices, world, vehicle, .. } = play;
    let vehicle = vehicle.get_or_insert_with(|| DynamicRayCastVehicleController::new(chassis));
    match choices.below(6) {
        0 => *vehicle = DynamicRayCastVehicleController::new(chassis),
        1 => {
            let (at, down, axle) =
                (some_vector(choices, 1.0), -Vector::Y, some_vector(choices, 1.0));
            let (rest, radius) = (some_positive(choices), some_positive(choices));
            if vehicle.wheels().len() < 6 {
                vehicle.add_wheel(at, down, axle, rest, radius, &WheelTuning::default());
            }
        }
        2 => {
            vehicle.index_up_axis = choices.below(4);
            vehicle.index_forward_axis = choices.below(4);
        }
        _ => {
            for wheel in vehicle.wheels_mut() {
                tune(wheel, choices);
            }
            let dt = if choices.coin() { 1.0 / 60.0 } else { some_real(choices) };
            let others = QueryFilter::default().groups(OTHERS);
            vehicle.update_vehicle(dt, world.query_pipeline_mut(others));
        }
    }
}

fn tune(wheel: &mut Wheel, choices: &mut Choices<'_>) {
    let value = some_real(choices);
    match choices.below(12) {
        0 => wheel.engine_force = value,
        1 => wheel.brake = value,
        2 => wheel.steering = value,
        3 => wheel.suspension_stiffness = value,
        4 => wheel.damping_compression = value,
        5 => wheel.damping_relaxation = value,
        6 => wheel.friction_slip = value,
        7 => wheel.max_suspension_force = value,
        8 => wheel.roll_influence = value,
        9 => wheel.axle_cs = Vector::X * value,
        10 => wheel.direction_cs = Vector::Y * value,
        _ => wheel.engine_force = 10.0,
    }
}
