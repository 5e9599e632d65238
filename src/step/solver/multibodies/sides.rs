//! The two sides of a contact or a loop: links, ordinary bodies, or the world.

use super::rows::{Part, Row};
use super::{LinkPlace, SolverMultibodies};
use crate::dim::math::{
    MAX_MANIFOLD_POINTS, Real, Rotation, SpatialVector, Vector, mul_inertia, torque,
};
use crate::dim::spatial::{angular, join, linear};
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::contact::{AnchorFrame, ContactManifold};
use crate::model::island::NONE;
use crate::step::solver::bodies::SolverBodies;
use arrayvec::ArrayVec;

/// One side of a manifold at the current pose.
pub(super) struct Side<'a> {
    /// A link. [`Self::place`] excludes kinematic roots, which are ordinary bodies here.
    pub link: Option<LinkPlace>,
    /// An ordinary body that can move, with its index in the solver.
    pub body: Option<(&'a RigidBody, u32)>,
    pub rotation: Rotation,
    /// The centre of mass; `None` for an immovable body.
    pub center: Option<Vector>,
    /// Whether the other side moves it.
    pub is_movable: bool,
}

/// Current world-space geometry of a manifold.
pub(super) struct Geometry {
    pub normal: Vector,
    /// By point: its position, and the distance of the surfaces.
    pub points: ArrayVec<(Vector, Real), MAX_MANIFOLD_POINTS>,
}

impl SolverMultibodies {
    /// The side of a contact or a loop that is the body in a slot.
    pub(super) fn side<'a>(
        &self,
        slot: u32,
        is_movable: bool,
        world: &'a RigidBodySet,
        bodies: &SolverBodies,
    ) -> Side<'a> {
        let body = world.at_slot(slot).map(|(_, body)| body);
        let body = body.filter(|body| body.is_dynamic_or_kinematic());
        let side = Side {
            link: self.place(slot),
            body: None,
            rotation: Rotation::IDENTITY,
            center: None,
            is_movable,
        };
        if let Some(place) = side.place() {
            let frame = &self.moving[place.multibody].motion.kinematics.links[place.link];
            return Side { rotation: frame.rotation, center: Some(frame.center), ..side };
        }
        Side {
            rotation: body.map_or(Rotation::IDENTITY, |body| body.pose.rotation),
            center: body.map(|body| body.mprops.world_com),
            body: body.map(|body| (body, bodies.index_of(slot))),
            ..side
        }
    }

    /// The fraction of their last impulses with which two sides begin.
    pub(super) fn fraction_of(&self, sides: &[Side<'_>; 2]) -> Real {
        let place = sides.iter().find_map(Side::place);
        place.map_or(1.0, |place| self.moving[place.multibody].fraction)
    }

    /// The island of the links among two sides.
    pub(super) fn island_of(&self, sides: &[Side<'_>; 2]) -> u32 {
        let place = sides.iter().find_map(Side::place);
        place.map_or(NONE, |place| self.moving[place.multibody].island)
    }

    /// The row whose impulse gives each side a wrench about its centre of mass.
    pub(super) fn row_of_wrenches(
        &mut self,
        sides: &[Side<'_>; 2],
        wrenches: [SpatialVector; 2],
    ) -> Row {
        let parts = match [sides[0].place(), sides[1].place()] {
            [Some(one), Some(two)] if one.multibody == two.multibody => {
                let is_movable = sides[0].is_movable || sides[1].is_movable;
                let fill = |moving: &super::Moving, jacobian: &mut [Real], sizes: &mut [Real]| {
                    let kinematics = &moving.motion.kinematics;
                    kinematics.add_measured_force(one.link, &wrenches[0], jacobian, sizes);
                    kinematics.add_measured_force(two.link, &wrenches[1], jacobian, sizes);
                };
                let part =
                    self.jacobians.add_links(&mut self.moving, one.multibody, is_movable, fill);
                [part, Part::Nothing]
            }
            _ => [self.part(&sides[0], wrenches[0]), self.part(&sides[1], wrenches[1])],
        };
        self.jacobians.row(parts)
    }

    fn part(&mut self, side: &Side<'_>, wrench: SpatialVector) -> Part {
        if let Some(place) = side.place() {
            return self.jacobians.add_links(
                &mut self.moving,
                place.multibody,
                side.is_movable,
                |moving, jacobian, sizes| {
                    moving
                        .motion
                        .kinematics
                        .add_measured_force(place.link, &wrench, jacobian, sizes);
                },
            );
        }
        let Some((body, index)) = side.body else { return Part::Nothing };
        let mprops = &body.mprops;
        let response = join(
            linear(&wrench) * mprops.inv_mass,
            mul_inertia(&mprops.inv_inertia, angular(&wrench)),
        );
        let response = if side.is_movable { response } else { [0.0; _] };
        Part::Body { index, jacobian: wrench, response }
    }
}

impl Side<'_> {
    /// The link that it is, if its multibody moves it.
    pub fn place(&self) -> Option<LinkPlace> {
        self.link.filter(|place| place.is_moved)
    }

    /// Displacement of its centre of mass since the step began.
    pub fn displacement_since(&self, world: &RigidBodySet, slot: u32) -> Vector {
        let start = world.at_slot(slot).map(|(_, body)| body.mprops.world_com);
        self.center.zip(start).map_or(Vector::ZERO, |(now, start)| now - start)
    }

    /// A unit force along a direction at a point, as a wrench on the centre of mass.
    pub fn wrench(&self, point: Vector, direction: Vector) -> SpatialVector {
        let arm = self.center.map_or(Vector::ZERO, |center| point - center);
        join(direction, torque(arm, direction))
    }
}

/// The normal of a manifold, which turns with the first side.
pub(super) fn normal_of(
    sides: &[Side<'_>; 2],
    anchor_frame: &AnchorFrame,
    manifold: &ContactManifold,
) -> Vector {
    sides[0].rotation * anchor_frame.rotations[0].inverse() * manifold.data.anchor_normal
}

impl Geometry {
    /// Moves the contact points from their anchors with the bodies, as
    /// [`MotionSince`](crate::model::contact::MotionSince) does for lanes.
    pub fn of(
        sides: &[Side<'_>; 2],
        anchor_frame: &AnchorFrame,
        manifold: &ContactManifold,
        normal: Vector,
    ) -> Self {
        let [x1, x2] = [0, 1].map(|side| sides[side].center.unwrap_or_default());
        let turns =
            [0, 1].map(|side| sides[side].rotation * anchor_frame.rotations[side].inverse());
        let has_world = sides.iter().any(|side| side.center.is_none());
        let (offset, offset_now) =
            if has_world { (Vector::ZERO, Vector::ZERO) } else { (-anchor_frame.centers, x1 - x2) };
        let shift = (x2 - x1) - anchor_frame.centers;
        let origin = if sides[0].center.is_none() { x2 } else { x1 };
        let follow = |known: &crate::model::contact::Contact| {
            let second = known.arm + offset;
            let (turned1, turned2) = (turns[0] * known.arm, turns[1] * second);
            let moved = shift + (turned2 - second) - (turned1 - known.arm);
            let arm = match sides[1].center {
                None => turned1 + moved * 0.5,
                Some(_) => turned2 - moved * 0.5 - offset_now,
            };
            (origin + arm, known.anchor_dist + normal.dot(moved))
        };
        Self { normal, points: manifold.data.points.iter().map(follow).collect() }
    }
}
