//! The correction of overlap must not become motion.
//!
//! The solve pass pushes overlapping bodies apart, and the relax pass removes that velocity after the bodies
//! have moved. One Gauss–Seidel iteration removes all of it for a few contacts, but not for thousands of
//! contacts of bodies that were created inside each other. Errors add up along chains of bodies, and the next
//! substep starts with the same impulses. A thousand balls at one point left with 300 m/s, though each
//! contact pushes with 4 m/s at most.
//!
//! ## The bound
//! Let `v` be the velocities before any impulse of a substep and `v'` those at its end. Contacts without
//! restitution satisfy `λ_i ≥ 0`, `λ_i Ċ_i' ≤ 0`, and friction opposes the sliding. The change of the kinetic
//! energy,
//!
//! ```text
//! ΔT = ½ Σ λ_i (Ċ_i + Ċ_i')
//! ```
//!
//! is therefore not positive in the exact solution without bias. That solution is the projection of `v` on
//! the admissible velocities in the metric of the kinetic energy. (Moreau, "Unilateral contact and dry
//! friction in finite freedom dynamics", 1988.) An energy gain of an island is an error. Bodies that gained
//! energy return the island's gain, each in proportion to its own:
//!
//! ```text
//! T_b' ← T_b + (1 − G/P) (T_b' − T_b)       G = Σ (T_b' − T_b),   P = the sum of the positive terms
//! ```
//!
//! The impulses of their contacts are scaled as their velocities are, so that the next substep does not start
//! with them. Bodies that contacts slow down, such as a pile around the overlapping bodies, keep their
//! velocities.
//!
//! ## Scope
//! The bound does not conserve momentum. It applies to islands with more deep contacts than bodies of such
//! contacts, which an impact does not cause. Islands that something drives are left out: joints, multibodies,
//! moving kinematic bodies, dominance and moving surfaces all do work.

use super::bodies::SolverBodies;
use super::island_sums::IslandSums;
use crate::base::wide::{LANES, Lane};
use crate::dim::contact::ContactBlock;
use crate::dim::math::{Real, ang_dot, inertia_of, mul_inertia};
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::model::contact::ContactInput;
use crate::model::params::ContactPass;

/// The fraction of the largest corrective velocity from which overlap counts as deep.
const DEEP_FRACTION: Real = 0.125;

/// The overlap (length) from which on its correction may throw bodies.
pub(super) fn deep_overlap(pass: &ContactPass) -> Real {
    let rate = pass.softness.bias_rate * pass.softness.mass_scale;
    pass.allowed_error + DEEP_FRACTION * pass.push_velocity_max / rate
}

/// The energies of one island.
#[derive(Copy, Clone, Debug, Default)]
struct IslandEnergy {
    /// The numbers of its deep contacts, and of the bodies that have some.
    deep_contacts: usize,
    deep_bodies: usize,
    /// Whether anything but contacts changes the energy.
    is_driven: bool,
    /// Energy gain of all its bodies in the substep.
    gain: Real,
    /// Energy gain of the bodies that gained.
    positive: Real,
}

impl IslandEnergy {
    /// Returns whether its deep contacts form loops, in which one relax iteration does not converge.
    fn is_recorded(&self) -> bool {
        self.deep_contacts > self.deep_bodies && !self.is_driven
    }

    /// The fraction of its gain that a body keeps, if it has to return any.
    fn kept(&self) -> Option<Real> {
        (self.gain > 0.0).then(|| 1.0 - (self.gain / self.positive).min(1.0))
    }
}

/// The islands in which the energy of overlap correction is recorded.
#[derive(Default)]
pub(super) struct Recovery {
    islands: Vec<IslandEnergy>,
    /// By index of a body: whether it is among the [deep bodies](IslandEnergy::deep_bodies).
    is_deep: Vec<bool>,
    /// By index of a body: the factor on its velocity in this substep.
    scales: Vec<Real>,
    /// Energy gain of bodies, and its positive part.
    gains: IslandSums<2>,
    is_active: bool,
}

impl Recovery {
    /// Starts a step in which no island is recorded.
    pub fn clear(&mut self) {
        self.is_active = false;
    }

    /// Starts a step in which some contact is deep.
    pub fn begin(&mut self, bodies: &SolverBodies) {
        self.islands.clear();
        self.islands.resize(bodies.island_bound(), IslandEnergy::default());
        self.is_deep.clear();
        self.is_deep.resize(bodies.states.len(), false);
        self.is_active = true;
    }

    /// Leaves an island out.
    pub fn leave_out(&mut self, island: u32) {
        if let Some(island) = self.islands.get_mut(island as usize) {
            island.is_driven = true;
        }
    }

    /// Counts the contacts deeper than `deep` and their bodies by island, and marks driven islands.
    pub fn note(
        &mut self,
        block: &ContactBlock,
        input: &ContactInput,
        deep: Real,
        bodies: &SolverBodies,
    ) {
        for lane in 0..LANES {
            let pair = input.bodies.map(|side| side[lane]);
            let island = bodies.island_of(pair);
            let Some(energy) = self.islands.get_mut(island as usize) else { continue };
            if block.points.iter().any(|it| it.mass.0[lane] > 0.0 && it.separation.0[lane] < -deep)
            {
                energy.deep_contacts += 1;
                for body in pair.into_iter().filter(|body| body & READ_ONLY == 0) {
                    let was_deep = core::mem::replace(&mut self.is_deep[body as usize], true);
                    energy.deep_bodies += usize::from(!was_deep);
                }
            }
            energy.is_driven |= is_driven(pair, lane, input, bodies);
        }
    }

    /// Removes the energy that contacts added to the bodies of recorded islands in a substep. Returns whether
    /// any did.
    pub fn limit(&mut self, bodies: &mut SolverBodies) -> bool {
        if !self.is_active {
            return false;
        }
        self.add_up_gains(bodies);
        self.scales.clear();
        self.scales.resize(bodies.states.len(), 1.0);
        let mut any = false;
        let [_, members] = bodies.moving();
        for index in members {
            let island = self.recorded(bodies.islands[index]);
            let Some(kept) = island.and_then(|it| it.kept()) else { continue };
            let (before, after) = energies(bodies, index);
            if after > before {
                let scale = ((before + kept * (after - before)) / after).sqrt();
                let (v, w) = bodies.states[index].velocity();
                bodies.states[index].set_velocity(v * scale, w * scale);
                self.scales[index] = scale;
                any = true;
            }
        }
        any
    }

    fn add_up_gains(&mut self, bodies: &SolverBodies) {
        for island in &mut self.islands {
            (island.gain, island.positive) = (0.0, 0.0);
        }
        self.gains.clear();
        let [_, members] = bodies.moving();
        for index in members {
            let island = bodies.islands[index];
            if self.recorded(island).is_some() {
                let (before, after) = energies(bodies, index);
                self.gains.push(island, [after - before, (after - before).max(0.0)]);
            }
        }
        self.gains.for_each(|island, [gain, positive]| {
            let island = &mut self.islands[island as usize];
            island.gain += gain;
            island.positive += positive;
        });
    }

    /// The fractions of its impulses that a block of contacts keeps, if not all of them: those of the body
    /// that keeps less.
    pub fn kept_by(&self, block: &ContactBlock) -> Option<Lane> {
        let mut factors = Lane::splat(1.0);
        for (lane, factor) in factors.0.iter_mut().enumerate() {
            for side in block.bodies {
                // Bodies that contacts must not move have not gained.
                *factor = factor.min(self.scales[(side[lane] & !READ_ONLY) as usize]);
            }
        }
        factors.0.iter().any(|&factor| factor < 1.0).then_some(factors)
    }

    fn recorded(&self, island: u32) -> Option<&IslandEnergy> {
        let energy = self.islands.get(island as usize)?;
        energy.is_recorded().then_some(energy)
    }
}

/// Returns whether something other than the energy of its bodies drives a contact.
fn is_driven(pair: [u32; 2], lane: usize, input: &ContactInput, bodies: &SolverBodies) -> bool {
    let is_dominated = input.mass_factors.iter().any(|factors| factors.0[lane] != 1.0);
    let is_conveyor = input.tangent_velocity.lane(lane).length_squared() > 0.0;
    let moves = |index: u32| {
        let (v, w) = bodies.states[(index & !READ_ONLY) as usize].velocity();
        v.length_squared() + ang_dot(w, w) > 0.0
    };
    let is_carried = pair.into_iter().any(|index| index & READ_ONLY != 0 && moves(index));
    is_dominated || is_conveyor || is_carried
}

/// The kinetic energies of a body before the impulses of a substep and now.
fn energies(bodies: &SolverBodies, index: usize) -> (Real, Real) {
    let pose = &bodies.poses[index];
    (kinetic_energy(pose, &bodies.before[index]), kinetic_energy(pose, &bodies.states[index]))
}

fn kinetic_energy(pose: &BodyPose, state: &BodyState) -> Real {
    let (v, w) = state.velocity();
    let inv_mass = pose.inv_mass().max_element();
    let mass = if inv_mass > 0.0 { 1.0 / inv_mass } else { 0.0 };
    let momentum = mul_inertia(&inertia_of(&pose.inv_inertia()), w);
    0.5 * (mass * v.length_squared() + ang_dot(w, momentum))
}
