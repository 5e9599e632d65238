//! Moving and movable ground.

use super::stage::{HEIGHT, MASS, RATES, Road, add_car};
use crate::suite::physics::stage::{G, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A car on a plate, which the test moves.
fn on_plate(rate: u32, plate: RigidBodyBuilder, gravity: Vector) -> (Road, RigidBodyHandle) {
    let mut world = world(rate);
    world.gravity = gravity;
    let shape = ColliderBuilder::cuboid(8.0, 0.5, 8.0).translation(-0.5 * Vector::Y);
    let (plate, _) = world.insert(plate, shape.mass(0.5 * MASS));
    world.step();
    let pose = Pose::from_translation(Vector::Y * HEIGHT);
    let car = add_car(&mut world, pose, 1.0);
    (Road { world, car }, plate)
}

/// A braked car stays at its place on a platform that translates and rotates. Without brakes it stays
/// on a platform that moves vertically.
#[test]
fn platforms() {
    let columns = ["rate", "platform", "by", "slip (mm)", "of (m)"];
    let mut table = Table::new("on a platform for 6 s", &columns);
    for rate in RATES {
        for by_position in [false, true] {
            for (name, brake) in [("to and fro", 1.0e4), ("up and down", 0.0), ("round", 1.0e4)] {
                let builder = if by_position {
                    RigidBodyBuilder::kinematic_position_based()
                } else {
                    RigidBodyBuilder::kinematic_velocity_based()
                };
                let (mut road, plate) = on_plate(rate, builder, -Vector::Y * G);
                road.wheels(|wheel| wheel.brake = brake);
                road.run(1.0);
                let before = place_on(&road, plate);
                let (mut farthest, mut way): (Real, Real) = (0.0, 0.0);
                for step in 0..6 * rate {
                    let from = road.chassis().translation();
                    let time = (step + 1) as Real / rate as Real;
                    lead(&mut road.world.bodies[plate], name, time, 1.0 / rate as Real);
                    road.step();
                    let slip = place_on(&road, plate) - before;
                    farthest = farthest.max(slip.reject_from_normalized(Vector::Y).length());
                    way += (road.chassis().translation() - from).length();
                }
                table.row([
                    rate.to_string(),
                    name.to_string(),
                    (if by_position { "position" } else { "velocity" }).to_string(),
                    format!("{:.3}", farthest * 1.0e3),
                    format!("{way:.2}"),
                ]);
                // Within a step the car comes to the platform's new velocity bit by bit, which the platform
                // has from its beginning: it falls behind by ⅜ of what the velocity changes by, 4 m/s in all,
                // times the step.
                let behind = 0.5 * 0.375 * 4.0 / rate as Real;
                table.check("the slip", farthest, 0.0, 1.1 * behind);
            }
        }
    }
}

/// Where the chassis is on the plate, in the plate's frame.
fn place_on(road: &Road, plate: RigidBodyHandle) -> Vector {
    road.world.bodies[plate].position().inverse() * road.chassis().translation()
}

/// Leads a platform: at most 2 m/s, 1 m/s² and 0.4 rad/s.
fn lead(plate: &mut RigidBody, name: &str, time: Real, dt: Real) {
    let phase = 0.5 * time;
    let (wave, velocity) = (4.0 * (1.0 - phase.cos()), 2.0 * (phase - 0.25 * dt).sin());
    let (along, turn) = match name {
        "to and fro" => (Vector::X, 0.0),
        "up and down" => (0.5 * Vector::Y, 0.0),
        _ => (Vector::ZERO, 0.4),
    };
    if plate.body_type() == RigidBodyType::KinematicPositionBased {
        let pose = Pose::from_parts(along * wave, Rotation::from_rotation_y(turn * time));
        plate.set_next_kinematic_position(pose);
    } else {
        plate.set_linvel(along * velocity, true);
        plate.set_angvel(Vector::Y * turn, true);
    }
}

/// Without gravity, a car drives on a free plate and accelerates the plate backwards. The momentum of
/// both together stays zero.
#[test]
fn momentum() {
    let columns = ["rate", "car (m/s)", "plate (m/s)", "momentum (kg m/s)"];
    let mut table = Table::new("a car on a free plate, pressed to it, drives and steers", &columns);
    for rate in RATES {
        let (mut road, plate) = on_plate(rate, RigidBodyBuilder::dynamic(), Vector::ZERO);
        // Forces between the two, in place of gravity.
        let chassis = road.car.chassis;
        road.world.bodies[chassis].add_force(-Vector::Y * 5000.0, true);
        road.world.bodies[plate].add_force(Vector::Y * 5000.0, true);
        road.wheels(|wheel| wheel.engine_force = 200.0);
        for wheel in &mut road.car.wheels_mut()[..2] {
            wheel.steering = 0.2;
        }
        let mut largest: Real = 0.0;
        for _ in 0..2 * rate {
            road.step();
            let all = [chassis, plate].map(|body| &road.world.bodies[body]);
            let momentum: Vector = all.iter().map(|body| body.linvel() * body.mass()).sum();
            largest = largest.max(momentum.length());
        }
        let all = [chassis, plate].map(|body| &road.world.bodies[body]);
        let scale = all[0].linvel().length() * MASS;
        table.row([
            rate.to_string(),
            format!("{:.4}", all[0].linvel().length()),
            format!("{:.4}", all[1].linvel().length()),
            format!("{largest:.5}"),
        ]);
        table.require(scale > 300.0, "it does not drive");
        table.check("the momentum", largest, 0.0, 1.0e-4 * scale);
    }
}

fn moment_of(body: &RigidBody) -> Vector {
    let spin = crate::dim::spin_momentum(body);
    spin + body.center_of_mass().cross(body.linvel() * body.mass())
}

/// A plate in space that a car presses and drives on gets, in one update, the opposite of what the chassis
/// gets: force and moment.
#[test]
fn reaction() {
    let (mut road, plate) = on_plate(60, RigidBodyBuilder::dynamic(), Vector::ZERO);
    let chassis = road.car.chassis;
    road.world.bodies[chassis].set_linvel(Vector::new(3.0, -1.0, 0.5), true);
    road.wheels(|wheel| {
        wheel.engine_force = 500.0;
        wheel.roll_influence = 1.0;
    });
    let total = |road: &Road| {
        let all = [chassis, plate].map(|body| &road.world.bodies[body]);
        let momentum: Vector = all.iter().map(|body| body.linvel() * body.mass()).sum();
        (momentum, all.iter().map(|body| moment_of(body)).sum::<Vector>())
    };
    let before = total(&road);
    road.step();
    let after = total(&road);
    let plate = &road.world.bodies[plate];
    println!("the plate moves at {} and turns at {}", plate.linvel(), plate.angvel());
    println!("momentum {} and moment {} were lost", before.0 - after.0, before.1 - after.1);
    assert!(plate.linvel().y < -0.01 && plate.linvel().x < -0.01, "{}", plate.linvel());
    assert!((before.0 - after.0).length() < 1.0e-4 * before.0.length());
    // Lever arms are those of the beginning of the step, whereas both go on by some centimetres.
    assert!((before.1 - after.1).length() < 0.02 * before.1.length());
}

/// A light plank on the floor carries a car of a hundred times its mass, like the floor itself.
#[test]
fn planks() {
    let columns = ["rate", "plank (kg)", "height on it (mm)", "formula", "speed (mm/s)"];
    let mut table = Table::new("a car of 1000 kg parked on a plank", &columns);
    for rate in RATES {
        for mass in [10.0, 100.0, 1000.0] {
            let mut road = Road::level(rate, 1.0);
            let half = Vector::new(3.0, 0.1, 1.5);
            let plank = ColliderBuilder::cuboid(half.x, half.y, half.z).mass(mass);
            let body = RigidBodyBuilder::dynamic().translation(Vector::Y * half.y);
            let (plank, _) = road.world.insert(body, plank);
            let chassis = road.car.chassis;
            let start = Vector::Y * (HEIGHT + 2.0 * half.y + 0.02);
            road.world.bodies[chassis].set_translation(start, true);
            road.world.step();
            road.wheels(|wheel| wheel.brake = 1.0e4);
            road.run(6.0);
            let top = road.world.bodies[plank].translation().y + half.y;
            let height = road.chassis().translation().y - top;
            let formula = HEIGHT;
            let speed = road.chassis().linvel().length();
            table.row([
                rate.to_string(),
                mass.to_string(),
                format!("{:.3}", height * 1.0e3),
                format!("{:.3}", formula * 1.0e3),
                format!("{:.3}", speed * 1.0e3),
            ]);
            // The plank itself sinks into the floor: a contact of 10 kg yields under 1000.
            table.check("the height", height, formula, 1.0e-4);
            table.check("the speed", speed, 0.0, 2.0e-3);
        }
    }
}
