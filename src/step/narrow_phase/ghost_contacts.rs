//! Ghost contacts between colliders: contacts that other colliders contradict.
//!
//! Pairs are computed without knowledge of each other. A body that slides over tiles, each of them a
//! collider, seems to meet the next tile from the side. Only the contact with the tile beneath it shows that
//! there is no side. The stage therefore compares all contacts of each body with non-dynamic colliders. Pairs
//! with ghost contacts (see [`crate::collide`]) are computed again, with the other contacts as [`Neighbor`]s.
//!
//! Contacts between dynamic bodies are not compared. Bodies in a pile meet internal edges between dynamic
//! bodies, but level edges rarely persist. A comparison of all their contacts costs more than it gives.

use super::update::{NarrowPhaseContext, Outcome, Worker};
use super::view::PairView;
use crate::base::disjoint::DisjointMut;
use crate::base::pool::Pool;
use crate::base::tasks::Tasks;
use crate::collide::{NORMAL_DISTANCE_SQUARED_MAX, Neighbor, ghost_contacts_among};
use crate::dim::math::Real;
use crate::model::body::RigidBody;
use crate::model::collider::Collider;
use crate::model::contact::{ContactPair, PairId, PairStore, StoreParts};
use core::ops::Range;
use smallvec::SmallVec;

/// Number of bodies per parallel task.
const BODIES_PER_TASK: usize = 8;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(super) struct GhostContactScratch {
    /// Slots of colliders that touch a non-dynamic collider, with the pair's position in the list of due
    /// pairs; sorted.
    touching: Vec<(u32, u32)>,
    /// The pairs of one collider each, as ranges of that list.
    groups: Vec<Range<usize>>,
}

/// The pairs that were computed in this step.
pub(super) struct Computed<'a> {
    /// Their ids.
    pub due: &'a [PairId],
    /// Result for each of them.
    pub outcomes: &'a mut [Outcome],
}

/// Side of the non-dynamic collider of a pair.
pub(super) fn non_dynamic_side(view: &PairView<'_>) -> Option<usize> {
    match view.bodies.map(|body| body.is_some_and(RigidBody::is_dynamic)) {
        [false, true] => Some(0),
        [true, false] => Some(1),
        _ => None,
    }
}

/// Recomputes pairs that have ghost contacts between non-dynamic colliders.
pub(super) fn filter_ghost_contacts(
    tasks: Tasks<'_>,
    context: NarrowPhaseContext<'_>,
    store: &mut PairStore<ContactPair>,
    computed: Computed<'_>,
    scratch: &mut GhostContactScratch,
    workers: &Pool<Worker>,
) {
    scratch.group(store, &computed);
    let GhostContactScratch { touching, groups } = &*scratch;
    let Computed { due, outcomes } = computed;
    let StoreParts { of_collider, states, pairs, .. } = store.split();
    let states = &*states;
    let (pairs, outcomes) = (DisjointMut::new(pairs), DisjointMut::new(outcomes));
    tasks.par_for(groups.len(), BODIES_PER_TASK, |range| {
        let mut worker = workers.take();
        for group in &groups[range] {
            let members = &touching[group.clone()];
            let ids = of_collider[members[0].0 as usize].ids.iter().copied();
            let ids = ids.filter(|&id| states[id as usize].touched_non_dynamic);
            // SAFETY: a pair of a dynamic and a non-dynamic collider belongs to the group of the dynamic one
            // alone. Pairs of two dynamic bodies belong to no group.
            let pair = |id: PairId| unsafe { pairs.get(id as usize).as_ref() };
            let pairs_of_body = ids.clone().filter_map(|id| Some((id, pair(id)?)));
            if have_similar_normals(context, members[0].0, pairs_of_body) {
                continue;
            }
            let mut contacts = Contacts::default();
            for id in ids {
                let Some((side, view)) = pair(id).and_then(|pair| with_non_dynamic(context, pair))
                else {
                    continue;
                };
                // SAFETY: as above, this is a pair of a dynamic and a non-dynamic collider.
                let Some(pair) = (unsafe { pairs.get_mut(id as usize) }) else { continue };
                context.lanes.write_back(id, pair);
                contacts.add(id, pair, side, &view);
            }
            contacts.remove_ghost_contacts(context.params.allowed_linear_error());
            for &(_, index) in members {
                let id = due[index as usize];
                if !contacts.ghost_contacts.contains(&id) {
                    continue;
                }
                // SAFETY: as above, and the members of all groups have different outcomes.
                let (pair, outcome) =
                    unsafe { (pairs.get_mut(id as usize), outcomes.get_mut(index as usize)) };
                let Some(pair) = pair else { continue };
                *outcome = contacts.recompute(context, id, pair, &mut worker).unwrap_or(*outcome);
            }
        }
        workers.put(worker);
    });
}

/// Returns whether all contacts of the collider in a slot push it in the same direction. In that case none is
/// a ghost contact.
fn have_similar_normals<'a>(
    context: NarrowPhaseContext<'_>,
    slot: u32,
    pairs: impl Iterator<Item = (PairId, &'a ContactPair)>,
) -> bool {
    let mut first = None;
    for (id, pair) in pairs {
        let is_second = pair.collider2.into_raw_parts().0 == slot;
        let manifolds = pair.manifolds.iter().enumerate();
        for (index, manifold) in manifolds.filter(|(_, manifold)| manifold.is_solved()) {
            let normal = context.lanes.normal_of(id, index, manifold);
            let normal = normal * if is_second { 1.0 } else { -1.0 };
            if normal.distance_squared(*first.get_or_insert(normal)) > NORMAL_DISTANCE_SQUARED_MAX {
                return false;
            }
        }
    }
    true
}

impl GhostContactScratch {
    /// Lists the contacts of bodies that may touch several non-dynamic colliders.
    fn group(&mut self, store: &mut PairStore<ContactPair>, computed: &Computed<'_>) {
        let Self { touching, groups } = self;
        touching.clear();
        groups.clear();
        for (index, outcome) in computed.outcomes.iter().enumerate() {
            let Some(side) = outcome.non_dynamic_side else { continue };
            let id = computed.due[index];
            store.state_mut(id).touched_non_dynamic = true;
            let body = store.collider_slots(id)[1 - side];
            if store.ids_of(body).len() > 1 {
                touching.push((body, index as u32));
            }
        }
        touching.sort_unstable();
        let mut start = 0;
        for group in touching.chunk_by(|a, b| a.0 == b.0) {
            groups.push(start..start + group.len());
            start += group.len();
        }
    }
}

/// Side of the non-dynamic collider of a touching pair, if it has one.
fn with_non_dynamic<'a>(
    context: NarrowPhaseContext<'a>,
    pair: &ContactPair,
) -> Option<(usize, PairView<'a>)> {
    let view = PairView::of(context, [pair.collider1, pair.collider2]);
    let view = view.filter(|_| pair.is_touching())?;
    Some((non_dynamic_side(&view)?, view))
}

/// The contacts of one collider with non-dynamic colliders.
#[derive(Default)]
struct Contacts<'a> {
    /// The contacts without the ghost contacts.
    list: SmallVec<[Neighbor<'a>; 8]>,
    /// The pairs that they are of.
    pairs: SmallVec<[PairId; 8]>,
    /// The pairs with ghost contacts.
    ghost_contacts: SmallVec<[PairId; 8]>,
}

impl<'a> Contacts<'a> {
    /// Adds the contacts of a pair whose non-dynamic collider is on this side.
    fn add(&mut self, id: PairId, pair: &ContactPair, side: usize, view: &PairView<'a>) {
        let pose = if side == 0 { view.pose12.inverse() } else { view.pose12 };
        let shapes = view.colliders.map(Collider::shape);
        for manifold in pair.manifolds.iter().filter(|manifold| manifold.is_solved()) {
            if let Some(contact) = Neighbor::of(manifold, side, shapes, pose) {
                self.list.push(contact);
                self.pairs.push(id);
            }
        }
    }

    /// Removes ghost contacts, and notes their pairs.
    fn remove_ghost_contacts(&mut self, step_height_tolerance: Real) {
        let several = self.pairs.iter().any(|id| *id != self.pairs[0]);
        if !several {
            return;
        }
        // The order is from behind, so that the other positions stay valid.
        let mut ghost_contacts = ghost_contacts_among(&self.list, step_height_tolerance);
        ghost_contacts.sort_unstable();
        for index in ghost_contacts.into_iter().rev() {
            self.list.remove(index);
            self.ghost_contacts.push(self.pairs.remove(index));
        }
    }

    /// Computes a pair with the contacts of the other pairs.
    fn recompute(
        &self,
        context: NarrowPhaseContext<'_>,
        id: PairId,
        pair: &mut ContactPair,
        worker: &mut Worker,
    ) -> Option<Outcome> {
        let view = PairView::of(context, [pair.collider1, pair.collider2])?;
        let side = non_dynamic_side(&view)?;
        let others = self.list.iter().zip(&self.pairs).filter(|(_, of)| **of != id);
        let others: SmallVec<[Neighbor<'_>; 8]> = others.map(|(other, _)| other.clone()).collect();
        let mut neighbors: [&[Neighbor<'_>]; 2] = [&[], &[]];
        neighbors[1 - side] = &others;
        Some(pair.renew(&view, neighbors, worker))
    }
}
