//! Which contact of this step was which contact of the last: so that solving starts from the impulses
//! that held the bodies apart a moment ago.

use crate::dim::math::{Real, Vector};
use crate::model::contact::{Contact, ContactManifold};
use parry::shape::PackedFeatureId;

/// Manifolds whose normals differ by more than 45° hold different sides of the bodies apart.
const NORMAL_COSINE_MIN: Real = 0.7;
/// Points without known features are the same if they are closer than this share of the manifold's size.
const NEAR_FRACTION: Real = 0.25;

/// Hands the impulses of the last step's manifolds to the manifolds of this step.
///
/// Manifolds match by the parts they stand between, points by the features of the two shapes (so a
/// sliding box keeps its impulses), or else by their place on the first shape.
pub(crate) fn inherit_impulses(new: &mut [ContactManifold], old: &[ContactManifold]) {
    // Both lists follow the same traversal, so the next match is most often right after the last.
    let mut start = 0;
    for manifold in new {
        let ids = (manifold.subshape1, manifold.subshape2);
        let matching = (start..old.len())
            .chain(0..start)
            .find(|&index| (old[index].subshape1, old[index].subshape2) == ids);
        if let Some(index) = matching {
            inherit_manifold(manifold, &old[index]);
            start = index + 1;
        }
    }
}

/// Hands over what one manifold remembers.
fn inherit_manifold(new: &mut ContactManifold, old: &ContactManifold) {
    new.data.user_data = old.data.user_data;
    if new.local_n1.dot(old.local_n1) < NORMAL_COSINE_MIN {
        return;
    }
    new.data.warmstart_friction = old.data.warmstart_friction;
    new.data.warmstart_twist = old.data.warmstart_twist;

    let old_points = old.contacts();
    let mut taken = 0_u32; // one bit for each old point
    let mut matched = 0_u32; // one bit for each new point
    for (index, point) in new.data.points.iter_mut().enumerate() {
        if let Some(found) = with_same_features(point, old_points, taken) {
            point.inherit(&old_points[found]);
            taken |= 1 << found;
            matched |= 1 << index;
        }
    }
    let limit = near_limit(old_points, new.data.points.len());
    for (index, point) in new.data.points.iter_mut().enumerate() {
        if matched & (1 << index) != 0 {
            continue;
        }
        if let Some(found) = nearest(point.local_p1, old_points, taken, limit) {
            point.inherit(&old_points[found]);
            taken |= 1 << found;
        }
    }
}

/// The old point between the same two features, if they are known.
fn with_same_features(point: &Contact, old: &[Contact], taken: u32) -> Option<usize> {
    let known = |id: PackedFeatureId| !id.is_unknown();
    if !(known(point.fid1) && known(point.fid2)) {
        return None;
    }
    (0..old.len()).find(|&index| {
        taken & (1 << index) == 0 && (old[index].fid1, old[index].fid2) == (point.fid1, point.fid2)
    })
}

/// Squared distance up to which two points count as one: without limit if there is but one.
fn near_limit(old: &[Contact], new_count: usize) -> Real {
    if old.len() == 1 && new_count == 1 {
        return Real::INFINITY;
    }
    let Some(first) = old.first() else { return 0.0 };
    let spread = old.iter().map(|point| point.local_p1.distance_squared(first.local_p1));
    spread.fold(0.0, Real::max) * (NEAR_FRACTION * NEAR_FRACTION)
}

/// The nearest old point that nobody took, within the squared distance `limit`.
fn nearest(place: Vector, old: &[Contact], taken: u32, limit: Real) -> Option<usize> {
    let mut best = (None, limit);
    for (index, point) in old.iter().enumerate() {
        let distance = point.local_p1.distance_squared(place);
        if taken & (1 << index) == 0 && distance <= best.1 {
            best = (Some(index), distance);
        }
    }
    best.0
}
