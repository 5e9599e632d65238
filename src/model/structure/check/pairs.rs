//! Pairs, and the manifolds of contact pairs.

use super::colors::Colors;
use super::last_step::{LastStep, Parent};
use super::{Depth, Structure, Verdict};
use crate::base::fault::ensure;
use crate::model::body::RigidBodyChanges;
use crate::model::collider::{Collider, ColliderChanges, ColliderHandle, may_interact};
use crate::model::constraint_graph::ManifoldRef;
use crate::model::contact::{NarrowPhase, PairId};
use crate::model::island::NONE;

impl Structure<'_> {
    /// A pair is awake if one of its bodies is. The bodies of an attached one are in one island, and its
    /// manifolds have colours while one of them is awake.
    pub(super) fn check_contacts(&self, then: &LastStep<'_>, depth: Depth) -> Verdict {
        let contacts = &self.narrow_phase.contacts;
        let mut colors = Colors::of(&self.islands.graph, depth)?;
        for id in contacts.ids() {
            let (pair, slots) = (&contacts[id], contacts.bodies(id));
            self.check_sides(then, [pair.collider1, pair.collider2], slots)?;
            let is_parted = self.islands.part(slots[0], slots[1]);
            ensure!(!is_parted, "pair {id} is of bodies {slots:?}, which do not collide");
            let awake = slots.iter().any(|&slot| then.is_awake(slot));
            ensure!(
                contacts.is_awake(id) == awake,
                "pair {id} of bodies {slots:?} is awake: {awake}"
            );
            let dynamic = then.dynamic(slots);
            if let ([Some(slot1), Some(slot2)], true) = (dynamic, pair.attached) {
                let islands = [slot1, slot2].map(|slot| then.link(slot).island);
                ensure!(islands[0] == islands[1], "bodies {slots:?} touch, of islands {islands:?}");
            }
            let is_active =
                pair.attached && dynamic.iter().flatten().any(|&slot| then.is_awake(slot));
            for (index, manifold) in pair.manifolds.iter().enumerate() {
                let here = ManifoldRef { pair: id, manifold: index as u32 };
                let is_solved = is_active && manifold.is_solved();
                colors.check(here, manifold.slot, is_solved, slots, then)?;
            }
        }
        colors.finish()
    }

    pub(super) fn check_intersections(&self, then: &LastStep<'_>) -> Verdict {
        let intersections = &self.narrow_phase.intersections;
        intersections.ids().try_for_each(|id| {
            let pair = &intersections[id];
            self.check_sides(then, [pair.collider1, pair.collider2], intersections.bodies(id))
        })
    }

    /// A pair names the bodies of its colliders, and they are two.
    fn check_sides(
        &self,
        then: &LastStep<'_>,
        colliders: [ColliderHandle; 2],
        slots: [u32; 2],
    ) -> Verdict {
        for (handle, slot) in colliders.into_iter().zip(slots) {
            ensure!(then.has_slot(slot), "a pair of {handle:?} is of body {slot}");
            match then.parent(self, handle) {
                Parent::Slot(parent) => {
                    ensure!(parent == slot, "{handle:?} is part of body {parent}, not {slot}");
                }
                Parent::Changed => {}
                Parent::Missing => ensure!(false, "{handle:?} of a pair is gone"),
            }
        }
        ensure!(slots[0] != slots[1] || slots[0] == NONE, "a pair is of body {} alone", slots[0]);
        Ok(())
    }

    /// The colliders of a pair may meet, unless the user changed that since: the next step removes such
    /// pairs. Sensors have intersection pairs, and no other colliders.
    pub(super) fn check_partners(&self) -> Verdict {
        let NarrowPhase { contacts, intersections, .. } = &*self.narrow_phase;
        for pair in contacts.iter() {
            self.check_partner_pair([pair.collider1, pair.collider2], false)?;
        }
        for pair in intersections.iter() {
            self.check_partner_pair([pair.collider1, pair.collider2], true)?;
        }
        Ok(())
    }

    fn check_partner_pair(&self, handles: [ColliderHandle; 2], is_sensed: bool) -> Verdict {
        let [Some(one), Some(two)] = handles.map(|handle| self.colliders.get(handle)) else {
            return Ok(());
        };
        if [one, two].into_iter().any(|collider| self.may_change_partners(collider)) {
            return Ok(());
        }
        ensure!(may_interact(one, two), "{handles:?} are a pair and may not meet");
        let has_sensor = one.is_sensor() || two.is_sensor();
        ensure!(has_sensor == is_sensed, "{handles:?} are a pair, with a sensor: {has_sensor}");
        Ok(())
    }

    /// Returns whether a pending edit affects the possible partners of a collider.
    fn may_change_partners(&self, collider: &Collider) -> bool {
        let body = collider.parent().and_then(|parent| self.bodies.get(parent));
        collider.changes.intersects(ColliderChanges::PARTNER_CHANGES)
            || body.is_some_and(|body| body.changes.intersects(RigidBodyChanges::KIND))
    }

    /// The numbers of contact pairs can be computed with.
    pub(super) fn check_contact_data(&self) -> Verdict {
        let contacts = &self.narrow_phase.contacts;
        contacts.ids().try_for_each(|id| self.check_contact(id))
    }

    fn check_contact(&self, id: PairId) -> Verdict {
        let contacts = &self.narrow_phase.contacts;
        let pair = &contacts[id];
        let slack = contacts.slack(id);
        ensure!(!slack.is_nan(), "pair {id} has the slack {slack}");
        ensure!(pair.is_sound(), "pair {id} has invalid numbers: {pair:?}");
        let bodies = [pair.collider1, pair.collider2]
            .map(|handle| self.colliders.get(handle).map(|collider| collider.parent()));
        for manifold in &pair.manifolds {
            let named = [manifold.data.rigid_body1, manifold.data.rigid_body2];
            let slots = named.map(|body| body.map_or(NONE, |body| body.into_raw_parts().0));
            let agrees = |side: usize| bodies[side].is_none_or(|body| body == named[side]);
            let is_of_pair = slots == contacts.bodies(id);
            ensure!(is_of_pair || agrees(0) && agrees(1), "pair {id} is of bodies {named:?}");
        }
        Ok(())
    }
}
