//! Contact manifolds of two shapes.
//!
//! Every pair of convex parts that come near each other gets a [patch](super::patches) of contacts.
//! Contacts that are only [seams](super::seams) between the parts go, patches that look the same way
//! are put together, and what is left are the manifolds. Nothing here remembers anything: the previous
//! manifolds serve as a hint where to begin the search, and the buffers in [`ManifoldScratch`] only
//! spare allocations.

use super::convex::{convex_manifold, manifold_along, separation_along};
use super::neighbor::Neighbor;
use super::parts::{Near, Part, Parts};
use super::patches::{Patches, push_manifold, unit_normal};
use super::seams::{Facet, Obstacle, Seam, find_seams};
use crate::base::guard::guarded;
use crate::dim::collide::{RawManifold, RawPoint, reduce};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::contact::ContactManifold;
use parry::query::{DefaultQueryDispatcher, PersistentQueryDispatcher, QueryDispatcher};
use parry::shape::Shape;
use smallvec::SmallVec;

/// Poses farther than this from each other (length units) give no contacts. Geometry works with
/// fourth powers of lengths, and those of larger numbers leave the range of `f32`.
const DISTANCE_MAX: Real = 1.0e9;

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
    /// The points of one manifold.
    points: Vec<RawPoint>,
    patches: Patches,
    seams: Vec<Seam>,
}

/// Two shapes, and which contacts of theirs are wanted.
#[derive(Copy, Clone)]
pub(crate) struct ShapePair<'a> {
    /// Pose of the second shape in the frame of the first.
    pub pos12: Pose,
    pub shapes: [&'a dyn Shape; 2],
    /// How far apart points may be (length units).
    pub prediction: Real,
    /// How high a step may be that is none (length units).
    pub flush: Real,
    /// The other contacts of each of the two.
    pub neighbors: [&'a [Neighbor<'a>]; 2],
}

/// Computes the manifolds of two shapes.
///
/// `out` is overwritten; manifolds without points are left out, as are those whose numbers are not
/// finite. Their impulses are zero: see [`inherit_impulses`](super::matching::inherit_impulses).
///
/// Returns a lower bound of the distance between the shapes: 0 if they touch or nothing is known,
/// infinity if they can never touch. When no manifold comes out, none can appear before the shapes
/// have moved against each other by the bound less the prediction.
pub(crate) fn compute_manifolds(
    pair: &ShapePair<'_>,
    previous: &[ContactManifold],
    scratch: &mut ManifoldScratch,
    out: &mut SmallVec<[ContactManifold; 1]>,
) -> Real {
    out.clear();
    let ShapePair { pos12, shapes: [shape1, shape2], prediction, .. } = *pair;
    if !pose_is_usable(&pos12) || !prediction.is_finite() {
        return 0.0;
    }
    if parry_merges_voxels(shape1, shape2, &pos12) || parry_merges_voxels(shape2, shape1, &pos12) {
        return voxel_manifolds(&pos12, [shape1, shape2], prediction, scratch, out);
    }
    let parts = [Parts::of(shape1), Parts::of(shape2)];
    let ManifoldScratch { raw, points, patches, seams, .. } = scratch;
    if parts.iter().all(Parts::is_convex) && pair.neighbors.iter().all(|list| list.is_empty()) {
        return convex_pair(pair, previous, raw, points, out);
    }
    patches.clear();
    let mut search = Search { pair, parts, previous, raw, patches, distance: Real::INFINITY };
    let bound = search.visit_near();
    for side in 0..2 {
        search.take_out_seams(side, seams);
    }
    search.patches.merge(&pos12, prediction, out);
    bound
}

/// Computes the manifold of two convex shapes.
fn convex_pair(
    pair: &ShapePair<'_>,
    previous: &[ContactManifold],
    raw: &mut RawManifold,
    points: &mut Vec<RawPoint>,
    out: &mut SmallVec<[ContactManifold; 1]>,
) -> Real {
    let ShapePair { pos12, shapes: [shape1, shape2], prediction, .. } = *pair;
    raw.local_n1 = previous.first().map_or(Vector::ZERO, |manifold| manifold.local_n1);
    let parts = [Part::whole(shape1), Part::whole(shape2)];
    let Some(bound) = part_manifold(&pos12, &parts, prediction, raw) else {
        return Real::INFINITY;
    };
    if raw.points.is_empty() {
        return if bound > 0.0 { bound } else { distance_bound(&pos12, shape1, shape2) };
    }
    if let Some(normal) = unit_normal(raw) {
        points.clear();
        points.extend(raw.points.iter().copied());
        reduce(points, normal, Real::INFINITY);
        push_manifold(points, normal, [0, 0], &pos12, out);
    }
    0.0
}

/// Computes the usable contacts of two convex parts, `pos12` being the pose of the second in the frame
/// of the first. Returns a lower bound of the distance, 0 if there are contacts or nothing is known;
/// `None` if such shapes never touch.
fn part_manifold(
    pos12: &Pose,
    [part1, part2]: &[Part<'_>; 2],
    prediction: Real,
    raw: &mut RawManifold,
) -> Option<Real> {
    raw.points.clear();
    let gap = convex_manifold(pos12, part1, part2, prediction, raw)?;
    raw.points.retain(|point| is_sound(point) && point.dist <= prediction);
    if !raw.points.is_empty() {
        return Some(0.0);
    }
    let gap = if gap > 0.0 {
        gap
    } else {
        separation_along(pos12, part1.shape, part2.shape, raw.local_n1)
    };
    Some(gap * DISTANCE_SHARE)
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

/// The search for the manifolds of a pair of shapes, one of which has several parts or other contacts.
struct Search<'a> {
    pair: &'a ShapePair<'a>,
    parts: [Parts<'a>; 2],
    previous: &'a [ContactManifold],
    raw: &'a mut RawManifold,
    patches: &'a mut Patches,
    /// Lower bound of the distance of the parts visited so far.
    distance: Real,
}

impl Search<'_> {
    /// Visits all pairs of parts that are near each other; returns a bound of the shapes' distance.
    fn visit_near(&mut self) -> Real {
        let ([parts1, parts2], prediction) = (self.parts, self.pair.prediction);
        let pos21 = self.pair.pos12.inverse();
        let near1 = Near::of(parts2.shape(), &self.pair.pos12, prediction);
        parts1.for_each_part(&near1, &mut |part1| match parts2 {
            Parts::Convex(shape2) => self.visit(part1, Part::whole(shape2)),
            _ => {
                let near2 = Near::of(part1.shape, &(pos21 * part1.pose()), prediction);
                parts2.for_each_part(&near2, &mut |part2| self.visit(part1, part2));
            }
        });
        // Parts that were not visited are farther than the prediction.
        self.distance.min(prediction)
    }

    /// Computes the contacts of two convex parts.
    fn visit(&mut self, part1: Part<'_>, part2: Part<'_>) {
        let pos12 = self.pose_of_parts(&part1, &part2);
        let apart = part2.gap_to_box(&pos12, &part1);
        let apart = apart.or_else(|| part1.gap_to_box(&pos12.inverse(), &part2));
        if let Some(gap) = apart.filter(|gap| *gap > self.pair.prediction) {
            self.distance = self.distance.min(gap * DISTANCE_SHARE);
            return;
        }
        self.raw.local_n1 = self.hint(&part1, &part2);
        let parts = [part1, part2];
        if let Some(gap) = part_manifold(&pos12, &parts, self.pair.prediction, self.raw) {
            self.distance = self.distance.min(gap);
            if !self.raw.points.is_empty() {
                self.patches.add(self.raw, &part1, &part2);
            }
        }
    }

    fn pose_of_parts(&self, part1: &Part<'_>, part2: &Part<'_>) -> Pose {
        match (part1.pose, part2.pose) {
            (None, None) => self.pair.pos12,
            _ => part1.pose().inverse() * self.pair.pos12 * part2.pose(),
        }
    }

    /// Where the normal of two parts pointed last time, in the frame of the first part. Flat parts that
    /// lie in the plane of a manifold are part of it.
    fn hint(&self, part1: &Part<'_>, part2: &Part<'_>) -> Vector {
        let ids = (part1.id, part2.id);
        let is_same = |m: &&ContactManifold| (m.subshape1, m.subshape2) == ids;
        let is_in_plane = |manifold: &&ContactManifold| {
            if !(part1.wants_hint() && part2.wants_hint()) {
                return false;
            }
            let Some(contact) = manifold.contacts().first() else { return false };
            let flush = self.pair.flush;
            part1.is_flat_in(contact.local_p1, manifold.local_n1, flush)
                || part2.is_flat_in(contact.local_p2, manifold.local_n2, flush)
        };
        let last = self.previous.iter().find(is_same);
        match (last.or_else(|| self.previous.iter().find(is_in_plane)), part1.pose) {
            (Some(manifold), Some(pose)) => pose.rotation.inverse() * manifold.local_n1,
            (Some(manifold), None) => manifold.local_n1,
            (None, _) => Vector::ZERO,
        }
    }

    /// Takes contacts out that are only seams between parts of the shape on a side, or between these and
    /// other obstacles of the shape on the other side.
    fn take_out_seams(&mut self, side: usize, seams: &mut Vec<Seam>) {
        let neighbors = self.pair.neighbors[1 - side];
        if neighbors.is_empty() && (self.parts[side].is_convex() || self.patches.look_alike()) {
            return;
        }
        self.find_seams(side, seams);
        for seam in &*seams {
            self.turn(side, seam);
        }
    }

    fn find_seams(&self, side: usize, seams: &mut Vec<Seam>) {
        let (pair, patches) = (self.pair, &*self.patches);
        let neighbors = pair.neighbors[1 - side];
        let facets = (0..patches.list().len()).map(|patch| self.facet(side, patch));
        let facets: SmallVec<[Facet<'_>; 16]> =
            facets.chain(neighbors.iter().map(Neighbor::as_facet)).collect();
        let points = |patch: usize, f: &mut dyn FnMut(Vector)| {
            patches.points(patch).iter().for_each(|point| f(pair.on_obstacle(side, point)));
        };
        find_seams(&facets, patches.list().len(), &points, pair.flush, seams);
    }

    /// A patch as a contact with an obstacle on a side, in the frame of the shape on the other.
    fn facet(&self, side: usize, patch: usize) -> Facet<'_> {
        let (index, patch) = (patch, &self.patches.list()[patch]);
        let pair = self.pair;
        let deepest = self.patches.points(index).iter().min_by(|a, b| a.dist.total_cmp(&b.dist));
        let (normal, pose) = match side {
            0 => (pair.pos12.rotation.inverse() * patch.normal, pair.pos12.inverse()),
            _ => (-patch.normal, pair.pos12),
        };
        let obstacle = Obstacle { parts: self.parts[side], id: patch.parts[side], pose };
        let place = deepest.map_or(Vector::ZERO, |point| pair.on_obstacle(side, point));
        let on = patch.parts[1 - side];
        let body = Obstacle { parts: self.parts[1 - side], id: on, pose: Pose::IDENTITY };
        Facet::new([obstacle, body], normal, place, patch.dist)
    }

    /// Computes a patch anew along the normal with which its obstacle may still carry the body.
    fn turn(&mut self, side: usize, seam: &Seam) {
        let Seam { index, along, .. } = *seam;
        let direction = if side == 0 { self.pair.pos12.rotation * along } else { -along };
        let [id1, id2] = self.patches.list()[index].parts;
        let [parts1, parts2] = self.parts;
        let (mut is_carried, mut is_too_deep) = (false, false);
        parts1.with_part(id1, &mut |part1| {
            parts2.with_part(id2, &mut |part2| {
                let pos12 = self.pose_of_parts(&part1, &part2);
                let direction = part1.pose().rotation.inverse() * direction;
                let (prediction, raw) = (self.pair.prediction, &mut *self.raw);
                raw.points.clear();
                manifold_along(&pos12, [&part1, &part2], side == 0, direction, prediction, raw);
                raw.points.retain(|point| is_sound(point) && point.dist <= prediction);
                is_too_deep = raw.points.iter().any(|point| point.dist < seam.least_dist);
                is_carried = !raw.points.is_empty()
                    && !is_too_deep
                    && self.patches.replace(index, raw, &part1, &part2);
            });
        });
        // An edge that seemed hidden, and is not.
        let stays = is_too_deep && !seam.is_behind;
        if !is_carried && !stays {
            self.patches.empty(index);
        }
    }
}

impl<'a> ShapePair<'a> {
    /// Two shapes that touch nothing else, and among whose own parts no step is too low to be one.
    #[cfg(test)]
    pub fn alone(pos12: &Pose, shapes: [&'a dyn Shape; 2], prediction: Real) -> Self {
        Self { pos12: *pos12, shapes, prediction, flush: 0.0, neighbors: [&[], &[]] }
    }

    /// Where a contact is on the obstacle on a side, in the frame of the shape on the other side.
    fn on_obstacle(&self, side: usize, point: &RawPoint) -> Vector {
        match side {
            0 => self.pos12.inverse_transform_point(point.local_p1),
            _ => self.pos12 * point.local_p2,
        }
    }
}

/// Are all numbers of the point finite?
fn is_sound(point: &RawPoint) -> bool {
    point.local_p1.is_finite() && point.local_p2.is_finite() && point.dist.is_finite()
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
    scratch: &mut ManifoldScratch,
    out: &mut SmallVec<[ContactManifold; 1]>,
) -> Real {
    let ManifoldScratch { many, patches, .. } = scratch;
    many.clear();
    patches.clear();
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
            patches.add(raw, &part1, &part2);
        }
    }
    patches.merge(pos12, prediction, out);
    if out.is_empty() { prediction } else { 0.0 }
}
