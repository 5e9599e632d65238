//! The ledger of an island's kinetic energy: impulses of a substep must not increase it, within a bound.
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
//! The suspects, bodies of islands with joints and bodies with deep contacts, keep the largest fraction `θ ≤
//! 1` of their impulses with which the `T` of the island does not exceed its bound. A fraction of impulses
//! conserves momentum (except at contacts of deep bodies with others), does not pull, and stays within the
//! cone of friction. The next substep starts with the same fraction.
//!
//! ## Entries of a substep
//! * *Start*: the impulses of the last substep are bounded by `2 T(v)`. Impulses that balance forces reduce
//!   the energy.
//! * *Correction*: those of the solve pass, which corrects errors by velocities, by `2 T(v)` and the energy
//!   of all bodies at the largest speed of a correction.
//! * *End*: after the relax pass, by `T(v)` of the start and the rest of the balance. A balance adds the
//!   gains up, and is at most [`ERROR_MAX`] of the energy. Energy that is lost beyond that does not return.
//!
//! ## Scope
//! Islands with joints, and islands with more deep contacts than bodies of such contacts, for which one relax
//! iteration does not converge. (A thousand balls at one point left with 300 m/s, though each contact pushes
//! with 4 m/s at most.) Other contacts converge, and their islands may be large.
//!
//! Motors do work. Their islands have no bound at the start, and the others include the most energy that the
//! motors can give in a substep (`joints/motors_and_limits.rs`). That is no balance, but keeps an error from
//! multiplying. Their exact work `λ J (v + Δv/2)` is useless as a bound: the impulses of rigid motors cancel,
//! and their rounding exceeds `T`.
//!
//! Islands that anything else drives are left out: soft joints, elastic transmissions, multibodies, moving
//! kinematic bodies, dominance and moving surfaces.
//!
//! Alternative: scaling the velocities of the bodies that gained. It does not conserve momentum.

use super::bodies::SolverBodies;
use super::context::SolverPass;
use super::island_sums::{IslandSums, UnorderedSum};
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
/// Relative rounding error of the terms.
const ROUNDING: f64 = 8.0 * Real::EPSILON as f64;

/// The overlap (length) from which on its correction may throw bodies.
pub(super) fn deep_overlap(pass: &ContactPass) -> Real {
    let rate = pass.softness.bias_rate * pass.softness.mass_scale;
    pass.allowed_error + DEEP_FRACTION * pass.push_velocity_max / rate
}

/// What does work on bodies, apart from the impulses that an entry compares.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) enum Drive {
    None,
    /// Motors, whose energy is bounded.
    Motors,
    /// Anything else.
    Unbounded,
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

/// Numbers of a body, and sums over bodies: `T(v)`, `b`, `a`, and the mass.
type Terms<T> = [T; 4];

/// The energy with a fraction of the impulses.
fn energy_with([t, b, a, _]: Terms<f64>, fraction: f64) -> f64 {
    t + fraction * (b + 0.5 * fraction * a)
}

/// The largest fraction of the impulses with an energy of at most `bound`; if there is none, the one of the
/// least energy.
fn largest_fraction([t, b, a, _]: Terms<f64>, bound: f64) -> Real {
    let root = (b * b - 2.0 * a * (t - bound)).max(0.0).sqrt();
    let fraction = (root - b) / a;
    // Without an effect of the impulses there is nothing to take back.
    if fraction.is_finite() { fraction.clamp(0.0, 1.0) as Real } else { 1.0 }
}

/// The account of one island.
#[derive(Copy, Clone, Debug, Default)]
struct Account {
    has_joints: bool,
    /// The numbers of its deep contacts, and of the bodies that have some.
    deep_contacts: usize,
    deep_bodies: usize,
    has_motors: bool,
    /// Whether something does work on it that no entry includes.
    is_driven: bool,
    /// `T(v)` of the substep.
    energy: f64,
    /// The most energy that motors can give in the substep.
    drive: f64,
    /// Energy that impulses have added.
    balance: f64,
    /// Whether impulses were taken back in this step.
    is_exceeded: bool,
    /// Sums over all bodies, and over those that may have to return impulses.
    all: Terms<f64>,
    suspect: Terms<f64>,
    /// The fraction of their impulses that these keep.
    kept: Real,
}

impl Account {
    fn is_open(&self) -> bool {
        (self.has_joints || self.deep_contacts > self.deep_bodies) && !self.is_driven
    }

    /// Returns whether a body may have to return impulses. Impulses act on pairs: all bodies of an island
    /// with joints return the same fraction.
    fn suspects(&self, is_deep: bool) -> bool {
        self.has_joints || is_deep
    }

    /// Makes an entry for corrections of up to these velocities of joints and of contacts.
    fn enter(&mut self, entry: Entry, speeds: [f64; 2]) {
        let [of_joints, of_contacts] = speeds;
        let speed = if self.has_joints { of_joints.max(of_contacts) } else { of_contacts };
        let [energy, .., mass] = self.all;
        if entry == Entry::Start {
            self.energy = energy;
        }
        let bound = match entry {
            Entry::Start if self.has_motors => f64::INFINITY,
            Entry::Start => 2.0 * self.energy,
            Entry::Correction => 2.0 * self.energy + 0.5 * mass * speed * speed + self.drive,
            Entry::End => self.energy + (self.band() - self.known_balance()).max(0.0) + self.drive,
        };
        self.limit(bound);
        if entry == Entry::End {
            self.settle();
        }
    }

    /// Finds the fraction with which the island keeps to its bound.
    fn limit(&mut self, bound: f64) {
        let [t, b, a, _] = self.all;
        let now = energy_with(self.all, 1.0);
        let exceeds = now > bound + ROUNDING * (t + b.abs() + a);
        self.kept = if exceeds {
            let others = now - energy_with(self.suspect, 1.0);
            largest_fraction(self.suspect, bound - others)
        } else {
            1.0
        };
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
        let taken =
            energy_with(self.suspect, 1.0) - energy_with(self.suspect, f64::from(self.kept));
        let balance =
            self.known_balance() + energy_with(self.all, 1.0) - taken - self.energy - self.drive;
        self.balance = if balance.is_finite() { balance.max(-self.band()) } else { 0.0 };
        self.is_exceeded |= self.kept < 1.0;
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
    terms: Vec<Terms<Lane>>,
    /// By island: the sums of the terms, of all bodies and of suspects.
    sums: Vec<[UnorderedSum; 8]>,
    /// What motors can give.
    drives: IslandSums<1>,
    /// By index of a body: whether it is among the [deep bodies](Account::deep_bodies).
    is_deep: Vec<bool>,
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

    /// Includes the island of a joint.
    pub fn note_joint(&mut self, pair: [u32; 2], drive: Drive, bodies: &SolverBodies) {
        if let Some(account) = self.accounts.get_mut(bodies.island_of(pair) as usize) {
            account.has_joints = true;
            account.has_motors |= drive == Drive::Motors;
            account.is_driven |= drive == Drive::Unbounded;
        }
    }

    /// Counts the contacts deeper than `deep`, if any may be, and their bodies by island, and marks driven
    /// islands.
    pub fn note_contacts(
        &mut self,
        block: &ContactBlock,
        input: &ContactInput,
        deep: Option<Real>,
        bodies: &SolverBodies,
    ) {
        for lane in 0..LANES {
            let pair = input.bodies.map(|side| side[lane]);
            let island = bodies.island_of(pair);
            let account = self.accounts.get_mut(island as usize);
            let is_due = |account: &&mut Account| account.has_joints || deep.is_some();
            let Some(account) = account.filter(is_due) else { continue };
            let is_deep = |deep: Real| {
                let mut points = block.points.iter();
                points.any(|it| it.mass.0[lane] > 0.0 && it.separation.0[lane] < -deep)
            };
            if deep.is_some_and(is_deep) {
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
                if account.suspects(self.is_deep[index]) {
                    // Islands that merge have the worse balance.
                    let added = f64::from(bodies.energy_errors[index].added);
                    account.balance = account.balance.max(added);
                }
                all.is_open = true;
                all.mass.0[lane] = mass;
                set_symmetric_lane(&mut all.inertia, lane, &inertia_of(&pose.inv_inertia()));
            }
            masses.push(all);
        }
    }

    /// Returns whether any account is open.
    pub fn is_active(&self) -> bool {
        self.is_active
    }

    /// Adds the most energy that motors between two bodies can give in the substep of the next entry.
    pub fn add_drive(&mut self, pair: [u32; 2], energy: Real, bodies: &SolverBodies) {
        self.drives.push(bodies.island_of(pair), [energy]);
    }

    /// Makes an entry. Returns whether any island must not keep all of its impulses.
    pub fn enter(
        &mut self,
        entry: Entry,
        bodies: &mut SolverBodies,
        pass: &SolverPass<'_>,
    ) -> bool {
        self.measure(bodies, pass);
        let speeds = [pass.joints.correction_max, pass.contacts.push_velocity_max].map(f64::from);
        for account in self.accounts.iter_mut().filter(|account| account.is_open()) {
            account.enter(entry, speeds);
        }
        self.accounts.iter().any(|account| account.kept < 1.0) && self.limit(bodies)
    }

    /// Ends the step: notes the balances in the bodies.
    pub fn close(&self, bodies: &mut SolverBodies) {
        let [_, members] = bodies.moving();
        for index in members {
            let account = self.accounts.get(bodies.islands[index] as usize);
            let account = account.filter(|account| self.is_active && account.is_open());
            bodies.energy_errors[index] = account.map_or(EnergyError::NONE, |account| {
                EnergyError { added: account.balance as Real, is_exceeded: account.is_exceeded }
            });
        }
    }

    /// Sums up the terms of the bodies of each island.
    fn measure(&mut self, bodies: &SolverBodies, pass: &SolverPass<'_>) {
        let Self { accounts, members, masses, terms, sums, drives, is_deep, .. } = self;
        let (states, before) = (&bodies.states[members.clone()], &bodies.before[members.clone()]);
        terms.clear();
        terms.resize(masses.len(), [Lane::ZERO; 4]);
        pass.simd.run(Measure { masses, states, before, terms });
        sums.clear();
        sums.resize(accounts.len(), Default::default());
        for visit in [UnorderedSum::include as fn(&mut _, _), UnorderedSum::add] {
            for (index, terms) in each(members.clone(), masses, terms) {
                let island = bodies.islands[index] as usize;
                let (Some(account), Some(sums)) = (accounts.get(island), sums.get_mut(island))
                else {
                    continue;
                };
                let count = if account.suspects(is_deep[index]) { sums.len() } else { terms.len() };
                let terms = terms.iter().chain(&terms).map(|term| f64::from(*term));
                sums[..count].iter_mut().zip(terms).for_each(|(sum, term)| visit(sum, term));
            }
        }
        for (account, sums) in accounts.iter_mut().zip(sums) {
            account.all = core::array::from_fn(|k| sums[k].value());
            account.suspect = core::array::from_fn(|k| sums[4 + k].value());
            (account.kept, account.drive) = (1.0, 0.0);
        }
        drives.for_each(|island, [drive]| {
            if let Some(account) = accounts.get_mut(island as usize) {
                account.drive = f64::from(drive);
            }
        });
        drives.clear();
    }

    /// Leaves the bodies the fraction of the effect of their impulses. Returns whether any is less than 1.
    fn limit(&self, bodies: &mut SolverBodies) -> bool {
        let mut any = false;
        for index in self.members.clone() {
            let kept = self.kept_by_body(index as u32, bodies);
            if kept < 1.0 {
                let (old_v, old_w) = bodies.before[index].velocity();
                let (v, w) = bodies.states[index].velocity();
                bodies.states[index]
                    .set_velocity(old_v + (v - old_v) * kept, old_w + (w - old_w) * kept);
                any = true;
            }
        }
        any
    }

    fn kept_by_body(&self, index: u32, bodies: &SolverBodies) -> Real {
        if index & READ_ONLY != 0 {
            return 1.0;
        }
        let account = self.accounts.get(bodies.islands[index as usize] as usize);
        let account = account.filter(|account| account.suspects(self.is_deep[index as usize]));
        account.map_or(1.0, |account| account.kept)
    }

    /// The fractions of impulses that constraints of these bodies keep, unless these keep all impulses.
    pub fn kept_by(&self, pairs: &[[u32; LANES]; 2], bodies: &SolverBodies) -> Option<Lane> {
        let mut factors = Lane::splat(1.0);
        for (lane, factor) in factors.0.iter_mut().enumerate() {
            let kept = pairs.map(|side| self.kept_by_body(side[lane], bodies));
            *factor = kept[0].min(kept[1]);
        }
        factors.0.iter().any(|&factor| factor < 1.0).then_some(factors)
    }
}

/// The indices and terms of bodies, without those that are far from any open account.
fn each<'a>(
    members: Range<usize>,
    masses: &'a [Masses],
    terms: &'a [Terms<Lane>],
) -> impl Iterator<Item = (usize, Terms<Real>)> + 'a {
    let end = members.end;
    let chunks = members.step_by(LANES).zip(masses.iter().zip(terms));
    chunks.filter(|(_, (masses, _))| masses.is_open).flat_map(move |(first, (_, terms))| {
        let indices = first..end.min(first + LANES);
        indices.map(move |index| (index, terms.map(|lanes| lanes.0[index - first])))
    })
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
    terms: &'a mut [Terms<Lane>],
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
            terms[3] = masses.mass;
        }
    }
}
