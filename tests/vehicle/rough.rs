//! Rough ground.

use super::stage::{HEIGHT, RATES, Road, STIFFNESS, add_car};
use crate::suite::physics::stage::{Dice, world};
use crate::suite::physics::table::Table;
use rapier::parry::utils::Array2;
use rapier::prelude::*;

/// A car on a field of bumps, 60 m square with a cell a metre, as high as `bumps`, in a bowl.
fn on_bumps(rate: u32, bumps: Real, friction: Real) -> Road {
    let mut world = world(rate);
    let mut dice = Dice(7);
    let mut heights = Array2::zeros(61, 61);
    for i in 0..61 {
        for j in 0..61 {
            let [z, x] = [i, j].map(|n| n as Real - 30.0);
            heights[(i, j)] = 0.01 * (x * x + z * z) + dice.within(-bumps, bumps);
        }
    }
    let field = ColliderBuilder::heightfield(heights, Vector::new(60.0, 1.0, 60.0));
    world.insert_collider(field, None);
    world.step();
    let pose = Pose::from_translation(Vector::Y * (HEIGHT + 2.0 * bumps));
    Road { car: add_car(&mut world, pose, friction), world }
}

/// The energy of a car: of motion, of height and in its springs.
fn energy(road: &Road) -> Real {
    let chassis = road.chassis();
    let springs = road.car.wheels().iter().map(|wheel| {
        let compression = wheel.suspension_rest_length - wheel.raycast_info().suspension_length;
        0.5 * STIFFNESS * chassis.mass() * compression * compression
    });
    let of_height = chassis.gravitational_potential_energy(0.0, road.world.gravity);
    chassis.kinetic_energy() + of_height + springs.sum::<Real>()
}

/// A car without engine and brakes rolls over bumps in a bowl, with random steering. Its energy never
/// exceeds the initial energy.
#[test]
fn coasting_gains_no_energy() {
    let columns = ["rate", "bumps (m)", "at first (J)", "most (J)", "after 30 s (J)", "way (m)"];
    let mut table = Table::new("a car coasts at 8 m/s in a bowl", &columns);
    for rate in RATES {
        for bumps in [0.0, 0.05, 0.15] {
            let mut road = on_bumps(rate, bumps, 1.0);
            let chassis = road.car.chassis;
            road.world.bodies[chassis].set_linvel(Vector::X * 8.0, true);
            let first = energy(&road);
            let (mut most, mut way) = (first, 0.0);
            let mut dice = Dice(3);
            for step in 0..30 * rate {
                if step % rate == 0 {
                    let steering = dice.within(-0.4, 0.4);
                    road.car.wheels_mut()[0].steering = steering;
                    road.car.wheels_mut()[1].steering = steering;
                }
                road.step();
                most = most.max(energy(&road));
                way += road.chassis().linvel().length() / rate as Real;
            }
            table.row([
                rate.to_string(),
                bumps.to_string(),
                format!("{first:.0}"),
                format!("{most:.0}"),
                format!("{:.0}", energy(&road)),
                format!("{way:.1}"),
            ]);
            // Springs and heights are read half a step apart from velocities.
            table.require(most <= 1.01 * first, "it gains energy");
            table.require(way > 10.0, "it stands");
        }
    }
}

/// A car drives over bumps with random throttle and steering. Speed, rotation and height stay below bounds that
/// a gain of energy from bumps would exceed.
#[test]
fn wild_driving() {
    let columns = ["rate", "µ", "fastest (m/s)", "turns (rad/s)", "highest (m)"];
    let mut table = Table::new("full throttle in the bumps for 20 s", &columns);
    for rate in RATES {
        for friction in [0.5, 1.5] {
            let mut road = on_bumps(rate, 0.2, friction);
            let mut dice = Dice(11);
            let (mut fastest, mut turns, mut highest): (Real, Real, Real) = (0.0, 0.0, 0.0);
            for step in 0..20 * rate {
                if step % rate == 0 {
                    let (force, steering) = (dice.within(-2500.0, 2500.0), dice.within(-0.5, 0.5));
                    for (index, wheel) in road.car.wheels_mut().iter_mut().enumerate() {
                        wheel.engine_force = force;
                        wheel.steering = if index < 2 { steering } else { 0.0 };
                    }
                }
                road.step();
                let chassis = road.chassis();
                fastest = fastest.max(chassis.linvel().length());
                turns = turns.max(chassis.angvel().length());
                highest = highest.max(chassis.translation().y);
            }
            table.row([
                rate.to_string(),
                friction.to_string(),
                format!("{fastest:.2}"),
                format!("{turns:.2}"),
                format!("{highest:.2}"),
            ]);
            // A second of full throttle gains 10 m/s; a toy that gained energy from bumps would soon have
            // more.
            table.require(fastest < 25.0, "it is too fast");
            table.require(turns < 12.0, "it tumbles");
            table.require(highest < 20.0, "it flies");
        }
    }
}
