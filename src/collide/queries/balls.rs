//! Casts of balls.
//!
//! A moving ball is a moving point against a shape that is enlarged by a layer.

use super::layer::{Meeting, Touch};
use super::plain::status_of;
use super::rounded::{enter_capsule, nearest_on_segment};
use super::{cuboid, hull};
use crate::base::parry_version::shape_cast_hit;
use crate::dim::facets::Facets;
use crate::dim::math::{Pose, Real, Vector};
use parry::query::{ShapeCastHit, ShapeCastOptions};
use parry::shape::{Ball, Shape, TypedShape};

/// The result of the formulas of a cast.
pub(super) enum Cast {
    Known(Option<ShapeCastHit>),
    /// There is no formula.
    Unclear,
}

/// The cast of two shapes of which at least one is a ball. The second moves at a velocity relative to the
/// first.
pub(super) fn cast_of_ball(
    pose12: &Pose,
    velocity12: Vector,
    [shape1, shape2]: [&dyn Shape; 2],
    options: &ShapeCastOptions,
) -> Cast {
    match (shape1.as_ball(), shape2.as_ball()) {
        (_, Some(ball)) => ball_second(pose12, velocity12, shape1, ball, options),
        (Some(ball), None) => ball_first(pose12, velocity12, ball, shape2, options),
        (None, None) => Cast::Unclear,
    }
}

/// A moving ball as the first shape, in the frame of the second.
fn ball_first(
    pose12: &Pose,
    velocity12: Vector,
    ball: &Ball,
    shape: &dyn Shape,
    options: &ShapeCastOptions,
) -> Cast {
    let origin = pose12.inverse_transform_point(Vector::ZERO);
    let dir = pose12.rotation.inverse() * -velocity12;
    meet(origin, dir, ball, shape, options, |touch| {
        let normal1 = pose12.rotation * -touch.normal;
        hit(touch.time, [normal1, touch.normal], [normal1 * ball.radius, touch.core])
    })
}

/// A moving ball as the second shape, in the frame of the first.
fn ball_second(
    pose12: &Pose,
    velocity12: Vector,
    shape: &dyn Shape,
    ball: &Ball,
    options: &ShapeCastOptions,
) -> Cast {
    meet(pose12.translation, velocity12, ball, shape, options, |touch| {
        let normal2 = pose12.rotation.inverse() * -touch.normal;
        hit(touch.time, [touch.normal, normal2], [touch.core, normal2 * ball.radius])
    })
}

fn hit(time: Real, normals: [Vector; 2], witnesses: [Vector; 2]) -> ShapeCastHit {
    shape_cast_hit(time, witnesses, normals, status_of(time), [0; 2])
}

/// A ball that moves along `dir`, in the frame of the shape. The touch that `to_hit` gets has the point of
/// the shape's surface for its core.
fn meet(
    origin: Vector,
    dir: Vector,
    ball: &Ball,
    shape: &dyn Shape,
    options: &ShapeCastOptions,
    to_hit: impl FnOnce(Touch) -> ShapeCastHit,
) -> Cast {
    let (meeting, layer) = enter_layer(origin, dir, ball.radius + options.target_distance, shape);
    match meeting {
        Meeting::Never => Cast::Known(None),
        Meeting::At(Touch { time, normal, core }) => {
            // A shape that begins inside may leave, but not go deeper.
            let goes_out = time == 0.0 && !options.stop_at_penetration && normal.dot(dir) >= 0.0;
            if goes_out || time > options.max_time_of_impact {
                return Cast::Known(None);
            }
            Cast::Known(Some(to_hit(Touch { time, normal, core: core + normal * layer })))
        }
        Meeting::Unclear => Cast::Unclear,
    }
}

/// Returns the time at which a point comes within `distance` of a shape, and the thickness of the shape's
/// layer around its core.
fn enter_layer(origin: Vector, dir: Vector, distance: Real, shape: &dyn Shape) -> (Meeting, Real) {
    // A velocity that is too small or too large to be squared has no formula.
    if !dir.length_squared().is_normal() || !origin.length_squared().is_finite() {
        return (Meeting::Unclear, 0.0);
    }
    match shape.as_typed_shape() {
        TypedShape::Ball(other) => {
            (enter_round(origin, dir, [Vector::ZERO; 2], distance + other.radius), other.radius)
        }
        TypedShape::Capsule(capsule) => {
            let ends = [capsule.segment.a, capsule.segment.b];
            (enter_round(origin, dir, ends, distance + capsule.radius), capsule.radius)
        }
        TypedShape::Segment(segment) => {
            (enter_round(origin, dir, [segment.a, segment.b], distance), 0.0)
        }
        TypedShape::Cuboid(cuboid) => {
            (cuboid::enter_layer(cuboid.half_extents, origin, dir, distance), 0.0)
        }
        TypedShape::RoundCuboid(round) => {
            let (half, layer) = (round.inner_shape.half_extents, round.border_radius);
            (cuboid::enter_layer(half, origin, dir, distance + layer), layer)
        }
        other => match Facets::of(other) {
            Some((facets, layer)) => {
                (hull::enter_layer(&facets, origin, dir, distance + layer), layer)
            }
            None => (Meeting::Unclear, 0.0),
        },
    }
}

/// Returns the time at which a point meets the layer around a segment. A point is a segment without length.
fn enter_round(origin: Vector, dir: Vector, ends: [Vector; 2], radius: Real) -> Meeting {
    if radius == 0.0 {
        return Meeting::Unclear; // The nearest point has no direction.
    }
    match enter_capsule(origin, dir, ends, radius) {
        None => Meeting::Never,
        Some((time, core)) if time > 0.0 => Touch::around(origin + dir * time, core, time),
        Some(_) => {
            let core = nearest_on_segment(origin, ends);
            let is_within = core.distance_squared(origin) <= radius * radius;
            if is_within { Touch::around(origin, core, 0.0) } else { Meeting::Never }
        }
    }
}
