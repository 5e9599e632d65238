//! Contact manifolds of pairs of solid colliders.

use super::anchors::AnchorTransform;
use super::faults;
use super::ghost_contacts::{self, GhostContactScratch, non_dynamic_side};
use super::update::{NarrowPhaseContext, Outcome, Update, Worker};
use super::view::PairView;
use crate::base::pool::Pool;
use crate::base::tasks::Tasks;
use crate::collide::{
    Neighbor, PENETRATION_FRACTION_MAX, ShapePair, compute_manifolds, inherit_impulses,
    renew_convex_manifold,
};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::{QuarantineCause, RigidBody, RigidBodyHandle};
use crate::model::collider::{
    ActiveEvents, ActiveHooks, CoefficientCombineRule, Collider, ColliderHandle,
};
use crate::model::contact::{
    ContactManifold, ContactPair, PairId, PairStore, SLACK_DUE, SolverFlags,
};
use crate::model::hooks::ContactModificationContext;
use crate::model::island::rotation_bound;
use crate::step::notes::PairChange;
use smallvec::SmallVec;

/// Results of a computation that later ones read.
struct Computed {
    /// Distance of the shapes beyond the prediction distance: no contact can appear before they have moved
    /// that far.
    gap: Real,
    /// Admissible motion of the bodies until the anchors must be [transformed](super::anchors) again.
    remaining: Real,
}

impl Update for ContactPair {
    fn update(
        &mut self,
        id: PairId,
        view: &PairView<'_>,
        last: Outcome,
        worker: &mut Worker,
    ) -> Outcome {
        let recycle_distance = view.recycle_distance();
        if last.slack != SLACK_DUE
            && self.is_touching()
            && let Some(drift) = self.drift_below(recycle_distance, &view.pose12, view.reach())
        {
            let remaining = recycle_distance - drift;
            let (stay, is_renewed) = self.update_frozen_anchors(id, view);
            let outcome = Outcome::unchanged(remaining.min(stay), last.reports_force);
            return Outcome { is_renewed, ..outcome };
        }
        if !view.boxes_overlap() {
            return Outcome::APART;
        }
        view.context.lanes.write_back(id, self);
        self.renew(view, [&[], &[]], worker)
    }

    fn filter_ghost_contacts(
        tasks: Tasks<'_>,
        context: NarrowPhaseContext<'_>,
        store: &mut PairStore<Self>,
        computed: ghost_contacts::Computed<'_>,
        scratch: &mut GhostContactScratch,
        workers: &Pool<Worker>,
    ) {
        ghost_contacts::filter_ghost_contacts(tasks, context, store, computed, scratch, workers);
    }
}

impl ContactPair {
    /// Computes a pair whose last impulses are written back, with the neighbouring contacts of both
    /// colliders.
    pub(super) fn renew(
        &mut self,
        view: &PairView<'_>,
        neighbors: [&[Neighbor<'_>]; 2],
        worker: &mut Worker,
    ) -> Outcome {
        let Computed { gap, remaining } = self.compute(view, neighbors, worker);
        worker.deeply_penetrating.extend(self.penetrating_body(view));
        let hooks = ActiveHooks::FILTER_CONTACT_PAIRS | ActiveHooks::MODIFY_SOLVER_CONTACTS;
        let slack = if view.has_hooks(hooks) {
            SLACK_DUE
        } else if self.is_touching() {
            view.recycle_distance().min(remaining)
        } else {
            gap
        };
        Outcome {
            change: self.needs_follow_up(view).then_some(PairChange::Computed),
            slack,
            reports_force: view.has_events(ActiveEvents::CONTACT_FORCE_EVENTS),
            is_renewed: true,
            non_dynamic_side: non_dynamic_side(view).filter(|_| self.is_touching()),
        }
    }

    /// The body that is deep in the other one, if that is not dynamic.
    fn penetrating_body(&self, view: &PairView<'_>) -> Option<RigidBodyHandle> {
        let solved = self.manifolds.iter().filter(|manifold| manifold.is_solved());
        let depth = -solved.map(ContactManifold::deepest_dist).fold(Real::INFINITY, Real::min);
        // Nearly all pairs end here.
        if depth <= view.context.params.prediction_distance() {
            return None;
        }
        let is_dynamic = view.bodies.map(|body| body.filter(|body| body.is_dynamic()));
        let (side, body) = match is_dynamic {
            [Some(body), None] => (0, body),
            [None, Some(body)] => (1, body),
            _ => return None,
        };
        let is_deep = depth > PENETRATION_FRACTION_MAX * body.thickness;
        is_deep.then(|| view.colliders[side].parent()).flatten()
    }

    /// Returns whether the change affects islands, colours or events. In a pile that moves most pairs are
    /// computed each step, and hardly any of them begins or ends.
    fn needs_follow_up(&mut self, view: &PairView<'_>) -> bool {
        self.has_any_active_contact = self.is_touching();
        let is_solved = self.manifolds.iter().any(ContactManifold::is_solved);
        let must_report_start = !self.start_event_emitted
            && self.has_any_active_contact
            && view.has_events(ActiveEvents::COLLISION_EVENTS);
        let must_report_stop = self.start_event_emitted && !self.has_any_active_contact;
        let as_colored = self.manifolds.iter().all(|manifold| {
            !manifold.contacts().is_empty() && manifold.slot.is_some() == manifold.is_solved()
        });
        is_solved != self.attached
            || !as_colored
            || must_report_start
            || must_report_stop
            || !view.is_any_body_awake()
    }

    /// Bound on the relative motion of the two bodies since the contact points were computed, in the region
    /// where they could touch. Returns zero unless the bound is below a limit, as for most pairs.
    ///
    /// The bound includes the motion of the points, and the rotation about them of everything within `reach`.
    /// The contact points of a tipping body do not move.
    fn drift_below(&self, limit: Real, pose12: &Pose, reach: Real) -> Option<Real> {
        let turned = rotation_bound(pose12.rotation, self.pose12.rotation) * reach;
        if turned >= limit {
            return None;
        }
        let contacts = self.manifolds.iter().flat_map(ContactManifold::contacts);
        let moved = contacts.map(|contact| {
            (pose12 * contact.local_p2 - self.pose12 * contact.local_p2).length_squared()
        });
        let drift = moved.fold(0.0, Real::max).sqrt() + turned;
        (drift < limit).then_some(drift)
    }

    /// Transforms anchors that begin to be frozen, or are frozen and whose bodies have moved too far. Returns
    /// the admissible motion until the next check, and whether anything changed.
    fn update_frozen_anchors(&mut self, id: PairId, view: &PairView<'_>) -> (Real, bool) {
        let anchors = AnchorTransform::of(view);
        let friction = self.least_friction();
        let (was_frozen, near_rest) = (self.anchor_frame.may_freeze, anchors.near_rest());
        let remaining = anchors.remaining_motion(&self.anchor_frame, friction);
        if near_rest == was_frozen && remaining > 0.0 {
            return (remaining, false);
        }
        view.context.lanes.write_back(id, self);
        if near_rest {
            self.anchor_frame = anchors.anchor_frame();
            for manifold in &mut self.manifolds {
                anchors.transform(manifold);
            }
        } else {
            // If the bodies come near rest again later, outdated anchors must not be frozen.
            self.anchor_frame.may_freeze = false;
        }
        (anchors.remaining_motion(&self.anchor_frame, friction), true)
    }

    fn least_friction(&self) -> Real {
        self.manifolds.iter().map(|manifold| manifold.data.friction).fold(Real::MAX, Real::min)
    }

    /// Computes the manifolds.
    ///
    /// Vanished manifolds stay, without points, until `islands` removes their colours.
    fn compute(
        &mut self,
        view: &PairView<'_>,
        neighbors: [&[Neighbor<'_>]; 2],
        worker: &mut Worker,
    ) -> Computed {
        let flags = if view.has_hooks(ActiveHooks::FILTER_CONTACT_PAIRS) {
            let context = view.filter_context([self.collider1, self.collider2]);
            view.context.hooks.contact_pair_flags(&context)
        } else {
            Some(SolverFlags::default())
        };
        let anchors = AnchorTransform::of(view);
        let reach = view.prediction() + view.skin();
        let pair = ShapePair {
            pos12: view.pose12,
            shapes: view.colliders.map(Collider::shape),
            motion: view.motion(),
            prediction: reach,
            step_height_tolerance: view.context.params.allowed_linear_error(),
            neighbors,
            simd: view.context.simd,
        };
        self.pose12 = view.pose12;
        let distance = if let Some(flags) = flags {
            self.anchor_frame = anchors.anchor_frame();
            let circumstances = Circumstances { view, anchors: &anchors, flags };
            if self.is_plain(view, neighbors) {
                self.renew_manifold(&pair, circumstances, worker)
            } else {
                self.compute_manifolds(&pair, circumstances, worker)
            }
        } else {
            self.replace_manifolds(&mut SmallVec::new());
            reach
        };
        let gap = (distance - reach).max(0.0);
        Computed {
            gap,
            remaining: anchors.remaining_motion(&self.anchor_frame, self.least_friction()),
        }
    }

    /// Returns whether the result can be written in place. The shapes are their own only parts, there is at
    /// most one manifold, and no hook can panic half-way.
    fn is_plain(&self, view: &PairView<'_>, neighbors: [&[Neighbor<'_>]; 2]) -> bool {
        let is_whole =
            |manifold: &ContactManifold| [manifold.subshape1, manifold.subshape2] == [0; 2];
        view.are_convex()
            && !view.has_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS)
            && neighbors.iter().all(|list| list.is_empty())
            && self.manifolds.len() <= 1
            && self.manifolds.iter().all(is_whole)
    }

    /// Computes the one manifold in its place. Returns a bound of the shapes' distance.
    fn renew_manifold(
        &mut self,
        pair: &ShapePair<'_>,
        circumstances: Circumstances<'_>,
        worker: &mut Worker,
    ) -> Real {
        let distance = renew_convex_manifold(pair, &mut self.manifolds, &mut worker.scratch);
        let colliders = [self.collider1, self.collider2];
        if let Some(manifold) = self.manifolds.first_mut().filter(|one| !one.contacts().is_empty())
        {
            let fault = complete(manifold, colliders, circumstances);
            worker.faults.extend(fault.map(|fault| (colliders, fault)));
        }
        distance
    }

    /// Computes any number of manifolds. Returns a bound of the shapes' distance.
    fn compute_manifolds(
        &mut self,
        pair: &ShapePair<'_>,
        circumstances: Circumstances<'_>,
        worker: &mut Worker,
    ) -> Real {
        let Worker { scratch, fresh, faults, culled, .. } = worker;
        let (old, colliders) = (&self.manifolds, [self.collider1, self.collider2]);
        let distance = compute_manifolds(pair, old, Some(&mut self.triangle_cache), scratch, fresh);
        culled.extend(scratch.is_culled().then_some(colliders));
        inherit_impulses(fresh, old);
        for manifold in fresh.iter_mut() {
            let fault = complete(manifold, colliders, circumstances);
            faults.extend(fault.map(|fault| (colliders, fault)));
        }
        fresh.retain(|manifold| !manifold.contacts().is_empty());
        self.replace_manifolds(fresh);
        distance
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
        for excess in &mut self.manifolds[kept..] {
            excess.data.points.clear();
        }
    }
}

/// Input for the completion of a pair's manifolds.
#[derive(Copy, Clone)]
struct Circumstances<'a> {
    view: &'a PairView<'a>,
    anchors: &'a AnchorTransform<'a>,
    /// The user's filter of solver contacts.
    flags: SolverFlags,
}

/// Completes a manifold with known points, and removes unusable numbers.
fn complete(
    manifold: &mut ContactManifold,
    [collider1, collider2]: [ColliderHandle; 2],
    Circumstances { view, anchors, flags }: Circumstances<'_>,
) -> Option<QuarantineCause> {
    finish(manifold, view);
    manifold.data.solver_flags &= flags;
    anchors.transform(manifold);
    modify(manifold, collider1, collider2, view);
    let fault = faults::leave_out(manifold);
    if !manifold.is_solved() {
        manifold.data.clear_impulses();
    }
    fault
}

/// Completes a manifold with the solver's data of materials and bodies.
fn finish(manifold: &mut ContactManifold, view: &PairView<'_>) {
    let [c1, c2] = view.colliders;
    let data = &mut manifold.data;
    data.rigid_body1 = c1.parent();
    data.rigid_body2 = c2.parent();
    data.tangent_velocity = Vector::ZERO;
    let (m1, m2) = (c1.material(), c2.material());
    data.friction = CoefficientCombineRule::combined(
        m1.friction,
        m1.friction_combine_rule,
        m2.friction,
        m2.friction_combine_rule,
    );
    data.restitution = CoefficientCombineRule::combined(
        m1.restitution,
        m1.restitution_combine_rule,
        m2.restitution,
        m2.restitution_combine_rule,
    );
    let [dominance1, dominance2] = view.bodies.map(RigidBody::dominance_of);
    data.relative_dominance = dominance1 - dominance2;
    let is_solved =
        c1.solver_groups().test(c2.solver_groups()) && !view.context.islands.weld_colliders(c1, c2);
    data.solver_flags =
        if is_solved { SolverFlags::COMPUTE_RIGID_IMPULSES } else { SolverFlags::empty() };
}

/// Calls the user's hook for the contacts.
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
        bodies: view.context.bodies,
        colliders: view.context.colliders,
        rigid_body1: view.colliders[0].parent(),
        rigid_body2: view.colliders[1].parent(),
        collider1,
        collider2,
        manifold,
    };
    view.context.hooks.modify_solver_contact(&mut context);
    manifold.data.anchor_normal = manifold.data.normal;
    for contact in &mut manifold.data.points {
        contact.anchor_dist = contact.dist;
    }
}
