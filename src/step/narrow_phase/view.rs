//! A pair of colliders with its context.

use super::recycle::recycle_distance;
use super::update::NarrowPhaseContext;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::RigidBody;
use crate::model::collider::{ActiveEvents, ActiveHooks, Collider, ColliderHandle, ShapeForm};
use crate::model::hooks::PairFilterContext;
use crate::model::island::NONE;
use parry::bounding_volume::BoundingVolume;

/// The two colliders of a pair and their bodies.
pub(super) struct PairView<'a> {
    pub context: NarrowPhaseContext<'a>,
    pub colliders: [&'a Collider; 2],
    pub bodies: [Option<&'a RigidBody>; 2],
    /// Pose of the second collider in the frame of the first.
    pub pose12: Pose,
}

impl<'a> PairView<'a> {
    pub fn of(context: NarrowPhaseContext<'a>, handles: [ColliderHandle; 2]) -> Option<Self> {
        let collider1 = context.colliders.get(handles[0])?;
        let collider2 = context.colliders.get(handles[1])?;
        let body = |collider: &Collider| context.bodies.get(collider.parent()?);
        Some(Self {
            context,
            colliders: [collider1, collider2],
            bodies: [body(collider1), body(collider2)],
            pose12: collider1.pose.inv_mul(&collider2.pose),
        })
    }

    /// No two points at which the colliders could touch are farther apart than this: the diameter of the
    /// smaller body.
    pub fn reach(&self) -> Real {
        let diameter =
            |body: Option<&RigidBody>| body.map_or(Real::INFINITY, |body| 2.0 * body.extent);
        diameter(self.bodies[0]).min(diameter(self.bodies[1]))
    }

    /// Returns whether both shapes are convex.
    pub fn are_convex(&self) -> bool {
        let [c1, c2] = self.colliders;
        (c1.form & c2.form).contains(ShapeForm::CONVEX)
    }

    /// Returns whether one of the colliders has these events enabled.
    pub fn has_events(&self, events: ActiveEvents) -> bool {
        let [c1, c2] = self.colliders;
        (c1.active_events() | c2.active_events()).contains(events)
    }

    /// Returns whether one of the bodies is awake.
    pub fn is_any_body_awake(&self) -> bool {
        self.bodies.iter().flatten().any(|body| body.link.awake != NONE)
    }

    /// Returns whether the fat AABBs overlap.
    pub fn boxes_overlap(&self) -> bool {
        let [c1, c2] = self.colliders;
        c1.proxy.fat_aabb.intersects(&c2.proxy.fat_aabb)
    }

    /// Returns whether one of the colliders has one of these hooks enabled.
    pub fn has_hooks(&self, hooks: ActiveHooks) -> bool {
        let [c1, c2] = self.colliders;
        (c1.active_hooks() | c2.active_hooks()).intersects(hooks)
    }

    pub fn filter_context(&self, pair: [ColliderHandle; 2]) -> PairFilterContext<'a> {
        PairFilterContext {
            bodies: self.context.bodies,
            colliders: self.context.colliders,
            collider1: pair[0],
            collider2: pair[1],
            rigid_body1: self.colliders[0].parent(),
            rigid_body2: self.colliders[1].parent(),
        }
    }

    /// Displacement of the second collider's body relative to the first's in a step, in the frame of the
    /// first collider.
    pub fn motion(&self) -> Vector {
        let velocity =
            |body: Option<&RigidBody>| body.map_or(Vector::ZERO, |body| body.vels.linvel);
        let relative = velocity(self.bodies[1]) - velocity(self.bodies[0]);
        self.colliders[0].pose.rotation.inverse() * relative * self.context.params.dt
    }

    /// Gap below which contacts are computed.
    pub fn prediction(&self) -> Real {
        let soft_ccd = |body: Option<&RigidBody>| body.map_or(0.0, |body| body.soft_ccd_prediction);
        let soft = soft_ccd(self.bodies[0]).max(soft_ccd(self.bodies[1]));
        let prediction = self.context.params.prediction_distance();
        if soft == 0.0 {
            return prediction;
        }
        // No farther than the two can come together in a step.
        let velocity =
            |body: Option<&RigidBody>| body.map_or(Vector::ZERO, |body| body.vels.linvel);
        let approach = (velocity(self.bodies[1]) - velocity(self.bodies[0])).length();
        prediction.max(soft.min(approach * self.context.params.dt))
    }

    /// The admissible motion of a touching pair until its contacts are recomputed.
    pub fn recycle_distance(&self) -> Real {
        let forms = self.colliders.map(|collider| collider.form);
        recycle_distance(forms, self.context.params.contact_recycle_distance())
    }

    pub fn skin(&self) -> Real {
        self.colliders[0].contact_skin + self.colliders[1].contact_skin
    }
}
