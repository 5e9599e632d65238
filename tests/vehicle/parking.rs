//! Cars at rest.

use super::stage::{RATES, Road};
use crate::suite::physics::stage::G;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A car stays at rest for a minute: without brakes on level ground, with brakes along and across a
/// slope.
#[test]
fn for_a_minute() {
    let columns =
        ["rate", "slope (°)", "heading (°)", "moved (mm)", "speed (mm/s)", "energy gained"];
    let mut table = Table::new("parked for 60 s", &columns);
    for rate in RATES {
        for (slope, heading, brake) in [
            (0.0, 0.0, 0.0),
            (0.0, 0.0, 1.0e4),
            (15.0, 0.0, 1.0e4),
            (15.0, 90.0, 1.0e4),
            (15.0, 40.0, 1.0e4),
        ] {
            let mut road = Road::new(rate, Real::to_radians(slope), 1.0);
            let turn = Rotation::from_rotation_y(Real::to_radians(heading));
            let chassis = road.car.chassis;
            let turned = *road.chassis().rotation() * turn;
            road.world.bodies[chassis].set_rotation(turned, true);
            road.wheels(|wheel| wheel.brake = brake);
            road.run(5.0);
            let start = *road.chassis().position();
            let energy = |road: &Road| {
                let (chassis, gravity) = (road.chassis(), road.world.gravity);
                chassis.kinetic_energy() + chassis.gravitational_potential_energy(0.0, gravity)
            };
            let before = energy(&road);
            road.run(60.0);
            let way = road.chassis().translation() - start.translation;
            let speed = road.chassis().linvel().length();
            table.row([
                rate.to_string(),
                slope.to_string(),
                heading.to_string(),
                format!("{:.5}", way.length() * 1.0e3),
                format!("{:.5}", speed * 1.0e3),
                format!("{:+.3e}", energy(&road) - before),
            ]);
            table.check("what it moved", way.length(), 0.0, 1.0e-3);
            table.check("the speed", speed, 0.0, 1.0e-3);
        }
    }
}

/// Brakes hold a car on a slope of the angle `α` if `tan α < µ`. Otherwise the car slides with `a = g
/// (sin α − µ cos α)`.
#[test]
fn up_to_the_limit_of_friction() {
    let columns = ["rate", "µ", "slid in 2 s (m)", "formula"];
    let mut table = Table::new("locked wheels on a slope of 20°, tan = 0.364", &columns);
    let slope = Real::to_radians(20.0);
    for rate in RATES {
        for friction in [0.1, 0.3, 0.35, 0.38, 0.6] {
            let mut road = Road::new(rate, slope, 2.0);
            road.wheels(|wheel| wheel.brake = Real::INFINITY);
            road.run(5.0);
            road.wheels(|wheel| wheel.friction_slip = friction);
            let start = road.chassis().translation();
            road.run(2.0);
            let way = (road.chassis().translation() - start)
                .dot(Rotation::from_rotation_z(slope) * Vector::X);
            let acceleration = (G * (slope.sin() - friction * slope.cos())).max(0.0);
            table.row([
                rate.to_string(),
                friction.to_string(),
                format!("{:.5}", -way),
                format!("{:.5}", 2.0 * acceleration),
            ]);
            // At the limit the swing that goes with the lost grip makes it slide once.
            table.check("what it slid", -way, 2.0 * acceleration, 0.02 * acceleration + 0.01);
        }
    }
}
