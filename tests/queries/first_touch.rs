//! Straight casts of convex shapes, compared with closed forms in double precision.
//!
//! Polytopes touch when their intervals along the last separating axis meet. The candidates for that axis are
//! normal to two edges. Every line between two corners counts as an edge here: further axes change nothing.
//! Round segments touch when the distance of their axes is the sum of their radii. That distance is convex
//! along a path, so a bisection finds the time. Balls stop where their distance from a hull is their radius.

use super::pairs::pose;
use super::paths::direction;
use crate::dim::queries::{axes, corner_shapes, hull_corners};
use crate::dim::shapes::flat_clouds;
use crate::dim::{about_z, cuboid, vec};
use crate::suite::physics::stage::Dice;
use rapier::parry::query::ShapeCastHit;
use rapier::prelude::*;

/// A point or direction.
type Triple = [f64; DIM];

/// Paths of each pair of shapes.
const PATHS: usize = 30;
/// Distances of the start from the target (m), and speeds. Most shapes have a size of a metre.
const STARTS: [(Real, Real); 6] =
    [(3.0, 1.0), (3.0, 1.0e-3), (3.0, 1.0e6), (30.0, 1.0), (1000.0, 1.0), (1000.0, 1.0e6)];
/// Documented precision of casts, as a fraction of the size.
const PRECISION: f64 = 2.0e-6;
/// Paths on which shapes overlap for a shorter distance (m) only graze each other.
const GRAZE: f64 = 0.02;

fn triple(v: Vector) -> Triple {
    v.to_array().map(f64::from)
}

fn dot(a: Triple, b: Triple) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn moved(a: Triple, direction: Triple, way: f64) -> Triple {
    core::array::from_fn(|k| a[k] + direction[k] * way)
}

/// The interval of a set of points along an axis.
fn interval(points: &[Triple], axis: Triple) -> [f64; 2] {
    points
        .iter()
        .map(|&point| dot(point, axis))
        .fold([f64::MAX, f64::MIN], |[low, high], x| [low.min(x), high.max(x)])
}

/// The paths at which the hull of the second points, which moves, enters and leaves that of the first, and
/// the cosine of the direction and the axis at the entry. The entry is after the exit if they never meet.
fn span(corners: [&[Triple]; 2], direction: Triple) -> ([f64; 2], f64) {
    let edges = corners
        .into_iter()
        .flat_map(|set| set.iter().flat_map(move |&p| set.iter().map(move |&q| moved(p, q, -1.0))));
    let (mut enter, mut leave, mut cosine) = (f64::MIN, f64::MAX, 1.0);
    for axis in axes(&edges.collect::<Vec<_>>()) {
        let [[low1, high1], [low2, high2]] = corners.map(|set| interval(set, axis));
        let speed = dot(axis, direction);
        let [mut first, mut last] = [(low1 - high2) / speed, (high1 - low2) / speed];
        if speed < 0.0 {
            (first, last) = (last, first);
        }
        if speed.abs() < 1.0e-12 {
            let overlap = high1 > low2 && high2 > low1;
            (first, last) = if overlap { (f64::MIN, f64::MAX) } else { (f64::MAX, f64::MIN) };
        }
        if first > enter {
            (enter, cosine) = (first, speed.abs());
        }
        leave = leave.min(last);
    }
    ([enter, leave], cosine)
}

/// The cast of the second shape from a distance behind the target.
fn cast(
    shapes: [&SharedShape; 2],
    target: &Pose,
    direction: Vector,
    (back, speed): (Real, Real),
) -> Option<ShapeCastHit> {
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let start = Pose::from_parts(target.translation - direction * back, target.rotation);
    let options = ShapeCastOptions::default();
    let hit = query.cast_shapes(&start, direction * speed, &**shapes[0], &**shapes[1], options);
    hit.expect("supports every pair")
}

/// A pose and a direction in the plane of x and y. Most shapes are symmetric about it: several corners are on
/// the path, and the smallest simplex around it is not unique.
fn in_plane(dice: &mut Dice) -> (Pose, Vector) {
    let mut within = |bound: Real| dice.within(-bound, bound);
    let body = RigidBodyBuilder::fixed().translation(vec(within(1.2), within(1.2)));
    let target = *body.rotation(about_z(within(3.0))).build().position();
    let angle = within(3.0);
    (target, vec(angle.cos(), angle.sin()))
}

/// Largest error of the path (m) for a start: the precision, and the rounding error of the positions.
fn tolerance((back, _): (Real, Real), cosine: f64) -> f64 {
    let rounding = 32.0 * f64::from(Real::EPSILON) * (2.0 + f64::from(back));
    PRECISION + rounding / cosine
}

#[test]
fn polytopes_touch_at_the_last_separating_axis() {
    let shapes = corner_shapes();
    let (mut hits, mut misses, mut faults) = (0, 0, Vec::new());
    for (i, (name1, shape1, corners1)) in shapes.iter().enumerate() {
        for (j, (name2, shape2, corners2)) in shapes.iter().enumerate() {
            let mut dice = Dice((100 * i + j) as u64);
            // Flat shapes in one plane have no separating axis.
            let are_solid =
                [shape1, shape2].iter().all(|shape| shape.mass_properties(1.0).mass() > 0.0);
            for path in 0..if are_solid { 2 * PATHS } else { PATHS } {
                let (target, direction) = if path < PATHS {
                    (pose(&mut dice, 1.2), direction(&mut dice))
                } else {
                    in_plane(&mut dice)
                };
                let still: Vec<_> = corners1.iter().copied().map(triple).collect();
                let moving: Vec<_> = corners2.iter().map(|&at| triple(target * at)).collect();
                let ([enter, leave], cosine) = span([&still, &moving], triple(direction));
                if (leave - enter).abs() < GRAZE {
                    continue;
                }
                // Some paths enter before the start.
                let is_before = |start: &(Real, Real)| enter > leave || -f64::from(start.0) < enter;
                for start in STARTS.into_iter().filter(is_before) {
                    let hit = cast([shape1, shape2], &target, direction, start);
                    let mut check = |is_right: bool, what: &str| {
                        if !is_right {
                            let path = [enter, leave, cosine];
                            faults.push(format!(
                                "{name1}, {name2} from {start:?}: {what} {path:?} {hit:?}"
                            ));
                        }
                    };
                    let Some(hit) = hit.filter(|_| enter < leave) else {
                        misses += 1;
                        check(hit.is_none() && enter > leave, "hit");
                        continue;
                    };
                    hits += 1;
                    let tolerance = tolerance(start, cosine);
                    let (back, speed) = (f64::from(start.0), f64::from(start.1));
                    let path = f64::from(hit.time_of_impact) * speed - back;
                    check((path - enter).abs() < tolerance, "place");
                    let normal = triple(hit.normal1);
                    let [point1, point2] = [hit.witness1, target * hit.witness2].map(triple);
                    let point2 = moved(point2, triple(direction), path);
                    check(
                        moved(point1, point2, -1.0).iter().all(|x| x.abs() < tolerance),
                        "points",
                    );
                    let [_, high] = interval(&still, normal);
                    let [low, _] = interval(&moving, normal);
                    let low = low + path * dot(normal, triple(direction));
                    let touches =
                        [high, low].iter().all(|at| (at - dot(point1, normal)).abs() < tolerance);
                    check(touches, "normal");
                }
            }
        }
    }
    println!("{hits} hits, {misses} misses");
    assert!(faults.is_empty(), "{} faults: {:#?}", faults.len(), &faults[..faults.len().min(20)]);
    assert!(hits > 1500 && misses > 300);
}

/// The distance of a point from a segment.
fn distance_of_point(point: Triple, [a, b]: [Triple; 2]) -> f64 {
    let (along, from) = (moved(b, a, -1.0), moved(point, a, -1.0));
    let fraction = (dot(from, along) / dot(along, along)).clamp(0.0, 1.0);
    let off = moved(from, along, -fraction);
    dot(off, off).sqrt()
}

/// The place of the minimum of a convex function between two places.
fn minimum(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let [a, b] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
        if f(a) < f(b) { high = b } else { low = a }
    }
    0.5 * (low + high)
}

/// The distance of two segments.
fn distance_of_segments(segment1: [Triple; 2], [a, b]: [Triple; 2]) -> f64 {
    let along = moved(b, a, -1.0);
    let at = |fraction: f64| distance_of_point(moved(a, along, fraction), segment1);
    at(minimum(0.0, 1.0, at))
}

#[test]
fn round_segments_touch_at_the_sum_of_their_radii() {
    let ends = [Vector::X * 0.5, Vector::Y * -0.3];
    let shapes = [0.3, 0.05, 0.0].map(|radius| {
        let shape = match radius {
            0.0 => SharedShape::segment(ends[0], ends[1]),
            _ => SharedShape::capsule(ends[0], ends[1], radius),
        };
        (f64::from(radius), shape)
    });
    let (mut hits, mut dice) = (0, Dice(3));
    let pairs = shapes.iter().flat_map(|one| shapes.iter().map(move |other| (one, other)));
    for ((radius1, shape1), (radius2, shape2)) in pairs.filter(|(a, b)| a.0 + b.0 > 0.0) {
        for _ in 0..12 {
            let (target, direction) = (pose(&mut dice, 0.4), direction(&mut dice));
            let still = ends.map(triple);
            let moving = ends.map(|end| triple(target * end));
            let apart = |path: f64| {
                let moved = moving.map(|end| moved(end, triple(direction), path));
                distance_of_segments(still, moved) - radius1 - radius2
            };
            let nearest = minimum(-3.0, 3.0, apart);
            if apart(nearest) > -0.01 {
                continue;
            }
            let (mut before, mut behind) = (-3.0, nearest);
            for _ in 0..60 {
                let middle = 0.5 * (before + behind);
                if apart(middle) > 0.0 { before = middle } else { behind = middle }
            }
            let cosine = (apart(before) - apart(before + 1.0e-5)) / 1.0e-5;
            for start in STARTS {
                let hit = cast([shape1, shape2], &target, direction, start);
                let time = hit.map_or(f64::NAN, |hit| f64::from(hit.time_of_impact));
                let path = time * f64::from(start.1) - f64::from(start.0);
                let tolerance = tolerance(start, cosine);
                assert!((path - before).abs() < tolerance, "{path}, not {before} from {start:?}");
                hits += 1;
            }
        }
    }
    println!("{hits} hits");
    assert!(hits > 200);
}

/// The foot of a point's perpendicular, if it lies in a triangle.
fn foot_on_triangle(point: Triple, [a, b, c]: [Triple; 3]) -> Option<Triple> {
    let [u, v, w] = [b, c, point].map(|corner| moved(corner, a, -1.0));
    let (uu, uv, vv, uw, vw) = (dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w));
    let determinant = uu * vv - uv * uv;
    // The edges of such a sliver are as near as the sliver.
    if determinant <= 1.0e-14 * uu * vv {
        return None;
    }
    let (s, t) = ((uw * vv - vw * uv) / determinant, (vw * uu - uw * uv) / determinant);
    let is_over = s >= 0.0 && t >= 0.0 && s + t <= 1.0;
    is_over.then(|| moved(moved(a, u, s), v, t))
}

/// The distance of a point outside from the hull of some corners. All triangles between corners are inside
/// the hull, and some of them are its faces.
fn distance_of_hull(point: Triple, corners: &[Triple]) -> f64 {
    let mut distance = f64::MAX;
    for (i, &a) in corners.iter().enumerate() {
        for (j, &b) in corners[..i].iter().enumerate() {
            distance = distance.min(distance_of_point(point, [a, b]));
            for foot in corners[..j].iter().filter_map(|&c| foot_on_triangle(point, [a, b, c])) {
                let off = moved(foot, point, -1.0);
                distance = distance.min(dot(off, off).sqrt());
            }
        }
    }
    distance
}

/// The hull of a slab of random points, two metres wide and oblique in the frame of the hull.
fn thin_hull(dice: &mut Dice, thickness: Real) -> Option<SharedShape> {
    let slopes: [Real; DIM] = core::array::from_fn(|_| dice.within(-1.0, 1.0));
    let count = dice.within(4.0, 13.0) as usize;
    let point = |_| {
        let mut point = Vector::ZERO;
        for axis in 0..DIM - 1 {
            point[axis] = dice.within(-1.0, 1.0);
            point[DIM - 1] += slopes[axis] * point[axis];
        }
        point[DIM - 1] += dice.within(-thickness, thickness);
        point
    };
    let hull = ColliderBuilder::try_convex_hull(&(0..count).map(point).collect::<Vec<_>>()).ok()?;
    Some(hull.build().shared_shape().clone())
}

/// Balls stop at every corner of a thin hull, also at those that parry's faces hide: it merges triangles that
/// are nearly in a plane, and a corner inside such a face is above it.
#[test]
fn balls_stop_at_thin_hulls() {
    let (mut dice, mut hits, mut faults) = (Dice(48), 0, Vec::new());
    for cast_number in 0..6000 {
        let thickness = [5.0e-3, 1.0e-2][cast_number % 2];
        let Some(hull) = thin_hull(&mut dice, thickness) else { continue };
        // The flattest are plates with a layer.
        let Some(corners) = hull_corners(&hull) else { continue };
        let (radius, path) = (dice.within(0.02, 0.5), direction(&mut dice));
        // The target overlaps a corner, so that the ball must stop before.
        let corner = corners[dice.within(0.0, corners.len() as Real) as usize % corners.len()];
        let aside = direction(&mut dice) * (radius * dice.within(0.0, 0.7));
        let (target, start) = (corner + aside, (dice.within(8.0, 10.0), 1.0));
        let ball = SharedShape::ball(radius);
        let hit = cast([&hull, &ball], &Pose::from_translation(target), path, start);
        let hit = hit.unwrap_or_else(|| panic!("cast {cast_number} passes a hull"));
        let center = moved(triple(target), triple(path), f64::from(hit.time_of_impact - start.0));
        let corners: Vec<_> = corners.iter().copied().map(triple).collect();
        let (normal, radius) = (triple(hit.normal1), f64::from(radius));
        let [_, high] = interval(&corners, normal);
        let gap = distance_of_hull(center, &corners) - radius;
        // The normal of a side as high as the hull is thick has the rounding error over that height.
        let tolerance = tolerance(start, 1.0) + f64::from(Real::EPSILON / thickness);
        // Beside a corner, the error of the place turns the normal.
        let depth = high - (dot(center, normal) - radius);
        if gap.abs() > tolerance || depth.abs() > 0.01 {
            faults
                .push(format!("cast {cast_number}, {thickness} thick: {gap} apart, {depth} deep"));
        }
        hits += 1;
    }
    // In double precision, five of parry's hulls have corners above faces (guide/queries.md).
    let known = if DIM == 3 && size_of::<Real>() == 8 { 5 } else { 0 };
    assert!(faults.len() <= known, "{faults:#?}");
    assert!(hits > 2000, "{hits}");
}

/// Points that aim at a segment, a plate or a triangle hit it, from any distance.
#[test]
fn points_hit_flat_shapes_at_which_they_aim() {
    let (mut dice, mut hits) = (Dice(14), 0);
    let simple = corner_shapes().into_iter();
    let simple = simple.map(|(name, shape, corners)| (name.to_owned(), shape, corners));
    let hulls = flat_clouds().into_iter().filter_map(|(name, corners)| {
        let hull = ColliderBuilder::try_convex_hull(&corners).ok()?;
        Some((name, hull.build().shared_shape().clone(), corners))
    });
    for (name, shape, corners) in simple.chain(hulls) {
        for _ in 0..40 {
            let weights: Vec<_> = corners.iter().map(|_| dice.within(0.05, 1.0)).collect();
            let sum: Real = weights.iter().sum();
            let inside = corners.iter().zip(&weights).map(|(&at, weight)| at * (weight / sum));
            let (target, path) = (inside.sum::<Vector>(), direction(&mut dice));
            for start in STARTS {
                let point = SharedShape::ball(0.0);
                let at = Pose::from_translation(target);
                let hit = cast([&shape, &point], &at, path, start);
                let hit = hit.unwrap_or_else(|| panic!("a point passes a {name} from {start:?}"));
                let end = hit.time_of_impact * start.1 - start.0;
                let cosine = -f64::from(hit.normal1.dot(path));
                assert!(cosine > 0.0, "{name}: {} along {path}", hit.normal1);
                let tolerance = tolerance(start, cosine);
                assert!(f64::from(end) < tolerance, "{name} from {start:?}: {end}, {tolerance}");
                hits += 1;
            }
        }
    }
    assert!(hits > 1000);
}

/// Shapes that have grazed each other before the start move apart.
#[test]
fn shapes_that_have_passed_each_other_do_not_touch() {
    let shapes = [
        SharedShape::ball(0.5),
        cuboid(0.5, 0.5).build().shared_shape().clone(),
        SharedShape::capsule_y(0.1, 0.4),
    ];
    for pair in shapes.iter().flat_map(|a| shapes.iter().map(move |b| [a, b])) {
        for x in [2.5, 50.0, 1000.0] {
            for ulps in -40..=40 {
                let target = Pose::from_translation(vec(x, 1.0 + ulps as Real * Real::EPSILON));
                let hit = cast(pair, &target, Vector::X, (0.0, 1.0));
                assert!(hit.is_none(), "{x}, {ulps}: {hit:?}");
            }
        }
    }
}
