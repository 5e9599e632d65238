//! Tests of formulas: the shapes touch at the computed time, and not before.

mod parts;

use super::{Dispatcher, intersection, time_of_impact};
use crate::base::random::Random;
use crate::dim::collide::samples;
use crate::dim::facets::Facets;
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::query::{
    DefaultQueryDispatcher, QueryDispatcher, Ray, ShapeCastHit, ShapeCastOptions, ShapeCastStatus,
};
use parry::shape::{Ball, Shape, TypedShape};

/// Precision of parry's closest-point search, between shapes of size 1 up to 10 away (length units).
const TOLERANCE: Real = 4.0e-3;
/// Sample times along a path.
const MOMENTS: usize = 40;

fn direction(random: &mut Random) -> Vector {
    let mut dir = samples::vector(random, 2.0);
    if random.below(4) == 0 {
        dir[random.below(DIM)] = 0.0;
    }
    if dir == Vector::ZERO { Vector::X } else { dir }
}

/// A path towards the neighbourhood of the origin.
fn random_path(random: &mut Random) -> (Vector, Vector) {
    let (target, dir) = (samples::vector(random, 1.5), direction(random));
    (target - dir * random.within(0.5, 4.0), dir)
}

/// Depth (length units) of a point inside a shape; zero outside.
fn depth(shape: &dyn Shape, pose: &Pose, point: Vector) -> Real {
    if !shape.contains_point(pose, point) {
        return 0.0;
    }
    shape.project_point(pose, point, false).point.distance(point)
}

fn has_ray_formula(shape: &dyn Shape) -> bool {
    let typed = shape.as_typed_shape();
    matches!(typed, TypedShape::Ball(_) | TypedShape::Cuboid(_) | TypedShape::Capsule(_))
        || Facets::of(typed).is_some_and(|(facets, layer)| layer == 0.0 && !facets.is_flat())
}

#[test]
fn rays_hit_surfaces_and_nothing_before() {
    let (mut random, mut hits, mut corners) = (Random(3), 0, 0);
    for round in 0..9000 {
        let shape = samples::shape(round % samples::CONVEX_KINDS, &mut random, 1.0);
        if !has_ray_formula(&*shape) {
            continue;
        }
        let pose = samples::pose(&mut random, 0.5);
        let (origin, dir) = random_path(&mut random);
        let (ray, limit) = (Ray::new(origin, dir), random.within(0.0, 8.0));
        let found = time_of_impact(&*shape, &pose, &ray, limit, true);
        let with_normal = intersection(&*shape, &pose, &ray, limit, true);
        let times = [found, with_normal.map(|hit| hit.time_of_impact)];
        let until = match times {
            [None, None] => limit,
            [Some(time), Some(other)] => {
                assert!((time - other).abs() <= TOLERANCE, "{time} and {other}");
                if time == 0.0 {
                    assert!(shape.distance_to_point(&pose, origin, true) <= TOLERANCE);
                    continue;
                }
                let normal = with_normal.map_or(Vector::ZERO, |hit| hit.normal);
                let sides = [normal, -normal]
                    .map(|side| shape.contains_point(&pose, ray.point_at(time) + side * TOLERANCE));
                assert!(!sides[0], "round {round}: it was inside before {time}");
                // Behind a sharp corner is outside, too.
                corners += usize::from(!sides[1]);
                time
            }
            _ => panic!("round {round}: {times:?}, with and without a normal"),
        };
        for moment in 0..MOMENTS {
            let point = ray.point_at(until * moment as Real / MOMENTS as Real);
            let depth = depth(&*shape, &pose, point);
            assert!(depth <= TOLERANCE, "round {round}: {depth} deep inside unnoticed");
        }
        let Some(hit) = with_normal else { continue };
        hits += 1;
        assert!((hit.normal.length() - 1.0).abs() < 1.0e-3 && hit.normal.dot(dir) <= 1.0e-3);
    }
    assert!(hits > 500 && corners <= hits / 50, "{hits} hits, {corners} of them at corners");
}

#[test]
fn rays_leave_hollow_shapes_as_in_parry() {
    let mut random = Random(4);
    for kind in [0, 1, 3, samples::HULL] {
        for round in 0..300 {
            let shape = samples::shape(kind, &mut random, 1.0);
            let pose = samples::pose(&mut random, 0.5);
            let inside = pose * shape.mass_properties(1.0).local_com;
            let ray =
                Ray::new(inside, direction(&mut random).normalize() * random.within(0.1, 9.0));
            let hit = intersection(&*shape, &pose, &ray, 100.0, false).expect("it has a wall");
            let wall = ray.point_at(hit.time_of_impact);
            assert!(!shape.contains_point(&pose, wall - hit.normal * TOLERANCE), "kind {kind}");
            let within = ray.point_at(0.99 * hit.time_of_impact);
            assert!(shape.contains_point(&pose, within), "kind {kind}, round {round}: {within}");
            assert!(hit.normal.dot(ray.dir) < 0.0, "{} points outward", hit.normal);
            let time = time_of_impact(&*shape, &pose, &ray, 100.0, false);
            assert_eq!(time, Some(hit.time_of_impact));
            let before = 0.9 * hit.time_of_impact;
            assert_eq!(time_of_impact(&*shape, &pose, &ray, before, false), None);
        }
    }
}

/// The error is that of the coordinates: two roundings of the distance.
#[test]
fn rays_from_far_away_keep_their_digits() {
    let ball = Ball::new(0.5);
    for distance in [1.0e2, 1.0e4, 1.0e6] {
        for (aside, chord) in [(0.0, 0.5), (0.3, 0.4), (0.48, 0.14)] {
            for speed in [0.01, 1.0, 300.0] {
                let ray = Ray::new(Vector::Y * aside - Vector::X * distance, Vector::X * speed);
                let time = time_of_impact(&ball, &Pose::IDENTITY, &ray, Real::MAX, true);
                let error = (time.expect("it hits") * speed - (distance - chord)).abs();
                // Roots near the rim have the square root of the accuracy of their arguments.
                let tolerance = 4.0 * Real::EPSILON * distance + 1.0e-5;
                assert!(error <= tolerance, "{error} from {distance} at {speed}");
            }
        }
        // Directions with squares outside the range of numbers may lose a hit, but have no false hit.
        for speed in [1.0, Real::MAX.sqrt() * 10.0, Real::MIN_POSITIVE.sqrt()] {
            let beside = Ray::new(Vector::Y * 0.51 - Vector::X * distance, Vector::X * speed);
            assert_eq!(time_of_impact(&ball, &Pose::IDENTITY, &beside, Real::MAX, true), None);
        }
    }
}

fn distance(pose12: &Pose, shape1: &dyn Shape, shape2: &dyn Shape) -> Real {
    let ((core1, layer1), (core2, layer2)) = (core(shape1), core(shape2));
    let found = DefaultQueryDispatcher.distance(pose12, core1, core2);
    found.expect("parry computes the distance of convex shapes").distance - layer1 - layer2
}

/// parry's search has tolerances near round surfaces, so it is applied to their cores.
fn core(shape: &dyn Shape) -> (&dyn Shape, Real) {
    match shape.as_typed_shape() {
        TypedShape::RoundCuboid(round) => (&round.inner_shape, round.border_radius),
        _ => (shape, 0.0),
    }
}

fn has_cast_formula(shape: &dyn Shape) -> bool {
    let typed = shape.as_typed_shape();
    matches!(typed, TypedShape::Ball(_) | TypedShape::Cuboid(_) | TypedShape::RoundCuboid(_))
        || matches!(typed, TypedShape::Capsule(_) | TypedShape::Segment(_))
        || Facets::of(typed).is_some()
}

/// One cast of a ball at a shape, or the reverse: the result is correct for the shapes at that time.
fn check_cast(kind: usize, random: &mut Random) -> bool {
    let shape = samples::shape(kind, random, 1.0);
    if !has_cast_formula(&*shape) {
        return false;
    }
    let ball = Ball::new(random.within(0.01, 0.8));
    let (origin, velocity) = random_path(random);
    let pose12 = Pose::from_parts(origin, samples::rotation(random));
    let (first, second): (&dyn Shape, &dyn Shape) =
        if random.below(2) == 0 { (&ball, &*shape) } else { (&*shape, &ball) };
    let options = ShapeCastOptions {
        max_time_of_impact: random.within(0.0, 8.0),
        target_distance: [0.0, 0.2][random.below(2)],
        ..ShapeCastOptions::default()
    };
    let hit = Dispatcher.cast_shapes(&pose12, velocity, first, second, options);
    let hit = hit.expect("such casts exist");
    if let Some(hit) = hit.filter(|hit| hit.time_of_impact == 0.0) {
        check_start(kind, &pose12, [first, second], &hit, options.target_distance);
        return false;
    }
    let until = hit.map_or(options.max_time_of_impact, |hit| hit.time_of_impact);
    let at = |time: Real| Pose::from_parts(pose12.translation + velocity * time, pose12.rotation);
    for moment in 0..MOMENTS {
        let pose = at(until * moment as Real / MOMENTS as Real);
        let distance = distance(&pose, first, second);
        assert!(
            distance >= options.target_distance - TOLERANCE,
            "kind {kind}: as near as {distance}"
        );
    }
    let Some(hit) = hit else { return false };
    let pose = at(hit.time_of_impact);
    let gap = distance(&pose, first, second) - options.target_distance;
    assert!(gap.abs() <= TOLERANCE, "kind {kind}: {gap} too far for a touch");
    let opposite = hit.normal1 + pose.rotation * hit.normal2;
    assert!(opposite.length() <= TOLERANCE && (hit.normal1.length() - 1.0).abs() <= TOLERANCE);
    assert!(hit.normal1.dot(velocity) <= TOLERANCE, "it goes away");
    let apart = pose * hit.witness2 - hit.witness1 - hit.normal1 * options.target_distance;
    assert!(apart.length() <= 2.0 * TOLERANCE, "kind {kind}: witnesses are {apart} apart");
    true
}

/// Casts of shapes that begin within each other: the separation is reported.
fn check_start(
    kind: usize,
    pose12: &Pose,
    [first, second]: [&dyn Shape; 2],
    hit: &ShapeCastHit,
    target_distance: Real,
) {
    let gap = distance(pose12, first, second);
    assert!(gap <= target_distance + TOLERANCE, "kind {kind}: {gap} apart");
    assert_eq!(hit.status, ShapeCastStatus::PenetratingOrWithinTargetDist);
    // Along the normal, from witness to witness, and no farther.
    let depth = (hit.witness1 - *pose12 * hit.witness2).dot(hit.normal1);
    let apart = pose12.translation + hit.normal1 * depth;
    let gap = distance(&Pose::from_parts(apart, pose12.rotation), first, second);
    assert!(gap <= TOLERANCE, "kind {kind}: {gap} too far out of each other");
    let out = pose12.translation + hit.normal1 * (depth + 4.0 * TOLERANCE);
    let gap = distance(&Pose::from_parts(out, pose12.rotation), first, second);
    assert!(gap > 0.0, "kind {kind}: still in each other at depth {depth}");
}

#[test]
fn balls_stop_where_they_touch() {
    let (mut random, mut hits) = (Random(6), 0);
    for kind in 0..samples::CONVEX_KINDS {
        hits += (0..1500).filter(|_| check_cast(kind, &mut random)).count();
    }
    assert!(hits > 1500, "{hits} hits");
}
