//! The path of one fast body, and what stops it.

use super::Surroundings;
use crate::collide::{Sweep, SweepGoal, first_impact};
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::{RigidBody, RigidBodyHandle};
use crate::model::collider::{ActiveHooks, Collider, ColliderHandle, may_interact};
use crate::model::hooks::PairFilterContext;
use crate::model::island::NONE;
use crate::model::tree::TreeKind;
use crate::step::notes::FastMotion;
use parry::bounding_volume::{Aabb, BoundingVolume};
use smallvec::SmallVec;

/// Bodies are stopped this far before they touch, at least: a share of the prediction distance.
const GAP_MIN: Real = 0.01;

/// A collider on its way.
#[derive(Copy, Clone)]
pub(super) struct Mover<'a> {
    pub handle: ColliderHandle,
    pub collider: &'a Collider,
    pub sweep: Sweep,
}

/// The solid colliders of a body on their way.
pub(super) struct Path<'a> {
    pub body: &'a RigidBody,
    pub movers: SmallVec<[Mover<'a>; 2]>,
}

impl<'a> Path<'a> {
    /// The path of a fast body, as far as it is known to come.
    pub fn of(around: Surroundings<'a>, motion: &FastMotion, stop: Real) -> Option<Self> {
        let body = around.bodies.get(motion.body)?;
        let sweep = |collider: &Collider| sweep_of(motion, collider.pose, stop);
        Some(Self { body, movers: movers(around, body, sweep) })
    }

    /// The path of a body that is not fast.
    pub fn of_slow(around: Surroundings<'a>, handle: RigidBodyHandle) -> Option<Self> {
        let body = around.bodies.get(handle)?;
        let sweep = |collider: &Collider| sweep_of_slow(around, body, collider);
        Some(Self { body, movers: movers(around, body, sweep) })
    }

    /// A box around all places of all colliders.
    pub fn region(&self) -> Aabb {
        let regions = self.movers.iter().map(|mover| mover.sweep.region(mover.collider.shape()));
        regions.fold(Aabb::new_invalid(), |all, region| all.merged(&region))
    }

    /// The share of the motion after which the first fixed or kinematic collider stops it.
    pub fn first_stop(&self, around: Surroundings<'_>) -> Real {
        let mut first = 1.0;
        for mover in &self.movers {
            let region = mover.sweep.region_of_core(mover.collider.shape());
            let movable = around.trees.has_kinematics().then_some(TreeKind::Movable);
            for kind in movable.into_iter().chain([TreeKind::Fixed]) {
                around.trees.for_each_overlapping(kind, &region, |slot| {
                    let Some((handle, collider)) = around.colliders.at_slot(slot) else { return };
                    let body = collider.parent().and_then(|body| around.bodies.get(body));
                    if body.is_some_and(RigidBody::is_dynamic) {
                        return;
                    }
                    let sweep = body.map_or(Sweep::at_rest(collider.pose), |body| {
                        sweep_of_slow(around, body, collider)
                    });
                    let other = Mover { handle, collider, sweep };
                    first = mover.impact(&other, around, first).unwrap_or(first);
                });
            }
        }
        first
    }

    /// The share of the step after which this path is stopped by another body; `None` if not before `until`.
    pub fn impact(&self, other: &Path<'_>, around: Surroundings<'_>, until: Real) -> Option<Real> {
        let mut first = None;
        for mover in &self.movers {
            for target in &other.movers {
                first = mover.impact(target, around, first.unwrap_or(until)).or(first);
            }
        }
        first
    }
}

impl Mover<'_> {
    /// The share of the step after which this collider is stopped by another; `None` if not before `until`.
    fn impact(&self, other: &Mover<'_>, around: Surroundings<'_>, until: Real) -> Option<Real> {
        if !self.is_stopped_by(other, around) {
            return None;
        }
        let params = around.params;
        let skin = self.collider.contact_skin + other.collider.contact_skin;
        let gap = params.allowed_linear_error().max(GAP_MIN * params.prediction_distance());
        let goal = SweepGoal { gap: gap + skin, on_penetration: params.ccd_on_penetration };
        let shapes = [self.collider.shape(), other.collider.shape()];
        first_impact(shapes, [&self.sweep, &other.sweep], goal, until)
    }

    /// Would the two press on each other if they touched? Where the user's hook has a say in what contacts do, only they
    /// can know.
    fn is_stopped_by(&self, other: &Mover<'_>, around: Surroundings<'_>) -> bool {
        let (own, others) = (self.collider, other.collider);
        let hooks = own.active_hooks() | others.active_hooks();
        !others.is_sensor()
            && may_interact(own, others)
            && own.solver_groups().test(others.solver_groups())
            && !hooks.contains(ActiveHooks::MODIFY_SOLVER_CONTACTS)
            && !self.is_parted_from(other, around)
            && (!hooks.contains(ActiveHooks::FILTER_CONTACT_PAIRS) || {
                let (low, high) = if self.handle.into_raw_parts() < other.handle.into_raw_parts() {
                    (self, other)
                } else {
                    (other, self)
                };
                around.hooks.filter_contact_pair(&PairFilterContext {
                    bodies: around.bodies,
                    colliders: around.colliders,
                    collider1: low.handle,
                    collider2: high.handle,
                    rigid_body1: low.collider.parent(),
                    rigid_body2: high.collider.parent(),
                })
            })
    }

    fn is_parted_from(&self, other: &Mover<'_>, around: Surroundings<'_>) -> bool {
        let (own, others) = (self.collider.parent(), other.collider.parent());
        own.zip(others).is_some_and(|(own, others)| {
            around.islands.joints.part(own.into_raw_parts().0, others.into_raw_parts().0)
        })
    }
}

fn movers<'a>(
    around: Surroundings<'a>,
    body: &RigidBody,
    sweep: impl Fn(&Collider) -> Sweep,
) -> SmallVec<[Mover<'a>; 2]> {
    let solid = body.colliders.iter().filter_map(|&handle| {
        let collider = around.colliders.get(handle)?;
        let is_solid = collider.is_enabled() && !collider.is_sensor();
        is_solid.then(|| Mover { handle, collider, sweep: sweep(collider) })
    });
    solid.collect()
}

/// The motion of something on a fast body that was at `start`, as far as `stop`.
pub(super) fn sweep_of(motion: &FastMotion, start: Pose, stop: Real) -> Sweep {
    Sweep::new(start, motion.center, motion.shift, motion.turn).until(stop)
}

/// From where the collider still is to where its body is.
fn sweep_of_slow(around: Surroundings<'_>, body: &RigidBody, collider: &Collider) -> Sweep {
    let Some(parent) = &collider.parent else { return Sweep::at_rest(collider.pose) };
    if around.islands.motion_of(body_slot(collider)) == 0.0 {
        return Sweep::at_rest(collider.pose);
    }
    let local_center = parent.pos_wrt_parent.inverse_transform_point(body.local_center_of_mass());
    let center = collider.pose * local_center;
    let shift: Vector = body.mprops.world_com - center;
    Sweep::new(collider.pose, center, shift, body.angvel * around.params.dt)
}

fn body_slot(collider: &Collider) -> u32 {
    collider.parent().map_or(NONE, |body| body.into_raw_parts().0)
}
