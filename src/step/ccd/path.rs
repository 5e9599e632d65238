//! The path of one fast body, and its stops.

use super::ride::Stop;
use super::{CcdContext, Search};
use crate::collide::{Overlap, PathSegment, Solid, Sweep, SweepGoal, ends_deep, first_impact};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::{RigidBody, RigidBodyHandle};
use crate::model::collider::{ActiveHooks, Collider, ColliderHandle, may_interact};
use crate::model::hooks::{PairFilterContext, lets_solver_push};
use crate::model::island::NONE;
use crate::model::tree::TreeKind;
use crate::step::notes::{FastMotion, MotionPart};
use core::sync::atomic::Ordering;
use parry::bounding_volume::{Aabb, BoundingVolume};
use smallvec::SmallVec;

/// Minimum gap of stopped bodies, as a fraction of the prediction distance.
const GAP_MIN: Real = 0.01;

/// Error of positions, as a fraction of lengths and of the distance from the origin.
pub(super) const ROUNDING: Real = 64.0 * Real::EPSILON;

/// Selects the non-dynamic colliders that a path is searched against.
#[derive(Copy, Clone)]
pub(super) enum NonDynamicFilter {
    /// All of them.
    All,
    /// All except the colliders of this body.
    NotOn(Option<RigidBodyHandle>),
    /// Moving colliders.
    Moving,
}

/// A moving collider.
#[derive(Copy, Clone)]
pub(super) struct Mover<'a> {
    pub handle: ColliderHandle,
    pub collider: &'a Collider,
    pub sweep: Sweep<'a>,
}

/// The moving colliders of a body.
pub(super) struct Path<'a> {
    pub body: &'a RigidBody,
    part: MotionPart,
    pub movers: SmallVec<[Mover<'a>; 2]>,
}

impl Search<'_> {
    /// The least gap at which bodies are stopped (length units).
    pub fn gap_min(&self) -> Real {
        GAP_MIN * self.context.params.prediction_distance()
    }

    /// The gap at which colliders without skins stop (length units).
    fn gap(&self) -> Real {
        self.context.params.allowed_linear_error().max(self.gap_min())
    }

    /// The largest contact skin of a body's colliders.
    pub fn skin_of(&self, body: &RigidBody) -> Real {
        let colliders = body.colliders.iter();
        let colliders = colliders.filter_map(|&handle| self.context.colliders.get(handle));
        colliders.map(|collider| collider.contact_skin).fold(0.0, Real::max)
    }

    /// Returns whether nothing that is not dynamic, sensors included, is near the path of a fast body. The
    /// path is that of a ball about the centre of mass: it contains all colliders, and the gap at which the
    /// colliders stop. (The boxes of other colliders contain the skins of these colliders.) For a body in
    /// free fall the exact region takes ten times as long.
    pub fn is_in_the_open(self, position: usize) -> bool {
        let motion = &self.context.fast[position];
        let body = self.context.bodies.get(motion.body).filter(|_| motion.link.is_none());
        let Some(body) = body else { return false };
        let (start, end) = (motion.center, motion.center + motion.shift);
        let radius = body.extent + self.gap() + self.skin_of(body);
        let rounding = ROUNDING * (start.abs().max(end.abs()).max_element() + radius);
        let region = Aabb::new(start.min(end), start.max(end)).loosened(radius + rounding);
        let mut is_open = true;
        self.for_each_box(NonDynamicFilter::All, &region, |_| is_open = false);
        is_open
    }

    /// Calls `visit` with the slots of colliders whose boxes overlap a region, some of them more than once.
    fn for_each_box(self, filter: NonDynamicFilter, region: &Aabb, mut visit: impl FnMut(u32)) {
        let kinds: &[_] = match filter {
            NonDynamicFilter::Moving => &[],
            _ => &[TreeKind::Fixed, TreeKind::Kinematic],
        };
        for &kind in kinds {
            self.context.trees.for_each_overlapping(kind, region, &mut visit);
        }
        // The trees have kinematic colliders where they were.
        self.movers.for_each_in(region, visit);
    }

    /// Calls `visit` with the solid colliders in a region that are not on dynamic bodies, in slot order. Of
    /// two nearly simultaneous hits, the first one visited may win, and that must not depend on the trees.
    fn for_each_non_dynamic(
        self,
        filter: NonDynamicFilter,
        region: &Aabb,
        mut visit: impl FnMut(Mover<'_>),
    ) {
        let mut slots = SmallVec::<[u32; 16]>::new();
        self.for_each_box(filter, region, |slot| slots.push(slot));
        slots.sort_unstable();
        slots.dedup();
        let colliders = self.context.colliders;
        for (handle, collider) in slots.into_iter().filter_map(|slot| colliders.at_slot(slot)) {
            let is_on = |body| collider.parent() == Some(body);
            let is_left_out = matches!(filter, NonDynamicFilter::NotOn(Some(body)) if is_on(body));
            if !collider.is_sensor() && !is_left_out {
                Mover::not_fast(self, handle, collider).into_iter().for_each(&mut visit);
            }
        }
    }
}

impl<'a> Path<'a> {
    /// The executed path of the solid colliders of the fast body at a position.
    pub fn of(search: Search<'a>, position: usize, stop: Real) -> Option<Self> {
        Self::of_all(search, position, stop).map(Self::of_solids)
    }

    /// The same path without sensors.
    pub fn of_solids(mut self) -> Self {
        self.movers.retain(|mover| !mover.collider.is_sensor());
        self
    }

    /// The path of all colliders of the fast body at a position.
    pub fn of_all(search: Search<'a>, position: usize, stop: Real) -> Option<Self> {
        let motion = &search.context.fast[position];
        let body = search.context.bodies.get(motion.body)?;
        let segments = motion.link.map_or(&[] as &[_], |link| search.link_trajectories.of(link));
        if !segments.is_empty() {
            return Some(Self::of_segments(search, body, segments, stop));
        }
        let sweep = |collider: &Collider| sweep_of(motion, collider.pose, stop);
        Some(Self { body, part: motion.part, movers: movers(search, body, sweep) })
    }

    /// The path of all colliders of the fast body at a position along these segments, up to a fraction of the
    /// step.
    pub fn along(
        search: Search<'a>,
        position: usize,
        segments: &'a [PathSegment],
        stop: Real,
    ) -> Option<Self> {
        let body = search.context.bodies.get(search.context.fast[position].body)?;
        Some(Self::of_segments(search, body, segments, stop))
    }

    fn of_segments(
        search: Search<'a>,
        body: &'a RigidBody,
        segments: &'a [PathSegment],
        stop: Real,
    ) -> Self {
        let center = body.local_center_of_mass();
        let sweep = |collider: &Collider| match &collider.parent {
            Some(parent) => Sweep::along(segments, &parent.pos_wrt_parent, center).until(stop),
            None => Sweep::at_rest(collider.pose),
        };
        Self { body, part: MotionPart::Whole, movers: movers(search, body, sweep) }
    }

    /// The pose of the body after a fraction of the step.
    pub fn pose_at(&self, fraction: Real) -> Option<Pose> {
        let mover = self.movers.first()?;
        let parent = mover.collider.parent.as_ref()?;
        let pose = mover.sweep.at(fraction) * parent.pos_wrt_parent.inverse();
        Some(Pose::from_parts(pose.translation, pose.rotation.normalize()))
    }

    /// The path of the solid colliders of a body that is not fast.
    pub fn of_slow(search: Search<'a>, handle: RigidBodyHandle) -> Option<Self> {
        let body = search.context.bodies.get(handle)?;
        let sweep = |collider: &Collider| sweep_of_slow(search.context, body, collider);
        Some(
            Self { body, part: MotionPart::Whole, movers: movers(search, body, sweep) }.of_solids(),
        )
    }

    /// Treatment of colliders that touch something when the step begins. Rotation in place leads no middle
    /// through a wall, and a body that is deep at a corner must be able to rotate.
    fn overlap(&self, search: Search<'_>) -> Overlap {
        match (search.context.params.ccd_on_penetration, self.part) {
            (false, _) => Overlap::Passes,
            (true, MotionPart::Rotation) => Overlap::StopsHalfway,
            (true, _) => Overlap::StopsEarly,
        }
    }

    /// A box around all places of all colliders.
    pub fn region(&self) -> Aabb {
        let regions = self.movers.iter().map(|mover| mover.sweep.region(mover.collider.shape()));
        regions.fold(Aabb::new_invalid(), |all, region| all.merged(&region))
    }

    /// The first stop among some colliders. It must be the path of solid colliders.
    pub fn first_stop(&self, search: Search<'_>, filter: NonDynamicFilter) -> Stop {
        let mut first = Stop::NONE;
        for mover in &self.movers {
            let region = mover.sweep.region_of_core(Solid::of(mover.collider));
            search.for_each_non_dynamic(filter, &region, |other| {
                let overlap = self.overlap(search);
                if let Some(fraction) = mover.impact(&other, overlap, search, first.fraction) {
                    let by = other.sweep.moves().then_some(other.handle);
                    first = Stop { fraction, by, ..Stop::NONE };
                }
            });
        }
        first
    }

    /// Returns whether the body is deep in a fixed or kinematic collider at its end. It must be that of solid
    /// colliders.
    pub fn ends_deep(&self, search: Search<'_>) -> bool {
        let mut deep = false;
        for mover in &self.movers {
            let solid = Solid::of(mover.collider);
            let region = solid.shape.compute_aabb(&mover.sweep.at(1.0));
            search.for_each_non_dynamic(NonDynamicFilter::All, &region, |other| {
                deep = deep
                    || mover.is_stopped_by(&other, search)
                        && ends_deep(solid, other.collider.shape(), [&mover.sweep, &other.sweep]);
            });
        }
        deep
    }

    /// The fraction of the step after which another body stops this path; `None` if not before `until`.
    pub fn impact(&self, other: &Path<'_>, search: Search<'_>, until: Real) -> Option<Real> {
        let mut first = None;
        for mover in &self.movers {
            for target in &other.movers {
                let until = first.unwrap_or(until);
                first = mover.impact(target, self.overlap(search), search, until).or(first);
            }
        }
        first
    }
}

impl<'a> Mover<'a> {
    /// A collider of a body that is not fast, or of none; `None` if it is fast.
    pub fn not_fast(
        search: Search<'a>,
        handle: ColliderHandle,
        collider: &'a Collider,
    ) -> Option<Self> {
        let parent = collider.parent();
        if parent.is_some_and(|body| search.groups.position(body.into_raw_parts().0).is_some()) {
            return None;
        }
        let body = parent.and_then(|body| search.context.bodies.get(body));
        let sweep = body.map_or(Sweep::at_rest(collider.pose), |body| {
            sweep_of_slow(search.context, body, collider)
        });
        Some(Self { handle, collider, sweep })
    }

    /// The fraction of the step after which another collider stops this one; `None` if not before `until`.
    fn impact(
        &self,
        other: &Mover<'_>,
        overlap: Overlap,
        search: Search<'_>,
        until: Real,
    ) -> Option<Real> {
        if !self.is_stopped_by(other, search) {
            return None;
        }
        search.searched.fetch_add(1, Ordering::Relaxed);
        let skin = self.collider.contact_skin + other.collider.contact_skin;
        let goal = SweepGoal { gap: search.gap() + skin, overlap };
        let (solid, other_shape) = (Solid::of(self.collider), other.collider.shape());
        first_impact(solid, other_shape, [&self.sweep, &other.sweep], goal, until)
    }

    /// Returns whether a contact of the two would exert forces. If a hook modifies contacts, only the hook
    /// can decide.
    fn is_stopped_by(&self, other: &Mover<'_>, search: Search<'_>) -> bool {
        let (own, others) = (self.collider, other.collider);
        let hooks = own.active_hooks() | others.active_hooks();
        !others.is_sensor()
            && may_interact(own, others)
            && own.solver_groups().test(others.solver_groups())
            && !hooks.contains(ActiveHooks::MODIFY_SOLVER_CONTACTS)
            && !search.context.islands.part_colliders(own, others)
            && !search.context.islands.weld_colliders(own, others)
            && (!hooks.contains(ActiveHooks::FILTER_CONTACT_PAIRS)
                || lets_solver_push(search.context.hooks, &self.filter_context(other, search)))
    }

    /// The hook's view of the two.
    pub fn filter_context<'b>(
        &self,
        other: &Mover<'_>,
        search: Search<'b>,
    ) -> PairFilterContext<'b> {
        let [low, high] = self.in_order(other);
        PairFilterContext {
            bodies: search.context.bodies,
            colliders: search.context.colliders,
            collider1: low.handle,
            collider2: high.handle,
            rigid_body1: low.collider.parent(),
            rigid_body2: high.collider.parent(),
        }
    }

    /// The two as pairs have them.
    pub fn in_order<'b>(&'b self, other: &'b Mover<'a>) -> [&'b Mover<'a>; 2] {
        let is_first = self.handle.into_raw_parts() < other.handle.into_raw_parts();
        if is_first { [self, other] } else { [other, self] }
    }
}

fn movers<'a>(
    search: Search<'a>,
    body: &RigidBody,
    sweep: impl Fn(&'a Collider) -> Sweep<'a>,
) -> SmallVec<[Mover<'a>; 2]> {
    let enabled = body.colliders.iter().filter_map(|&handle| {
        let collider = search.context.colliders.get(handle)?;
        collider.is_enabled().then(|| Mover { handle, collider, sweep: sweep(collider) })
    });
    enabled.collect()
}

/// The motion of something on a fast body that was at `start`, as far as `stop`.
pub(super) fn sweep_of(motion: &FastMotion, start: Pose, stop: Real) -> Sweep<'static> {
    Sweep::new(start, motion.center, motion.path_shift(), motion.path_rotvec()).until(stop)
}

/// The motion from the old pose of the collider to its body's new pose.
pub(super) fn sweep_of_slow(
    context: CcdContext<'_>,
    body: &RigidBody,
    collider: &Collider,
) -> Sweep<'static> {
    let Some(parent) = &collider.parent else { return Sweep::at_rest(collider.pose) };
    if context.islands.motion_of(body_slot(collider)).bound() == 0.0 {
        return Sweep::at_rest(collider.pose);
    }
    let local_center = parent.pos_wrt_parent.inverse_transform_point(body.local_center_of_mass());
    let center = collider.pose * local_center;
    let shift: Vector = body.mprops.world_com - center;
    Sweep::new(collider.pose, center, shift, body.vels.angvel * context.params.dt)
}

fn body_slot(collider: &Collider) -> u32 {
    collider.parent().map_or(NONE, |body| body.into_raw_parts().0)
}
