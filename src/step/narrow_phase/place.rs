//! Where contact points are in the world, and for how long.
//!
//! Manifolds are computed in the frames of the colliders. To *place* a pair is to turn its normals and
//! levers into the world. Bodies that turn take them along; but while a body hardly turns they stay as they
//! are, up to [`TURN_MAX`], and only the separations follow from step to step.
//!
//! # Why not follow the bodies at once
//!
//! Because piles would buckle that cannot. The faces of two rigid boxes on each other do not give way,
//! but the soft contacts of the solver do: under a moment they yield like a hinge with a spring. A tower
//! of `n` boxes of size `a` and mass `m` is then an elastic column, and under its own weight it buckles
//! (Greenhill 1881) when the stiffness `k` of its hinges is less than
//!
//! ```text
//! k  <  n³ m g a / 7.84        k = β m a² / (8 σ h²) for unit boxes (see `model/params/softness`)
//! ```
//!
//! which for our contacts are towers of some twenty boxes. What tips a column is the moment of its load
//! about the leaning part below, the load times how far the levers have turned. With levers that keep
//! their places that moment is zero, as it is between faces that cannot give way, and the column is a
//! beam without a load along it, which is stable whatever its height. The alternative, stiffer contacts,
//! would have to be a hundred times as stiff for a pile of a hundred layers, and one visit per substep
//! does not converge for these. Box3D keeps its anchors for the same reason, for up to seven degrees.
//!
//! # The price
//!
//! That moment is real. Without it, action and reaction of a contact do not act along one line, and the pair's
//! angular momentum is not conserved: two cubes that are pressed together and spin as one would be stopped. So it
//! is left out only where a pile creeps: on dynamic bodies that turn more slowly than [`SLOW`]. The normal lags
//! behind, too, which friction must hide: the less there is of it, the less the lag ([`LAG_OF_FRICTION`]). What is
//! wrong in the end is the load's lever, by a few hundredths of the body's size, and the slope under what stands on
//! a dynamic body that tilts by less than 3 degrees a minute. Bodies that turn or slide *against* each other are
//! computed anew after a far smaller motion ([`recycle`](super::recycle)).

use super::update::PairView;
use crate::dim::math::{Pose, Real, Rotation, Vector, ang_length_squared};
use crate::model::body::RigidBody;
use crate::model::collider::Collider;
use crate::model::contact::{ContactManifold, Placement};

/// By how much (rad) a dynamic body may creep before its contacts are placed anew: three degrees.
const TURN_MAX: Real = 0.05;

/// Dynamic bodies that turn faster than this (rad/s) do not creep. The layers of a pyramid of a hundred rows that
/// settles stay below it; at 0.02 they did not, and it was seen to lean.
const SLOW: Real = 0.05;

/// The turn (rad) that may lag behind, in units of the friction coefficient: the slope that friction can hold is
/// right to a tenth.
const LAG_OF_FRICTION: Real = 0.1;

/// The same for bodies that do not creep, and those that the user moves: nothing bends them, so there is nothing
/// to hold straight. What stands on a platform that tilts is to feel it.
const DRIVEN_TURN_MAX: Real = 0.002;

/// A rotation moves no unit vector farther than this factor times the farthest that it moves one of the
/// axes: at least one axis is at 54.7 degrees or more from the axis of rotation, and 1 / sin 54.7° is
/// the square root of 3/2.
const TURN_BOUND: Real = 1.225;

/// A bound of how far two rotations take a unit vector apart.
pub(super) fn turn_bound(a: Rotation, b: Rotation) -> Real {
    let apart = Vector::AXES.map(|axis| (a * axis - b * axis).length_squared());
    TURN_BOUND * apart.into_iter().fold(0.0, Real::max).sqrt()
}

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
    pub fn placement(&self) -> Placement {
        let [x1, x2] = [0, 1].map(|side| self.frames[side].center().unwrap_or_default());
        Placement {
            rotations: [self.frames[0].rotation(), self.frames[1].rotation()],
            centers: x2 - x1,
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
            let lever1 = frame1.lever(point1, self.origins[0]);
            let gap = frame2.lever(point2, self.origins[1]) - lever1 + between;
            contact.lever = lever1 + gap * 0.5;
            contact.dist = gap.dot(normal);
            contact.placed_dist = contact.dist;
            contact.point = self.origins[0] + contact.lever;
        }
        manifold.data.normal = normal;
    }

    /// How far the two bodies may move (a bound, as for slack) until contacts that were placed like this
    /// must be placed anew. `friction` is the least coefficient of the contacts.
    pub fn left(&self, placed: &Placement, friction: Real) -> Real {
        let lag = (LAG_OF_FRICTION * friction).clamp(DRIVEN_TURN_MAX, TURN_MAX);
        let left = |side: usize| self.frames[side].turn_left(placed.rotations[side], lag);
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
    fn lever(&self, local: Vector, origin: Vector) -> Vector {
        match self.body {
            Some((body, from_collider)) => {
                body.pose.rotation * (from_collider * local - body.local_center_of_mass())
            }
            None => self.collider.pose * local - origin,
        }
    }

    /// See [`Place::left`]. Turning by an angle moves the farthest point of the body by that times its
    /// extent. Creeping bodies may lag behind by `lag`.
    fn turn_left(&self, placed: Rotation, lag: Real) -> Real {
        let Some((body, _)) = self.body else { return Real::INFINITY };
        let creeps = body.is_dynamic() && ang_length_squared(body.angvel) < SLOW * SLOW;
        let limit = if creeps { lag } else { DRIVEN_TURN_MAX };
        (limit - turn_bound(body.pose.rotation, placed)) * body.extent
    }
}
