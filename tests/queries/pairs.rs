//! Every pair of shapes has a result for every query, and the results agree with each other.
//!
//! No query is compared with itself: intersections and contacts are compared with distances, casts with
//! distances along the path, and rotating casts with straight ones.

use crate::dim::about_z;
use crate::dim::queries::every_shape;
use crate::suite::physics::stage::{Dice, world};
use crate::suite::worlds::own_shape::OwnShape;
use rapier::parry::query::{NonlinearRigidMotion, QueryDispatcher};
use rapier::parry::shape::Ball;
use rapier::prelude::*;

/// Relative poses of each pair of shapes.
const POSES: usize = 24;
/// Precision of parry's search for closest points (length units), for shapes of a metre.
pub(super) const TOLERANCE: Real = 4.0e-3;
/// Relative precision of that search between curved shapes.
const CURVED_FRACTION: Real = 0.02;
/// Places on the path of a cast.
const PLACES: u16 = 40;

fn shapes() -> Vec<(&'static str, SharedShape)> {
    let mut shapes = every_shape();
    shapes.push(("own shape", SharedShape::new(OwnShape(Ball::new(0.5)))));
    shapes
}

pub(super) fn pose(dice: &mut Dice, reach: Real) -> Pose {
    let mut place = Vector::ZERO;
    (0..DIM).for_each(|axis| place[axis] = dice.within(-reach, reach));
    let body = RigidBodyBuilder::fixed().translation(place);
    *body.rotation(about_z(dice.within(-3.0, 3.0))).build().position()
}

pub(super) fn for_each_pair(mut f: impl FnMut([&str; 2], [&SharedShape; 2], &mut Dice)) {
    let shapes = shapes();
    for (i, (name1, shape1)) in shapes.iter().enumerate() {
        for (j, (name2, shape2)) in shapes.iter().enumerate() {
            f([name1, name2], [shape1, shape2], &mut Dice((100 * i + j) as u64));
        }
    }
}

pub(super) fn distance(
    query: &dyn QueryDispatcher,
    pose: &Pose,
    shapes: [&SharedShape; 2],
) -> Real {
    query.distance(pose, &**shapes[0], &**shapes[1]).expect("supports every pair").distance
}

/// Shapes intersect where their distance is zero, and the depth of a contact is the distance where that is
/// positive. Exchanging the shapes changes nothing.
#[test]
fn intersection_distance_and_contact_agree() {
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let (mut touching, mut apart, mut faults) = (0, 0, Vec::new());
    for_each_pair(|names, [shape1, shape2], dice| {
        let mut check = |is_right: bool, what: String| {
            if !is_right {
                faults.push(format!("{names:?}: {what}"));
            }
        };
        for _ in 0..POSES {
            let pose = pose(dice, 2.0);
            let distance = distance(query, &pose, [shape1, shape2]);
            let meets = |pose: &Pose, shape1: &SharedShape, shape2: &SharedShape| {
                query.intersection_test(pose, &**shape1, &**shape2).expect("supports every pair")
            };
            let intersects = meets(&pose, shape1, shape2).intersecting;
            let swapped = meets(&pose.inverse(), shape2, shape1).intersecting;
            let contact = query.contact(&pose, &**shape1, &**shape2, Real::MAX);
            let Some(contact) = contact.expect("supports every pair") else {
                check(false, format!("no contact, {distance} apart: {pose:?}"));
                continue;
            };
            let depth = -contact.dist;
            if distance > TOLERANCE {
                apart += 1;
                check(!intersects && !swapped, format!("meet {distance} apart: {pose:?}"));
                let tolerance = TOLERANCE + CURVED_FRACTION * distance;
                let is_equal = (depth + distance).abs() < tolerance;
                check(is_equal, format!("distance {distance}, depth {depth}"));
                let apart = (pose * contact.point2 - contact.point1).length();
                check((apart - distance).abs() < tolerance, format!("{apart}, not {distance}"));
            } else if depth > TOLERANCE {
                touching += 1;
                check(intersects && swapped, format!("do not meet, {depth} deep: {pose:?}"));
            }
        }
    });
    println!("{touching} poses touch, {apart} are apart");
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
    assert!(touching > 500 && apart > 500);
}

/// A cast ends where the shapes touch, and they do not touch before.
#[test]
fn casts_end_where_shapes_touch() {
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let mut faults = Vec::new();
    for_each_pair(|names, [shape1, shape2], dice| {
        // The bounding box of an own shape is cast at balls, although their distance is exact.
        let has_ball = names.contains(&"ball") || names.contains(&"compound");
        if names.contains(&"own shape") && has_ball {
            return;
        }
        let (mut hits, mut widest, mut deepest) = (0, 0.0, 0.0);
        for _ in 0..POSES {
            let target = pose(dice, 1.0);
            let path = pose(dice, 1.0).translation.normalize_or_zero() * dice.within(3.0, 12.0);
            let start = Pose::from_parts(target.translation - path, target.rotation);
            let at = |time: Real| Pose::from_parts(start.translation + path * time, start.rotation);
            if distance(query, &start, [shape1, shape2]) <= TOLERANCE {
                continue;
            }
            let options = ShapeCastOptions::with_max_time_of_impact(2.0);
            let hit = query.cast_shapes(&start, path, &**shape1, &**shape2, options);
            let hit = hit.expect("supports every pair");
            let end = hit.map_or(2.0, |hit| hit.time_of_impact);
            if hit.is_some() {
                hits += 1;
                widest = distance(query, &at(end), [shape1, shape2]).max(widest);
            }
            for k in 0..PLACES {
                let pose = at((end - 0.002) * Real::from(k) / Real::from(PLACES));
                let contact = query.contact(&pose, &**shape1, &**shape2, 0.0);
                let depth = contact.expect("supports every pair").map_or(0.0, |c| -c.dist);
                deepest = depth.max(deepest);
            }
        }
        println!("{names:?}: {hits} hits, at most {widest} early; {deepest} deep before");
        if widest > TOLERANCE || deepest > TOLERANCE {
            faults.push(format!("{names:?} end {widest} apart, {deepest} deep before"));
        }
    });
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Without rotation, the search for rotating shapes finds the time of a straight cast, to its tolerance.
#[test]
fn rotating_casts_without_rotation_are_straight_casts() {
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let mut hits = 0;
    for_each_pair(|names, [shape1, shape2], dice| {
        for _ in 0..POSES / 4 {
            let target = pose(dice, 0.5);
            let path = pose(dice, 1.0).translation.normalize_or_zero() * 6.0;
            let start = Pose::from_parts(target.translation - path, target.rotation);
            let options = ShapeCastOptions::with_max_time_of_impact(2.0);
            let straight = query.cast_shapes(&start, path, &**shape1, &**shape2, options);
            let still = NonlinearRigidMotion::constant_position(Pose::IDENTITY);
            let motion = NonlinearRigidMotion::new(start, Vector::ZERO, path, about_z(0.0));
            let turning =
                query.cast_shapes_nonlinear(&still, &**shape1, &motion, &**shape2, 0.0, 2.0, true);
            let times = [straight, turning]
                .map(|hit| hit.expect("supports every pair").map(|hit| hit.time_of_impact));
            match times {
                [Some(straight), Some(turning)] => {
                    hits += 1;
                    let pose = Pose::from_parts(start.translation + path * turning, start.rotation);
                    let early = distance(query, &pose, [shape1, shape2]);
                    let is_near = (straight - turning).abs() * 6.0 < 2.0 * TOLERANCE;
                    assert!(is_near || early < TOLERANCE, "{names:?}: {times:?}");
                }
                [None, None] => {}
                // The search counts a pass at a small distance as a touch.
                [None, Some(turning)] => {
                    let pose = Pose::from_parts(start.translation + path * turning, start.rotation);
                    let distance = distance(query, &pose, [shape1, shape2]);
                    assert!(distance < TOLERANCE, "{names:?}: {times:?}");
                }
                [Some(_), None] => panic!("{names:?} pass: {times:?} from {start:?} along {path}"),
            }
        }
    });
    println!("{hits} hits");
    assert!(hits > 500);
}

/// Sensors and queries of the world find every shape with every other.
#[test]
fn sensors_find_every_shape() {
    let solid = |shape: &SharedShape| {
        let mut world = world(60);
        world.gravity = Vector::ZERO;
        (world.insert_collider(ColliderBuilder::new(shape.clone()), None), world)
    };
    let mut met = 0;
    for_each_pair(|names, [shape1, shape2], dice| {
        let (first, mut world) = solid(shape1);
        for round in 0..4 {
            let pose = pose(dice, 1.5);
            let distance = distance(world.narrow_phase.query_dispatcher(), &pose, [shape1, shape2]);
            let deep = world
                .narrow_phase
                .query_dispatcher()
                .contact(&pose, &**shape1, &**shape2, 0.0)
                .expect("supports every pair")
                .is_some_and(|contact| contact.dist < -TOLERANCE);
            let body = RigidBodyBuilder::dynamic().pose(pose).additional_mass(1.0);
            let sensor = ColliderBuilder::new(shape2.clone()).sensor(true);
            let (body, second) = world.insert(body, sensor);
            world.step();
            let sensed = world.narrow_phase.intersection_pair(first, second) == Some(true);
            let mut found = false;
            let queries = world.query_pipeline();
            for (handle, _) in queries.intersect_shape(pose, &**shape2) {
                found |= handle == first;
            }
            met += usize::from(deep);
            assert!(!deep || (sensed && found), "{names:?}, round {round}: {sensed}, {found}");
            let apart = distance > TOLERANCE;
            assert!(!apart || !(sensed || found), "{names:?}, round {round}: {distance} apart");
            world.remove_body(body);
        }
    });
    println!("{met} sensors in something");
    assert!(met > 200);
}
