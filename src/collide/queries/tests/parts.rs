//! Queries of shapes with many parts, compared with a loop over all parts.

use crate::base::random::Random;
use crate::collide::parts::Parts;
use crate::collide::queries::pair_query::PairQuery;
use crate::collide::queries::{intersection, plain};
use crate::dim::collide::samples::{self, CONVEX_KINDS, KINDS};
use crate::dim::math::{Pose, Real, Vector};
use parry::query::{Ray, ShapeCastOptions};
use parry::shape::{Cuboid, Shape, SharedShape};

/// Precision of parry's searches, which differs from frame to frame (length units).
const TOLERANCE: Real = 4.0e-3;
const ROUNDS: usize = 10;

type Part = (Pose, Box<dyn Shape>);

fn parts_of(shape: &dyn Shape) -> Vec<Part> {
    if let Some(voxels) = shape.as_voxels() {
        let filled = voxels.voxels().filter(|voxel| !voxel.state.is_empty());
        let cube = Cuboid::new(voxels.voxel_size() * 0.5);
        return filled
            .map(|voxel| (Pose::from_translation(voxel.center), cube.clone_dyn()))
            .collect();
    }
    let (parts, mut all) = (Parts::of(shape), Vec::new());
    for id in 0..parts.len() as u32 {
        parts.with_part(id, &mut |part| all.push((part.pose(), part.shape.clone_dyn())));
    }
    all
}

/// The least cost of all pairs of parts.
fn brute_force(query: PairQuery, pose12: &Pose, parts: [&[Part]; 2], limit: Real) -> Option<Real> {
    let mut least = None;
    for (pose1, shape1) in parts[0] {
        for (pose2, shape2) in parts[1] {
            let pose = pose1.inv_mul(&(*pose12 * *pose2));
            let shapes = [&**shape1, &**shape2];
            let found = plain::least(query.for_part(Some(pose1)), &pose, shapes, limit);
            least = found.map(|found| found.cost).into_iter().chain(least).min_by(Real::total_cmp);
        }
    }
    least
}

fn queries(velocity: Vector) -> [(PairQuery, Real); 4] {
    let cast = PairQuery::Cast { velocity, options: ShapeCastOptions::default() };
    let (here, anywhere) = (0.0, Real::MAX);
    [
        (PairQuery::Intersection, here),
        (PairQuery::Distance, anywhere),
        (PairQuery::Contact, anywhere),
        (cast, anywhere),
    ]
}

/// Distance of the shapes at the time of a cast, if only one of two searches has a hit there: a graze.
fn is_graze(pose12: &Pose, velocity: Vector, shapes: [&dyn Shape; 2], time: Real) -> bool {
    let pose = Pose::from_parts(pose12.translation + velocity * time, pose12.rotation);
    let distance = PairQuery::Distance.least(&pose, shapes, Real::MAX);
    let depth = PairQuery::Contact.least(&pose, shapes, 0.0).map_or(0.0, |found| -found.cost);
    distance.is_some_and(|found| found.cost < TOLERANCE) && depth < TOLERANCE
}

#[test]
fn a_query_finds_the_least_of_all_parts() {
    let mut random = Random(21);
    for kind1 in CONVEX_KINDS..KINDS {
        let mut found = [0; 4];
        for kind2 in 0..KINDS {
            for round in 0..ROUNDS {
                let shapes = [kind1, kind2].map(|kind| samples::shape(kind, &mut random, 1.0));
                let parts = shapes.each_ref().map(|shape| parts_of(&**shape));
                let reach = if round % 2 == 0 { 1.5 } else { 12.0 };
                let pose12 = samples::pose(&mut random, reach);
                let velocity = samples::vector(&mut random, 0.3)
                    - pose12.translation * random.within(0.1, 3.0);
                let shapes: [&SharedShape; 2] = [&shapes[0], &shapes[1]];
                let shapes = shapes.map(|shape| &**shape as &dyn Shape);
                for (k, (query, limit)) in queries(velocity).into_iter().enumerate() {
                    let [parts1, parts2] = parts.each_ref().map(Vec::as_slice);
                    let right = brute_force(query, &pose12, [parts1, parts2], limit);
                    let ours = query.least(&pose12, shapes, limit).map(|found| found.cost);
                    let names = [kind1, kind2];
                    match (ours, right) {
                        (Some(ours), Some(right)) => {
                            found[k] += 1;
                            let scale = if k == 3 { velocity.length() } else { 1.0 };
                            let is_equal = (ours - right).abs() * scale <= TOLERANCE;
                            let either = ours.min(right);
                            assert!(
                                is_equal || (k == 3 && is_graze(&pose12, velocity, shapes, either)),
                                "kinds {names:?}, query {k}: {ours}, not {right}, from {pose12:?}"
                            );
                        }
                        (None, None) => {}
                        (Some(time), None) | (None, Some(time)) => assert!(
                            is_graze(
                                &pose12,
                                if k == 3 { velocity } else { Vector::ZERO },
                                shapes,
                                time
                            ),
                            "kinds {names:?}, query {k}: {ours:?}, not {right:?}, from {pose12:?}"
                        ),
                    }
                }
            }
        }
        println!("kind {kind1}: {found:?} intersections, distances, contacts, casts");
        assert!(found.iter().all(|&count| count > 20), "{found:?}");
    }
}

/// Rays, with and without direction, and points: the first hit and the nearest point of all parts.
#[test]
fn rays_and_points_find_the_nearest_of_all_parts() {
    let mut random = Random(22);
    for kind in 0..KINDS {
        let (mut hits, mut inside) = (0, 0);
        for _ in 0..200 {
            let shape = samples::shape(kind, &mut random, 1.0);
            let (parts, pose) = (parts_of(&*shape), samples::pose(&mut random, 0.5));
            let origin = samples::vector(&mut random, 2.0);
            let dir = samples::vector(&mut random, 1.0) - origin;
            for ray in [Ray::new(origin, dir), Ray::new(origin, Vector::ZERO)] {
                let time = |pose: &Pose, shape: &dyn Shape| {
                    let hit = intersection(shape, pose, &ray, 9.0, true)?;
                    Some(hit.time_of_impact)
                };
                let times =
                    parts.iter().filter_map(|(place, part)| time(&(pose * *place), &**part));
                let (right, ours) = (times.min_by(Real::total_cmp), time(&pose, &*shape));
                hits += usize::from(ours.is_some());
                let is_equal = match (ours, right) {
                    (Some(ours), Some(right)) => (ours - right).abs() * dir.length() < TOLERANCE,
                    (None, None) => true,
                    // At the edge of a surface, either is right.
                    (Some(time), None) | (None, Some(time)) => {
                        let point = ray.point_at(time);
                        let beside = ray.point_at(time + TOLERANCE);
                        let near = |point| shape.distance_to_point(&pose, point, true) < TOLERANCE;
                        near(point) && !shape.contains_point(&pose, beside)
                    }
                };
                assert!(is_equal, "kind {kind}: {ours:?}, not {right:?}, by {ray:?} from {pose:?}");
            }
            let nearest = shape.project_point(&pose, origin, true);
            let distances = parts.iter().map(|(place, part)| {
                let found = part.project_point(&(pose * *place), origin, true);
                found.point.distance(origin)
            });
            let (ours, right) =
                (nearest.point.distance(origin), distances.fold(Real::INFINITY, Real::min));
            inside += usize::from(ours == 0.0);
            assert!((ours - right).abs() < TOLERANCE, "kind {kind}: {ours}, not {right}");
        }
        println!("kind {kind}: {hits} hits of 400 rays, {inside} of 200 points inside");
    }
}
