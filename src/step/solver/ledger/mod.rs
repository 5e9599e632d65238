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
//!   gains up, and is at most [`ERROR_MAX`](account) of the energy. Energy that is lost beyond that does not
//!   return.
//!
//! ## Scope
//! Islands in which every body has a joint, and islands with more deep contacts between bodies than bodies of
//! such contacts, for which one relax iteration does not converge. (A thousand balls at one point left with
//! 300 m/s, though each contact pushes with 4 m/s at most.) Other contacts converge, their islands may be
//! large, and a fraction of their impulses would not carry a load: boxes sank into the plank of a seesaw.
//!
//! Motors do work. Their islands have no bound at the start, and the others include the most energy that the
//! motors can give in a substep (`joints/motors_and_limits.rs`). That is no balance, but an error cannot
//! multiply. Their exact work `λ J (v + Δv/2)` is useless as a bound: the impulses of rigid motors cancel,
//! and their rounding exceeds `T`.
//!
//! The energy of an island with a kinematic body that translates is measured in the frame of that body
//! ([`Frame`]).
//!
//! Islands that anything else drives are left out: soft joints, elastic transmissions, multibodies, bodies
//! that rotate, bodies with different frames, dominance and moving surfaces. Nets that are too large for a
//! direct solution are left out, too. They converge over many substeps, and fractions of their impulses would
//! not.
//!
//! Alternative: scaling the velocities of the bodies that gained. It does not conserve momentum.

mod account;
mod measure;

use super::bodies::SolverBodies;
use super::context::SolverPass;
use super::island_sums::{IslandSums, UnorderedSum};
use crate::base::wide::{LANES, Lane};
use crate::dim::contact::ContactBlock;
use crate::dim::math::{Real, ang_dot, inertia_of};
use crate::dim::state::READ_ONLY;
use crate::dim::wide::set_symmetric_lane;
use crate::model::body::EnergyError;
use crate::model::contact::ContactInput;
use crate::model::params::ContactPass;
use account::{Account, Terms};
pub(super) use account::{Entry, Frame};
use core::ops::Range;
use measure::{Masses, Measure};

/// The fraction of the largest corrective velocity from which overlap counts as deep.
const DEEP_FRACTION: Real = 0.125;

/// The overlap (length) from which on its correction may throw bodies.
pub(super) fn deep_overlap(pass: &ContactPass) -> Real {
    let rate = pass.softness.bias_rate * pass.softness.mass_scale;
    pass.allowed_error + DEEP_FRACTION * pass.push_velocity_max / rate
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
    /// By index of a body: whether it has a joint.
    is_held: Vec<bool>,
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
        self.accounts.resize(bodies.island_bound(), Account::empty());
        for list in [&mut self.is_deep, &mut self.is_held] {
            list.clear();
            list.resize(bodies.states.len(), false);
        }
        self.is_active = true;
    }

    /// Leaves an island out.
    pub fn leave_out(&mut self, island: u32) {
        if let Some(account) = self.accounts.get_mut(island as usize) {
            account.include_frame(Frame::None);
        }
    }

    /// Includes the island of a joint. Apart from its motors, the joint does no work in this frame.
    pub fn note_joint(
        &mut self,
        pair: [u32; 2],
        frame: Frame,
        has_motors: bool,
        bodies: &SolverBodies,
    ) {
        if let Some(account) = self.accounts.get_mut(bodies.island_of(pair) as usize) {
            account.has_joints = true;
            account.has_motors |= has_motors;
            account.include_frame(frame);
            account.include_frame(frame_of(pair, bodies));
            for body in pair.into_iter().filter(|body| body & READ_ONLY == 0) {
                self.is_held[body as usize] = true;
            }
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
                let is_between = pair.iter().all(|body| body & READ_ONLY == 0);
                account.deep_contacts += usize::from(is_between);
                for body in pair.into_iter().filter(|body| body & READ_ONLY == 0) {
                    let was_deep = core::mem::replace(&mut self.is_deep[body as usize], true);
                    account.deep_bodies += usize::from(!was_deep);
                }
            }
            account.include_frame(frame_of(pair, bodies));
            if is_driven(pair, lane, input) {
                account.include_frame(Frame::None);
            }
        }
    }

    /// Finds the islands with bodies that no joint holds, and leaves those out in which the world holds an
    /// axis of a body, while their frame moves.
    fn inspect_bodies(&mut self, bodies: &SolverBodies) {
        let [_, members] = bodies.moving();
        for index in members {
            let Some(account) = self.accounts.get_mut(bodies.islands[index] as usize) else {
                continue;
            };
            let inv_mass = bodies.poses[index].inv_mass();
            account.has_free_bodies |= !self.is_held[index] && inv_mass.max_element() > 0.0;
            let is_locked = inv_mass.min_element() == 0.0;
            if matches!(account.frame, Frame::Body(carrier) if is_locked && carrier != index as u32)
            {
                account.frame = Frame::None;
            }
        }
    }

    /// Opens the accounts: reads the masses of their bodies.
    pub fn open(&mut self, bodies: &SolverBodies) {
        self.inspect_bodies(bodies);
        let Self { accounts, members, masses, .. } = self;
        self.is_active &= accounts.iter().any(Account::is_open);
        if !self.is_active {
            return;
        }
        [_, *members] = bodies.moving();
        masses.clear();
        for first in members.clone().step_by(LANES) {
            let mut all = Masses::NONE;
            for (lane, index) in (first..members.end.min(first + LANES)).enumerate() {
                let account = accounts.get_mut(bodies.islands[index] as usize);
                let Some(account) = account.filter(|account| account.is_open()) else { continue };
                let pose = &bodies.poses[index];
                let inv_mass = pose.inv_mass().max_element();
                debug_assert!(inv_mass >= 0.0);
                let mass = if inv_mass > 0.0 { 1.0 / inv_mass } else { 0.0 };
                if account.suspects(self.is_deep[index]) {
                    // Islands that merge have the worse balance.
                    let added = f64::from(bodies.energy_errors[index].added);
                    account.balance = account.balance.max(added);
                }
                if let Frame::Body(carrier) = account.frame {
                    all.frame.set_lane(lane, bodies.states[carrier as usize].velocity().0);
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

    /// Returns whether an entry has bounds that include what motors can give. The first one of a substep has
    /// no bound where there are motors.
    pub fn needs_drives(&self, entry: Entry) -> bool {
        let mut accounts = self.accounts.iter();
        entry != Entry::Start && accounts.any(|account| account.has_motors && account.is_open())
    }

    /// Adds the most energy that motors between two bodies can give in the substep of the next entry.
    pub fn add_drive(&mut self, pair: [u32; 2], energy: Real, bodies: &SolverBodies) {
        debug_assert!(energy >= 0.0 || energy.is_nan(), "a capacity");
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
        debug_assert_eq!(
            masses.len(),
            members.len().div_ceil(LANES),
            "the group is that of `open`"
        );
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
fn is_driven(pair: [u32; 2], lane: usize, input: &ContactInput) -> bool {
    let mut sides = pair.into_iter().zip(&input.mass_factors);
    let is_dominated = sides.any(|(body, factors)| body & READ_ONLY == 0 && factors.0[lane] != 1.0);
    let is_conveyor = input.tangent_velocity.lane(lane).length_squared() > 0.0;
    is_dominated || is_conveyor
}

/// The frame in which a constraint does no work.
fn frame_of(pair: [u32; 2], bodies: &SolverBodies) -> Frame {
    let Some(index) = pair.into_iter().find(|index| index & READ_ONLY != 0) else {
        return Frame::Any;
    };
    let index = index & !READ_ONLY;
    let (v, w) = bodies.states[index as usize].velocity();
    match (v.length_squared() > 0.0, ang_dot(w, w) > 0.0) {
        (_, true) => Frame::None,
        (true, _) => Frame::Body(index),
        _ => Frame::Rest,
    }
}
