//! The search for contacts between the parts of two shapes.
//!
//! Pieces of a [`surface`] are culled together, and [`coplanar`] pieces are processed as one patch. Two
//! shapes with many parts are searched pair by pair ([`part_pairs`]). Last, [`ghost_contacts`] are removed.

mod coplanar;
mod ghost_contacts;
mod part_pairs;
mod surface;

use super::convex::part_manifold;
use super::pair::ShapePair;
use super::part::Part;
use super::parts::{Near, Parts};
use super::patches::Patches;
use crate::dim::collide::RawManifold;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::contact::{ContactManifold, TriangleCache};
pub(super) use surface::CulledParts;

/// The search for the contacts of a pair of shapes, one of which has several parts or other contacts.
pub(super) struct Search<'a> {
    pub pair: &'a ShapePair<'a>,
    pub parts: [Parts<'a>; 2],
    pub previous: &'a [ContactManifold],
    pub raw: &'a mut RawManifold,
    pub patches: &'a mut Patches,
    pub culled: &'a mut CulledParts,
    /// The triangle cache of the pair, which persists from step to step, if the pair has one.
    pub triangle_cache: Option<&'a mut Option<Box<TriangleCache>>>,
    /// The triangle cache of this search, for a pair without one.
    pub passing: &'a mut TriangleCache,
    /// Lower bound of the distance of the parts visited so far.
    pub distance: Real,
    /// Set if there are too many pairs of parts to visit all.
    pub are_parts_culled: &'a mut bool,
}

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
    fn search(&mut self, part1: Part<'_>, part2: Part<'_>) {
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
    fn hint(&self, part1: &Part<'_>, part2: &Part<'_>) -> Vector {
        let ids = (part1.id, part2.id);
        let is_same = |m: &&ContactManifold| (m.subshape1, m.subshape2) == ids;
        let is_in_plane = |manifold: &&ContactManifold| {
            if !(part1.uses_plane_normal() && part2.uses_plane_normal()) {
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
