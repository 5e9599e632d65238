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

/// One step of the world. The parameters must be valid.
pub(crate) fn step(world: World<'_>, counters: &mut Counters, scratch: &mut StepScratch) {
    let threads = scratch.threads.clone();
    threads.open(|tasks| Step::new(world, counters, scratch, tasks).run());
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
    /// A panic of a hook or an event handler. It continues when the world is consistent again.
    panic: HeldPanic,
}

impl Step<'_> {
    /// All stages. A step in which bodies diverged is repeated without the causes.
    fn run(mut self) {
        let stamp = self.resync();
        self.quarantine_edits();
        self.hold_panic(|step| {
            loop {
                step.user_changes();
                step.broad_phase();
                step.narrow_phase();
                step.islands();
                step.ccd_candidates();
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
        self.report_quarantine();
        self.events();
        self.end(stamp);
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
