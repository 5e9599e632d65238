//! Coplanar patches: a body on a fine mesh costs as much as on a plane.
//!
//! A body that lies on a plane touches it with the corners of one face. If the plane is a mesh, dozens of
//! triangles under the face would be clipped against it. Of all these points only the corners remain after
//! the merge: they are the outermost, and points in between carry nothing more. If every corner is over
//! *some* piece of the plane, the corners are therefore the contacts. The pieces need not be clipped one by
//! one. The area between the corners is irrelevant: other pieces, a hole or a shape above the plane. The
//! latter is in another plane, and processed separately.
//!
//! Only planes that the body touched a moment ago are tried. There is always a first plane, because the first
//! time the pieces *are* processed one by one. On rough ground, without coplanar triangles, there are few
//! failed attempts.
//!
//! If a corner is over the edge of the plane, the pieces under the body determine the contacts, and are
//! clipped as usual. Box3D clusters the clipped points, PhysX and Bullet keep persistent points; either way
//! each triangle is clipped.

use super::Search;
use super::surface::{Bits, FlatParts};
use crate::base::wide::{Kernel, LANES, Wide};
use crate::collide::convex::is_sound;
use crate::collide::part::Part;
use crate::collide::polytopes::OVERLAP_RATIO_MAX;
use crate::collide::support_feature::{SUPPORT_VERTICES_MAX, SupportFeature};
use crate::dim::collide::{Flat, FlatBlock, RawPoint, Rims};
use crate::dim::math::{Real, Vector};
use crate::dim::wide::WideVector;
use crate::model::contact::{ContactManifold, TriangleCache};
use arrayvec::ArrayVec;
use parry::shape::PackedFeatureId;

/// Largest distance of a piece from the plane of its patch, as a fraction of the step height tolerance.
const FLATNESS_TOLERANCE: Real = 0.1;
/// Fewer pieces are tested as quickly one by one.
const PIECES_MIN: u32 = 2;

/// A plane in the frame of the shape that has the parts, its normal towards the body.
#[derive(Copy, Clone)]
struct Plane {
    point: Vector,
    normal: Vector,
}

impl Plane {
    /// The plane of a contact of the shape on a side, in that shape's frame at that time.
    fn of(manifold: &ContactManifold, side: usize) -> Option<Self> {
        let contact = manifold.contacts().first()?;
        Some(match side {
            0 => Self { point: contact.local_p1, normal: manifold.local_n1 },
            _ => Self { point: contact.local_p2, normal: manifold.local_n2 },
        })
    }

    /// The plane of a piece, which has no new rounding error in each step.
    fn of_piece(&self, flat: &Flat) -> Self {
        let normal = flat.normal();
        let is_back = normal.dot(self.normal) < 0.0;
        Self { point: flat.origin(), normal: if is_back { -normal } else { normal } }
    }
}

fn is_several(pieces: &[u32]) -> bool {
    pieces.iter().map(|block| block.count_ones()).sum::<u32>() >= PIECES_MIN
}

/// The corners of the body over pieces of a patch.
#[derive(Default)]
struct SupportedVertices {
    points: ArrayVec<RawPoint, SUPPORT_VERTICES_MAX>,
    /// The deepest: the number of its piece, and the plane's normal there.
    piece: u32,
    normal: Vector,
    dist: Real,
}

impl Search<'_> {
    /// Processes flat parts in one plane under the body as one, and adds its contacts.
    pub(super) fn add_coplanar_contacts(&mut self, flat_parts: &FlatParts<'_>) {
        for last in self.previous {
            let Some((plane, pieces)) = self.patch_of(last, flat_parts) else { continue };
            if let Some(support) = self.supported_vertices(flat_parts, &plane, &pieces) {
                for (left, taken) in self.culled.left.iter_mut().zip(&pieces) {
                    *left &= !taken;
                }
                if self.add_patch(flat_parts, &support) {
                    self.culled.patches.push(pieces);
                }
            }
        }
    }

    /// The plane of a manifold of last time, and the parts that lie in it, if they are several.
    fn patch_of(
        &self,
        last: &ContactManifold,
        flat_parts: &FlatParts<'_>,
    ) -> Option<(Plane, Bits)> {
        let plane = Plane::of(last, flat_parts.side)?;
        let (triangle_cache, step_height_tolerance) =
            (flat_parts.triangle_cache, self.pair.step_height_tolerance);
        // The normal may have been that of the body's own face, which leans a little.
        let nearly = self.parts_in(triangle_cache, &plane, step_height_tolerance);
        let block = nearly.iter().position(|&bits| bits != 0).filter(|_| is_several(&nearly))?;
        let (_, first) = triangle_cache.piece(block, nearly[block].trailing_zeros() as usize);
        let plane = plane.of_piece(&Flat::new(&first)?);
        let pieces =
            self.parts_in(triangle_cache, &plane, FLATNESS_TOLERANCE * step_height_tolerance);
        is_several(&pieces).then_some((plane, pieces))
    }

    /// The flat parts that lie in a plane.
    fn parts_in(&self, triangle_cache: &TriangleCache, plane: &Plane, tolerance: Real) -> Bits {
        let (blocks, left) = (triangle_cache.blocks(), &self.culled.left[..]);
        let mut pieces = Bits::from_elem(0, blocks.len());
        let found = &mut pieces[..];
        self.pair.simd.run(InPlane { plane, tolerance, blocks, left, pieces: found });
        pieces
    }

    /// The supported corners of the body on a patch. `None` if some corner is not over a piece, not near, or
    /// so deep that the body may have come from the side.
    fn supported_vertices(
        &self,
        flat_parts: &FlatParts<'_>,
        plane: &Plane,
        pieces: &[u32],
    ) -> Option<SupportedVertices> {
        let pose = &flat_parts.poses[0];
        let down = pose.rotation.inverse() * -plane.normal;
        let support_feature =
            SupportFeature::of(flat_parts.body.shape, down, self.pair.step_height_tolerance)?;
        let places: ArrayVec<Vector, SUPPORT_VERTICES_MAX> =
            support_feature.vertices.iter().map(|vertex| *pose * vertex.point).collect();
        let mut found = [None; SUPPORT_VERTICES_MAX];
        let blocks = flat_parts.triangle_cache.blocks();
        let (normal, places, found) = (plane.normal, &places[..], &mut found[..places.len()]);
        let tolerance = self.pair.step_height_tolerance;
        self.pair.simd.run(Over { normal, tolerance, blocks, pieces, places, found });
        let mut support =
            SupportedVertices { dist: Real::INFINITY, ..SupportedVertices::default() };
        for ((vertex, place), found) in support_feature.vertices.iter().zip(places).zip(found) {
            let (block, lane) = (*found)?;
            let (piece, shape) = flat_parts.triangle_cache.piece(block, lane);
            let flat = Flat::new(&shape)?;
            let Plane { point, normal } = plane.of_piece(&flat);
            let dist = normal.dot(*place - point);
            let (on_surface, id) = (*place - normal * dist, PackedFeatureId::UNKNOWN);
            let is_second = flat_parts.side == 1;
            let point =
                RawPoint::flipped(on_surface, vertex.point, id, vertex.feature, dist, is_second);
            support.points.push(point);
            if dist < support.dist {
                (support.piece, support.normal, support.dist) = (piece, normal, dist);
            }
        }
        let (dist, prediction) = (support.dist, self.pair.prediction);
        let is_shallow = -dist < prediction.max(OVERLAP_RATIO_MAX * support_feature.thickness);
        (dist <= prediction && is_shallow).then_some(support)
    }

    /// Adds the contacts with a patch, with the part number of the piece under the deepest. Returns whether
    /// they are usable.
    fn add_patch(&mut self, flat_parts: &FlatParts<'_>, support: &SupportedVertices) -> bool {
        let (raw, prediction) = (&mut *self.raw, self.pair.prediction);
        let normals = [support.normal, flat_parts.poses[1].rotation * -support.normal];
        [raw.local_n1, raw.local_n2] =
            if flat_parts.side == 0 { normals } else { [normals[1], normals[0]] };
        raw.points.clear();
        let points = support.points.iter().copied();
        raw.points.extend(points.filter(|point| is_sound(point) && point.dist <= prediction));
        self.distance = 0.0;
        // Only the number of the piece is used: points are in the frame of the shape.
        let piece = Part { id: support.piece, ..Part::whole(flat_parts.body.shape) };
        let patch = self.culled.patches.len() as u32;
        self.patches.add_on(self.pair, raw, &flat_parts.with_body(piece), Some(patch))
    }

    /// Sets the pieces of coplanar patches, which only the internal-edge tests read.
    pub(super) fn build_patches(&mut self, triangle_cache: &TriangleCache) {
        for (patch, pieces) in self.culled.patches.iter().enumerate() {
            let bits = |(block, bits): (usize, &u32)| {
                let bits = *bits;
                let lanes = (0..LANES).filter(move |lane| bits & (1 << lane) != 0);
                lanes.map(move |lane| (block, lane))
            };
            let places = pieces.iter().enumerate().flat_map(bits);
            let shapes = places.map(|(block, lane)| triangle_cache.piece(block, lane).1);
            self.patches.build_patch(patch as u32, shapes);
        }
    }
}

/// Finds the flat shapes that lie in a plane.
struct InPlane<'a> {
    plane: &'a Plane,
    tolerance: Real,
    blocks: &'a [FlatBlock],
    /// The matching lanes of each block.
    left: &'a [u32],
    pieces: &'a mut [u32],
}

impl Kernel for InPlane<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        let Self { plane, tolerance, blocks, left, pieces } = self;
        let (point, normal) =
            (WideVector::<W>::splat(plane.point), WideVector::<W>::splat(plane.normal));
        let tolerance = W::splat(tolerance);
        for index in 0..blocks.len() {
            pieces[index] = left[index];
            for corner in &blocks[index] {
                let height = normal.dot(WideVector::load(corner) - point);
                pieces[index] &= W::bits(height.abs().le(tolerance));
            }
        }
    }
}

/// Finds the piece of a patch below each point.
struct Over<'a> {
    normal: Vector,
    /// Largest distance beyond the edge of a piece that counts as over it.
    tolerance: Real,
    blocks: &'a [FlatBlock],
    pieces: &'a [u32],
    places: &'a [Vector],
    /// Block and lane of the first that a place is over.
    found: &'a mut [Option<(usize, usize)>],
}

impl Kernel for Over<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        let Self { normal, tolerance, blocks, pieces, places, found } = self;
        for block in 0..blocks.len() {
            if pieces[block] == 0 {
                continue;
            }
            let rims = Rims::<W>::of(&blocks[block], normal, tolerance);
            for (place, found) in places.iter().zip(&mut *found) {
                if found.is_some() {
                    continue;
                }
                let over = pieces[block] & W::bits(rims.contain(WideVector::splat(*place)));
                if over != 0 {
                    *found = Some((block, over.trailing_zeros() as usize));
                }
            }
        }
    }
}
