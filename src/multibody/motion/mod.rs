//! Motion of one multibody through a step: a substep without contacts, and its response to impulses.
//!
//! # A substep
//! The scheme is kick, free motion, kick: the free motion uses the velocity in the middle of the substep.
//! With the inertial forces `-C q̇` and the step `h`
//!
//! ```text
//! q̇  ← q̇ + h M̃⁻¹ (gravity, forces of the user, springs, dampers, motors)      at q
//! q̇½ = q̇ - ½ h M̃⁻¹ C(q, q̇½) q̇½                                               implicit: by iteration
//!      contacts and limits act on q̇½
//! q  ← q + h q̇½
//! q̇  ← q̇½ - ½ h M̃⁻¹ C(q, q̇½) q̇½                                               explicit, at the new q
//! ```
//!
//! The two halves of the free motion are each other's mirror image. The method is therefore reversible and of
//! second order, and its energy does not drift. It is the generalised leapfrog (Hairer, Lubich, Wanner,
//! "Geometric Numerical Integration", 2006, chapter VI) in velocities. Persistent limits and contacts must
//! not break the symmetry. The first half therefore includes half of the impulses of the last substep, which
//! equals their steady state, and the rest is added after it. (Without them, a conical pendulum at 8 rad/s
//! loses a tenth of its energy per second.) An explicit step `q̇ - h M⁻¹ C q̇`, as given by one evaluation of
//! forward dynamics, makes a tumbling chain gain energy until it explodes. A single body uses another
//! symmetric method (`dim3/gyroscopic.rs`), so chains and bodies fall alike to second order.
//!
//! `M̃ = M + h D + θ h² K`: dampers `D` are evaluated at the end of the substep, and springs of stiffness `K`
//! after the fraction `θ` of it. At its beginning, `θ = 0`, they conserve energy but are stable only for `h ω
//! < 2`. At its end they are always stable, and lose `h ω / 2` of the energy per radian. With `a = (h ω)²`
//! and
//!
//! ```text
//! θ = a / (1 + a)        stable for a (1 - 2 θ) < 4, that is, always; loss per substep θ a, in fourth order
//! ```
//!
//! springs that can be followed swing on (2 Hz at 240 substeps a second: 0.5 % in three seconds), and stiff
//! ones hold.
//!
//! Free motion and its non-converged pieces are in `free.rs`, momentum in `centroidal.rs`, energy in
//! `ledger.rs`.

mod centroidal;
mod energy;
mod free;
mod ledger;
mod rates;

use super::factor::{Factor, Resistance};
use super::kinematics::Kinematics;
use super::locked_inertia::LockedInertia;
use super::spatial::{ZERO, add_scaled, angular_momentum};
use crate::dim::math::{Real, SpatialVector};
use crate::dim::spatial::{angular, join, linear};
use crate::model::body::RigidBodySet;
use crate::model::multibody::{DofLists, Multibody, MultibodyLink};
use ledger::Ledger;
use rates::Rates;

/// Constant loads on a link during a step.
#[derive(Copy, Clone, Debug)]
pub struct LinkForce {
    /// Gravity and the user's forces.
    pub wrench: SpatialVector,
    /// Damping of the body, linear and angular (1/s).
    pub damping: [Real; 2],
}

/// Constant loads on a degree of freedom during a step: `pull - stiffness q - damping q̇`.
#[derive(Copy, Clone, Debug, Default)]
pub struct JointLoad {
    /// Inertia in addition to that of the links; infinite for a prescribed degree of freedom.
    pub armature: Real,
    /// Force per coordinate.
    pub stiffness: Real,
    /// Force per velocity.
    pub damping: Real,
    /// Force at the coordinate 0 and the velocity 0.
    pub pull: Real,
}

impl JointLoad {
    /// Returns whether the velocity of the degree of freedom is prescribed.
    fn is_prescribed(&self) -> bool {
        self.armature == Real::INFINITY
    }
}

/// See the [module](self). Fields that are lists have a number per degree of freedom.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    pub kinematics: Kinematics,
    factor: Factor,
    locked_inertia: LockedInertia,
    /// The velocities.
    pub rates: Rates,
    pub forces: Vec<LinkForce>,
    pub joint_loads: Vec<JointLoad>,
    /// The velocity of a root without degrees of freedom.
    root: SpatialVector,
    /// Fraction of the substep at which a spring is evaluated: `θ`.
    spring_times: Vec<Real>,
    /// Inverse articulated inertia of each degree of freedom: descendants free, ancestors locked. The root's
    /// are all free.
    inv_articulated_inertias: Vec<Real>,
    armature: Vec<Real>,
    drag: Vec<[Real; 2]>,
    /// The momentum of all links about the root's centre of mass, without [`Self::external_impulse`].
    momentum: SpatialVector,
    /// The impulses from outside since then, likewise.
    external_impulse: SpatialVector,
    /// Those of the links: see [`Self::update_velocities`].
    velocities: Vec<SpatialVector>,
    accelerations: Vec<SpatialVector>,
    wrenches: Vec<SpatialVector>,
    momenta: Vec<SpatialVector>,
    change: Vec<Real>,
    /// Buffers of functions, kept between steps: a step allocates nothing.
    buffers: Vec<Vec<Real>>,
    /// Whether a link exceeded the velocity limit since the step began.
    pub is_limited: bool,
    /// Velocity changes by the first half of the free motion.
    first_half_change: Vec<Real>,
    /// Velocity changes by the second half of the last piece, and its length (s).
    last_kick: (Vec<Real>, Real),
    ledger: Ledger,
    /// The largest angular velocity of a link (rad/s).
    fastest_turn: Real,
    /// Number of pieces of this substep's free motion.
    pieces: usize,
    /// Whether a piece of this substep's free motion is too fast to be integrated.
    pub has_diverged: bool,
}

impl Motion {
    /// Begins a step: the links get the poses of the coordinates, and the velocities of the last step.
    /// `joint_loads` must be set before.
    ///
    /// Velocities and impulses that the user applied to bodies since the last step count as momentum. The
    /// generalised velocities have, at each degree of freedom, the momentum of the bodies.
    pub fn begin(&mut self, multibody: &Multibody, bodies: &RigidBodySet) {
        self.is_limited = false;
        self.ledger = Ledger::default();
        self.last_kick.0.clear();
        self.place(multibody);
        let velocity = |link: &MultibodyLink| Some(bodies.get(link.body)?.vels);
        let is_pushed = multibody.links.iter().any(|link| velocity(link) != link.seen_velocity);
        let DofLists { velocities, body_velocities, .. } = &multibody.lists;
        let rates = if is_pushed { body_velocities } else { velocities };
        self.rates.assign(rates.iter().map(|&rate| finite(rate)));
        debug_assert_eq!(self.rates.len(), self.kinematics.axes.len());
        debug_assert_eq!(self.joint_loads.len(), self.rates.len(), "`joint_loads` are set before");
        self.armature.clear();
        self.armature.extend(self.joint_loads.iter().map(|load| load.armature));
        self.factor.update(&self.kinematics, Resistance { armature: &self.armature, drag: &[] });
        self.inv_articulated_inertias.clear();
        self.inv_articulated_inertias
            .extend(self.factor.inv_articulated_inertias(&self.kinematics.root_axes));
        let body = |link: &MultibodyLink| bodies.get(link.body);
        self.root = ZERO;
        if let Some(root) = body(&multibody.links[0]).filter(|root| !root.is_dynamic()) {
            self.root = join(root.vels.linvel, root.vels.angvel);
        }
        if is_pushed {
            self.take_momenta(|id, frame| {
                let link = &multibody.links[id];
                // The zero velocity of a body that became a link does not count: its parent takes it along.
                let velocity =
                    velocity(link).filter(|v| link.seen_velocity.is_some() || !v.is_zero());
                let velocity = velocity.filter(|_| body(link).is_some_and(|b| b.is_dynamic()))?;
                Some(frame.momentum(&join(velocity.linvel, velocity.angvel)))
            });
            self.add_set_velocities(&multibody.lists);
        }
        self.follow_momentum();
    }

    /// Adds the changes of generalised velocities by the user since the last step.
    fn add_set_velocities(&mut self, lists: &DofLists) {
        let velocities = lists.velocities.iter().zip(&lists.body_velocities);
        for (rate, (&set, &before)) in self.rates.iter_mut().zip(velocities) {
            let (set, before) = (finite(set), finite(before));
            // Without rounding where no body was pushed, as for prescribed velocities.
            *rate = if *rate == before { set } else { *rate + (set - before) };
        }
    }

    /// Moves the links to the poses of the coordinates.
    fn place(&mut self, multibody: &Multibody) {
        self.kinematics.update(multibody);
        self.locked_inertia = LockedInertia::of(&self.kinematics);
        self.rates.touch();
    }

    /// Returns whether the root moves at a velocity set by the user.
    pub fn is_carried(&self) -> bool {
        self.root != ZERO
    }

    /// Number of degrees of freedom of the root.
    pub fn root_dofs(&self) -> usize {
        self.kinematics.links[0].dofs.len()
    }

    /// Adds up the articulated inertias for substeps of `h` seconds, with springs and dampers.
    pub fn resist(&mut self, h: Real) {
        self.spring_times.clear();
        self.armature.clear();
        for (load, inv_inertia) in self.joint_loads.iter().zip(&self.inv_articulated_inertias) {
            let swing = h * h * load.stiffness * inv_inertia;
            let time = if swing < Real::INFINITY { swing / (1.0 + swing) } else { 1.0 };
            self.spring_times.push(time);
            self.armature.push(load.armature + h * (load.damping + time * h * load.stiffness));
        }
        self.drag.clear();
        self.drag.extend(self.forces.iter().map(|force| force.damping.map(|c| 1.0 + h * c)));
        let resistance = Resistance { armature: &self.armature, drag: &self.drag };
        self.factor.update(&self.kinematics, resistance);
    }

    /// By degree of freedom: its acceleration by a force of 1 on it, while all others are free.
    pub fn inverse_inertias(&mut self, inverses: &mut Vec<Real>) {
        self.factor.inverse_inertias(&self.kinematics, inverses);
    }

    /// Turns impulses on the degrees of freedom into velocities.
    pub fn respond(&mut self, impulses: &mut [Real]) {
        self.factor.solve(&self.kinematics, &[], impulses);
    }

    /// Applies the forces for `h` seconds and integrates the velocities to the middle of the substep. No link
    /// gets faster than `speed_max`. During it, the rates contain half of the effect of the last substep's
    /// impulses.
    pub fn accelerate(
        &mut self,
        multibody: &mut Multibody,
        h: Real,
        speed_max: Real,
        pushed: &[Real],
    ) {
        self.ledger.corrected += self.keep_momentum(self.kinematics.links[0].center);
        let mut change = core::mem::take(&mut self.change);
        self.kick(multibody, h, &mut change);
        add_all(&mut self.rates, &change, 1.0);
        multibody.lists.accelerations.clone_from(&change);
        self.limit_speed(speed_max);
        self.momentum = self.root_momentum();
        self.open_ledger(h);
        self.pieces = self.pieces_for(h);
        add_all(&mut self.rates, pushed, 0.5);
        self.begin_free_motion(h, &mut change);
        add_all(&mut self.rates, pushed, -0.5);
        if self.has_diverged {
            change.fill(0.0);
            self.limit_joint_rates(h);
            self.open_ledger(h);
        }
        self.first_half_change.clone_from(&change);
        let total = multibody.lists.accelerations.iter_mut().zip(&change);
        total.for_each(|(kick, half)| *kick = if h > 0.0 { (*kick + 2.0 * half) / h } else { 0.0 });
        self.change = change;
    }

    /// Velocity changes by forces, springs and dampers.
    fn kick(&mut self, multibody: &Multibody, h: Real, change: &mut Vec<Real>) {
        self.update_velocities();
        self.wrenches.clear();
        for ((link, force), velocity) in
            self.kinematics.links.iter().zip(&self.forces).zip(&self.velocities)
        {
            let [along, about] = force.damping;
            let drag = join(
                linear(velocity) * (link.mass * along),
                angular_momentum(&link.inertia, angular(velocity)) * about,
            );
            let mut impulse = ZERO;
            add_scaled(&mut impulse, &force.wrench, h);
            add_scaled(&mut impulse, &drag, -h);
            self.wrenches.push(impulse);
        }
        change.clear();
        let joint_loads = self.joint_loads.iter().zip(&self.spring_times);
        for (((load, time), dof), rate) in joint_loads.zip(&multibody.dofs).zip(self.rates.iter()) {
            let is_idle = load.stiffness == 0.0;
            let joint = &multibody.links[dof.link].joint;
            let q = if is_idle { 0.0 } else { joint.coordinate(dof.axis) };
            let spring = load.pull - load.stiffness * (q + time * h * rate);
            change.push(h * (spring - load.damping * rate));
        }
        self.factor.solve(&self.kinematics, &self.wrenches, change);
    }

    /// Ends the step. The last correction of the momentum adds no energy.
    pub fn finish(&mut self, touches: bool) {
        let (energy, of_free_motion) = (self.kinetic_energy(), self.free_motion_energy());
        let gain = self.keep_momentum(self.kinematics.links[0].center);
        if gain <= 0.0 || of_free_motion.is_none() {
            return;
        }
        if self.ledger.is_hit {
            self.limit_energy(energy, touches);
        } else {
            self.limit_free_energy(of_free_motion);
        }
    }

    /// The velocities of all links.
    pub fn link_velocities(&mut self) -> &[SpatialVector] {
        self.update_velocities();
        &self.velocities
    }

    /// Computes the velocities of the links, unless they are those of the present rates and poses.
    fn update_velocities(&mut self) {
        if self.rates.take_change() {
            self.kinematics.velocities(&self.rates, &self.root, &mut self.velocities);
        }
    }

    /// The velocities of all links at these rates, without the motion of the root.
    pub fn link_velocities_at(&mut self, rates: &[Real]) -> &[SpatialVector] {
        self.rates.touch();
        self.kinematics.velocities(rates, &ZERO, &mut self.velocities);
        &self.velocities
    }
}

/// A number, or zero if it is not finite.
fn finite(number: Real) -> Real {
    if number.is_finite() { number } else { 0.0 }
}

/// `target += change · factor`.
fn add_all(target: &mut [Real], change: &[Real], factor: Real) {
    for (number, more) in target.iter_mut().zip(change) {
        *number += more * factor;
    }
}
