//! The neighbours of one collider.

use super::borne::{Borne, HandlePair};
use super::{COLLIDERS_PER_TASK, KnownPairs, TURNS_AHEAD};
use crate::base::marks::Marks;
use crate::base::pool::Pool;
use crate::base::tasks::Tasks;
use crate::base::wide::prefetch;
use crate::model::collider::{Collider, ColliderHandle, ColliderSet, may_interact};
use crate::model::tree::{BroadPhaseBvh, TreeKind};

/// What one thread found.
#[derive(Default)]
pub(super) struct Finds {
    pub pairs: Vec<HandlePair>,
    /// Colliders that did not move, and have so many pairs already that they must say themselves whether they bear more.
    pub late: Vec<u32>,
    /// Colliders that would have to bear more pairs than they may.
    pub refused: Vec<u32>,
    /// The pairs that one collider would have to bear: with larger ones, and with those of its size.
    borne: [Borne; 2],
    /// Who has a pair with it already.
    known: Marks,
}

/// Where to look, and for what.
pub(super) struct Search<'a, K> {
    pub tree: &'a BroadPhaseBvh,
    pub colliders: &'a ColliderSet,
    pub known: &'a K,
    /// How many pairs a collider bears.
    pub most: usize,
    /// Look only for pairs that the collider who looks would have to bear?
    pub only_borne: bool,
}

/// Who looks for neighbours.
#[derive(Copy, Clone)]
struct Seeker<'a> {
    slot: u32,
    handle: ColliderHandle,
    collider: &'a Collider,
    kind: TreeKind,
}

impl<K: KnownPairs> Search<'_, K> {
    /// Lets the colliders at these slots look for neighbours.
    pub fn run(&self, tasks: Tasks<'_>, slots: &[u32], finds: &Pool<Finds>) {
        tasks.par_for(slots.len(), COLLIDERS_PER_TASK, |range| {
            let mut found = finds.take();
            for position in range {
                self.prefetch(slots.get(position + TURNS_AHEAD));
                let slot = slots[position];
                // The collider may be gone since it moved, or disabled.
                let Some((handle, collider)) = self.colliders.at_slot(slot) else { continue };
                let Some(kind) = collider.proxy.tree else { continue };
                if !self.tree.may_meet_any(collider.collision_groups()) {
                    continue;
                }
                self.look_around(Seeker { slot, handle, collider, kind }, &mut found);
            }
            finds.put(found);
        });
    }

    /// Asks for what the search of a collider begins with.
    #[inline]
    fn prefetch(&self, slot: Option<&u32>) {
        let Some(&slot) = slot else { return };
        self.colliders.prefetch(slot);
        self.known.partners(slot).first().into_iter().for_each(prefetch);
    }

    /// Adds the new pairs of one collider. Nearly all that it finds are old ones.
    fn look_around(&self, seeker: Seeker<'_>, found: &mut Finds) {
        found.borne.iter_mut().for_each(|borne| borne.clear(self.most));
        found.known.clear();
        let partners = self.known.partners(seeker.slot);
        let all = partners.iter().chain(self.known.sensed(seeker.slot));
        all.for_each(|&slot| found.known.mark(slot));
        found.known.mark(seeker.slot);
        for other_kind in TreeKind::ALL {
            if !self.tree.may_meet(seeker.kind, other_kind) {
                continue;
            }
            let is_movable = seeker.kind.is_movable() && other_kind.is_movable();
            self.tree.for_each_overlapping(other_kind, &seeker.collider.proxy.fat_aabb, |other| {
                if !found.known.has(other) {
                    self.meet(seeker, other, is_movable, found);
                }
            });
        }
        let mut is_crowded = false;
        for (is_alike, borne) in [false, true].into_iter().zip(&mut found.borne) {
            let mut places = self.most;
            if borne.len() > 0 && partners.len() + borne.len() > self.most {
                places -= self.count_borne(seeker.slot, is_alike).min(places);
            }
            is_crowded |= borne.len() > places;
            found.pairs.extend(borne.nearest(places));
        }
        if is_crowded {
            found.refused.push(seeker.slot);
        }
    }

    /// Adds a new pair with the collider at another slot, if the two are to be one.
    #[inline]
    fn meet(&self, seeker: Seeker<'_>, other_slot: u32, is_movable: bool, found: &mut Finds) {
        let Seeker { slot, handle, collider, .. } = seeker;
        let bears = self.tree.bears(slot, other_slot);
        // Of two that moved, each finds the other.
        if !bears && (self.only_borne || self.tree.is_moved(other_slot)) {
            return;
        }
        let borne = &mut found.borne[usize::from(self.are_alike(slot, other_slot))];
        let remoteness = slot.abs_diff(other_slot);
        // Pairs with sensors are not counted, and must not be left out.
        let may_leave_out = is_movable && !self.tree.has_sensors();
        if bears && may_leave_out && borne.leaves_out(remoteness) {
            return;
        }
        let Some((other_handle, other)) = self.colliders.at_slot(other_slot) else { return };
        if !may_interact(collider, other) {
            return;
        }
        let pair = if slot < other_slot { (handle, other_handle) } else { (other_handle, handle) };
        let is_counted = is_movable && !collider.is_sensor() && !other.is_sensor();
        if self.only_borne && !is_counted {
            // What is new here has moved, and has found the pair in the first search.
            return;
        }
        if is_counted && bears {
            borne.push(remoteness, pair);
        } else if is_counted && self.known.partners(other_slot).len() >= self.most {
            found.late.push(other_slot);
        } else {
            found.pairs.push(pair);
        }
    }

    fn are_alike(&self, slot: u32, other_slot: u32) -> bool {
        self.tree.size(slot) == self.tree.size(other_slot)
    }

    /// How many pairs of one kind the collider at a slot bears already.
    fn count_borne(&self, slot: u32, alike: bool) -> usize {
        let is_movable = |other: u32| {
            let other = self.colliders.at_slot(other);
            other.is_some_and(|(_, other)| other.proxy.tree.is_some_and(TreeKind::is_movable))
        };
        let borne = |&other: &u32| {
            self.tree.bears(slot, other)
                && self.are_alike(slot, other) == alike
                && is_movable(other)
        };
        self.known.partners(slot).iter().copied().filter(borne).count()
    }
}
