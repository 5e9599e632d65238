//! Contact manifolds of two shapes.
//!
//! Every pair of convex parts that come near each other gets a manifold of its own. Nothing here
//! remembers anything: the previous manifolds serve as a hint where to begin the search, and the
//! buffers in [`ManifoldScratch`] only spare allocations.

use super::convex::{convex_manifold, separation_along};
use super::parts::{Near, Part, Parts};
use crate::base::guard::guarded;
use crate::dim::collide::{RawManifold, RawPoint, reduce};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::contact::{Contact, ContactManifold};
use parry::query::{DefaultQueryDispatcher, PersistentQueryDispatcher, QueryDispatcher};
use parry::shape::Shape;
use smallvec::SmallVec;

/// Poses farther than this from each other (length units) give no contacts. Geometry works with
/// fourth powers of lengths, and those of larger numbers leave the range of `f32`.
const DISTANCE_MAX: Real = 1.0e9;
/// A normal whose squared length is off by more than this is the product of degenerate geometry.
const NORMAL_TOLERANCE: Real = 1.0e-2;

/// Lengths at which nothing is extreme.
const USUAL: (Real, Real) = (1.0e-3, 1.0e5);
/// What share of a computed distance is surely there, whatever the rounding.
const DISTANCE_SHARE: Real = 0.99;

/// Buffers that are reused from pair to pair. One for each thread.
#[derive(Default)]
pub(crate) struct ManifoldScratch {
    /// The manifold of one pair of convex parts.
    raw: RawManifold,
    /// Manifolds of voxel shapes, which parry computes all at once.
    many: Vec<RawManifold>,
}

/// Computes the manifolds of two shapes, all points within `prediction` (length units) of each other.
///
/// `pos12` is the pose of the second shape in the frame of the first. `out` is overwritten; manifolds
/// without points are left out, as are those whose numbers are not finite. Their impulses are zero:
/// see [`inherit_impulses`](super::matching::inherit_impulses).
///
/// Returns a lower bound of the distance between the shapes: 0 if they touch or nothing is known,
/// infinity if they can never touch. When no manifold comes out, none can appear before the shapes
/// have moved against each other by the bound less `prediction`.
pub(crate) fn compute_manifolds(
    pos12: &Pose,
    shape1: &dyn Shape,
    shape2: &dyn Shape,
    prediction: Real,
    previous: &[ContactManifold],
    scratch: &mut ManifoldScratch,
    out: &mut SmallVec<[ContactManifold; 1]>,
) -> Real {
    out.clear();
    if !pose_is_usable(pos12) || !prediction.is_finite() {
        return 0.0;
    }
    if parry_merges_voxels(shape1, shape2, pos12) || parry_merges_voxels(shape2, shape1, pos12) {
        return voxel_manifolds(pos12, [shape1, shape2], prediction, &mut scratch.many, out);
    }
    let parts = (Parts::of(shape1), Parts::of(shape2));
    let raw = &mut scratch.raw;
    let mut search = Search { pos12, prediction, previous, raw, out, distance: Real::INFINITY };
    match parts {
        (Parts::Convex(_), Parts::Convex(_)) => {
            search.visit(&Part::whole(shape1), &Part::whole(shape2));
            let is_known = search.distance > 0.0 || !search.out.is_empty();
            if is_known { search.distance } else { distance_bound(pos12, shape1, shape2) }
        }
        _ => search.visit_near(&parts.0, &parts.1),
    }
}

/// A lower bound of the distance of two convex shapes by way of their closest points.
fn distance_bound(pos12: &Pose, shape1: &dyn Shape, shape2: &dyn Shape) -> Real {
    match guarded(|| DefaultQueryDispatcher.distance(pos12, shape1, shape2)) {
        Some(Ok(found)) if found.distance.is_finite() => found.distance * DISTANCE_SHARE,
        _ => 0.0,
    }
}

/// Do the two shapes intersect? `pos12` is the pose of the second in the frame of the first.
pub(crate) fn shapes_intersect(pos12: &Pose, shape1: &dyn Shape, shape2: &dyn Shape) -> bool {
    let test = || DefaultQueryDispatcher.intersection_test(pos12, shape1, shape2);
    pose_is_usable(pos12)
        && guarded(test).is_some_and(|found| found.is_ok_and(|found| found.intersecting))
}

/// Is the pose one that geometry can be computed with?
fn pose_is_usable(pose: &Pose) -> bool {
    let distance = pose.translation.abs().max_element();
    pose.is_finite() && distance < DISTANCE_MAX
}

/// The search for the manifolds of one pair of shapes.
struct Search<'a> {
    pos12: &'a Pose,
    prediction: Real,
    previous: &'a [ContactManifold],
    raw: &'a mut RawManifold,
    out: &'a mut SmallVec<[ContactManifold; 1]>,
    /// Lower bound of the distance of the parts visited so far.
    distance: Real,
}

impl Search<'_> {
    /// Visits all pairs of parts that are near each other; returns a bound of the shapes' distance.
    fn visit_near(&mut self, parts1: &Parts<'_>, parts2: &Parts<'_>) -> Real {
        let (pos12, prediction) = (*self.pos12, self.prediction);
        let pos21 = pos12.inverse();
        let near1 = Near::of(parts2.shape(), &pos12, prediction);
        parts1.for_each_part(&near1, &mut |part1| match parts2 {
            Parts::Convex(shape2) => self.visit(&part1, &Part::whole(*shape2)),
            _ => {
                let near2 = Near::of(part1.shape, &(pos21 * part1.pose()), prediction);
                parts2.for_each_part(&near2, &mut |part2| self.visit(&part1, &part2));
            }
        });
        // Parts that were not visited are farther than the prediction.
        self.distance.min(prediction)
    }

    /// Computes the manifold of two convex parts.
    fn visit(&mut self, part1: &Part<'_>, part2: &Part<'_>) {
        let pos12 = match (part1.pose, part2.pose) {
            (None, None) => *self.pos12,
            _ => part1.pose().inverse() * *self.pos12 * part2.pose(),
        };
        self.raw.local_n1 = self.hint(part1, part2);
        self.raw.points.clear();
        let found = convex_manifold(&pos12, part1, part2, self.prediction, self.raw);
        let Some(mut gap) = found else { return };
        let prediction = self.prediction;
        self.raw.points.retain(|point| is_sound(point) && point.dist <= prediction);
        if self.raw.points.is_empty() {
            if gap <= 0.0 {
                gap = separation_along(&pos12, part1.shape, part2.shape, self.raw.local_n1);
            }
            self.distance = self.distance.min(gap * DISTANCE_SHARE);
            return;
        }
        self.distance = 0.0;
        finish(self.raw, self.pos12, part1, part2, self.out);
    }

    /// Where the normal of two parts pointed last time, in the frame of the first part.
    fn hint(&self, part1: &Part<'_>, part2: &Part<'_>) -> Vector {
        let ids = (part1.id, part2.id);
        let is_same = |m: &&ContactManifold| (m.subshape1, m.subshape2) == ids;
        match (self.previous.iter().find(is_same), part1.pose) {
            (Some(manifold), Some(pose)) => pose.rotation.inverse() * manifold.local_n1,
            (Some(manifold), None) => manifold.local_n1,
            (None, _) => Vector::ZERO,
        }
    }
}

/// Are all numbers of the point finite?
fn is_sound(point: &RawPoint) -> bool {
    point.local_p1.is_finite() && point.local_p2.is_finite() && point.dist.is_finite()
}

/// Adds the manifold in the frames of the shapes, with as many points as the solver takes.
fn finish(
    raw: &mut RawManifold,
    pos12: &Pose,
    part1: &Part<'_>,
    part2: &Part<'_>,
    out: &mut SmallVec<[ContactManifold; 1]>,
) {
    let length_squared = raw.local_n1.length_squared();
    // Written so that NaN is refused.
    let is_unit = (length_squared - 1.0).abs() < NORMAL_TOLERANCE;
    if !is_unit {
        return;
    }
    reduce(&mut raw.points, raw.local_n1);
    let mut local_n1 = raw.local_n1 / length_squared.sqrt();
    if let Some(pose) = part1.pose {
        local_n1 = pose.rotation * local_n1;
    }
    // Filled in place: a manifold is some hundred bytes.
    out.push(ContactManifold::default());
    let Some(manifold) = out.last_mut() else { return };
    manifold.local_n1 = local_n1;
    manifold.local_n2 = pos12.rotation.inverse() * -local_n1;
    manifold.subshape1 = part1.id;
    manifold.subshape2 = part2.id;
    for point in &raw.points {
        manifold.data.points.push(Contact::new(
            part1.pose.map_or(point.local_p1, |pose| *pose * point.local_p1),
            part2.pose.map_or(point.local_p2, |pose| *pose * point.local_p2),
            point.fid1,
            point.fid2,
            point.dist,
        ));
    }
}

/// Does parry know a better way for voxels against the other shape than to look at them one by one?
///
/// It does for convex shapes; but it asserts what rounding can break when sizes are extreme.
fn parry_merges_voxels(voxels: &dyn Shape, other: &dyn Shape, pos12: &Pose) -> bool {
    let Some(voxels) = voxels.as_voxels() else { return false };
    if other.as_support_map().is_none() {
        return false;
    }
    let usual = |length: Real| (USUAL.0..USUAL.1).contains(&length);
    let extents = other.compute_local_aabb().extents();
    usual(voxels.voxel_size().min_element())
        && usual(voxels.voxel_size().max_element())
        && extents.max_element() < USUAL.1
        && pos12.translation.abs().max_element() < USUAL.1
}

/// The manifolds of a pair with voxels, which parry treats as a whole: it merges neighbouring voxels
/// so that nothing catches on the edges between them.
fn voxel_manifolds(
    pos12: &Pose,
    shapes: [&dyn Shape; 2],
    prediction: Real,
    many: &mut Vec<RawManifold>,
    out: &mut SmallVec<[ContactManifold; 1]>,
) -> Real {
    many.clear();
    let [shape1, shape2] = shapes;
    let query = DefaultQueryDispatcher;
    let found =
        guarded(|| query.contact_manifolds(pos12, shape1, shape2, prediction, many, &mut None));
    match found {
        Some(Ok(())) => {}
        Some(Err(_)) => return Real::INFINITY,
        None => return 0.0, // in this pose; the next one may do
    }
    for raw in many {
        let poses = raw.subshape_poses.take();
        let poses = poses.as_ref().map(|poses| (poses.pos1.as_ref(), poses.pos2.as_ref()));
        let (pose1, pose2) = poses.unwrap_or_default();
        let part1 = Part { id: raw.subshape1, pose: pose1, ..Part::whole(shapes[0]) };
        let part2 = Part { id: raw.subshape2, pose: pose2, ..Part::whole(shapes[1]) };
        raw.points.retain(|point| is_sound(point) && point.dist <= prediction);
        if !raw.points.is_empty() {
            finish(raw, pos12, &part1, &part2, out);
        }
    }
    if out.is_empty() { prediction } else { 0.0 }
}
