//! The ledger of an island's kinetic energy: impulses of a substep must not increase it.
//!
//! Contacts without restitution, locked axes, limits and dampers do no positive work. Let `v` be the
//! velocities before any impulse of a substep. The exact solution is the projection of `v` on the admissible
//! velocities in the metric of the kinetic energy (Moreau, "Unilateral contact and dry friction in finite
//! freedom dynamics", 1988). A gain is therefore an error: one Gauss-Seidel iteration has not converged,
//! Newton's rounds end at poses that they did not predict, or the impulses of the last substep, with which a
//! substep starts, act along axes that have rotated since. Each of these can feed the next substep (figures:
//! `docs/decisions/0029-energy-of-islands.md`).
//!
//! ## The fraction of the impulses
//! With the effect `Δv` of all impulses of an island, the multiple `θ` of these impulses leads to
//!
//! ```text
//! T(v + θ Δv) = T(v) + θ b + θ² a / 2        b = ⟨v, Δv⟩,   a = ⟨Δv, Δv⟩       (metric of the kinetic energy)
//! ```
//!
//! The island keeps the largest fraction `θ ≤ 1` with which `T` does not exceed its bound. A fraction of
//! impulses conserves momentum, pushes and does not pull, and satisfies the law of friction, as all of them
//! do. The next substep starts with the same fraction.
//!
//! ## Entries of a substep
//! * *Start*: the impulses of the last substep are bounded by `2 T(v)`. Where they balance forces, they
//!   reduce the energy.
//! * *Correction*: those of the solve pass, which corrects errors by velocities, by `2 T(v)` and the energy
//!   of all bodies at the largest speed of a correction. Without a bound, a joint that is half a metre off
//!   moves light bodies by several metres in a substep.
//! * *End*: after the relax pass, by `T(v)` of the start and the rest of the balance. A balance adds the
//!   gains up, and is at most [`ERROR_MAX`] of the energy. Energy that is lost beyond that does not return.
//!
//! ## Scope
//! Islands with joints, and islands with more deep contacts than bodies of such contacts, for which one relax
//! iteration does not converge. (A thousand balls at one point left with 300 m/s, though each contact pushes
//! with 4 m/s at most.) Other contacts converge, and their islands may be large. Islands that something
//! drives are left out: motors, springs, multibodies, moving kinematic bodies, dominance and moving surfaces
//! all do work.
//!
//! Alternative: scaling the velocities of the bodies that gained. It does not conserve momentum.

use super::bodies::SolverBodies;
use super::context::SolverPass;
use super::island_sums::IslandSums;
use super::states::load_states;
use crate::base::wide::{Kernel, LANES, Lane, Wide};
use crate::dim::contact::ContactBlock;
use crate::dim::math::{Real, ang_dot, inertia_of};
use crate::dim::rotation_vector::turned_inertia;
use crate::dim::state::{BodyState, READ_ONLY};
use crate::dim::wide::{
    WideSymmetric, ZERO_INERTIA, ang_dot as wide_ang_dot, load_symmetric, mul_inertia,
    set_symmetric_lane,
};
use crate::model::body::EnergyError;
use crate::model::contact::ContactInput;
use crate::model::params::ContactPass;
use core::ops::Range;

/// The fraction of the largest corrective velocity from which overlap counts as deep.
const DEEP_FRACTION: Real = 0.125;
/// The bound of the balance, as a fraction of the kinetic energy. The energy of a chain oscillates as its
/// links rotate: what a substep gains, the next one loses.
const ERROR_MAX: f64 = 0.025;
/// Relative rounding error of an island's energy.
const ROUNDING: f64 = 8.0 * Real::EPSILON as f64;
/// The same for sums in another order.
const ORDER_ROUNDING: f64 = 1.0e-11;

/// The overlap (length) from which on its correction may throw bodies.
pub(super) fn deep_overlap(pass: &ContactPass) -> Real {
    let rate = pass.softness.bias_rate * pass.softness.mass_scale;
    pass.allowed_error + DEEP_FRACTION * pass.push_velocity_max / rate
}

/// What bounds an entry.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) enum Entry {
    /// The impulses with which a substep starts.
    Start,
    /// Those of the solve pass, too, which correct errors.
    Correction,
    /// Those that remain after the relax pass.
    End,
}

/// Sums over bodies: `T(v)`, `b` and `a`.
type Terms = [f64; 3];

/// The account of one island.
#[derive(Copy, Clone, Debug, Default)]
struct Account {
    has_joints: bool,
    /// The numbers of its deep contacts, and of the bodies that have some.
    deep_contacts: usize,
    deep_bodies: usize,
    /// Whether something does work on it that no entry includes.
    is_driven: bool,
    /// Its mass, and `T(v)` of the substep.
    mass: f64,
    energy: f64,
    terms: Terms,
    /// Energy that impulses have added.
    balance: f64,
    /// Whether an entry exceeded its bound since the balance was positive.
    is_exceeded: bool,
    /// The bound of the present entry.
    bound: f64,
    /// Whether it may exceed the bound.
    is_due: bool,
    /// The fraction of its impulses that it keeps.
    kept: Real,
}

impl Account {
    fn is_open(&self) -> bool {
        (self.has_joints || self.deep_contacts > self.deep_bodies) && !self.is_driven
    }

    /// Sets the bound of an entry, for corrections of up to this speed.
    fn set_bound(&mut self, entry: Entry, speed: f64) {
        if entry == Entry::Start {
            self.energy = self.terms[0];
        }
        self.bound = match entry {
            Entry::Start => 2.0 * self.energy,
            Entry::Correction => 2.0 * self.energy + 0.5 * self.mass * speed * speed,
            Entry::End => self.energy + (self.band() - self.known_balance()).max(0.0),
        };
        self.is_due = self.may_exceed();
    }

    /// The bound of the balance, in both directions.
    fn band(&self) -> f64 {
        ERROR_MAX * self.energy
    }

    /// The balance without losses beyond the band, which do not return.
    fn known_balance(&self) -> f64 {
        self.balance.max(-self.band())
    }

    /// Adds the gain of the substep to the balance.
    fn settle(&mut self) {
        let ([t, b, a], kept) = (self.terms, f64::from(self.kept));
        let gain = t + kept * (b + 0.5 * kept * a) - self.energy;
        let balance = self.known_balance() + gain;
        self.balance = if balance.is_finite() { balance.max(-self.band()) } else { 0.0 };
        self.is_exceeded = self.balance > 0.0 && (self.is_exceeded || self.kept < 1.0);
    }

    /// Returns whether its energy is beyond the bound, with sums of which the order may be another one.
    fn may_exceed(&self) -> bool {
        let [t, b, a] = self.terms;
        self.is_open() && t + b + 0.5 * a > self.bound - ORDER_ROUNDING * (t + b.abs() + a)
    }

    /// The largest fraction of the impulses that keeps to the bound; if there is none, the one of the least
    /// energy.
    fn fraction(&self) -> Real {
        let [t, b, a] = self.terms;
        let bound = self.bound + ROUNDING * self.energy;
        if t + b + 0.5 * a <= bound || a.is_nan() {
            return 1.0;
        }
        let root = (b * b - 2.0 * a * (t - bound)).max(0.0).sqrt();
        ((root - b) / a).clamp(0.0, 1.0) as Real
    }
}

/// Mass and inertia of [`LANES`] adjacent bodies when the step began.
#[derive(Copy, Clone, Debug)]
struct Masses {
    mass: Lane,
    inertia: WideSymmetric<Lane>,
    /// Whether any of them belongs to an open account.
    is_open: bool,
}

/// The accounts of all islands of a group.
#[derive(Default)]
pub(super) struct Ledger {
    accounts: Vec<Account>,
    /// The indices of the group's bodies, and their masses.
    members: Range<usize>,
    masses: Vec<Masses>,
    /// By body of the group: the terms of the present entry.
    terms: Vec<[Lane; 3]>,
    /// By index of a body: whether it is among the [deep bodies](Account::deep_bodies).
    is_deep: Vec<bool>,
    sums: IslandSums<3>,
    is_active: bool,
}

impl Ledger {
    /// Begins a step without accounts.
    pub fn clear(&mut self) {
        self.is_active = false;
    }

    /// Begins a step in which there may be accounts.
    pub fn begin(&mut self, bodies: &SolverBodies) {
        self.accounts.clear();
        let empty = Account { balance: f64::NEG_INFINITY, ..Account::default() };
        self.accounts.resize(bodies.island_bound(), empty);
        self.is_deep.clear();
        self.is_deep.resize(bodies.states.len(), false);
        self.is_active = true;
    }

    /// Leaves an island out.
    pub fn leave_out(&mut self, island: u32) {
        if let Some(account) = self.accounts.get_mut(island as usize) {
            account.is_driven = true;
        }
    }

    /// Includes the island of a joint, which something may drive.
    pub fn note_joint(&mut self, island: u32, is_driven: bool) {
        if let Some(account) = self.accounts.get_mut(island as usize) {
            account.has_joints = true;
            account.is_driven |= is_driven;
        }
    }

    /// Counts the contacts deeper than `deep` and their bodies by island, and marks driven islands.
    pub fn note_contacts(
        &mut self,
        block: &ContactBlock,
        input: &ContactInput,
        deep: Real,
        bodies: &SolverBodies,
    ) {
        for lane in 0..LANES {
            let pair = input.bodies.map(|side| side[lane]);
            let island = bodies.island_of(pair);
            let Some(account) = self.accounts.get_mut(island as usize) else { continue };
            if block.points.iter().any(|it| it.mass.0[lane] > 0.0 && it.separation.0[lane] < -deep)
            {
                account.deep_contacts += 1;
                for body in pair.into_iter().filter(|body| body & READ_ONLY == 0) {
                    let was_deep = core::mem::replace(&mut self.is_deep[body as usize], true);
                    account.deep_bodies += usize::from(!was_deep);
                }
            }
            account.is_driven |= is_driven(pair, lane, input, bodies);
        }
    }

    /// Opens the accounts: reads the masses of their bodies.
    pub fn open(&mut self, bodies: &SolverBodies) {
        let Self { accounts, members, masses, .. } = self;
        self.is_active &= accounts.iter().any(Account::is_open);
        if !self.is_active {
            return;
        }
        [_, *members] = bodies.moving();
        masses.clear();
        for first in members.clone().step_by(LANES) {
            let mut all = Masses { mass: Lane::ZERO, inertia: ZERO_INERTIA, is_open: false };
            for (lane, index) in (first..members.end.min(first + LANES)).enumerate() {
                let account = accounts.get_mut(bodies.islands[index] as usize);
                let Some(account) = account.filter(|account| account.is_open()) else { continue };
                let pose = &bodies.poses[index];
                let inv_mass = pose.inv_mass().max_element();
                let mass = if inv_mass > 0.0 { 1.0 / inv_mass } else { 0.0 };
                account.mass += f64::from(mass);
                // A new body has none, and islands that merge have the worse one.
                let error = bodies.energy_errors[index];
                account.balance = account.balance.max(f64::from(error.added));
                account.is_exceeded |= error.is_exceeded;
                all.is_open = true;
                all.mass.0[lane] = mass;
                set_symmetric_lane(&mut all.inertia, lane, &inertia_of(&pose.inv_inertia()));
            }
            masses.push(all);
        }
    }

    /// Makes an entry. Returns whether any island must not keep all of its impulses.
    pub fn enter(
        &mut self,
        entry: Entry,
        bodies: &mut SolverBodies,
        pass: &SolverPass<'_>,
    ) -> bool {
        if !self.is_active {
            return false;
        }
        self.measure(bodies, pass);
        let speed = f64::from(pass.joints.correction_max);
        for account in self.accounts.iter_mut().filter(|account| account.is_open()) {
            account.set_bound(entry, speed);
        }
        let is_exceeded = self.accounts.iter().any(|account| account.is_due);
        if is_exceeded {
            self.add_up_in_order(bodies);
        }
        if entry == Entry::End {
            self.accounts.iter_mut().filter(|account| account.is_open()).for_each(Account::settle);
        }
        is_exceeded && self.limit(bodies)
    }

    /// Ends the step: notes the balances in the bodies.
    pub fn close(&mut self, bodies: &mut SolverBodies) {
        if !self.is_active {
            return;
        }
        for index in self.members.clone() {
            let account = self.accounts.get(bodies.islands[index] as usize);
            if let Some(account) = account.filter(|account| account.is_open()) {
                let Account { balance, is_exceeded, .. } = *account;
                bodies.energy_errors[index] = EnergyError { added: balance as Real, is_exceeded };
            }
        }
    }

    /// Sums up the terms of the bodies of each island.
    fn measure(&mut self, bodies: &SolverBodies, pass: &SolverPass<'_>) {
        let Self { accounts, members, masses, terms, .. } = self;
        let (states, before) = (&bodies.states[members.clone()], &bodies.before[members.clone()]);
        terms.clear();
        terms.resize(masses.len(), [Lane::ZERO; 3]);
        pass.simd.run(Measure { masses, states, before, terms });
        for account in &mut *accounts {
            (account.terms, account.is_due, account.kept) = ([0.0; 3], false, 1.0);
        }
        for (index, terms) in members.clone().zip(each(terms)) {
            if let Some(account) = accounts.get_mut(bodies.islands[index] as usize) {
                (0..3).for_each(|k| account.terms[k] += f64::from(terms[k]));
            }
        }
    }

    /// Repeats the sums of islands that may exceed their bound, in an order that does not depend on the rest of
    /// the world.
    fn add_up_in_order(&mut self, bodies: &SolverBodies) {
        let Self { accounts, members, terms, sums, .. } = self;
        sums.clear();
        for (index, terms) in members.clone().zip(each(terms)) {
            let island = bodies.islands[index];
            if accounts.get(island as usize).is_some_and(|account| account.is_due) {
                sums.push(island, terms);
            }
        }
        for account in accounts.iter_mut().filter(|account| account.is_due) {
            account.terms = [0.0; 3];
        }
        sums.for_each(|island, terms| {
            let account = &mut accounts[island as usize];
            (0..3).for_each(|k| account.terms[k] += f64::from(terms[k]));
        });
        for account in accounts.iter_mut().filter(|account| account.is_due) {
            account.kept = account.fraction();
        }
    }

    /// Leaves the bodies the fraction of the effect of their impulses. Returns whether any is less than 1.
    fn limit(&self, bodies: &mut SolverBodies) -> bool {
        let mut any = false;
        for index in self.members.clone() {
            let kept = self.kept_by_island(bodies.islands[index]);
            if kept < 1.0 {
                let (before, state) = (bodies.before[index].velocity(), &mut bodies.states[index]);
                let (v, w) = state.velocity();
                let (old_v, old_w) = before;
                state.set_velocity(old_v + (v - old_v) * kept, old_w + (w - old_w) * kept);
                any = true;
            }
        }
        any
    }

    fn kept_by_island(&self, island: u32) -> Real {
        self.accounts.get(island as usize).map_or(1.0, |account| account.kept)
    }

    /// The fractions of their impulses that constraints of these bodies keep, if not all of them.
    pub fn kept_by(&self, pairs: &[[u32; LANES]; 2], bodies: &SolverBodies) -> Option<Lane> {
        let mut factors = Lane::splat(1.0);
        for (lane, factor) in factors.0.iter_mut().enumerate() {
            *factor = self.kept_by_island(bodies.island_of(pairs.map(|side| side[lane])));
        }
        factors.0.iter().any(|&factor| factor < 1.0).then_some(factors)
    }
}

/// The terms of each body.
fn each(terms: &[[Lane; 3]]) -> impl Iterator<Item = [Real; 3]> {
    terms.iter().flat_map(|lanes| (0..LANES).map(move |lane| lanes.map(|of| of.0[lane])))
}

/// Returns whether something other than the energy of its bodies drives a contact.
fn is_driven(pair: [u32; 2], lane: usize, input: &ContactInput, bodies: &SolverBodies) -> bool {
    let mut sides = pair.into_iter().zip(&input.mass_factors);
    let is_dominated = sides.any(|(body, factors)| body & READ_ONLY == 0 && factors.0[lane] != 1.0);
    let is_conveyor = input.tangent_velocity.lane(lane).length_squared() > 0.0;
    is_dominated || is_conveyor || is_carried(pair, bodies)
}

/// Returns whether a body that constraints cannot move moves.
pub(super) fn is_carried(pair: [u32; 2], bodies: &SolverBodies) -> bool {
    pair.into_iter().filter(|index| index & READ_ONLY != 0).any(|index| {
        let (v, w) = bodies.states[(index & !READ_ONLY) as usize].velocity();
        v.length_squared() + ang_dot(w, w) > 0.0
    })
}

/// Computes the terms of bodies, with their inertias at the present poses.
struct Measure<'a> {
    masses: &'a [Masses],
    states: &'a [BodyState],
    before: &'a [BodyState],
    terms: &'a mut [[Lane; 3]],
}

impl Kernel for Measure<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        let states = self.states.chunks(LANES).zip(self.before.chunks(LANES));
        let all = self.masses.iter().zip(self.terms).zip(states);
        for ((masses, terms), (states, before)) in all.filter(|((it, _), _)| it.is_open) {
            let ((now, moved), (old, _)) = (load_states::<W>(states), load_states::<W>(before));
            let change = now - old;
            let inertia = turned_inertia(load_symmetric(&masses.inertia), moved.rotation());
            let mass = W::load(&masses.mass);
            let (p, l) = (change.linear * mass, mul_inertia(inertia, change.angular));
            let own = mul_inertia(inertia, old.angular);
            let t = old.linear.dot(old.linear) * mass + wide_ang_dot(old.angular, own);
            (t * W::splat(0.5)).store(&mut terms[0]);
            (old.linear.dot(p) + wide_ang_dot(old.angular, l)).store(&mut terms[1]);
            (change.linear.dot(p) + wide_ang_dot(change.angular, l)).store(&mut terms[2]);
        }
    }
}
