//! Puts contact points into the world.
//!
//! Manifolds are computed in the frames of the colliders. To *place* a pair is to turn its normals and levers into the
//! world, once; [`AnchorFrame`] says how the solver goes on from there, and why it holds some contacts where they were
//! placed. Those must be placed anew when their bodies have crept on.

use super::view::PairView;
use crate::dim::math::{Pose, Real, Rotation, Vector, ang_length_squared};
use crate::model::body::RigidBody;
use crate::model::collider::Collider;
use crate::model::contact::{AnchorFrame, ContactManifold};
use crate::model::island::turn_bound;

/// What is needed to place the contacts of a pair.
pub(super) struct Place<'a> {
    frames: [Frame<'a>; 2],
    /// From where the levers of the two bodies are measured.
    origins: [Vector; 2],
}

impl<'a> Place<'a> {
    /// As the bodies stand now.
    pub fn of(view: &PairView<'a>) -> Self {
        let [c1, c2] = view.colliders;
        let frames = [Frame::of(c1, view.bodies[0]), Frame::of(c2, view.bodies[1])];
        // The world has no centre of mass: the other body's makes all levers as short as they can be.
        let [x1, x2] = [frames[0].center(), frames[1].center()];
        let origin1 = x1.or(x2).unwrap_or_default();
        Self { frames, origins: [origin1, x2.unwrap_or(origin1)] }
    }

    /// The placement of contacts that are placed now.
    pub fn anchor_frame(&self) -> AnchorFrame {
        let [x1, x2] = [0, 1].map(|side| self.frames[side].center().unwrap_or_default());
        AnchorFrame {
            rotations: [self.frames[0].rotation(), self.frames[1].rotation()],
            centers: x2 - x1,
            may_freeze: self.near_rest(),
        }
    }

    /// Places the contacts of a manifold.
    pub fn put(&self, manifold: &mut ContactManifold) {
        let [frame1, frame2] = &self.frames;
        let normal = frame1.collider.pose.rotation * manifold.local_n1;
        let (skin1, skin2) = (frame1.collider.contact_skin, frame2.collider.contact_skin);
        let between = self.origins[1] - self.origins[0];
        for contact in &mut manifold.data.points {
            // The skin is a layer on each surface: it brings the surfaces closer, and outward.
            let point1 = contact.local_p1 + manifold.local_n1 * skin1;
            let point2 = contact.local_p2 + manifold.local_n2 * skin2;
            let arm1 = frame1.arm(point1, self.origins[0]);
            let gap = frame2.arm(point2, self.origins[1]) - arm1 + between;
            contact.arm = arm1 + gap * 0.5;
            contact.dist = gap.dot(normal);
            contact.placed_dist = contact.dist;
            contact.point = self.origins[0] + contact.arm;
        }
        (manifold.data.normal, manifold.data.placed_normal) = (normal, normal);
    }

    /// Do both bodies creep?
    pub fn near_rest(&self) -> bool {
        self.frames.iter().all(Frame::near_rest)
    }

    /// How far the two bodies may move (a bound, as for slack) until contacts that were placed like this, and are held,
    /// must be placed anew. `friction` is the least coefficient of the contacts. Those that are not held need not be.
    pub fn left(&self, world_anchors: &AnchorFrame, friction: Real) -> Real {
        let frozen = AnchorFrame::frozen_angle(friction);
        if frozen == 0.0 || !world_anchors.may_freeze {
            return Real::INFINITY;
        }
        let left = |side: usize| self.frames[side].turn_left(world_anchors.rotations[side], frozen);
        left(0).min(left(1))
    }
}

/// A collider and the body that the solver moves it with. None of those that are fixed: the solver knows
/// them as the world.
struct Frame<'a> {
    collider: &'a Collider,
    body: Option<(&'a RigidBody, Pose)>,
}

impl<'a> Frame<'a> {
    fn of(collider: &'a Collider, body: Option<&'a RigidBody>) -> Self {
        let moved = body.filter(|body| body.is_dynamic_or_kinematic());
        let body = moved.zip(collider.parent.as_ref().map(|parent| parent.pos_wrt_parent));
        Self { collider, body }
    }

    fn rotation(&self) -> Rotation {
        self.body.map_or(Rotation::IDENTITY, |(body, _)| body.pose.rotation)
    }

    fn center(&self) -> Option<Vector> {
        self.body.map(|(body, _)| body.mprops.world_com)
    }

    /// From an origin to a point of the collider, in world space. The origin is the body's centre of
    /// mass, if there is a body: then no position in the world, with its few digits, comes in.
    fn arm(&self, local: Vector, origin: Vector) -> Vector {
        match self.body {
            Some((body, from_collider)) => {
                body.pose.rotation * (from_collider * local - body.local_center_of_mass())
            }
            None => self.collider.pose * local - origin,
        }
    }

    fn near_rest(&self) -> bool {
        self.body.is_none_or(|(body, _)| {
            AnchorFrame::near_rest(ang_length_squared(body.angvel), body.is_dynamic())
        })
    }

    /// Turning by an angle moves the farthest point of the body by that times its extent.
    fn turn_left(&self, world_anchors: Rotation, frozen: Real) -> Real {
        let Some((body, _)) = self.body else { return Real::INFINITY };
        (frozen - turn_bound(body.pose.rotation, world_anchors)) * body.extent
    }
}
