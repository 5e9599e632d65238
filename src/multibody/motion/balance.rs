//! What a multibody keeps: momentum and energy.
//!
//! # Momentum
//! Nothing inside a multibody changes its linear and angular momentum. The error of the flight does, in third order, and so do
//! pushes from outside, whose responses are frozen during a step. So the momentum is followed beside the velocities: it changes by
//! gravity, forces and pushes alone, and what the velocities miss of it the [`Whole`](super::super::whole::Whole) makes up for.
//! Chains that tumble freely do not stray, and what a contact gives to one side it takes from the other.
//!
//! The momentum is that about the root's centre of mass, wherever that moves. A push is one at a lever that moves along: the
//! contact of a ball is below the ball also when this has rolled on. (Held where it was when the step began, the ball would be turned
//! by its weight times its way.)
//!
//! # Energy
//! In a flight the multibody keeps its energy, seen from whatever moves evenly. Contacts with what is at rest do not add to
//! it. Numerically both may, where links turn far: contacts if they do in a step, flights if they do in a substep. What is too much for a flight is taken from the change of shape first, so
//! that momentum stays; what contacts make is taken from all velocities, which then still lead out of the contacts.

use super::super::kinematics::LinkFrame;
use super::super::spatial::{ZERO, add_scaled, carry_back, turn};
use super::{Drive, Motion, add_all};
use crate::dim::math::{ANG_ZERO, Real, SpatialVector, Vector, ang_dot, ang_length_squared};
use crate::dim::spatial::{angular, linear};

/// Flights, and contacts of links that turn far, make energy if they leave so many times what there was.
pub(super) const JUMP: Real = 1.1;
/// How far a link turns in a step (rad) if contacts may be wrong: their rows are made when it begins. (Of four hundred rods on long arms that were
/// thrown on the ground eighteen gained energy when this was asked of each substep, up to more than they had, and none when of the step.)
const FAR_TURN: Real = 0.1;
/// The farthest that joints turn in a substep (rad) when a flight is wild. Beyond that links would come to be anywhere.
const WHIP: Real = 0.5;
/// What turns farther than this in a substep (rad) is no whip: somebody pushed harder than anybody can calculate with, and is to be
/// told so ([`QuarantineEvent`](crate::model::event::QuarantineEvent)).
const SENSELESS: Real = 1.0e6;

// ---- Momentum ----

impl Motion {
    /// Notes an impulse from outside that the rates have felt already, as the impulses on the root's degrees of freedom.
    pub fn note_outside(&mut self, impulses: &[Real], factor: Real) {
        for (axis, impulse) in self.kinematics.axes.iter().zip(impulses) {
            add_scaled(&mut self.outside, axis, impulse * factor);
        }
    }

    /// The impulses from outside that have been noted and not yet been taken in.
    pub fn outside(&self) -> SpatialVector {
        self.outside
    }

    /// Keeps only a share of the impulses from outside since they were these.
    pub fn share_outside(&mut self, since: &SpatialVector, share: Real) {
        for (now, since) in self.outside.iter_mut().zip(since) {
            *now = since + (*now - since) * share;
        }
    }

    /// Begins to follow the momentum.
    pub(super) fn follow_momentum(&mut self) {
        (self.momentum, self.outside) = (self.root_momentum(), ZERO);
    }

    /// Lets the whole move so that nothing is missing of the momentum. That was about `before`, and is about the root's
    /// centre of mass from now on.
    pub(super) fn keep_momentum(&mut self, before: Vector) {
        if self.root_dofs() == 0 {
            return;
        }
        self.carry_momentum(before);
        let mut missing = self.momentum;
        add_scaled(&mut missing, &self.root_momentum(), -1.0);
        add_all(&mut self.rates, self.whole.correction(&missing), 1.0);
    }

    /// Lets the momentum that was about `before`, and the impulses from outside that came there, be about the root's centre
    /// of mass.
    pub(super) fn carry_momentum(&mut self, before: Vector) {
        add_scaled(&mut self.momentum, &self.outside, 1.0);
        self.momentum = carry_back(&self.momentum, before - self.kinematics.links[0].center);
        self.outside = ZERO;
    }

    /// The momentum of all links together, about the root's centre of mass.
    pub(super) fn root_momentum(&mut self) -> SpatialVector {
        self.note_momenta();
        let Self { kinematics, momenta, .. } = self;
        for (id, link) in kinematics.links.iter().enumerate().rev() {
            let Some(parent) = link.parent else { continue };
            let felt = carry_back(&momenta[id], link.lever);
            add_scaled(&mut momenta[parent], &felt, 1.0);
        }
        momenta[0]
    }

    /// The momenta of the links.
    pub fn link_momenta(&mut self) -> Vec<SpatialVector> {
        self.note_momenta();
        self.momenta.clone()
    }

    /// Notes the momenta of the links.
    pub(super) fn note_momenta(&mut self) {
        self.update_velocities();
        let Self { kinematics, velocities, momenta, .. } = self;
        momenta.clear();
        let links = kinematics.links.iter().zip(velocities);
        momenta.extend(links.map(|(link, velocity)| link.momentum(velocity)));
    }

    /// Changes the velocities to those at which, for each degree of freedom, the links have these momenta; `None`: the
    /// momentum that the link has.
    pub fn take_momenta(&mut self, of: impl Fn(usize, &LinkFrame) -> Option<SpatialVector>) {
        self.update_velocities();
        self.wrenches.clear();
        for (id, link) in self.kinematics.links.iter().enumerate() {
            let missing = of(id, link).map_or(ZERO, |mut missing| {
                add_scaled(&mut missing, &link.momentum(&self.velocities[id]), -1.0);
                missing
            });
            self.wrenches.push(missing);
        }
        let mut change = core::mem::take(&mut self.change);
        change.clear();
        change.resize(self.rates.len(), 0.0);
        self.factor.solve(&self.kinematics, &self.wrenches, &mut change);
        add_all(&mut self.rates, &change, 1.0);
        self.change = change;
    }
}

// ---- Energy ----

impl Motion {
    /// The energy that a flight keeps; `None` if something drives the links: a root that turns, or a joint that moves as it
    /// is told.
    pub(super) fn flight_energy(&mut self) -> Option<Real> {
        let is_told = |(drive, rate): (&Drive, &Real)| drive.is_told() && *rate != 0.0;
        if angular(&self.root) != ANG_ZERO || self.drives.iter().zip(&self.rates).any(is_told) {
            return None;
        }
        self.update_velocities();
        Some(self.energy_seen_from(self.frame_velocity()))
    }

    /// The velocity of the frame in which the multibody as a whole goes nowhere, at the velocities that the links had last.
    fn frame_velocity(&self) -> Vector {
        if self.root_dofs() == 0 {
            return linear(&self.root);
        }
        let links = self.kinematics.links.iter().zip(&self.velocities);
        let add = |(mass, momentum): (Real, Vector), (link, velocity): (&LinkFrame, _)| {
            (mass + link.mass, momentum + linear(velocity) * link.mass)
        };
        let (mass, momentum) = links.fold((0.0, Vector::ZERO), add);
        let axes = self.kinematics.axes[..self.root_dofs()].iter().map(linear);
        let moving = axes.map(|axis| axis * axis.dot(momentum)).sum::<Vector>();
        if mass > 0.0 { moving / mass } else { Vector::ZERO }
    }

    /// Does a link turn so far in `dt` seconds that contacts are not what they were at their beginning?
    pub fn turns_far(&mut self, dt: Real) -> bool {
        let turns_far =
            |v: &SpatialVector| ang_length_squared(angular(v)) * dt * dt > FAR_TURN * FAR_TURN;
        self.is_wild || self.link_velocities().iter().any(turns_far)
    }

    /// The energy that contacts with what is at rest may leave; no limit if the root moves as it is told.
    pub fn energy_before_contacts(&mut self) -> Real {
        if self.root == ZERO { self.kinetic_energy() } else { Real::MAX }
    }

    /// Slows all links down if contacts left more than this energy: scaled, velocities that lead out of a contact still do.
    pub fn keep_energy(&mut self, most: Real) {
        let energy = self.kinetic_energy();
        self.is_wild |= energy > JUMP * most;
        if self.is_wild && energy > most {
            self.slow_down((most / energy).sqrt());
        }
    }

    /// Leaves this share of all velocities but of those of degrees of freedom that move as they are told.
    fn slow_down(&mut self, share: Real) {
        for (rate, drive) in self.rates.iter_mut().zip(&self.drives) {
            *rate *= if drive.is_told() { 1.0 } else { share };
        }
        self.follow_momentum();
    }

    /// Lets the links have no more than this energy of their flight: slows the change of shape down and, if that is not enough,
    /// the turn of the whole. Where links are moved far at once they may come to lie closer together than their angular momentum
    /// and their energy allow.
    pub(super) fn limit_flight(&mut self, most: Option<Real>) {
        let Some(most) = most else { return };
        self.update_velocities();
        let frame = self.frame_velocity();
        let energy = self.energy_seen_from(frame);
        if energy <= most {
            return;
        }
        let own = self.rates.clone();
        self.slow_to_whole();
        self.update_velocities();
        let of_whole = self.energy_seen_from(frame);
        if of_whole < most {
            self.blend(&own, ((most - of_whole) / (energy - of_whole)).sqrt());
        } else {
            let whole = self.rates.clone();
            self.slow_to(frame);
            self.blend(&whole, (most / of_whole).sqrt());
        }
        self.obey(&own);
        self.follow_momentum();
    }

    /// Lets no joint turn by more than [`WHIP`] in `h` seconds: slows the change of shape down.
    pub(super) fn limit_whip(&mut self, h: Real) {
        let axes = self.kinematics.axes.iter().zip(&self.rates).skip(self.root_dofs());
        let turns = axes.filter(|(axis, _)| angular(axis) != ANG_ZERO);
        let fastest = turns.map(|(_, rate)| (rate * h).abs()).fold(0.0, Real::max);
        if fastest > WHIP && fastest < SENSELESS {
            let own = self.rates.clone();
            self.slow_to_whole();
            self.blend(&own, WHIP / fastest);
            self.obey(&own);
        }
    }

    /// Adds a share of what is missing to these velocities.
    fn blend(&mut self, to: &[Real], share: Real) {
        let share = share.clamp(0.0, 1.0);
        for (rate, to) in self.rates.iter_mut().zip(to) {
            *rate += (to - *rate) * share;
        }
    }

    /// Degrees of freedom that move as they are told take these velocities.
    fn obey(&mut self, told: &[Real]) {
        for ((rate, drive), told) in self.rates.iter_mut().zip(&self.drives).zip(told) {
            *rate = if drive.is_told() { *told } else { *rate };
        }
    }

    /// Leaves the motion of the whole alone.
    fn slow_to_whole(&mut self) {
        let momentum = self.root_momentum();
        self.rates.fill(0.0);
        add_all(&mut self.rates, self.whole.rates_at(&momentum), 1.0);
    }

    /// Leaves the whole going evenly.
    fn slow_to(&mut self, velocity: Vector) {
        self.rates.fill(0.0);
        let count = self.root_dofs();
        for (rate, axis) in self.rates[..count].iter_mut().zip(&self.kinematics.axes) {
            *rate = linear(axis).dot(velocity);
        }
    }

    /// Slows all degrees of freedom down alike if they move a link faster than this.
    pub(super) fn limit_speed(&mut self, speed_max: Real) {
        if speed_max >= Real::MAX {
            return;
        }
        self.kinematics.velocities(&self.rates, &ZERO, &mut self.velocities);
        let fastest = self.velocities.iter().map(|v| speed(linear(v))).fold(0.0, Real::max);
        if fastest > speed_max {
            self.is_limited = true;
            self.slow_down(speed_max / fastest);
        }
    }

    /// The kinetic energy of all links.
    pub fn kinetic_energy(&mut self) -> Real {
        self.update_velocities();
        self.energy_seen_from(Vector::ZERO)
    }

    /// The same at other rates of the degrees of freedom.
    pub fn energy_at(&mut self, rates: &[Real]) -> Real {
        let own = core::mem::replace(&mut self.rates, rates.to_vec());
        let energy = self.kinetic_energy();
        self.rates = own;
        energy
    }

    /// The kinetic energy of all links at the velocities that they had last, seen from a frame with this velocity.
    fn energy_seen_from(&self, frame: Vector) -> Real {
        let of = |(link, velocity): (&LinkFrame, &SpatialVector)| {
            let (v, w) = (linear(velocity) - frame, angular(velocity));
            0.5 * (link.mass * v.length_squared() + ang_dot(w, turn(&link.inertia, w)))
        };
        self.kinematics.links.iter().zip(&self.velocities).map(of).sum()
    }
}

/// The length of a velocity, whose square may be beyond all numbers.
fn speed(velocity: Vector) -> Real {
    let size = velocity.abs().max_element();
    if size > 0.0 { (velocity / size).length() * size } else { 0.0 }
}
