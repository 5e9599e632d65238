//! Groups of islands, and their numbers of substeps.
//!
//! The load that a contact transfers in an iteration is limited by the lighter of two bodies. Under a body
//! `r` times as heavy, a contact carries `r` times the load for which it is stiff, and penetrates by `r σ g
//! h² / β` ([`Softness`](crate::model::params::Softness)). More iterations per substep do not help: the
//! residual after one is nearly the whole, 1 - 1/r. A harder contact is unstable. But the penetration
//! decreases with the square of the substep `h`, as everything in a soft step. Islands in which light bodies
//! carry heavy ones therefore get more substeps, without cost for other islands. Groups of islands are solved
//! in sequence, each with its own `h`.
//!
//! Joints that connect light bodies to heavy ones need more substeps for another reason. Under a load `M g`
//! with moment arm `r`, a link of mass `m` and inertia `I` vibrates with `ω² = M g r / (I + m r²)`. The
//! solver does not recover from a substep in which the link rotates too far
//! (`joints/geometric_stiffness.rs`). So `(h ω)²` is kept below [`GEOMETRIC_STIFFNESS_MAX`]. A chain under
//! 1000 times the mass of a link gets twice the usual substeps at 30 steps a second. At 60 it gets the usual
//! number.
//!
//! Tall stacks and those of thin bodies get more substeps for the same reason ([`Stack`]).
//!
//! Four cubes under one of 1000 times the mass sink in by 0.8 m with 4 substeps, by 34 mm with 16 and by 10
//! mm with 32. Two alternatives were rejected. A direct solution of loaded contacts fails because these
//! change within a substep. Supporting bodies with increased masses fall incorrectly.

use crate::base::tasks::{Gather, Tasks};
use crate::dim::joint::inertia_about;
use crate::dim::joint_axes::JointAxesMask;
use crate::dim::math::{Real, Vector};
use crate::model::body::{BODIES_PER_TASK, RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::contact::NarrowPhase;
use crate::model::island::{IslandManager, NONE, StepPace};
use crate::model::joint::ImpulseJointSet;
use crate::model::params::IntegrationParameters;
use crate::step::solver::context::{SolverInput, SolverSettings};
use crate::step::solver::stacks::{Give, Member, Stack};
use core::ops::Range;

/// Up to this ratio of masses the usual substeps are sufficient: four cubes under one of 30 times the mass
/// sink in by 15 mm.
const MASS_RATIO_MODERATE_MAX: Real = 32.0;
/// Largest factor on the usual number of substeps of an island.
const SUBSTEP_FACTOR_MAX: usize = 16;
/// Largest factor on the usual number of substeps of an island for its joints.
const JOINT_SUBSTEP_FACTOR_MAX: usize = 32;
/// Largest factor on the usual number of substeps of an island for its stack.
const STACK_SUBSTEP_FACTOR_MAX: usize = 32;
/// Largest product of the factor and the number of bodies of an island: a load on a large heap rests on many
/// bodies.
const BODY_SUBSTEPS_MAX: usize = 1024;
/// The largest `(h ω)²` with which light links swing under a heavy load. A chain of 20 links holds at 0.51,
/// under any load, and comes apart at 0.8.
const GEOMETRIC_STIFFNESS_MAX: Real = 0.55;

/// Bodies that are solved together.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// Range in [`Groups::order`].
    pub members: Range<usize>,
    pub substeps: usize,
}

/// Requirements of an island.
#[derive(Copy, Clone, Debug)]
struct IslandRequirement {
    /// Masses of the lightest and the heaviest of the bodies that touch another.
    masses: [Real; 2],
    /// The same for bodies that joints hold.
    joined: [Real; 2],
    /// The largest `r / (I + m r²)` of these: the angular acceleration by a unit force.
    acceleration_per_force: Real,
    /// Additional substeps that its bodies request.
    extra: usize,
    /// Its resting bodies as a stack.
    stack: Option<Stack>,
}

impl IslandRequirement {
    const NOTHING: Self = {
        let none = [Real::INFINITY, 0.0];
        Self { masses: none, joined: none, acceleration_per_force: 0.0, extra: 0, stack: None }
    };

    /// Includes a body that touches another.
    fn include(&mut self, mass: Real) {
        include(&mut self.masses, mass);
    }

    /// Includes a body that a joint holds at this distance from its centre of mass.
    fn include_joined(&mut self, body: &RigidBody, arm: Real) {
        let Some(mass) = mass(body) else { return };
        include(&mut self.joined, mass);
        if let Some(inertia) = inertia_about(&body.mprops.inv_inertia) {
            self.acceleration_per_force =
                self.acceleration_per_force.max(arm / (inertia + mass * arm * arm));
        }
    }

    /// Returns whether the masses of touching bodies are within [`MASS_RATIO_MODERATE_MAX`].
    fn has_moderate_mass_ratio(&self) -> bool {
        let [lightest, heaviest] = self.masses;
        heaviest <= MASS_RATIO_MODERATE_MAX * lightest
    }

    /// The factor on the usual number of substeps for an island of this size. It is a power of two, so
    /// there are few groups.
    fn factor(
        &self,
        bodies: usize,
        usual: usize,
        gravity: Real,
        params: &IntegrationParameters,
        pace: StepPace,
    ) -> usize {
        let h = params.dt / usual as Real;
        let last_h = pace.last / usual as Real;
        let give = Give::new(params, gravity, h, h * pace.reference_ratio);
        let ([lightest, heaviest], [least, most]) = (self.masses, self.joined);
        let is_ratio_large = most > MASS_RATIO_MODERATE_MAX * least;
        let stiffness =
            if is_ratio_large { h * h * most * gravity * self.acceleration_per_force } else { 0.0 };
        let mut factor = 1;
        while 2 * factor * bodies <= BODY_SUBSTEPS_MAX {
            let square = (factor * factor) as Real;
            let by_contacts = factor < SUBSTEP_FACTOR_MAX
                && heaviest > MASS_RATIO_MODERATE_MAX * lightest * square;
            let by_joints =
                factor < JOINT_SUBSTEP_FACTOR_MAX && stiffness > GEOMETRIC_STIFFNESS_MAX * square;
            let by_stack = factor < STACK_SUBSTEP_FACTOR_MAX
                && self.stack.is_some_and(|stack| stack.is_soft(factor, give, last_h));
            if !by_contacts && !by_joints && !by_stack {
                break;
            }
            factor *= 2;
        }
        factor
    }
}

fn include([lightest, heaviest]: &mut [Real; 2], mass: Real) {
    (*lightest, *heaviest) = (lightest.min(mass), heaviest.max(mass));
}

/// Contact requirements of a body, stored contiguously because access is random.
#[derive(Copy, Clone, Debug)]
struct BodyRequirement {
    island: u32,
    mass: Option<Real>,
    /// Additional substeps that the body requests.
    extra: usize,
}

impl BodyRequirement {
    const NONE: Self = Self { island: NONE, mass: None, extra: 0 };

    fn of(body: &RigidBody) -> Self {
        let extra = body.additional_solver_iterations;
        Self { island: body.link.island, mass: mass(body), extra }
    }
}

/// All awake bodies, in groups.
#[derive(Default)]
pub(super) struct Groups {
    /// First come bodies that belong to no island, if there are several groups: any constraint may read
    /// them. Then the members of each group.
    order: Vec<RigidBodyHandle>,
    groups: Vec<Group>,
    /// By island.
    requirements: Vec<IslandRequirement>,
    /// By dynamic body, in the order of the awake list.
    body_requirements: Vec<BodyRequirement>,
    /// The same by body slot. Filled only while requirements are found.
    by_slot: Vec<BodyRequirement>,
    /// Of one island, while its stack is measured.
    members: Vec<Member>,
    /// Substeps of each island, then those that occur.
    substeps: Vec<usize>,
    counts: Vec<usize>,
    gather: Gather<BodyRequirement>,
}

impl Groups {
    /// The bodies in the order in which the solver has them.
    pub fn order(&self) -> &[RigidBodyHandle] {
        &self.order
    }

    pub fn iter(&self) -> impl ExactSizeIterator<Item = &Group> {
        self.groups.iter()
    }

    /// Number of groups.
    pub fn len(&self) -> usize {
        self.groups.len()
    }

    /// The group at a position.
    pub fn get(&self, position: usize) -> &Group {
        &self.groups[position]
    }

    /// The number of bodies before the groups.
    pub fn ungrouped(&self) -> usize {
        self.groups.first().map_or(0, |group| group.members.start)
    }

    /// Divides the awake bodies.
    pub fn divide(&mut self, input: SolverInput<'_>, settings: &SolverSettings<'_>) {
        let &SolverSettings { gravity, params, pace, tasks, .. } = settings;
        let SolverInput { world: bodies, narrow_phase, joints, islands } = input;
        self.order.clear();
        self.groups.clear();
        // Nothing is solved: contacts and lanes stay as they are.
        if islands.awake.is_empty() {
            return;
        }
        self.read_bodies(islands, bodies, tasks);
        self.requirements.clear();
        self.requirements.resize(islands.island_bound() as usize, IslandRequirement::NOTHING);
        self.find_stacks(islands, bodies, gravity);
        if !self.are_all_alike() {
            self.find_requirements(islands, bodies.slot_count(), narrow_phase);
            self.find_requirements_of_joints(islands, bodies, joints);
        }
        self.find_substeps(islands, gravity.length(), params, pace);
        if self.counts.iter().all(|&substeps| substeps == params.num_solver_iterations) {
            self.order.extend_from_slice(&islands.awake);
            let members = 0..self.order.len();
            return self.groups.push(Group { members, substeps: params.num_solver_iterations });
        }
        self.order.extend_from_slice(islands.awake.kinematic());
        for &substeps in &self.counts {
            let start = self.order.len();
            let all = islands.awake.dynamic().iter().zip(&self.body_requirements);
            let members = all.filter(|(_, body_requirement)| {
                self.substeps.get(body_requirement.island as usize) == Some(&substeps)
            });
            self.order.extend(members.map(|(handle, _)| handle));
            self.groups.push(Group { members: start..self.order.len(), substeps });
        }
        debug_assert_eq!(self.order.len(), islands.awake.len(), "each awake body has one place");
        debug_assert!(
            self.groups.is_sorted_by(|one, two| one.members.end == two.members.start),
            "groups have no common member"
        );
    }

    /// Reads each dynamic body once.
    fn read_bodies(&mut self, islands: &IslandManager, bodies: &RigidBodySet, tasks: Tasks<'_>) {
        let awake = islands.awake.dynamic();
        let read = |range: Range<usize>, body_requirements: &mut Vec<BodyRequirement>| {
            let all = awake[range].iter();
            body_requirements.extend(all.map(|&handle| {
                bodies.get(handle).map_or(BodyRequirement::NONE, BodyRequirement::of)
            }));
        };
        self.body_requirements.clear();
        self.gather.run(tasks, (awake.len(), BODIES_PER_TASK), read, &mut self.body_requirements);
    }

    /// Reads the bodies of islands whose size admits more substeps. Bodies held by joints or multibodies are
    /// not part of a stack: a chain hangs.
    fn find_stacks(&mut self, islands: &IslandManager, bodies: &RigidBodySet, gravity: Vector) {
        let Some(up) = (-gravity).try_normalize() else { return };
        let gravity = gravity.length();
        for (id, requirement) in self.requirements.iter_mut().enumerate() {
            let island = islands.island(id as u32);
            if island.sleeping || !(3..=BODY_SUBSTEPS_MAX / 2).contains(&island.bodies.len()) {
                continue;
            }
            let members = island.bodies.iter().filter_map(|&handle| bodies.get(handle));
            let free = members.filter(|body| {
                let slot = body.link.slot;
                islands.joints.of_body(slot).is_empty() && islands.groups.of(slot).is_empty()
            });
            self.members.clear();
            self.members.extend(free.filter_map(Member::of));
            requirement.stack = Stack::of(&self.members, gravity, up);
        }
    }

    /// Returns whether no body requests more substeps, and no body is much heavier than another.
    fn are_all_alike(&self) -> bool {
        let mut requirement = IslandRequirement::NOTHING;
        for body_requirement in &self.body_requirements {
            requirement.extra = requirement.extra.max(body_requirement.extra);
            body_requirement.mass.into_iter().for_each(|mass| requirement.include(mass));
        }
        requirement.extra == 0 && requirement.has_moderate_mass_ratio()
    }

    /// Finds the requirements of islands from touching bodies.
    fn find_requirements(
        &mut self,
        islands: &IslandManager,
        slot_count: usize,
        narrow_phase: &NarrowPhase,
    ) {
        // This writes new entries alone, so sleeping bodies are free.
        self.by_slot.resize(slot_count.max(self.by_slot.len()), BodyRequirement::NONE);
        let slots = islands.awake.dynamic().iter().map(|handle| handle.into_raw_parts().0 as usize);
        for (slot, body_requirement) in slots.clone().zip(&self.body_requirements) {
            if let Some(requirement) = self.requirements.get_mut(body_requirement.island as usize) {
                requirement.extra = requirement.extra.max(body_requirement.extra);
            }
            self.by_slot[slot] = *body_requirement;
        }
        let none = BodyRequirement::NONE;
        let at = |slot: u32| self.by_slot.get(slot as usize).unwrap_or(&none);
        for (_, manifolds) in islands.graph.in_solving_order() {
            for manifold in manifolds {
                let [one, other] = narrow_phase.contacts.bodies(manifold.pair).map(at);
                if one.island != NONE && other.island != NONE {
                    let requirement = &mut self.requirements[one.island as usize];
                    [one, other]
                        .iter()
                        .filter_map(|body_requirement| body_requirement.mass)
                        .for_each(|m| requirement.include(m));
                }
            }
        }
        slots.for_each(|slot| self.by_slot[slot] = BodyRequirement::NONE);
    }

    /// Finds the requirements of islands from bodies with joints.
    fn find_requirements_of_joints(
        &mut self,
        islands: &IslandManager,
        bodies: &RigidBodySet,
        joints: &ImpulseJointSet,
    ) {
        for &slot in islands.joint_graph.in_solving_order().flat_map(|(_, slots)| slots) {
            let joint = islands.joints.get(slot).and_then(|link| joints.get(link.handle));
            let Some(joint) = joint else { continue };
            let data = &joint.data;
            if !data.locked_axes.intersects(JointAxesMask::LIN_AXES) {
                continue;
            }
            let ends = [(joint.body1(), data.local_frame1), (joint.body2(), data.local_frame2)];
            for (handle, frame) in ends {
                let Some(body) = bodies.get(handle) else { continue };
                if let Some(requirement) = self.requirements.get_mut(body.link.island as usize) {
                    let arm = frame.translation - body.mprops.local_mprops.local_com;
                    requirement.include_joined(body, arm.length());
                }
            }
        }
    }

    /// Finds the substeps of each island with an awake body.
    fn find_substeps(
        &mut self,
        islands: &IslandManager,
        gravity: Real,
        params: &IntegrationParameters,
        pace: StepPace,
    ) {
        self.substeps.clear();
        self.counts.clear();
        for (id, requirement) in self.requirements.iter().enumerate() {
            let island = islands.island(id as u32);
            let usual = params.num_solver_iterations + requirement.extra;
            let factor = requirement.factor(island.bodies.len(), usual, gravity, params, pace);
            debug_assert!(usual > 0 && factor.is_power_of_two());
            self.substeps.push(usual * factor);
            if !island.bodies.is_empty() && !island.sleeping {
                self.counts.extend(self.substeps.last());
            }
        }
        self.counts.sort_unstable();
        self.counts.dedup();
    }
}

/// The mass of a body; `None` if it has none, or moves along no axis.
fn mass(body: &RigidBody) -> Option<Real> {
    let inverse = body.mprops.inv_mass.max_element();
    (inverse > 0.0).then(|| 1.0 / inverse)
}
