//! Contacts of links: with each other, with ordinary bodies, with the world.
//!
//! The rows are those of other contacts (`dim3/contact/mod.rs`), solved point by point. Each point has a
//! normal row with the same softness, and friction within the exact cone `|λt| ≤ μ λn`, independent of
//! [`FrictionModel`](crate::model::params::FrictionModel).

use super::impacts::{LinkImpact, LinkImpactRow};
use super::rows::{ConstrainedStates, JacobianPool, Row};
use super::sides::{Geometry, Side, normal_of};
use super::{SolverMultibodies, solve_unilateral};
use crate::dim::contact::PointTangentMass;
use crate::dim::math::{DIM, MAX_MANIFOLD_POINTS, Real, Vector, tangents};
use crate::model::constraint_graph::ManifoldRef;
use crate::model::contact::{ContactManifold, NarrowPhase};
use crate::model::frozen::Frozen;
use crate::model::params::ContactPass;
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::context::SolverInput;
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
    tangent_mass: PointTangentMass,
    /// Along each tangent: the velocity that friction brings about (conveyor belts).
    surface: [Real; DIM - 1],
    impulse: Real,
    friction: [Real; DIM - 1],
    /// Sum of the normal impulses of the substeps.
    pub total: Real,
    pub impact: LinkImpactRow,
    /// Whether the contact is deferred to a later substep.
    pub is_deferred: bool,
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

impl SolverMultibodies {
    /// Makes constraints of the manifolds of links.
    pub(super) fn prepare_contacts(
        &mut self,
        manifolds: &[ManifoldRef],
        input: SolverInput<'_>,
        bodies: &SolverBodies,
    ) {
        let SolverInput { world, narrow_phase, .. } = input;
        self.contacts.contacts.clear();
        self.moving.iter_mut().for_each(|moving| moving.touches = false);
        // The links of one multibody are coupled by each other's contacts, so the order matters. The order of
        // contacts in their colours depends on the rest of the world.
        let order = |at: &ManifoldRef| (narrow_phase.contacts.collider_slots(at.pair), at.manifold);
        let mut solved_now = core::mem::take(&mut self.manifolds);
        let solved = |at: &&ManifoldRef| self.solves_one_of(narrow_phase.contacts.bodies(at.pair));
        solved_now.clear();
        solved_now.extend(manifolds.iter().filter(solved));
        solved_now.sort_unstable_by_key(order);
        for &at in &solved_now {
            let slots = narrow_phase.contacts.bodies(at.pair);
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
        self.manifolds = solved_now;
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
                let normal = self.row(sides, [position; 2], geometry.normal);
                let tangents = along.map(|tangent| self.row(sides, [position; 2], tangent));
                Point {
                    position,
                    separation,
                    normal,
                    tangents,
                    tangent_mass: self.jacobians.tangent_mass(&tangents),
                    surface: along.map(|tangent| tangent.dot(data.tangent_velocity)),
                    impulse: known.warmstart_impulse * fraction,
                    friction: known.warmstart_tangent_impulse.map(|impulse| impulse * fraction),
                    total: 0.0,
                    impact: LinkImpactRow::default(),
                    is_deferred: false,
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
        SolverInput { world, narrow_phase, .. }: SolverInput<'_>,
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
            let places = displacements.map(|displacement| point.position + displacement);
            point.normal = self.row(&sides, places, normal);
            point.tangents = along.map(|tangent| self.row(&sides, places, tangent));
            point.tangent_mass = self.jacobians.tangent_mass(&point.tangents);
            let states =
                ConstrainedStates { multibodies: &mut self.moving, states: &mut bodies.states };
            point.separation = separation - self.jacobians.displacement(&point.normal, &states);
        }
        self.jacobians.append();
        self.contacts.contacts[position].points = points;
    }

    /// Recomputes the rows of contacts of far-rotating links at the current poses.
    pub fn follow_contacts(&mut self, input: SolverInput<'_>, bodies: &mut SolverBodies) {
        if !self.any_turns_far() {
            return;
        }
        for position in 0..self.contacts.contacts.len() {
            let contacts = &input.narrow_phase.contacts;
            let slots = contacts.bodies(self.contacts.contacts[position].at.pair);
            let turns_far =
                |slot| self.place(slot).is_some_and(|place| self.moving[place.multibody].turns_far);
            if slots.into_iter().any(turns_far) {
                self.warm_contact(position, bodies, -1.0);
                self.follow_contact(position, input, bodies);
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

    /// The row of the second side's velocity against the first's along a direction, at a point of each.
    fn row(&mut self, sides: &[Side<'_>; 2], points: [Vector; 2], direction: Vector) -> Row {
        let [first, second] = points;
        let wrenches = [sides[0].wrench(first, -direction), sides[1].wrench(second, direction)];
        let row = self.row_of_wrenches(sides, wrenches);
        row.with_compliance_min(COMPLIANCE_MIN * self.compliance_without_joint(sides))
    }

    /// The compliance of a link and its parent against an impulse through their centres, if no joint held
    /// them. Zero for other pairs.
    fn compliance_without_joint(&self, sides: &[Side<'_>; 2]) -> Real {
        let [Some(one), Some(two)] = [sides[0].link, sides[1].link] else { return 0.0 };
        let links = &self.moving[one.multibody].motion.kinematics.links;
        let are_joined = one.multibody == two.multibody
            && (links[one.link].parent == Some(two.link)
                || links[two.link].parent == Some(one.link));
        let moving = [one, two].into_iter().filter(|place| are_joined && place.is_moved);
        let masses = moving.map(|place| links[place.link].mass);
        masses.filter(|&mass| mass > 0.0).map(|mass| 1.0 / mass).sum()
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
        pass: &ContactPass,
        bias: bool,
    ) {
        for point in self.points() {
            let velocity = jacobians.velocity(&point.normal, states);
            let separation =
                point.shown_separation() + jacobians.displacement(&point.normal, states);
            let (mass, old) = (point.normal.mass, point.impulse);
            let new = solve_unilateral(pass, velocity, separation, mass, old, bias);
            jacobians.push(&point.normal, new - old, states);
            point.impulse = new;
        }
    }

    /// Solves the friction rows once, under the normal impulses as they are.
    pub fn solve_friction(&mut self, jacobians: &JacobianPool, states: &mut ConstrainedStates<'_>) {
        for contact in &mut self.contacts {
            for point in &mut contact.points {
                let old = point.friction;
                let limit = contact.friction * point.impulse;
                let new = point.friction_within(limit, old, jacobians, states);
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
        debug_assert!(!self.points().any(|point| point.impulse < 0.0), "contacts push");
        self.points().for_each(|point| point.total += point.impulse);
    }

    /// Writes impulses, and where the contacts were, back to the manifolds.
    pub fn store(&self, narrow_phase: &mut Frozen<'_, NarrowPhase>) {
        for contact in &self.contacts {
            let pair = narrow_phase.pair_mut(contact.at.pair);
            let data = &mut pair.manifolds[contact.at.manifold as usize].data;
            if !contact.is_sound() {
                data.clear_impulses();
                continue;
            }
            data.normal = contact.normal;
            data.clear_friction();
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

    /// The new impulses of friction, together at most `limit`: see `dim3/contact/tangents.rs`.
    pub fn friction_within(
        &self,
        limit: Real,
        old: [Real; DIM - 1],
        jacobians: &JacobianPool,
        states: &ConstrainedStates<'_>,
    ) -> [Real; DIM - 1] {
        let mut slip = [0.0; DIM - 1];
        for k in 0..DIM - 1 {
            slip[k] = jacobians.velocity(&self.tangents[k], states) - self.surface[k];
        }
        self.tangent_mass.friction(old, slip, limit)
    }
}

impl JacobianPool {
    fn tangent_mass(&self, tangents: &[Row; DIM - 1]) -> PointTangentMass {
        let coupling = || self.coupling(&tangents[0], &tangents[DIM - 2]) as Real;
        PointTangentMass::of(tangents.map(|row| row.mass), coupling)
    }
}

impl LinkContact {
    /// Returns whether all numbers are finite.
    fn is_sound(&self) -> bool {
        self.normal.is_finite()
            && self.points.iter().all(|point| {
                let impulses = point.friction.iter().chain([&point.impulse, &point.total]);
                let mut numbers = impulses.chain([&point.separation]);
                point.position.is_finite() && numbers.all(|number| number.is_finite())
            })
    }
}
