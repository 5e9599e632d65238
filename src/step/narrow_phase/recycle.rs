//! How far a touching pair may move before its contact points are computed anew.
//!
//! Until then the points ride along with the two bodies, which is nearly right as long as the same
//! corners and edges touch. It is wrong at once where a round surface rolls: its point of contact moves
//! on. A point that lags behind by `δ` lets the normal force `N` turn the body with the torque `N δ`.

use crate::dim::math::Real;
use crate::dim::shapes::has_curved_surface;
use parry::shape::{Shape, TypedShape};

/// Share of the recycle distance for which the points of round surfaces ride along.
///
/// With the default distance of 0.01 m, a ball of radius `r` rolls on with a point that lags by 0.2 mm
/// at most. That changes the acceleration of a ball of `r` = 0.5 on a slope of 20° by less than
/// 0.1 %; the full distance changed it by 2.5 %.
const ROUND_SHARE: Real = 0.02;

/// How far (length units) any point of the two shapes may move against the other shape before contacts
/// must be computed again, if `distance` is right for shapes with flat sides.
pub(super) fn recycle_distance(shapes: [&dyn Shape; 2], distance: Real) -> Real {
    if shapes.into_iter().any(is_round) { distance * ROUND_SHARE } else { distance }
}

/// Can the shape roll?
fn is_round(shape: &dyn Shape) -> bool {
    match shape.as_typed_shape() {
        TypedShape::Ball(_)
        | TypedShape::Capsule(_)
        | TypedShape::RoundCuboid(_)
        | TypedShape::RoundTriangle(_)
        | TypedShape::Custom(_) => true,
        TypedShape::Compound(compound) => {
            compound.shapes().iter().any(|(_, part)| is_round(&**part))
        }
        other => has_curved_surface(other),
    }
}
