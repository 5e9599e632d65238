//! Contact manifolds of two shapes.
//!
//! Every pair of convex parts that come near each other gets a [patch](super::patches) of contacts. [Ghost
//! contacts](super::internal_edges) between the parts are removed, patches with similar normals are merged,
//! and the rest are the manifolds. The module is stateless: the previous manifolds are a start for the
//! search, and the buffers in [`ManifoldScratch`] only save allocations.

use super::convex::{DISTANCE_FRACTION, is_sound, part_manifold};
use super::internal_edges::GhostContact;
use super::matching::replace_contacts;
use super::pair::ShapePair;
use super::part::Part;
use super::parts::Parts;
use super::patches::{Patches, push_manifold, unit_normal};
use super::queries::distance;
use super::search::{CulledParts, Search};
use crate::base::guard::guarded;
use crate::base::measure::FRAME_DISTANCE_MAX;
use crate::base::parry_version::take_subshape_poses;
use crate::dim::collide::{RawManifold, RawPoint, reduce};
use crate::dim::math::{MAX_MANIFOLD_POINTS, Pose, Real, Vector};
use crate::model::contact::{ContactManifold, TriangleCache};
use parry::query::{DefaultQueryDispatcher, PersistentQueryDispatcher};
use parry::shape::Shape;
use smallvec::SmallVec;

/// Lengths at which nothing is extreme.
const LENGTH_RANGE: (Real, Real) = (1.0e-3, 1.0e5);

/// Buffers that are reused from pair to pair. One for each thread.
#[derive(Default)]
pub(crate) struct ManifoldScratch {
    /// The manifold of one pair of convex parts.
    raw: RawManifold,
    /// Manifolds of voxel shapes, which parry computes all at once.
    many: Vec<RawManifold>,
    /// The points of one manifold.
    points: Vec<RawPoint>,
    patches: Patches,
    culled: CulledParts,
    passing: TriangleCache,
    ghost_contacts: Vec<GhostContact>,
    /// Whether there were too many pairs of parts to compute the contacts of all.
    are_parts_culled: bool,
}

impl ManifoldScratch {
    /// Returns whether the last manifolds were made of some contacts alone, because there were too many.
    pub fn is_culled(&self) -> bool {
        self.are_parts_culled || self.patches.are_culled()
    }
}

/// Computes the manifolds of two shapes.
///
/// `out` is overwritten; manifolds without points are left out, as are those whose numbers are not finite.
/// Their impulses are zero: see [`inherit_impulses`](super::matching::inherit_impulses). `triangle_cache`
/// affects the running time only.
///
/// Returns a lower bound of the distance between the shapes: 0 if they touch or nothing is known,
/// infinity if they can never touch. When no manifold comes out, none can appear before the shapes
/// have moved against each other by the bound less the prediction.
pub(crate) fn compute_manifolds(
    pair: &ShapePair<'_>,
    previous: &[ContactManifold],
    triangle_cache: Option<&mut Option<Box<TriangleCache>>>,
    scratch: &mut ManifoldScratch,
    out: &mut SmallVec<[ContactManifold; 1]>,
) -> Real {
    out.clear();
    scratch.patches.clear();
    scratch.are_parts_culled = false;
    let ShapePair { pos12, shapes: [shape1, shape2], prediction, .. } = *pair;
    if !pose_is_usable(&pos12) || !prediction.is_finite() {
        return 0.0;
    }
    let ManifoldScratch { raw, points, .. } = &mut *scratch;
    let parts = [Parts::of(shape1), Parts::of(shape2)];
    if parts.iter().all(Parts::is_convex) && pair.neighbors.iter().all(|list| list.is_empty()) {
        let hint = previous.first().map_or(Vector::ZERO, |manifold| manifold.local_n1);
        let (bound, normal) = convex_pair(pair, hint, raw);
        if let Some(normal) = normal {
            push_manifold(outermost(raw, normal, points), normal, [0, 0], &pos12, out);
        }
        return bound;
    }
    if parry_merges_voxels(shape1, shape2, &pos12) || parry_merges_voxels(shape2, shape1, &pos12) {
        return voxel_manifolds(pair, scratch, out);
    }
    let ManifoldScratch { raw, patches, culled, passing, ghost_contacts, are_parts_culled, .. } =
        scratch;
    let distance = Real::INFINITY;
    let mut search = Search {
        pair,
        parts,
        previous,
        raw,
        patches,
        culled,
        triangle_cache,
        passing,
        distance,
        are_parts_culled,
    };
    let bound = search.visit_near();
    for side in 0..2 {
        search.remove_ghost_contacts(side, ghost_contacts);
    }
    search.patches.merge(&pos12, prediction, out);
    bound
}

/// Updates the manifold of two convex shapes in place: as [`compute_manifolds`] does if they have no other
/// relevant contacts, without a temporary manifold.
///
/// `manifolds` has that of last time, or none. If there are no points now it is left without. Matching
/// contacts keep their impulses. Returns the bound of the distance.
pub(crate) fn renew_convex_manifold(
    pair: &ShapePair<'_>,
    manifolds: &mut SmallVec<[ContactManifold; 1]>,
    scratch: &mut ManifoldScratch,
) -> Real {
    let ManifoldScratch { raw, points, .. } = scratch;
    let is_usable = pose_is_usable(&pair.pos12) && pair.prediction.is_finite();
    let hint = manifolds.first().map_or(Vector::ZERO, |manifold| manifold.local_n1);
    let (bound, normal) = if is_usable { convex_pair(pair, hint, raw) } else { (0.0, None) };
    if normal.is_some() && manifolds.is_empty() {
        manifolds.push(ContactManifold::default());
    }
    let Some(manifold) = manifolds.first_mut() else { return bound };
    match normal {
        Some(normal) => {
            let points = outermost(raw, normal, points);
            replace_contacts(manifold, normal, &pair.pos12, points);
        }
        None => manifold.data.points.clear(),
    }
    bound
}

/// Computes the points of two convex shapes, into `raw`. Returns the bound of their distance and, if there
/// are points, the normal. `hint` is that of last time, or zero.
fn convex_pair(
    pair: &ShapePair<'_>,
    hint: Vector,
    raw: &mut RawManifold,
) -> (Real, Option<Vector>) {
    let ShapePair { pos12, shapes: [shape1, shape2], prediction, .. } = *pair;
    raw.local_n1 = hint;
    let parts = [Part::whole(shape1), Part::whole(shape2)];
    let Some(bound) = part_manifold(&pos12, &parts, prediction, raw) else {
        return (Real::INFINITY, None);
    };
    if raw.points.is_empty() {
        let bound = if bound > 0.0 { bound } else { distance_bound(&pos12, shape1, shape2) };
        return (bound, None);
    }
    (0.0, unit_normal(raw))
}

/// The points that the solver takes.
fn outermost<'a>(
    raw: &'a RawManifold,
    normal: Vector,
    points: &'a mut Vec<RawPoint>,
) -> &'a [RawPoint] {
    if raw.points.len() <= MAX_MANIFOLD_POINTS {
        return &raw.points;
    }
    points.clear();
    points.extend(raw.points.iter().copied());
    reduce(points, normal, Real::INFINITY);
    points
}

/// A lower bound of the distance of two convex shapes by their closest points.
fn distance_bound(pos12: &Pose, shape1: &dyn Shape, shape2: &dyn Shape) -> Real {
    match distance(pos12, [shape1, shape2]) {
        Some(distance) if distance.is_finite() => distance * DISTANCE_FRACTION,
        _ => 0.0,
    }
}

/// Returns whether geometry can be computed with the pose.
pub(super) fn pose_is_usable(pose: &Pose) -> bool {
    let distance = pose.translation.abs().max_element();
    pose.is_finite() && distance <= FRAME_DISTANCE_MAX
}

/// Returns whether parry has a faster algorithm for voxels against the other shape than a search of all
/// voxels.
///
/// It is sufficient for convex shapes, but contains assertions that rounding violates for extreme sizes.
fn parry_merges_voxels(voxels: &dyn Shape, other: &dyn Shape, pos12: &Pose) -> bool {
    let Some(voxels) = voxels.as_voxels() else { return false };
    if other.as_support_map().is_none() {
        return false;
    }
    let usual = |length: Real| (LENGTH_RANGE.0..LENGTH_RANGE.1).contains(&length);
    let extents = other.compute_local_aabb().extents();
    usual(voxels.voxel_size().min_element())
        && usual(voxels.voxel_size().max_element())
        && extents.max_element() < LENGTH_RANGE.1
        && pos12.translation.abs().max_element() < LENGTH_RANGE.1
}

/// The manifolds of a pair with voxels, which parry processes as a whole: it merges neighbouring voxels to
/// avoid internal edges.
fn voxel_manifolds(
    pair: &ShapePair<'_>,
    scratch: &mut ManifoldScratch,
    out: &mut SmallVec<[ContactManifold; 1]>,
) -> Real {
    let ShapePair { pos12, shapes, prediction, .. } = pair;
    let ManifoldScratch { many, patches, .. } = scratch;
    many.clear();
    let [shape1, shape2] = *shapes;
    let query = DefaultQueryDispatcher;
    let found =
        guarded(|| query.contact_manifolds(pos12, shape1, shape2, *prediction, many, &mut None));
    match found {
        Some(Ok(())) => {}
        Some(Err(_)) => return Real::INFINITY,
        None => return 0.0, // parry panics in this pose; the next one may succeed.
    }
    for raw in many {
        let poses = take_subshape_poses(raw);
        let [pose1, pose2] = poses.each_ref().map(Option::as_ref);
        let part1 = Part { id: raw.subshape1, pose: pose1, ..Part::whole(shapes[0]) };
        let part2 = Part { id: raw.subshape2, pose: pose2, ..Part::whole(shapes[1]) };
        raw.points.retain(|point| is_sound(point) && point.dist <= *prediction);
        if !raw.points.is_empty() {
            patches.add(pair, raw, &[part1, part2]);
        }
    }
    patches.merge(pos12, *prediction, out);
    if out.is_empty() { *prediction } else { 0.0 }
}
