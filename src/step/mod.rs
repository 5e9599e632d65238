//! # Step: the stages in the order of execution
//!
//! [`step`] is the whole pipeline. Each stage's signature lists its inputs and outputs, and the first lines
//! of its module are its card. Stages do not import each other: they leave [`notes`].

mod notes;
mod trace;

// In the order in which they run.
mod user_changes;
mod broad_phase;
mod narrow_phase;
mod islands;
mod solver;
mod quarantine;
mod ccd;
mod advance;
mod events;

use crate::base::held::HeldPanic;
use crate::base::tasks::{Tasks, Threads};
use crate::base::wide::Simd;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodySet;
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::NarrowPhase;
use crate::model::counters::Counters;
use crate::model::event::EventHandler;
use crate::model::hooks::PhysicsHooks;
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::{MultibodyEdits, MultibodyJointSet};
use crate::model::params::IntegrationParameters;
use crate::model::state_hash::WorldSets;
use crate::model::structure::Structure;
use crate::model::tree::BroadPhaseBvh;
use broad_phase::NeighborLimits;
use narrow_phase::{NarrowPhaseContext, NarrowPhaseScratch};
use notes::StepNotes;
use quarantine::{Checkpoint, Quarantine, StepConditions, World};
use solver::SolverScratch;
use trace::StageTrace;
pub use trace::StepStage;
use user_changes::{Resync, Resynced, UserChanges};

/// The sets and parameters of a world.
pub(crate) struct StepParts<'a> {
    pub gravity: Vector,
    pub params: &'a IntegrationParameters,
    pub islands: &'a mut IslandManager,
    pub broad_phase: &'a mut BroadPhaseBvh,
    pub narrow_phase: &'a mut NarrowPhase,
    pub bodies: &'a mut RigidBodySet,
    pub colliders: &'a mut ColliderSet,
    pub hooks: &'a dyn PhysicsHooks,
    pub events: &'a dyn EventHandler,
    pub counters: &'a mut Counters,
}

/// Buffers that are reused from step to step, and how steps are to run. They contain no state of the world.
#[derive(Default)]
pub(crate) struct StepScratch {
    notes: StepNotes,
    broad_phase: broad_phase::BroadPhaseScratch,
    pairs: Vec<(ColliderHandle, ColliderHandle)>,
    narrow_phase: NarrowPhaseScratch,
    simd: Simd,
    threads: Threads,
    solver: SolverScratch,
    quarantine: Quarantine,
    ccd: ccd::CcdScratch,
    advance: advance::AdvanceScratch,
    sleep: islands::SleepScratch,
    trace: StageTrace,
}

/// One step of the world. The parameters must be valid.
pub(crate) fn step(
    parts: StepParts<'_>,
    joints: &mut ImpulseJointSet,
    multibodies: &mut MultibodyJointSet,
    scratch: &mut StepScratch,
) {
    let threads = scratch.threads.clone();
    threads.open(|tasks| step_with(tasks, parts, joints, multibodies, scratch));
}

fn step_with(
    tasks: Tasks<'_>,
    mut parts: StepParts<'_>,
    joints: &mut ImpulseJointSet,
    multibodies: &mut MultibodyJointSet,
    scratch: &mut StepScratch,
) {
    parts.counters.reset();
    parts.counters.step_time.resume();
    scratch.notes.clear();
    scratch.quarantine.open();
    scratch.trace.clear();
    let Resynced { parted, stamp, .. } = parts.resync().before_step(joints, multibodies);
    // Hooks may panic. The events found so far are reported nevertheless.
    let mut panic = HeldPanic::default();
    let moved = panic.hold(|| simulate(tasks, &mut parts, joints, multibodies, scratch));
    let taken_out = scratch.quarantine.close(parts.bodies, &mut scratch.notes);
    parts.counters.solver.nquarantined = taken_out;
    scratch.notes.events.splice(..0, parted);
    let dt = if moved.is_some() { parts.params.dt } else { 0.0 };
    panic.join(moved.unwrap_or_default());
    report(&mut parts, scratch, dt, &mut panic);
    parts.islands.stamp = stamp;
    parts.counters.step_time.pause();
    panic.release();
}

/// All stages of the step except the last one, which reports events. Returns the panic of a hook that did not
/// end it.
fn simulate(
    tasks: Tasks<'_>,
    parts: &mut StepParts<'_>,
    joints: &mut ImpulseJointSet,
    multibodies: &mut MultibodyJointSet,
    scratch: &mut StepScratch,
) -> HeldPanic {
    let conditions = parts.conditions();
    let world = parts.world(joints, multibodies);
    let checkpoint = quarantine::is_at_risk(&world, conditions).then(|| Checkpoint::new(&world));
    while !solve(tasks, parts, joints, multibodies, scratch) {
        let StepScratch { quarantine, notes, .. } = scratch;
        let world = parts.world(joints, multibodies);
        quarantine.take_out(world, checkpoint.as_ref(), conditions, notes);
    }
    if parts.params.dt <= 0.0 {
        parts.islands.forget_motion();
        return HeldPanic::default();
    }
    let panic = follow_bodies(tasks, parts, multibodies, scratch);
    scratch.trace.add(StepStage::Finalize, &parts.sets(joints, multibodies));
    put_to_sleep(parts, scratch);
    scratch.trace.add(StepStage::Sleep, &parts.sets(joints, multibodies));
    parts.validate();
    panic
}

/// The step up to where bodies have moved, and nothing has followed them yet. Returns whether all of them
/// could; if not, none has.
fn solve(
    tasks: Tasks<'_>,
    parts: &mut StepParts<'_>,
    joints: &mut ImpulseJointSet,
    multibodies: &mut MultibodyJointSet,
    scratch: &mut StepScratch,
) -> bool {
    let edits = multibodies.apply_changes(parts.bodies);
    apply_user_changes(parts, joints, edits, scratch);
    joints.apply_changes(&mut parts.islands.joints);
    scratch.trace.add(StepStage::UserChanges, &parts.sets(joints, multibodies));
    find_contacts(tasks, parts, scratch);
    scratch.trace.add(StepStage::CollisionDetection, &parts.sets(joints, multibodies));
    find_approaches(parts, scratch);
    parts.validate();
    if parts.params.dt > 0.0 {
        move_bodies(tasks, parts, joints, multibodies, scratch);
        scratch.trace.add(StepStage::Solver, &parts.sets(joints, multibodies));
    }
    scratch.notes.diverged.is_empty()
}

/// The collision detection of a step, without any motion. Applies the user's edits if `apply_changes`.
/// Otherwise it applies removals only, and other edits stay pending.
pub(crate) fn detect_collisions(
    mut parts: StepParts<'_>,
    joints: &ImpulseJointSet,
    scratch: &mut StepScratch,
    apply_changes: bool,
) {
    parts.counters.reset();
    parts.counters.step_time.resume();
    scratch.notes.clear();
    let Resynced { parted, stamp, joints_fit } = parts.resync().before_detection(joints);
    scratch.notes.events.extend(parted);
    // Joints of another world wait for the next step.
    let none = ImpulseJointSet::new();
    let joints = if joints_fit { joints } else { &none };
    if apply_changes {
        apply_user_changes(&mut parts, joints, MultibodyEdits::default(), scratch);
    } else {
        let params = parts.params;
        let (structure, tree) = parts.structure();
        let events = &mut scratch.notes.events;
        let multibodies = MultibodyEdits::default();
        UserChanges { structure, tree, joints, multibodies, params, events }.run_removals();
    }
    let mut panic = HeldPanic::default();
    let threads = scratch.threads.clone();
    let found = panic.hold(|| threads.open(|tasks| find_contacts(tasks, &mut parts, scratch)));
    // Removals changed the list of awake bodies even if a hook panicked since.
    parts.bodies.renew_places();
    if found.is_some() {
        parts.islands.forget_motion();
        parts.narrow_phase.forget_step_impulses();
    }
    report(&mut parts, scratch, 0.0, &mut panic);
    parts.islands.stamp = stamp;
    parts.counters.step_time.pause();
    panic.release();
}

fn apply_user_changes(
    parts: &mut StepParts<'_>,
    joints: &ImpulseJointSet,
    multibodies: MultibodyEdits,
    scratch: &mut StepScratch,
) {
    parts.counters.stages.user_changes.resume();
    let params = parts.params;
    let (structure, tree) = parts.structure();
    let events = &mut scratch.notes.events;
    UserChanges { structure, tree, joints, multibodies, params, events }.run();
    parts.counters.stages.user_changes.pause();
}

fn find_contacts(tasks: Tasks<'_>, parts: &mut StepParts<'_>, scratch: &mut StepScratch) {
    let StepScratch { notes, broad_phase, pairs, narrow_phase, simd, .. } = scratch;
    parts.counters.stages.collision_detection_time.resume();
    parts.counters.cd.broad_phase_time.resume();
    let (known, colliders) = (&*parts.narrow_phase, &*parts.colliders);
    let tree = (&mut *parts.broad_phase, NeighborLimits::of(parts.params));
    let crowded = broad_phase::find_pairs(tasks, tree, colliders, known, broad_phase, pairs);
    parts.counters.cd.ncrowded = crowded.solids;
    parts.counters.cd.ncrowded_sensors = crowded.sensors;
    let (mut structure, _) = parts.structure();
    structure.add_pairs(pairs);
    parts.counters.cd.broad_phase_time.pause();

    parts.counters.cd.narrow_phase_time.resume();
    let NarrowPhase { contacts, intersections, lanes, .. } = &mut *parts.narrow_phase;
    let context = NarrowPhaseContext {
        bodies: parts.bodies,
        colliders: parts.colliders,
        islands: parts.islands,
        lanes,
        params: parts.params,
        hooks: parts.hooks,
        simd: *simd,
    };
    parts.counters.cd.nculled_pairs =
        narrow_phase::update(tasks, context, (contacts, intersections), narrow_phase, notes);
    parts.counters.cd.narrow_phase_time.pause();
    parts.counters.cd.ncontact_pairs = parts.narrow_phase.contacts.len();
    parts.counters.cd.nintersection_pairs = parts.narrow_phase.intersections.len();
    parts.counters.stages.collision_detection_time.pause();

    parts.counters.stages.island_construction_time.resume();
    let (mut structure, _) = parts.structure();
    islands::update(&mut structure, notes);
    ccd::watch(parts.bodies, &notes.deeply_penetrating, parts.params);
    parts.counters.stages.island_construction_time.pause();
}

/// Lists the bodies that kinematic bodies approach in this step, and wakes them. Collision detection alone
/// moves nothing, and wakes nothing.
fn find_approaches(parts: &mut StepParts<'_>, scratch: &mut StepScratch) {
    parts.counters.stages.island_construction_time.resume();
    let params = parts.params;
    let (mut structure, trees) = parts.structure();
    ccd::find_approaches(&mut structure, trees, params, &mut scratch.notes.approaches);
    parts.counters.stages.island_construction_time.pause();
}

fn move_bodies(
    tasks: Tasks<'_>,
    parts: &mut StepParts<'_>,
    joints: &mut ImpulseJointSet,
    multibodies: &mut MultibodyJointSet,
    scratch: &mut StepScratch,
) {
    parts.counters.stages.solver_time.resume();
    let context = solver::SolverContext {
        gravity: parts.gravity,
        params: parts.params,
        simd: scratch.simd,
        tasks,
        bodies: parts.bodies,
        narrow_phase: parts.narrow_phase,
        joints,
        multibodies,
        islands: parts.islands,
        fast: &mut scratch.notes.fast,
        trajectories: &mut scratch.notes.trajectories,
        broken: &mut scratch.notes.broken,
        diverged: &mut scratch.notes.diverged,
    };
    solver::solve(context, &mut scratch.solver, &mut parts.counters.solver);
    parts.counters.stages.solver_time.pause();
}

/// Returns the panic of a hook: bodies have moved, and the rest of the world must follow them.
fn follow_bodies(
    tasks: Tasks<'_>,
    parts: &mut StepParts<'_>,
    multibodies: &mut MultibodyJointSet,
    scratch: &mut StepScratch,
) -> HeldPanic {
    parts.counters.stages.ccd_time.resume();
    parts.counters.ccd.toi_computation_time.resume();
    let mut panic = HeldPanic::default();
    panic.hold(|| find_impacts(tasks, parts, multibodies, scratch));
    parts.counters.ccd.toi_computation_time.pause();
    let StepNotes { fast, trajectories, events, sleepy, .. } = &mut scratch.notes;
    let (stops, reports) = (&mut scratch.ccd, (events, &mut parts.counters.ccd));
    let moved = (&mut *parts.bodies, &mut *parts.islands);
    ccd::stop(moved, multibodies, (fast, trajectories), parts.params.dt, stops, reports);
    parts.counters.stages.ccd_time.pause();

    parts.counters.stages.update_time.resume();
    let StepParts { bodies, colliders, islands, broad_phase, params, .. } = parts;
    let (sets, scratch) = ((&mut **bodies, &mut **colliders), &mut scratch.advance);
    advance::advance(tasks, sets, islands, broad_phase, params, sleepy, scratch);
    parts.counters.stages.update_time.pause();
    panic
}

fn find_impacts(
    tasks: Tasks<'_>,
    parts: &StepParts<'_>,
    multibodies: &MultibodyJointSet,
    scratch: &mut StepScratch,
) {
    let StepScratch { notes, ccd, .. } = scratch;
    let StepNotes { fast, trajectories, approaches, .. } = notes;
    let context = ccd::CcdContext {
        bodies: parts.bodies,
        colliders: parts.colliders,
        multibodies,
        islands: parts.islands,
        trees: parts.broad_phase,
        narrow_phase: parts.narrow_phase,
        params: parts.params,
        hooks: parts.hooks,
        fast: &[],
        trajectories,
    };
    ccd::add_approached(context, approaches, fast);
    ccd::find_impacts(tasks, ccd::CcdContext { fast, ..context }, ccd);
}

fn put_to_sleep(parts: &mut StepParts<'_>, scratch: &mut StepScratch) {
    parts.counters.stages.island_construction_time.resume();
    let (mut structure, _) = parts.structure();
    islands::put_to_sleep(&mut structure, &scratch.notes.sleepy, &mut scratch.sleep);
    parts.counters.stages.island_construction_time.pause();
}

/// `dt` is the duration of the motion: 0 if bodies did not move, and then contacts have no impulses.
fn report(parts: &mut StepParts<'_>, scratch: &mut StepScratch, dt: Real, panic: &mut HeldPanic) {
    scratch.notes.order_events();
    let StepParts { bodies, colliders, narrow_phase, events, .. } = parts;
    events::report((bodies, colliders, narrow_phase), &scratch.notes, dt, *events, panic);
}

impl StepScratch {
    /// Runs steps on these threads.
    pub fn set_threads(&mut self, threads: Threads) {
        self.threads = threads;
    }

    /// Hashes the world after each stage, or no longer.
    pub fn trace_stages(&mut self, enabled: bool) {
        self.trace.enable(enabled);
    }

    /// The hashes of the last step.
    pub fn stage_hashes(&self) -> &[(StepStage, u64)] {
        self.trace.hashes()
    }

    /// Selects the widest instructions of the machine for the solver, or the baseline of its architecture.
    pub fn set_wide_instructions(&mut self, wide: bool) {
        self.simd = if wide { Simd::detect() } else { Simd::baseline() };
    }
}

impl<'a> StepParts<'a> {
    /// In debug builds, asserts that bodies, pairs, islands and colours agree.
    fn validate(&mut self) {
        if cfg!(debug_assertions) {
            self.structure().0.validate();
        }
    }

    /// The parts that must be those of the last step.
    fn resync(&mut self) -> Resync<'_> {
        let (structure, tree) = self.structure();
        Resync { structure, tree }
    }

    /// Gravity and parameters.
    fn conditions(&self) -> StepConditions<'a> {
        StepConditions { gravity: self.gravity, params: self.params }
    }

    /// All that a step changes.
    fn world<'w>(
        &'w mut self,
        joints: &'w mut ImpulseJointSet,
        multibodies: &'w mut MultibodyJointSet,
    ) -> World<'w> {
        World {
            islands: self.islands,
            broad_phase: self.broad_phase,
            narrow_phase: self.narrow_phase,
            bodies: self.bodies,
            colliders: self.colliders,
            joints,
            multibodies,
        }
    }

    /// The sets that a hash covers.
    fn sets<'w>(
        &'w self,
        impulse_joints: &'w ImpulseJointSet,
        multibody_joints: &'w MultibodyJointSet,
    ) -> WorldSets<'w> {
        let (bodies, colliders) = (&*self.bodies, &*self.colliders);
        let narrow_phase = &*self.narrow_phase;
        WorldSets { bodies, colliders, impulse_joints, multibody_joints, narrow_phase }
    }

    /// The sets that refer to each other, and the trees.
    fn structure(&mut self) -> (Structure<'_>, &mut BroadPhaseBvh) {
        let structure = Structure {
            bodies: self.bodies,
            colliders: self.colliders,
            narrow_phase: self.narrow_phase,
            islands: self.islands,
        };
        (structure, self.broad_phase)
    }
}
