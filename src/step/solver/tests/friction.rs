//! Friction: it slows sliding, supports resting bodies, and stays within the cone.

use super::scene::{Body, Contact, SUBSTEP, Scene, random_direction, random_vector};
use crate::base::random::Random;
use crate::dim::contact::CoulombBlock;
use crate::dim::math::{MAX_MANIFOLD_POINTS, Real, Vector};

const ROUNDING: Real = 1000.0 * Real::EPSILON;
const GRAVITY: Real = 10.0;
const FRICTION: Real = 0.5;

/// A unit vector along the plane of a normal.
fn random_tangent(random: &mut Random, normal: Vector) -> Vector {
    loop {
        let direction = random_direction(random);
        let along = direction - normal * normal.dot(direction);
        if along.length() > 0.1 {
            return along.normalize();
        }
    }
}

/// A block that cannot turn, lying on the world, moving with this velocity.
fn block_on_ground(normal: Vector, linvel: Vector) -> Scene {
    let body = Body { linvel, ..Body::block() };
    Scene::new([None, Some(body)], &Contact::at(normal, &[-normal]).rough(FRICTION))
}

/// Runs a substep under an acceleration. Returns the normal impulse, which bounds friction.
fn substep(scene: &mut Scene, acceleration: Vector) -> Real {
    scene.begin_substep(acceleration);
    scene.solve();
    scene.relax();
    scene.normal_impulse()
}

#[test]
fn sliding_slows_by_friction_times_weight_in_every_direction() {
    let mut random = Random(11);
    for round in 0..30 {
        let normal = random_direction(&mut random);
        let direction = random_tangent(&mut random, normal);
        let mut scene = block_on_ground(normal, direction);
        scene.coulomb = (round % 2 == 1).then_some(CoulombBlock::EMPTY);
        scene.prepare();
        let mut speed: Real = 1.0;
        for _ in 0..100 {
            substep(&mut scene, -normal * GRAVITY);
            speed = (speed - FRICTION * GRAVITY * SUBSTEP).max(0.0);
            let (linvel, _) = scene.velocity(1);
            assert!((linvel - direction * speed).length() < ROUNDING, "{linvel} at {speed}");
        }
        assert_eq!(speed, 0.0);
    }
}

#[test]
fn impulses_within_the_cone_are_unchanged() {
    let mut random = Random(12);
    for _ in 0..30 {
        let normal = random_direction(&mut random);
        let pull = random_tangent(&mut random, normal) * (0.98 * FRICTION * GRAVITY);
        let mut scene = block_on_ground(normal, Vector::ZERO);
        scene.prepare();
        for _ in 0..20 {
            substep(&mut scene, pull - normal * GRAVITY);
            assert!(scene.velocity(1).0.length() < ROUNDING, "{}", scene.velocity(1).0);
        }
        let impulse = scene.friction_impulse();
        assert!((impulse + pull * SUBSTEP).length() < ROUNDING);
    }
}

#[test]
fn pulled_harder_than_the_cone_allows_it_slides() {
    let pull = 1.5 * FRICTION * GRAVITY;
    let mut scene = block_on_ground(Vector::Y, Vector::ZERO);
    scene.prepare();
    for substeps in 1..20 {
        substep(&mut scene, Vector::X * pull - Vector::Y * GRAVITY);
        let expected = (pull - FRICTION * GRAVITY) * SUBSTEP * substeps as Real;
        let (linvel, _) = scene.velocity(1);
        assert!((linvel - Vector::X * expected).length() < ROUNDING, "{linvel}");
    }
}

#[test]
fn the_impulse_never_leaves_the_cone() {
    let mut random = Random(13);
    for _ in 0..50 {
        let bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
        let points: Vec<_> =
            (0..MAX_MANIFOLD_POINTS).map(|_| random_vector(&mut random, 0.5)).collect();
        let contact = Contact::at(random_direction(&mut random), &points).rough(FRICTION);
        let mut scene = Scene::new(bodies, &contact);
        scene.prepare();
        for _ in 0..10 {
            let pull = random_vector(&mut random, 20.0);
            let limit = FRICTION * substep(&mut scene, pull);
            let friction = scene.friction_impulse();
            assert!(friction.length() <= limit * (1.0 + 8.0 * Real::EPSILON));
            assert!(friction.dot(contact.normal).abs() <= ROUNDING * limit);
        }
    }
}

#[test]
fn a_rough_contact_drags_along_at_the_surface_velocity() {
    let mut random = Random(14);
    let normal = random_direction(&mut random);
    let belt = random_tangent(&mut random, normal) * 0.3;
    let mut contact = Contact::at(normal, &[-normal]).rough(FRICTION);
    contact.tangent_velocity = belt;
    let mut scene = Scene::new([None, Some(Body::block())], &contact);
    scene.prepare();
    for _ in 0..100 {
        substep(&mut scene, -normal * GRAVITY);
    }
    assert!((scene.velocity(1).0 - belt).length() < ROUNDING);
}

/// Points near the first one under a large normal impulse, without a friction limit: finally the two bodies
/// move as one.
#[test]
fn a_rough_manifold_holds_fast() {
    let mut random = Random(15);
    for _ in 0..30 {
        let normal = random_direction(&mut random);
        let mut bodies = [Body::random(&mut random), Body::random(&mut random)];
        (bodies[0].center, bodies[1].center) = (-normal * 0.5, normal * 0.5);
        (bodies[0].linvel, bodies[1].linvel) = (normal * 10.0, -normal * 10.0);
        for body in &mut bodies {
            body.linvel += random_tangent(&mut random, normal);
        }
        let bodies = bodies.map(Some);
        let arm = random_tangent(&mut random, normal) * 0.3;
        let points = [arm, -arm];
        let mut scene = Scene::new(bodies, &Contact::at(normal, &points).rough(100.0));
        scene.prepare();
        for _ in 0..300 {
            scene.relax();
        }
        for point in points {
            let velocity = scene.relative_velocity(bodies, point);
            assert!(velocity.length() < 0.001, "{velocity}");
        }
    }
}

/// With one free axis, the matrix of the tangents has no inverse, and friction acts nevertheless.
#[test]
fn friction_slows_a_body_on_a_rail() {
    let mut random = Random(17);
    for _ in 0..30 {
        let turned = random_tangent(&mut random, Vector::Y);
        for normal in [Vector::Y, (Vector::Y + turned * 0.001).normalize()] {
            let rail = Body {
                inv_mass: Vector::X + Vector::Y,
                linvel: Vector::X - normal * 0.1,
                ..Body::block()
            };
            let contact = Contact::at(normal, &[-Vector::Y]).rough(FRICTION);
            let mut scene = Scene::new([None, Some(rail)], &contact);
            scene.prepare();
            scene.solve();
            scene.relax();
            let limit = FRICTION * scene.normal_impulse();
            let (linvel, _) = scene.velocity(1);
            assert!((linvel.x - (1.0 - limit)).abs() < 0.01, "{linvel}, limit {limit}");
        }
    }
}

/// With no prediction distance all points count the same.
#[test]
fn the_friction_centre_needs_no_prediction() {
    let body = Body { linvel: Vector::X - Vector::Y, ..Body::block() };
    let points = [Vector::X - Vector::Y, -Vector::X - Vector::Y];
    let run = |prediction| {
        let contact = Contact::at(Vector::Y, &points).rough(FRICTION);
        let mut turning = body;
        turning.inv_inertia = Body::random(&mut Random(18)).inv_inertia;
        let mut scene = Scene::new([None, Some(turning)], &contact);
        scene.prediction = prediction;
        scene.prepare();
        scene.solve();
        scene.relax();
        scene.velocity(1)
    };
    assert_eq!(format!("{:?}", run(0.0)), format!("{:?}", run(0.02)));
}
