//! Casts of balls at hulls up to a thousand times as long as they are thick, compared with exact distances.
//!
//! parry merges triangles of such a hull into faces, and corners inside a merged face are above its plane. A
//! formula with the planes of all faces let balls pass through these corners.

use super::exact::{Triple, corners, dot, length, moved, nearest, triple};
use crate::base::random::Random;
use crate::collide::queries::Dispatcher;
use crate::dim::collide::samples;
use crate::dim::hull::convex_hull;
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::query::{QueryDispatcher, ShapeCastHit, ShapeCastOptions};
use parry::shape::{Ball, Shape, SharedShape};

/// Number of casts.
const CASTS: usize = 4000;
/// Longest path (length units).
const PATH: f64 = 8.0;
/// Largest error (length units) of the touch, for hulls of a metre from a few metres away.
const ERROR_MAX: f64 = 3.0e-6 + 256.0 * Real::EPSILON as f64;
/// Largest difference of the normals. Iterative casts have the root of the error above at the smallest ball.
const NORMAL_ERROR_MAX: f64 = 0.03;

/// A slab of random points, a metre wide, oblique in the frame of the hull.
fn thin_hull(random: &mut Random, thickness: f64) -> Option<SharedShape> {
    let slopes = samples::vector(random, 1.0);
    let points: Vec<Vector> = (0..4 + random.below(9))
        .map(|_| {
            let mut point = samples::vector(random, 1.0);
            point[DIM - 1] = random.within(-thickness, thickness);
            for axis in 0..DIM - 1 {
                point[DIM - 1] += slopes[axis] * point[axis];
            }
            point
        })
        .collect();
    convex_hull(&points).map(SharedShape::new)
}

/// A cast of a ball along a straight path.
struct Case {
    corners: Vec<Triple>,
    origin: Triple,
    /// Unit vector.
    direction: Triple,
    radius: f64,
}

impl Case {
    fn at(&self, path: f64) -> (f64, Triple) {
        let center = moved(self.origin, self.direction, path);
        let (distance, place) = nearest(&self.corners, center);
        (distance - self.radius, moved(center, place, -1.0))
    }

    fn gap(&self, path: f64) -> f64 {
        self.at(path).0
    }

    /// The path to the nearest approach. The distance from a convex shape is convex along a line.
    fn nearest_approach(&self) -> f64 {
        let [mut low, mut high] = [0.0, PATH];
        for _ in 0..80 {
            let [a, b] = [low + (high - low) * 0.382, low + (high - low) * 0.618];
            if self.gap(a) < self.gap(b) { high = b } else { low = a }
        }
        low
    }

    /// The error of a result, if there is one that matters.
    fn fault(&self, hit: Option<ShapeCastHit>) -> Option<String> {
        let Some(hit) = hit else {
            let nearest = self.gap(self.nearest_approach());
            return (nearest < -ERROR_MAX).then(|| format!("missed by a gap of {nearest}"));
        };
        let path = f64::from(hit.time_of_impact);
        let (gap, outward) = self.at(path);
        // Along a slanting path the bounds of the touch are farther apart.
        let outward = moved([0.0; 3], outward, 1.0 / length(outward));
        let cosine = -dot(outward, self.direction);
        if gap.abs() > ERROR_MAX {
            return Some(format!("touches at a gap of {gap}, {cosine} along the normal"));
        }
        let turned = length(moved(triple(hit.normal2), outward, -1.0));
        (turned > NORMAL_ERROR_MAX).then(|| format!("the normal is off by {turned}"))
    }
}

#[test]
fn balls_stop_at_thin_hulls() {
    let (mut random, mut hits, mut faults) = (Random(48), 0, Vec::new());
    for cast in 0..CASTS {
        let thickness = [1.0e-3, 1.0e-2][cast % 2];
        let Some(hull) = thin_hull(&mut random, thickness) else { continue };
        let radius = random.within(0.02, 0.5);
        // At a corner, or beside one.
        let all = corners(&*hull);
        let corner = all[random.below(all.len())];
        let reach = [0.0, 0.1, 0.7][random.below(3)];
        let target = Vector::from_array(core::array::from_fn(|axis| corner[axis] as Real))
            + samples::vector(&mut random, reach);
        let direction = samples::vector(&mut random, 1.0).normalize_or(Vector::X);
        let origin = target - direction * random.within(3.0, 5.0);
        let case = Case {
            corners: all,
            origin: triple(origin),
            direction: triple(direction),
            radius: f64::from(radius),
        };
        let options =
            ShapeCastOptions { max_time_of_impact: PATH as Real, ..ShapeCastOptions::default() };
        let pose21 = Pose::from_translation(-origin);
        let shapes: [&dyn Shape; 2] = [&Ball::new(radius), &*hull];
        let hit = Dispatcher.cast_shapes(&pose21, -direction, shapes[0], shapes[1], options);
        let hit = hit.expect("such casts exist");
        hits += usize::from(hit.is_some());
        faults.extend(case.fault(hit).map(|fault| format!("{cast}, {thickness} thick: {fault}")));
    }
    println!("{hits} hits, {} faults: {faults:#?}", faults.len());
    assert!(faults.is_empty() && hits > CASTS / 4);
}
