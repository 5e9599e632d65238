//! Friction: sliding distances, holding slopes, rolling.

use super::stage::{G, RATES, add_ground, penetration, run, substep, world};
use super::table::Table;
use crate::dim::{ROLLING_BALL, about_z, cuboid, vec};
use rapier::prelude::*;

/// Speed of the tilting table (rad/s), small enough that its inertial effects on the box are negligible.
const TILTING: Real = 0.02;

/// A box of the speed `v` slides for the distance `v² / 2µg`. Semi-implicit Euler uses the velocity
/// at the end of each substep, which subtracts `v h / 2`.
#[test]
fn slide_to_stop() {
    let columns =
        ["rate", "friction", "distance (m)", "formula", "exact", "error (m)", "turn (rad)"];
    let mut table = Table::new("slide to stop from 8 m/s", &columns);
    let speed: Real = 8.0;
    for rate in RATES {
        for friction in [0.3, 0.6] {
            let mut world = world(rate);
            add_ground(&mut world, friction);
            let body =
                RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5)).linvel(vec(speed, 0.0));
            let (body, _) = world.insert(body, cuboid(0.5, 0.5).friction(friction));
            run(&mut world, 5.0);
            let body = &world.bodies[body];
            let distance = body.translation().x;
            let exact = speed * speed / (2.0 * friction * G);
            let formula = exact - 0.5 * speed * substep(&world);
            let turn = crate::dim::angle(body.rotation());
            table.row([
                rate.to_string(),
                friction.to_string(),
                format!("{distance:.4}"),
                format!("{formula:.4}"),
                format!("{exact:.4}"),
                format!("{:+.4}", distance - exact),
                format!("{turn:+.1e}"),
            ]);
            table.require(body.linvel().length() < 1.0e-3, "still slides");
            table.check("the distance", distance, formula, 5.0e-3);
        }
    }
}

/// Builds a slope of `tan θ = slope` with a body that just touches it. Returns the world, the body, and the
/// directions down the slope and out of it.
fn on_slope(
    rate: u32,
    slope: Real,
    friction: Real,
    height: Real,
    collider: ColliderBuilder,
) -> (PhysicsWorld, RigidBodyHandle, Vector) {
    let angle = slope.atan();
    let (sin, cos) = angle.sin_cos();
    let mut world = world(rate);
    let slab = cuboid(100.0, 1.0).friction(friction);
    // The slab is rotated clockwise about the point (0, 0) of its surface: down is to the right.
    let slab = slab.translation(vec(-sin, -cos)).rotation(about_z(-angle));
    world.insert_collider(slab, None);
    let body = RigidBodyBuilder::dynamic()
        .translation(vec(height * sin, height * cos))
        .rotation(about_z(-angle))
        .can_sleep(false);
    let (body, _) = world.insert(body, collider.friction(friction));
    (world, body, vec(cos, -sin))
}

/// A box on a slope stays if `tan θ ≤ µ`. Otherwise it slides with `a = g (sin θ - µ cos θ)`.
#[test]
fn slope_holds_or_slips() {
    let friction: Real = 0.5;
    let columns = ["rate", "tan θ / µ", "10 s of creep (mm)", "acceleration (m/s²)", "formula"];
    let mut table = Table::new("box on a slope, µ = 0.5", &columns);
    for rate in RATES {
        for ratio in [0.5, 0.9, 0.98] {
            let cube = cuboid(0.5, 0.5);
            let (mut world, body, down) = on_slope(rate, ratio * friction, friction, 0.5, cube);
            // The box lands first, so the motion of the first half second is excluded.
            run(&mut world, 0.5);
            let start = world.bodies[body].translation();
            run(&mut world, 10.0);
            let creep = (world.bodies[body].translation() - start).dot(down) * 1.0e3;
            let no = || "-".to_string();
            table.row([rate.to_string(), ratio.to_string(), format!("{creep:.4}"), no(), no()]);
            table.check("the creep", creep, 0.0, 1.0);
        }
        for ratio in [1.02, 1.1, 1.5] {
            let slope: Real = ratio * friction;
            let cube = cuboid(0.5, 0.5);
            let (mut world, body, down) = on_slope(rate, slope, friction, 0.5, cube);
            run(&mut world, 0.5);
            let start = world.bodies[body].linvel();
            run(&mut world, 2.0);
            let acceleration = (world.bodies[body].linvel() - start).dot(down) / 2.0;
            let (sin, cos) = slope.atan().sin_cos();
            let formula = G * (sin - friction * cos);
            table.row([
                rate.to_string(),
                ratio.to_string(),
                "-".to_string(),
                format!("{acceleration:.5}"),
                format!("{formula:.5}"),
            ]);
            table.check("the acceleration", acceleration, formula, 1.0e-3 * G);
        }
    }
}

/// A box on a slowly tilting table begins to slide at `tan θ = µ`. The test detects the motion
/// slightly later.
#[test]
fn tilted_table() {
    let (friction, slip): (Real, Real) = (0.5, 0.05);
    let columns = ["rate", "slipped 5 cm at (°)", "formula"];
    let mut table = Table::new("box on a table that tilts", &columns);
    for rate in RATES {
        let mut world = world(rate);
        let turning = RigidBodyBuilder::kinematic_velocity_based().angvel(about_z(-TILTING));
        let (slab, _) = world.insert(turning, cuboid(20.0, 1.0).friction(friction));
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 1.5)).can_sleep(false);
        let (body, _) = world.insert(body, cuboid(0.5, 0.5).friction(friction));
        let mut time = 0.0;
        let slipped = |world: &PhysicsWorld| {
            let pose = world.bodies[slab].position().inv_mul(world.bodies[body].position());
            pose.translation.x
        };
        while slipped(&world) < slip && time < 1.0 / TILTING {
            world.step();
            time += world.integration_parameters.dt;
        }
        let found = time * TILTING;
        // After the start it accelerates by g √(1 + µ²) times the excess angle, which grows with time.
        let jerk = G * (1.0 + friction * friction).sqrt() * TILTING;
        let formula = friction.atan() + TILTING * (6.0 * slip / jerk).cbrt();
        table.row([
            rate.to_string(),
            format!("{:.3}", found.to_degrees()),
            format!("{:.3}", formula.to_degrees()),
        ]);
        // Contacts follow a rotating table to within 0.1°.
        table.check("the angle", found, formula, 2.0e-3);
    }
}

/// A ball that rolls without slipping (`µ ≥ 2/7 tan θ`) has the acceleration `a = g sin θ / (1 + I /
/// m r²)` and the angular velocity `v / r`. The contact point lies midway between the overlapping
/// surfaces. Half of the overlap is therefore missing from `r`: about 0.1 % of `a`.
#[test]
fn ball_rolls() {
    let columns = ["rate", "acceleration (m/s²)", "formula", "error (%)", "slip (m/s)"];
    let mut table = Table::new("ball on a slope of 20°", &columns);
    for rate in RATES {
        let angle: Real = 20.0 * (std::f64::consts::PI / 180.0) as Real;
        let ball = ColliderBuilder::ball(0.5);
        let (mut world, body, down) = on_slope(rate, angle.tan(), 1.0, 0.5, ball);
        run(&mut world, 0.5);
        let start = world.bodies[body].linvel();
        run(&mut world, 2.0);
        let body = &world.bodies[body];
        let acceleration = (body.linvel() - start).dot(down) / 2.0;
        let sunk = penetration(&world) / 0.5;
        let inertia = (1.0 / ROLLING_BALL - 1.0) / (1.0 - 0.5 * sunk).powi(2);
        let formula = G * angle.sin() / (1.0 + inertia);
        let slip = body.linvel().dot(down) + 0.5 * crate::dim::z_of(body.angvel());
        let error = acceleration / formula - 1.0;
        table.row([
            rate.to_string(),
            format!("{acceleration:.5}"),
            format!("{formula:.5}"),
            format!("{:+.4}", error * 100.0),
            format!("{slip:+.1e}"),
        ]);
        table.check("the acceleration", acceleration, formula, 3.0e-4 * formula);
    }
}

/// Returns a world with a box that slides along x on the ground.
fn sliding_box(friction: Real) -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y).friction(friction), None);
    let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5)).linvel(Vector::X * 8.0);
    let (body, _) = world.insert(body, cuboid(1.0, 0.5).friction(friction));
    (world, body)
}

/// Runs 20 steps. Asserts that the friction impulses of the sliding box are the momentum that it loses, and
/// that none exceeds `µ` times the normal impulse of its point. The box carries the mass `m`. Returns the
/// momentum that it loses in a substep, relative to `µ m g h`.
#[track_caller]
fn friction_impulse(
    (world, body): (&mut PhysicsWorld, RigidBodyHandle),
    mass: Real,
    friction: Real,
) -> Real {
    let speed = |world: &PhysicsWorld| world.bodies[body].linvel().x;
    for _ in 0..19 {
        world.step();
    }
    let before = speed(world);
    world.step();
    let substeps = world.integration_parameters.num_solver_iterations as Real;
    let lost = mass * (before - speed(world)) / substeps;
    let (_, _, pair) = world.contact_pairs().next().expect("the box touches the ground");
    let data = &pair.manifolds[0].data;
    let each: Vec<Vector> = (0..data.points.len()).map(|k| data.friction_impulse(k)).collect();
    let total: Vector = each.iter().copied().sum();
    let is_second = data.rigid_body2.is_some();
    let along = if is_second { -total.x } else { total.x };
    assert!((along / lost - 1.0).abs() < 0.02, "{friction}: {total} of {lost}");
    for (own, point) in each.iter().zip(&data.points) {
        let bound = friction * point.warmstart_impulse;
        assert!(own.length() <= 1.05 * bound + 1.0e-4, "{friction}: {own} of {bound}");
    }
    assert_eq!(data.friction_impulse(data.points.len()), Vector::ZERO);
    lost / (friction * mass * G * substep(world))
}

/// Asserts that the sliding box loses the momentum `µ m g h`.
#[track_caller]
fn assert_friction_impulses(
    sliding: (&mut PhysicsWorld, RigidBodyHandle),
    mass: Real,
    friction: Real,
) {
    let fraction = friction_impulse(sliding, mass, friction);
    assert!((fraction - 1.0).abs() < 0.02, "{friction}: {fraction} of µ m g h");
}

/// The friction impulse of each contact can be read in the default model.
#[test]
fn friction_impulses_of_contacts_can_be_read() {
    for friction in [0.1, 0.4, 0.7] {
        let (mut world, body) = sliding_box(friction);
        let mass = world.bodies[body].mass();
        assert_friction_impulses((&mut world, body), mass, friction);
    }
}

/// The friction impulse of each contact can be read with Coulomb friction, and in the default model after it.
#[test]
fn friction_impulses_of_coulomb_contacts_can_be_read() {
    for friction in [0.1, 0.4, 0.7] {
        let (mut world, body) = sliding_box(friction);
        let mass = world.bodies[body].mass();
        for model in [FrictionModel::Coulomb, FrictionModel::Standard, FrictionModel::Coulomb] {
            world.integration_parameters.friction_model = model;
            assert_friction_impulses((&mut world, body), mass, friction);
        }
    }
}

/// The friction impulse of each contact of a link can be read, and that of the body after the removal of its
/// joint. The link carries a second one without a collider.
#[test]
fn friction_impulses_of_links_can_be_read() {
    for friction in [0.1, 0.4, 0.7] {
        for model in [FrictionModel::Standard, FrictionModel::Coulomb] {
            let (mut world, body) = sliding_box(friction);
            world.integration_parameters.friction_model = model;
            let load = RigidBodyBuilder::dynamic().additional_mass(1.0);
            let pose = *world.bodies[body].position();
            let load = world.insert_body(load.pose(pose).linvel(Vector::X * 8.0));
            let joint = world.multibody_joints.insert(body, load, FixedJoint::new(), true);
            let joint = joint.expect("the joint fits");
            let mass = world.bodies[body].mass();
            assert_friction_impulses((&mut world, body), mass + 1.0, friction);
            world.multibody_joints.remove(joint, true);
            assert_friction_impulses((&mut world, body), mass, friction);
        }
    }
}
