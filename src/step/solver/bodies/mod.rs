//! Awake bodies of the solver: dense, and group after group.

mod load;
mod motion;
mod store;
mod divergence;

use super::context::SolverPass;
use super::groups::{Group, Groups};
use super::impact_time::ImpactTime;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::{Gather, Tasks};
use crate::base::wide::Simd;
use crate::dim::math::{AngularInertia, Real, SpatialVector};
use crate::dim::motion::FreeMotion;
use crate::dim::spatial::{angular, join};
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::model::body::{BODIES_PER_TASK, EnergyError};
use crate::model::island::NONE;
use crate::step::notes::FastMotion;
use core::ops::Range;
use core::sync::atomic::{AtomicUsize, Ordering};
use load::Places;
use motion::{Accelerate, Advance, BodyChunk, TurnInertias};

/// All awake bodies. Index 0 is the world, index `i + 1` the `i`-th in the order of the groups.
#[derive(Default)]
pub(super) struct SolverBodies {
    pub poses: Vec<BodyPose>,
    pub states: Vec<BodyState>,
    /// Velocities before any impulse of the current substep, with the displacements of its beginning.
    pub before: Vec<BodyState>,
    /// Velocities at the end of the last substep, before the forces of this one, if a stage requires them.
    pub last: Vec<BodyState>,
    motions: Vec<FreeMotion>,
    /// By body slot: the index above, with [`READ_ONLY`] unless constraints may move the body, and with
    /// [`NEAR_REST`]. The world's for bodies that are not awake.
    indices: Vec<u32>,
    /// By index: the slot whose index it is, or [`NONE`]; to be cleared by the next step.
    listed: Vec<u32>,
    /// By index: the fractions of the last impulses with which a step begins. The flag is set if that of any
    /// contacts is less than 1.
    impulse_fractions: Vec<ImpulseFractions>,
    any_scaled: bool,
    /// By index: whether the inertia changes so much during the step that contacts follow the body.
    pub uneven: Vec<bool>,
    /// The indices of uneven bodies in ascending order, and their inverse inertias when the step began.
    uneven_starts: Vec<(u32, AngularInertia)>,
    /// By index: the island, or [`NONE`].
    pub islands: Vec<u32>,
    /// By index: the energy error of the island.
    pub energy_errors: Vec<EnergyError>,
    /// The indices of moving bodies: the ungrouped ones, and the members of the solved group.
    moving: [Range<usize>; 2],
    /// Buffers of threads for fast bodies.
    fast: Gather<FastMotion>,
    /// Whether any body was far from the origin when the step began.
    pub any_far: bool,
}

/// The fractions of the last impulses with which a step begins. They are less than 1 if substeps have become
/// shorter, in proportion to the impulse of a force. They stay 1 if substeps have become longer: the impulses
/// may be those of a moment that does not last.
#[derive(Copy, Clone, Debug)]
pub(super) struct ImpulseFractions {
    pub of_joints: Real,
    /// Impulses of contacts may be those of longer substeps.
    pub of_contacts: Real,
}

impl ImpulseFractions {
    /// The whole impulses.
    const ALL: Self = Self { of_joints: 1.0, of_contacts: 1.0 };

    /// Returns whether both are within 0 and 1.
    fn are_fractions(&self) -> bool {
        [self.of_joints, self.of_contacts].iter().all(|fraction| (0.0..=1.0).contains(fraction))
    }
}

const WORLD: u32 = BodyPose::WORLD_INDEX | NEAR_REST;
/// Bit of a body index: marks bodies of a pile that are near rest, and the supports of piles.
const NEAR_REST: u32 = READ_ONLY >> 1;

impl SolverBodies {
    /// Selects the group that is solved; the others do not move.
    pub fn enter(&mut self, group: &Group, groups: &Groups) {
        let ungrouped = self.begin_ungrouped(groups);
        debug_assert!(ungrouped.end <= 1 + group.members.start, "bodies move once in a substep");
        debug_assert!(group.members.end < self.states.len(), "each member has a state");
        self.moving = [ungrouped, 1 + group.members.start..1 + group.members.end];
    }

    /// Puts ungrouped bodies back to the poses at the beginning of the step. Returns their indices.
    fn begin_ungrouped(&mut self, groups: &Groups) -> Range<usize> {
        let ungrouped = 1..1 + groups.ungrouped();
        for index in ungrouped.clone() {
            let (v, w) = self.states[index].velocity();
            self.states[index] = BodyState::new(v, w);
        }
        ungrouped
    }

    /// Moves ungrouped bodies through the step, in the usual number of substeps. The sum over those of the
    /// last group would have other last bits, and one island would change the motion of another.
    pub fn move_ungrouped(&mut self, groups: &Groups, pass: &SolverPass<'_>) {
        self.moving = [self.begin_ungrouped(groups), 0..0];
        for _ in 0..pass.params.num_solver_iterations {
            self.integrate_positions(pass);
        }
    }

    /// Moves the bodies of the group through the step if nothing holds or touches any of them. Returns the
    /// largest number of bodies that one substep limited to the largest speed.
    pub fn move_freely(&mut self, substeps: usize, pass: &SolverPass<'_>) -> usize {
        let mut limited = 0;
        for substep in 0..substeps {
            limited = limited.max(self.integrate_velocities(substep == 0, false, pass));
            self.integrate_positions(pass);
        }
        limited
    }

    /// Returns whether an index of a body, with or without [`READ_ONLY`], is that of a state.
    pub fn has_state(&self, index: u32) -> bool {
        ((index & !READ_ONLY) as usize) < self.states.len()
    }

    /// The bodies that may move.
    pub fn moving(&self) -> [Range<usize>; 2] {
        self.moving.clone()
    }

    /// Returns whether the solved group contains one of two bodies. For pairs of bodies that touch.
    pub fn has_one_of(&self, slots: [u32; 2]) -> bool {
        let [_, members] = &self.moving;
        slots.into_iter().any(|slot| {
            let index = self.index_of(slot);
            index & READ_ONLY == 0 && members.contains(&(index as usize))
        })
    }

    /// Returns whether the contacts of any body begin with a reduced fraction of their impulses.
    pub fn any_scaled(&self) -> bool {
        self.any_scaled
    }

    /// Returns whether there are uneven bodies.
    pub fn any_uneven(&self) -> bool {
        !self.uneven_starts.is_empty()
    }

    /// The fractions of the last impulses with which two bodies begin.
    pub fn impulse_fractions(&self, indices: [u32; 2]) -> ImpulseFractions {
        let moved = indices.into_iter().find(|index| index & READ_ONLY == 0);
        moved.map_or(ImpulseFractions::ALL, |index| self.impulse_fractions[index as usize])
    }

    /// The island of two bodies that touch.
    pub fn island_of(&self, indices: [u32; 2]) -> u32 {
        let moved = indices.into_iter().find(|index| index & READ_ONLY == 0);
        moved.map_or(NONE, |index| self.islands[index as usize])
    }

    /// Exclusive upper bound of the numbers of islands.
    pub fn island_bound(&self) -> usize {
        let ids = self.islands.iter().filter(|&&island| island != NONE);
        ids.max().map_or(0, |&island| island as usize + 1)
    }

    /// The solver's index of the body in a slot ([`NONE`]: no body).
    pub fn index_of(&self, slot: u32) -> u32 {
        self.find(slot).0
    }

    /// The same, with the bit for near rest.
    #[inline]
    pub fn find(&self, slot: u32) -> (u32, bool) {
        // There is no body in the slot `NONE`.
        let index = self.indices.get(slot as usize).copied().unwrap_or(WORLD);
        (index & !NEAR_REST, index & NEAR_REST != 0)
    }

    /// The poses and states, these to be shared among constraints of one colour.
    pub fn shared(&mut self) -> (&[BodyPose], DisjointMut<'_, BodyState>) {
        (&self.poses, DisjointMut::new(&mut self.states))
    }

    /// Adds gravity and the user's forces, damps, and starts the substep with the last one's impulses.
    ///
    /// At the first substep the states hold the impulses of the last step already, which must not be damped
    /// with the velocity. Keeps the old velocities if `keep_last`. Returns the number of bodies that were
    /// limited to the largest speed.
    pub fn integrate_velocities(
        &mut self,
        is_first: bool,
        keep_last: bool,
        pass: &SolverPass<'_>,
    ) -> usize {
        let &SolverPass { params, substep: h, simd, tasks, .. } = pass;
        self.last.resize(if keep_last { self.states.len() } else { 0 }, BodyState::AT_REST);
        let (warm_start_coefficient, speed_max) =
            (params.warmstart_coefficient, params.max_linear_velocity());
        let limited = AtomicUsize::new(0);
        self.for_all_moving(tasks, |bodies| {
            let slowed =
                simd.run(Accelerate { bodies, h, warm_start_coefficient, speed_max, is_first });
            limited.fetch_add(slowed, Ordering::Relaxed);
        });
        limited.into_inner()
    }

    /// Commits the changes of the velocities [before](Self::before) any impulse by an impact since the
    /// `start`, scaled by the `fraction` of each island. The changes count from the mean time of the impacts
    /// of a body. They are no warm-start impulses, so the states get the same changes.
    pub fn accept_impact(
        &mut self,
        touched: &[u32],
        start: &[BodyState],
        times: &[ImpactTime],
        fraction: impl Fn(u32) -> Real,
    ) {
        for &index in touched {
            let index = index as usize;
            let ((old_v, old_w), (v, w)) = (start[index].velocity(), self.before[index].velocity());
            if (v, w) == (old_v, old_w) {
                continue;
            }
            let fraction = fraction(self.islands[index]);
            debug_assert!(
                (0.0..=1.0).contains(&fraction),
                "an impact gives no more than its round"
            );
            let (added_v, added_w) = ((v - old_v) * fraction, (w - old_w) * fraction);
            self.before[index].set_velocity(old_v + added_v, old_w + added_w);
            self.states[index].add_velocity(join(added_v, added_w));
            if let Some(time) = times[index].mean() {
                debug_assert!(self.before[index].has_displacement_of(&self.states[index]));
                self.displace(index, join(added_v * -time, added_w * -time));
            }
        }
    }

    /// Rotates the inertias of uneven bodies of the group to their present orientations.
    pub fn turn_uneven(&mut self, simd: Simd) {
        let Self { uneven_starts, states, poses, moving: [_, members], .. } = self;
        debug_assert!(uneven_starts.is_sorted_by_key(|start| start.0), "the search bisects");
        let position = |end: usize| uneven_starts.partition_point(|start| (start.0 as usize) < end);
        let uneven_starts = &uneven_starts[position(members.start)..position(members.end)];
        simd.run(TurnInertias { uneven_starts, states, poses });
    }

    /// Notes the bodies that directly solved joints hold.
    pub fn note_joints(&mut self, held: impl Iterator<Item = u32>) {
        held.for_each(|index| self.motions[index as usize].note_joint());
    }

    /// Moves a body at once.
    pub fn displace(&mut self, index: usize, change: SpatialVector) {
        self.states[index].add_displacement(change);
        self.before[index].copy_displacement(&self.states[index]);
        self.motions[index].rotate(angular(&change));
    }

    /// Moves all bodies by their velocities.
    pub fn integrate_positions(&mut self, pass: &SolverPass<'_>) {
        let &SolverPass { substep: h, simd, tasks, .. } = pass;
        self.for_all_moving(tasks, |bodies| simd.run(Advance { bodies, h }));
    }

    fn for_all_moving(&mut self, tasks: Tasks<'_>, work: impl Fn(BodyChunk<'_>) + Sync) {
        let all = self.moving.clone();
        let Places { states, before, last, motions, .. } = self.places();
        for members in all {
            tasks.par_for(members.len(), BODIES_PER_TASK, |range| {
                let range = members.start + range.start..members.start + range.end;
                // SAFETY: groups have places, and each index belongs to one task.
                let bodies = unsafe {
                    BodyChunk {
                        states: states.range_mut(range.clone()),
                        before: before.range_mut(range.clone()),
                        last: last.range_mut(if last.len() == 0 { 0..0 } else { range.clone() }),
                        motions: motions.range_mut(range),
                    }
                };
                work(bodies);
            });
        }
    }
}
