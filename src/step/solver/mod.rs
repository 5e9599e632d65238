//! # Solver — make velocities obey
//!
//! Reads:   manifolds, the constraint graph, parameters
//! Writes:  velocities and poses of awake bodies, impulses of manifolds
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
mod multibodies;
#[cfg(test)]
mod tests;

use crate::base::tasks::Tasks;
use crate::base::wide::Simd;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodySet;
use crate::model::contact::NarrowPhase;
use crate::model::counters::SolverCounters;
use crate::model::island::IslandManager;
use crate::model::multibody::MultibodyJointSet;
use crate::model::params::{ContactPass, IntegrationParameters};
use bodies::SolverBodies;
use contacts::SolverContacts;
use multibodies::SolverMultibodies;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct SolverScratch {
    bodies: SolverBodies,
    contacts: SolverContacts,
    multibodies: SolverMultibodies,
    simd: Simd,
}

impl SolverScratch {
    /// Uses the widest instructions that the machine has, or those that every machine has.
    pub fn set_wide_instructions(&mut self, wide: bool) {
        self.simd = if wide { Simd::detect() } else { Simd::baseline() };
    }
}

/// What the solver works on.
pub(crate) struct SolverWorld<'a> {
    pub bodies: &'a mut RigidBodySet,
    pub narrow_phase: &'a mut NarrowPhase,
    pub islands: &'a mut IslandManager,
    pub multibody_joints: &'a mut MultibodyJointSet,
}

/// Solves one step for all awake bodies.
pub(crate) fn solve(
    gravity: Vector,
    params: &IntegrationParameters,
    world: SolverWorld<'_>,
    scratch: &mut SolverScratch,
    counters: &mut SolverCounters,
) {
    let SolverWorld { bodies, narrow_phase, islands, multibody_joints } = world;
    let SolverScratch { bodies: states, contacts, multibodies, simd } = scratch;
    let tasks = Tasks::current();

    counters.velocity_assembly_time.resume();
    multibodies.load(multibody_joints, bodies);
    let extra = states.load(&islands.awake, bodies, multibodies, gravity, params);
    let substeps = params.num_solver_iterations + extra;
    let h = params.dt / substeps as Real;
    let pass = ContactPass::new(params, h);
    let early_pass = ContactPass { is_last_visit: false, ..pass };
    multibodies.begin(bodies, gravity, h);
    contacts.load(&islands.graph, narrow_phase, states, multibodies);
    contacts.prepare(states, params, *simd, tasks);
    multibodies.prepare(narrow_phase, bodies, states, h);
    counters.velocity_assembly_time.pause();

    counters.velocity_resolution_time.resume();
    for substep in 0..substeps {
        states.integrate_velocities(h, params, substep == 0);
        multibodies.integrate_velocities(h, params.warmstart_coefficient, tasks);
        contacts.scale_impulses(params.warmstart_coefficient);
        for _ in 0..params.num_internal_pgs_iterations {
            contacts.solve(states, &pass, *simd, tasks);
            multibodies.solve(states, &pass, params);
        }
        states.integrate_positions(h);
        multibodies.integrate_positions(h, tasks);
        for _ in 0..params.num_additional_friction_iterations {
            contacts.relax(states, &early_pass, *simd, tasks);
            multibodies.relax(states, &early_pass, params);
        }
        contacts.relax(states, &pass, *simd, tasks);
        multibodies.relax(states, &pass, params);
    }
    contacts.restitute(states, &pass, *simd, tasks);
    multibodies.restitute(states, &pass);
    counters.velocity_resolution_time.pause();

    counters.velocity_writeback_time.resume();
    contacts.store(&islands.graph, narrow_phase, multibodies);
    states.store(islands, bodies, multibodies, params);
    multibodies.store(multibody_joints, narrow_phase, islands, bodies);
    counters.velocity_writeback_time.pause();
    counters.nconstraints = contacts.len();
    counters.ncontacts = contacts.point_count();
}
