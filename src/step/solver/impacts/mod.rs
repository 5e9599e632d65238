//! Impacts: what happens in no time, before forces act.
//!
//! A contact with restitution `e` that is hit at the velocity `c < 0` parts at `-e c` (Newton). With several contacts
//! this says nothing of those that were at rest. Solved as forces are, all at once, the blow on a row of balls spreads
//! over the whole row; a real row sends off its last ball, because the blow travels.
//!
//! So we use the generalised reflections of Smith, Kaufman, Vouga, Tamstorf and Grinspun, "Reflections on
//! simultaneous impact" (SIGGRAPH 2012). At the start of a substep, in rounds:
//!
//! 1. `S` is the set of contacts that hit now: approach, and would overlap before the substep ends.
//! 2. Impulses on `S` alone part them: `Ċ_i ≥ -e_i c_i ⊥ λ_i ≥ 0` with the approach velocities `c_i` of this round.
//! 3. This makes others approach. Those are the next round's `S`.
//!
//! What is hit at the same moment is thrown back together, so a box that lands flat rises flat; what is hit by what was
//! hit follows. Rounds end when nothing approaches any more, or when [`VISITS`] are used up: the rest of the approach is
//! stopped by the passes that follow, without a bounce, as an approach that is slower than the threshold is.
//!
//! ## Energy
//! With all impulses `λ` of a round the kinetic energy changes by
//!
//! ```text
//! ΔT = ½ Σ λ_i (Ċ_i' + c_i)                     Ċ': after the round
//! ```
//!
//! whatever the couplings between the contacts are. A solution of 2 has `Ċ_i' = -e_i c_i` wherever `λ_i > 0`: every term
//! is negative, for any mixture of `e_i ≤ 1`. Sweeps leave errors, so we look: where the sum over an island is above zero, its
//! round goes only the share `s = a / (a + ΔT)` of its way, with `a = -Σ λ_i c_i`, which is where the energy is back at
//! what it was. Impacts never add energy.
//!
//! ## Joints
//! Joints transmit blows. Locked axes that are solved exactly take part: after each sweep over `S` the velocities are
//! projected on what they allow. Their impulses do no work, so that the sum above still holds over contacts alone.
//!
//! ## When
//! A blow falls at a time `τ = C / |c|` within the substep, or before it if a fast body was noticed too late. The
//! bodies are placed as if they had moved on at their new velocities since then: by `-τ Δv` (`accept_impact`). And the
//! velocity of a substep, which is that of its middle, is not that of the time `τ`. With the acceleration `A/h` the
//! velocities before and after at `τ` are `c + b` and `-e (c + b)`, in the middle `c` and
//!
//! ```text
//! -e (c + b) - b,      b = A (τ/h - ½)
//! ```
//!
//! so a ball that bounces with `e = 1` keeps its height to second order in `h`.
//!
//! A body that comes fast but does not arrive before the substep ends is put aside until the next: the passes that let
//! it come no nearer than to touch would take off its speed before it is there.
//!
//! ## Friction
//! Acts once at the end, under all normal impulses of the impact. What an impact adds to the velocities is added to the
//! velocities "before any impulse" of the substep too: it is no load that the next one could start with.

mod rows;

use super::bodies::SolverBodies;
use super::contacts::{Blocks, for_each_color};
use super::joints::SolverJoints;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{Kernel, Lane, Simd, Wide};
use crate::dim::contact::{ContactInput, NormalRows};
use crate::dim::math::Real;
use crate::dim::state::BodyState;
use crate::model::params::{ImpactPass, JointPass};
use core::ops::Range;
pub(super) use rows::ImpactBlock;

/// Visits of all contacts that hit, per substep.
const VISITS: usize = 64;
/// And per round.
const ROUND_VISITS: usize = 16;

/// The contacts with restitution.
#[derive(Default)]
pub(super) struct Impacts {
    /// Those of one colour stand together.
    blocks: Vec<ImpactBlock>,
    colors: Vec<Range<usize>>,
    memory: Memory,
}

/// What is known of bodies, by their index, or of islands.
#[derive(Default)]
struct Memory {
    /// How they moved when the last substep ended.
    last: Vec<BodyState>,
    /// How they moved when the round began.
    start: Vec<BodyState>,
    /// In place of a velocity: the sum of impulses in this round, and of impulse times time.
    delays: Vec<BodyState>,
    /// By island: the sums of `stopped` and of `surplus`, then the share that is gone.
    shares: Vec<[Real; 2]>,
}

/// What acts on bodies beside contacts.
pub(super) struct Around<'a> {
    pub joints: &'a mut SolverJoints,
    pub joint_pass: &'a JointPass,
    pub simd: Simd,
    pub tasks: Tasks,
}

impl Impacts {
    /// Finds the contacts with restitution among the blocks of each colour.
    pub fn load(&mut self, inputs: &[ContactInput], colors: &[Range<usize>]) {
        self.blocks.clear();
        self.colors.clear();
        for color in colors {
            let start = self.blocks.len();
            let members = color.clone().filter(|&at| inputs[at].restitution != Lane::ZERO);
            self.blocks.extend(members.map(|at| ImpactBlock::new(at, inputs[at].restitution)));
            if start < self.blocks.len() {
                self.colors.push(start..self.blocks.len());
            }
        }
    }

    /// Notes how the bodies move at the end of a substep, before forces act in the next.
    pub fn note_velocities(&mut self, velocities: &[BodyState]) {
        if !self.blocks.is_empty() {
            self.memory.last.clear();
            self.memory.last.extend_from_slice(velocities);
        }
    }

    /// Lets everything bounce that hits something in this substep.
    pub fn run(
        &mut self,
        contacts: Blocks<'_>,
        bodies: &mut SolverBodies,
        mut around: Around<'_>,
        pass: &ImpactPass,
    ) {
        if self.blocks.is_empty() {
            return;
        }
        self.pass(Stage::Begin, contacts, bodies, &around, pass);
        let mut visits = 0;
        while visits < VISITS && self.blocks.iter().any(|block| block.is_struck) {
            visits += self.solve_round(contacts, bodies, &mut around, pass);
            self.pass(Stage::Mark, contacts, bodies, &around, pass);
        }
        self.pass(Stage::PutAside, contacts, bodies, &around, pass);
        if visits > 0 {
            self.begin_round(bodies);
            self.pass(Stage::Rub, contacts, bodies, &around, pass);
            bodies.accept_impact(&self.memory.start, &self.memory.delays, |_| 1.0);
            around.joints.forget_places();
        }
    }

    /// Parts the contacts that hit. Returns the number of visits that it took.
    fn solve_round(
        &mut self,
        contacts: Blocks<'_>,
        bodies: &mut SolverBodies,
        around: &mut Around<'_>,
        pass: &ImpactPass,
    ) -> usize {
        self.begin_round(bodies);
        let mut visits = 0;
        loop {
            self.pass(Stage::Visit, contacts, bodies, around, pass);
            visits += 1;
            let moving = |block: &ImpactBlock| block.is_struck && block.is_moving;
            if visits == ROUND_VISITS || !self.blocks.iter().any(moving) {
                break;
            }
            around.joints.project(bodies, around.joint_pass, around.simd, around.tasks);
        }
        self.pass(Stage::End, contacts, bodies, around, pass);
        self.find_shares(contacts, bodies);
        let share = |island: u32| match self.memory.shares.get(island as usize) {
            Some(&[stopped, surplus]) if surplus > 0.0 => stopped / (stopped - surplus),
            _ => 1.0,
        };
        bodies.accept_impact(&self.memory.start, &self.memory.delays, share);
        visits
    }

    fn begin_round(&mut self, bodies: &SolverBodies) {
        let Memory { start, delays, .. } = &mut self.memory;
        start.clear();
        start.extend_from_slice(&bodies.states);
        delays.clear();
        delays.resize(bodies.states.len(), BodyState::default());
    }

    /// Sums up the energy of each island.
    fn find_shares(&mut self, contacts: Blocks<'_>, bodies: &SolverBodies) {
        let shares = &mut self.memory.shares;
        shares.clear();
        for block in self.blocks.iter().filter(|block| block.is_struck) {
            // SAFETY: no pass runs.
            let pairs = unsafe { contacts.get(block.at).0.bodies };
            for lane in 0..pairs[0].len() {
                let island = bodies.island_of([pairs[0][lane], pairs[1][lane]]) as usize;
                if block.stopped.0[lane] == 0.0 {
                    continue;
                }
                if shares.len() <= island {
                    shares.resize(island + 1, [0.0; 2]);
                }
                shares[island][0] += block.stopped.0[lane];
                shares[island][1] += block.surplus.0[lane];
            }
        }
    }

    fn pass(
        &mut self,
        stage: Stage,
        contacts: Blocks<'_>,
        bodies: &mut SolverBodies,
        around: &Around<'_>,
        pass: &ImpactPass,
    ) {
        let (_, states, _) = bodies.shared();
        let impacts = DisjointMut::new(&mut self.blocks);
        let delays = DisjointMut::new(&mut self.memory.delays);
        let last = &self.memory.last;
        for_each_color(&self.colors, around.tasks, |range| {
            around.simd.run(Run { stage, range, contacts, impacts, states, delays, last, pass });
        });
    }
}

/// What is done with each block.
#[derive(Copy, Clone, PartialEq, Eq)]
enum Stage {
    Begin,
    Mark,
    Visit,
    End,
    PutAside,
    Rub,
}

/// A stage, for some blocks of one colour.
struct Run<'a> {
    stage: Stage,
    range: Range<usize>,
    contacts: Blocks<'a>,
    impacts: DisjointMut<'a, ImpactBlock>,
    states: DisjointMut<'a, BodyState>,
    delays: DisjointMut<'a, BodyState>,
    last: &'a [BodyState],
    pass: &'a ImpactPass,
}

impl Kernel for Run<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        for index in self.range.clone() {
            // SAFETY: each block belongs to one task, the constraints of one colour share no body that is not
            // read-only, and one colour is done before the next begins.
            unsafe { self.run_block::<W>(index) };
        }
    }
}

impl Run<'_> {
    /// # Safety
    /// Nobody else may touch the block, or the states and delays of its bodies, meanwhile.
    #[inline(always)]
    unsafe fn run_block<W: Wide>(&self, index: usize) {
        let (states, pass) = (&self.states, self.pass);
        // SAFETY: the caller's promise.
        unsafe {
            let impact = self.impacts.get_mut(index);
            let (block, coulomb) = self.contacts.get(impact.at);
            match self.stage {
                Stage::Begin => impact.recall(block),
                Stage::Visit | Stage::End if !impact.is_struck => return,
                Stage::PutAside => return impact.put_aside(block),
                Stage::Rub if impact.was_struck => return impact.rub::<W>(block, coulomb, states),
                Stage::Rub => return,
                _ => {}
            }
            let mut rows = NormalRows::<W>::gather(states, block);
            match self.stage {
                Stage::Begin => {
                    impact.begin(&rows, block, self.last, pass);
                    impact.mark(&rows, block, pass);
                }
                Stage::Mark => impact.mark(&rows, block, pass),
                Stage::Visit => {
                    impact.visit(&mut rows);
                    rows.scatter(states);
                }
                Stage::End => impact.end(&rows, block, &self.delays),
                Stage::PutAside | Stage::Rub => {}
            }
        }
    }
}
