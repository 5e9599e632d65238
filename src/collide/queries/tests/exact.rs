//! Distances of points from convex hulls by exhaustion, in double precision.
//!
//! All triangles between the corners of a hull are inside the hull, and some of them are its faces. The
//! nearest point of all triangles is therefore the nearest point of the hull, whatever its faces are.

use crate::base::measure::Measure;
use crate::dim::math::Vector;
use crate::dim::shapes::measures;
use parry::shape::Shape;

/// A point or a direction. The third component is zero in 2D.
pub type Triple = [f64; 3];

pub fn triple(v: Vector) -> Triple {
    let mut all = [0.0; 3];
    all.iter_mut().zip(v.to_array()).for_each(|(to, from)| *to = f64::from(from));
    all
}

pub fn dot(a: Triple, b: Triple) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The sum of `a` and the multiple `b` `factor`.
pub fn moved(a: Triple, b: Triple, factor: f64) -> Triple {
    core::array::from_fn(|k| a[k] + b[k] * factor)
}

pub fn length(a: Triple) -> f64 {
    dot(a, a).sqrt()
}

/// The corners of a hull.
pub fn corners(hull: &dyn Shape) -> Vec<Triple> {
    let [Measure::Points(_, points)] = measures(hull.as_typed_shape())[..] else {
        panic!("is a hull")
    };
    points.iter().map(|point| triple(*point)).collect()
}

fn nearest_on_segment(point: Triple, a: Triple, b: Triple) -> Triple {
    let along = moved(b, a, -1.0);
    let fraction = dot(moved(point, a, -1.0), along) / dot(along, along).max(f64::MIN_POSITIVE);
    moved(a, along, fraction.clamp(0.0, 1.0))
}

/// The point of a triangle above which a point is, if there is one.
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

/// The point of the triangles between all corners that is nearest to a point, and its distance.
pub fn nearest(corners: &[Triple], point: Triple) -> (f64, Triple) {
    let mut best = (f64::INFINITY, point);
    let mut candidate = |place: Triple| {
        let distance = length(moved(place, point, -1.0));
        best = if distance < best.0 { (distance, place) } else { best };
    };
    for (i, a) in corners.iter().enumerate() {
        for (j, b) in corners[..i].iter().enumerate() {
            candidate(nearest_on_segment(point, *a, *b));
            let feet = corners[..j].iter().filter_map(|c| foot_on_triangle(point, [*a, *b, *c]));
            feet.for_each(&mut candidate);
        }
    }
    best
}
