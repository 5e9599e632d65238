//! Valid but extreme values: tiny, huge, far away, and combined.

use super::scene::Scene;
use super::values::SHAPE_MAX;
use super::world::check;
use crate::dim::queries::wide_ground;
use crate::dim::{about_z, cuboid, vec};
use rapier::prelude::*;

/// Returns a ground, and on it a box of this size and mass with linear and angular velocity.
fn pushed(size: Real, mass: Real, place: Vector) -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = PhysicsWorld::new();
    let ground = cuboid(10.0 * size, size).translation(place - Vector::Y * size);
    world.insert_collider(ground, None);
    let body = RigidBodyBuilder::dynamic()
        .translation(place + Vector::Y * size)
        .linvel(vec(size, 0.0))
        .angvel(about_z(1.0));
    let (body, _) = world.insert(body, cuboid(size, size).mass(mass));
    (world, body)
}

fn steps(world: &mut PhysicsWorld, count: usize) {
    for _ in 0..count {
        world.step();
        check(world);
    }
}

#[test]
fn steps_of_any_length_keep_the_invariants() {
    for dt in [0.0, 1.0e-15, 1.0e-9, 1.0e-6, 1.0, 10.0, 1.0e6, 1.0e15] {
        let mut scene = Scene::new();
        scene.world.integration_parameters.dt = dt;
        scene.steps(30);
        scene.world.integration_parameters.dt = 1.0 / 60.0;
        scene.steps(30);
    }
    let mut scene = Scene::new();
    for i in 0..60 {
        scene.world.integration_parameters.dt = [1.0 / 60.0, 0.0, 1.0e-9, 10.0][i % 4];
        scene.steps(1);
    }
}

/// A step of length zero detects collisions and moves no body, however often.
#[test]
fn steps_of_no_length_move_nothing() {
    let mut scene = Scene::new();
    let expected = Scene::new().all_in_the_end();
    scene.world.integration_parameters.dt = 0.0;
    let before: Vec<_> = scene.world.bodies.iter().map(|(_, b)| *b.position()).collect();
    scene.steps(10);
    let after: Vec<_> = scene.world.bodies.iter().map(|(_, b)| *b.position()).collect();
    assert_eq!(before, after);
    scene.world.integration_parameters.dt = 1.0 / 60.0;
    assert!(scene.all_in_the_end() == expected, "steps of no length left something behind");
}

#[test]
fn masses_from_a_microgram_to_a_mountain_rest_on_the_ground() {
    for mass in [1.0e-9, 1.0e-6, 1.0e-3, 1.0, 1.0e3, 1.0e6, 1.0e9] {
        let (mut world, body) = pushed(0.5, mass, Vector::ZERO);
        steps(&mut world, 240);
        let height = world.bodies[body].translation().y;
        assert!((height - 0.5).abs() < 0.02, "a mass of {mass} ends at {height}");
    }
}

/// A body is squeezed out by a neighbour of 10⁹ times its mass, without a gain of energy.
#[test]
fn masses_of_any_ratio_may_touch() {
    const MASSES: [Real; 4] = [1.0e-9, 1.0e-3, 1.0e3, 1.0e9];
    let untouched = Scene::new().distant_in_the_end();
    for below in MASSES {
        for above in MASSES {
            let mut scene = Scene::new();
            let pile = [scene.neighbours[0], scene.body, scene.neighbours[1]];
            for (body, mass) in pile.into_iter().zip([below, 1.0, above]) {
                let collider = scene.world.bodies[body].colliders()[0];
                scene.world.colliders[collider].set_mass(mass);
            }
            assert!(
                scene.distant_in_the_end() == untouched,
                "{above} on {below} affects distant bodies"
            );
            // The centres are at half a metre, a metre and a half, and two and a half.
            let energy = 9.81 * (0.5 * below + 1.5 + 2.5 * above);
            for step in 0..120 {
                scene.steps(1);
                for handle in pile {
                    let body = &scene.world.bodies[handle];
                    let kinetic = 0.5 * body.mass() * body.linvel().length_squared();
                    let height = body.translation().y;
                    let case =
                        format!("{above} on {below}, step {step}: {kinetic} J at {height} m");
                    assert!(body.is_enabled() && kinetic <= energy, "{case} of {energy} J");
                    // A crushed body yields; the crushing one does not fall through the ground.
                    let is_heaviest = body.mass() >= below.max(above).max(1.0);
                    assert!(height > 0.4 || !is_heaviest, "{case}");
                }
            }
        }
    }
}

#[test]
fn sizes_and_masses_of_any_ratio_keep_the_invariants() {
    for (small, large) in [(1.0e-6, 1.0e6), (1.0e-3, 1.0e3), (1.0e-15, 1.0e15), (0.1, 1.0e9)] {
        let mut world = PhysicsWorld::new();
        world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
        for (i, size) in [small, large, small, large].into_iter().enumerate() {
            let place = vec(0.0, 2.0 * large * i as Real);
            let body = RigidBodyBuilder::dynamic().translation(place).additional_mass(small);
            world.insert(body, cuboid(size, size).mass(size));
        }
        steps(&mut world, 60);
    }
}

#[test]
fn piles_far_out_leave_the_world_in_order() {
    for distance in [1.0e4, 1.0e7, 1.0e10, 9.9e14] {
        for direction in [Vector::X, Vector::Y, -Vector::ONE] {
            let (mut world, _) = pushed(0.5, 1.0, direction * distance);
            world.insert(
                RigidBodyBuilder::dynamic().translation(direction * distance + Vector::Y * 2.0),
                ColliderBuilder::ball(0.5),
            );
            steps(&mut world, 30);
        }
    }
}

/// Grounds collide up to the size that the precision allows, and larger ones are refused with their size. (In
/// double precision, ground with corners beyond 10⁹ m let everything fall through.)
#[test]
fn grounds_of_any_size_collide_or_are_refused() {
    for half in [1.0e3, 1.0e6, 1.0e8, 1.0e10, 1.0e12] {
        // Larger coordinates are not exact to a millimetre.
        let is_exact = half * Real::EPSILON < 1.0e-3;
        for place in [0.0, 0.5, -0.9].into_iter().filter(|_| is_exact) {
            let mut world = PhysicsWorld::new();
            let mut ground = wide_ground(half).expect("is small enough");
            ground.set_translation(vec(place * half, 0.0));
            world.insert_collider(ground, None);
            let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.51));
            let (ball, _) = world.insert(body, ColliderBuilder::ball(0.5));
            steps(&mut world, 60);
            let height = world.bodies[ball].translation().y;
            assert!((height - 0.5).abs() < 0.02, "{height} on ground of {half} at {place}");
        }
    }
    for half in [1.1 * SHAPE_MAX, 100.0 * SHAPE_MAX] {
        let message = wide_ground(half).expect_err("is too large").to_string();
        assert!(message.contains(&format!("{half}")), "{message}");
    }
}

/// At the limit of positions, a body stops with a message.
#[test]
fn no_body_leaves_the_world() {
    for speed in [1.0e9, 1.0e14, 1.0e15] {
        let mut scene = Scene::new();
        let distant = Scene::new().distant_in_the_end();
        let top = scene.neighbours[1];
        scene.world.bodies[top].set_linvel(Vector::Y * speed, true);
        assert!(scene.distant_in_the_end() == distant, "{speed} affects distant bodies");
        scene.steps(100);
        let height = scene.world.bodies[top].translation().y;
        assert!((0.9 * speed..=1.0e15).contains(&height), "{speed} takes it to {height}");
    }
}

#[test]
fn bodies_at_one_point_keep_the_invariants() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    for i in 0..400 {
        let collider = if i % 2 == 0 { ColliderBuilder::ball(0.5) } else { cuboid(0.5, 0.5) };
        world.insert(RigidBodyBuilder::dynamic().translation(Vector::Y), collider);
    }
    steps(&mut world, 3);
    assert!(world.bodies.iter().all(|(_, body)| body.translation().length() < 100.0));
}

#[test]
fn very_many_colliders_on_one_body() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let body = world.insert_body(RigidBodyBuilder::dynamic().translation(Vector::Y));
    let mut colliders = Vec::new();
    for i in 0..2000 {
        let place = vec(0.1 * (i % 100) as Real, 0.1 * (i / 100) as Real);
        colliders.push(world.insert_collider(cuboid(0.05, 0.05).translation(place), Some(body)));
    }
    steps(&mut world, 30);
    for collider in colliders {
        world.remove_collider(collider);
    }
    steps(&mut world, 2);
    assert!(world.bodies[body].colliders().is_empty());
}

/// Friction and restitution far beyond physical values.
#[test]
fn impossible_surfaces_keep_the_invariants() {
    for value in [2.0, 100.0, 1.0e6, 1.0e15] {
        let (mut world, body) = pushed(0.5, 1.0, Vector::ZERO);
        let collider = world.bodies[body].colliders()[0];
        world.colliders[collider].set_friction(value);
        world.colliders[collider].set_restitution(value);
        world.colliders[collider].set_restitution_combine_rule(CoefficientCombineRule::Max);
        world.bodies[body].set_linvel(vec(5.0, -5.0), true);
        steps(&mut world, 120);
    }
}

/// Kinematic bodies follow their targets, unless the speed would exceed the representable range.
#[test]
fn kinematic_jumps_keep_the_invariants() {
    for distance in [1.0, 1.0e3, 1.0e9, 1.0e15] {
        for dt in [1.0 / 60.0, 1.0e-9] {
            let mut scene = Scene::with_body_type(RigidBodyType::KinematicPositionBased);
            scene.world.integration_parameters.dt = dt;
            for i in 0..6 {
                let y = if i % 2 == 0 { distance } else { 1.5 };
                scene.body().set_next_kinematic_position(Pose::from_translation(Vector::Y * y));
                scene.body().set_next_kinematic_rotation(
                    *RigidBodyBuilder::dynamic().rotation(about_z(i as Real)).build().rotation(),
                );
                let speed = (y - scene.body().translation().y).abs() / dt;
                scene.steps(1);
                if speed <= 1.0e15 {
                    assert_eq!(scene.body().translation().y, y, "it reaches its target");
                    continue;
                }
                let cause = scene.body().quarantine();
                assert!(matches!(cause, Some(QuarantineCause::KinematicTarget(_))), "{cause:?}");
                scene.body().set_enabled(true);
            }
        }
    }
}
