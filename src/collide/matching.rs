//! Matching of this step's contacts with those of the last one, so that the solver starts with their
//! impulses.

use crate::dim::collide::RawPoint;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::contact::{Contact, ContactManifold};
use parry::shape::PackedFeatureId;

/// Manifolds whose normals differ by more than 45° hold different sides of the bodies apart.
const NORMAL_COSINE_MIN: Real = 0.7;
/// Least cosine of the normals of equal manifolds of different parts (8°).
const EQUAL_NORMAL_COSINE_MIN: Real = 0.99;
/// Largest distance of matching points without known features, as a fraction of the manifold's size.
const MATCH_DISTANCE_FRACTION_MAX: Real = 0.25;

/// Copies the impulses of the last step's manifolds to the manifolds of this step.
///
/// Manifolds match by their parts or, where many parts have one manifold, by their normals. Points match by
/// the features of the two shapes (so a sliding box keeps its impulses), or else by their position on either
/// shape.
pub(crate) fn inherit_impulses(new: &mut [ContactManifold], old: &[ContactManifold]) {
    // Both lists follow the same traversal, so the next match is most often right after the last.
    let mut start = 0;
    for manifold in new {
        let ids = (manifold.subshape1, manifold.subshape2);
        let has_same_parts = (start..old.len())
            .chain(0..start)
            .find(|&index| (old[index].subshape1, old[index].subshape2) == ids);
        if let Some(index) = has_same_parts {
            inherit_manifold(manifold, &old[index], true);
            start = index + 1;
        } else if let Some(index) = with_same_normal(manifold, old) {
            inherit_manifold(manifold, &old[index], false);
        }
    }
}

/// The manifold with similar normals on both shapes: that of other parts, when a body slides over them.
fn with_same_normal(manifold: &ContactManifold, old: &[ContactManifold]) -> Option<usize> {
    let cosine = |index: &usize| {
        let other = &old[*index];
        manifold.local_n1.dot(other.local_n1).max(manifold.local_n2.dot(other.local_n2))
    };
    let same = (0..old.len()).filter(|index| cosine(index) > EQUAL_NORMAL_COSINE_MIN);
    same.max_by(|a, b| cosine(a).total_cmp(&cosine(b)))
}

/// Transfers the stored data of a manifold.
fn inherit_manifold(new: &mut ContactManifold, old: &ContactManifold, has_same_parts: bool) {
    new.data.user_data = old.data.user_data;
    if new.local_n1.dot(old.local_n1) < NORMAL_COSINE_MIN {
        return;
    }
    new.data.last_friction = old.data.last_friction;
    new.data.warmstart_friction = old.data.warmstart_friction;
    new.data.warmstart_torsion = old.data.warmstart_torsion;
    inherit_points(&mut new.data.points, old.contacts(), has_same_parts);
}

/// Puts other contacts between the same two convex shapes in the place of those of a manifold, in the frames
/// of the shapes. Matching contacts keep their impulses.
pub(super) fn replace_contacts(
    manifold: &mut ContactManifold,
    local_n1: Vector,
    pos12: &Pose,
    points: &[RawPoint],
) {
    let (old_normal, old) = (manifold.local_n1, core::mem::take(&mut manifold.data.points));
    (manifold.local_n1, manifold.local_n2) = (local_n1, pos12.rotation.inverse() * -local_n1);
    set_contacts(manifold, points);
    let data = &mut manifold.data;
    if local_n1.dot(old_normal) < NORMAL_COSINE_MIN {
        data.clear_friction();
    } else {
        inherit_points(&mut data.points, &old, true);
    }
}

/// Gives a manifold these points, which carry no impulses yet.
///
/// The solver visits them in this order, that of the features of the shapes. It is not the same in a mirror,
/// so mirror-image collisions of boxes differ by up to 7 mm after 45 steps. Rejected alternative: an order by
/// depth, in each step or at the beginning of a contact, the deepest first or last. Boxes are then mirrored
/// to 0.1 mm, but heaps settle worse: an overlap of 30 mm in the scene `primitives` that is below 10 mm now.
pub(super) fn set_contacts(manifold: &mut ContactManifold, points: &[RawPoint]) {
    manifold.data.points.clear();
    manifold.data.points.extend(points.iter().map(|point| {
        Contact::new(point.local_p1, point.local_p2, point.fid1, point.fid2, point.dist)
    }));
}

/// Copies the impulses of old points to the matching new ones.
fn inherit_points(new: &mut [Contact], old: &[Contact], has_same_parts: bool) {
    let new_count = new.len();
    let mut taken = 0_u32; // one bit for each old point
    let mut matched = 0_u32; // one bit for each new point
    for (index, point) in new.iter_mut().enumerate() {
        let found = with_same_features(point, old, taken).filter(|_| has_same_parts);
        if let Some(found) = found {
            point.inherit(&old[found]);
            taken |= 1 << found;
            matched |= 1 << index;
        }
    }
    if matched.count_ones() as usize == new_count {
        return;
    }
    let limit = near_limit(old, new_count);
    for (index, point) in new.iter_mut().enumerate() {
        if matched & (1 << index) != 0 {
            continue;
        }
        if let Some(found) = nearest(point, old, taken, limit) {
            point.inherit(&old[found]);
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
    spread.fold(0.0, Real::max) * (MATCH_DISTANCE_FRACTION_MAX * MATCH_DISTANCE_FRACTION_MAX)
}

/// The unmatched old point that is nearest on one of the shapes, within the squared distance `limit`.
fn nearest(point: &Contact, old: &[Contact], taken: u32, limit: Real) -> Option<usize> {
    let mut best = (None, limit);
    for (index, other) in old.iter().enumerate() {
        let on_first = other.local_p1.distance_squared(point.local_p1);
        let distance = on_first.min(other.local_p2.distance_squared(point.local_p2));
        if taken & (1 << index) == 0 && distance <= best.1 {
            best = (Some(index), distance);
        }
    }
    best.0
}
