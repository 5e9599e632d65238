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
mod groups;
#[cfg(test)]
mod tests;

use crate::base::tasks::Tasks;
use crate::base::wide::Simd;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodySet;
use crate::model::contact::NarrowPhase;
use crate::model::counters::SolverCounters;
use crate::model::island::IslandManager;
use crate::model::params::{ContactPass, IntegrationParameters};
use bodies::SolverBodies;
use contacts::SolverContacts;
use groups::Groups;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct SolverScratch {
    bodies: SolverBodies,
    contacts: SolverContacts,
    groups: Groups,
    simd: Simd,
}

impl SolverScratch {
    /// Uses the widest instructions that the machine has, or those that every machine has.
    pub fn set_wide_instructions(&mut self, wide: bool) {
        self.simd = if wide { Simd::detect() } else { Simd::baseline() };
    }
}

/// Solves one step for all awake bodies.
pub(crate) fn solve(
    gravity: Vector,
    params: &IntegrationParameters,
    bodies: &mut RigidBodySet,
    narrow_phase: &mut NarrowPhase,
    islands: &mut IslandManager,
    scratch: &mut SolverScratch,
    counters: &mut SolverCounters,
) {
    let SolverScratch { bodies: states, contacts, groups, simd } = scratch;
    counters.velocity_assembly_time.resume();
    groups.divide(islands, bodies, narrow_phase, params);
    states.load(groups, bodies, gravity, params);
    counters.velocity_assembly_time.pause();
    (counters.nconstraints, counters.ncontacts) = (0, 0);
    for group in groups.iter() {
        counters.velocity_assembly_time.resume();
        states.enter(group, groups);
        contacts.load(&islands.graph, narrow_phase, states, groups.len() == 1);
        counters.velocity_assembly_time.pause();

        solve_group(group.substeps, params, states, contacts, *simd, counters);

        counters.velocity_writeback_time.resume();
        contacts.store(narrow_phase);
        counters.velocity_writeback_time.pause();
        counters.nconstraints += contacts.len();
        counters.ncontacts += contacts.point_count();
    }
    counters.velocity_writeback_time.resume();
    states.store(groups, islands, bodies, params);
    counters.velocity_writeback_time.pause();
}

/// Solves one step for some bodies, in substeps.
fn solve_group(
    substeps: usize,
    params: &IntegrationParameters,
    states: &mut SolverBodies,
    contacts: &mut SolverContacts,
    simd: Simd,
    counters: &mut SolverCounters,
) {
    let tasks = Tasks::current();
    let h = params.dt / substeps as Real;
    let pass = ContactPass::new(params, h);
    let early_pass = ContactPass { is_last_visit: false, ..pass };
    counters.velocity_assembly_time.resume();
    contacts.prepare(states, params, simd, tasks);
    counters.velocity_assembly_time.pause();

    counters.velocity_resolution_time.resume();
    for substep in 0..substeps {
        states.integrate_velocities(h, params, substep == 0);
        contacts.scale_impulses(params.warmstart_coefficient);
        for _ in 0..params.num_internal_pgs_iterations {
            contacts.solve(states, &pass, simd, tasks);
        }
        states.integrate_positions(h);
        for _ in 0..params.num_additional_friction_iterations {
            contacts.relax(states, &early_pass, simd, tasks);
        }
        contacts.relax(states, &pass, simd, tasks);
    }
    contacts.restitute(states, &pass, simd, tasks);
    counters.velocity_resolution_time.pause();
}
