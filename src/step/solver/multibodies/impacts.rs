//! Contacts of links in impacts.
//!
//! They take part in the rounds of `impacts/mod.rs`, beside the blocks of bodies' contacts and with the same
//! rules, processed point by point. These rules use a contact's velocity, its `1/K` and its effect on the
//! velocities of others. The inertia may be that of a body or, with `W = M⁻¹ Jᵀ` (`rows.rs`), of a whole
//! multibody. An impact thus travels through chains as through rows of bodies, and the energy sum of an
//! island includes both.
//!
//! An impact acts on a multibody as on a body. Its generalised velocities change by the fraction of its
//! island's round, and the impulse is no warm-start load. But its configuration changes. `J`, `W` and the
//! velocities in the middle of a substep differ from those at the time `τ` of the impact. With them an impact
//! would add energy. The multibody is therefore moved to that time, `q + τ q̇`, with the velocities of free
//! motion. The impact rows are made there, and after the round everything returns the same way with the new
//! velocities. Both halves of the free motion use the configuration at the impact, so that they cancel
//! exactly without one. There may be dozens of rounds, for example when a corner bounces while another one
//! rests, and their errors would add up. A multibody that is hit several times in a round goes to the mean of
//! these. It returns to a time before the substep only if all its links move as one. That distance exceeds
//! the range of the tangents of a chain. On the return, links that were not hit would end up in the ground.
//!
//! Impact velocities of multibodies exclude the impulses that the substep starts with: see *Supported loads*
//! in `impacts/mod.rs`.
//!
//! Limits, motors, gears and loops take no part: the following passes undo the effect of an impact on them.

use super::contacts::{LinkContact, LinkContacts, Point};
use super::rows::{ConstrainedStates, JacobianPool};
use super::{Moving, SolverMultibodies};
use crate::dim::math::{DIM, Real, SpatialVector};
use crate::dim::state::BodyState;
use crate::model::island::NONE;
use crate::model::params::ImpactPass;
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::context::SolverInput;
use crate::step::solver::impact_time::ImpactTime;
use crate::step::solver::restitution::{
    APPROACH_CHANGE_MIN, DEFERRED_SEPARATION, HitRow, POINT_ITERATIONS, supported,
};

/// A contact point in an impact. See `ImpactRow` in `impacts/rows.rs`.
#[derive(Copy, Clone, Debug, Default)]
pub struct LinkImpactRow {
    /// Its velocity when the last substep ended, and with the impulses of that in this one.
    last: Real,
    loaded: Real,
    /// Velocity change in this substep by forces and their supports.
    accelerated: Real,
    /// It hits where its velocity is below this.
    limit: Real,
    /// Its velocity in the substep's middle when the round began.
    middle: Real,
    /// Whether the point approaches fast and does not arrive in this substep.
    to_defer: bool,
    hit: HitRow<Real>,
    /// Impulses of this round, and of the whole impact: the committed fraction of each round.
    impulse: Real,
    given: Real,
}

/// A contact in an impact. See `impacts/rows.rs` and `impacts/active.rs`.
#[derive(Copy, Clone, Debug, Default)]
pub struct LinkImpact {
    /// The island of its links.
    pub island: u32,
    /// Whether any point hits in this round.
    pub active: bool,
    /// Whether any point hit in this substep.
    pub was_active: bool,
    /// Whether the last iteration changed anything.
    pub moving: bool,
    /// The sum of impulse times approach in this round, and the excess of energy.
    pub dissipated: Real,
    pub energy_gain: Real,
}

/// State of a multibody at the start of a round.
#[derive(Debug, Default)]
pub struct BeforeImpact {
    rates: Vec<Real>,
    external_impulse: SpatialVector,
    /// The time of its impacts in this round.
    time: ImpactTime,
    /// Time (s) by which it was moved to the pose of its hit, if it has one.
    ahead: Option<Real>,
    /// Whether it may gain energy: other bodies hit it, or its restitution exceeds 1.
    may_gain: bool,
}

impl BeforeImpact {
    /// Notes the time of an impact, and whether it may add energy.
    pub fn note(&mut self, time: Real, may_gain: bool) {
        self.may_gain |= may_gain;
        self.time += ImpactTime::new(1.0, time);
    }
}

impl SolverMultibodies {
    /// Returns whether any contact has restitution.
    pub fn has_restitution(&self) -> bool {
        self.contacts.contacts.iter().any(LinkContact::bounces)
    }

    /// Exclusive upper bound of the numbers of islands with a contact that bounces.
    pub fn island_bound(&self) -> usize {
        let islands = self.contacts.contacts.iter().filter(|contact| contact.bounces());
        islands.map(|contact| contact.impact.island as usize + 1).max().unwrap_or(0)
    }

    /// The contacts that hit in this round.
    pub fn active(&mut self) -> impl Iterator<Item = &mut LinkContact> {
        self.contacts.contacts.iter_mut().filter(|contact| contact.impact.active)
    }

    /// The island and the restitution of each contact that bounces.
    pub fn restitutions(&self) -> impl Iterator<Item = (u32, Real)> {
        let bouncing = self.contacts.contacts.iter().filter(|contact| contact.bounces());
        bouncing.map(|contact| (contact.impact.island, contact.restitution))
    }

    /// Notes how the contacts move at the end of a substep, before forces act in the next.
    pub fn note_velocities(&mut self, velocities: &mut [BodyState]) {
        let (jacobians, contacts, states) = self.bouncing(velocities);
        for contact in contacts.bouncing() {
            for point in &mut contact.points {
                point.impact.last = jacobians.velocity(&point.normal, &states);
            }
        }
    }

    /// Begins a substep: notes the contact velocities, with the effect of forces and their supports, and
    /// removes the warm-start impulses from multibodies. Bodies have the velocities without them in
    /// [`SolverBodies::before`].
    pub fn begin_impact(&mut self, bodies: &mut SolverBodies, pass: &ImpactPass) {
        self.note_loaded(&mut bodies.states);
        self.moving.iter_mut().for_each(|moving| moving.add_pushed(-1.0));
        let (jacobians, contacts, states) = self.bouncing(&mut bodies.before);
        for contact in contacts.bouncing() {
            contact.impact.was_active = false;
            for Point { normal, impact, .. } in &mut contact.points {
                impact.begin(jacobians.velocity(normal, &states), pass);
            }
        }
    }

    /// Ends it: gives the impulses of the last substep back to multibodies.
    pub fn end_impact(&mut self) {
        self.moving.iter_mut().for_each(|moving| moving.add_pushed(1.0));
    }

    /// Notes how contacts move with the impulses of the last substep.
    fn note_loaded(&mut self, loaded: &mut [BodyState]) {
        let (jacobians, contacts, states) = self.bouncing(loaded);
        for Point { normal, impact, .. } in
            contacts.bouncing().flat_map(|contact| &mut contact.points)
        {
            impact.loaded = jacobians.velocity(normal, &states);
        }
        // Inertial terms are evaluated at the configuration of the impact.
        let before_free_motion = |moving: &mut Moving| {
            let mut before = moving.motion.rates_before_free_motion();
            moving.motion.rates.swap_with_slice(&mut before);
            before
        };
        let rates_before: Vec<_> = states.multibodies.iter_mut().map(before_free_motion).collect();
        for point in contacts.bouncing().flat_map(|contact| &mut contact.points) {
            point.impact.accelerated =
                jacobians.velocity(&point.normal, &states) - point.impact.last;
        }
        for (moving, rates) in states.multibodies.iter_mut().zip(rates_before) {
            moving.motion.rates.copy_from_slice(&rates);
            moving.motion.return_buffer(rates);
        }
    }

    /// Begins a round: finds the points that hit before the substep ends, and how they separate. Islands
    /// whose impact has ended stay as they are: to move there and back leaves rounding errors, as often as
    /// other islands need another round.
    pub fn mark_active(
        &mut self,
        input: SolverInput<'_>,
        bodies: &mut SolverBodies,
        takes_part: impl Fn(u32) -> bool,
        pass: &ImpactPass,
    ) {
        let (jacobians, contacts, mut states) = self.bouncing(&mut bodies.before);
        for contact in contacts.bouncing() {
            contact.impact.active = false;
            let takes_part = takes_part(contact.impact.island);
            for Point { normal, impact, separation, .. } in &mut contact.points {
                let velocity = jacobians.velocity(normal, &states) + impact.hit.support_velocity;
                let separation = *separation + jacobians.displacement(normal, &states);
                impact.impulse = 0.0;
                impact.hit.mass = 0.0;
                let earliest = if jacobians.goes_back(normal, &states) { -pass.step } else { 0.0 };
                if impact.find_time(velocity, separation, earliest, pass.substep) && takes_part {
                    impact.hit.mass = normal.mass;
                    contact.impact.active |= impact.hit.mass > 0.0;
                    let gains = contact.restitution > 1.0;
                    jacobians.note_time(normal, impact.hit.time, gains, &mut states);
                }
            }
            contact.impact.was_active |= contact.impact.active;
        }
        self.move_to_impact(input, bodies, pass.substep);
        let (jacobians, contacts, states) = self.bouncing(&mut bodies.before);
        for contact in contacts.bouncing().filter(|contact| contact.impact.active) {
            for Point { normal, impact, .. } in &mut contact.points {
                if impact.hit.mass > 0.0 {
                    impact.hit.mass = normal.mass;
                    let velocity =
                        jacobians.velocity(normal, &states) + impact.hit.support_velocity;
                    impact.aim(velocity, contact.restitution, pass);
                }
            }
        }
    }

    /// Moves the hit multibodies to the time of their impact, and makes the impact rows there.
    fn move_to_impact(&mut self, input: SolverInput<'_>, bodies: &mut SolverBodies, h: Real) {
        for moving in &mut self.moving {
            if let Some(time) = core::mem::take(&mut moving.before_impact.time).mean() {
                moving.move_on(time, h);
            }
        }
        for position in 0..self.contacts.contacts.len() {
            if self.contacts.contacts[position].impact.active {
                self.follow_contact(position, input, bodies);
            }
        }
    }

    /// Iterates over the points that hit, and applies impulses until they separate at their target
    /// velocities.
    pub fn iterate_active(&mut self, states: &mut [BodyState]) {
        let (jacobians, contacts, mut states) = self.bouncing(states);
        for contact in contacts.bouncing().filter(|contact| contact.impact.active) {
            contact.impact.moving = false;
            for iteration in 0..POINT_ITERATIONS {
                for Point { normal, impact, .. } in &mut contact.points {
                    let velocity = jacobians.velocity(normal, &states);
                    let new = impact.hit.impulse(velocity, impact.impulse);
                    let change = new - impact.impulse;
                    impact.impulse = new;
                    jacobians.apply_impact(normal, change, &mut states);
                    contact.impact.moving |=
                        iteration == 0 && change.abs() > impact.hit.tolerance();
                }
            }
        }
    }

    /// Ends a round: sums up its energy, and records the impact times of bodies.
    pub fn end_round(&mut self, states: &mut [BodyState], times: &mut [ImpactTime]) {
        let (jacobians, contacts, states) = self.bouncing(states);
        for contact in contacts.bouncing().filter(|contact| contact.impact.active) {
            (contact.impact.dissipated, contact.impact.energy_gain) = (0.0, 0.0);
            for Point { normal, impact, .. } in &mut contact.points {
                let velocity = jacobians.velocity(normal, &states);
                let [of_approach, gain] =
                    impact.hit.energies(velocity, impact.impulse, contact.restitution);
                contact.impact.dissipated += of_approach;
                contact.impact.energy_gain += gain;
                let time = ImpactTime::new(impact.impulse, impact.hit.time);
                jacobians.note_body_time(normal, time, times);
            }
        }
    }

    /// Commits the impulses of a round, scaled by the fraction of each island.
    pub fn commit_round(&mut self, fraction: impl Fn(u32) -> Real) {
        for contact in self.active() {
            let fraction = fraction(contact.impact.island);
            contact
                .points
                .iter_mut()
                .for_each(|point| point.impact.given += fraction * point.impact.impulse);
        }
    }

    /// Defers the points that approach fast and do not arrive in this substep.
    pub fn defer(&mut self) {
        for contact in self.contacts.bouncing() {
            contact.points.iter_mut().for_each(|point| point.is_deferred = point.impact.to_defer);
        }
    }

    /// Ends the impact: friction acts under its normal impulses, which count into those of the step.
    pub fn solve_active_friction(&mut self, states: &mut [BodyState]) {
        let (jacobians, contacts, mut states) = self.bouncing(states);
        for contact in contacts.bouncing().filter(|contact| contact.impact.was_active) {
            for point in contact.points.iter_mut().filter(|point| point.impact.given > 0.0) {
                point.total += point.impact.given;
                let limit = contact.friction * point.impact.given;
                let none = [0.0; DIM - 1];
                let friction_impulses = point.friction_within(limit, none, jacobians, &states);
                for (row, impulse) in point.tangents.iter().zip(friction_impulses) {
                    jacobians.apply_impact(row, impulse, &mut states);
                }
            }
        }
    }

    /// Stores the velocities of the multibodies when a round begins.
    pub fn begin_round(&mut self) {
        for moving in &mut self.moving {
            let BeforeImpact { rates, external_impulse, .. } = &mut moving.before_impact;
            rates.clear();
            rates.extend_from_slice(&moving.motion.rates);
            *external_impulse = moving.motion.external_impulse();
        }
    }

    /// Commits the velocity changes since the round began, scaled by the `fraction` of each island: see
    /// [`SolverBodies::accept_impact`].
    pub fn accept_impact(&mut self, h: Real, fraction: impl Fn(u32) -> Real) {
        for moving in &mut self.moving {
            moving.accept_impact(h, fraction(moving.island));
        }
    }

    fn bouncing<'a>(
        &'a mut self,
        states: &'a mut [BodyState],
    ) -> (&'a JacobianPool, &'a mut LinkContacts, ConstrainedStates<'a>) {
        let Self { jacobians, contacts, moving, .. } = self;
        (jacobians, contacts, ConstrainedStates { multibodies: moving, states })
    }
}

impl LinkContacts {
    /// The contacts with restitution.
    fn bouncing(&mut self) -> impl Iterator<Item = &mut LinkContact> {
        self.contacts.iter_mut().filter(|contact| contact.bounces())
    }
}

impl LinkImpact {
    /// For a contact of this island.
    pub fn of(island: u32) -> Self {
        Self { island, ..Self::default() }
    }
}

impl LinkContact {
    /// Returns whether the contact has restitution in an island.
    fn bounces(&self) -> bool {
        self.restitution != 0.0 && self.impact.island != NONE
    }

    /// Leaves it as it is for the rest of the round.
    pub fn deactivate(&mut self) {
        self.points.iter_mut().for_each(|point| point.impact.hit.mass = 0.0);
    }
}

impl Point {
    /// Its separation for all passes except impacts.
    pub fn shown_separation(&self) -> Real {
        if self.is_deferred { DEFERRED_SEPARATION } else { self.separation }
    }
}

impl LinkImpactRow {
    /// Begins a substep in which the point moves like this without the impulses of the last one.
    fn begin(&mut self, free: Real, pass: &ImpactPass) {
        (self.hit.support_velocity, self.limit) = supported(free, self.last, self.loaded, pass);
        self.accelerated = self.accelerated.clamp(-pass.fall, pass.fall);
        self.given = 0.0;
    }

    /// Returns whether the point hits in this substep, and computes the time of the hit.
    fn find_time(&mut self, velocity: Real, separation: Real, earliest: Real, h: Real) -> bool {
        let comes = velocity < self.limit;
        let arrives = separation + velocity * h < 0.0;
        self.to_defer = comes && !arrives;
        self.middle = velocity;
        if comes {
            self.hit.time = (separation / -velocity).max(earliest).min(h);
        }
        comes && arrives
    }

    /// Finds how it is to part, at the velocity that it has when it hits.
    fn aim(&mut self, velocity: Real, restitution: Real, pass: &ImpactPass) {
        if velocity >= self.limit {
            // It has separated by then, and only returns to the middle of the substep, as it would in each
            // further round.
            self.hit.mass = 0.0;
            self.limit = self.middle - pass.threshold * APPROACH_CHANGE_MIN;
        }
        self.hit.aim((-velocity).max(0.0), self.accelerated, restitution, pass);
    }
}

impl Moving {
    /// Returns whether the multibody has no more degrees of freedom than its root, or a single one.
    pub(super) fn has_rigid_motion(&self) -> bool {
        self.motion.rates.len() <= self.motion.root_dofs().max(1)
    }

    /// Goes to where the links are after `time` seconds of a substep of `h` seconds.
    fn move_on(&mut self, time: Real, h: Real) {
        let rates = self.motion.rates.to_vec();
        self.displace(&rates, time);
        self.motion.resist(h);
        self.motion.undo_inertial_kick(self.motion.middle(h) - time);
        self.before_impact.ahead = Some(time);
    }

    /// Ends a round of a substep of `h` seconds.
    fn accept_impact(&mut self, h: Real, fraction: Real) {
        let ahead = self.before_impact.ahead.take();
        let BeforeImpact { rates: before, external_impulse, may_gain, .. } = &self.before_impact;
        if **before != *self.motion.rates {
            // Fixed bodies add no energy.
            let energy = may_gain.then(|| self.motion.energy_at(before));
            for (rate, old) in self.motion.rates.iter_mut().zip(before) {
                *rate = *old + (*rate - *old) * fraction;
            }
            self.motion.scale_external_impulse(external_impulse, fraction);
            if let Some(energy) = energy {
                self.work += (self.motion.kinetic_energy() - energy).max(0.0);
            }
            self.before_impact.may_gain = false;
        }
        if let Some(time) = ahead {
            self.motion.implicit_inertial_kick(self.motion.middle(h) - time);
            let rates = self.motion.rates.to_vec();
            self.displace(&rates, -time);
        }
    }

    /// Moves the links for `time` seconds, which may be negative, at these rates.
    fn displace(&mut self, rates: &[Real], time: Real) {
        for (shift, rate) in self.shift.iter_mut().zip(rates) {
            *shift += rate * time;
        }
        self.motion.displace(&mut self.multibody, rates, time);
        self.note_travel_at(rates, time.abs());
    }
}
