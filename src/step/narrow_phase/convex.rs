//! The manifold of two convex parts.

use super::ball::ball_manifold;
use super::parts::Part;
use crate::dim::collide::RawManifold;
use crate::dim::math::{Pose, Real, Vector};
use parry::query::details::contact_manifold_pfm_pfm;
use parry::query::{DefaultQueryDispatcher, PersistentQueryDispatcher};
use parry::shape::Shape;

/// Computes the points at which two convex parts are within `prediction`, into `raw`.
///
/// `raw.local_n1` holds the normal of last time, or zero; afterwards the normal, or a direction in
/// which the parts are apart if there are no points. `false` if such shapes never touch.
pub(super) fn convex_manifold(
    pos12: &Pose,
    part1: &Part<'_>,
    part2: &Part<'_>,
    prediction: Real,
    raw: &mut RawManifold,
) -> bool {
    let is_constrained = part1.constraints.is_some() || part2.constraints.is_some();
    if is_constrained && constrained_manifold(pos12, part1, part2, prediction, raw) {
        return true;
    }
    if !is_constrained {
        if let Some(ball) = part2.shape.as_ball() {
            ball_manifold(pos12, part1.shape, ball, prediction, raw);
            return true;
        }
        if let Some(ball) = part1.shape.as_ball() {
            ball_manifold(&pos12.inverse(), part2.shape, ball, prediction, raw);
            flip(raw);
            return true;
        }
    }
    DefaultQueryDispatcher
        .contact_manifold_convex_convex(
            pos12,
            part1.shape,
            part2.shape,
            part1.constraints,
            part2.constraints,
            prediction,
            raw,
        )
        .is_ok()
}

/// Exchanges the roles of the two parts.
fn flip(raw: &mut RawManifold) {
    core::mem::swap(&mut raw.local_n1, &mut raw.local_n2);
    for point in &mut raw.points {
        core::mem::swap(&mut point.local_p1, &mut point.local_p2);
        core::mem::swap(&mut point.fid1, &mut point.fid2);
    }
}

/// The manifold of two parts of which one has neighbours that restrict its normal.
///
/// The dispatcher's special cases for boxes and capsules know no restrictions, so all polyhedra go
/// the general way here. `false` if one of them is none.
fn constrained_manifold(
    pos12: &Pose,
    part1: &Part<'_>,
    part2: &Part<'_>,
    prediction: Real,
    raw: &mut RawManifold,
) -> bool {
    let (features1, features2) =
        (part1.shape.as_polygonal_feature_map(), part2.shape.as_polygonal_feature_map());
    let (Some((features1, radius1)), Some((features2, radius2))) = (features1, features2) else {
        return false;
    };
    contact_manifold_pfm_pfm(
        pos12,
        features1,
        radius1,
        part1.constraints,
        features2,
        radius2,
        part2.constraints,
        prediction,
        raw,
    );
    true
}

/// How far two convex shapes are apart along `direction`, at least; 0 if they overlap along it or if
/// nothing is known.
pub(super) fn separation_along(
    pos12: &Pose,
    shape1: &dyn Shape,
    shape2: &dyn Shape,
    direction: Vector,
) -> Real {
    let (Some(support1), Some(support2)) = (shape1.as_support_map(), shape2.as_support_map())
    else {
        return 0.0;
    };
    let Some(direction) = direction.try_normalize() else { return 0.0 };
    let highest = support1.local_support_point(direction);
    let lowest = support2.support_point(pos12, -direction);
    let gap = direction.dot(lowest - highest);
    if gap.is_finite() { gap.max(0.0) } else { 0.0 }
}
