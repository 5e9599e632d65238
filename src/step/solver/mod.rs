//! # Solver — make velocities obey
//!
//! Reads:   manifolds, joints, multibodies, the constraint graphs, parameters
//! Writes:  velocities and poses of awake bodies, impulses of manifolds and joints; breaks joints
//! Runs:    parallel within a colour; colours in order
//! Never:   adds or removes anything: the structure is frozen
//!
//! The soft step of Catto's "Solver2D" (box2d.org, 2024), after Macklin et al. 2019, "Small Steps in
//! Physics Simulation": many small substeps with one visit of each constraint beat one step with many
//! visits. Each substep solves the constraints with a soft bias that undoes overlap, moves the bodies,
//! and relaxes: solves once more without bias, so that the velocity that undid the overlap does not
//! stay. Bounces come once, at the end.
//!
//! **Warm starting without passes.** A substep should begin with the impulses of the last one. Lever
//! arms and inertias are frozen during a step, so what those impulses do to a body is what they did to
//! it in the last substep: the difference between its velocity at that substep's end and before any
//! impulse. We keep the latter per body and add the difference, instead of visiting all constraints.

mod bodies;
mod contacts;
mod groups;
mod joints;
mod multibodies;
#[cfg(test)]
mod tests;

use crate::base::tasks::Tasks;
use crate::base::wide::Simd;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodySet;
use crate::model::contact::NarrowPhase;
use crate::model::counters::SolverCounters;
use crate::model::event::JointBreakEvent;
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;
use crate::model::params::{ContactPass, IntegrationParameters, JointPass};
use bodies::SolverBodies;
use contacts::SolverContacts;
use groups::Groups;
use joints::SolverJoints;
use multibodies::{SolverMultibodies, Surroundings};

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct SolverScratch {
    groups: Groups,
    bodies: SolverBodies,
    constraints: Constraints,
    multibodies: SolverMultibodies,
}

/// What holds bodies.
#[derive(Default)]
struct Constraints {
    joints: SolverJoints,
    contacts: SolverContacts,
}

/// What the solver reads and writes.
pub(crate) struct Scene<'a> {
    pub gravity: Vector,
    pub params: &'a IntegrationParameters,
    /// The instructions that kernels run on.
    pub simd: Simd,
    pub bodies: &'a mut RigidBodySet,
    pub narrow_phase: &'a mut NarrowPhase,
    pub joints: &'a mut ImpulseJointSet,
    pub multibodies: &'a mut MultibodyJointSet,
    pub islands: &'a mut IslandManager,
    /// Gets the joints that break.
    pub broken: &'a mut Vec<JointBreakEvent>,
}

/// Solves one step for all awake bodies.
pub(crate) fn solve(scene: Scene<'_>, scratch: &mut SolverScratch, counters: &mut SolverCounters) {
    let Scene { gravity, params, simd, bodies, narrow_phase, joints: set, islands, broken, .. } =
        scene;
    let SolverScratch { groups, bodies: states, constraints, multibodies } = scratch;
    counters.velocity_assembly_time.resume();
    multibodies.load(scene.multibodies, bodies);
    groups.divide(islands, bodies, narrow_phase, multibodies, params);
    states.load(groups, bodies, multibodies, gravity, params);
    counters.velocity_assembly_time.pause();
    (counters.nconstraints, counters.ncontacts) = (0, 0);
    let nobody = &mut SolverMultibodies::default();
    for group in groups.iter() {
        let h = params.dt / group.substeps as Real;
        let multibodies = if group.has_multibodies { &mut *multibodies } else { &mut *nobody };
        let Constraints { joints, contacts } = constraints;
        let pass = JointPass::new(params, h);
        counters.velocity_assembly_time.resume();
        states.enter(group, groups);
        joints.load(islands, set, bodies, states, multibodies, &pass);
        joints.warm_start(states, simd, Tasks::current());
        multibodies.begin(bodies, gravity, h);
        contacts.load(&islands.graph, narrow_phase, states, multibodies);
        contacts.prepare(states, params, simd, Tasks::current());
        let around = Surroundings { narrow_phase, islands, joints: set, world: bodies };
        multibodies.prepare(around, states, &pass);
        counters.velocity_assembly_time.pause();

        counters.velocity_resolution_time.resume();
        let substeps = Substeps { count: group.substeps, h, params, simd, world: bodies };
        substeps.run(states, constraints, multibodies);
        counters.velocity_resolution_time.pause();

        counters.velocity_writeback_time.resume();
        let Constraints { joints, contacts } = constraints;
        contacts.store(narrow_phase);
        joints.store(islands, set, params.inv_dt(), broken);
        counters.velocity_writeback_time.pause();
        counters.nconstraints += contacts.len() + joints.len();
        counters.ncontacts += contacts.point_count();
    }
    counters.velocity_writeback_time.resume();
    states.store(groups, islands, bodies, multibodies, params);
    multibodies.store(scene.multibodies, set, narrow_phase, islands, bodies, params.inv_dt());
    counters.velocity_writeback_time.pause();
}

/// How some bodies are taken through a step.
struct Substeps<'a> {
    count: usize,
    /// Length of each (s).
    h: Real,
    params: &'a IntegrationParameters,
    simd: Simd,
    world: &'a RigidBodySet,
}

impl Substeps<'_> {
    fn run(
        &self,
        states: &mut SolverBodies,
        Constraints { joints, contacts }: &mut Constraints,
        multibodies: &mut SolverMultibodies,
    ) {
        let Self { count, h, params, simd, world } = *self;
        let tasks = Tasks::current();
        let pass = ContactPass::new(params, h);
        let early_pass = ContactPass { is_last_visit: false, ..pass };
        let joint_pass = JointPass::new(params, h);
        let early_joint_pass = JointPass { is_last_visit: false, ..joint_pass };
        for substep in 0..count {
            states.integrate_velocities(h, params, substep == 0);
            if substep > 0 {
                multibodies.follow_loops(world, states);
            }
            multibodies.integrate_velocities(h, params.warmstart_coefficient, tasks);
            joints.tighten(&joint_pass);
            joints.scale_impulses(params.warmstart_coefficient);
            contacts.scale_impulses(params.warmstart_coefficient);
            for _ in 0..params.num_internal_pgs_iterations {
                joints.solve(states, &joint_pass, simd, tasks);
                contacts.solve(states, &pass, simd, tasks);
                multibodies.solve(states, &pass, params);
            }
            states.integrate_positions(h);
            multibodies.integrate_positions(h, tasks);
            for _ in 0..params.num_additional_friction_iterations {
                joints.relax(states, &early_joint_pass, simd, tasks);
                contacts.relax(states, &early_pass, simd, tasks);
                multibodies.relax(states, &early_pass, params);
            }
            joints.relax(states, &joint_pass, simd, tasks);
            contacts.relax(states, &pass, simd, tasks);
            multibodies.relax(states, &pass, params);
        }
        contacts.restitute(states, &pass, simd, tasks);
        multibodies.restitute(states, &pass);
    }
}
