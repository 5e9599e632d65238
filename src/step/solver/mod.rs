//! # Solver: velocities and poses under constraints
//!
//! Reads:   manifolds, joints, multibodies, the constraint graphs, parameters
//! Writes:  velocities and poses of awake bodies, impulses of contacts and joints; breaks joints
//! Runs:    parallel within a colour; colours in order
//! Never:   adds or removes anything: the structure is frozen
//!
//! The solver implements the soft step of Catto's "Solver2D" (box2d.org, 2024), after Macklin et al. 2019,
//! "Small Steps in Physics Simulation". Many small substeps with one iteration are better than one step with
//! many iterations. Each substep processes restitution, solves the constraints with a soft bias that removes
//! overlap, and integrates the positions. It then relaxes: a second iteration without bias removes the
//! velocity that the bias added.
//!
//! **Warm starting without passes.** A substep should begin with the impulses of the last one. Moment arms
//! and inertias of contacts are frozen during a step (joints rotate theirs, and so do the contacts of thin
//! bodies: `contacts/follow.rs`). Warm-start impulses therefore have the same effect on a body as in the last
//! substep. That effect is the difference between the velocity at the end of that substep and before any
//! impulse. The solver stores the latter per body and adds the difference, instead of visiting all
//! constraints.

mod axis_law;
mod blocks;
mod bodies;
mod contacts;
mod context;
mod groups;
mod impact_time;
mod impacts;
mod island_sums;
mod joint_rules;
mod joints;
mod ledger;
mod links;
mod multibodies;
mod restitution;
mod stacks;
mod states;
mod transmission_end;
#[cfg(test)]
mod tests;

use crate::model::body::{RigidBodyHandle, RigidBodySet};
use crate::model::counters::SolverCounters;
use bodies::SolverBodies;
use contacts::{ContactLoadContext, SolverContacts};
use context::{ImpulseOutput, SolverInput, SolverPass};
pub(crate) use context::{SolverContext, SolverSettings};
use groups::Groups;
use impacts::{ImpactContext, Impacts};
use joints::{JointLoadContext, SolverJoints};
use ledger::{Entry, Ledger};
use links::Links;
use multibodies::SolverMultibodies;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct SolverScratch {
    groups: Groups,
    links: Links,
    bodies: SolverBodies,
    /// By group, and some that are not needed now.
    constraints: Vec<Constraints>,
}

/// Constraints of a group.
#[derive(Default)]
struct Constraints {
    joints: SolverJoints,
    contacts: SolverContacts,
    multibodies: SolverMultibodies,
    impacts: Impacts,
    ledger: Ledger,
}

/// Solves one step for all awake bodies.
///
/// If any body cannot be stored, nothing is stored.
pub(crate) fn solve(
    mut context: SolverContext<'_>,
    scratch: &mut SolverScratch,
    counters: &mut SolverCounters,
) {
    counters.velocity_assembly_time.resume();
    scratch.load(&mut context);
    counters.velocity_assembly_time.pause();
    counters.nlimited_bodies = 0;
    for index in 0..scratch.groups.len() {
        scratch.solve_group(index, &mut context, counters);
    }
    let settings = context.settings;
    let pass = settings.pass(settings.params.num_solver_iterations);
    scratch.bodies.move_ungrouped(&scratch.groups, &pass);
    counters.velocity_writeback_time.resume();
    if context.diverged.is_empty() {
        scratch.store(&mut context, counters);
    } else {
        scratch.discard(&mut context);
    }
    counters.velocity_writeback_time.pause();
}

impl SolverScratch {
    /// Divides the awake bodies into groups, and gathers their states.
    fn load(&mut self, context: &mut SolverContext<'_>) {
        let Self { groups, links, bodies, constraints } = self;
        groups.divide(context.input(), &context.settings);
        links.register(&mut context.multibodies, &context.bodies);
        bodies.load(groups, links, &mut context.bodies, &context.settings);
        // All groups are solved before any is stored.
        constraints.resize_with(groups.len().max(constraints.len()), Constraints::default);
    }

    /// Solves one step for the bodies of a group.
    fn solve_group(
        &mut self,
        index: usize,
        context: &mut SolverContext<'_>,
        counters: &mut SolverCounters,
    ) {
        let Self { groups, links, bodies, constraints } = self;
        let (group, constraints) = (groups.get(index), &mut constraints[index]);
        let pass = context.settings.pass(group.substeps);
        let members = &groups.order()[group.members.clone()];
        let is_only_group = groups.len() == 1;

        counters.velocity_assembly_time.resume();
        bodies.enter(group, groups);
        constraints.load_links(members, links, context, &pass);
        constraints.load(is_only_group, bodies, links, context, &pass);
        let input = context.input();
        constraints.prepare(input, bodies, &pass);
        constraints.open_ledger(members, links, input.world, bodies, &pass);
        counters.velocity_assembly_time.pause();

        counters.velocity_resolution_time.resume();
        counters.nlimited_bodies += if constraints.is_empty() {
            bodies.move_freely(group.substeps, &pass)
        } else {
            constraints.solve(group.substeps, input, bodies, &pass)
        };
        counters.velocity_resolution_time.pause();

        counters.velocity_writeback_time.resume();
        constraints.ledger.close(bodies);
        constraints.joints.finish(bodies, &pass);
        let links_are_moderate = constraints.multibodies.finish(context.diverged, pass.substep);
        let is_moderate = links_are_moderate & bodies.are_moderate(pass.tasks);
        if !is_moderate || bodies.any_far {
            bodies.find_diverged(groups, links, &context.bodies, context.diverged);
        }
        counters.velocity_writeback_time.pause();
    }

    /// Writes the results back, and the notes for later stages.
    fn store(&mut self, context: &mut SolverContext<'_>, counters: &mut SolverCounters) {
        let Self { groups, links, bodies, constraints } = self;
        if groups.len() > 0 {
            context.narrow_phase.clear_renewed();
        }
        (counters.nconstraints, counters.ncontacts) = (0, 0);
        let constraints = &mut constraints[..groups.len()];
        let mut impulses = context.impulse_output();
        for constraints in &mut *constraints {
            constraints.store_impulses(&mut impulses);
            counters.nconstraints += constraints.contacts.len() + constraints.joints.len();
            counters.ncontacts += constraints.contacts.point_count();
        }
        let mut motions = context.motion_output();
        for constraints in constraints {
            counters.nlimited_bodies += constraints.multibodies.store(&mut motions);
        }
        bodies.store(groups, links, &mut motions);
    }

    /// Returns the borrowed multibodies and lanes unchanged.
    fn discard(&mut self, context: &mut SolverContext<'_>) {
        for Constraints { contacts, multibodies, .. } in &mut self.constraints[..self.groups.len()]
        {
            multibodies.give_back(&mut context.multibodies);
            contacts.give_back(&mut context.narrow_phase);
        }
    }
}

impl Constraints {
    /// Moves the multibodies of a group out of their set.
    fn load_links(
        &mut self,
        members: &[RigidBodyHandle],
        links: &Links,
        context: &mut SolverContext<'_>,
        pass: &SolverPass<'_>,
    ) {
        self.multibodies.load(members, links, &mut context.multibodies, &context.bodies);
        self.multibodies.begin(&mut context.bodies, context.settings.gravity, pass.substep);
    }

    /// Makes blocks of joints and contacts.
    fn load(
        &mut self,
        is_only_group: bool,
        bodies: &SolverBodies,
        links: &Links,
        context: &mut SolverContext<'_>,
        pass: &SolverPass<'_>,
    ) {
        let SolverContext { islands, bodies: world, joints, narrow_phase, .. } = context;
        let joint_context = JointLoadContext { islands, world, bodies, links };
        self.joints.load(joints, joint_context, &pass.joints, pass.tasks);
        let per_point = pass.has_friction_per_point();
        let contact_context = ContactLoadContext { bodies, links, is_only_group, per_point };
        self.contacts.load(contact_context, &islands.graph, narrow_phase, pass.tasks);
        self.impacts.load(&self.contacts, bodies);
    }

    /// Returns whether nothing holds or touches the bodies.
    fn is_empty(&self) -> bool {
        self.joints.len() == 0 && self.contacts.len() == 0 && self.multibodies.is_empty()
    }

    /// Computes effective masses, and applies the impulses of the last step.
    fn prepare(
        &mut self,
        input: SolverInput<'_>,
        bodies: &mut SolverBodies,
        pass: &SolverPass<'_>,
    ) {
        let Self { joints, contacts, multibodies, .. } = self;
        multibodies.prepare(contacts.of_links(), input, bodies, pass);
        bodies.note_joints(joints.held());
        joints.warm_start(bodies, pass);
        contacts.prepare_and_warm_start(bodies, pass);
        multibodies.warm_start(bodies);
    }

    /// Solves one step in substeps. Returns the largest number of bodies that one substep limited to the
    /// largest speed.
    fn solve(
        &mut self,
        substeps: usize,
        input: SolverInput<'_>,
        bodies: &mut SolverBodies,
        pass: &SolverPass<'_>,
    ) -> usize {
        let mut limited = 0;
        for substep in 0..substeps {
            let slowed = self.begin_substep(substep == 0, input, bodies, pass);
            limited = limited.max(slowed);
            let Self { joints, contacts, multibodies, impacts, .. } = self;
            let context = ImpactContext { joints, multibodies, input, pass };
            impacts.solve(contacts, bodies, context);
            self.enter(Entry::Start, bodies, pass);
            let Self { joints, contacts, multibodies, .. } = self;
            for _ in 0..pass.params.num_internal_pgs_iterations {
                joints.solve(bodies, pass);
                contacts.solve(bodies, pass);
                multibodies.solve(bodies, pass);
            }
            self.enter(Entry::Correction, bodies, pass);
            let Self { joints, contacts, multibodies, .. } = self;
            bodies.integrate_positions(pass);
            joints.correct_poses(bodies, pass.substep);
            multibodies.integrate_positions(input, bodies, pass);
            bodies.turn_uneven(pass.simd);
            contacts.follow(bodies, pass);
            for pass in pass.relaxations() {
                joints.relax(bodies, &pass);
                contacts.relax(bodies, &pass);
                multibodies.relax(bodies, &pass);
            }
            self.enter(Entry::End, bodies, pass);
        }
        limited
    }

    /// Integrates velocities, and begins a substep with the impulses of the last one. Returns the number of
    /// bodies that were limited to the largest speed.
    fn begin_substep(
        &mut self,
        is_first: bool,
        input: SolverInput<'_>,
        bodies: &mut SolverBodies,
        pass: &SolverPass<'_>,
    ) -> usize {
        let Self { joints, contacts, multibodies, impacts, .. } = self;
        multibodies.note_velocities(if is_first { &mut bodies.before } else { &mut bodies.states });
        let keep_last = !impacts.is_empty();
        let limited = bodies.integrate_velocities(is_first, keep_last, pass);
        multibodies.integrate_velocities(is_first, input.world, bodies, pass);
        joints.begin_substep(bodies, pass);
        contacts.begin_substep(pass);
        limited
    }

    /// Makes an entry in the ledger of energy, and takes back impulses that exceed the bound.
    fn enter(&mut self, entry: Entry, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        let Self { joints, contacts, ledger, .. } = self;
        if !ledger.is_active() {
            return;
        }
        if ledger.needs_drives(entry) {
            joints.note_drives(ledger, bodies);
        }
        if ledger.enter(entry, bodies, pass) {
            joints.limit(ledger, entry, bodies);
            contacts.limit(ledger, entry, bodies);
        }
    }

    /// Opens the accounts of islands whose energy the impulses of this step must not increase.
    fn open_ledger(
        &mut self,
        members: &[RigidBodyHandle],
        links: &Links,
        world: &RigidBodySet,
        bodies: &SolverBodies,
        pass: &SolverPass<'_>,
    ) {
        let Self { joints, contacts, ledger, .. } = self;
        ledger.clear();
        if joints.len() == 0 && !contacts.has_deep_overlap() {
            return;
        }
        ledger.begin(bodies);
        joints.note_in(ledger, bodies);
        contacts.note_in(ledger, bodies, pass);
        let of_links = members.iter().filter(|body| links.moves(body.into_raw_parts().0));
        of_links.for_each(|&link| ledger.leave_out(world[link].link.island));
        ledger.open(bodies);
    }

    /// Stores impulses of contacts and joints, and breaks overloaded joints.
    fn store_impulses(&mut self, output: &mut ImpulseOutput<'_>) {
        let Self { joints, contacts, multibodies, impacts, .. } = self;
        impacts.restore(contacts);
        contacts.store(output);
        joints.store(output);
        multibodies.store_impulses(output);
    }
}
