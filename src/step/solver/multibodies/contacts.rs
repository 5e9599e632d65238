//! Contacts of links: with each other, with ordinary bodies, with the world.
//!
//! The rows are those of other contacts (`dim3/contact/mod.rs`), solved point by point. Each point has a
//! normal row with the same softness, and friction within the exact cone `|λt| ≤ μ λn`, independent of
//! [`FrictionModel`](crate::model::params::FrictionModel).

use super::impacts::{LinkImpact, LinkImpactRow};
use super::rows::{ConstrainedStates, JacobianPool, Part, Row};
use super::{LinkPlace, SoftPass, SolverMultibodies};
use crate::dim::math::{
    DIM, MAX_MANIFOLD_POINTS, Real, Rotation, SpatialVector, Vector, mul_inertia, tangents, torque,
};
use crate::dim::spatial::{angular, join, linear};
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::constraint_graph::ManifoldRef;
use crate::model::contact::{AnchorFrame, ContactManifold, NarrowPhase};
use crate::model::island::NONE;
use crate::step::solver::bodies::SolverBodies;
use arrayvec::ArrayVec;

/// The least compliance of a contact between a link and its parent, as a fraction of the value without a
/// joint.
///
/// Near the axis of their joint the moment arm `l` is almost zero, and so is `K = l²/I`. The contact impulse
/// is then `I ω / l`, with friction of the same size. When the moment arm changes in the next substep, the
/// same impulse causes a different rotation. Twenty capsules in a row, hinged end to end with limits, threw
/// each other to 10¹⁸ J in half a second. With a moment arm of at least a fifth of the radius of gyration
/// nothing changes. With a shorter one the contact converges more slowly, and the overlap is as small as the
/// moment arm.
const COMPLIANCE_MIN: Real = 0.02;

/// One contact point.
#[derive(Copy, Clone, Debug)]
pub struct Point {
    position: Vector,
    pub separation: Real,
    pub normal: Row,
    pub tangents: [Row; DIM - 1],
    /// Along each tangent: the velocity that friction brings about (conveyor belts).
    surface: [Real; DIM - 1],
    impulse: Real,
    friction: [Real; DIM - 1],
    /// Sum of the normal impulses of the substeps.
    pub total: Real,
    pub impact: LinkImpactRow,
    /// Whether the contact is deferred to a later substep.
    pub is_aside: bool,
}

/// One manifold.
#[derive(Clone, Debug)]
pub struct LinkContact {
    at: ManifoldRef,
    normal: Vector,
    /// First Jacobian of its rows.
    first_number: usize,
    pub friction: Real,
    pub restitution: Real,
    pub points: ArrayVec<Point, MAX_MANIFOLD_POINTS>,
    pub impact: LinkImpact,
}

/// All contacts of links.
#[derive(Debug, Default)]
pub struct LinkContacts {
    pub contacts: Vec<LinkContact>,
}

/// One side of a manifold at the current pose.
pub(super) struct Side<'a> {
    /// Links, and roots that are led, which are ordinary bodies here.
    link: Option<LinkPlace>,
    /// An ordinary body that can move, with its index in the solver.
    pub body: Option<(&'a RigidBody, u32)>,
    pub rotation: Rotation,
    /// The centre of mass; `None` for an immovable body.
    pub center: Option<Vector>,
    /// Whether the other side moves it.
    gives_way: bool,
}

/// Current world-space geometry of a manifold.
struct Geometry {
    normal: Vector,
    /// By point: where it is, how far apart the surfaces are.
    points: ArrayVec<(Vector, Real), MAX_MANIFOLD_POINTS>,
}

impl SolverMultibodies {
    /// Makes constraints of the manifolds that were left out of the lanes.
    pub(super) fn prepare_contacts(
        &mut self,
        narrow_phase: &NarrowPhase,
        world: &RigidBodySet,
        bodies: &SolverBodies,
    ) {
        self.contacts.contacts.clear();
        self.moving.iter_mut().for_each(|moving| moving.touches = false);
        // The links of one multibody are coupled by each other's contacts, so the order matters. The order of
        // contacts in their colours depends on the rest of the world.
        let order = |at: &ManifoldRef| (narrow_phase.contacts.collider_slots(at.pair), at.manifold);
        self.left_out.sort_unstable_by_key(order);
        for position in 0..self.left_out.len() {
            let at = self.left_out[position];
            let slots = narrow_phase.contacts.bodies(at.pair);
            if let [Some(one), Some(two)] = slots.map(|slot| self.place(slot))
                && one.multibody == two.multibody
                && !self.moving[one.multibody].multibody.may_touch(one.link, two.link)
            {
                continue;
            }
            let pair = &narrow_phase.contacts[at.pair];
            let manifold = &pair.manifolds[at.manifold as usize];
            let dominance = manifold.data.relative_dominance;
            let sides = [
                self.side(slots[0], dominance <= 0, world, bodies),
                self.side(slots[1], dominance >= 0, world, bodies),
            ];
            for place in sides.iter().filter_map(Side::place) {
                self.moving[place.multibody].touches = true;
            }
            let normal = normal_of(&sides, &pair.anchor_frame, manifold);
            let geometry = Geometry::of(&sides, &pair.anchor_frame, manifold, normal);
            let contact = self.contact(at, &sides, &geometry, manifold);
            self.contacts.contacts.push(contact);
        }
    }

    pub(super) fn side<'a>(
        &self,
        slot: u32,
        gives_way: bool,
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
            gives_way,
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

    fn contact(
        &mut self,
        at: ManifoldRef,
        sides: &[Side<'_>; 2],
        geometry: &Geometry,
        manifold: &ContactManifold,
    ) -> LinkContact {
        let data = &manifold.data;
        let first_number = self.jacobians.len();
        let along = tangents(geometry.normal);
        let fraction = self.fraction_of(sides);
        let points =
            geometry.points.iter().zip(&data.points).map(|(&(position, separation), known)| {
                Point {
                    position,
                    separation,
                    normal: self.row(sides, [position; 2], geometry.normal),
                    tangents: along.map(|tangent| self.row(sides, [position; 2], tangent)),
                    surface: along.map(|tangent| tangent.dot(data.tangent_velocity)),
                    impulse: known.warmstart_impulse * fraction,
                    friction: known.warmstart_tangent_impulse.map(|impulse| impulse * fraction),
                    total: 0.0,
                    impact: LinkImpactRow::default(),
                    is_aside: false,
                }
            });
        let points = points.collect();
        let (friction, restitution) = (data.friction, data.restitution);
        let impact = LinkImpact::of(self.island_of(sides));
        let normal = geometry.normal;
        LinkContact { at, normal, first_number, friction, restitution, points, impact }
    }

    /// Recomputes the rows of a contact at the current poses.
    ///
    /// Normal and moment arms stay constant during a step, as for bodies: the lowest point of a rolling ball
    /// stays the lowest.
    pub(super) fn follow_contact(
        &mut self,
        position: usize,
        (narrow_phase, world): (&NarrowPhase, &RigidBodySet),
        bodies: &mut SolverBodies,
    ) {
        let LinkContact { at, first_number, normal, .. } = self.contacts.contacts[position];
        let pair = &narrow_phase.contacts[at.pair];
        let manifold = &pair.manifolds[at.manifold as usize];
        let dominance = manifold.data.relative_dominance;
        let slots = narrow_phase.contacts.bodies(at.pair);
        let sides = [
            self.side_now(slots[0], dominance <= 0, world, bodies),
            self.side_now(slots[1], dominance >= 0, world, bodies),
        ];
        let displacements = [0, 1].map(|side| sides[side].displacement_since(world, slots[side]));
        let separations = Geometry::of(&sides, &pair.anchor_frame, manifold, normal).points;
        let along = tangents(normal);
        self.jacobians.rewrite_from(first_number);
        let mut points = core::mem::take(&mut self.contacts.contacts[position].points);
        for (point, (_, separation)) in points.iter_mut().zip(separations) {
            let places = displacements.map(|way| point.position + way);
            point.normal = self.row(&sides, places, normal);
            point.tangents = along.map(|tangent| self.row(&sides, places, tangent));
            let states =
                ConstrainedStates { multibodies: &mut self.moving, states: &mut bodies.states };
            point.separation = separation - self.jacobians.displacement(&point.normal, &states);
        }
        self.jacobians.append();
        self.contacts.contacts[position].points = points;
    }

    /// Recomputes the rows of contacts of far-rotating links at the current poses.
    pub fn follow_contacts(
        &mut self,
        place: (&NarrowPhase, &RigidBodySet),
        bodies: &mut SolverBodies,
    ) {
        if !self.any_turns_far() {
            return;
        }
        for position in 0..self.contacts.contacts.len() {
            let slots = place.0.contacts.bodies(self.contacts.contacts[position].at.pair);
            let turns_far =
                |slot| self.place(slot).is_some_and(|place| self.moving[place.multibody].turns_far);
            if slots.into_iter().any(turns_far) {
                self.warm_contact(position, bodies, -1.0);
                self.follow_contact(position, place, bodies);
                self.warm_contact(position, bodies, 1.0);
            }
        }
    }

    /// Adds this fraction of a contact's impulses to the warm start of the substep.
    fn warm_contact(&mut self, position: usize, bodies: &mut SolverBodies, fraction: Real) {
        let Self { jacobians, contacts, moving, .. } = self;
        let mut states = ConstrainedStates { multibodies: moving, states: &mut bodies.states };
        for (row, impulse, _) in contacts.contacts[position].points.iter().flat_map(Point::rows) {
            jacobians.push_early(row, impulse * fraction, &mut states);
        }
    }

    /// The fraction of their last impulses with which two sides begin.
    pub(super) fn fraction_of(&self, sides: &[Side<'_>; 2]) -> Real {
        let place = sides.iter().find_map(Side::place);
        place.map_or(1.0, |place| self.moving[place.multibody].fraction)
    }

    /// The island of the links among two sides.
    fn island_of(&self, sides: &[Side<'_>; 2]) -> u32 {
        let place = sides.iter().find_map(Side::place);
        place.map_or(NONE, |place| self.moving[place.multibody].island)
    }

    /// The row of the second side's velocity against the first's along a direction, at a point of each.
    fn row(&mut self, sides: &[Side<'_>; 2], points: [Vector; 2], direction: Vector) -> Row {
        let [first, second] = points;
        let wrenches = [sides[0].wrench(first, -direction), sides[1].wrench(second, direction)];
        let row = self.row_of_wrenches(sides, wrenches);
        row.with_compliance_min(COMPLIANCE_MIN * self.yield_without_joint(sides))
    }

    /// The compliance of a link and its parent against an impulse through their centres, if no joint held
    /// them. Zero for other pairs.
    fn yield_without_joint(&self, sides: &[Side<'_>; 2]) -> Real {
        let [Some(one), Some(two)] = [sides[0].link, sides[1].link] else { return 0.0 };
        let links = &self.moving[one.multibody].motion.kinematics.links;
        let are_joined = one.multibody == two.multibody
            && (links[one.link].parent == Some(two.link)
                || links[two.link].parent == Some(one.link));
        let moving = [one, two].into_iter().filter(|place| are_joined && place.is_moved);
        let masses = moving.map(|place| links[place.link].mass);
        masses.filter(|&mass| mass > 0.0).map(|mass| 1.0 / mass).sum()
    }

    /// The row whose impulse gives each side a wrench about its centre of mass.
    pub(super) fn row_of_wrenches(
        &mut self,
        sides: &[Side<'_>; 2],
        wrenches: [SpatialVector; 2],
    ) -> Row {
        let parts = match [sides[0].place(), sides[1].place()] {
            [Some(one), Some(two)] if one.multibody == two.multibody => {
                let gives_way = sides[0].gives_way || sides[1].gives_way;
                let fill = |moving: &super::Moving, jacobian: &mut [Real], sizes: &mut [Real]| {
                    let kinematics = &moving.motion.kinematics;
                    kinematics.add_measured_force(one.link, &wrenches[0], jacobian, sizes);
                    kinematics.add_measured_force(two.link, &wrenches[1], jacobian, sizes);
                };
                let part =
                    self.jacobians.add_links(&mut self.moving, one.multibody, gives_way, fill);
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
                side.gives_way,
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
        let response = if side.gives_way { response } else { [0.0; _] };
        Part::Body { index, jacobian: wrench, response }
    }
}

impl Side<'_> {
    /// The link that it is, if its multibody moves it.
    fn place(&self) -> Option<LinkPlace> {
        self.link.filter(|place| place.is_moved)
    }

    /// Displacement of its centre of mass since the step began.
    fn displacement_since(&self, world: &RigidBodySet, slot: u32) -> Vector {
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
fn normal_of(sides: &[Side<'_>; 2], placed: &AnchorFrame, manifold: &ContactManifold) -> Vector {
    sides[0].rotation * placed.rotations[0].inverse() * manifold.data.placed_normal
}

impl Geometry {
    /// Follows the contact points from where they were placed, as
    /// [`MotionSince`](crate::model::contact::MotionSince) does for lanes.
    fn of(
        sides: &[Side<'_>; 2],
        placed: &AnchorFrame,
        manifold: &ContactManifold,
        normal: Vector,
    ) -> Self {
        let [x1, x2] = [0, 1].map(|side| sides[side].center.unwrap_or_default());
        let turns = [0, 1].map(|side| sides[side].rotation * placed.rotations[side].inverse());
        let has_world = sides.iter().any(|side| side.center.is_none());
        let (offset, offset_now) =
            if has_world { (Vector::ZERO, Vector::ZERO) } else { (-placed.centers, x1 - x2) };
        let shift = (x2 - x1) - placed.centers;
        let origin = if sides[0].center.is_none() { x2 } else { x1 };
        let follow = |known: &crate::model::contact::Contact| {
            let second = known.arm + offset;
            let (turned1, turned2) = (turns[0] * known.arm, turns[1] * second);
            let moved = shift + (turned2 - second) - (turned1 - known.arm);
            let arm = match sides[1].center {
                None => turned1 + moved * 0.5,
                Some(_) => turned2 - moved * 0.5 - offset_now,
            };
            (origin + arm, known.placed_dist + normal.dot(moved))
        };
        Self { normal, points: manifold.data.points.iter().map(follow).collect() }
    }
}

impl LinkContacts {
    fn points(&mut self) -> impl Iterator<Item = &mut Point> {
        self.contacts.iter_mut().flat_map(|contact| &mut contact.points)
    }

    /// Starts the step with the last one's impulses.
    pub fn warm_start(&mut self, jacobians: &JacobianPool, states: &mut ConstrainedStates<'_>) {
        for point in self.points() {
            jacobians.push_early(&point.normal, point.impulse, states);
            for (row, impulse) in point.tangents.iter().zip(&point.friction) {
                jacobians.push_early(row, *impulse, states);
            }
        }
    }

    /// Scales the impulses with which the next substep starts, by a factor for each row.
    pub fn scale_impulses(&mut self, factor: impl Fn(&Row) -> Real) {
        for point in self.points() {
            let factor = factor(&point.normal);
            point.impulse *= factor;
            point.friction = point.friction.map(|impulse| impulse * factor);
        }
    }

    /// Solves the normal rows once.
    pub fn solve(
        &mut self,
        jacobians: &JacobianPool,
        states: &mut ConstrainedStates<'_>,
        pass: &SoftPass,
        bias: bool,
    ) {
        for point in self.points() {
            let velocity = jacobians.velocity(&point.normal, states);
            let separation =
                point.shown_separation() + jacobians.displacement(&point.normal, states);
            let new = pass.solve(velocity, separation, point.normal.mass, point.impulse, bias);
            jacobians.push(&point.normal, new - point.impulse, states);
            point.impulse = new;
        }
    }

    /// Solves the friction rows once, under the normal impulses as they are.
    pub fn solve_friction(&mut self, jacobians: &JacobianPool, states: &mut ConstrainedStates<'_>) {
        for contact in &mut self.contacts {
            for point in &mut contact.points {
                let old = point.friction;
                let most = contact.friction * point.impulse;
                let new = point.friction_under(most, old, jacobians, states);
                for k in 0..DIM - 1 {
                    jacobians.push(&point.tangents[k], new[k] - old[k], states);
                }
                point.friction = new;
            }
        }
    }

    /// All rows with their impulses, and with the velocities that these bring about.
    pub fn rows(&self) -> impl Iterator<Item = (&Row, Real, Real)> {
        self.contacts.iter().flat_map(|contact| &contact.points).flat_map(Point::rows)
    }

    /// Counts the impulses of the substep into those of the step.
    pub fn count(&mut self) {
        self.points().for_each(|point| point.total += point.impulse);
    }

    /// Writes impulses, and where the contacts were, back to the manifolds.
    pub fn store(&self, narrow_phase: &mut NarrowPhase) {
        for contact in &self.contacts {
            let pair = &mut narrow_phase.contacts[contact.at.pair];
            let data = &mut pair.manifolds[contact.at.manifold as usize].data;
            if !contact.is_sound() {
                data.forget_impulses();
                continue;
            }
            data.normal = contact.normal;
            data.warmstart_friction = Vector::ZERO;
            data.warmstart_twist = 0.0;
            for (known, point) in data.points.iter_mut().zip(&contact.points) {
                (known.point, known.dist) = (point.position, point.separation);
                (known.impulse, known.warmstart_impulse) = (point.total, point.impulse);
                known.warmstart_tangent_impulse = point.friction;
            }
        }
    }
}

impl Point {
    fn rows(&self) -> impl Iterator<Item = (&Row, Real, Real)> {
        let along = (0..DIM - 1).map(|k| (&self.tangents[k], self.friction[k], self.surface[k]));
        core::iter::once((&self.normal, self.impulse, 0.0)).chain(along)
    }

    /// The impulses of friction that stop the slip, if they need not be larger than `most`; `old` ones have
    /// been given already.
    pub fn friction_under(
        &self,
        most: Real,
        old: [Real; DIM - 1],
        jacobians: &JacobianPool,
        states: &ConstrainedStates<'_>,
    ) -> [Real; DIM - 1] {
        let mut new = old;
        for k in 0..DIM - 1 {
            let row = &self.tangents[k];
            let slip = jacobians.velocity(row, states) - self.surface[k];
            new[k] -= slip * row.mass;
        }
        let length = new.iter().map(|impulse| impulse * impulse).sum::<Real>().sqrt();
        if length > most { new.map(|impulse| impulse * (most / length)) } else { new }
    }
}

impl LinkContact {
    /// Returns whether all numbers are finite.
    fn is_sound(&self) -> bool {
        self.normal.is_finite()
            && self.points.iter().all(|point| {
                let impulses = point.friction.iter().chain([&point.impulse, &point.total]);
                let mut jacobians = impulses.chain([&point.separation]);
                point.position.is_finite() && jacobians.all(|number| number.is_finite())
            })
    }
}
