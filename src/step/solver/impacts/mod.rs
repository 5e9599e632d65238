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
//! hit follows. Rounds end when nothing approaches any more, or when the island's visits are used up (`IterationBudget`): the
//! rest of the approach is stopped by the passes that follow, without a bounce, as an approach that is slower than the threshold is.
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
//! what it was. (Where `a` is below zero the round adds energy from the beginning, and goes no way.) Impacts never add energy.
//!
//! ## Joints
//! Joints transmit blows. Locked axes that are solved exactly take part: after each sweep over `S` the velocities are
//! projected on what they allow. What a blow changes they hold against, so of their impulses `μ` the work is `μ Jv`, with the
//! velocities before the blow. That is none where the joint held these, and forces alone have acted since. But in a substep that
//! turns a body by a radian the joint's axes turn away from the velocities that it left. Then the work is anything, and
//! it counts in the sum above, and in `-a`: without it two cubes on a hinge that fell into a heap at 250 rad/s had 10¹⁶ times
//! their velocity after as many rounds as there may be.
//!
//! What a round's impulses are, of contacts and of joints, is known when its share is: `s λ` and `s μ` are what bodies got, what
//! friction acts under, and what is told of contacts and joints and breaks these. An island whose round goes no way is where it was,
//! and would go no way again: its impact ends.
//!
//! All that holds for one mass matrix `M`. The changes that joints allow are the nearest ones in its metric, that of the kinetic
//! energy (Moreau, "Unilateral contact and dry friction in finite freedom dynamics", 1988), and in this one they still part what
//! hit. Contacts know the inertias with which the step began. Had joints those of the moment, then the contact of a thin board
//! that has turned by a radian would approach as before or faster, however hard it is pushed: rounds added up to a
//! quarter of the energy, and no account knew. So in impacts joints take the inertias that contacts have.
//!
//! ## What bears loads
//! A substep starts with the impulses of the last one, and they need not fit any more: what stopped a blow then would be
//! a kick now. So impacts see the velocities before any impulse, in which forces have acted and nothing holds
//! against them. A contact that bears a load would then approach. To its velocity we add what these impulses take of
//! that: `o_i`, from 0 to all that the forces did, a constant of the substep. With it, what lies or is pressed is at
//! rest. The energy added is then less than the sum above, by `Σ λ_i o_i`. Joints are asked about changes alone: what a
//! blow changes must be what they allow.
//!
//! ## When
//! A blow falls at a time `τ = C / |c|` within the substep, or before it if a fast body was noticed too late. The
//! bodies are placed as if they had moved on at their new velocities since then: by `-τ Δv` (`accept_impact`). That must not
//! tear joints, which would turn gaps into speed: bodies that joints hold exactly have one `τ`, and those
//! of swept joints stay (`SolverJoints::share_delays`).
//!
//! The velocity of a substep, which is that of its middle, is not that of the time `τ`. With the acceleration `A/h` the
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

mod points;
mod rows;
mod active;
mod touched;

use super::bodies::SolverBodies;
use super::contacts::{Blocks, for_each_color};
use super::island_sums::IslandSums;
use super::joints::{Changes, SolverJoints};
use super::multibodies::SolverMultibodies;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{Kernel, LANES, Lane, Simd, Wide};
use crate::dim::contact::ContactBlock;
use crate::dim::math::Real;
use crate::dim::state::{BodyState, READ_ONLY};
use crate::model::body::RigidBodySet;
use crate::model::contact::{ContactInput, ContactLanes, NarrowPhase};
use crate::model::params::{ImpactPass, JointPass};
#[cfg(test)]
pub(super) use active::ActiveBlock;
use active::{Active, Phase, Round};
pub(super) use active::{CONVERGENCE_TOLERANCE, SWEEPS};
use core::ops::Range;
pub(super) use points::NormalRows;
pub(super) use rows::{
    APPROACH_CHANGE_MIN, COORDINATE_MODERATE_MAX, CURVATURE_ANGLE_MAX, ImpactBlock, ImpactMark,
};
use touched::Touched;

/// Visits of all contacts that hit, per substep, in an island with a contact of restitution 1.
const ITERATIONS_MAX: usize = 128;
/// Islands of so few contacts get as many whatever their restitution is.
const SMALL_ISLAND: usize = 32;
/// And per round.
const ROUND_ITERATIONS: usize = 16;
/// Blocks that are worth handing over to another thread together. A visit of few is over before another thread has noticed.
const BLOCKS_PER_TASK: usize = 32;

/// Of so many blocks about one has been struck.
const FRICTION_INTERVAL: usize = 4;

/// The contacts with restitution.
#[derive(Default)]
pub(super) struct Impacts {
    /// Those of one colour stand together.
    blocks: Vec<ImpactBlock>,
    /// Of each block.
    marks: Vec<ImpactMark>,
    colors: Vec<Range<usize>>,
    /// What a round is about, often little of all that could be hit.
    active: Active,
    touched: Touched,
    memory: Memory,
}

/// What is known of islands.
#[derive(Default)]
struct Memory {
    energy_budgets: Vec<EnergyBudget>,
    /// Nothing until something hits in this step.
    iteration_budgets: Vec<IterationBudget>,
    /// Of those that are struck: what the contacts and joints add to [`EnergyBudget::dissipated`] and [`EnergyBudget::energy_gain`] in this round.
    sums: IslandSums<2>,
}

/// How many visits an island is worth: how many of its contacts bounce, and the largest restitution among them.
#[derive(Copy, Clone, Default)]
struct IterationBudget {
    contacts: usize,
    restitution: Real,
}

impl IterationBudget {
    fn iterations(&self) -> usize {
        let smallness = SMALL_ISLAND as Real / self.contacts as Real;
        let worth = self.restitution.max(smallness).min(1.0);
        (ITERATIONS_MAX as Real * worth).ceil() as usize
    }
}

/// How far an island is. Each goes on by itself: what the others do must not change a bit of it.
#[derive(Copy, Clone, Default)]
struct EnergyBudget {
    /// Visits that are left in this substep.
    iterations: usize,
    is_active: bool,
    is_moving: bool,
    /// Sums over the contacts, see [`active::ActiveBlock`].
    dissipated: Real,
    energy_gain: Real,
}

impl EnergyBudget {
    /// How much of a round an island goes: no further than where its energy is what it was.
    fn share(&self) -> Real {
        let share = self.dissipated / (self.dissipated - self.energy_gain);
        match self.energy_gain > 0.0 {
            true if self.dissipated < 0.0 => share.max(0.0),
            true => 0.0,
            false => 1.0,
        }
    }
}

/// What acts on bodies beside contacts.
pub(super) struct ImpactContext<'a> {
    pub joints: &'a mut SolverJoints,
    pub joint_pass: &'a JointPass,
    /// The contacts of links, which take part, and where they know from where they are.
    pub links: (&'a mut SolverMultibodies, (&'a NarrowPhase, &'a RigidBodySet)),
    pub simd: Simd,
    pub tasks: Tasks<'a>,
}

impl Impacts {
    /// Finds the contacts with restitution among the blocks of each colour.
    pub fn load(&mut self, lanes: &ContactLanes, colors: &[Range<usize>], bodies: &SolverBodies) {
        self.blocks.clear();
        self.colors.clear();
        self.memory.iteration_budgets.clear();
        for color in colors {
            let start = self.blocks.len();
            for at in color.clone().filter(|&at| lanes.blocks[at].input.restitution != Lane::ZERO) {
                let ContactInput { bodies: [first, second], restitution, .. } =
                    &lanes.blocks[at].input;
                let islands = core::array::from_fn(|k| bodies.island_of([first[k], second[k]]));
                self.blocks.push(ImpactBlock::new(at, *restitution, islands));
            }
            if start < self.blocks.len() {
                self.colors.push(start..self.blocks.len());
            }
        }
        self.marks.clear();
        self.marks.resize(self.blocks.len(), ImpactMark::default());
    }

    /// Returns whether there is no contact with restitution.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// Lets everything bounce that hits something in this substep.
    pub fn run(
        &mut self,
        contacts: Blocks<'_>,
        bodies: &mut SolverBodies,
        mut context: ImpactContext<'_>,
        pass: &ImpactPass,
    ) {
        if self.is_empty() && !context.links.0.bounce() {
            return;
        }
        bodies.swap_before();
        let (links, place) = &mut context.links;
        links.begin_impact(bodies, pass);
        links.mark_active(*place, bodies, |_| true, pass);
        self.look(Stage::Begin, contacts, bodies, &context, pass);
        let hits = self.marks.iter().any(|mark| mark.active != 0);
        let hits = hits || context.links.0.active().next().is_some();
        if hits {
            self.open_energy_budgets(bodies, context.links.0);
            let held = self.begin(bodies, &context);
            while self.find_active(contacts, context.links.0) {
                self.solve_round(held, bodies, &mut context, pass);
                let (links, place) = &mut context.links;
                let energy_budgets = &self.memory.energy_budgets;
                let has_iterations = |island: u32| energy_budgets[island as usize].iterations > 0;
                links.mark_active(*place, bodies, has_iterations, pass);
                self.look(Stage::Mark, contacts, bodies, &context, pass);
            }
        }
        context.links.0.defer();
        self.look(Stage::Defer, contacts, bodies, &context, pass);
        if hits {
            self.begin_round(bodies, context.links.0);
            context.links.0.solve_active_friction(&mut bodies.states);
            self.look(Stage::Friction, contacts, bodies, &context, pass);
            self.accept(bodies, &mut context, |_| 1.0, pass);
            context.joints.forget_places();
        }
        context.links.0.end_impact();
        bodies.swap_before();
    }

    /// Takes back what the last substep has put aside.
    pub fn restore(&mut self, contacts: &mut [ContactBlock]) {
        for (impact, mark) in self.blocks.iter().zip(&mut self.marks) {
            if mark.is_aside() {
                impact.restore(mark, &mut contacts[impact.at]);
            }
        }
    }

    /// Opens the accounts of all islands. What is left of a blow when the visits are used up parts without a bounce: an error of the
    /// share `e` of its speed. So a large island gets as many as its largest `e` is worth. In a small one they cost nothing.
    fn open_energy_budgets(&mut self, bodies: &SolverBodies, links: &SolverMultibodies) {
        let Self { blocks, active, memory, .. } = self;
        let Memory { energy_budgets, iteration_budgets, .. } = memory;
        if iteration_budgets.is_empty() {
            iteration_budgets.resize(
                bodies.island_bound().max(links.island_bound()),
                IterationBudget::default(),
            );
            // Whose lanes stand in a block with others' must not count: who these are depends on all of the world.
            let mut count = |island: u32, restitution: Real| {
                if let Some(grant) =
                    iteration_budgets.get_mut(island as usize).filter(|_| restitution != 0.0)
                {
                    grant.contacts += 1;
                    grant.restitution = grant.restitution.max(restitution);
                }
            };
            for block in blocks {
                let lanes = block.islands.iter().zip(&block.restitution.0);
                lanes.for_each(|(&island, &restitution)| count(island, restitution));
            }
            links.restitutions().for_each(|(island, restitution)| count(island, restitution));
        }
        energy_budgets.clear();
        let energy_budget = |grant: &IterationBudget| EnergyBudget {
            iterations: grant.iterations(),
            ..EnergyBudget::default()
        };
        energy_budgets.extend(iteration_budgets.iter().map(energy_budget));
        active.clear();
    }

    /// Begins an impact: lists the bodies that joints hold exactly, which it may change wherever it falls.
    /// Returns their number.
    fn begin(&mut self, bodies: &SolverBodies, context: &ImpactContext<'_>) -> usize {
        self.touched.begin(bodies.states.len());
        self.touched.add(context.joints.held());
        let of_joints = self.touched.bodies.len();
        // What a multibody that is hit pushes can be anything.
        if context.links.0.bounce() {
            self.touched.add_all(bodies.moving());
        }
        self.touched.keep();
        of_joints
    }

    /// Finds the contacts that hit, in islands that have visits left. Returns whether there is any.
    fn find_active(&mut self, contacts: Blocks<'_>, links: &mut SolverMultibodies) -> bool {
        let Self { blocks, marks, colors, active, touched, memory } = self;
        let energy_budgets = &mut memory.energy_budgets;
        for island in active.islands.drain(..) {
            let energy_budget = &mut energy_budgets[island as usize];
            (energy_budget.is_active, energy_budget.is_moving) = (false, false);
            (energy_budget.dissipated, energy_budget.energy_gain) = (0.0, 0.0);
        }
        memory.sums.clear();
        active.clear();
        touched.begin_round();
        for color in &*colors {
            active.add_color(color.clone(), (blocks, marks), contacts, energy_budgets);
        }
        active.blocks.iter().for_each(|block| touched.add(block.bodies()));
        for contact in links.active() {
            let island = contact.strike.island;
            active.strike(island, &mut energy_budgets[island as usize]);
        }
        !active.islands.is_empty()
    }

    /// Parts the contacts that hit.
    fn solve_round(
        &mut self,
        held: usize,
        bodies: &mut SolverBodies,
        context: &mut ImpactContext<'_>,
        pass: &ImpactPass,
    ) {
        self.begin_round(bodies, context.links.0);
        context.joints.forget_places();
        context.joints.begin_impact_impulses();
        for _ in 0..ROUND_ITERATIONS {
            context.links.0.iterate_active(&mut bodies.states);
            self.iterate(Phase::Iterate, bodies, context);
            if !self.find_moving(context.links.0) {
                break;
            }
            let Memory { energy_budgets, sums, .. } = &mut self.memory;
            let islands = &bodies.islands;
            let energy_budget = |body: u32| energy_budgets.get(islands[body as usize] as usize);
            // Bodies without an island move as they did.
            let is_moving =
                |body: u32| energy_budget(body).is_none_or(|energy_budget| energy_budget.is_moving);
            let add_work = |body: u32, work: Real| sums.push(islands[body as usize], [work; 2]);
            let changes = Changes {
                held: &self.touched.bodies[..held],
                start: &self.touched.start,
                states: &mut bodies.states,
                poses: &bodies.poses,
            };
            let ImpactContext { joints, joint_pass, simd, tasks, .. } = context;
            joints.project(changes, is_moving, add_work, joint_pass, (*simd, *tasks));
        }
        context.links.0.end_round(&mut bodies.states, &mut self.touched.delays);
        self.iterate(Phase::End, bodies, context);
        let sums = &mut self.memory.sums;
        for block in &self.active.blocks {
            for lane in block.lanes() {
                sums.push(
                    block.islands[lane],
                    [block.dissipated.0[lane], block.energy_gain.0[lane]],
                );
            }
        }
        for contact in context.links.0.active() {
            sums.push(
                contact.strike.island,
                [contact.strike.dissipated, contact.strike.energy_gain],
            );
        }
        context.joints.share_delays(&mut self.touched.delays);
        self.commit_round(bodies, context, pass);
    }

    /// Lets each island go the share of the round that its energy allows.
    fn commit_round(
        &mut self,
        bodies: &mut SolverBodies,
        context: &mut ImpactContext<'_>,
        pass: &ImpactPass,
    ) {
        let Memory { energy_budgets, sums, .. } = &mut self.memory;
        sums.for_each(|island, [dissipated, energy_gain]| {
            let energy_budget = &mut energy_budgets[island as usize];
            energy_budget.dissipated += dissipated;
            energy_budget.energy_gain += energy_gain;
        });
        for &island in &self.active.islands {
            let energy_budget = &mut energy_budgets[island as usize];
            if energy_budget.share() == 0.0 {
                energy_budget.iterations = 0;
            }
        }
        let energy_budgets = &self.memory.energy_budgets;
        let share =
            |island: u32| energy_budgets.get(island as usize).map_or(1.0, EnergyBudget::share);
        self.active.blocks.iter().for_each(|block| block.commit(&mut self.blocks, share));
        let islands = &bodies.islands;
        context.joints.commit_impact_impulses(|body| share(islands[body as usize]));
        context.links.0.commit_round(share);
        self.accept(bodies, context, share, pass);
    }

    /// Bodies and multibodies take over what the round did, or the share of it for their island.
    fn accept(
        &self,
        bodies: &mut SolverBodies,
        context: &mut ImpactContext<'_>,
        share: impl Fn(u32) -> Real + Copy,
        pass: &ImpactPass,
    ) {
        let Touched { bodies: touched, start, delays, .. } = &self.touched;
        bodies.accept_impact(touched, start, delays, share);
        context.links.0.accept_impact(pass.substep, share);
    }

    /// Finds the islands where the last visit had something to change, and lets the others be for the rest of
    /// the round. Returns whether there is any.
    fn find_moving(&mut self, links: &mut SolverMultibodies) -> bool {
        let Self { active, memory, .. } = self;
        let energy_budgets = &mut memory.energy_budgets;
        for &island in &active.islands {
            let energy_budget = &mut energy_budgets[island as usize];
            energy_budget.iterations =
                energy_budget.iterations.saturating_sub(usize::from(energy_budget.is_active));
            energy_budget.is_moving = false;
        }
        for block in &active.blocks {
            lanes(block.moving)
                .for_each(|k| energy_budgets[block.islands[k] as usize].is_moving = true);
        }
        for contact in links.active().filter(|contact| contact.strike.moving) {
            energy_budgets[contact.strike.island as usize].is_moving = true;
        }
        let mut any = false;
        for block in &mut active.blocks {
            for lane in block.lanes() {
                let energy_budget = &mut energy_budgets[block.islands[lane] as usize];
                if energy_budget.is_moving {
                    any = true;
                } else {
                    energy_budget.is_active = false;
                    block.deactivate(lane);
                }
            }
        }
        for contact in links.active() {
            let energy_budget = &mut energy_budgets[contact.strike.island as usize];
            if energy_budget.is_moving {
                any = true;
            } else {
                energy_budget.is_active = false;
                contact.deactivate();
            }
        }
        any
    }

    fn begin_round(&mut self, bodies: &SolverBodies, links: &mut SolverMultibodies) {
        links.begin_round();
        self.touched.note_start(&bodies.states);
    }

    /// Takes a look at all blocks.
    fn look(
        &mut self,
        stage: Stage,
        contacts: Blocks<'_>,
        bodies: &mut SolverBodies,
        context: &ImpactContext<'_>,
        pass: &ImpactPass,
    ) {
        let known = [&bodies.last[..], &bodies.before];
        let states = DisjointMut::new(&mut bodies.states);
        let impacts = DisjointMut::new(&mut self.blocks);
        let marks = DisjointMut::new(&mut self.marks);
        let (simd, touched) = (context.simd, &self.touched);
        let all = 0..impacts.len();
        let (colors, grain) = match stage {
            Stage::Friction => (&self.colors[..], BLOCKS_PER_TASK * FRICTION_INTERVAL),
            // They change no body: all blocks may be looked at at once.
            _ => (core::slice::from_ref(&all), BLOCKS_PER_TASK),
        };
        for_each_color(colors, (context.tasks, grain), |range| {
            simd.run(Look { stage, range, contacts, impacts, marks, states, known, touched, pass });
        });
    }

    /// Visits the blocks of the round.
    fn iterate(&mut self, phase: Phase, bodies: &mut SolverBodies, context: &ImpactContext<'_>) {
        let (_, states) = bodies.shared();
        let Self { active: Active { blocks, colors, .. }, touched, .. } = self;
        let (blocks, delays) = (DisjointMut::new(blocks), DisjointMut::new(&mut touched.delays));
        let simd = context.simd;
        for_each_color(colors, (context.tasks, BLOCKS_PER_TASK), |range| {
            simd.run(Round { phase, range, blocks, states, delays });
        });
    }
}

/// The lanes whose bits are set.
pub(super) fn lanes(bits: u32) -> impl Iterator<Item = usize> {
    (0..LANES).filter(move |lane| bits >> lane & 1 == 1)
}

/// What is done with each block.
#[derive(Copy, Clone, PartialEq, Eq)]
enum Stage {
    Begin,
    Mark,
    Defer,
    Friction,
}

/// A stage, for some blocks.
struct Look<'a> {
    stage: Stage,
    range: Range<usize>,
    contacts: Blocks<'a>,
    impacts: DisjointMut<'a, ImpactBlock>,
    marks: DisjointMut<'a, ImpactMark>,
    states: DisjointMut<'a, BodyState>,
    /// How the bodies moved when the last substep ended, and with its impulses in this one.
    known: [&'a [BodyState]; 2],
    touched: &'a Touched,
    pass: &'a ImpactPass,
}

impl Kernel for Look<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        for index in self.range.clone() {
            // SAFETY: each block belongs to one task. The stage that changes bodies runs colour by colour, and the
            // constraints of one colour share no body that is not read-only; the others change their block alone.
            unsafe { self.look_at::<W>(index) };
        }
    }
}

impl Look<'_> {
    fn is_changed(&self, block: &ContactBlock) -> bool {
        let mut movable = block.bodies.iter().flatten().filter(|&body| body & READ_ONLY == 0);
        movable.any(|&body| self.touched.is_changed(body))
    }

    /// # Safety
    /// Nobody else may touch the block, or write the states of its bodies, meanwhile.
    #[inline(always)]
    unsafe fn look_at<W: Wide>(&self, index: usize) {
        let (states, pass) = (&self.states, self.pass);
        // SAFETY: the caller's promise.
        unsafe {
            let mark = self.marks.get_mut(index);
            let is_of_interest = match self.stage {
                Stage::Begin | Stage::Mark => true,
                Stage::Defer => mark.waits(),
                Stage::Friction => mark.was_active,
            };
            if !is_of_interest {
                return;
            }
            let impact = self.impacts.get_mut(index);
            let (block, coulomb) = self.contacts.get(impact.at);
            match self.stage {
                Stage::Begin => {
                    if mark.is_aside() {
                        impact.restore(mark, block);
                    }
                    *mark = ImpactMark::default();
                    let rows = NormalRows::<W>::gather(states, block);
                    impact.begin(&rows, block, self.known, pass);
                    impact.mark(mark, &rows, block, pass);
                }
                // What nobody has changed is as it was when it was marked last.
                Stage::Mark if !self.is_changed(block) => {}
                Stage::Mark => {
                    let rows = NormalRows::<W>::gather(states, block);
                    impact.mark(mark, &rows, block, pass);
                }
                Stage::Defer => impact.defer(mark, block),
                Stage::Friction => impact.solve_friction::<W>(block, coulomb, states),
            }
        }
    }
}
