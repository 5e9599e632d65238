//! Multibodies in the solver: their own substeps, in the same passes as those of ordinary bodies.
//!
//! Links are in the list of awake bodies, but have no state in [`SolverBodies`](super::bodies::SolverBodies),
//! and the lanes exclude their manifolds. An impulse on one link moves all of its multibody, so no two of
//! their constraints could have one colour. Contacts of links are solved here one after the other, behind the
//! colours, in the order of the constraint graph; all other rows together (`system.rs`).
//!
//! Multibodies warm-start a substep as bodies do, without an iteration: the effect of the impulses on the
//! generalised velocities is stored ([`Moving::pushed`]) and added.

mod impacts;
mod contacts;
mod force_rows;
mod gears;
mod limits;
mod load;
mod loops;
mod rows;
mod sides;
mod store;
mod system;

use super::bodies::SolverBodies;
use super::context::{SolverInput, SolverPass};
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::dim::math::{Pose, Real};
use crate::dim::state::BodyState;
use crate::model::body::RigidBodySet;
use crate::model::constraint_graph::ManifoldRef;
use crate::model::multibody::{LinkTravel, Multibody, MultibodyIndex, MultibodyJoint};
use crate::model::params::{ContactPass, Softness};
use crate::multibody::Motion;
use contacts::LinkContacts;
use gears::Gears;
use impacts::BeforeImpact;
use limits::JointRows;
use loops::Loops;
use rows::{ConstrainedStates, JacobianPool};
use system::RowSystem;

/// Number of multibodies per parallel task (some ten microseconds).
const MULTIBODIES_PER_TASK: usize = 2;

/// A multibody that is awake. It is moved out of its set while the solver runs.
#[derive(Debug, Default)]
pub(super) struct Moving {
    index: MultibodyIndex,
    /// The island of its links.
    island: u32,
    multibody: Multibody,
    motion: Motion,
    /// The fraction of the last impulses with which it begins.
    fraction: Real,
    /// Effect of this substep's impulses on the generalised velocities.
    pushed: Vec<Real>,
    /// The same impulses on the root's degrees of freedom.
    root_pushed: Vec<Real>,
    /// Displacement of the degrees of freedom since the step began.
    shift: Vec<Real>,
    /// By link: its motion since the step began.
    travel: Vec<LinkTravel>,
    before_impact: BeforeImpact,
    /// Whether it has contacts.
    touches: bool,
    /// Whether links rotate so far in a step that contacts must be updated in each substep. Without contacts
    /// there is no update: free motion conserves momentum.
    turns_far: bool,
    /// The energy that impacts have added in this substep, and the work of what drives the links: see
    /// [`SolverMultibodies::add_work`].
    work: Real,
    /// Whether the balance of its energy exceeds the bound.
    has_gained: bool,
    /// The fraction of the impulses with which the next substep starts.
    kept: Real,
    /// The joints and the root's pose when the step began.
    start: (Vec<MultibodyJoint>, Pose),
}

/// A link of a multibody that is solved now.
#[derive(Copy, Clone, Debug)]
struct LinkPlace {
    multibody: usize,
    link: usize,
    is_moved: bool,
}

/// The awake multibodies of a group.
#[derive(Default)]
pub(super) struct SolverMultibodies {
    moving: Vec<Moving>,
    /// Buffers of those that were awake before.
    spare: Vec<Moving>,
    /// By body slot: the link that is there.
    places: Vec<Option<LinkPlace>>,
    /// The slots where there is one, to be cleared by the next step.
    listed: Vec<u32>,
    /// The manifolds of the contacts below.
    manifolds: Vec<ManifoldRef>,
    jacobians: JacobianPool,
    joints: JointRows,
    gears: Gears,
    system: RowSystem,
    loops: Loops,
    contacts: LinkContacts,
}

/// The impulse of a unilateral row (`dim3/contact/mod.rs`), given `Ċ`, `C`, `1/K` and the impulse so far.
fn solve_unilateral(
    pass: &ContactPass,
    velocity: Real,
    separation: Real,
    mass: Real,
    impulse: Real,
    bias: bool,
) -> Real {
    if separation > 0.0 {
        return (impulse - mass * (velocity + separation * pass.inv_substep)).max(0.0);
    }
    if !bias {
        return (impulse - mass * velocity).max(0.0);
    }
    let Softness { bias_rate, mass_scale, impulse_scale } = pass.softness;
    let error = (separation + pass.allowed_error).min(0.0);
    let opening = (error * bias_rate * mass_scale).max(-pass.push_velocity_max);
    (impulse - mass * (velocity * mass_scale + opening) - impulse * impulse_scale).max(0.0)
}

impl SolverMultibodies {
    /// Returns whether there are no multibodies.
    pub fn is_empty(&self) -> bool {
        self.moving.is_empty()
    }

    /// Returns whether one of these bodies is a link that is moved now.
    fn solves_one_of(&self, slots: [u32; 2]) -> bool {
        slots.into_iter().any(|slot| self.place(slot).is_some_and(|place| place.is_moved))
    }

    fn place(&self, slot: u32) -> Option<LinkPlace> {
        self.places.get(slot as usize).copied().flatten()
    }

    /// Makes the constraints, with the manifolds of links in the order of the constraint graph.
    pub fn prepare(
        &mut self,
        manifolds: &[ManifoldRef],
        input: SolverInput<'_>,
        bodies: &mut SolverBodies,
        pass: &SolverPass<'_>,
    ) {
        self.jacobians.clear();
        self.system.reset(self.moving.len());
        self.joints.prepare(&mut self.jacobians, &mut self.moving, pass.substep);
        self.gears.prepare(&mut self.jacobians, &mut self.moving, pass.joints.softness.bias_rate);
        self.prepare_loops(input, bodies, &pass.joints);
        self.prepare_contacts(manifolds, input, bodies);
        self.lock_loops(input, bodies);
    }

    /// Applies the last step's impulses to all multibodies.
    pub fn warm_start(&mut self, bodies: &mut SolverBodies) {
        let Self { jacobians, joints, gears, contacts, moving, .. } = self;
        let mut states = ConstrainedStates { multibodies: moving, states: &mut bodies.states };
        joints.warm_start(jacobians, &mut states);
        gears.warm_start(jacobians, &mut states);
        contacts.warm_start(jacobians, &mut states);
        self.warm_loops(bodies, 1.0);
    }

    /// Applies gravity, forces, springs and dampers, and warm-starts the substep.
    pub fn integrate_velocities(
        &mut self,
        is_first: bool,
        world: &RigidBodySet,
        bodies: &mut SolverBodies,
        pass: &SolverPass<'_>,
    ) {
        if !is_first {
            self.follow_loops(world, bodies);
        }
        let &SolverPass { params, substep, .. } = pass;
        let (warm_start_coefficient, speed_max) =
            (params.warmstart_coefficient, params.max_linear_velocity());
        for_each(&mut self.moving, pass.tasks, |moving| {
            moving.pushed.iter_mut().for_each(|pushed| *pushed *= warm_start_coefficient);
            moving.motion.accelerate(&mut moving.multibody, substep, speed_max, &moving.pushed);
            moving.turns_far = moving.touches && moving.motion.turns_far(params.dt);
            moving.work = 0.0;
            moving.add_pushed(1.0);
            moving.root_pushed.iter_mut().for_each(|impulse| *impulse *= warm_start_coefficient);
            moving.motion.note_external_impulse(&moving.root_pushed, 1.0);
        });
        if warm_start_coefficient != 1.0 {
            self.scale_impulses(|_| warm_start_coefficient);
        }
    }

    /// Moves all links by their velocities, and updates the rows that this changes.
    pub fn integrate_positions(
        &mut self,
        input: SolverInput<'_>,
        bodies: &mut SolverBodies,
        pass: &SolverPass<'_>,
    ) {
        let (h, speed_max) = (pass.substep, pass.params.max_linear_velocity());
        for_each(&mut self.moving, pass.tasks, |moving| moving.advance(h, speed_max));
        let mut states =
            ConstrainedStates { multibodies: &mut self.moving, states: &mut bodies.states };
        self.joints.follow_balls(&mut self.jacobians, &mut states);
        self.follow_contacts(input, bodies);
    }

    /// Solves all constraints once, with bias.
    pub fn solve(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        if self.is_empty() {
            return;
        }
        self.iterate(bodies, pass, true);
    }

    /// Solves all constraints once, without bias and with friction.
    pub fn relax(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        if self.is_empty() {
            return;
        }
        self.iterate(bodies, pass, false);
        let Self { jacobians, joints, loops, contacts, moving, .. } = self;
        let mut states = ConstrainedStates { multibodies: moving, states: &mut bodies.states };
        contacts.solve_friction(jacobians, &mut states);
        if pass.contacts.is_last_iteration {
            joints.count();
            loops.count();
            contacts.count();
            self.limit_energy(&mut bodies.states);
        }
    }

    /// Removes the energy that the impulses of a substep added to multibodies. The work of motors, loop
    /// joints, moving bodies and moving surfaces is excluded.
    fn limit_energy(&mut self, states: &mut [BodyState]) {
        self.add_work(states);
        for moving in &mut self.moving {
            moving.has_gained = !moving.settle();
        }
        if self.moving.iter().any(|moving| moving.has_gained) {
            self.moving.iter_mut().for_each(Moving::remove_excess);
            self.scale_impulses(|moving| moving.kept);
        }
    }

    /// Scales the impulses with which the next substep starts, by the least factor of the multibodies of each
    /// row.
    fn scale_impulses(&mut self, factor: impl Fn(&Moving) -> Real) {
        let Self { joints, gears, loops, contacts, moving, .. } = self;
        joints.scale_impulses(|row| row.least_of(moving, &factor));
        gears.scale_impulses(|row| row.least_of(moving, &factor));
        loops.scale_impulses(|row| row.least_of(moving, &factor));
        contacts.scale_impulses(|row| row.least_of(moving, &factor));
    }

    /// Adds the work of motors and other joints, and of bodies and surfaces that push links.
    fn add_work(&mut self, states: &mut [BodyState]) {
        let Self { jacobians, joints, loops, contacts, moving, .. } = self;
        let mut states = ConstrainedStates { multibodies: moving, states };
        for (row, impulse) in joints.working_rows().chain(loops.rows()) {
            jacobians.note_work(row, impulse, &mut states);
        }
        for (row, impulse, surface) in contacts.rows() {
            jacobians.note_shove(row, impulse, surface, &mut states);
        }
    }

    /// Returns whether a multibody has links that rotate far.
    fn any_turns_far(&self) -> bool {
        self.moving.iter().any(|moving| moving.turns_far)
    }

    /// Visits all rows but those of friction.
    fn iterate(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>, bias: bool) {
        let Self { jacobians, joints, gears, system, loops, contacts, moving, .. } = self;
        let mut states = ConstrainedStates { multibodies: moving, states: &mut bodies.states };
        system.clear(bias);
        joints.add_to(system, jacobians, &states, &pass.joints, bias);
        gears.add_to(system, jacobians, &states, bias);
        loops.add_to(system, jacobians, &states, bias);
        system.solve(jacobians, &mut states);
        let mut solved = system.rows.iter();
        joints.take_from(&mut solved);
        gears.take_from(&mut solved);
        loops.take_from(&mut solved);
        contacts.solve(jacobians, &mut states, &pass.contacts, bias);
    }
}

impl Moving {
    /// Adds the energy gain of the substep to the balance. Returns whether that stays within its bound.
    fn settle(&mut self) -> bool {
        let is_pushed = self.pushed.iter().any(|&rate| rate != 0.0);
        // Contacts do work on links that a root carries along.
        let is_exempt = self.touches && self.motion.is_carried();
        is_exempt || self.motion.settle(&mut self.multibody, is_pushed, self.work)
    }

    /// Removes the energy that impulses gave. The impulses that did will be less in the next substep.
    fn remove_excess(&mut self) {
        self.kept = 1.0;
        if self.has_gained {
            self.kept = self.motion.remove_excess(self.touches);
            debug_assert!(self.kept <= 1.0 || self.kept.is_nan(), "removal adds nothing");
            self.pushed.iter_mut().for_each(|rate| *rate *= self.kept);
            self.root_pushed.iter_mut().for_each(|impulse| *impulse *= self.kept);
        }
    }

    /// Adds this fraction of the effect of the substep's impulses so far.
    fn add_pushed(&mut self, fraction: Real) {
        for (rate, pushed) in self.motion.rates.iter_mut().zip(&self.pushed) {
            *rate += pushed * fraction;
        }
    }

    fn advance(&mut self, h: Real, speed_max: Real) {
        let Self { motion, multibody, shift, travel, .. } = self;
        motion.advance(multibody, h, speed_max, |motion, piece| {
            for (shift, rate) in shift.iter_mut().zip(motion.rates.iter()) {
                *shift += rate * piece;
            }
            store::note_travel(travel, motion.link_velocities(), piece);
        });
        self.turns_far |= self.touches && motion.has_diverged;
    }
}

/// Works on the multibodies, several at once. They are independent of each other.
fn for_each(moving: &mut [Moving], tasks: Tasks<'_>, work: impl Fn(&mut Moving) + Sync) {
    let count = moving.len();
    let moving = DisjointMut::new(moving);
    tasks.par_for(count, MULTIBODIES_PER_TASK, |range| {
        for position in range {
            // SAFETY: each position is in one range, and below the count.
            work(unsafe { moving.get_mut(position) });
        }
    });
}
