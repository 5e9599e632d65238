//! A cast has the same end from any start on its path, and in any unit of time.
//!
//! parry's search missed shapes from a distance of a hundred sizes, or hit them late by as much as their
//! size. At a speed of 10⁶ its points were up to two sizes apart.

use super::pairs::{TOLERANCE, distance, for_each_pair, pose};
use crate::suite::physics::stage::Dice;
use rapier::parry::query::QueryDispatcher;
use rapier::parry::shape::Ball;
use rapier::prelude::*;

/// Paths of each pair of shapes.
const PATHS: usize = 8;
/// Distances of the start from the target, and speeds. The cast of the first pair is compared with all casts.
const STARTS: [(Real, Real); 8] = [
    (6.0, 1.0),
    (6.0, 1.0e6),
    (6.0, 1.0e-3),
    (1.0, 1.0),
    (100.0, 1.0),
    (100.0, 7.0),
    (1000.0, 1.0),
    (1000.0, 1.0e6),
];
/// Rounding error of the path, as a fraction of the distance of the start: the documented one, for a cosine
/// between the path and the normal of a half.
const ROUNDING: Real = 64.0 * Real::EPSILON;
/// Path behind a touch on which shapes that do not only graze each other overlap visibly (m).
const BEHIND: Real = 0.05;

pub(super) fn direction(dice: &mut Dice) -> Vector {
    let mut direction = Vector::ZERO;
    (0..DIM).for_each(|axis| direction[axis] = dice.within(-1.0, 1.0));
    direction.normalize_or(Vector::X)
}

/// The second shape on a straight path through a target.
struct Path<'a> {
    shapes: [&'a SharedShape; 2],
    target: Pose,
    direction: Vector,
}

impl Path<'_> {
    /// The pose at a distance behind the target.
    fn at(&self, place: Real) -> Pose {
        Pose::from_parts(self.target.translation + self.direction * place, self.target.rotation)
    }

    /// The place of the touch, and the distance of its two points.
    fn end(&self, query: &dyn QueryDispatcher, (back, speed): (Real, Real)) -> Option<[Real; 2]> {
        let ([shape1, shape2], options) = (self.shapes, ShapeCastOptions::default());
        let (start, velocity) = (self.at(-back), self.direction * speed);
        let hit = query.cast_shapes(&start, velocity, &**shape1, &**shape2, options);
        let hit = hit.expect("supports every pair")?;
        let place = hit.time_of_impact * speed - back;
        Some([place, (self.at(place) * hit.witness2 - hit.witness1).length()])
    }

    fn depth(&self, query: &dyn QueryDispatcher, place: Real) -> Real {
        let contact = query.contact(&self.at(place), &**self.shapes[0], &**self.shapes[1], 0.0);
        contact.expect("supports every pair").map_or(0.0, |contact| -contact.dist)
    }
}

#[test]
fn casts_end_at_the_same_place_from_any_distance_at_any_speed() {
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let (mut compared, mut faults) = (0, Vec::new());
    for_each_pair(|names, shapes, dice| {
        for _ in 0..PATHS {
            let path = Path { shapes, target: pose(dice, 0.5), direction: direction(dice) };
            let begins_apart =
                |start: &&(Real, Real)| distance(query, &path.at(-start.0), shapes) > TOLERANCE;
            let first = STARTS.iter().take(1).find(begins_apart);
            let Some([near, _]) = first.and_then(|start| path.end(query, *start)) else { continue };
            // A graze may pass by rounding.
            if path.depth(query, near + BEHIND) < 2.0 * TOLERANCE {
                continue;
            }
            let is_before = |start: &&(Real, Real)| -start.0 < near && begins_apart(start);
            for start in STARTS.iter().filter(is_before) {
                compared += 1;
                let tolerance = TOLERANCE + ROUNDING * start.0;
                match path.end(query, *start) {
                    Some([end, gap]) if (end - near).abs() < tolerance && gap < tolerance => {}
                    end => faults.push(format!("{names:?} from {start:?}: {end:?}, not {near}")),
                }
            }
        }
    });
    println!("{compared} casts");
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
    assert!(compared > 3000);
}

/// Points hit segments and boxes without height on the side from which they come.
#[test]
fn points_hit_flat_shapes_from_their_side() {
    let mut dice = Dice(14);
    let end = Vector::X;
    let flat = [
        SharedShape::segment(-end, end),
        SharedShape::polyline(vec![-end, Vector::ZERO, end], None),
        crate::dim::cuboid(1.0, 0.0).build().shared_shape().clone(),
    ];
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    for (k, shape) in flat.iter().cycle().take(300).enumerate() {
        let mut path = Vector::Y * dice.within(-1.0, 1.0);
        path.x = dice.within(-1.0, 1.0);
        let target = Vector::X * dice.within(-0.9, 0.9);
        let start = Pose::from_translation(target - path);
        let options = ShapeCastOptions::default();
        let hit = query.cast_shapes(&start, path, &**shape, &Ball::new(0.0), options);
        let hit = hit.expect("supports every pair").unwrap_or_else(|| panic!("{k} passes"));
        let (time, normal) = (hit.time_of_impact, hit.normal1);
        assert!((time - 1.0).abs() * path.length() < TOLERANCE, "{k}: {time}");
        let is_against = normal.dot(path) <= 0.0 && (normal.length() - 1.0).abs() < 1.0e-3;
        assert!(is_against, "{k}: {normal} along {path}");
    }
}
