//! Contacts between convex parts of two shapes, before they become manifolds.
//!
//! A body on a fine mesh touches a hundred triangles, all with the same normal. A hundred manifolds would
//! cost a hundred times as much as one, without better support of the body. Patches with similar normals are
//! therefore merged, and only the outermost of their points are kept, as for a single face.

use super::culling::{Grid, Rank, main_direction};
use super::matching::set_contacts;
use super::normals::NORMAL_DISTANCE_SQUARED_MAX;
use super::pair::ShapePair;
use super::part::Part;
use crate::dim::collide::{FlatShape, RawManifold, RawPoint, reduce};
use crate::dim::math::{DIM, MAX_MANIFOLD_POINTS, Pose, Real, Vector};
use crate::model::contact::ContactManifold;
use core::ops::Range;
use parry::shape::PackedFeatureId;
use smallvec::SmallVec;

/// A normal whose squared length is off by more than this is the product of degenerate geometry.
const NORMAL_TOLERANCE: Real = 1.0e-2;
/// Normals with at least this cosine to that of the deepest patch (5 degrees) become one manifold.
const NORMAL_COSINE_MIN: Real = 0.9962;
/// Largest distance of equal points, as a fraction of the manifold's size.
const POINT_DISTANCE_FRACTION_MAX: Real = 1.0e-3;
/// Patches are culled beyond this number. Meshes finer than the bodies on them stay far below it.
const PATCHES_MAX: usize = 1024;
/// Points of replaced patches are dropped beyond this number.
const POINTS_MAX: usize = 32 * PATCHES_MAX;
/// A cell of the culling grid keeps a patch for each of these directions of its normal.
const DIRECTIONS: usize = 2 * DIM;
/// Index of no patch.
const NONE: u32 = u32::MAX;

/// The contacts of two convex parts.
#[derive(Clone, Debug)]
pub(super) struct Patch {
    /// Numbers of the two parts within their shapes.
    pub parts: [u32; 2],
    /// Unit normal from the first shape to the second, in the frame of the first.
    pub normal: Vector,
    /// Distance at the deepest point.
    pub dist: Real,
    /// Whether no part meets the other with its rim alone. A flat part does, unless
    /// its normal is the contact normal.
    is_broad: bool,
    /// Range of its points.
    points: Range<usize>,
    /// The number of its [coplanar patch](super::search).
    coplanar_patch: Option<u32>,
    /// Range of the pieces of the coplanar patch; empty for one part alone.
    pieces: Range<usize>,
}

impl Patch {
    fn rank(&self) -> Rank {
        Rank { dist: self.dist, parts: self.parts }
    }

    /// A point as one of a manifold of these parts. Features of other parts would be taken for theirs.
    fn named(&self, point: &RawPoint, parts: [u32; 2]) -> RawPoint {
        let mut named = *point;
        if self.parts[0] != parts[0] {
            named.fid1 = PackedFeatureId::UNKNOWN;
        }
        if self.parts[1] != parts[1] {
            named.fid2 = PackedFeatureId::UNKNOWN;
        }
        named
    }
}

/// All patches of two shapes.
#[derive(Default)]
pub(super) struct Patches {
    list: Vec<Patch>,
    /// Points in the frames of the two shapes.
    points: Vec<RawPoint>,
    /// Pieces of coplanar patches, in the frame of their shape.
    pieces: Vec<FlatShape>,
    /// The patches that are part of a manifold already, and the points of the next one.
    merged: Vec<bool>,
    gathered: Vec<RawPoint>,
    /// The grid by which patches are culled, once there are too many, and by cell and direction the patch
    /// that is kept.
    grid: Option<Grid>,
    kept: Vec<u32>,
}

impl Patches {
    pub fn clear(&mut self) {
        self.list.clear();
        self.points.clear();
        self.pieces.clear();
        self.grid = None;
    }

    /// Returns whether some patches were dropped because there were too many.
    pub fn are_culled(&self) -> bool {
        self.grid.is_some()
    }

    pub fn list(&self) -> &[Patch] {
        &self.list
    }

    /// Returns whether all patches have similar normals. In that case none is a ghost contact.
    pub fn have_similar_normals(&self) -> bool {
        let Some(first) = self.list.first() else { return true };
        let same = |patch: &Patch| {
            patch.normal.distance_squared(first.normal) <= NORMAL_DISTANCE_SQUARED_MAX
        };
        self.list.iter().all(same)
    }

    /// The points of a patch.
    pub fn points(&self, index: usize) -> &[RawPoint] {
        &self.points[self.list[index].points.clone()]
    }

    /// Adds the contacts between two parts, in their frames. Returns whether it is usable.
    pub fn add(&mut self, pair: &ShapePair<'_>, raw: &RawManifold, parts: &[Part<'_>; 2]) -> bool {
        self.add_on(pair, raw, parts, None)
    }

    /// Adds contacts with a [coplanar patch](super::search) of this number, if it is one.
    pub fn add_on(
        &mut self,
        pair: &ShapePair<'_>,
        raw: &RawManifold,
        parts: &[Part<'_>; 2],
        coplanar_patch: Option<u32>,
    ) -> bool {
        let at = self.list.len();
        self.list.push(Patch {
            parts: parts.each_ref().map(|part| part.id),
            normal: Vector::ZERO,
            dist: 0.0,
            is_broad: true,
            points: 0..0,
            coplanar_patch,
            pieces: 0..0,
        });
        if !self.replace(at, pair, raw, parts) {
            self.list.pop();
            return false;
        }
        if self.grid.is_some() {
            self.cull_last();
        } else if self.list.len() > PATCHES_MAX {
            self.cull_all(pair);
        }
        true
    }

    /// Begins to cull: of all patches so far and to come, the deepest of each cell and direction stay.
    fn cull_all(&mut self, pair: &ShapePair<'_>) {
        let grid = Grid::between(pair);
        self.kept.clear();
        self.kept.resize(grid.len() * DIRECTIONS, NONE);
        self.grid = Some(grid);
        for patch in core::mem::take(&mut self.list) {
            self.list.push(patch);
            self.cull_last();
        }
    }

    /// Keeps the last patch only if it is the deepest of its cell and direction.
    fn cull_last(&mut self) {
        let (Some(grid), Some(patch)) = (self.grid, self.list.pop()) else { return };
        let points = &self.points[patch.points.clone()];
        let deepest = points.iter().min_by(|a, b| a.dist.total_cmp(&b.dist));
        let cell = deepest.map_or(0, |point| grid.cell(point.local_p1));
        let kept = &mut self.kept[cell * DIRECTIONS + main_direction(patch.normal)];
        if *kept == NONE {
            *kept = self.list.len() as u32;
            self.list.push(patch);
        } else {
            let other = &mut self.list[*kept as usize];
            if patch.rank().is_before(&other.rank()) {
                *other = patch;
            }
        }
        if self.points.len() > POINTS_MAX {
            self.drop_unused_points();
        }
    }

    /// Drops the points of patches that are no more.
    fn drop_unused_points(&mut self) {
        let used: usize = self.list.iter().map(|patch| patch.points.len()).sum();
        let mut points = Vec::with_capacity(2 * used);
        for patch in &mut self.list {
            let start = points.len();
            points.extend_from_slice(&self.points[patch.points.clone()]);
            patch.points = start..points.len();
        }
        self.points = points;
    }

    /// Stores the pieces of a coplanar patch for its contacts, if these were not culled.
    pub fn build_patch(&mut self, coplanar_patch: u32, pieces: impl Iterator<Item = FlatShape>) {
        let is_of_patch = |patch: &&mut Patch| patch.coplanar_patch == Some(coplanar_patch);
        let Some(patch) = self.list.iter_mut().find(is_of_patch) else { return };
        let start = self.pieces.len();
        self.pieces.extend(pieces);
        patch.pieces = start..self.pieces.len();
    }

    /// The pieces of the coplanar patch of a contact patch; none if it is on one part.
    pub fn pieces(&self, index: usize) -> &[FlatShape] {
        &self.pieces[self.list[index].pieces.clone()]
    }

    /// Puts other contacts of the same two parts in the place of a patch. `false` if they are not
    /// usable.
    pub fn replace(
        &mut self,
        index: usize,
        pair: &ShapePair<'_>,
        raw: &RawManifold,
        parts: &[Part<'_>; 2],
    ) -> bool {
        let [part1, part2] = parts;
        let Some(unit) = unit_normal(raw) else { return false };
        let start = self.points.len();
        for point in &raw.points {
            let mut point = *point;
            if let Some(pose) = part1.pose {
                point.local_p1 = *pose * point.local_p1;
            }
            if let Some(pose) = part2.pose {
                point.local_p2 = *pose * point.local_p2;
            }
            self.points.push(point);
        }
        let patch = &mut self.list[index];
        patch.normal = part1.pose.map_or(unit, |pose| pose.rotation * unit);
        let normals = [patch.normal, pair.pos12.rotation.inverse() * patch.normal];
        let meets_with_rim = |(part, normal): (&Part<'_>, Vector)| part.has_other_normal(normal);
        patch.is_broad = !parts.iter().zip(normals).any(meets_with_rim);
        patch.dist = raw.points.iter().map(|point| point.dist).fold(Real::INFINITY, Real::min);
        patch.points = start..self.points.len();
        true
    }

    /// Takes the contacts of a patch away.
    pub fn empty(&mut self, index: usize) {
        self.list[index].points.end = self.list[index].points.start;
    }

    /// Makes manifolds of the patches: one for each direction in which the shapes touch.
    ///
    /// The normal of a manifold is the mean of the patches', each weighted by its distance below the
    /// prediction distance. A body in a shallow valley is thus carried vertically.
    pub fn merge(
        &mut self,
        pos12: &Pose,
        prediction: Real,
        out: &mut SmallVec<[ContactManifold; 1]>,
    ) {
        self.merged.clear();
        self.merged.extend(self.list.iter().map(|patch| patch.points.is_empty()));
        while let Some(deepest) = self.deepest_unmerged() {
            let first = self.list[deepest].normal;
            let parts = self.list[self.namesake(deepest)].parts;
            let mut normal = Vector::ZERO;
            self.gathered.clear();
            for (patch, merged) in self.list.iter().zip(&mut self.merged) {
                if !*merged && patch.normal.dot(first) > NORMAL_COSINE_MIN {
                    *merged = true;
                    normal += patch.normal * (prediction - patch.dist);
                    let points = &self.points[patch.points.clone()];
                    self.gathered.extend(points.iter().map(|point| patch.named(point, parts)));
                }
            }
            let normal = normal.normalize_or(first);
            reduce(&mut self.gathered, normal, prediction);
            drop_doubles(&mut self.gathered);
            push_manifold(&self.gathered, normal, parts, pos12, out);
        }
    }

    /// The patch whose parts identify a manifold. Of the patches that will be merged with the deepest, it is
    /// the deepest broad one. If there is none, it is the deepest patch itself. The wall of a step touches
    /// the body at its top edge, but does not continue beneath the body. So it must not identify the support.
    fn namesake(&self, deepest: usize) -> usize {
        let first = &self.list[deepest];
        if first.is_broad {
            return deepest;
        }
        let depth = |index: &usize| self.list[*index].dist;
        let is_with =
            |patch: &Patch| patch.is_broad && patch.normal.dot(first.normal) > NORMAL_COSINE_MIN;
        let is_candidate = |&index: &usize| !self.merged[index] && is_with(&self.list[index]);
        let broad = (0..self.list.len()).filter(is_candidate);
        broad.min_by(|a, b| depth(a).total_cmp(&depth(b))).unwrap_or(deepest)
    }

    fn deepest_unmerged(&self) -> Option<usize> {
        let depth = |index: &usize| self.list[*index].dist;
        let unmerged = (0..self.list.len()).filter(|&index| !self.merged[index]);
        unmerged.min_by(|a, b| depth(a).total_cmp(&depth(b)))
    }
}

/// Leaves one of the points that are the same: parts that meet at a corner all have a point there.
fn drop_doubles(points: &mut Vec<RawPoint>) {
    let Some(first) = points.first().map(|point| point.local_p2) else { return };
    let apart = |point: &RawPoint| point.local_p2.distance_squared(first);
    let spread = points.iter().map(apart).fold(0.0, Real::max);
    let rounding = Real::EPSILON * Real::EPSILON * 1.0e2 * first.length_squared();
    let limit = POINT_DISTANCE_FRACTION_MAX * POINT_DISTANCE_FRACTION_MAX * spread + rounding;
    let mut kept = 0;
    for index in 0..points.len() {
        let place = points[index].local_p2;
        if points[..kept].iter().all(|other| other.local_p2.distance_squared(place) > limit) {
            points.swap(kept, index);
            kept += 1;
        }
    }
    points.truncate(kept);
}

/// The normal, if it is one.
pub(super) fn unit_normal(raw: &RawManifold) -> Option<Vector> {
    let length_squared = raw.local_n1.length_squared();
    // Written so that NaN is refused.
    let is_unit = (length_squared - 1.0).abs() < NORMAL_TOLERANCE;
    is_unit.then(|| raw.local_n1 / length_squared.sqrt())
}

/// Adds a manifold of points, up to the solver's maximum. All in the frames of the shapes.
pub(super) fn push_manifold(
    points: &[RawPoint],
    local_n1: Vector,
    [subshape1, subshape2]: [u32; 2],
    pos12: &Pose,
    out: &mut SmallVec<[ContactManifold; 1]>,
) {
    debug_assert!((local_n1.length_squared() - 1.0).abs() < NORMAL_TOLERANCE, "a unit normal");
    debug_assert!(points.len() <= MAX_MANIFOLD_POINTS, "the caller reduces the points");
    // Filled in place: a manifold is some hundred bytes.
    out.push(ContactManifold::default());
    let Some(manifold) = out.last_mut() else { return };
    manifold.local_n1 = local_n1;
    manifold.local_n2 = pos12.rotation.inverse() * -local_n1;
    manifold.subshape1 = subshape1;
    manifold.subshape2 = subshape2;
    set_contacts(manifold, points);
}
