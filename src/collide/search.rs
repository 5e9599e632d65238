//! The search for contacts between the parts of two shapes, and for ghost contacts.

use super::convex::{is_sound, manifold_along, part_manifold};
use super::flat_parts::CulledParts;
use super::internal_edges::{Facet, GhostContact, Piece, find_ghost_contacts};
use super::manifolds::ShapePair;
use super::neighbor::Neighbor;
use super::parts::{Near, Part, Parts};
use super::patches::Patches;
use crate::dim::collide::RawManifold;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::contact::{ContactManifold, TriangleCache};
use smallvec::SmallVec;

/// The search for the contacts of a pair of shapes, one of which has several parts or other contacts.
pub(super) struct Search<'a> {
    pub pair: &'a ShapePair<'a>,
    pub parts: [Parts<'a>; 2],
    pub previous: &'a [ContactManifold],
    pub raw: &'a mut RawManifold,
    pub patches: &'a mut Patches,
    pub culled: &'a mut CulledParts,
    /// Flat parts that are kept from step to step, where there is such a place, and those of the moment.
    pub kept: Option<&'a mut Option<Box<TriangleCache>>>,
    pub passing: &'a mut TriangleCache,
    /// Lower bound of the distance of the parts visited so far.
    pub distance: Real,
    /// Set if there are too many pairs of parts to visit all.
    pub are_parts_culled: &'a mut bool,
}

/// The search for parts that are near each other.
impl Search<'_> {
    /// Visits all pairs of parts that are near each other; returns a bound of the shapes' distance.
    pub fn visit_near(&mut self) -> Real {
        if !(self.visit_surface(0) || self.visit_surface(1)) {
            match self.parts {
                [_, Parts::Convex(_)] => self.visit_parts(0),
                [Parts::Convex(_), _] => self.visit_parts(1),
                _ => self.visit_parts_of_both(),
            }
        }
        // Parts that were not visited are farther than the prediction.
        self.distance.min(self.pair.prediction)
    }

    /// Visits the parts of the shape on a side, the other being convex.
    fn visit_parts(&mut self, side: usize) {
        let (parts, other) = (self.parts[side], self.parts[1 - side].shape());
        let pos12 = self.pair.pos12;
        let pose = if side == 0 { pos12 } else { pos12.inverse() };
        let near = Near::of(other, &pose, self.pair.prediction);
        parts.for_each_part(&near, &mut |part| {
            let other = Part::whole(other);
            let [part1, part2] = if side == 0 { [part, other] } else { [other, part] };
            self.search(part1, part2);
        });
    }

    /// Computes the contacts of two convex parts.
    pub(super) fn search(&mut self, part1: Part<'_>, part2: Part<'_>) {
        let pos12 = self.pose_of_parts(&part1, &part2);
        self.raw.local_n1 = self.hint(&part1, &part2);
        let parts = [part1, part2];
        if let Some(gap) = part_manifold(&pos12, &parts, self.pair.prediction, self.raw) {
            self.distance = self.distance.min(gap);
            if !self.raw.points.is_empty() {
                self.patches.add(self.pair, self.raw, &parts);
            }
        }
    }

    fn pose_of_parts(&self, part1: &Part<'_>, part2: &Part<'_>) -> Pose {
        match (part1.pose, part2.pose) {
            (None, None) => self.pair.pos12,
            _ => part1.pose().inverse() * self.pair.pos12 * part2.pose(),
        }
    }

    /// The last normal of two parts, in the frame of the first part. Flat parts that lie in the plane of a
    /// manifold are part of it.
    pub(super) fn hint(&self, part1: &Part<'_>, part2: &Part<'_>) -> Vector {
        let ids = (part1.id, part2.id);
        let is_same = |m: &&ContactManifold| (m.subshape1, m.subshape2) == ids;
        let is_in_plane = |manifold: &&ContactManifold| {
            if !(part1.wants_hint() && part2.wants_hint()) {
                return false;
            }
            let Some(contact) = manifold.contacts().first() else { return false };
            let step_height_tolerance = self.pair.step_height_tolerance;
            part1.is_flat_in(contact.local_p1, manifold.local_n1, step_height_tolerance)
                || part2.is_flat_in(contact.local_p2, manifold.local_n2, step_height_tolerance)
        };
        let last = self.previous.iter().find(is_same);
        match (last.or_else(|| self.previous.iter().find(is_in_plane)), part1.pose) {
            (Some(manifold), Some(pose)) => pose.rotation.inverse() * manifold.local_n1,
            (Some(manifold), None) => manifold.local_n1,
            (None, _) => Vector::ZERO,
        }
    }
}

/// The search for ghost contacts.
impl Search<'_> {
    /// Removes ghost contacts between parts of the shape on a side, or between these and other non-dynamic
    /// colliders.
    pub fn remove_ghost_contacts(&mut self, side: usize, ghost_contacts: &mut Vec<GhostContact>) {
        if !self.may_have_ghost_contacts(side) {
            return;
        }
        self.find_ghost_contacts(side, ghost_contacts);
        for ghost in &*ghost_contacts {
            self.turn(side, ghost);
        }
    }

    /// Returns whether a contact may be a ghost contact: there are several directions, or other contacts.
    pub(super) fn may_have_ghost_contacts(&self, side: usize) -> bool {
        let neighbors = self.pair.neighbors[1 - side];
        !neighbors.is_empty() || !(self.parts[side].is_convex() || self.patches.look_alike())
    }

    fn find_ghost_contacts(&self, side: usize, ghost_contacts: &mut Vec<GhostContact>) {
        let (pair, patches) = (self.pair, &*self.patches);
        let neighbors = pair.neighbors[1 - side];
        let facets = (0..patches.list().len()).map(|patch| self.facet(side, patch));
        let facets: SmallVec<[Facet<'_>; 16]> =
            facets.chain(neighbors.iter().map(Neighbor::as_facet)).collect();
        let points = |patch: usize, f: &mut dyn FnMut(Vector)| {
            patches.points(patch).iter().for_each(|point| f(pair.on_obstacle(side, point)));
        };
        find_ghost_contacts(
            &facets,
            patches.list().len(),
            &points,
            pair.step_height_tolerance,
            ghost_contacts,
        );
    }

    /// A patch as a contact with the piece on a side, in the frame of the shape on the other.
    fn facet(&self, side: usize, patch: usize) -> Facet<'_> {
        let (pair, patches, index) = (self.pair, &*self.patches, patch);
        let patch = &patches.list()[index];
        let deepest = patches.points(index).iter().min_by(|a, b| a.dist.total_cmp(&b.dist));
        let (normal, pose) = match side {
            0 => (pair.pos12.rotation.inverse() * patch.normal, pair.pos12.inverse()),
            _ => (-patch.normal, pair.pos12),
        };
        // From the other side the roles are exchanged.
        let coplanar_patch = Piece::coplanar_patch(patches.pieces(index), pose);
        let piece = coplanar_patch
            .filter(|_| side == self.culled.side)
            .unwrap_or_else(|| Piece::new(self.parts[side], patch.parts[side], pose));
        let place = deepest.map_or(Vector::ZERO, |point| pair.on_obstacle(side, point));
        let body = (self.parts[1 - side], patch.parts[1 - side]);
        Facet::new(piece, body, normal, place, patch.dist)
    }

    /// Recomputes a patch along the normal with which its piece may still support the body.
    fn turn(&mut self, side: usize, ghost: &GhostContact) {
        let GhostContact { index, along, .. } = *ghost;
        if ghost.is_turned {
            let points = self.patches.points(index);
            if points.iter().any(|point| point.dist < ghost.least_dist) {
                self.patches.empty(index);
            }
            return;
        }
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
                is_too_deep = raw.points.iter().any(|point| point.dist < ghost.least_dist);
                is_carried = !raw.points.is_empty()
                    && !is_too_deep
                    && self.patches.replace(index, self.pair, raw, &[part1, part2]);
            });
        });
        // An edge that seemed hidden, and is not.
        let stays = is_too_deep && !ghost.is_behind;
        if !is_carried && !stays {
            self.patches.empty(index);
        }
    }
}
