//! The search for ghost contacts.

use super::Search;
use crate::collide::convex::{is_sound, manifold_along};
use crate::collide::internal_edges::{Facet, GhostContact, Piece, find_ghost_contacts};
use crate::collide::neighbor::Neighbor;
use crate::dim::math::Vector;
use smallvec::SmallVec;

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
        !neighbors.is_empty()
            || !(self.parts[side].is_convex() || self.patches.have_similar_normals())
    }

    fn find_ghost_contacts(&self, side: usize, ghost_contacts: &mut Vec<GhostContact>) {
        let (pair, patches) = (self.pair, &*self.patches);
        let neighbors = pair.neighbors[1 - side];
        let facets = (0..patches.list().len()).map(|patch| self.facet(side, patch));
        let facets: SmallVec<[Facet<'_>; 16]> =
            facets.chain(neighbors.iter().map(Neighbor::as_facet)).collect();
        let points = |patch: usize, f: &mut dyn FnMut(Vector)| {
            patches.points(patch).iter().for_each(|point| f(pair.in_other_frame(side, point)));
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
        let place = deepest.map_or(Vector::ZERO, |point| pair.in_other_frame(side, point));
        let (body, body_part) = (self.parts[1 - side], patch.parts[1 - side]);
        Facet::new(piece, body, body_part, normal, place, patch.dist)
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
