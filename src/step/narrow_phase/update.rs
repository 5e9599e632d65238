//! Due pairs, and their update.

use super::faults;
use super::ghost_contacts::{Computed, GhostContactScratch};
use super::view::PairView;
use crate::base::disjoint::DisjointMut;
use crate::base::pool::Pool;
use crate::base::tasks::{Gather, Tasks};
use crate::base::wide::{Simd, prefetch};
use crate::collide::ManifoldScratch;
use crate::dim::math::Real;
use crate::model::body::{QuarantineCause, RigidBodyHandle, RigidBodySet};
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::{
    ContactLanes, ContactManifold, ContactPair, IntersectionPair, Pair, PairId, PairState,
    PairStore, SLACK_DUE, StoreParts,
};
use crate::model::hooks::PhysicsHooks;
use crate::model::island::IslandManager;
use crate::model::params::IntegrationParameters;
use crate::step::notes::{PairChange, StepNotes};
use core::ops::Range;
use smallvec::SmallVec;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// Number of pairs per parallel task.
const PAIRS_PER_TASK: usize = 16;
/// Number of outcomes per parallel task.
const OUTCOMES_PER_TASK: usize = 512;

/// Prefetch distance of the update, in list positions.
const PAIR_PREFETCH_DISTANCE: usize = 2;
/// Prefetch distance where outcomes are stored, with no other work per list position.
const SLOT_PREFETCH_DISTANCE: usize = 32;

/// Context of the narrow phase.
#[derive(Copy, Clone)]
pub(crate) struct NarrowPhaseContext<'a> {
    pub bodies: &'a RigidBodySet,
    pub colliders: &'a ColliderSet,
    pub islands: &'a IslandManager,
    /// Impulses of the last step that are not written back yet.
    pub lanes: &'a ContactLanes,
    pub params: &'a IntegrationParameters,
    pub hooks: &'a dyn PhysicsHooks,
    /// The instructions that kernels run on.
    pub simd: Simd,
}

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct NarrowPhaseScratch {
    due: Vec<PairId>,
    gather_due: Gather<PairId>,
    outcomes: Vec<Outcome>,
    changes: Vec<Change>,
    gather_changes: Gather<Change>,
    /// One for each task that runs at the same time.
    workers: Pool<Worker>,
    ghost_contacts: GhostContactScratch,
    culled: Culled,
}

/// Pairs that touch in so many places that only some contacts were taken.
#[derive(Default)]
struct Culled {
    pairs: Vec<[ColliderHandle; 2]>,
    /// Whether the log already contains the warning.
    has_warned: bool,
}

impl Culled {
    /// Collects the pairs from all workers. A pair that was computed twice counts once.
    fn gather(&mut self, workers: &mut Pool<Worker>) {
        self.pairs.clear();
        workers.for_each(|worker| self.pairs.append(&mut worker.culled));
        self.pairs.sort_unstable();
        self.pairs.dedup();
        if let (Some([one, two]), false) = (self.pairs.first(), self.has_warned) {
            self.has_warned = true;
            log::warn!(
                "colliders {one:?} and {two:?} touch in thousands of places: the deepest contacts of each region are kept \
                 (`counters.cd.nculled_pairs` counts such pairs)"
            );
        }
    }
}

/// A pair that changed, after the slots of its colliders.
type Change = ([u32; 2], PairId, PairChange);

/// Buffers of one thread for the computation of manifolds.
#[derive(Default)]
pub(super) struct Worker {
    pub scratch: ManifoldScratch,
    pub fresh: SmallVec<[ContactManifold; 1]>,
    /// Pairs with impossible numbers.
    pub faults: Vec<([ColliderHandle; 2], QuarantineCause)>,
    /// Bodies that are deep in something.
    pub deeply_penetrating: Vec<RigidBodyHandle>,
    /// Pairs that touch in so many places that only some were taken.
    pub culled: Vec<[ColliderHandle; 2]>,
}

/// Result for one pair.
#[derive(Copy, Clone, Debug)]
pub(super) struct Outcome {
    pub change: Option<PairChange>,
    pub slack: Real,
    /// Whether events of strong contact forces are enabled.
    pub reports_force: bool,
    /// Whether any input of the solver changed.
    pub is_renewed: bool,
    /// Side of the non-dynamic collider, if contacts with it were computed.
    pub non_dynamic_side: Option<usize>,
}

impl Outcome {
    /// The pair is as it was, and stays so for this far.
    pub const fn unchanged(slack: Real, reports_force: bool) -> Self {
        Self { change: None, slack, reports_force, is_renewed: false, non_dynamic_side: None }
    }

    /// The boxes no longer overlap.
    pub const APART: Self =
        Self { change: Some(PairChange::Apart), ..Self::unchanged(SLACK_DUE, false) };
}

/// Brings all awake pairs up to date. Returns the number of contact pairs that touch in so many places that
/// only some were taken.
pub(crate) fn update(
    tasks: Tasks<'_>,
    context: NarrowPhaseContext<'_>,
    contacts: &mut PairStore<ContactPair>,
    intersections: &mut PairStore<IntersectionPair>,
    scratch: &mut NarrowPhaseScratch,
    notes: &mut StepNotes,
) -> usize {
    let work = AssertUnwindSafe(|| {
        update_store(tasks, context, contacts, scratch, &mut notes.contacts);
        update_store(tasks, context, intersections, scratch, &mut notes.intersections);
    });
    let outcome = catch_unwind(work);
    faults::report(&mut scratch.workers, &mut notes.quarantined);
    scratch
        .workers
        .for_each(|worker| notes.deeply_penetrating.append(&mut worker.deeply_penetrating));
    scratch.culled.gather(&mut scratch.workers);
    if let Err(panic) = outcome {
        // A hook did that. Some pairs are up to date, and their result is lost: all are due again.
        contacts.invalidate_all();
        contacts.renew_all();
        intersections.invalidate_all();
        resume_unwind(panic);
    }
    scratch.culled.pairs.len()
}

/// A kind of pair, and how it is computed.
pub(super) trait Update: Pair + Sized + Send + Sync {
    fn update(
        &mut self,
        id: PairId,
        view: &PairView<'_>,
        last: Outcome,
        worker: &mut Worker,
    ) -> Outcome;

    /// Goes over the pairs that were computed once all of them are known.
    fn filter_ghost_contacts(
        _tasks: Tasks<'_>,
        _context: NarrowPhaseContext<'_>,
        _store: &mut PairStore<Self>,
        _computed: Computed<'_>,
        _scratch: &mut GhostContactScratch,
        _workers: &Pool<Worker>,
    ) {
    }
}

fn update_store<P: Update>(
    tasks: Tasks<'_>,
    context: NarrowPhaseContext<'_>,
    store: &mut PairStore<P>,
    scratch: &mut NarrowPhaseScratch,
    notes: &mut Vec<(PairId, PairChange)>,
) {
    let NarrowPhaseScratch {
        due,
        gather_due,
        outcomes,
        changes,
        gather_changes,
        workers,
        ghost_contacts,
        ..
    } = scratch;
    list_due(tasks, context, store, gather_due, due);
    outcomes.clear();
    outcomes.resize(due.len(), Outcome::APART);
    update_due_pairs(tasks, context, store, due, outcomes, workers);
    P::filter_ghost_contacts(
        tasks,
        context,
        store,
        Computed { due, outcomes },
        ghost_contacts,
        workers,
    );
    changes.clear();
    apply(tasks, store, Computed { due, outcomes }, gather_changes, changes);
    // The free ids depend on all pairs of the world. Colours are assigned in the order of the notes, and
    // remote events must not change them.
    changes.sort_unstable_by_key(|&(slots, ..)| slots);
    notes.extend(changes.iter().map(|&(_, id, change)| (id, change)));
}

/// Lists the awake pairs whose slack is used up.
fn list_due<P: Pair>(
    tasks: Tasks<'_>,
    context: NarrowPhaseContext<'_>,
    store: &mut PairStore<P>,
    gather: &mut Gather<PairId>,
    due: &mut Vec<PairId>,
) {
    due.clear();
    let is_due = |state: &mut PairState| {
        let [body1, body2] = state.bodies;
        state.slack -= context.islands.motion_of(body1).against(context.islands.motion_of(body2));
        // The difference of two infinite displacements is NaN.
        state.slack < 0.0 || state.slack.is_nan()
    };
    store.list_awake(tasks, gather, is_due, due);
}

/// Updates each due pair independently.
fn update_due_pairs<P: Update>(
    tasks: Tasks<'_>,
    context: NarrowPhaseContext<'_>,
    store: &mut PairStore<P>,
    due: &[PairId],
    outcomes: &mut [Outcome],
    workers: &Pool<Worker>,
) {
    let StoreParts { states, pairs, reporting, .. } = store.split();
    let states = &*states;
    let (results, pairs) = (DisjointMut::new(outcomes), DisjointMut::new(pairs));
    tasks.par_for(due.len(), PAIRS_PER_TASK, |range| {
        let mut worker = workers.take();
        let prefetcher = Prefetcher { context, states, due: &due[range.clone()], pairs };
        for (position, index) in range.enumerate() {
            prefetcher.of(position);
            let id = due[index];
            // SAFETY: ids of awake pairs differ, and so do the indices of different tasks.
            let (pair, result) = unsafe { (pairs.get_mut(id as usize), results.get_mut(index)) };
            let Some(pair) = pair else { continue };
            let last = Outcome::unchanged(states[id as usize].slack, reporting.contains(id));
            *result = update_pair(context, id, pair, last, &mut worker);
        }
        workers.put(worker);
    });
}

/// Stores the results of all pairs, and lists the pairs that changed.
fn apply<P: Pair>(
    tasks: Tasks<'_>,
    store: &mut PairStore<P>,
    computed: Computed<'_>,
    gather: &mut Gather<Change>,
    changes: &mut Vec<Change>,
) {
    let (due, outcomes) = (computed.due, &*computed.outcomes);
    let StoreParts { states, slots, .. } = store.split();
    let states = DisjointMut::new(states);
    let apply = |range: Range<usize>, found: &mut Vec<Change>| {
        for index in range {
            let later = outcomes.get(index + SLOT_PREFETCH_DISTANCE).and_then(|later| later.change);
            if later.is_some() {
                slots.prefetch(due[index + SLOT_PREFETCH_DISTANCE]);
            }
            let (id, outcome) = (due[index], &outcomes[index]);
            debug_assert!(!outcome.slack.is_nan(), "the slack of pair {id} is a distance");
            // SAFETY: ids of awake pairs differ, and so do the indices of different tasks.
            unsafe { states.get_mut(id as usize) }.slack = outcome.slack;
            found.extend(outcome.change.map(|change| (slots.of(id), id, change)));
        }
    };
    gather.run(tasks, (due.len(), OUTCOMES_PER_TASK), apply, changes);
    let found = || due.iter().copied().zip(outcomes);
    found().for_each(|(id, outcome)| store.set_reporting(id, outcome.reports_force));
    store.renew(found().filter(|(_, outcome)| outcome.is_renewed).map(|(id, _)| id));
}

/// Prefetches the input of the next iterations. Pairs, colliders and bodies are spread over memory. Without
/// prefetching, a third of the computation is the delay of these loads.
struct Prefetcher<'a, P> {
    context: NarrowPhaseContext<'a>,
    states: &'a [PairState],
    due: &'a [PairId],
    pairs: DisjointMut<'a, Option<P>>,
}

impl<P: Update> Prefetcher<'_, P> {
    /// The pair contains the collider slots, so it is prefetched first.
    #[inline(always)]
    fn of(&self, index: usize) {
        if let Some(&id) = self.due.get(index + 2 * PAIR_PREFETCH_DISTANCE) {
            // SAFETY: the later pairs of the range belong to this task exclusively.
            prefetch(unsafe { self.pairs.get(id as usize) });
        }
        if let Some(&id) = self.due.get(index + PAIR_PREFETCH_DISTANCE) {
            // SAFETY: as above.
            let pair = unsafe { self.pairs.get(id as usize) };
            for collider in pair.iter().flat_map(Pair::colliders) {
                self.context.colliders.prefetch(collider.into_raw_parts().0);
            }
            for body in self.states[id as usize].bodies {
                self.context.bodies.prefetch(body);
            }
            pair.iter().for_each(Pair::prefetch_address);
        }
        if let Some(&id) = self.due.get(index + 1) {
            // SAFETY: as above.
            let pair = unsafe { self.pairs.get(id as usize) };
            pair.iter().for_each(|pair| pair.prefetch_report(self.context.lanes));
            pair.iter().for_each(Pair::prefetch_content);
        }
    }
}

fn update_pair<P: Update>(
    context: NarrowPhaseContext<'_>,
    id: PairId,
    pair: &mut P,
    last: Outcome,
    worker: &mut Worker,
) -> Outcome {
    match PairView::of(context, pair.colliders()) {
        Some(view) => pair.update(id, &view, last, worker),
        None => Outcome::APART,
    }
}
