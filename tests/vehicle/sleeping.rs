//! Vehicles fall asleep like other bodies, and wake for input.

use super::stage::Road;
use rapier::prelude::*;

/// Returns a car that has stood long enough to sleep.
fn asleep(slope: Real) -> Road {
    let mut road = Road::new(60, slope, 1.0);
    let chassis = road.car.chassis;
    *road.world.bodies[chassis].activation_mut() = RigidBodyActivation::active();
    road.wheels(|wheel| wheel.brake = 1.0e4);
    road.run(6.0);
    assert!(road.chassis().is_sleeping(), "it moves at {}", road.chassis().linvel());
    road
}

#[test]
fn a_parked_car_sleeps_and_stays() {
    let mut road = asleep(0.2);
    let pose = *road.chassis().position();
    road.run(10.0);
    assert!(road.chassis().is_sleeping());
    assert_eq!(*road.chassis().position(), pose);
}

#[test]
fn the_engine_wakes_it() {
    let mut road = asleep(0.0);
    road.wheels(|wheel| {
        wheel.brake = 0.0;
        wheel.engine_force = 100.0;
    });
    let start = road.chassis().translation().x;
    road.run(4.0);
    assert!(!road.chassis().is_sleeping());
    assert!((road.chassis().linvel().x - 1.6).abs() < 0.01, "{}", road.chassis().linvel());
    assert!(road.chassis().translation().x > start + 3.0);
}

/// On a slope of 1°, a car needs two seconds to exceed the speed of bodies that may sleep.
#[test]
fn released_brakes_wake_it() {
    let slope = Real::to_radians(1.0);
    let mut road = asleep(slope);
    road.wheels(|wheel| wheel.brake = 0.0);
    road.run(3.0);
    let speed = road.chassis().linvel().length();
    let formula = 3.0 * 9.81 * slope.sin();
    println!("{speed} m/s after 3 s on a slope of 1°, {formula} expected");
    assert!((speed - formula).abs() < 0.02 * formula + 0.01);
}

#[test]
fn removed_ground_wakes_it() {
    let mut road = asleep(0.0);
    let ground = road.car.wheels()[0].raycast_info().ground_object.unwrap();
    road.world.remove_collider(ground);
    road.run(1.0);
    assert!(!road.chassis().is_sleeping());
    assert!(road.chassis().linvel().y < -9.0, "{}", road.chassis().linvel());
}

/// A car at the speed of bodies that fall asleep keeps moving.
#[test]
fn slow_cars_do_not_sleep() {
    let mut road = asleep(0.0);
    road.wheels(|wheel| wheel.brake = 0.0);
    let chassis = road.car.chassis;
    road.world.bodies[chassis].set_linvel(Vector::X * 0.2, true);
    let start = road.chassis().translation().x;
    road.run(10.0);
    let way = road.chassis().translation().x - start;
    assert!((way - 2.0).abs() < 0.01, "{way}");
}

/// A platform below a sleeping car carries it along when it starts to move.
#[test]
fn platforms_wake_it() {
    let mut road = Road::level(60, 1.0);
    let chassis = road.car.chassis;
    *road.world.bodies[chassis].activation_mut() = RigidBodyActivation::active();
    let body = RigidBodyBuilder::kinematic_velocity_based().translation(-0.1 * Vector::Y);
    let (platform, _) = road.world.insert(body, ColliderBuilder::cuboid(5.0, 0.15, 5.0));
    road.world.step();
    road.wheels(|wheel| wheel.brake = 1.0e4);
    road.run(6.0);
    assert!(road.chassis().is_sleeping(), "it moves at {}", road.chassis().linvel());
    road.world.bodies[platform].set_linvel(Vector::X, true);
    road.run(2.0);
    assert!((road.chassis().linvel().x - 1.0).abs() < 0.01, "{}", road.chassis().linvel());
}
