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
//! it. Numerically both may, where links turn far in a substep. What is too much for a flight is taken from the change of shape alone, and
//! what is too much for contacts from what these have just done.

use super::super::kinematics::LinkFrame;
use super::super::spatial::{ZERO, add_scaled, carry_back, turn};
use super::{Motion, add_all};
use crate::dim::math::{ANG_ZERO, Real, SpatialVector, Vector, ang_dot, ang_length_squared};
use crate::dim::spatial::{angular, join, linear};

/// Contacts of links that turn far make energy if they leave so many times what there was.
const JUMP: Real = 1.1;
/// How far a link turns in a substep (rad) if contacts may be wrong.
const FAR_TURN: Real = 0.1;

impl LinkFrame {
    /// The momentum that it has at a velocity.
    pub(super) fn momentum(&self, velocity: &SpatialVector) -> SpatialVector {
        join(linear(velocity) * self.mass, turn(&self.inertia, angular(velocity)))
    }
}

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

    /// Notes the momenta of the links.
    pub(super) fn note_momenta(&mut self) {
        let Self { kinematics, velocities, momenta, .. } = self;
        kinematics.velocities(&self.rates, &self.root, velocities);
        momenta.clear();
        let links = kinematics.links.iter().zip(velocities);
        momenta.extend(links.map(|(link, velocity)| link.momentum(velocity)));
    }

    /// Changes the velocities to those at which, for each degree of freedom, the links have these momenta; `None`: the
    /// momentum that the link has.
    pub(super) fn take_momenta(&mut self, of: impl Fn(usize, &LinkFrame) -> Option<SpatialVector>) {
        self.kinematics.velocities(&self.rates, &self.root, &mut self.velocities);
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
        let is_told = self.drives.iter().zip(&self.rates);
        let is_told =
            is_told.fold(false, |told, (drive, rate)| told || (drive.is_told() && *rate != 0.0));
        if is_told || angular(&self.root) != ANG_ZERO {
            return None;
        }
        let frame = self.frame_velocity();
        Some(self.kinetic_energy_from(frame))
    }

    /// The velocity of the frame in which the multibody as a whole goes nowhere.
    fn frame_velocity(&mut self) -> Vector {
        if self.root_dofs() == 0 {
            return linear(&self.root);
        }
        let momentum = linear(&self.root_momentum());
        let mass: Real = self.kinematics.links.iter().map(|link| link.mass).sum();
        let axes = self.kinematics.axes[..self.root_dofs()].iter().map(linear);
        let moving = axes.map(|axis| axis * axis.dot(momentum)).sum::<Vector>();
        if mass > 0.0 { moving / mass } else { Vector::ZERO }
    }

    /// Does a link turn so far in a substep of `h` seconds that contacts are not what they were at its beginning?
    pub fn turns_far(&mut self, h: Real) -> bool {
        let turns_far =
            |v: &SpatialVector| ang_length_squared(angular(v)) * h * h > FAR_TURN * FAR_TURN;
        self.is_wild || self.link_velocities().iter().any(turns_far)
    }

    /// The energy that contacts with what is at rest may leave; no limit if the root moves as it is told.
    pub fn energy_before_contacts(&mut self) -> Real {
        if self.root == ZERO { self.kinetic_energy() } else { Real::MAX }
    }

    /// Notes the velocities before contacts act.
    pub fn note_before_contacts(&mut self) {
        self.uncontacted.clone_from(&self.rates);
        self.outside_before = self.outside;
    }

    /// Leaves only as much of what contacts changed since then as makes no more than this energy.
    pub fn keep_energy(&mut self, most: Real) {
        let now = self.kinetic_energy();
        if now <= JUMP * most {
            return;
        }
        self.is_wild = true;
        let before = core::mem::take(&mut self.uncontacted);
        let start = self.energy_at(&before);
        let halfway: Vec<Real> =
            before.iter().zip(&self.rates).map(|(old, new)| 0.5 * (old + new)).collect();
        // E(s) = E(0) + b s + c s²
        let curve = 2.0 * (now + start - 2.0 * self.energy_at(&halfway));
        let slope = now - start - curve;
        let room = (most - start).max(0.0);
        let root = (slope * slope + 4.0 * curve * room).max(0.0).sqrt();
        let share = if curve > 0.0 { (root - slope) / (2.0 * curve) } else { 0.0 };
        let share = share.clamp(0.0, 1.0);
        for (rate, old) in self.rates.iter_mut().zip(&before) {
            *rate = old + (*rate - old) * share;
        }
        let outside = self.outside_before;
        self.share_outside(&outside, share);
        self.uncontacted = before;
    }

    /// Slows the change of shape down if the links have more energy than this, seen from a frame with this velocity.
    fn limit_energy(&mut self, most: Real, frame: Vector) {
        let energy = self.kinetic_energy_from(frame);
        if energy <= most {
            return;
        }
        let momentum = self.root_momentum();
        let count = self.root_dofs();
        let whole = self.whole.rates_at(&momentum).to_vec();
        let own = core::mem::replace(&mut self.rates, whole);
        self.rates.resize(own.len(), 0.0);
        let of_whole = if count > 0 { self.kinetic_energy_from(frame) } else { 0.0 };
        let share =
            ((most - of_whole).max(0.0) / (energy - of_whole).max(Real::MIN_POSITIVE)).sqrt();
        for ((rate, own), drive) in self.rates.iter_mut().zip(&own).zip(&self.drives) {
            *rate = if drive.is_told() { *own } else { *rate + (*own - *rate) * share.min(1.0) };
        }
    }

    /// Lets the links have no more than this energy of their flight.
    pub(super) fn limit_flight(&mut self, most: Option<Real>) {
        if let Some(most) = most {
            let frame = self.frame_velocity();
            self.limit_energy(most, frame);
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
            for (rate, drive) in self.rates.iter_mut().zip(&self.drives) {
                *rate *= if drive.is_told() { 1.0 } else { speed_max / fastest };
            }
            self.follow_momentum();
        }
    }

    /// The kinetic energy of all links.
    pub fn kinetic_energy(&mut self) -> Real {
        self.kinetic_energy_from(Vector::ZERO)
    }

    /// The same at other rates of the degrees of freedom.
    pub fn energy_at(&mut self, rates: &[Real]) -> Real {
        let own = core::mem::replace(&mut self.rates, rates.to_vec());
        let energy = self.kinetic_energy();
        self.rates = own;
        energy
    }

    /// The kinetic energy of all links, seen from a frame with this velocity.
    fn kinetic_energy_from(&mut self, frame: Vector) -> Real {
        self.kinematics.velocities(&self.rates, &self.root, &mut self.velocities);
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
