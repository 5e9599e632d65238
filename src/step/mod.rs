//! # Step: the stages in the order of execution
//!
//! `Step::run` is the whole pipeline, and `stages` contains the calls of each stage, with the sets that the
//! stage gets. The first lines of a stage's module are its card. Stages do not import each other: they leave
//! [`notes`].

mod notes;
mod scratch;
mod stages;
mod trace;
mod world;

// In the order in which they run.
mod user_changes;
mod broad_phase;
mod narrow_phase;
mod islands;
mod solver;
mod quarantine;
mod ccd;
mod finalize_bodies;
mod events;

use crate::base::held::HeldPanic;
use crate::base::tasks::Tasks;
use crate::dim::math::Real;
use crate::model::counters::Counters;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;
pub(crate) use scratch::StepScratch;
pub use trace::StepStage;
pub(crate) use world::World;

/// One step of the world, in parts if impacts may divide it. The parameters must be valid.
pub(crate) fn step(mut world: World<'_>, counters: &mut Counters, scratch: &mut StepScratch) {
    let threads = scratch.threads.clone();
    scratch.trace.clear();
    counters.reset();
    threads.open(|tasks| {
        let parts = world.params.max_ccd_substeps.max(1);
        for part in 1..=parts {
            let step = Step::new(world.reborrow(), counters, scratch, tasks);
            world.params.dt = step.run(part < parts);
            if world.params.dt <= 0.0 {
                break;
            }
        }
    });
}

/// The collision detection of a step, without any motion. Applies the user's edits if `apply_changes`.
/// Otherwise it applies removals only, and other edits stay pending.
pub(crate) fn detect_collisions(
    world: World<'_>,
    joints: (&ImpulseJointSet, &MultibodyJointSet),
    counters: &mut Counters,
    scratch: &mut StepScratch,
    apply_changes: bool,
) {
    let threads = scratch.threads.clone();
    scratch.trace.clear();
    counters.reset();
    threads.open(|tasks| Step::new(world, counters, scratch, tasks).detect(joints, apply_changes));
}

/// A step in progress.
struct Step<'a> {
    world: World<'a>,
    counters: &'a mut Counters,
    scratch: &'a mut StepScratch,
    tasks: Tasks<'a>,
    /// The duration of the motion: 0 until bodies have moved.
    duration: Real,
    /// The time that an impact has divided off: another step takes it.
    time_left: Real,
    /// A panic of a hook or an event handler. It continues when the world is consistent again.
    panic: HeldPanic,
}

impl Step<'_> {
    /// All stages. A step in which bodies diverged is repeated without the causes. Returns the time that is
    /// left if the step ends at an impact, which is possible if `may_divide`.
    fn run(mut self, may_divide: bool) -> Real {
        let stamp = self.resync();
        self.quarantine_edits();
        self.hold_panic(|step| {
            loop {
                step.user_changes();
                step.broad_phase();
                step.narrow_phase();
                step.islands();
                step.ccd_candidates();
                if may_divide {
                    step.divide();
                }
                step.solver();
                if step.all_converged() {
                    break;
                }
                step.quarantine();
            }
            if step.duration > 0.0 {
                step.ccd();
                step.finalize_bodies();
                step.sleep();
            }
        });
        self.restore_targets();
        self.report_quarantine();
        self.events();
        let time_left = self.time_left;
        self.end(stamp);
        time_left
    }

    /// The stages that move no body.
    fn detect(
        mut self,
        (joints, multibodies): (&ImpulseJointSet, &MultibodyJointSet),
        apply_changes: bool,
    ) {
        let stamp = self.detect_user_changes(joints, multibodies, apply_changes);
        self.hold_panic(|step| {
            step.broad_phase();
            step.narrow_phase();
            step.islands();
            step.clear_last_step();
        });
        // Removals changed the list of awake bodies even if a hook panicked since.
        self.world.structure.bodies.renew_places();
        self.events();
        self.end(stamp);
    }

    /// Runs stages that call hooks.
    fn hold_panic(&mut self, stages: impl FnOnce(&mut Self)) {
        let mut panic = HeldPanic::default();
        panic.hold(|| stages(self));
        self.panic.join(panic);
    }
}
