//! Input and output of the solver, and the context of its passes.

use crate::base::tasks::Tasks;
use crate::base::wide::Simd;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodySet;
use crate::model::contact::NarrowPhase;
use crate::model::event::JointBreakEvent;
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::{LinkTrajectory, MultibodyJointSet};
use crate::model::params::{
    ContactPass, FrictionModel, ImpactPass, IntegrationParameters, JointPass,
};
use crate::step::notes::{Diverged, FastMotion};

/// Input and output of the solver.
pub(crate) struct SolverContext<'a> {
    pub gravity: Vector,
    pub params: &'a IntegrationParameters,
    /// The instructions that kernels run on.
    pub simd: Simd,
    pub tasks: Tasks<'a>,
    pub bodies: &'a mut RigidBodySet,
    pub narrow_phase: &'a mut NarrowPhase,
    pub joints: &'a mut ImpulseJointSet,
    pub multibodies: &'a mut MultibodyJointSet,
    pub islands: &'a mut IslandManager,
    /// Output: the motions of fast bodies.
    pub fast: &'a mut Vec<FastMotion>,
    /// Output: the trajectories of fast multibodies.
    pub trajectories: &'a mut Vec<LinkTrajectory>,
    /// Output: the joints that break.
    pub broken: &'a mut Vec<JointBreakEvent>,
    /// Output: the bodies that cannot be stored.
    pub diverged: &'a mut Vec<Diverged>,
}

impl<'a> SolverContext<'a> {
    /// The passes of a group with this number of substeps.
    pub(super) fn pass(&self, substeps: usize) -> SolverPass<'a> {
        let Self { gravity, params, simd, tasks, .. } = *self;
        let substep = params.dt / substeps as Real;
        SolverPass {
            params,
            substep,
            contacts: ContactPass::new(params, substep),
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
