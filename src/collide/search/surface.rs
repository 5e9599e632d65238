//! Culling of surface parts: most parts whose boxes overlap a body's are far from it.

use super::Search;
use crate::base::wide::{Kernel, LANES, Wide};
use crate::collide::convex::{DISTANCE_FRACTION, is_sound};
use crate::collide::part::Part;
use crate::collide::parts::{Near, Parts};
use crate::collide::polytopes::contacts_on_axis;
use crate::dim::collide::{
    Flat, FlatAxes, FlatBlock, Polytope, RawManifold, TriangleCulling, as_flat,
};
use crate::dim::math::{Pose, Real, Vector};
use crate::dim::wide::WideVector;
use crate::model::contact::TriangleCache;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::shape::Cuboid;
use smallvec::SmallVec;

/// The culling keeps parts within this many times the prediction distance, which is more than rounding
/// errors.
const CULLING_REACH: Real = 1.02;
/// Number of steps of the body's motion that a lookup of parts covers, unless the body moves by more than its
/// size.
const STEPS_AHEAD: Real = 6.0;
/// Margin for motion in other directions, as a fraction of its size.
const MARGIN: Real = 0.05;

/// Pieces of a surface times parts of a body, beyond which the pieces are found in the surface's tree.
const SCANNED_PAIRS_MAX: usize = 1 << 20;

/// Some flat parts: a bit for each of each block.
pub(super) type Bits = SmallVec<[u32; 16]>;

/// Result of the culling of flat parts.
#[derive(Default)]
pub(in crate::collide) struct CulledParts {
    /// Side of the surface.
    pub side: usize,
    /// Parts that remain.
    pub left: Bits,
    /// The pieces of coplanar patches, by the patch number.
    pub patches: Vec<Bits>,
    /// The axes of a block.
    axes: FlatAxes,
}

/// Parts of a surface, and a convex part of the other shape, the body.
pub(super) struct FlatParts<'a> {
    /// Side of the surface.
    pub side: usize,
    pub triangle_cache: &'a TriangleCache,
    pub body: Part<'a>,
    /// The body's pose in the frame of the surface, and the inverse.
    pub poses: [Pose; 2],
}

impl<'a> FlatParts<'a> {
    /// A part of the surface and the body, in the order of the pair.
    pub fn with_body<'b>(&self, part: Part<'b>) -> [Part<'b>; 2]
    where
        'a: 'b,
    {
        if self.side == 0 { [part, self.body] } else { [self.body, part] }
    }
}

impl Search<'_> {
    /// Visits the parts of the surface on a side that are near the other shape.
    ///
    /// Returns whether it did: not if the shape is no surface, or if the other shape is a surface or
    /// unbounded.
    pub(super) fn visit_surface(&mut self, side: usize) -> bool {
        let [surface, body] = [self.parts[side], self.parts[1 - side]];
        let (prediction, pos12) = (self.pair.prediction, self.pair.pos12);
        let poses = if side == 0 { [pos12, pos12.inverse()] } else { [pos12.inverse(), pos12] };
        // The many pieces of another surface find their neighbours faster in the tree than in the cache.
        if !surface.is_surface() || body.is_surface() {
            return false;
        }
        let near = Near::of(body.shape(), &poses[0], prediction);
        let Some(bounds) = near.bounds() else { return false };
        let mut passing = core::mem::take(&mut *self.passing);
        let pair_cache = self.triangle_cache.take();
        let place = pair_cache.map_or(&mut passing, |cache| cache.get_or_insert_default());
        look_up(&surface, &bounds, self.pair.motion_of(1 - side), place);
        // Each part of the body scans the whole cache.
        if is_tree_quicker(place, &body) {
            place.shrink();
            passing.clear();
            *self.passing = passing;
            return false;
        }
        let triangle_cache = &*place;
        self.culled.side = side;
        self.culled.patches.clear();
        if let Parts::Convex(shape) = body {
            let body = Part::whole(shape);
            self.visit_over(&FlatParts { side, triangle_cache, body, poses }, &bounds);
        } else {
            let around = Near::of(surface.shape(), &poses[1], prediction);
            body.for_each_part(&around, &mut |body| {
                let in_shape = body.pose();
                let poses = [poses[0] * in_shape, in_shape.inverse() * poses[1]];
                if let Some(bounds) = Near::of(body.shape, &poses[0], prediction).bounds() {
                    self.visit_over(&FlatParts { side, triangle_cache, body, poses }, &bounds);
                }
            });
        }
        if self.may_have_ghost_contacts(side) {
            self.build_patches(triangle_cache);
        }
        place.shrink();
        passing.clear();
        *self.passing = passing;
        true
    }

    /// Visits the parts of a surface near a body within `bounds`. [Coplanar patches](super::coplanar) are
    /// processed as one, and other parts are culled.
    fn visit_over(&mut self, flat_parts: &FlatParts<'_>, bounds: &Aabb) {
        self.list_left(flat_parts.triangle_cache, bounds);
        if as_flat(flat_parts.body.shape).is_none() {
            self.add_coplanar_contacts(flat_parts);
        }
        self.cull(flat_parts);
    }

    /// Lists the flat parts that reach into a box.
    fn list_left(&mut self, triangle_cache: &TriangleCache, bounds: &Aabb) {
        let blocks = triangle_cache.blocks();
        let left = &mut self.culled.left;
        left.clear();
        left.extend((0..blocks.len()).map(|block| triangle_cache.used(block)));
        self.pair.simd.run(Inside { bounds, blocks, left });
    }

    /// Visits those of the flat parts that are near.
    fn cull(&mut self, flat_parts: &FlatParts<'_>) {
        let around = flat_parts.body.shape.compute_local_aabb();
        let culling_box = TriangleCulling::new(
            &around,
            &flat_parts.poses[1],
            CULLING_REACH * self.pair.prediction,
        );
        // A box without thickness keeps its side as other parts do.
        let cuboid = flat_parts.body.shape.as_cuboid();
        let cuboid = cuboid.filter(|cuboid| cuboid.half_extents.min_element() > 0.0);
        for (index, block) in flat_parts.triangle_cache.blocks().iter().enumerate() {
            let CulledParts { left, axes, .. } = &mut *self.culled;
            if left[index] == 0 {
                continue;
            }
            let near = left[index] & culling_box.near(block, self.pair.simd, axes);
            for lane in (0..LANES).filter(|lane| near & (1 << lane) != 0) {
                let (id, shape) = flat_parts.triangle_cache.piece(index, lane);
                let part = Part { id, ..Part::whole(&shape) };
                match (cuboid, Flat::new(&shape)) {
                    (Some(cuboid), Some(flat)) => {
                        self.visit_box(flat_parts, cuboid, part, &flat, lane);
                    }
                    _ => {
                        let [part1, part2] = flat_parts.with_body(part);
                        self.search(part1, part2);
                    }
                }
            }
        }
    }

    /// Computes the contacts of a flat part with a box. Its axes are those in a lane.
    fn visit_box(
        &mut self,
        flat_parts: &FlatParts<'_>,
        cuboid: &Cuboid,
        part: Part<'_>,
        flat: &Flat,
        lane: usize,
    ) {
        let prediction = self.pair.prediction;
        let [to_box, from_box] = [&flat_parts.poses[1], &flat_parts.poses[0]];
        let (flat, half) = (flat.as_polytope(), cuboid.half_extents);
        let cuboid = Polytope::Cuboid(cuboid);
        let (poses, polytopes) = match flat_parts.side {
            0 => ([from_box, to_box], [&flat, &cuboid]),
            _ => ([to_box, from_box], [&cuboid, &flat]),
        };
        let parts = flat_parts.with_body(part);
        let (hint, axes) = (self.hint(&parts[0], &parts[1]), &self.culled.axes);
        let axis = match flat_parts.side {
            0 => axes.best(lane, half, to_box.rotation * -hint).exchanged(from_box),
            _ => axes.best(lane, half, hint),
        };
        let raw: &mut RawManifold = &mut *self.raw;
        raw.points.clear();
        let gap = contacts_on_axis(poses, polytopes, &axis, prediction, raw);
        raw.points.retain(|point| is_sound(point) && point.dist <= prediction);
        if raw.points.is_empty() {
            self.distance = self.distance.min(gap.max(0.0) * DISTANCE_FRACTION);
        } else {
            self.distance = 0.0;
            self.patches.add(self.pair, raw, &parts);
        }
    }
}

/// Returns whether the tree of a surface is faster than a scan of all pieces around the body.
fn is_tree_quicker(triangle_cache: &TriangleCache, body: &Parts<'_>) -> bool {
    !body.is_convex() && triangle_cache.len().saturating_mul(body.len()) > SCANNED_PAIRS_MAX
}

/// Adds the parts of a surface in a box to the cache if they are missing, and those in the predicted path of
/// the box.
fn look_up(surface: &Parts<'_>, bounds: &Aabb, motion: Vector, triangle_cache: &mut TriangleCache) {
    if triangle_cache.covers(bounds) {
        return;
    }
    triangle_cache.clear();
    let size = bounds.extents().max_element();
    let displacement = (motion * STEPS_AHEAD).clamp_length_max(size);
    let later = Aabb::new(bounds.mins + displacement, bounds.maxs + displacement);
    let (around, margin) = (bounds.merged(&later), Vector::splat(MARGIN * size));
    let region = Aabb::new(around.mins - margin, around.maxs + margin);
    // A body that is very fast, or very far away, uses the current box only.
    let is_wide = region.extents().is_finite() && !triangle_cache.is_crowded();
    let region = if is_wide { region } else { *bounds };
    surface.for_each_flat(&region, |id, flat| triangle_cache.add(id, flat));
    triangle_cache.keep(region);
}

/// Finds the flat parts that reach into a box.
struct Inside<'a> {
    bounds: &'a Aabb,
    blocks: &'a [FlatBlock],
    /// The lanes that are culled.
    left: &'a mut [u32],
}

impl Kernel for Inside<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        let mins = WideVector::<W>::splat(self.bounds.mins);
        let maxs = WideVector::<W>::splat(self.bounds.maxs);
        for (block, left) in self.blocks.iter().zip(self.left) {
            let (mut low, mut high) = (WideVector::load(&block[0]), WideVector::load(&block[0]));
            for corner in &block[1..] {
                let corner = WideVector::load(corner);
                (low, high) = (low.min(corner), high.max(corner));
            }
            *left &= W::bits(low.all_le(maxs) & mins.all_le(high));
        }
    }
}
