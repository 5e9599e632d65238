//! Grip of tyres, and its direction.

use super::stage::{HALF_BASE, MASS, RATES, Road};
use crate::suite::physics::stage::G;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Friction circle: the horizontal force on a wheel never exceeds µ times its load, for any
/// combination of driving, braking and sliding.
#[test]
fn circle() {
    let columns = ["rate", "µ", "largest share of µ N", "wheels at the limit (%)"];
    let mut table = Table::new("wild driving for 10 s", &columns);
    for rate in RATES {
        for friction in [0.3, 1.0] {
            let mut road = Road::level(rate, friction);
            road.run(1.0);
            let (mut largest, mut sliding, mut all): (Real, u32, u32) = (0.0, 0, 0);
            for step in 0..10 * rate {
                let time = step as Real / rate as Real;
                for (index, wheel) in road.car.wheels_mut().iter_mut().enumerate() {
                    wheel.engine_force = 4000.0 * (1.3 * time).sin();
                    wheel.brake = if (time as u32).is_multiple_of(3) { 20.0 } else { 0.0 };
                    wheel.steering = if index < 2 { 0.5 * (0.9 * time).sin() } else { 0.0 };
                }
                road.step();
                for wheel in road.car.wheels() {
                    let load = wheel.wheel_suspension_force / rate as Real;
                    let cosine = -wheel.suspension().dot(wheel.raycast_info().contact_normal_ws);
                    let push = wheel.forward_impulse.hypot(wheel.side_impulse);
                    if load > 0.0 {
                        largest = largest.max(push * cosine.max(0.1) / (friction * load));
                    }
                    sliding += u32::from(wheel.is_sliding());
                    all += 1;
                }
            }
            table.row([
                rate.to_string(),
                friction.to_string(),
                format!("{largest:.6}"),
                format!("{:.0}", 100.0 * sliding as Real / all as Real),
            ]);
            table.require(largest <= 1.0 + 1.0e-5, "more than the circle");
            table.require(sliding > 0, "never at the limit");
        }
    }
}

/// A car that slides sideways stops within `v² / 2 µ g`, with and without brakes. A car at an angle
/// with locked wheels does so too, on a straight path.
#[test]
fn sideways() {
    let columns = ["rate", "angle (°)", "locked", "distance (m)", "formula", "deviation (m)"];
    let mut table = Table::new("slides at 10 m/s, µ = 0.5", &columns);
    for rate in RATES {
        for (angle, is_locked) in [(90.0, false), (90.0, true), (45.0, true), (20.0, true)] {
            let mut road = Road::level(rate, 0.5);
            road.run(1.0);
            let chassis = road.car.chassis;
            let turn = Rotation::from_rotation_y(Real::to_radians(angle));
            // Rows to the side push higher up; the load is to stay the same at all wheels.
            road.wheels(|wheel| wheel.roll_influence = 0.0);
            road.wheels(|wheel| wheel.brake = if is_locked { 1.0e6 } else { 0.0 });
            road.world.bodies[chassis].set_rotation(turn, true);
            road.world.bodies[chassis].set_linvel(Vector::X * 10.0, true);
            let start = road.chassis().translation();
            road.run(5.0);
            let way = road.chassis().translation() - start;
            let formula = 100.0 / (2.0 * 0.5 * G);
            table.row([
                rate.to_string(),
                angle.to_string(),
                is_locked.to_string(),
                format!("{:.3}", way.x),
                format!("{formula:.3}"),
                format!("{:.3}", way.z),
            ]);
            table.check("the distance", way.x, formula, 0.02 * formula);
            // It dives in front, so its front wheels hold more, and it turns a little: by 1°, say.
            table.check("the deviation", way.z, 0.0, 0.3);
        }
    }
}

/// A car holds a curve of the radius `r` as long as `v² / r < µ g`. At the default roll influence it
/// stays on its wheels, even with tyres that could roll it over.
#[test]
fn curves() {
    let columns = ["rate", "µ", "v² / r g wanted", "got", "lean (°)"];
    let mut table = Table::new("curve of 20 m", &columns);
    let radius: Real = 20.0;
    for rate in RATES {
        for (friction, wanted) in [(0.8, 0.5), (0.8, 1.2), (10.5, 2.0)] {
            let mut road = Road::level(rate, friction);
            road.run(1.0);
            let chassis = road.car.chassis;
            let speed = (wanted * G * radius).sqrt();
            road.world.bodies[chassis].set_linvel(Vector::X * speed, true);
            for wheel in &mut road.car.wheels_mut()[..2] {
                wheel.steering = (2.0 * HALF_BASE / radius).atan();
            }
            let (mut lean, mut got): (Real, Real) = (0.0, 0.0);
            for step in 0..rate {
                let before = road.chassis().linvel();
                road.step();
                let chassis = road.chassis();
                let up = *chassis.rotation() * Vector::Y;
                lean = lean.max(up.y.clamp(-1.0, 1.0).acos().to_degrees());
                if step > rate / 2 {
                    let change = (chassis.linvel() - before) * rate as Real;
                    got = got.max(change.reject_from(chassis.linvel()).length() / G);
                }
            }
            table.row([
                rate.to_string(),
                friction.to_string(),
                wanted.to_string(),
                format!("{got:.3}"),
                format!("{lean:.2}"),
            ]);
            table.require(got <= 1.02 * friction.min(wanted * 1.2), "more than it can hold");
            table.require(got >= 0.8 * friction.min(wanted), "less than it can hold");
            table.require(lean < 20.0, "it leans too far");
        }
    }
}

/// Grip of side and drive are one: a wheel at full throttle on ice does not hold a push from the side.
#[test]
fn no_hold_while_spinning() {
    let pushed = |engine_force: Real| {
        let mut road = Road::level(60, 0.3);
        road.run(1.0);
        let chassis = road.car.chassis;
        road.wheels(|wheel| wheel.engine_force = engine_force);
        road.world.bodies[chassis].add_force(Vector::Z * 0.1 * MASS * G, true);
        road.run(1.0);
        road.chassis().linvel().z
    };
    let (rolling, spinning) = (pushed(0.0), pushed(5000.0));
    println!(
        "after a push from the side: {rolling} m/s rolling, {spinning} m/s with wheels that spin"
    );
    assert!(rolling.abs() < 0.01);
    assert!(spinning > 0.9 * 0.1 * G);
}
