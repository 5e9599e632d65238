//! Driving, steering, braking, and the rotation of wheels.

use super::stage::{HALF_BASE, MASS, RADIUS, RATES, Road};
use crate::suite::physics::stage::G;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A car accelerates by `F / m`, and by at most `µ g`.
#[test]
fn acceleration() {
    let columns = ["rate", "F (N)", "µ", "speed (m/s)", "formula", "rolled (m)", "went (m)"];
    let mut table = Table::new("two seconds of full throttle, all wheels driven", &columns);
    for rate in RATES {
        for (force, friction) in [(2000.0, 1.0), (5000.0, 1.0), (8000.0, 0.3)] {
            let mut road = Road::level(rate, friction);
            road.run(1.0);
            let start = road.chassis().translation().x;
            let rotation = road.car.wheels()[0].rotation;
            road.wheels(|wheel| wheel.engine_force = 0.25 * force);
            road.run(2.0);
            let speed = road.chassis().linvel().x;
            let formula = 2.0 * (force / MASS).min(friction * G);
            let rolled = (road.car.wheels()[0].rotation - rotation) * RADIUS;
            let went = road.chassis().translation().x - start;
            table.row([
                rate.to_string(),
                force.to_string(),
                friction.to_string(),
                format!("{speed:.4}"),
                format!("{formula:.4}"),
                format!("{rolled:.4}"),
                format!("{went:.4}"),
            ]);
            table.check("the speed", speed, formula, 0.01 * formula);
            if force / MASS < friction * G {
                // Between two velocities by their mean, whereas substeps are a little ahead.
                table.check("what it rolled", rolled, went, 0.005 * went + 0.01);
            } else {
                table.require(rolled > 1.2 * went, "its wheels do not spin");
                table.require(road.car.wheels()[0].is_sliding(), "it does not slide");
            }
        }
    }
}

/// A car with full brakes stops within `v² / 2 µ g`: grip is the limit, whatever the brakes.
#[test]
fn braking_distance() {
    let columns =
        ["rate", "µ", "brake (N)", "distance (m)", "formula", "error (%)", "deviation (m)"];
    let mut table = Table::new("full brakes at 20 m/s", &columns);
    for rate in RATES {
        for friction in [1.0, 0.5, 0.1] {
            for force in [1.0e4, 1.0e6, Real::INFINITY] {
                let speed = 20.0;
                let mut road = Road::level(rate, friction);
                road.run(1.0);
                let chassis = road.car.chassis;
                road.world.bodies[chassis].set_linvel(Vector::X * speed, true);
                let start = road.chassis().translation();
                road.wheels(|wheel| wheel.brake = force / rate as Real);
                road.run(1.0);
                assert!(
                    road.car.wheels().iter().all(|wheel| wheel.spin() == 0.0),
                    "all are locked"
                );
                road.run(speed / (friction * G) + 2.0);
                let way = road.chassis().translation() - start;
                let formula = speed * speed / (2.0 * friction * G);
                table.row([
                    rate.to_string(),
                    friction.to_string(),
                    format!("{force:e}"),
                    format!("{:.4}", way.x),
                    format!("{formula:.4}"),
                    format!("{:+.3}", (way.x / formula - 1.0) * 100.0),
                    format!("{:.4}", way.z),
                ]);
                table.check("the distance", way.x, formula, 0.02 * formula);
                table.check("the deviation", way.z, 0.0, 0.01);
                table.check("the speed", road.chassis().linvel().length(), 0.0, 1.0e-4);
            }
        }
    }
}

/// Brakes below the limit of grip stop the car within `m v² / 2 F`, and the wheels roll.
#[test]
fn gentle_brakes() {
    let columns = ["rate", "distance (m)", "formula", "rolled (m)"];
    let mut table = Table::new("gentle brakes, 2000 N, at 10 m/s", &columns);
    for rate in RATES {
        let mut road = Road::level(rate, 1.0);
        road.run(1.0);
        let chassis = road.car.chassis;
        road.world.bodies[chassis].set_linvel(Vector::X * 10.0, true);
        let start = road.chassis().translation().x;
        let rotation = road.car.wheels()[1].rotation;
        road.wheels(|wheel| wheel.brake = 500.0 / rate as Real);
        road.run(8.0);
        let way = road.chassis().translation().x - start;
        let rolled = (road.car.wheels()[1].rotation - rotation) * RADIUS;
        let formula = MASS * 100.0 / (2.0 * 2000.0);
        table.row([
            rate.to_string(),
            format!("{way:.4}"),
            format!("{formula:.4}"),
            format!("{rolled:.4}"),
        ]);
        table.check("the distance", way, formula, 0.01 * formula);
        table.check("what it rolled", rolled, way, 0.01 * way);
    }
}

/// At walking speed a car follows a circle of the radius `wheelbase / tan(steering)` about the centre
/// of its rear axle.
#[test]
fn turning_circle() {
    let columns = ["rate", "steering (°)", "radius (m)", "formula", "error (%)"];
    let mut table = Table::new("circle at 2 m/s", &columns);
    for rate in RATES {
        for degrees in [5.0, 15.0, 30.0, -15.0] {
            let steering = Real::to_radians(degrees);
            let mut road = Road::level(rate, 1.0);
            road.run(1.0);
            let chassis = road.car.chassis;
            road.world.bodies[chassis].set_linvel(Vector::X * 2.0, true);
            // Both front wheels by the same angle, as of one wheel in their middle.
            for wheel in &mut road.car.wheels_mut()[..2] {
                wheel.steering = steering;
                wheel.chassis_connection_point_cs.z = 0.0;
            }
            // Something has to make up for what scrubbing of the tyres takes.
            let drive = |road: &mut Road| {
                let missing = 2.0 - road.chassis().linvel().length();
                for wheel in &mut road.car.wheels_mut()[2..] {
                    wheel.engine_force = 2000.0 * missing;
                }
                road.step();
            };
            (0..4 * rate).for_each(|_| drive(&mut road));
            let (mut way, mut turned) = (0.0, 0.0);
            for _ in 0..4 * rate {
                drive(&mut road);
                let rear = *road.chassis().position() * (Vector::X * -HALF_BASE);
                let dt = 1.0 / rate as Real;
                way += road.chassis().velocity_at_point(rear).length() * dt;
                turned += road.chassis().angvel().y * dt;
            }
            let radius = way / turned;
            let formula = 2.0 * HALF_BASE / steering.tan();
            table.row([
                rate.to_string(),
                degrees.to_string(),
                format!("{radius:.4}"),
                format!("{formula:.4}"),
                format!("{:+.3}", (radius / formula - 1.0) * 100.0),
            ]);
            table.check("the radius", radius, formula, 0.02 * formula.abs());
        }
    }
}

/// Wheels in the air go on turning; a brake stops them.
#[test]
fn spin_in_the_air() {
    let mut road = Road::level(60, 1.0);
    road.run(1.0);
    let chassis = road.car.chassis;
    road.world.bodies[chassis].set_linvel(Vector::X * 9.0, true);
    road.run(0.5);
    let rolling = road.chassis().linvel().x / RADIUS;
    road.world.bodies[chassis].set_translation(Vector::Y * 1000.0, true);
    road.run(2.0);
    let wheel = &road.car.wheels()[3];
    assert!(!wheel.raycast_info().is_in_contact);
    println!("spin {} rad/s in the air, {rolling} rolling", wheel.spin());
    assert!((wheel.spin() - rolling).abs() < 1.0e-3 * rolling);
    assert_eq!(wheel.wheel_suspension_force, 0.0);
    road.wheels(|wheel| wheel.brake = 1000.0 / 60.0);
    road.run(1.0);
    assert_eq!(road.car.wheels()[3].spin(), 0.0);
}

/// The car drives the same to the last bit, independent of the owner of the trees.
#[test]
fn three_ways_to_ask() {
    let dt = 1.0 / 60.0;
    let drive = |update: &dyn Fn(&mut DynamicRayCastVehicleController, &mut PhysicsWorld)| {
        let mut road = Road::level(60, 1.0);
        road.wheels(|wheel| wheel.engine_force = 700.0);
        for wheel in &mut road.car.wheels_mut()[..2] {
            wheel.steering = 0.1;
        }
        for _ in 0..120 {
            update(&mut road.car, &mut road.world);
            road.world.step();
        }
        crate::dim::components(road.chassis().position())
    };
    let filter = QueryFilter::default();
    let by_world = drive(&|car, world| car.update_vehicle(dt, world.query_pipeline_mut(filter)));
    let by_parts = drive(&|car, world| {
        let PhysicsWorld { broad_phase, narrow_phase, bodies, colliders, .. } = world;
        let dispatcher = narrow_phase.query_dispatcher();
        let queries = broad_phase.as_query_pipeline_mut(dispatcher, bodies, colliders, filter);
        car.update_vehicle(dt, queries);
    });
    let by_queries = drive(&|car, world| {
        let mut queries = QueryPipeline::new();
        queries.update(&world.colliders);
        car.update_vehicle(dt, queries.view_mut(&mut world.bodies, &world.colliders, filter));
    });
    assert!(by_world[0] > 2.0, "{by_world:?}");
    assert_eq!(by_world, by_parts);
    assert_eq!(by_world, by_queries);
}

/// A wheel is drawn as it rolls: forwards its top goes ahead, steered to the left its front goes left (-z,
/// seen along x with y up), and its drawn axle is the one that it drives with.
#[test]
fn drawn_as_it_rolls() {
    let mut road = Road::level(60, 1.0);
    road.run(1.0);
    let chassis = road.car.chassis;
    road.world.bodies[chassis].set_linvel(Vector::X * 3.0, true);
    road.world.bodies[chassis].set_angvel(Vector::Y * 0.5, true);
    let before = road.car.wheels()[0].rotation_cs();
    road.step();
    let wheel = &mut road.car.wheels_mut()[0];
    let top_goes = wheel.rotation_cs() * (before.inverse() * Vector::Y);
    assert!(wheel.spin() > 0.0 && top_goes.x > 0.1, "{top_goes}");
    wheel.rotation = 0.0;
    wheel.steering = 0.3;
    let front = wheel.rotation_cs() * Vector::X;
    assert!(front.z < -0.2 && front.y.abs() < 1.0e-6, "{front}");
    let pose = *road.chassis().position();
    road.step();
    let wheel = &road.car.wheels()[0];
    let drawn = pose.rotation * (wheel.rotation_cs() * wheel.axle_cs);
    assert!((drawn - wheel.axle()).length() < 1.0e-5, "{drawn} {}", wheel.axle());
    assert!((pose * wheel.center_cs() - wheel.center()).length() < 1.0e-5);
}
