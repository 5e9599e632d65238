//! # Solver: velocities and poses under constraints
//!
//! Reads:   manifolds, joints, multibodies, the constraint graphs, parameters
//! Writes:  velocities and poses of awake bodies, impulses of contacts and joints; breaks joints
//! Runs:    parallel within a colour; colours in order
//! Never:   adds or removes anything: the structure is frozen
//!
//! The soft step of Catto's "Solver2D" (box2d.org, 2024), after Macklin et al. 2019, "Small Steps in Physics
//! Simulation": many small substeps with one iteration are better than one step with many iterations. Each
//! substep processes restitution, solves the constraints with a soft bias that removes overlap, and
//! integrates the positions. It then relaxes: a second iteration without bias removes the velocity that the
//! bias added.
//!
//! **Warm starting without passes.** A substep should begin with the impulses of the last one. Moment arms
//! and inertias of contacts are frozen during a step (joints rotate theirs), so warm-start impulses have the
//! same effect on a body as in the last substep. That effect is the difference between the velocity at the
//! end of that substep and before any impulse. We keep the latter per body and add the difference, instead of
//! visiting all constraints.

mod bodies;
mod contacts;
mod groups;
mod impacts;
mod island_sums;
mod joints;
mod store_impulses;
mod layout;
mod multibodies;
mod overflow;
mod recovery;
#[cfg(test)]
mod tests;

use crate::base::tasks::Tasks;
use crate::base::wide::Simd;
use crate::dim::math::{Real, Vector};
use crate::model::body::{RigidBodyHandle, RigidBodySet};
use crate::model::contact::NarrowPhase;
use crate::model::counters::SolverCounters;
use crate::model::event::JointBreakEvent;
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::{LinkTrajectory, MultibodyJointSet};
use crate::model::params::{
    ContactPass, FrictionModel, ImpactPass, IntegrationParameters, JointPass,
};
use crate::step::notes::{Diverged, FastMotion};
use bodies::SolverBodies;
use contacts::{LoadKind, SolverContacts};
use groups::Groups;
use impacts::ImpactContext;
use joints::{JointSources, SolverJoints};
use multibodies::{MultibodyContext, SolverMultibodies};
use recovery::Recovery;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct SolverScratch {
    groups: Groups,
    bodies: SolverBodies,
    /// By group.
    constraints: Vec<Constraints>,
}

/// Joints, contacts and multibodies of a group.
#[derive(Default)]
struct Constraints {
    joints: SolverJoints,
    contacts: SolverContacts,
    multibodies: SolverMultibodies,
    recovery: Recovery,
}

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
    /// Gets the motions of fast bodies.
    pub fast: &'a mut Vec<FastMotion>,
    /// Output: the trajectories of fast multibodies.
    pub trajectories: &'a mut Vec<LinkTrajectory>,
    /// Gets the joints that break.
    pub broken: &'a mut Vec<JointBreakEvent>,
    /// Gets the bodies that cannot be stored.
    pub diverged: &'a mut Vec<Diverged>,
}

/// Solves one step for all awake bodies.
///
/// If there are bodies that cannot be stored, nothing is.
pub(crate) fn solve(
    context: SolverContext<'_>,
    scratch: &mut SolverScratch,
    counters: &mut SolverCounters,
) {
    let SolverContext { gravity, params, simd, tasks, bodies, narrow_phase, islands, .. } = context;
    let (set, trees, diverged) = (context.joints, context.multibodies, context.diverged);
    let SolverScratch { groups, bodies: states, constraints } = scratch;
    counters.velocity_assembly_time.resume();
    groups.divide(islands, bodies, narrow_phase, set, (gravity, params, tasks));
    let constraints = for_each_group(constraints, groups);
    constraints.iter_mut().for_each(|of_group| of_group.multibodies.register_links(trees, bodies));
    states.load(groups, bodies, &constraints[0].multibodies, (gravity, params), tasks);
    counters.velocity_assembly_time.pause();
    let is_only_group = groups.iter().len() == 1;
    constraints.iter_mut().for_each(|of_group| of_group.contacts.clear());
    let mut is_moderate = true;
    counters.nlimited_bodies = 0;
    for (group, constraints) in groups.iter().zip(&mut *constraints) {
        counters.velocity_assembly_time.resume();
        states.enter(group, groups);
        let pass = JointPass::new(params, params.dt / group.substeps as Real);
        let Constraints { joints, contacts, multibodies, .. } = constraints;
        multibodies.load(&groups.order()[group.members.clone()], trees, bodies);
        multibodies.begin(bodies, gravity, pass.substep);
        let from = JointSources { islands, world: bodies, bodies: states, multibodies };
        joints.load(set, from, &pass, tasks);
        let per_point = params.friction_model == FrictionModel::Coulomb;
        let kind = LoadKind { is_only_group, per_point };
        contacts.load(&islands.graph, narrow_phase, (states, kind), multibodies, tasks);
        let multibody_context =
            MultibodyContext { narrow_phase, islands, joints: set, world: bodies };
        multibodies.prepare(multibody_context, states, &pass);
        counters.velocity_assembly_time.pause();

        let place = (&*narrow_phase, &*bodies);
        let order = &groups.order()[group.members.clone()];
        let context = GroupContext { gravity, params, place, order, simd, tasks };
        solve_group(group.substeps, &context, states, constraints, counters);

        counters.velocity_writeback_time.resume();
        constraints.joints.finish(states, simd, tasks);
        let links_are_moderate = constraints.multibodies.finish(diverged, pass.substep);
        let group_is_moderate = links_are_moderate & states.are_moderate(tasks);
        if !group_is_moderate || states.any_far {
            states.find_diverged(groups, bodies, &constraints.multibodies, diverged);
        }
        is_moderate &= group_is_moderate;
        counters.velocity_writeback_time.pause();
    }
    counters.velocity_writeback_time.resume();
    if diverged.is_empty() {
        if groups.iter().len() > 0 {
            narrow_phase.contacts.forget_renewed();
        }
        let world = World { narrow_phase, set, trees, islands, bodies };
        let SolverContext { fast, trajectories, broken, .. } = context;
        let mut notes = Notes { fast, trajectories, broken };
        store_constraints(constraints, world, &mut notes, params, (counters, simd, tasks));
        let world = (&mut *islands, bodies, &constraints[0].multibodies);
        states.store(groups, world, params, notes.fast, tasks);
        islands.ill_conditioned = !is_moderate || states.any_far || groups.are_ill_conditioned();
    } else {
        for of_group in constraints {
            of_group.multibodies.give_back(trees);
            of_group.contacts.give_back(narrow_phase);
        }
    }
    counters.velocity_writeback_time.pause();
}

/// A buffer for each group: all groups are solved before any is stored.
fn for_each_group<'a>(
    constraints: &'a mut Vec<Constraints>,
    groups: &Groups,
) -> &'a mut [Constraints] {
    let count = groups.iter().len().max(1);
    constraints.resize_with(count.max(constraints.len()), Constraints::default);
    &mut constraints[..count]
}

/// Destination sets of stored results.
struct World<'a> {
    narrow_phase: &'a mut NarrowPhase,
    set: &'a mut ImpulseJointSet,
    trees: &'a mut MultibodyJointSet,
    islands: &'a mut IslandManager,
    bodies: &'a mut RigidBodySet,
}

/// Notes for later stages, made while results are stored.
struct Notes<'a> {
    fast: &'a mut Vec<FastMotion>,
    trajectories: &'a mut Vec<LinkTrajectory>,
    broken: &'a mut Vec<JointBreakEvent>,
}

/// Stores the impulses of contacts and joints, and the state of multibodies in their links; breaks overloaded
/// joints.
fn store_constraints(
    constraints: &mut [Constraints],
    world: World<'_>,
    Notes { fast, trajectories, broken }: &mut Notes<'_>,
    params: &IntegrationParameters,
    (counters, simd, tasks): (&mut SolverCounters, Simd, Tasks<'_>),
) {
    let World { narrow_phase, set, trees, islands, bodies } = world;
    (counters.nconstraints, counters.ncontacts) = (0, 0);
    for Constraints { joints, contacts, multibodies, .. } in constraints {
        contacts.store(narrow_phase, simd, tasks);
        joints.store((islands, set), params.inv_dt(), broken, tasks);
        multibodies.store_constraints(set, narrow_phase, params.inv_dt(), broken);
        let displacements = (&mut **fast, &mut **trajectories);
        counters.nlimited_bodies +=
            multibodies.store(trees, (islands, bodies), params, displacements);
        counters.nconstraints += contacts.len() + joints.len();
        counters.ncontacts += contacts.point_count();
    }
}

/// Common context of all solved bodies.
struct GroupContext<'a> {
    gravity: Vector,
    params: &'a IntegrationParameters,
    /// Contacts and bodies.
    place: (&'a NarrowPhase, &'a RigidBodySet),
    /// The bodies that are solved.
    order: &'a [RigidBodyHandle],
    simd: Simd,
    tasks: Tasks<'a>,
}

/// Solves one step for some bodies, in substeps.
fn solve_group(
    substeps: usize,
    context: &GroupContext<'_>,
    states: &mut SolverBodies,
    constraints: &mut Constraints,
    counters: &mut SolverCounters,
) {
    let Constraints { joints, contacts, multibodies, recovery } = constraints;
    let &GroupContext { gravity, params, place, order, simd, tasks } = context;
    let h = params.dt / substeps as Real;
    let pass = ContactPass::new(params, h);
    let early_pass = ContactPass { is_last_iteration: false, ..pass };
    let joint_pass = JointPass::new(params, h);
    let impact_pass = ImpactPass::new(params, gravity.length(), h);
    let early_joint_pass = JointPass { is_last_iteration: false, ..joint_pass };
    counters.velocity_assembly_time.resume();
    joints.warm_start(states, simd, tasks);
    contacts.prepare(states, (params, &pass), simd, tasks);
    if contacts.note_deep_overlaps(recovery, states, &pass) {
        let links = order.iter().filter(|link| multibodies.moves(link.into_raw_parts().0));
        let links = links.map(|&link| place.1[link].link.island);
        joints.islands(states).chain(links).for_each(|island| recovery.leave_out(island));
    }
    multibodies.warm_start(states);
    counters.velocity_assembly_time.pause();

    counters.velocity_resolution_time.resume();
    let mut limited = 0;
    for substep in 0..substeps {
        let last = if substep == 0 { &mut states.before } else { &mut states.states };
        multibodies.note_velocities(last);
        let when = (substep == 0, contacts.has_restitution());
        let slowed = states.integrate_velocities(h, params, when, (simd, tasks));
        limited = limited.max(slowed);
        if substep > 0 {
            multibodies.follow_loops(place.1, states);
        }
        multibodies.integrate_velocities(h, params, tasks);
        joints.select_method(states, &joint_pass);
        joints.scale_impulses(params.warmstart_coefficient);
        contacts.scale_impulses(params.warmstart_coefficient);
        let links = (&mut *multibodies, place);
        let impact_context = ImpactContext { joints, joint_pass: &joint_pass, links, simd, tasks };
        contacts.solve_impacts(states, impact_context, &impact_pass);
        for _ in 0..params.num_internal_pgs_iterations {
            joints.solve(states, &joint_pass, simd, tasks);
            contacts.solve(states, &pass, simd, tasks);
            multibodies.solve(states, &pass, params);
        }
        states.integrate_positions(h, (simd, tasks));
        multibodies.integrate_positions(states, h, params.max_linear_velocity(), tasks);
        multibodies.follow_contacts(place, states);
        for _ in 0..params.num_additional_friction_iterations {
            joints.relax(states, &early_joint_pass, simd, tasks);
            contacts.relax(states, &early_pass, simd, tasks);
            multibodies.relax(states, &early_pass, params);
        }
        joints.relax(states, &joint_pass, simd, tasks);
        contacts.relax(states, &pass, simd, tasks);
        multibodies.relax(states, &pass, params);
        contacts.return_gains(recovery, states);
    }
    counters.nlimited_bodies += limited;
    counters.velocity_resolution_time.pause();
}
