//! The normal rows: impulses that stop bodies, separate them, let them bounce, and depend on their distance.

use super::scene::{
    Body, Contact, LANE, SUBSTEP, Scene, THRESHOLD, advance, random_direction, random_vector,
};
use crate::base::random::Random;
use crate::dim::math::{
    ANG_ZERO, MAX_MANIFOLD_POINTS, Real, Vector, ang_length_squared, integrate_rotation,
};
use crate::dim::state::BodyState;

/// Rounding error of a velocity of about 1.
const ROUNDING: Real = 1000.0 * Real::EPSILON;

/// Two bodies and a point between them.
fn random_contact(random: &mut Random) -> ([Option<Body>; 2], Contact) {
    let bodies = [Some(Body::random(random)), Some(Body::random(random))];
    let contact = Contact::at(random_direction(random), &[random_vector(random, 1.0)]);
    (bodies, contact)
}

/// A scene whose substeps are long: else the rounding error of a separation would be a velocity that
/// closes it.
fn long_substep(bodies: [Option<Body>; 2], contact: &Contact) -> Scene {
    let mut scene = Scene::new(bodies, contact);
    scene.pass.inv_substep = 1.0;
    scene
}

#[test]
fn one_point_stops_bodies_that_approach_and_lets_others_go() {
    let mut random = Random(1);
    let (mut stopped, mut left) = (0, 0);
    for _ in 0..200 {
        let (bodies, contact) = random_contact(&mut random);
        let (n, p) = (contact.normal, contact.points[0].0);
        let mut scene = long_substep(bodies, &contact);
        scene.prepare();
        let before = scene.relative_velocity(bodies, p).dot(n);
        scene.solve();
        let after = scene.relative_velocity(bodies, p).dot(n);
        if before < 0.0 {
            stopped += 1;
            assert!(after.abs() < ROUNDING, "from {before} to {after}");
            assert!(scene.normal_impulse() > 0.0);
        } else {
            left += 1;
            assert_eq!(after, before);
            assert_eq!(scene.normal_impulse(), 0.0);
        }
    }
    assert!(stopped > 50 && left > 50);
}

/// Equal and opposite impulses at one point conserve momentum and angular momentum. It is therefore
/// sufficient to check the motion of each body by its mass and inertia.
#[test]
fn impulses_are_equal_and_opposite_and_act_at_the_point() {
    let mut random = Random(2);
    for _ in 0..200 {
        let (bodies, contact) = random_contact(&mut random);
        let mut scene = long_substep(bodies, &contact);
        scene.prepare();
        scene.solve();
        let impulse = contact.normal * scene.normal_impulse();
        for (side, body) in bodies.into_iter().flatten().enumerate() {
            let impulse = if side == 0 { -impulse } else { impulse };
            let (linvel, angvel) = body.pushed(impulse, contact.points[0].0);
            let (found_linvel, found_angvel) = scene.velocity(side + 1);
            assert!((found_linvel - linvel).length() < ROUNDING, "{found_linvel} not {linvel}");
            let error = ang_length_squared(found_angvel - angvel).sqrt();
            assert!(error < ROUNDING, "{found_angvel} instead of {angvel}");
        }
    }
}

/// Points around a middle, in the plane of a normal.
fn plane_points(random: &mut Random, normal: Vector, middle: Vector) -> Vec<Vector> {
    let mut points = Vec::new();
    for k in 0..MAX_MANIFOLD_POINTS {
        let side = if k % 2 == 0 { 1.0 } else { -1.0 };
        let arm = random_direction(random) * 0.5;
        points.push(middle + (arm - normal * normal.dot(arm)) * side);
    }
    points
}

#[test]
fn several_points_stop_together() {
    let mut random = Random(3);
    for _ in 0..50 {
        let bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
        let normal = random_direction(&mut random);
        let middle = random_vector(&mut random, 1.0);
        let points = plane_points(&mut random, normal, middle);
        let mut scene = long_substep(bodies, &Contact::at(normal, &points));
        scene.prepare();
        for _ in 0..500 {
            scene.relax();
        }
        for (k, &point) in points.iter().enumerate() {
            let velocity = scene.relative_velocity(bodies, point).dot(normal);
            let impulse = scene.block.points[k].impulse.0[LANE];
            assert!(velocity > -0.01, "point {k} still comes at {velocity}");
            assert!(impulse == 0.0 || velocity < 0.01, "point {k} is pushed off at {velocity}");
        }
    }
}

/// One iteration over coupled points of a block equals one over rows that are applied to the bodies one by
/// one.
#[test]
fn an_iteration_is_gauss_seidel() {
    let mut random = Random(4);
    for _ in 0..100 {
        let bodies = [Some(Body::random(&mut random)), Some(Body::random(&mut random))];
        let normal = random_direction(&mut random);
        let points = plane_points(&mut random, normal, Vector::ZERO);
        let mut scene = long_substep(bodies, &Contact::at(normal, &points));
        scene.prepare();
        scene.relax();
        let mut one_by_one = bodies.map(|body| body.expect("two bodies"));
        for &point in &points {
            let bodies = one_by_one.map(Some);
            let mut single = long_substep(bodies, &Contact::at(normal, &[point]));
            single.prepare();
            single.relax();
            for (k, body) in one_by_one.iter_mut().enumerate() {
                (body.linvel, body.angvel) = single.velocity(k + 1);
            }
        }
        for (k, body) in one_by_one.iter().enumerate() {
            let (linvel, angvel) = scene.velocity(k + 1);
            assert!((linvel - body.linvel).length() < ROUNDING);
            assert!(ang_length_squared(angvel - body.angvel).sqrt() < ROUNDING);
        }
    }
}

#[test]
fn separated_points_close_up_to_contact() {
    let body = Some(Body { linvel: -Vector::Y * 10.0, ..Body::block() });
    let mut contact = Contact::at(Vector::Y, &[-Vector::Y]);
    contact.points[0].1 = 0.01;
    let mut scene = Scene::new([None, body], &contact);
    scene.prepare();
    scene.solve();
    let (linvel, _) = scene.velocity(1);
    assert!((linvel.y + 0.01 / SUBSTEP).abs() < ROUNDING * 10.0, "{linvel}");
    // Once it has moved, the gap is closed, and nothing is left to allow.
    advance(&mut scene.states[1], SUBSTEP);
    scene.relax();
    let (linvel, _) = scene.velocity(1);
    assert!(linvel.y.abs() < ROUNDING, "{linvel}");
}

#[test]
fn overlap_is_undone_at_a_limited_speed_and_relaxed_away() {
    let mut contact = Contact::at(Vector::Y, &[-Vector::Y]);
    for (depth, speed) in [(0.0005, 0.0), (0.011, 1.0), (0.3, 4.0)] {
        contact.points[0].1 = -depth;
        let mut scene = Scene::new([None, Some(Body::block())], &contact);
        scene.pass.softness.bias_rate = 100.0;
        scene.pass.allowed_error = 0.001;
        scene.prepare();
        scene.solve();
        let (linvel, _) = scene.velocity(1);
        assert!((linvel.y - speed).abs() < ROUNDING, "{linvel} at depth {depth}");
        scene.relax();
        let (linvel, _) = scene.velocity(1);
        assert!(linvel.y.abs() < ROUNDING, "{linvel} is left at depth {depth}");
    }
}

#[test]
fn impacts_bounce_and_resting_contacts_do_not() {
    let mut random = Random(5);
    let mut bounced = 0;
    for _ in 0..200 {
        let (bodies, mut contact) = random_contact(&mut random);
        contact.restitution = random.within(0.1, 1.0);
        let (n, p) = (contact.normal, contact.points[0].0);
        let mut scene = long_substep(bodies, &contact);
        let approach = scene.relative_velocity(bodies, p).dot(n);
        scene.prepare();
        scene.bounce();
        scene.solve();
        scene.relax();
        let after = scene.relative_velocity(bodies, p).dot(n);
        let expected = if approach < -THRESHOLD {
            bounced += 1;
            -contact.restitution * approach
        } else {
            approach.max(0.0)
        };
        assert!((after - expected).abs() < ROUNDING, "{approach} to {after}, not {expected}");
    }
    assert!(bounced > 20);
}

/// A bounce counts into the impulse of the step, and the next step does not start with it.
#[test]
fn a_bounce_is_no_load() {
    let body = Body { linvel: -Vector::Y, ..Body::block() };
    let mut contact = Contact::at(Vector::Y, &[-Vector::Y]);
    contact.restitution = 0.5;
    let mut scene = Scene::new([None, Some(body)], &contact);
    scene.prepare();
    scene.bounce();
    scene.solve();
    scene.relax();
    assert_eq!(scene.normal_impulse(), 0.0);
    assert!((scene.block.totals[0].0[LANE] - 1.5).abs() < ROUNDING);
    assert!((scene.velocity(1).0 - Vector::Y * 0.5).length() < ROUNDING);
}

/// A fast body that does not arrive in this substep keeps its speed.
#[test]
fn a_near_miss_does_not_bounce() {
    let body = Some(Body { linvel: -Vector::Y, ..Body::block() });
    let mut contact = Contact::at(Vector::Y, &[-Vector::Y]);
    contact.points[0].1 = 0.015;
    contact.restitution = 1.0;
    let mut scene = Scene::new([None, body], &contact);
    scene.prepare();
    scene.bounce();
    scene.solve();
    scene.relax();
    assert_eq!(scene.velocity(1).0, -Vector::Y);
}

/// Separation of a point in the kernel after the bodies have moved for `time`, and the exact separation.
fn separations(bodies: [Body; 2], contact: &Contact, time: Real) -> (Real, Real) {
    let (point, gap) = contact.points[0];
    let mut scene = Scene::new(bodies.map(Some), contact);
    scene.prepare();
    let mut ends = [Vector::ZERO; 2];
    for (k, body) in bodies.iter().enumerate() {
        advance(&mut scene.states[k + 1], time);
        let away = if k == 0 { -0.5 } else { 0.5 };
        let arm = point + contact.normal * (away * gap) - body.center;
        let turned = integrate_rotation(body.rotation, body.angvel * time);
        let arm = turned * (body.rotation.inverse() * arm);
        ends[k] = body.center + body.linvel * time + arm;
        // Coming so fast that the speed it is left with is the gap over the substep.
        let toward = if k == 0 { 1.0 } else { -1.0 };
        scene.states[k + 1].set_velocity(contact.normal * (toward * 50.0), body.angvel);
    }
    scene.pass.inv_substep = 1.0;
    scene.relax();
    let seen = -scene.relative_velocity(bodies.map(Some), point).dot(contact.normal);
    let turned = integrate_rotation(bodies[0].rotation, bodies[0].angvel * time);
    let normal = turned * (bodies[0].rotation.inverse() * contact.normal);
    (seen, (ends[1] - ends[0]).dot(normal))
}

#[test]
fn separation_is_followed_to_second_order() {
    let mut random = Random(6);
    let (mut coarse, mut fine) = (0.0, 0.0);
    for _ in 0..100 {
        let bodies = [Body::random(&mut random), Body::random(&mut random)];
        let mut contact = Contact::at(random_direction(&mut random), &[Vector::ZERO]);
        contact.points[0].1 = 1.0;
        let (seen, truth) = separations(bodies, &contact, 0.1);
        coarse += (seen - truth).abs();
        let (seen, truth) = separations(bodies, &contact, 0.05);
        fine += (seen - truth).abs();
    }
    // Half the motion, a quarter of the error.
    let ratio = coarse / fine;
    assert!((3.5..4.5).contains(&ratio), "{ratio}");
    assert!(fine / 100.0 < 0.01, "{fine}");
}

#[test]
fn a_dominant_body_is_not_moved() {
    let mut random = Random(7);
    for dominant in [0, 1] {
        let (bodies, contact) = random_contact(&mut random);
        let point = contact.points[0].0;
        let mut scene = long_substep(bodies, &contact.rough(1.0));
        scene.input.mass_factors[dominant].0[LANE] = 0.0;
        scene.input.impulses[0].0[LANE] = 1.0;
        scene.prepare();
        assert_ne!(
            scene.velocity(2 - dominant).0,
            bodies[1 - dominant].expect("two bodies").linvel
        );
        scene.solve();
        let normal = scene.block.normal.lane(LANE);
        assert!(scene.relative_velocity(bodies, point).dot(normal) > -ROUNDING);
        scene.relax();
        let body = bodies[dominant].expect("two bodies");
        assert_eq!(scene.velocity(dominant + 1), (body.linvel, body.angvel));
    }
}

/// A body on a rail along x touches a slope. Friction and the normal row act on the same coordinate, and each
/// must include the effect of the other.
#[test]
fn rows_of_a_locked_body_are_coupled() {
    let normal = (Vector::X + Vector::Y).normalize();
    let rail = Body { inv_mass: Vector::X, linvel: -Vector::X, ..Body::block() };
    let mut scene = Scene::new([None, Some(rail)], &Contact::at(normal, &[-normal]).rough(2.0));
    scene.prepare();
    scene.solve();
    for _ in 0..3 {
        // Something else pushes it against the slope again.
        scene.states[1] = BodyState::new(-Vector::X, ANG_ZERO);
        scene.relax();
        let (linvel, _) = scene.velocity(1);
        assert!(linvel.length() < ROUNDING, "{linvel}");
    }
}
