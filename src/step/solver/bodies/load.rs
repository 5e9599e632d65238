//! Gathers bodies into solver states: once per step, on several threads.

use super::motion::motion_of;
use super::{ImpulseFractions, NEAR_REST, SolverBodies, WORLD};
use crate::base::disjoint::DisjointMut;
use crate::base::measure::COORDINATE_MODERATE_MAX;
use crate::base::tasks::Tasks;
use crate::dim::math::{Real, Rotation, Vector, ang_length_squared};
use crate::dim::motion::{FreeMotion, is_uneven};
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::model::body::{EnergyError, RigidBody, RigidBodyHandle, RigidBodySet, RigidBodyType};
use crate::model::contact::AnchorFrame;
use crate::model::frozen::Frozen;
use crate::model::island::{NONE, StepPace};
use crate::model::params::IntegrationParameters;
use crate::step::solver::context::SolverSettings;
use crate::step::solver::groups::Groups;
use crate::step::solver::links::Links;
use core::ops::Range;
use core::sync::atomic::{AtomicBool, Ordering};

impl SolverBodies {
    /// Gathers all awake bodies. Links of multibodies have an index without a state.
    pub fn load(
        &mut self,
        groups: &Groups,
        links: &Links,
        bodies: &mut Frozen<'_, RigidBodySet>,
        settings: &SolverSettings<'_>,
    ) {
        let &SolverSettings { gravity, params, pace, tasks, .. } = settings;
        self.allocate(groups.order().len(), bodies.slot_count());
        let order = groups.order();
        let context = LoadContext { links, gravity, params, pace };
        let ungrouped = 0..groups.ungrouped();
        self.any_far = self.load_members(order, ungrouped, bodies, &context, params.dt, tasks);
        for group in groups.iter() {
            let h = params.dt / group.substeps as Real;
            let members = group.members.clone();
            self.any_far |= self.load_members(order, members, bodies, &context, h, tasks);
        }
        debug_assert!(
            self.impulse_fractions.iter().all(ImpulseFractions::are_fractions),
            "a step begins with at most the impulses of the last one"
        );
        self.any_scaled = self.impulse_fractions.iter().any(|it| it.of_contacts < 1.0);
        let uneven = self.uneven.iter().zip(&self.poses).enumerate().filter(|(_, (is, _))| **is);
        self.uneven_starts.clear();
        self.uneven_starts.extend(uneven.map(|(k, (_, pose))| (k as u32, pose.inv_inertia())));
        debug_assert!(self.indices.iter().all(|&index| self.has_state(index & !NEAR_REST)));
    }

    /// Allocates states for some bodies, which fill all of them, and for the world.
    fn allocate(&mut self, count: usize, slot_count: usize) {
        for slot in self.listed.drain(..).filter(|&slot| slot != NONE) {
            self.indices[slot as usize] = WORLD;
        }
        self.indices.resize(slot_count.max(self.indices.len()), WORLD);
        self.listed.resize(count + 1, NONE);
        self.poses.resize(count + 1, BodyPose::WORLD);
        self.states.resize(count + 1, BodyState::default());
        self.before.resize(count + 1, BodyState::default());
        self.motions.resize(count + 1, FreeMotion::at_rest(Rotation::IDENTITY));
        self.impulse_fractions.resize(count + 1, ImpulseFractions::ALL);
        self.uneven.resize(count + 1, false);
        self.islands.resize(count + 1, NONE);
        self.energy_errors.resize(count + 1, EnergyError::NONE);
        // SAFETY: the index is in range, and this task owns it exclusively.
        unsafe { self.places().at(0).clear() };
    }

    pub(super) fn places(&mut self) -> Places<'_> {
        Places {
            listed: DisjointMut::new(&mut self.listed),
            indices: DisjointMut::new(&mut self.indices),
            poses: DisjointMut::new(&mut self.poses),
            states: DisjointMut::new(&mut self.states),
            before: DisjointMut::new(&mut self.before),
            last: DisjointMut::new(&mut self.last),
            motions: DisjointMut::new(&mut self.motions),
            impulse_fractions: DisjointMut::new(&mut self.impulse_fractions),
            uneven: DisjointMut::new(&mut self.uneven),
            islands: DisjointMut::new(&mut self.islands),
            energy_errors: DisjointMut::new(&mut self.energy_errors),
        }
    }

    /// Loads the bodies of a range. Returns whether one of them is far from the origin.
    fn load_members(
        &mut self,
        order: &[RigidBodyHandle],
        members: Range<usize>,
        bodies: &mut Frozen<'_, RigidBodySet>,
        context: &LoadContext<'_>,
        h: Real,
        tasks: Tasks<'_>,
    ) -> bool {
        let (places, handles) = (self.places(), &order[members.clone()]);
        let any_far = AtomicBool::new(false);
        let fill = |position: usize, body: Option<&mut RigidBody>| {
            let slot = handles[position].into_raw_parts().0;
            let index = members.start + position + 1;
            // SAFETY: places are as many as bodies and one, and each position is visited once.
            unsafe {
                let place = places.at(index);
                match body {
                    Some(body) if !context.links.moves(slot) => {
                        if body.pose.translation.abs().max_element() > COORDINATE_MODERATE_MAX {
                            any_far.store(true, Ordering::Relaxed);
                        }
                        place.fill(body, context, h);
                        places.list(index, body, slot);
                    }
                    _ => place.clear(),
                }
            }
        };
        // SAFETY: the order names each body once.
        unsafe { bodies.visit(handles, tasks, fill) };
        any_far.into_inner()
    }
}

/// Context for loading bodies.
struct LoadContext<'a> {
    links: &'a Links,
    gravity: Vector,
    params: &'a IntegrationParameters,
    pace: StepPace,
}

/// The solver's data of one body, to be filled.
struct Place<'a> {
    pose: &'a mut BodyPose,
    state: &'a mut BodyState,
    before: &'a mut BodyState,
    motion: &'a mut FreeMotion,
    impulse_fractions: &'a mut ImpulseFractions,
    is_uneven: &'a mut bool,
    island: &'a mut u32,
    energy_error: &'a mut EnergyError,
}

impl Place<'_> {
    /// Marks the index as empty.
    fn clear(self) {
        *self.pose = BodyPose::WORLD;
        (*self.state, *self.before) = (BodyState::AT_REST, BodyState::AT_REST);
        *self.motion = FreeMotion::at_rest(Rotation::IDENTITY);
        (*self.impulse_fractions, *self.island) = (ImpulseFractions::ALL, NONE);
        (*self.is_uneven, *self.energy_error) = (false, EnergyError::NONE);
    }

    /// A body that is solved with the substep `h`.
    fn fill(self, body: &mut RigidBody, context: &LoadContext<'_>, h: Real) {
        if body.body_type == RigidBodyType::KinematicPositionBased {
            let velocity = body.velocity_to_next_position(context.params.inv_dt());
            (body.vels.linvel, body.vels.angvel) = (velocity.linvel, velocity.angvel);
        }
        let fraction = if body.substep > 0.0 { h / body.substep } else { 1.0 };
        *self.impulse_fractions = ImpulseFractions {
            of_joints: fraction.min(1.0),
            of_contacts: (fraction / body.reference_ratio).min(1.0),
        };
        (body.substep, body.reference_ratio) = (h, context.pace.reference_ratio);
        *self.motion = if body.is_dynamic() {
            motion_of(body, context.gravity, h)
        } else {
            FreeMotion::at_rest(body.pose.rotation)
        };
        let mprops = &body.mprops;
        *self.is_uneven = body.is_dynamic()
            && mprops.rotates_freely()
            && is_uneven(&mprops.local_mprops, body.vels.angvel, context.params.dt);
        let (center, inv_inertia) = (mprops.world_com, &mprops.inv_inertia);
        *self.pose = BodyPose::new(body.pose.rotation, center, mprops.inv_mass, inv_inertia);
        *self.state = BodyState::new(body.vels.linvel, body.vels.angvel);
        *self.before = *self.state;
        (*self.island, *self.energy_error) = (body.link.island, body.energy_error);
    }
}

/// The places of all bodies, to be filled by several threads.
pub(super) struct Places<'a> {
    listed: DisjointMut<'a, u32>,
    indices: DisjointMut<'a, u32>,
    poses: DisjointMut<'a, BodyPose>,
    pub states: DisjointMut<'a, BodyState>,
    pub before: DisjointMut<'a, BodyState>,
    /// As many, or none.
    pub last: DisjointMut<'a, BodyState>,
    pub motions: DisjointMut<'a, FreeMotion>,
    impulse_fractions: DisjointMut<'a, ImpulseFractions>,
    uneven: DisjointMut<'a, bool>,
    islands: DisjointMut<'a, u32>,
    energy_errors: DisjointMut<'a, EnergyError>,
}

impl Places<'_> {
    /// The place with an index.
    ///
    /// # Safety
    /// The index must be in range, and the caller must own it exclusively.
    unsafe fn at(&self, index: usize) -> Place<'_> {
        // SAFETY: the caller's promise.
        unsafe {
            Place {
                pose: self.poses.get_mut(index),
                state: self.states.get_mut(index),
                before: self.before.get_mut(index),
                motion: self.motions.get_mut(index),
                impulse_fractions: self.impulse_fractions.get_mut(index),
                is_uneven: self.uneven.get_mut(index),
                island: self.islands.get_mut(index),
                energy_error: self.energy_errors.get_mut(index),
            }
        }
    }

    /// Maps a slot to its body.
    ///
    /// # Safety
    /// As [`Self::at`], and the caller must own the slot, which must be that of a body, exclusively.
    unsafe fn list(&self, index: usize, body: &RigidBody, slot: u32) {
        // Colours keep constraints apart at bodies with an island, and at no others.
        let flags = if body.link.island == NONE { READ_ONLY } else { 0 };
        // SAFETY: the caller's promise.
        unsafe {
            let may_be_in_pile = self.motions.get(index).may_be_in_pile();
            let near_rest = may_be_in_pile
                && AnchorFrame::near_rest(ang_length_squared(body.vels.angvel), flags == 0);
            let flags = if near_rest { flags | NEAR_REST } else { flags };
            *self.listed.get_mut(index) = slot;
            *self.indices.get_mut(slot as usize) = index as u32 | flags;
        }
    }
}
