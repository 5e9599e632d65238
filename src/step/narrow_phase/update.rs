//! Which pairs are due, and what becomes of them.

use super::place::{Place, turn_bound};
use super::recycle::recycle_distance;
use crate::base::disjoint::DisjointMut;
use crate::base::pool::Pool;
use crate::base::tasks::Tasks;
use crate::collide::{ManifoldScratch, compute_manifolds, inherit_impulses, shapes_intersect};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::collider::{
    ActiveEvents, ActiveHooks, CoefficientCombineRule, Collider, ColliderHandle, ColliderSet,
};
use crate::model::contact::{
    AwakePair, ContactManifold, ContactPair, DUE, IntersectionPair, NarrowPhase, Pair, PairId,
    PairStore, SolverFlags,
};
use crate::model::hooks::{ContactModificationContext, PairFilterContext, PhysicsHooks};
use crate::model::island::{IslandManager, NONE};
use crate::model::params::IntegrationParameters;
use crate::step::notes::{PairChange, StepNotes};
use parry::bounding_volume::BoundingVolume;
use smallvec::SmallVec;

/// Pairs that are worth handing over to another thread together.
const PAIRS_PER_TASK: usize = 16;

/// What the narrow phase reads.
#[derive(Copy, Clone)]
pub(crate) struct Surroundings<'a> {
    pub bodies: &'a RigidBodySet,
    pub colliders: &'a ColliderSet,
    pub islands: &'a IslandManager,
    pub params: &'a IntegrationParameters,
    pub hooks: &'a dyn PhysicsHooks,
}

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct NarrowPhaseScratch {
    /// Positions in the list of awake pairs.
    due: Vec<u32>,
    outcomes: Vec<Outcome>,
    /// One for each task that runs at the same time.
    workers: Pool<Worker>,
}

/// What one thread needs to compute manifolds.
#[derive(Default)]
struct Worker {
    scratch: ManifoldScratch,
    fresh: SmallVec<[ContactManifold; 1]>,
}

/// What a look at one pair found.
#[derive(Copy, Clone, Debug)]
struct Outcome {
    change: Option<PairChange>,
    slack: Real,
    /// Does somebody want to hear of strong contact forces?
    reports_force: bool,
}

impl Outcome {
    /// The pair is as it was, and stays so for this far.
    fn unchanged(slack: Real, reports_force: bool) -> Self {
        Self { change: None, slack, reports_force }
    }

    /// The boxes no longer overlap.
    const APART: Self = Self { change: Some(PairChange::Apart), slack: DUE, reports_force: false };
}

/// Brings all awake pairs up to date.
pub(crate) fn update(
    around: Surroundings<'_>,
    narrow_phase: &mut NarrowPhase,
    scratch: &mut NarrowPhaseScratch,
    notes: &mut StepNotes,
) {
    update_store(around, &mut narrow_phase.contacts, scratch, &mut notes.contacts);
    update_store(around, &mut narrow_phase.intersections, scratch, &mut notes.intersections);
}

/// A kind of pair, and how it is computed.
trait Update: Sized + Send + Sync {
    fn update(&mut self, view: &PairView<'_>, last: Outcome, worker: &mut Worker) -> Outcome;
}

fn update_store<P: Update + Pair>(
    around: Surroundings<'_>,
    store: &mut PairStore<P>,
    scratch: &mut NarrowPhaseScratch,
    notes: &mut Vec<(PairId, PairChange)>,
) {
    let NarrowPhaseScratch { due, outcomes, workers } = scratch;
    due.clear();
    for (position, pair) in store.awake_mut().iter_mut().enumerate() {
        let [body1, body2] = pair.bodies;
        pair.slack -= around.islands.motion_of(body1) + around.islands.motion_of(body2);
        if pair.slack < 0.0 {
            due.push(position as u32);
        }
    }

    outcomes.clear();
    outcomes.resize(due.len(), Outcome::APART);
    let (awake, pairs) = store.awake_and_pairs();
    let (results, pairs) = (DisjointMut::new(outcomes), DisjointMut::new(pairs));
    let due = &*due;
    Tasks::current().par_for(due.len(), PAIRS_PER_TASK, |range| {
        let mut worker = workers.take();
        for index in range {
            let AwakePair { id, slack, reports_force, .. } = awake[due[index] as usize];
            // SAFETY: ids of awake pairs differ, and so do the indices of different tasks.
            let (slot, result) = unsafe { (pairs.get_mut(id as usize), results.get_mut(index)) };
            let Some(pair) = PairStore::pair_mut(slot) else { continue };
            let last = Outcome::unchanged(slack, reports_force);
            *result = look_at(around, pair, last, &mut worker);
        }
        workers.put(worker);
    });

    for (&position, outcome) in due.iter().zip(outcomes.iter()) {
        let pair = &mut store.awake_mut()[position as usize];
        pair.slack = outcome.slack;
        pair.reports_force = outcome.reports_force;
        if let Some(change) = outcome.change {
            notes.push((pair.id, change));
        }
    }
    // The list of awake pairs is reordered when any pair of the world goes. Colours are given in the
    // order of the notes, and what happens far away must not change them.
    notes.sort_unstable_by_key(|&(id, _)| store[id].colliders());
}

fn look_at<P: Update + Pair>(
    around: Surroundings<'_>,
    pair: &mut P,
    last: Outcome,
    worker: &mut Worker,
) -> Outcome {
    match PairView::of(around, pair.colliders()) {
        Some(view) => pair.update(&view, last, worker),
        None => Outcome::APART,
    }
}

/// The two colliders of a pair and their bodies.
pub(super) struct PairView<'a> {
    around: Surroundings<'a>,
    pub colliders: [&'a Collider; 2],
    pub bodies: [Option<&'a RigidBody>; 2],
    pose12: Pose,
}

impl<'a> PairView<'a> {
    fn of(around: Surroundings<'a>, handles: [ColliderHandle; 2]) -> Option<Self> {
        let collider1 = around.colliders.get(handles[0])?;
        let collider2 = around.colliders.get(handles[1])?;
        let body = |collider: &Collider| around.bodies.get(collider.parent()?);
        Some(Self {
            around,
            colliders: [collider1, collider2],
            bodies: [body(collider1), body(collider2)],
            pose12: collider1.pose.inv_mul(&collider2.pose),
        })
    }

    /// No two points at which the colliders could touch are farther apart than this: the diameter of the
    /// smaller body.
    fn reach(&self) -> Real {
        let diameter =
            |body: Option<&RigidBody>| body.map_or(Real::INFINITY, |body| 2.0 * body.extent);
        diameter(self.bodies[0]).min(diameter(self.bodies[1]))
    }

    fn wants_events(&self, events: ActiveEvents) -> bool {
        let [c1, c2] = self.colliders;
        (c1.active_events() | c2.active_events()).contains(events)
    }

    fn is_any_body_awake(&self) -> bool {
        self.bodies.iter().flatten().any(|body| body.link.awake != NONE)
    }

    fn boxes_overlap(&self) -> bool {
        let [c1, c2] = self.colliders;
        c1.proxy.fat_aabb.intersects(&c2.proxy.fat_aabb)
    }

    fn has_hooks(&self, hooks: ActiveHooks) -> bool {
        let [c1, c2] = self.colliders;
        (c1.active_hooks() | c2.active_hooks()).intersects(hooks)
    }

    fn filter_context(&self, pair: [ColliderHandle; 2]) -> PairFilterContext<'a> {
        PairFilterContext {
            bodies: self.around.bodies,
            colliders: self.around.colliders,
            collider1: pair[0],
            collider2: pair[1],
            rigid_body1: self.colliders[0].parent(),
            rigid_body2: self.colliders[1].parent(),
        }
    }

    /// Gap below which contacts are wanted.
    fn prediction(&self) -> Real {
        let soft_ccd = |body: Option<&RigidBody>| body.map_or(0.0, |body| body.soft_ccd_prediction);
        let soft = soft_ccd(self.bodies[0]).max(soft_ccd(self.bodies[1]));
        let prediction = self.around.params.prediction_distance();
        if soft == 0.0 {
            return prediction;
        }
        // No farther than the two can come together in a step.
        let velocity = |body: Option<&RigidBody>| body.map_or(Vector::ZERO, |body| body.linvel);
        let approach = (velocity(self.bodies[1]) - velocity(self.bodies[0])).length();
        prediction.max(soft.min(approach * self.around.params.dt))
    }

    /// How far a touching pair may move before its contacts are computed again.
    fn recycle_distance(&self) -> Real {
        let shapes = self.colliders.map(Collider::shape);
        recycle_distance(shapes, self.around.params.contact_recycle_distance())
    }

    fn skin(&self) -> Real {
        self.colliders[0].contact_skin + self.colliders[1].contact_skin
    }
}

impl Update for IntersectionPair {
    fn update(&mut self, view: &PairView<'_>, _: Outcome, _: &mut Worker) -> Outcome {
        if !view.boxes_overlap() {
            return Outcome::APART;
        }
        let [c1, c2] = view.colliders;
        let wanted = !view.has_hooks(ActiveHooks::FILTER_INTERSECTION_PAIR) || {
            let context = view.filter_context([self.collider1, self.collider2]);
            view.around.hooks.filter_intersection_pair(&context)
        };
        self.intersecting = wanted && shapes_intersect(&view.pose12, c1.shape(), c2.shape());
        // Any motion may begin or end an intersection; without motion nothing can.
        let filtered = view.has_hooks(ActiveHooks::FILTER_INTERSECTION_PAIR);
        Outcome {
            change: Some(PairChange::Computed),
            slack: if filtered { DUE } else { 0.0 },
            reports_force: false,
        }
    }
}

impl Update for ContactPair {
    fn update(&mut self, view: &PairView<'_>, last: Outcome, worker: &mut Worker) -> Outcome {
        let recycle_distance = view.recycle_distance();
        if last.slack != DUE {
            let left = recycle_distance - self.drift(&view.pose12, view.reach());
            if left > 0.0 && self.is_touching() {
                let left = left.min(self.keep_placed(view));
                return Outcome::unchanged(left, last.reports_force);
            }
        }
        if !view.boxes_overlap() {
            return Outcome::APART;
        }
        let gap = self.compute(view, worker);
        let hooks = ActiveHooks::FILTER_CONTACT_PAIRS | ActiveHooks::MODIFY_SOLVER_CONTACTS;
        let slack = if view.has_hooks(hooks) {
            DUE
        } else if self.is_touching() {
            recycle_distance.min(Place::of(view).left(&self.placement, self.least_friction()))
        } else {
            gap
        };
        let change = if self.needs_follow_up(view) { Some(PairChange::Computed) } else { None };
        let reports_force = view.wants_events(ActiveEvents::CONTACT_FORCE_EVENTS);
        Outcome { change, slack, reports_force }
    }
}

impl ContactPair {
    /// Did anything change that others must be told of: islands, colours, events? In a pile that moves
    /// most pairs are computed each step, and hardly any of them begins or ends.
    fn needs_follow_up(&mut self, view: &PairView<'_>) -> bool {
        self.has_any_active_contact = self.is_touching();
        let is_solved = self.manifolds.iter().any(ContactManifold::is_solved);
        let wants_start = !self.start_event_emitted
            && self.has_any_active_contact
            && view.wants_events(ActiveEvents::COLLISION_EVENTS);
        let wants_stop = self.start_event_emitted && !self.has_any_active_contact;
        let as_colored = self.manifolds.iter().all(|manifold| {
            !manifold.contacts().is_empty() && manifold.slot.is_some() == manifold.is_solved()
        });
        is_solved != self.attached
            || !as_colored
            || wants_start
            || wants_stop
            || !view.is_any_body_awake()
    }

    /// A bound of how far the two bodies moved against each other, in the region where they could touch,
    /// since the contact points were computed.
    ///
    /// That is how far the points moved, and how far a rotation about them moves anything else within
    /// `reach`: a body that tips over on its contact points has them stand still.
    fn drift(&self, pose12: &Pose, reach: Real) -> Real {
        let contacts = self.manifolds.iter().flat_map(ContactManifold::contacts);
        let moved = contacts.map(|contact| {
            (pose12 * contact.local_p2 - self.pose12 * contact.local_p2).length_squared()
        });
        let turn = turn_bound(pose12.rotation, self.pose12.rotation);
        moved.fold(0.0, Real::max).sqrt() + turn * reach
    }

    /// Places contacts anew that begin to be held, or are held and whose bodies have crept too far. Returns how far the
    /// bodies may move until this must be asked again.
    fn keep_placed(&mut self, view: &PairView<'_>) -> Real {
        let place = Place::of(view);
        let friction = self.least_friction();
        let (held, creeps) = (self.placement.may_hold, place.creeps());
        if !creeps {
            // Should they creep again later, they must not be held where they were long ago.
            self.placement.may_hold = false;
        } else if !held || place.left(&self.placement, friction) <= 0.0 {
            self.placement = place.placement();
            for manifold in &mut self.manifolds {
                place.put(manifold);
            }
        }
        place.left(&self.placement, friction)
    }

    fn least_friction(&self) -> Real {
        self.manifolds.iter().map(|manifold| manifold.data.friction).fold(Real::MAX, Real::min)
    }

    /// Computes the manifolds. Returns how far apart the shapes are beyond the prediction distance: no
    /// contact can appear before they have moved that far.
    ///
    /// Manifolds that vanish stay, without points, until whoever gave them colours takes those away.
    fn compute(&mut self, view: &PairView<'_>, worker: &mut Worker) -> Real {
        let Worker { scratch, fresh } = worker;
        let wanted = !view.has_hooks(ActiveHooks::FILTER_CONTACT_PAIRS) || {
            let context = view.filter_context([self.collider1, self.collider2]);
            view.around.hooks.filter_contact_pair(&context)
        };
        let mut gap = 0.0;
        if wanted {
            let (prediction, skin) = (view.prediction(), view.skin());
            let [shape1, shape2] = view.colliders.map(Collider::shape);
            let reach = prediction + skin;
            let old = &self.manifolds;
            let distance =
                compute_manifolds(&view.pose12, shape1, shape2, reach, old, scratch, fresh);
            gap = (distance - reach).max(0.0);
            inherit_impulses(fresh, old);
            let place = Place::of(view);
            self.placement = place.placement();
            for manifold in fresh.iter_mut() {
                finish(manifold, view);
                place.put(manifold);
                modify(manifold, self.collider1, self.collider2, view);
                if !manifold.is_solved() {
                    manifold.data.forget_impulses();
                }
            }
            fresh.retain(|manifold| !manifold.contacts().is_empty());
        } else {
            fresh.clear();
        }
        self.pose12 = view.pose12;
        self.replace_manifolds(fresh);
        gap
    }

    fn replace_manifolds(&mut self, fresh: &mut SmallVec<[ContactManifold; 1]>) {
        let kept = fresh.len();
        for (index, mut manifold) in fresh.drain(..).enumerate() {
            match self.manifolds.get_mut(index) {
                Some(old) => {
                    manifold.slot = old.slot;
                    *old = manifold;
                }
                None => self.manifolds.push(manifold),
            }
        }
        for surplus in &mut self.manifolds[kept..] {
            surplus.data.points.clear();
        }
    }
}

/// Completes a manifold with what the solver needs to know of materials and bodies.
fn finish(manifold: &mut ContactManifold, view: &PairView<'_>) {
    let [c1, c2] = view.colliders;
    let data = &mut manifold.data;
    data.rigid_body1 = c1.parent();
    data.rigid_body2 = c2.parent();
    data.tangent_velocity = Vector::ZERO;
    let (m1, m2) = (c1.material(), c2.material());
    data.friction = CoefficientCombineRule::combine(
        m1.friction,
        m1.friction_combine_rule,
        m2.friction,
        m2.friction_combine_rule,
    );
    data.restitution = CoefficientCombineRule::combine(
        m1.restitution,
        m1.restitution_combine_rule,
        m2.restitution,
        m2.restitution_combine_rule,
    );
    let [dominance1, dominance2] = view.bodies.map(RigidBody::dominance_of);
    data.relative_dominance = dominance1 - dominance2;
    data.solver_flags = if c1.solver_groups().test(c2.solver_groups()) {
        SolverFlags::COMPUTE_RIGID_IMPULSES
    } else {
        SolverFlags::empty()
    };
}

/// Lets the user change the contacts.
fn modify(
    manifold: &mut ContactManifold,
    collider1: ColliderHandle,
    collider2: ColliderHandle,
    view: &PairView<'_>,
) {
    if !view.has_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS) {
        return;
    }
    let mut context = ContactModificationContext {
        bodies: view.around.bodies,
        colliders: view.around.colliders,
        rigid_body1: view.colliders[0].parent(),
        rigid_body2: view.colliders[1].parent(),
        collider1,
        collider2,
        manifold,
    };
    view.around.hooks.modify_solver_contact(&mut context);
    manifold.data.placed_normal = manifold.data.normal;
    for contact in &mut manifold.data.points {
        contact.placed_dist = contact.dist;
    }
}
