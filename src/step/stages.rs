//! The calls of the stages: each gets the sets that its signature lists, and its time is measured.

use super::broad_phase::{self, NeighborLimits};
use super::ccd::{self, CcdContext, StopContext};
use super::events::{self, EventContext};
use super::finalize_bodies::{self, FinalizeContext};
use super::islands;
use super::narrow_phase::{self, NarrowPhaseContext};
use super::notes::StepNotes;
use super::solver::{self, SolverContext, SolverSettings};
use super::trace::StepStage;
use super::user_changes::{Resynced, UserChanges, resync_before_detection, resync_before_step};
use super::{Step, StepScratch, World};
use crate::base::held::HeldPanic;
use crate::base::tasks::Tasks;
use crate::model::contact::NarrowPhase;
use crate::model::counters::Counters;
use crate::model::frozen::Frozen;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::{MultibodyEdits, MultibodyJointSet};
use crate::model::stamp::WorldStamp;
use crate::model::structure::Structure;

impl<'a> Step<'a> {
    /// A new step of a world.
    pub(super) fn new(
        world: World<'a>,
        counters: &'a mut Counters,
        scratch: &'a mut StepScratch,
        tasks: Tasks<'a>,
    ) -> Self {
        counters.step_time.resume();
        scratch.notes.clear();
        let (duration, time_left) = (0.0, 0.0);
        Self { world, counters, scratch, tasks, duration, time_left, panic: HeldPanic::default() }
    }
}

impl Step<'_> {
    /// Registers everything anew if a set is not that of the last step. Returns the stamp of this step.
    pub(super) fn resync(&mut self) -> WorldStamp {
        let Resynced { end_events, stamp, .. } = resync_before_step(&mut self.world);
        self.scratch.notes.events.extend(end_events);
        stamp
    }

    /// Disables edited bodies that diverge on their own.
    pub(super) fn quarantine_edits(&mut self) {
        let quarantine = &mut self.scratch.quarantine;
        self.counters.stages.user_changes.measure(|| quarantine.open(&mut self.world));
    }

    /// Applies the edits since the last step.
    pub(super) fn user_changes(&mut self) {
        let World { structure, broad_phase: tree, joints, multibodies, params, .. } =
            &mut self.world;
        let events = &mut self.scratch.notes.events;
        self.counters.stages.user_changes.measure(|| {
            let multibodies = multibodies.apply_changes(structure.bodies);
            let set = structure.reborrow();
            UserChanges { structure: set, tree, joints, multibodies, params, events }.run();
            joints.apply_changes(&mut structure.islands.joints);
        });
        let Structure { bodies, colliders, .. } = structure;
        debug_assert!(bodies.modified().is_empty() && colliders.modified().is_empty());
        self.trace(StepStage::UserChanges);
    }

    /// The same before a detection: applies edits of bodies and colliders, or removals only. Returns the
    /// stamp of the detection.
    pub(super) fn detect_user_changes(
        &mut self,
        joints: &ImpulseJointSet,
        multibodies: &MultibodyJointSet,
        are_applied: bool,
    ) -> WorldStamp {
        let Resynced { end_events, stamp, joints_fit } =
            resync_before_detection(&mut self.world, joints, multibodies);
        let World { structure, broad_phase: tree, joints: none, params, .. } = &mut self.world;
        // Joints of another world are applied in the next step.
        let joints = if joints_fit[0] { joints } else { none };
        let multibodies = match joints_fit[1] {
            true => multibodies.pending_changes(structure.bodies),
            false => MultibodyEdits::default(),
        };
        let structure = structure.reborrow();
        let events = &mut self.scratch.notes.events;
        events.extend(end_events);
        let changes = UserChanges { structure, tree, joints, multibodies, params, events };
        let timer = &mut self.counters.stages.user_changes;
        timer.measure(|| if are_applied { changes.run() } else { changes.run_removals() });
        stamp
    }

    /// Finds new pairs of colliders, and adds them to the structure.
    pub(super) fn broad_phase(&mut self) {
        let World { structure, broad_phase: tree, params, .. } = &mut self.world;
        let (limits, scratch) = (NeighborLimits::of(params), &mut self.scratch.broad_phase);
        let Counters { stages, cd, .. } = self.counters;
        let find = || {
            let Structure { colliders, narrow_phase: known, islands, .. } = structure.reborrow();
            let crowded = broad_phase::find_pairs(
                self.tasks, tree, limits, colliders, known, islands, scratch,
            );
            (cd.ncrowded, cd.ncrowded_sensors) = (crowded.solids, crowded.sensors);
            structure.add_pairs(&scratch.pairs);
        };
        stages.collision_detection_time.measure(|| cd.broad_phase_time.measure(find));
    }

    /// Computes the contacts and intersections of pairs.
    pub(super) fn narrow_phase(&mut self) {
        let StepScratch { narrow_phase: scratch, notes, simd, .. } = self.scratch;
        let Structure { bodies, colliders, islands, narrow_phase } = &mut self.world.structure;
        let NarrowPhase { contacts, intersections, lanes, .. } = &mut **narrow_phase;
        let context = NarrowPhaseContext {
            bodies,
            colliders,
            islands,
            lanes,
            params: &self.world.params,
            hooks: self.world.hooks,
            simd: *simd,
        };
        let Counters { stages, cd, .. } = self.counters;
        let update =
            || narrow_phase::update(self.tasks, context, contacts, intersections, scratch, notes);
        cd.nculled_pairs =
            stages.collision_detection_time.measure(|| cd.narrow_phase_time.measure(update));
        (cd.ncontact_pairs, cd.nintersection_pairs) = (contacts.len(), intersections.len());
    }

    /// Links and cuts islands, wakes bodies, and marks bodies deep in a wall for CCD.
    pub(super) fn islands(&mut self) {
        let World { structure, params, .. } = &mut self.world;
        let notes = &mut self.scratch.notes;
        self.counters.stages.island_construction_time.measure(|| {
            islands::update(structure, notes);
            ccd::set_deeply_penetrating(structure.bodies, &notes.deeply_penetrating, params);
        });
        self.trace(StepStage::CollisionDetection);
    }

    /// Lists and wakes the bodies that kinematic bodies approach in this step.
    pub(super) fn ccd_candidates(&mut self) {
        let World { structure, broad_phase: trees, params, .. } = &mut self.world;
        let approaches = &mut self.scratch.notes.approaches;
        self.counters.stages.island_construction_time.measure(|| {
            ccd::find_approaches(structure, trees, params, approaches);
        });
        self.validate();
    }

    /// Ends the step at the first impact of a fast body, unless an earlier attempt did.
    pub(super) fn divide(&mut self) {
        if self.time_left > 0.0 || self.world.params.dt <= 0.0 {
            return;
        }
        let StepScratch { ccd: scratch, notes, .. } = self.scratch;
        let (context, gravity) = (ccd_context(&self.world), self.world.gravity);
        let find = || ccd::first_impact_time(self.tasks, context, gravity, scratch);
        if let Some(time) = self.counters.stages.ccd_time.measure(find) {
            let World { structure: Structure { bodies, islands, .. }, params, .. } =
                &mut self.world;
            let fraction = time / params.dt;
            let bodies = Frozen::new(&mut **bodies);
            ccd::share_targets(bodies, islands, params, fraction, &mut notes.targets);
            self.time_left = params.dt - time;
            params.dt = time;
        }
    }

    /// Returns the targets of position-based kinematic bodies after a divided step.
    pub(super) fn restore_targets(&mut self) {
        for (handle, target) in self.scratch.notes.targets.drain(..) {
            let body = self.world.structure.bodies.get_unnoted_mut(handle);
            body.into_iter().for_each(|body| body.next_pose = target);
        }
    }

    /// Moves the bodies, unless the step has no duration. If a body diverged, nothing is stored.
    pub(super) fn solver(&mut self) {
        let World { gravity, params, structure, joints, multibodies, .. } = &mut self.world;
        if params.dt <= 0.0 {
            structure.islands.clear_motion();
            return;
        }
        let StepScratch { notes, solver: scratch, simd, .. } = self.scratch;
        let pace = structure.islands.pace.of(params.dt);
        let settings =
            SolverSettings { gravity: *gravity, params, pace, simd: *simd, tasks: self.tasks };
        let context = SolverContext {
            settings,
            bodies: Frozen::new(structure.bodies),
            narrow_phase: Frozen::new(structure.narrow_phase),
            joints: Frozen::new(joints),
            multibodies: Frozen::new(multibodies),
            islands: Frozen::new(structure.islands),
            fast: &mut notes.fast,
            trajectories: &mut notes.trajectories,
            broken: &mut notes.broken,
            diverged: &mut notes.diverged,
        };
        let Counters { stages, solver: counters, .. } = self.counters;
        stages.solver_time.measure(|| solver::solve(context, scratch, counters));
        if notes.diverged.is_empty() {
            structure.islands.pace = structure.islands.pace.after(params.dt);
            self.duration = params.dt;
            debug_assert!(structure.has_usable_bodies(), "the solver stores finite numbers");
        }
        self.trace(StepStage::Solver);
    }

    /// Returns whether the solver could store all bodies.
    pub(super) fn all_converged(&self) -> bool {
        self.scratch.notes.diverged.is_empty()
    }

    /// Disables the causes of a failed step.
    pub(super) fn quarantine(&mut self) {
        let StepScratch { quarantine, notes, .. } = self.scratch;
        quarantine.take_out(&mut self.world, notes);
    }

    /// Notes the disabled bodies for the event handler.
    pub(super) fn report_quarantine(&mut self) {
        let StepScratch { quarantine, notes, .. } = self.scratch;
        self.counters.solver.nquarantined = quarantine.close(self.world.structure.bodies, notes);
    }

    /// Stops fast bodies at their first impact. Bodies have moved: even if a hook panics, the rest of the
    /// world must follow them.
    pub(super) fn ccd(&mut self) {
        let StepScratch { ccd: scratch, notes, .. } = self.scratch;
        let StepNotes { fast, trajectories, approaches, events, .. } = notes;
        let Counters { stages, ccd: counters, .. } = self.counters;
        stages.ccd_time.measure(|| {
            let context = CcdContext { trajectories, ..ccd_context(&self.world) };
            counters.toi_computation_time.measure(|| {
                self.panic.hold(|| {
                    ccd::add_approached(context, approaches, fast);
                    ccd::find_impacts(self.tasks, context, fast, scratch);
                })
            });
            let World { structure, multibodies, params, .. } = &mut self.world;
            let context = StopContext {
                bodies: Frozen::new(structure.bodies),
                islands: Frozen::new(structure.islands),
                multibodies: Frozen::new(multibodies),
                fast,
                trajectories,
                dt: params.dt,
            };
            ccd::stop(context, scratch, events, counters);
        });
    }

    /// Updates colliders, boxes and sleep timers.
    pub(super) fn finalize_bodies(&mut self) {
        let World { structure, broad_phase: tree, params, .. } = &mut self.world;
        let Structure { bodies, colliders, islands, .. } = structure;
        let context = FinalizeContext {
            tasks: self.tasks,
            params,
            bodies: Frozen::new(bodies),
            colliders: Frozen::new(colliders),
            islands,
            tree,
        };
        let StepScratch { notes, finalize: scratch, .. } = self.scratch;
        let timer = &mut self.counters.stages.update_time;
        timer.measure(|| finalize_bodies::finalize_bodies(context, scratch, &mut notes.sleepy));
        self.trace(StepStage::Finalize);
    }

    /// Puts islands at rest to sleep.
    pub(super) fn sleep(&mut self) {
        let StepScratch { notes, sleep: scratch, .. } = self.scratch;
        let structure = &mut self.world.structure;
        self.counters
            .stages
            .island_construction_time
            .measure(|| islands::put_to_sleep(structure, &notes.sleepy, scratch));
        self.trace(StepStage::Sleep);
        debug_assert!(self.world.structure.narrow_phase.has_all_results(), "no result is lost");
        self.validate();
    }

    /// Calls the user's event handler. Contacts have impulses only if bodies moved.
    pub(super) fn events(&mut self) {
        let notes = &mut self.scratch.notes;
        let Structure { bodies, colliders, narrow_phase, .. } = &mut self.world.structure;
        notes.order_events();
        let context = EventContext {
            bodies,
            colliders,
            narrow_phase,
            notes,
            duration: self.duration,
            handler: self.world.events,
        };
        events::report(context, &mut self.panic);
    }

    /// After a detection: contacts have no impulses, and no body has moved.
    pub(super) fn clear_last_step(&mut self) {
        self.world.structure.islands.clear_motion();
        self.world.structure.narrow_phase.clear_step_impulses();
    }

    /// Marks the sets as those of one step, and continues a panic.
    pub(super) fn end(self, stamp: WorldStamp) {
        self.world.structure.islands.stamp = stamp;
        self.counters.step_time.pause();
        self.panic.release();
    }

    /// Adds a hash of the world to the trace.
    fn trace(&mut self, stage: StepStage) {
        self.scratch.trace.add(stage, &self.world.hashed_sets());
    }

    /// In debug builds, asserts that bodies, pairs, islands, colours and multibodies agree.
    fn validate(&self) {
        if cfg!(debug_assertions) {
            self.world.structure.validate(self.world.multibodies);
        }
    }
}

/// The context of a search without fast bodies.
fn ccd_context<'a>(world: &'a World<'_>) -> CcdContext<'a> {
    let World { structure, broad_phase: trees, multibodies, params, hooks, .. } = world;
    let Structure { bodies, colliders, narrow_phase, islands } = structure;
    CcdContext {
        bodies,
        colliders,
        multibodies,
        islands,
        trees,
        narrow_phase,
        params,
        hooks: *hooks,
        fast: &[],
        trajectories: &[],
    }
}
