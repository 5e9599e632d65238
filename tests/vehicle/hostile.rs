//! Hostile input: no panic, all numbers stay finite, and the log contains the reason why a wheel is inactive.

use super::stage::{HEIGHT, Road, add_car};
use crate::suite::hostile::listener::{listen, names};
use crate::suite::hostile::values::{EDGES, NOT_FINITE};
use rapier::prelude::*;

/// Name of a field of a wheel, and its setter.
type Field = (&'static str, fn(&mut Wheel, Real));

const FIELDS: [Field; 19] = [
    ("rest length", |w, v| w.suspension_rest_length = v),
    ("travel", |w, v| w.max_suspension_travel = v),
    ("radius", |w, v| w.radius = v),
    ("stiffness", |w, v| w.suspension_stiffness = v),
    ("compression", |w, v| w.damping_compression = v),
    ("relaxation", |w, v| w.damping_relaxation = v),
    ("force", |w, v| w.max_suspension_force = v),
    ("friction slip", |w, v| w.friction_slip = v),
    ("side friction", |w, v| w.side_friction_stiffness = v),
    ("roll influence", |w, v| w.roll_influence = v),
    ("steering", |w, v| w.steering = v),
    ("engine", |w, v| w.engine_force = v),
    ("brake", |w, v| w.brake = v),
    ("rotation", |w, v| w.rotation = v),
    ("place", |w, v| w.chassis_connection_point_cs.x = v),
    ("direction", |w, v| w.direction_cs = Vector::splat(v)),
    ("direction", |w, v| w.direction_cs.y = v),
    ("axle", |w, v| w.axle_cs = Vector::splat(v)),
    ("axle", |w, v| w.axle_cs.z = v),
];

/// Outputs, which the user may overwrite with any value.
const OUTPUTS: [Field; 3] = [
    ("suspension force", |w, v| w.wheel_suspension_force = v),
    ("forward impulse", |w, v| w.forward_impulse = v),
    ("side impulse", |w, v| w.side_impulse = v),
];

fn is_valid(road: &Road) -> bool {
    let chassis = road.chassis();
    let wheels = road.car.wheels().iter();
    let numbers = wheels.flat_map(|wheel| {
        let forces = [wheel.wheel_suspension_force, wheel.forward_impulse, wheel.side_impulse];
        let center = wheel.center();
        forces.into_iter().chain([wheel.spin(), center.x, center.y, center.z])
    });
    chassis.position().is_finite()
        && chassis.linvel().is_finite()
        && chassis.angvel().is_finite()
        && road.car.current_vehicle_speed.is_finite()
        && numbers.into_iter().all(Real::is_finite)
}

/// An infinite brake locks every wheel, also in the air and under a chassis without mass, where no impulse
/// rotates it.
#[test]
fn an_infinite_brake_under_a_chassis_without_mass() {
    let mut road = Road::level(60, 1.0);
    road.run(0.2);
    let collider = road.chassis().colliders()[0];
    road.world.colliders[collider].set_mass(0.0);
    let chassis = road.car.chassis;
    road.world.bodies[chassis].set_translation(Vector::Y * 50.0, true);
    road.wheels(|wheel| wheel.brake = Real::INFINITY);
    road.run(0.2);
    assert_eq!(road.chassis().mass(), 0.0);
    assert!(is_valid(&road));
    assert!(road.car.wheels().iter().all(|wheel| wheel.spin() == 0.0));
}

/// Every field of one wheel takes every value: the world stays finite, and invalid numbers are named in the
/// log.
#[test]
fn every_number_everywhere() {
    for (name, set) in FIELDS {
        for value in EDGES {
            let mut road = Road::level(60, 1.0);
            road.run(0.2);
            set(&mut road.car.wheels_mut()[1], value);
            let ((), log) = listen(|| road.run(0.2));
            assert!(is_valid(&road), "{name} of {value}");
            let reported = log.iter().any(|line| line.contains(name) && names(line, value));
            let may_be_infinite = ["travel", "force", "brake"].contains(&name) && value > 0.0;
            if NOT_FINITE.iter().any(|v| v.to_bits() == value.to_bits()) && !may_be_infinite {
                assert!(reported || name == "place", "{name} of {value}: {log:?}");
                assert_eq!(log.len(), 1, "it is reported once: {log:?}");
                let wheels = road.car.wheels();
                assert!(!wheels[1].raycast_info().is_in_contact, "{name} of {value}");
                assert!(wheels[0].raycast_info().is_in_contact, "the others go on");
            }
        }
    }
    for (name, set) in OUTPUTS {
        for value in EDGES {
            let mut road = Road::level(60, 1.0);
            road.run(0.2);
            road.wheels(|wheel| set(wheel, value));
            let ((), log) = listen(|| road.run(0.2));
            assert!(is_valid(&road) && log.is_empty(), "{name} of {value}");
        }
    }
}

/// An unusable wheel works again after its repair.
#[test]
fn repaired() {
    let mut road = Road::level(60, 1.0);
    road.run(1.0);
    road.car.wheels_mut()[2].axle_cs = Vector::ZERO;
    road.run(0.5);
    assert!(!road.car.wheels()[2].raycast_info().is_in_contact);
    road.car.wheels_mut()[2].axle_cs = Vector::Z;
    road.run(5.0);
    assert!((road.chassis().translation().y - HEIGHT).abs() < 1.0e-3);
}

#[test]
fn invalid_time_steps() {
    for dt in [0.0, -0.0, -1.0, Real::NAN, Real::INFINITY, Real::NEG_INFINITY, Real::MAX] {
        let mut road = Road::level(60, 1.0);
        road.wheels(|wheel| wheel.engine_force = 1000.0);
        let before = road.car.wheels()[0].rotation;
        let queries = road.world.query_pipeline_mut(QueryFilter::default());
        let ((), log) = listen(|| road.car.update_vehicle(dt, queries));
        assert_eq!(log.len(), usize::from(dt != 0.0), "{dt}: {log:?}");
        assert!(log.iter().all(|line| names(line, dt)), "{dt}: {log:?}");
        assert_eq!(road.car.wheels()[0].raycast_info().is_in_contact, dt == 0.0, "{dt}");
        assert_eq!(road.car.wheels()[0].rotation, before);
        let linvel = road.chassis().linvel();
        road.world.step();
        // The chassis falls as if it were alone.
        let fallen = road.chassis().linvel() - linvel;
        assert!((fallen - Vector::Y * -9.81 / 60.0).length() < 1.0e-5, "{dt}: {fallen}");
    }
}

#[test]
fn very_short_and_very_long_steps() {
    for dt in [Real::MIN_POSITIVE, 1.0e-12, 1.0e-6, 10.0, 1.0e6, 1.0e15] {
        let mut road = Road::level(60, 1.0);
        road.wheels(|wheel| {
            wheel.engine_force = 1000.0;
            wheel.brake = 10.0;
        });
        for _ in 0..20 {
            let queries = road.world.query_pipeline_mut(QueryFilter::default());
            road.car.update_vehicle(dt, queries);
            road.world.step();
            assert!(is_valid(&road), "{dt}");
        }
    }
}

#[test]
fn no_chassis() {
    let mut road = Road::level(60, 1.0);
    road.run(0.1);
    let chassis = road.car.chassis;
    road.world.remove_body(chassis);
    let seen: Vec<_> = road.car.wheels().to_vec();
    let ((), log) = listen(|| road.run(0.1));
    assert_eq!(log.len(), 1, "it is reported once: {log:?}");
    assert_eq!(road.car.wheels(), seen, "nothing changes");

    let mut lost = DynamicRayCastVehicleController::new(RigidBodyHandle::default());
    lost.update_vehicle(0.1, road.world.query_pipeline_mut(QueryFilter::default()));
    road.car.index_up_axis = 3;
    let queries = road.world.query_pipeline_mut(QueryFilter::default());
    let ((), log) =
        listen(|| DynamicRayCastVehicleController::update_vehicle(&mut road.car, 0.1, queries));
    assert!(log.is_empty() || log[0].contains('3'), "{log:?}");
}

/// The chassis is disabled, fixed, kinematic, without mass, or locked in every axis.
#[test]
fn unusual_chassis() {
    type Change = fn(&mut RigidBody);
    let changes: [Change; 7] = [
        |body| body.set_enabled(false),
        |body| body.set_body_type(RigidBodyType::Fixed, true),
        |body| body.set_body_type(RigidBodyType::KinematicVelocityBased, true),
        |body| body.set_body_type(RigidBodyType::KinematicPositionBased, true),
        |body| body.set_locked_axes(LockedAxes::all(), true),
        |body| body.set_locked_axes(LockedAxes::TRANSLATION_LOCKED_Y, true),
        |body| body.set_gravity_scale(-1.0, true),
    ];
    for (index, change) in changes.into_iter().enumerate() {
        let mut road = Road::level(60, 1.0);
        road.run(0.1);
        let chassis = road.car.chassis;
        change(&mut road.world.bodies[chassis]);
        road.wheels(|wheel| wheel.engine_force = 1000.0);
        road.run(0.5);
        assert!(is_valid(&road), "{index}");
    }
    let mut road = Road::level(60, 1.0);
    let shape = road.chassis().colliders()[0];
    road.world.remove_collider(shape);
    road.run(0.5);
    assert!(is_valid(&road));
}

/// The wheels of a kinematic chassis roll with its motion.
#[test]
fn kinematic_chassis_roll() {
    let mut road = Road::level(60, 1.0);
    let chassis = road.car.chassis;
    let body = &mut road.world.bodies[chassis];
    body.set_body_type(RigidBodyType::KinematicVelocityBased, true);
    body.set_linvel(Vector::X * 3.0, true);
    road.run(1.0);
    assert!((road.car.wheels()[0].rotation * 0.3 - 3.0).abs() < 1.0e-3);
}

/// Rays begin inside the chassis, which has several colliders, one of them low; sensors are not ground. The
/// user's own exclusion remains in effect.
#[test]
fn own_chassis_and_sensors_are_not_ground() {
    let mut road = Road::level(60, 1.0);
    let chassis = road.car.chassis;
    let skirt = ColliderBuilder::cuboid(2.0, 0.05, 0.9).translation(-Vector::Y * 0.45).density(0.0);
    road.world.insert_collider(skirt, Some(chassis));
    let sensor = ColliderBuilder::cuboid(9.0, 0.1, 9.0).translation(Vector::Y * 0.2).sensor(true);
    road.world.insert_collider(sensor, None);
    let block = RigidBodyBuilder::fixed();
    let (block, _) = road.world.insert(
        block,
        ColliderBuilder::cuboid(9.0, 0.05, 9.0).collision_groups(InteractionGroups::none()),
    );
    road.world.step();
    for _ in 0..300 {
        let filter = QueryFilter::default().exclude_rigid_body(block);
        road.car.update_vehicle(1.0 / 60.0, road.world.query_pipeline_mut(filter));
        road.world.step();
    }
    let height = road.chassis().translation().y;
    assert!((height - HEIGHT).abs() < 1.0e-3, "it stands at {height}");
    let ground = road.car.wheels()[0].raycast_info().ground_object.unwrap();
    assert_eq!(road.world.colliders[ground].parent(), None);
}

/// The same drive twice gives the same bits; a second update before the step does not diverge.
#[test]
fn determinism_and_double_updates() {
    let drive = |updates: usize| {
        let mut road = Road::level(60, 0.8);
        for step in 0..240 {
            let time = step as Real / 60.0;
            for (index, wheel) in road.car.wheels_mut().iter_mut().enumerate() {
                wheel.engine_force = 2000.0;
                wheel.steering = if index < 2 { 0.4 * time.sin() } else { 0.0 };
                wheel.brake = if step > 200 { 100.0 } else { 0.0 };
            }
            for _ in 1..updates {
                let queries = road.world.query_pipeline_mut(QueryFilter::default());
                road.car.update_vehicle(1.0 / 60.0, queries);
            }
            road.step();
            assert!(is_valid(&road));
        }
        crate::dim::components(road.chassis().position())
    };
    assert_eq!(drive(1), drive(1));
    let twice = drive(2);
    assert!(twice.iter().all(|number| number.abs() < 100.0), "{twice:?}");
}

/// Two vehicles share one chassis, one of them upside down, and a vehicle stands on another one.
#[test]
fn vehicles_on_vehicles() {
    let mut road = Road::level(60, 1.0);
    let mut second = road.car.clone();
    let upside_down = Rotation::from_rotation_x(3.1);
    let pose = Pose::from_parts(Vector::new(9.0, 2.0, 0.0), upside_down);
    let mut third = add_car(&mut road.world, pose, 1.0);
    let pose = Pose::from_translation(Vector::Y * 2.5);
    let mut fourth = add_car(&mut road.world, pose, 1.0);
    for _ in 0..300 {
        for car in [&mut second, &mut third, &mut fourth] {
            car.update_vehicle(1.0 / 60.0, road.world.query_pipeline_mut(QueryFilter::default()));
        }
        road.step();
        assert!(is_valid(&road));
    }
    for (_, body) in road.world.bodies.iter() {
        assert!(body.linvel().length() < 1.0, "{}", body.linvel());
        assert!(body.translation().length() < 20.0, "{}", body.translation());
    }
}
