//! One multibody on its way through a step: a substep without contacts, and its response to impulses.
//!
//! # A substep
//! Forces kick, then the links fly on by themselves, then forces kick again: for the flight the velocity of the middle of the
//! substep is what counts. With the inertial forces `-C q̇` and the step `h`
//!
//! ```text
//! q̇  ← q̇ + h M̃⁻¹ (gravity, forces of the user, springs, dampers, motors)      at q
//! q̇½ = q̇ - ½ h M̃⁻¹ C(q, q̇½) q̇½                                               implicit: by iteration
//!      contacts and limits act on q̇½
//! q  ← q + h q̇½
//! q̇  ← q̇½ - ½ h M̃⁻¹ C(q, q̇½) q̇½                                               explicit, at the new q
//! ```
//!
//! The two halves of the flight are each other's mirror image, so that the whole is reversible and of second order, and its
//! energy does not drift: the generalised leapfrog (Hairer, Lubich, Wanner, "Geometric Numerical Integration", 2006, chapter
//! VI) in velocities. An explicit step `q̇ - h M⁻¹ C q̇` instead, which is what one visit of forward dynamics gives, makes a tumbling chain gain
//! energy until it explodes. A body of its own is moved the same way (`dim3/gyro.rs`), so chains and bodies fall alike.
//!
//! `M̃ = M + h D + h² K`: springs of stiffness `K` and dampers `D` are taken at the end of the substep.
//!
//! # Wild flights
//! The iteration of the implicit half contracts by the angle of half a substep times how much more easily a link turns about
//! one axis than it carries what hangs on it about another: forty times for a chain of thin limbs, so that 25 rad/s at
//! 240 substeps a second are too many for it, and the explicit half makes more energy of what is wrong. Where the visits do not
//! come together, or the second half makes energy, inertia turns no velocity in that substep, and the links take no more
//! energy along than contacts have left them, nor get any from contacts, whose rows have turned away; what motors and
//! other joints do is theirs. Whips are dull for a moment and never explode. (Shorter flights would keep them sharp, at
//! the cost of several factorisations in each substep.)
//!
//! # Momentum
//! Nothing inside a multibody changes its linear and angular momentum. The error of the flight does, in third order, and so do
//! pushes from outside, whose responses are frozen during a step. So the momentum is followed beside the velocities: it changes by
//! gravity, forces and pushes alone, and what the velocities miss of it is given to the root as one impulse. Chains that
//! tumble freely do not stray, and what a contact gives to one side it takes from the other.

use super::factor::{Factor, Resistance};
use super::kinematics::{Kinematics, LinkFrame};
use super::spatial::{ZERO, add_scaled, carry_back, turn};
use crate::dim::math::{Real, SpatialVector, Vector, ang_dot, ang_length_squared};
use crate::dim::spatial::{angular, join, linear};
use crate::model::body::{RigidBodySet, RigidBodyVelocity};
use crate::model::multibody::{Multibody, MultibodyLink};

/// Visits of the implicit half.
const VISITS: usize = 3;
/// A flight is wild if a visit changes more than this share of what the visit before changed. What is left of an error after
/// [`VISITS`] is its third power.
const WILD: Real = 0.3;
/// It is wild, too, if its second half, or contacts of links that turn far, make the energy so many times what it was.
const JUMP: Real = 1.1;
/// How far a link turns in a substep (rad) if contacts may be wrong.
const FAR_TURN: Real = 0.1;

/// What acts on a link all through a step.
#[derive(Copy, Clone, Debug)]
pub struct LinkForce {
    /// Gravity and the user's forces.
    pub wrench: SpatialVector,
    /// Damping of the body, linear and angular (1/s).
    pub damping: [Real; 2],
}

/// What acts on a degree of freedom all through a step: `pull - stiffness q - damping q̇`.
#[derive(Copy, Clone, Debug, Default)]
pub struct Drive {
    /// Inertia beyond that of the links; infinite for a degree of freedom that moves as it is told.
    pub armature: Real,
    /// Force per coordinate.
    pub stiffness: Real,
    /// Force per velocity.
    pub damping: Real,
    /// Force at the coordinate 0 and the velocity 0.
    pub pull: Real,
}

/// See the [module](self). Fields that are lists have a number per degree of freedom.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    pub kinematics: Kinematics,
    factor: Factor,
    /// The velocities.
    pub rates: Vec<Real>,
    pub forces: Vec<LinkForce>,
    pub drives: Vec<Drive>,
    /// The velocity of a root without degrees of freedom.
    root: SpatialVector,
    armature: Vec<Real>,
    drag: Vec<[Real; 2]>,
    /// The momentum of all links about the root's centre of mass, but for [`Self::outside`].
    momentum: SpatialVector,
    /// The impulses from outside since then, about [`Self::origin`].
    outside: SpatialVector,
    /// Where the root's centre of mass was when the step began.
    origin: Vector,
    velocities: Vec<SpatialVector>,
    accelerations: Vec<SpatialVector>,
    wrenches: Vec<SpatialVector>,
    change: Vec<Real>,
    /// Was a link faster than the user allows since the step began?
    pub is_limited: bool,
    /// What the first half of the flight changed about the velocities.
    flown: Vec<Real>,
    /// Is the flight of this substep too fast to be followed?
    is_wild: bool,
}

impl Motion {
    /// Begins a step: links where the coordinates say, velocities as they were. `drives` are to be set before.
    ///
    /// Velocities and impulses that the user gave to bodies since the last step count as momentum: the multibody gets the
    /// velocities that have, at each degree of freedom, the momentum of the bodies.
    pub fn begin(&mut self, multibody: &Multibody, bodies: &RigidBodySet) {
        self.is_limited = false;
        self.kinematics.update(multibody);
        self.rates.clear();
        let rates = multibody.generalized_velocity().iter();
        self.rates.extend(rates.map(|rate| if rate.is_finite() { *rate } else { 0.0 }));
        self.armature.clear();
        self.armature.extend(self.drives.iter().map(|drive| drive.armature));
        self.factor.update(&self.kinematics, Resistance { armature: &self.armature, drag: &[] });
        let body = |link: &MultibodyLink| bodies.get(link.body);
        self.root = ZERO;
        if let Some(root) = body(&multibody.links[0]).filter(|root| !root.is_dynamic()) {
            self.root = join(root.linvel, root.angvel);
        }
        let velocity = |link: &MultibodyLink| Some(body(link)?.vels());
        if multibody.links.iter().any(|link| velocity(link) != link.seen_velocity) {
            self.take_momentum(|id| {
                let link = &multibody.links[id];
                // A body that was at rest when it became a link says nothing: the user may have set the joint's velocity.
                let velocity =
                    velocity(link).filter(|v| link.seen_velocity.is_some() || !v.is_zero());
                velocity.filter(|_| body(link).is_some_and(|body| body.is_dynamic()))
            });
        }
        self.follow_momentum();
    }

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

    /// Number of degrees of freedom of the root.
    pub fn root_dofs(&self) -> usize {
        self.kinematics.links[0].dofs.len()
    }

    /// Gives the links the momentum that bodies with these velocities have.
    fn take_momentum(&mut self, body: impl Fn(usize) -> Option<RigidBodyVelocity>) {
        self.kinematics.velocities(&self.rates, &self.root, &mut self.velocities);
        self.wrenches.clear();
        for (id, link) in self.kinematics.links.iter().enumerate() {
            let own = &self.velocities[id];
            let missing = body(id).map_or(ZERO, |velocity| {
                let angvel = velocity.angvel - angular(own);
                join((velocity.linvel - linear(own)) * link.mass, turn(&link.inertia, angvel))
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

    /// Begins to follow the momentum.
    fn follow_momentum(&mut self) {
        self.momentum = self.root_momentum();
        self.outside = ZERO;
        self.origin = self.kinematics.links[0].center;
    }

    /// Adds up the articulated inertias for substeps of `h` seconds, with springs and dampers.
    pub fn resist(&mut self, h: Real) {
        self.armature.clear();
        let resisting = |drive: &Drive| drive.armature + h * (drive.damping + h * drive.stiffness);
        self.armature.extend(self.drives.iter().map(resisting));
        self.drag.clear();
        self.drag.extend(self.forces.iter().map(|force| force.damping.map(|c| 1.0 + h * c)));
        let resistance = Resistance { armature: &self.armature, drag: &self.drag };
        self.factor.update(&self.kinematics, resistance);
    }

    /// Turns impulses on the degrees of freedom into velocities.
    pub fn respond(&mut self, impulses: &mut [Real]) {
        self.factor.solve(&self.kinematics, &[], impulses);
    }

    /// Lets the forces act for `h` seconds and turns the velocities to those of the substep's middle. No link gets faster than
    /// `speed_max`.
    pub fn accelerate(&mut self, multibody: &mut Multibody, h: Real, speed_max: Real) {
        self.keep_momentum(self.kinematics.links[0].center);
        let mut change = core::mem::take(&mut self.change);
        self.kick(multibody, h, &mut change);
        add_all(&mut self.rates, &change, 1.0);
        multibody.lists.accelerations.clone_from(&change);
        self.limit_speed(speed_max);
        self.momentum = self.root_momentum();
        let before = self.rates.clone();
        self.is_wild = !self.fly_half(&before, 0.5 * h, &mut change);
        if self.is_wild {
            self.rates.copy_from_slice(&before);
            change.fill(0.0);
        }
        self.flown.clone_from(&change);
        let total = multibody.lists.accelerations.iter_mut().zip(&change);
        total.for_each(|(kick, half)| *kick = if h > 0.0 { (*kick + 2.0 * half) / h } else { 0.0 });
        self.change = change;
    }

    /// Slows all degrees of freedom down alike if they move a link faster than this.
    fn limit_speed(&mut self, speed_max: Real) {
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

    /// The energy that contacts may leave. If links turn far in a substep of `h` seconds, contacts make energy, as their rows are
    /// those of the beginning of the step; so there is a limit for these, and none for others.
    pub fn energy_before_contacts(&mut self, h: Real) -> Real {
        self.kinematics.velocities(&self.rates, &self.root, &mut self.velocities);
        let turns_far =
            |v: &SpatialVector| ang_length_squared(angular(v)) * h * h > FAR_TURN * FAR_TURN;
        let is_fast = self.is_wild || self.velocities.iter().any(turns_far);
        if is_fast { self.kinetic_energy() } else { Real::MAX }
    }

    /// Takes away what contacts made of this energy.
    pub fn keep_energy(&mut self, before: Real) {
        if before < Real::MAX {
            self.is_wild |= self.kinetic_energy() > JUMP * before;
            if self.is_wild {
                self.limit_energy(before);
            }
        }
    }

    /// Slows all degrees of freedom down alike if the links have more energy than this.
    fn limit_energy(&mut self, most: Real) {
        let energy = self.kinetic_energy();
        if energy > most {
            self.slow_down((most / energy).sqrt());
        }
    }

    /// Leaves this share of the velocities, but of those of degrees of freedom that move as they are told.
    fn slow_down(&mut self, share: Real) {
        for (rate, drive) in self.rates.iter_mut().zip(&self.drives) {
            *rate *= if drive.armature == Real::INFINITY { 1.0 } else { share };
        }
        (self.momentum, self.outside) = (self.root_momentum(), ZERO);
    }

    /// The kinetic energy of all links.
    fn kinetic_energy(&mut self) -> Real {
        self.kinematics.velocities(&self.rates, &self.root, &mut self.velocities);
        let of = |(link, velocity): (&LinkFrame, &SpatialVector)| {
            let (v, w) = (linear(velocity), angular(velocity));
            0.5 * (link.mass * v.length_squared() + ang_dot(w, turn(&link.inertia, w)))
        };
        self.kinematics.links.iter().zip(&self.velocities).map(of).sum()
    }

    /// What forces, springs and dampers add to the velocities.
    fn kick(&mut self, multibody: &Multibody, h: Real, change: &mut Vec<Real>) {
        self.kinematics.velocities(&self.rates, &self.root, &mut self.velocities);
        self.wrenches.clear();
        for ((link, force), velocity) in
            self.kinematics.links.iter().zip(&self.forces).zip(&self.velocities)
        {
            let [along, about] = force.damping;
            let drag = join(
                linear(velocity) * (link.mass * along),
                turn(&link.inertia, angular(velocity)) * about,
            );
            let mut impulse = ZERO;
            add_scaled(&mut impulse, &force.wrench, h);
            add_scaled(&mut impulse, &drag, -h);
            self.wrenches.push(impulse);
        }
        change.clear();
        for ((drive, dof), rate) in self.drives.iter().zip(&multibody.dofs).zip(&self.rates) {
            let is_idle = drive.stiffness == 0.0;
            let joint = &multibody.links[dof.link].joint;
            let q = if is_idle { 0.0 } else { joint.coordinate(dof.axis) };
            let spring = drive.pull - drive.stiffness * (q + h * rate);
            change.push(h * (spring - drive.damping * rate));
        }
        self.factor.solve(&self.kinematics, &self.wrenches, change);
    }

    /// What inertia alone changes about the velocities in `h` seconds.
    fn drift(&mut self, h: Real, change: &mut Vec<Real>) {
        let Self { kinematics, velocities, accelerations, wrenches, .. } = self;
        kinematics.velocities(&self.rates, &self.root, velocities);
        kinematics.inertial_wrenches(&self.rates, velocities, accelerations, wrenches);
        change.clear();
        change.resize(self.rates.len(), 0.0);
        self.factor.solve(kinematics, wrenches, change);
        change.iter_mut().for_each(|number| *number *= h);
    }

    /// Moves the links for `h` seconds at their velocities, and turns these to those of the substep's end. None gets faster
    /// than `speed_max`.
    pub fn advance(&mut self, multibody: &mut Multibody, h: Real, speed_max: Real) {
        let root_center = self.kinematics.links[0].center;
        let energy = self.kinetic_energy();
        multibody.integrate(h, &self.rates, &self.root);
        self.kinematics.update(multibody);
        self.resist(h);
        if !self.is_wild {
            let mut change = core::mem::take(&mut self.change);
            self.drift(0.5 * h, &mut change);
            add_all(&mut self.rates, &change, 1.0);
            self.is_wild = self.kinetic_energy() > JUMP * energy;
            if self.is_wild {
                add_all(&mut self.rates, &change, -1.0);
            }
            self.change = change;
        }
        self.keep_momentum(root_center);
        if self.is_wild {
            self.limit_energy(energy);
        }
        self.limit_speed(speed_max);
    }

    /// Moves the links for `h` seconds, which may be negative, at these rates. Velocities stay.
    pub fn displace(&mut self, multibody: &mut Multibody, rates: &[Real], h: Real) {
        let root_center = self.kinematics.links[0].center;
        multibody.integrate(h, rates, &ZERO);
        self.kinematics.update(multibody);
        self.carry_momentum(root_center);
    }

    /// Undoes what inertia changed in the last `h` seconds, which led to the velocities that there are.
    pub fn fly_back(&mut self, h: Real) {
        let mut change = core::mem::take(&mut self.change);
        self.drift(h, &mut change);
        add_all(&mut self.rates, &change, -1.0);
        self.change = change;
    }

    /// Lets inertia change the velocities for `h` seconds, implicitly as [`Self::accelerate`] does.
    pub fn fly_on(&mut self, h: Real) {
        let mut change = core::mem::take(&mut self.change);
        let start = self.rates.clone();
        if !self.fly_half(&start, h, &mut change) {
            self.rates.copy_from_slice(&start);
        }
        self.change = change;
    }

    /// The velocities before the first half of the flight.
    pub fn rates_before_flight(&self) -> Vec<Real> {
        let mut rates = self.rates.clone();
        add_all(&mut rates, &self.flown, -1.0);
        rates
    }

    /// Lets inertia act for `h` seconds on velocities that `start` like this, taking those of their end. Returns whether the
    /// visits come together.
    fn fly_half(&mut self, start: &[Real], h: Real, change: &mut Vec<Real>) -> bool {
        let (mut moved, mut comes_together) = (Real::MAX, true);
        for _ in 0..VISITS {
            self.drift(h, change);
            let news =
                |((rate, start), change): ((&Real, &Real), &Real)| (start + change - rate).abs();
            let next = self.rates.iter().zip(start).zip(&*change).map(news).fold(0.0, Real::max);
            // What is lost in rounding anyway need not come any nearer.
            let fastest = start.iter().fold(0.0, |most: Real, rate| most.max(rate.abs()));
            comes_together &= next <= (WILD * moved).max(16.0 * Real::EPSILON * fastest);
            moved = next;
            self.rates.copy_from_slice(start);
            add_all(&mut self.rates, change, 1.0);
        }
        comes_together
    }

    /// Ends the step.
    pub fn finish(&mut self) {
        self.keep_momentum(self.kinematics.links[0].center);
    }

    /// Gives the root the impulse that the velocities miss of the momentum. That was about `before`, and is about the root's
    /// centre of mass from now on.
    fn keep_momentum(&mut self, before: Vector) {
        if self.root_dofs() == 0 {
            return;
        }
        self.carry_momentum(before);
        let mut missing = self.momentum;
        add_scaled(&mut missing, &self.root_momentum(), -1.0);
        let mut change = core::mem::take(&mut self.change);
        change.clear();
        change.resize(self.rates.len(), 0.0);
        self.factor.solve(&self.kinematics, &[missing], &mut change);
        let energy = self.kinetic_energy();
        add_all(&mut self.rates, &change, 1.0);
        // More than an error: what was pushed has turned away since.
        if self.kinetic_energy() > JUMP * energy {
            add_all(&mut self.rates, &change, -1.0);
            self.momentum = self.root_momentum();
        }
        self.change = change;
    }

    /// Lets the momentum that was about `before` be about the root's centre of mass, with the impulses from outside.
    fn carry_momentum(&mut self, before: Vector) {
        let center = self.kinematics.links[0].center;
        let mut momentum = carry_back(&self.momentum, before - center);
        add_scaled(&mut momentum, &carry_back(&self.outside, self.origin - center), 1.0);
        (self.momentum, self.outside) = (momentum, ZERO);
    }

    /// The momentum of all links together, about the root's centre of mass.
    fn root_momentum(&mut self) -> SpatialVector {
        let Self { kinematics, velocities, wrenches, .. } = self;
        kinematics.velocities(&self.rates, &self.root, velocities);
        wrenches.clear();
        wrenches.extend(kinematics.links.iter().zip(velocities).map(|(link, velocity)| {
            join(linear(velocity) * link.mass, turn(&link.inertia, angular(velocity)))
        }));
        for (id, link) in kinematics.links.iter().enumerate().rev() {
            let Some(parent) = link.parent else { continue };
            let felt = carry_back(&wrenches[id], link.lever);
            add_scaled(&mut wrenches[parent], &felt, 1.0);
        }
        wrenches[0]
    }

    /// The velocities of all links.
    pub fn link_velocities(&mut self) -> &[SpatialVector] {
        self.kinematics.velocities(&self.rates, &self.root, &mut self.velocities);
        &self.velocities
    }

    /// The velocities of all links if these rates alone move them.
    pub fn link_velocities_at(&mut self, rates: &[Real]) -> &[SpatialVector] {
        self.kinematics.velocities(rates, &ZERO, &mut self.velocities);
        &self.velocities
    }
}

/// The length of a velocity, whose square may be beyond all numbers.
fn speed(velocity: Vector) -> Real {
    let size = velocity.abs().max_element();
    if size > 0.0 { (velocity / size).length() * size } else { 0.0 }
}

/// `target += change · factor`.
fn add_all(target: &mut [Real], change: &[Real], factor: Real) {
    for (number, more) in target.iter_mut().zip(change) {
        *number += more * factor;
    }
}
