//! Springs and dampers.

use super::stage::{DAMPING, HEIGHT, RATES, Road, SAG, STIFFNESS};
use crate::suite::physics::stage::G;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// The weight compresses the suspension by `m g / 4 k`. `k` is a force per length: stiffness times
/// mass.
#[test]
fn static_sag() {
    let columns = ["rate", "stiffness", "height (mm)", "formula", "load (N)", "m g / 4"];
    let mut table = Table::new("car at rest on its springs", &columns);
    for rate in RATES {
        for stiffness in [STIFFNESS, 200.0, 1.0e4] {
            let mut road = Road::level(rate, 1.0);
            road.wheels(|wheel| {
                wheel.suspension_stiffness = stiffness;
                wheel.damping_compression = stiffness.sqrt();
                wheel.damping_relaxation = stiffness.sqrt();
            });
            road.run(5.0);
            let height = road.chassis().translation().y;
            let formula = HEIGHT + SAG - G / (4.0 * stiffness);
            let wheel = &road.car.wheels()[0];
            table.row([
                rate.to_string(),
                stiffness.to_string(),
                format!("{:.4}", height * 1.0e3),
                format!("{:.4}", formula * 1.0e3),
                format!("{:.3}", wheel.wheel_suspension_force),
                format!("{:.3}", 250.0 * G),
            ]);
            table.check("the height", height, formula, 1.0e-5);
            table.check("the load", wheel.wheel_suspension_force, 250.0 * G, 0.5);
            let speed = road.chassis().linvel().length();
            table.check("the speed", speed, 0.0, 1.0e-4);
        }
    }
}

/// A car that is released slightly above its rest oscillates with `ω = √(4 k / m)` and the damping
/// ratio `ζ = ½ c √(4 / k)`, as long as no wheel lifts off. Extrema are `π / ω√(1 − ζ²)` apart, and
/// each is `e^(−πζ / √(1 − ζ²))` times the one before.
///
/// Both formulas hold for a vanishing time step. The update of the spring
/// (`src/dim3/vehicle/spring.rs`) adds, at 30 Hz, 1 % to the frequency, and half of `ω dt / 8` to the
/// damping ratio because of substeps. The time of an extremum is known to half a step: 3 % of a
/// period of 15 steps, without interpolation.
#[test]
fn bounce() {
    let columns = ["rate", "ζ wanted", "ζ", "frequency (Hz)", "formula"];
    let mut table = Table::new("bounce of a car", &columns);
    let omega = (4.0 * STIFFNESS).sqrt();
    for rate in RATES {
        for damping in [0.5 * DAMPING, DAMPING] {
            let ratio = 0.5 * damping * (4.0 / STIFFNESS).sqrt();
            let mut road = Road::level(rate, 1.0);
            road.wheels(|wheel| {
                wheel.damping_compression = damping;
                wheel.damping_relaxation = damping;
            });
            road.run(3.0);
            let chassis = road.car.chassis;
            let rest = road.chassis().translation().y;
            road.world.bodies[chassis].set_translation(Vector::Y * (rest + 0.7 * SAG), true);
            let mut heights = vec![];
            for _ in 0..3 * rate {
                heights.push(road.chassis().translation().y - rest);
                road.step();
            }
            let peaks = extrema(&heights);
            let (first, second) = (peaks[0], peaks[1]);
            let frequency = 0.5 * rate as Real / (second.0 - first.0);
            let decrement = -(second.1 / first.1).abs().ln() / core::f64::consts::PI as Real;
            let measured = decrement / (1.0 + decrement * decrement).sqrt();
            let formula = omega * (1.0 - ratio * ratio).sqrt() / core::f64::consts::TAU as Real;
            table.row([
                rate.to_string(),
                format!("{ratio:.3}"),
                format!("{measured:.4}"),
                format!("{frequency:.3}"),
                format!("{formula:.3}"),
            ]);
            table.check("the frequency", frequency, formula, 0.03 * formula);
            let of_step = 1.5 * omega / rate as Real / 8.0;
            table.check("the damping ratio", measured, ratio, of_step);
        }
    }
}

/// The inner extrema of samples, as (place, height): of the parabola through three of them.
fn extrema(samples: &[Real]) -> Vec<(Real, Real)> {
    let inner = samples.windows(3).enumerate();
    let extreme = |[a, b, c]: [Real; 3]| (b - a) * (c - b) <= 0.0 && (a != b || b != c);
    inner
        .filter_map(|(index, window)| {
            let [a, b, c] = [window[0], window[1], window[2]];
            let (slope, bend) = (0.5 * (c - a), a - 2.0 * b + c);
            extreme([a, b, c]).then(|| {
                let at = -slope / bend;
                (index as Real + 1.0 + at, b + 0.5 * slope * at)
            })
        })
        .collect()
}

/// The suspension is stable for any stiffness and any rate.
#[test]
fn stiff_springs() {
    let mut table = Table::new("stiff springs, dropped by 10 cm", &["rate", "k", "c", "speed"]);
    for rate in RATES {
        for (stiffness, damping) in [(1.0e3, 0.0), (1.0e5, 0.0), (1.0e7, 1.0e3), (50.0, 1.0e5)] {
            let mut road = Road::level(rate, 1.0);
            road.wheels(|wheel| {
                wheel.suspension_stiffness = stiffness;
                wheel.damping_compression = damping;
                wheel.damping_relaxation = damping;
                wheel.max_suspension_force = Real::INFINITY;
            });
            let chassis = road.car.chassis;
            road.world.bodies[chassis].set_translation(Vector::Y, true);
            let mut highest: Real = 0.0;
            for _ in 0..10 * rate {
                road.step();
                highest = highest.max(road.chassis().translation().y);
            }
            let speed = road.chassis().linvel().length();
            table.row([
                rate.to_string(),
                format!("{stiffness:e}"),
                format!("{damping:e}"),
                format!("{speed:.2e}"),
            ]);
            table.require(highest < 1.01, "it jumps");
            table.check("the speed after 10 s", speed, 0.0, 0.02);
        }
    }
}

/// The suspension force stays between zero and its maximum, and the travel within its limit.
#[test]
fn limits() {
    let columns =
        ["rate", "limit (N)", "travel (m)", "largest force (N)", "shortest (m)", "height (m)"];
    let mut table = Table::new("a car dropped by 0.3 m", &columns);
    for rate in RATES {
        // Four times 2000 N do not carry 1000 kg: it comes to lie on its own collider.
        for (limit, travel) in [(1.0e5, 5.0), (2000.0, 5.0), (1.0e5, 0.1)] {
            let mut road = Road::level(rate, 1.0);
            road.wheels(|wheel| {
                wheel.max_suspension_force = limit;
                wheel.max_suspension_travel = travel;
            });
            let chassis = road.car.chassis;
            road.world.bodies[chassis].set_translation(Vector::Y * (HEIGHT + 0.3), true);
            let (mut force, mut length): (Real, Real) = (0.0, 1.0);
            for _ in 0..5 * rate {
                road.step();
                for wheel in road.car.wheels() {
                    assert!(wheel.wheel_suspension_force >= 0.0, "it pulls");
                    force = force.max(wheel.wheel_suspension_force);
                    length = length.min(wheel.raycast_info().suspension_length);
                }
            }
            let height = road.chassis().translation().y;
            table.row([
                rate.to_string(),
                format!("{limit:e}"),
                travel.to_string(),
                format!("{force:.1}"),
                format!("{length:.4}"),
                format!("{height:.4}"),
            ]);
            table.require(force <= limit * (1.0 + 1.0e-5), "it presses too hard");
            table.require(length >= 0.4 - travel - 1.0e-6, "it gives way too far");
            let formula = if limit < 250.0 * G { 0.3 } else { HEIGHT };
            table.check("the height", height, formula, 1.0e-2);
        }
    }
}

/// The numbers of a well-known example of the API: a toy of 22 kg that is all default but for the springs.
#[test]
fn a_toy_of_defaults() {
    for rate in RATES {
        let mut world = crate::suite::physics::stage::world(rate);
        world.insert_collider(ColliderBuilder::cuboid(50.0, 0.1, 50.0), None);
        let (width, height) = (0.3, 0.15);
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y).can_sleep(false);
        let shape = ColliderBuilder::cuboid(2.0 * width, height, width).density(100.0);
        let (chassis, _) = world.insert(body, shape);
        let tuning = WheelTuning {
            suspension_stiffness: 100.0,
            suspension_damping: 10.0,
            ..WheelTuning::default()
        };
        let mut car = DynamicRayCastVehicleController::new(chassis);
        for (x, z) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let place = Vector::new(1.5 * width * x, -height, width * z);
            car.add_wheel(place, -Vector::Y, Vector::Z, height, 0.25 * height, &tuning);
        }
        let mut road = Road { world, car };
        road.run(2.0);
        let rest = road.chassis().translation().y;
        for wheel in &mut road.car.wheels_mut()[..2] {
            (wheel.engine_force, wheel.steering) = (30.0, 0.2);
        }
        road.run(2.0);
        let (speed, top) = (road.car.current_vehicle_speed, road.chassis().translation().y);
        println!("{rate}: rests at {rest}, drives at {speed}");
        // With the default µ of 10.5 it takes any curve, leaning out of it a little.
        assert!((top - rest).abs() < 0.03, "{rate}: {rest} at rest, {top} driving");
        assert!((3.0..5.8).contains(&speed), "{speed}");
        road.wheels(|wheel| (wheel.engine_force, wheel.brake) = (0.0, 1.0));
        road.run(3.0);
        assert!(road.chassis().linvel().length() < 1.0e-3, "{}", road.chassis().linvel());
    }
}
