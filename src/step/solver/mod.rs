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
use joints::SolverJoints;
use multibodies::{SolverMultibodies, Surroundings};

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct SolverScratch {
    bodies: SolverBodies,
    contacts: SolverContacts,
    joints: SolverJoints,
    multibodies: SolverMultibodies,
    simd: Simd,
}

impl SolverScratch {
    /// Uses the widest instructions that the machine has, or those that every machine has.
    pub fn set_wide_instructions(&mut self, wide: bool) {
        self.simd = if wide { Simd::detect() } else { Simd::baseline() };
    }
}

/// What the solver reads and writes.
pub(crate) struct Scene<'a> {
    pub gravity: Vector,
    pub params: &'a IntegrationParameters,
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
    let Scene { gravity, params, bodies, narrow_phase, joints: set, islands, broken, .. } = scene;
    let SolverScratch { bodies: states, contacts, joints, multibodies, simd } = scratch;
    let tasks = Tasks::current();

    counters.velocity_assembly_time.resume();
    multibodies.load(scene.multibodies, bodies);
    let extra = states.load(&islands.awake, bodies, multibodies, gravity, params);
    let substeps = params.num_solver_iterations + extra;
    let h = params.dt / substeps as Real;
    let pass = ContactPass::new(params, h);
    let early_pass = ContactPass { is_last_visit: false, ..pass };
    let joint_pass = JointPass::new(params, h);
    let early_joint_pass = JointPass { is_last_visit: false, ..joint_pass };
    joints.load(islands, set, bodies, states, multibodies, &joint_pass);
    joints.warm_start(states, *simd, tasks);
    multibodies.begin(bodies, gravity, h);
    contacts.load(&islands.graph, narrow_phase, states, multibodies);
    contacts.prepare(states, params, *simd, tasks);
    let around = Surroundings { narrow_phase, islands, joints: set, world: bodies };
    multibodies.prepare(around, states, &joint_pass);
    counters.velocity_assembly_time.pause();

    counters.velocity_resolution_time.resume();
    for substep in 0..substeps {
        states.integrate_velocities(h, params, substep == 0);
        if substep > 0 {
            multibodies.follow_loops(bodies, states);
        }
        multibodies.integrate_velocities(h, params.warmstart_coefficient, tasks);
        joints.tighten(&joint_pass);
        joints.scale_impulses(params.warmstart_coefficient);
        contacts.scale_impulses(params.warmstart_coefficient);
        for _ in 0..params.num_internal_pgs_iterations {
            joints.solve(states, &joint_pass, *simd, tasks);
            contacts.solve(states, &pass, *simd, tasks);
            multibodies.solve(states, &pass, params);
        }
        states.integrate_positions(h);
        multibodies.integrate_positions(h, tasks);
        for _ in 0..params.num_additional_friction_iterations {
            joints.relax(states, &early_joint_pass, *simd, tasks);
            contacts.relax(states, &early_pass, *simd, tasks);
            multibodies.relax(states, &early_pass, params);
        }
        joints.relax(states, &joint_pass, *simd, tasks);
        contacts.relax(states, &pass, *simd, tasks);
        multibodies.relax(states, &pass, params);
    }
    contacts.restitute(states, &pass, *simd, tasks);
    multibodies.restitute(states, &pass);
    counters.velocity_resolution_time.pause();

    counters.velocity_writeback_time.resume();
    contacts.store(&islands.graph, narrow_phase, multibodies);
    joints.store(islands, set, multibodies, params.inv_dt(), broken);
    states.store(islands, bodies, multibodies, params);
    multibodies.store(scene.multibodies, set, narrow_phase, islands, bodies, params.inv_dt());
    counters.velocity_writeback_time.pause();
    counters.nconstraints = contacts.len() + joints.len();
    counters.ncontacts = contacts.point_count();
}
