//! Impacts: restitution, before forces act.
//!
//! A contact with restitution `e` that is hit at the velocity `c < 0` parts at `-e c` (Newton). For several
//! contacts, the law is undefined for those that were at rest. A simultaneous solution, as for forces, would
//! spread an impact on a row of balls over the whole row. A real row sends off its last ball, because the
//! impact travels.
//!
//! The method is that of the generalised reflections of Smith, Kaufman, Vouga, Tamstorf and Grinspun,
//! "Reflections on simultaneous impact" (SIGGRAPH 2012). At the start of a substep, in rounds:
//!
//! 1. `S` is the set of contacts that hit now: approach, and would overlap before the substep ends.
//! 2. Impulses on `S` alone part them: `Ċ_i ≥ -e_i c_i ⊥ λ_i ≥ 0` with the approach velocities `c_i` of this
//!    round.
//! 3. This makes others approach. They are the `S` of the next round.
//!
//! Simultaneous contacts get their restitution together, so a box that lands flat rises flat. Contacts that
//! they cause follow. Rounds end when nothing approaches, or when the island's iterations are used up
//! (`IslandRestitution`). The following passes stop the remaining approach without restitution, as for
//! approaches below the threshold.
//!
//! ## Energy
//! With all impulses `λ` of a round the kinetic energy changes by
//!
//! ```text
//! ΔT = ½ Σ λ_i (Ċ_i' + c_i)                     Ċ': after the round
//! ```
//!
//! whatever the couplings between the contacts are. A solution of 2 has `Ċ_i' = -e_i c_i` wherever `λ_i > 0`:
//! every term is negative, for any mixture of `e_i ≤ 1`. Iterations leave errors. If the sum over an island
//! is positive, its round is scaled by `s = a / (a + ΔT)` with `a = -Σ λ_i c_i`, which restores the energy.
//! (If `a` is negative, the round adds energy from the beginning, and is scaled by zero.) Impacts never add
//! energy.
//!
//! ## Joints
//! Joints transmit impacts. Directly solved locked axes take part. After each iteration over `S`, the
//! velocities are projected on the admissible ones. Joints resist the changes of an impact. The work of their
//! impulses `μ` is `μ Jv`, with the velocities before the impact. That is zero where the joint held these
//! velocities, and only forces have acted since. In a substep that rotates a body by a radian, the joint's
//! axes rotate away from the velocities that it left. The work is then arbitrary. It is added to the sum
//! above and to `-a`.
//!
//! The impulses of a round, of contacts and joints, are final when its fraction is known. Bodies, friction,
//! reports and break limits get `s λ` and `s μ`. An island whose round has the fraction zero is unchanged,
//! and would stay unchanged: its impact ends.
//!
//! All that holds for one mass matrix `M`. The projected changes are the nearest ones in its metric, which is
//! that of the kinetic energy. (Moreau, "Unilateral contact and dry friction in finite freedom dynamics",
//! 1988.) In this metric they still separate the contacts that hit. Contacts use the inertias of the start of
//! the step, except for uneven bodies (`contacts/follow.rs`). In impacts, joints therefore use these too.
//!
//! The energy that counts is that of the mean velocities of the substep. Gyroscopic bodies receive exactly
//! this energy (`dimN/motion.rs`). The changes of their free rotation are not taken for those of a force.
//!
//! ## Supported loads
//! A substep starts with the impulses of the last one, which may be outdated. An impulse that stopped an
//! impact would accelerate the body now. So impacts use the velocities before any impulse
//! (`SolverBodies::before`), after the forces and without any support. A loaded contact would then approach.
//! The impulses of the last substep change that velocity by `o_i`, from 0 up to the effect of the forces.
//! This constant of the substep is added. With it, resting and loaded bodies are at rest. The energy added is
//! then less than the sum above, by `Σ λ_i o_i`. Joints apply to changes alone: the changes of an impact must
//! be admissible.
//!
//! ## Time of impact
//! An impact happens at a time `τ = C / |c|` within the substep, or before it if a fast body was detected
//! late. The bodies are placed as if they had moved on at their new velocities since then: by `-τ Δv`
//! (`accept_impact`). The correction must not violate joints, which would turn errors into velocity. Bodies
//! of directly solved joints have one `τ`, and those of iterated joints have none
//! (`SolverJoints::merge_impact_times`).
//!
//! The target velocity (`rows.rs`) is that of the middle of the substep.
//!
//! A fast body that does not arrive before the substep ends is deferred to the next one. The other passes
//! only prevent penetration, and would remove its speed before it arrives.
//!
//! ## Friction
//! Friction acts once at the end, under all normal impulses of the impact. The velocity changes of an impact
//! are also added to the velocities "before any impulse" of the substep: they are no warm-start load.

mod impact_islands;
mod points;
mod rows;
mod active;
mod touched;
mod visits;

use super::blocks::for_each_color;
use super::bodies::SolverBodies;
use super::contacts::{Blocks, SolverContacts};
use super::context::{SolverInput, SolverPass};
use super::island_sums::IslandSums;
use super::joints::{Changes, SolverJoints};
use super::multibodies::SolverMultibodies;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane};
use crate::dim::math::Real;
use crate::model::contact::ContactInput;
#[cfg(test)]
pub(super) use active::ActiveBlock;
use active::{Active, Phase, Round};
use core::ops::Range;
use impact_islands::{ImpactIsland, IslandRestitution};
#[cfg(test)]
pub(super) use points::NormalRows;
pub(super) use rows::{ImpactBlock, ImpactMark, KnownVelocities};
use touched::Touched;
use visits::{BlockVisit, ImpactPhase};

/// Largest number of iterations of a round.
const ROUND_ITERATIONS_MAX: usize = 16;
/// Number of blocks per parallel task. An iteration of few blocks ends before another thread starts.
const BLOCKS_PER_TASK: usize = 32;

/// Mean number of blocks per active block.
const BLOCKS_PER_ACTIVE: usize = 4;

/// The contacts with restitution.
#[derive(Default)]
pub(super) struct Impacts {
    /// Blocks of one colour are contiguous.
    blocks: Vec<ImpactBlock>,
    /// By block.
    marks: Vec<ImpactMark>,
    colors: Vec<Range<usize>>,
    /// The active part of a round, often a small part of all contacts.
    active: Active,
    touched: Touched,
    islands: ImpactIslands,
}

/// Energy, restitution and sums of the islands that impacts have hit.
#[derive(Default)]
struct ImpactIslands {
    /// By island.
    impact_islands: Vec<ImpactIsland>,
    /// By island. Empty until a contact hits in this step.
    restitutions: Vec<IslandRestitution>,
    /// By island: the contributions of contacts and joints to [`ImpactIsland::dissipated`] and
    /// [`ImpactIsland::energy_gain`] in this round.
    sums: IslandSums<2>,
}

/// Constraints and context besides the contacts of bodies.
pub(super) struct ImpactContext<'a> {
    pub joints: &'a mut SolverJoints,
    /// The contacts of links, which take part.
    pub multibodies: &'a mut SolverMultibodies,
    pub input: SolverInput<'a>,
    pub pass: &'a SolverPass<'a>,
}

impl Impacts {
    /// Finds the contacts with restitution among the blocks of each colour.
    pub fn load(&mut self, contacts: &SolverContacts, bodies: &SolverBodies) {
        let lanes = contacts.lanes();
        self.blocks.clear();
        self.colors.clear();
        self.islands.restitutions.clear();
        for color in contacts.colors() {
            let start = self.blocks.len();
            for at in color.clone().filter(|&at| lanes[at].input.restitution != Lane::ZERO) {
                let ContactInput { bodies: [first, second], restitution, .. } = &lanes[at].input;
                let islands = core::array::from_fn(|k| bodies.island_of([first[k], second[k]]));
                self.blocks.push(ImpactBlock::new(at, *restitution, islands));
            }
            if start < self.blocks.len() {
                self.colors.push(start..self.blocks.len());
            }
        }
        debug_assert!(self.colors.is_sorted_by(|one, two| one.end == two.start));
        self.marks.clear();
        self.marks.resize(self.blocks.len(), ImpactMark::default());
    }

    /// Returns whether there is no contact with restitution.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// Applies restitution to everything that hits in this substep. Impacts read and change the velocities
    /// before any impulse of the substep, [`SolverBodies::before`].
    pub fn solve(
        &mut self,
        contacts: &mut SolverContacts,
        bodies: &mut SolverBodies,
        mut context: ImpactContext<'_>,
    ) {
        if self.is_empty() && !context.multibodies.has_restitution() {
            return;
        }
        let (contacts, pass) = (contacts.blocks(), &context.pass.impacts);
        let input = context.input;
        context.multibodies.begin_impact(bodies, pass);
        context.multibodies.mark_active(input, bodies, |_| true, pass);
        self.visit_blocks(ImpactPhase::Begin, contacts, bodies, &context);
        let hits = self.marks.iter().any(|mark| mark.active != 0);
        let hits = hits || context.multibodies.active().next().is_some();
        if hits {
            self.open_islands(bodies, context.multibodies);
            let held = self.begin(bodies, &context);
            while self.find_active(contacts, context.multibodies) {
                self.solve_round(held, bodies, &mut context);
                let impact_islands = &self.islands.impact_islands;
                let has_iterations = |island: u32| impact_islands[island as usize].iterations > 0;
                context.multibodies.mark_active(input, bodies, has_iterations, pass);
                self.visit_blocks(ImpactPhase::Mark, contacts, bodies, &context);
            }
        }
        context.multibodies.defer();
        self.visit_blocks(ImpactPhase::Defer, contacts, bodies, &context);
        if hits {
            self.begin_round(bodies, context.multibodies);
            context.multibodies.solve_active_friction(&mut bodies.before);
            self.visit_blocks(ImpactPhase::Friction, contacts, bodies, &context);
            self.accept(bodies, &mut context, |_| 1.0);
            context.joints.invalidate_poses();
        }
        context.multibodies.end_impact();
    }

    /// Restores the points that the last substep deferred.
    pub fn restore(&mut self, contacts: &mut SolverContacts) {
        for (impact, mark) in self.blocks.iter().zip(&mut self.marks) {
            if mark.is_deferred() {
                impact.restore(mark, contacts.block_mut(impact.at));
            }
        }
    }

    /// Initialises the progress of all islands. After the last iteration, the rest of an impact has no
    /// restitution: an error of the fraction `e` of its speed. So the iterations of a large island are
    /// proportional to its largest `e`. Small islands get all of them: their iterations are cheap.
    fn open_islands(&mut self, bodies: &SolverBodies, links: &SolverMultibodies) {
        let Self { blocks, active, islands, .. } = self;
        let ImpactIslands { impact_islands, restitutions, .. } = islands;
        if restitutions.is_empty() {
            restitutions.resize(
                bodies.island_bound().max(links.island_bound()),
                IslandRestitution::default(),
            );
            // The lanes beside it in a block must not matter: they depend on all of the world.
            let mut count = |island: u32, restitution: Real| {
                if let Some(of_island) =
                    restitutions.get_mut(island as usize).filter(|_| restitution != 0.0)
                {
                    of_island.contacts += 1;
                    of_island.restitution = of_island.restitution.max(restitution);
                }
            };
            for block in blocks {
                let lanes = block.islands.iter().zip(&block.restitution.0);
                lanes.for_each(|(&island, &restitution)| count(island, restitution));
            }
            links.restitutions().for_each(|(island, restitution)| count(island, restitution));
        }
        impact_islands.clear();
        let impact_island = |restitution: &IslandRestitution| ImpactIsland {
            iterations: restitution.iterations(),
            ..ImpactIsland::default()
        };
        impact_islands.extend(restitutions.iter().map(impact_island));
        active.clear();
    }

    /// Begins an impact: lists the bodies that joints hold exactly, which it may change wherever it falls.
    /// Returns their number.
    fn begin(&mut self, bodies: &SolverBodies, context: &ImpactContext<'_>) -> usize {
        self.touched.begin(bodies.states.len());
        self.touched.add(context.joints.held());
        let of_joints = self.touched.bodies.len();
        // The set of bodies that a hit multibody pushes is unknown.
        if context.multibodies.has_restitution() {
            self.touched.add_all(bodies.moving());
        }
        self.touched.keep();
        of_joints
    }

    /// Finds the contacts that hit, in islands with iterations left. Returns whether there is any.
    fn find_active(&mut self, contacts: Blocks<'_>, links: &mut SolverMultibodies) -> bool {
        let Self { blocks, marks, colors, active, touched, islands } = self;
        let impact_islands = &mut islands.impact_islands;
        for island in active.islands.drain(..) {
            let impact_island = &mut impact_islands[island as usize];
            (impact_island.is_active, impact_island.is_moving) = (false, false);
            (impact_island.dissipated, impact_island.energy_gain) = (0.0, 0.0);
        }
        islands.sums.clear();
        active.clear();
        touched.begin_round();
        for color in &*colors {
            active.add_color(color.clone(), blocks, marks, contacts, impact_islands);
        }
        active.blocks.iter().for_each(|block| touched.add(block.bodies()));
        for contact in links.active() {
            let island = contact.impact.island;
            active.include(island, &mut impact_islands[island as usize]);
        }
        !active.islands.is_empty()
    }

    /// Parts the contacts that hit.
    fn solve_round(
        &mut self,
        held: usize,
        bodies: &mut SolverBodies,
        context: &mut ImpactContext<'_>,
    ) {
        self.begin_round(bodies, context.multibodies);
        context.joints.invalidate_poses();
        context.joints.begin_impact_impulses();
        for _ in 0..ROUND_ITERATIONS_MAX {
            context.multibodies.iterate_active(&mut bodies.before);
            self.iterate(Phase::Iterate, bodies, context);
            if !self.find_moving(context.multibodies) {
                break;
            }
            let ImpactIslands { impact_islands, sums, .. } = &mut self.islands;
            let islands = &bodies.islands;
            let impact_island = |body: u32| impact_islands.get(islands[body as usize] as usize);
            // Bodies without an island move as they did.
            let is_moving =
                |body: u32| impact_island(body).is_none_or(|impact_island| impact_island.is_moving);
            let add_work = |body: u32, work: Real| sums.push(islands[body as usize], [work; 2]);
            let changes = Changes {
                held: &self.touched.bodies[..held],
                start: &self.touched.start,
                states: &mut bodies.before,
                poses: &bodies.poses,
            };
            context.joints.project(changes, is_moving, add_work, context.pass);
        }
        context.multibodies.end_round(&mut bodies.before, &mut self.touched.times);
        self.iterate(Phase::End, bodies, context);
        let sums = &mut self.islands.sums;
        for block in &self.active.blocks {
            for lane in block.lanes() {
                sums.push(
                    block.islands[lane],
                    [block.dissipated.0[lane], block.energy_gain.0[lane]],
                );
            }
        }
        for contact in context.multibodies.active() {
            sums.push(
                contact.impact.island,
                [contact.impact.dissipated, contact.impact.energy_gain],
            );
        }
        context.joints.merge_impact_times(&mut self.touched.times);
        self.commit_round(bodies, context);
    }

    /// Scales the round of each island by the fraction that its energy allows.
    fn commit_round(&mut self, bodies: &mut SolverBodies, context: &mut ImpactContext<'_>) {
        let ImpactIslands { impact_islands, sums, .. } = &mut self.islands;
        sums.for_each(|island, [dissipated, energy_gain]| {
            let impact_island = &mut impact_islands[island as usize];
            impact_island.dissipated += dissipated;
            impact_island.energy_gain += energy_gain;
        });
        for &island in &self.active.islands {
            let impact_island = &mut impact_islands[island as usize];
            if impact_island.fraction() == 0.0 {
                impact_island.iterations = 0;
            }
        }
        let impact_islands = &self.islands.impact_islands;
        let fraction =
            |island: u32| impact_islands.get(island as usize).map_or(1.0, ImpactIsland::fraction);
        self.active.blocks.iter().for_each(|block| block.commit(&mut self.blocks, fraction));
        let islands = &bodies.islands;
        context.joints.commit_impact_impulses(|body| fraction(islands[body as usize]));
        context.multibodies.commit_round(fraction);
        self.accept(bodies, context, fraction);
    }

    /// Commits the changes of the round to bodies and multibodies, scaled by the fraction of each island.
    fn accept(
        &self,
        bodies: &mut SolverBodies,
        context: &mut ImpactContext<'_>,
        fraction: impl Fn(u32) -> Real + Copy,
    ) {
        let Touched { bodies: touched, start, times, .. } = &self.touched;
        bodies.accept_impact(touched, start, times, fraction);
        context.multibodies.accept_impact(context.pass.substep, fraction);
    }

    /// Finds the islands that the last iteration changed, and deactivates the others for the rest of the
    /// round. Returns whether there is any.
    fn find_moving(&mut self, links: &mut SolverMultibodies) -> bool {
        let Self { active, islands, .. } = self;
        let impact_islands = &mut islands.impact_islands;
        for &island in &active.islands {
            let impact_island = &mut impact_islands[island as usize];
            impact_island.iterations =
                impact_island.iterations.saturating_sub(usize::from(impact_island.is_active));
            impact_island.is_moving = false;
        }
        for block in &active.blocks {
            lanes(block.moving)
                .for_each(|k| impact_islands[block.islands[k] as usize].is_moving = true);
        }
        for contact in links.active().filter(|contact| contact.impact.moving) {
            impact_islands[contact.impact.island as usize].is_moving = true;
        }
        let mut any = false;
        for block in &mut active.blocks {
            for lane in block.lanes() {
                let impact_island = &mut impact_islands[block.islands[lane] as usize];
                if impact_island.is_moving {
                    any = true;
                } else {
                    impact_island.is_active = false;
                    block.deactivate(lane);
                }
            }
        }
        for contact in links.active() {
            let impact_island = &mut impact_islands[contact.impact.island as usize];
            if impact_island.is_moving {
                any = true;
            } else {
                impact_island.is_active = false;
                contact.deactivate();
            }
        }
        any
    }

    fn begin_round(&mut self, bodies: &SolverBodies, links: &mut SolverMultibodies) {
        links.begin_round();
        self.touched.note_start(&bodies.before);
    }

    /// Visits all blocks.
    fn visit_blocks(
        &mut self,
        phase: ImpactPhase,
        contacts: Blocks<'_>,
        bodies: &mut SolverBodies,
        context: &ImpactContext<'_>,
    ) {
        debug_assert!(self.is_empty() || bodies.last.len() == bodies.states.len());
        let known = KnownVelocities { last: &bodies.last, loaded: &bodies.states };
        let states = DisjointMut::new(&mut bodies.before);
        let impacts = DisjointMut::new(&mut self.blocks);
        let marks = DisjointMut::new(&mut self.marks);
        let (simd, pass) = (context.pass.simd, &context.pass.impacts);
        let touched = &self.touched;
        let all = 0..impacts.len();
        let (colors, grain) = match phase {
            ImpactPhase::Friction => (&self.colors[..], BLOCKS_PER_TASK * BLOCKS_PER_ACTIVE),
            // The other phases change no body: all blocks may be visited at once.
            _ => (core::slice::from_ref(&all), BLOCKS_PER_TASK),
        };
        for_each_color(colors, context.pass.tasks, grain, |range| {
            simd.run(BlockVisit {
                phase,
                range,
                contacts,
                impacts,
                marks,
                states,
                known,
                touched,
                pass,
            });
        });
    }

    /// Visits the blocks of the round.
    fn iterate(&mut self, phase: Phase, bodies: &mut SolverBodies, context: &ImpactContext<'_>) {
        let states = DisjointMut::new(&mut bodies.before);
        let Self { active: Active { blocks, colors, .. }, touched, .. } = self;
        let (blocks, times) = (DisjointMut::new(blocks), DisjointMut::new(&mut touched.times));
        let simd = context.pass.simd;
        for_each_color(colors, context.pass.tasks, BLOCKS_PER_TASK, |range| {
            simd.run(Round { phase, range, blocks, states, times });
        });
    }
}

/// The lanes whose bits are set.
pub(super) fn lanes(bits: u32) -> impl Iterator<Item = usize> {
    (0..LANES).filter(move |lane| bits >> lane & 1 == 1)
}
