//! Input and output of the solver, and the context of its passes.
//!
//! The solver has three phases. It loads from the sets, and reads them while it solves ([`SolverInput`]). If
//! no body diverged, it stores impulses ([`ImpulseOutput`]), and then motions ([`MotionOutput`]). The
//! functions of a phase receive its type, or single sets. The types show what a phase writes.

use crate::base::tasks::Tasks;
use crate::base::wide::Simd;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodySet;
use crate::model::contact::NarrowPhase;
use crate::model::event::JointBreakEvent;
use crate::model::frozen::Frozen;
use crate::model::island::{BodyMotion, IslandManager, StepPace};
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::{LinkTrajectory, MultibodyJointSet};
use crate::model::params::{
    ContactPass, FrictionModel, ImpactPass, IntegrationParameters, JointPass,
};
use crate::step::notes::{Diverged, FastMotion};

/// Input and output of the solver. Nothing can be inserted into the sets or removed. Their comments list the
/// data that loading writes.
pub(crate) struct SolverContext<'a> {
    pub settings: SolverSettings<'a>,
    /// The lengths of substeps, and the velocities of position-based kinematic bodies.
    pub bodies: Frozen<'a, RigidBodySet>,
    /// Impulses of the last step from the lanes. The lanes are borrowed until impulses are stored.
    pub narrow_phase: Frozen<'a, NarrowPhase>,
    /// Angles, flags of displaced joints, and impulses that are scaled to the substep.
    pub joints: Frozen<'a, ImpulseJointSet>,
    /// Notes of multibodies with a removed body. Awake multibodies are borrowed until motions are stored.
    pub multibodies: Frozen<'a, MultibodyJointSet>,
    /// Loading writes nothing, and storing [`MotionOutput::motions`].
    pub islands: Frozen<'a, IslandManager>,
    /// Output: the motions of fast bodies.
    pub fast: &'a mut Vec<FastMotion>,
    /// Output: the trajectories of fast multibodies.
    pub trajectories: &'a mut Vec<LinkTrajectory>,
    /// Output: the joints that break.
    pub broken: &'a mut Vec<JointBreakEvent>,
    /// Output: the bodies that cannot be stored.
    pub diverged: &'a mut Vec<Diverged>,
}

/// The settings of a step, and the registers and threads that it runs on.
#[derive(Copy, Clone)]
pub(crate) struct SolverSettings<'a> {
    pub gravity: Vector,
    pub params: &'a IntegrationParameters,
    pub pace: StepPace,
    /// The instructions that kernels run on.
    pub simd: Simd,
    pub tasks: Tasks<'a>,
}

/// The sets while constraints are prepared and solved.
#[derive(Copy, Clone)]
pub(super) struct SolverInput<'a> {
    pub world: &'a RigidBodySet,
    pub narrow_phase: &'a NarrowPhase,
    pub joints: &'a ImpulseJointSet,
    pub islands: &'a IslandManager,
}

/// The sets that receive impulses.
pub(super) struct ImpulseOutput<'a> {
    pub settings: SolverSettings<'a>,
    pub islands: &'a IslandManager,
    /// Impulses of manifolds; the lanes return.
    pub narrow_phase: Frozen<'a, NarrowPhase>,
    /// Impulses, forces and angles.
    pub joints: Frozen<'a, ImpulseJointSet>,
    pub broken: &'a mut Vec<JointBreakEvent>,
}

/// The sets that receive poses and velocities.
pub(super) struct MotionOutput<'a> {
    pub settings: SolverSettings<'a>,
    pub bodies: Frozen<'a, RigidBodySet>,
    /// The borrowed multibodies return.
    pub multibodies: Frozen<'a, MultibodyJointSet>,
    /// By body slot: the motion of the body in this step.
    pub motions: &'a mut [BodyMotion],
    pub fast: &'a mut Vec<FastMotion>,
    pub trajectories: &'a mut Vec<LinkTrajectory>,
}

impl SolverContext<'_> {
    /// The sets, for reading.
    pub(super) fn input(&self) -> SolverInput<'_> {
        let Self { bodies: world, narrow_phase, joints, islands, .. } = self;
        SolverInput { world, narrow_phase, joints, islands }
    }

    /// The sets that receive impulses.
    pub(super) fn impulse_output(&mut self) -> ImpulseOutput<'_> {
        let Self { settings, islands, narrow_phase, joints, broken, .. } = self;
        let (narrow_phase, joints) = (narrow_phase.reborrow(), joints.reborrow());
        ImpulseOutput { settings: *settings, islands, narrow_phase, joints, broken }
    }

    /// The sets that receive poses and velocities.
    pub(super) fn motion_output(&mut self) -> MotionOutput<'_> {
        let Self { settings, islands, bodies, multibodies, fast, trajectories, .. } = self;
        let motions = islands.motions_mut(bodies.slot_count());
        let (bodies, multibodies) = (bodies.reborrow(), multibodies.reborrow());
        MotionOutput { settings: *settings, bodies, multibodies, motions, fast, trajectories }
    }
}

impl<'a> SolverSettings<'a> {
    /// The passes of a group with this number of substeps.
    pub(super) fn pass(&self, substeps: usize) -> SolverPass<'a> {
        let Self { gravity, params, pace, simd, tasks } = *self;
        let substep = params.dt / substeps as Real;
        debug_assert!(substep > 0.0 && substep <= params.dt);
        SolverPass {
            params,
            substep,
            contacts: ContactPass::new(params, substep, pace.reference_ratio),
            joints: JointPass::new(params, substep),
            impacts: ImpactPass::new(params, gravity.length(), substep),
            simd,
            tasks,
        }
    }
}

/// Parameters of a substep, and the registers and threads that its passes run on.
#[derive(Copy, Clone)]
pub(super) struct SolverPass<'a> {
    pub params: &'a IntegrationParameters,
    /// Length of a substep (s).
    pub substep: Real,
    pub contacts: ContactPass,
    pub joints: JointPass,
    pub impacts: ImpactPass,
    pub simd: Simd,
    pub tasks: Tasks<'a>,
}

impl SolverPass<'_> {
    /// Returns whether each contact point has its own friction rows.
    pub fn has_friction_per_point(&self) -> bool {
        self.params.friction_model == FrictionModel::Coulomb
    }

    /// The relax iterations of a substep.
    pub fn relaxations(&self) -> impl Iterator<Item = Self> {
        let mut early = *self;
        early.contacts.is_last_iteration = false;
        early.joints.is_last_iteration = false;
        let count = self.params.num_additional_friction_iterations;
        core::iter::repeat_n(early, count).chain([*self])
    }
}
