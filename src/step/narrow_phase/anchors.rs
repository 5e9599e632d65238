//! Transformation of contact points into the world.
//!
//! Manifolds are computed in the frames of the colliders. The normals and moment arms of a pair are
//! transformed into the world once. [`AnchorFrame`] derives how the solver continues from there, and why some
//! anchors are frozen. Frozen anchors are transformed again when their bodies have moved on.

use super::view::PairView;
use crate::dim::math::{Pose, Real, Rotation, Vector, ang_length_squared};
use crate::model::body::RigidBody;
use crate::model::collider::Collider;
use crate::model::contact::{AnchorFrame, ContactManifold};
use crate::model::island::rotation_bound;

/// Input of the transformation of a pair's contacts.
pub(super) struct AnchorTransform<'a> {
    frames: [Frame<'a>; 2],
    /// Reference points of the moment arms of the two bodies.
    origins: [Vector; 2],
}

impl<'a> AnchorTransform<'a> {
    /// The transformation at the current poses.
    pub fn of(view: &PairView<'a>) -> Self {
        let [c1, c2] = view.colliders;
        let frames = [Frame::of(c1, view.bodies[0]), Frame::of(c2, view.bodies[1])];
        // The world has no centre of mass. The other body's centre gives the shortest moment arms.
        let [x1, x2] = [frames[0].center(), frames[1].center()];
        let origin1 = x1.or(x2).unwrap_or_default();
        Self { frames, origins: [origin1, x2.unwrap_or(origin1)] }
    }

    /// The anchor frame of contacts that are transformed now.
    pub fn anchor_frame(&self) -> AnchorFrame {
        let [x1, x2] = [0, 1].map(|side| self.frames[side].center().unwrap_or_default());
        AnchorFrame {
            rotations: [self.frames[0].rotation(), self.frames[1].rotation()],
            centers: x2 - x1,
            may_freeze: self.near_rest(),
        }
    }

    /// Transforms the contacts of a manifold into the world.
    pub fn transform(&self, manifold: &mut ContactManifold) {
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
            contact.anchor_dist = contact.dist;
            contact.point = self.origins[0] + contact.arm;
        }
        (manifold.data.normal, manifold.data.anchor_normal) = (normal, normal);
    }

    /// Returns whether both bodies are near rest.
    pub fn near_rest(&self) -> bool {
        self.frames.iter().all(Frame::near_rest)
    }

    /// Bound on the motion of the two bodies (as for slack) until frozen anchors must be transformed again.
    /// `friction` is the least coefficient of the contacts. Anchors that are not frozen need no bound.
    pub fn remaining_motion(&self, anchor_frame: &AnchorFrame, friction: Real) -> Real {
        let frozen = AnchorFrame::frozen_angle(friction);
        if frozen == 0.0 || !anchor_frame.may_freeze {
            return Real::INFINITY;
        }
        let remaining = |side: usize| {
            self.frames[side].remaining_rotation(anchor_frame.rotations[side], frozen)
        };
        remaining(0).min(remaining(1))
    }
}

/// A collider and the body that the solver moves it with. Fixed bodies have no centre: the solver treats them
/// as the world.
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
            AnchorFrame::near_rest(ang_length_squared(body.vels.angvel), body.is_dynamic())
        })
    }

    /// Bound on the motion until the rotation since `anchor_rotation` reaches an angle. A rotation moves the
    /// farthest point of the body by the angle times its extent.
    fn remaining_rotation(&self, anchor_rotation: Rotation, frozen: Real) -> Real {
        let Some((body, _)) = self.body else { return Real::INFINITY };
        (frozen - rotation_bound(body.pose.rotation, anchor_rotation)) * body.extent
    }
}
