//! From bodies to the places that the solver knows them by: once per step, on several threads.

use super::motion::Motion;
use super::{BODIES_PER_TASK, SolverBodies, TURNS_AHEAD, WORLD};
use crate::base::arena::SharedArena;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::dim::math::{Real, Vector};
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet, RigidBodyType};
use crate::model::island::NONE;
use crate::model::params::IntegrationParameters;
use crate::step::solver::groups::Groups;
use crate::step::solver::multibodies::SolverMultibodies;
use core::ops::Range;

impl SolverBodies {
    /// Gathers all awake bodies; those that multibodies move have a place and nobody in it.
    pub fn load(
        &mut self,
        groups: &Groups,
        bodies: &mut RigidBodySet,
        multibodies: &SolverMultibodies,
        (gravity, params): (Vector, &IntegrationParameters),
        tasks: Tasks<'_>,
    ) {
        self.make_room(groups.order().len(), bodies.slot_count());
        let order = groups.order();
        let around = Around { bodies: bodies.share(), multibodies, gravity, params };
        let spectators = 0..groups.spectators();
        self.load_members(order, spectators, &around, params.dt, tasks);
        for group in groups.iter() {
            let h = params.dt / group.substeps as Real;
            self.load_members(order, group.members.clone(), &around, h, tasks);
        }
    }

    /// Makes places for some bodies, who fill all of them, and for the world.
    fn make_room(&mut self, count: usize, slot_count: usize) {
        for slot in self.listed.drain(..).filter(|&slot| slot != NONE) {
            self.indices[slot as usize] = WORLD;
        }
        self.indices.resize(slot_count.max(self.indices.len()), WORLD);
        self.listed.resize(count + 1, NONE);
        self.poses.resize(count + 1, BodyPose::WORLD);
        self.states.resize(count + 1, BodyState::default());
        self.before.resize(count + 1, BodyState::default());
        self.motions.resize(count + 1, Motion::AT_REST);
        self.shares.resize(count + 1, 1.0);
        self.islands.resize(count + 1, NONE);
        // SAFETY: a place is there, and nobody else has any.
        unsafe { self.places().fill(0, NONE, Place::NOBODY) };
    }

    pub(super) fn places(&mut self) -> Places<'_> {
        Places {
            listed: DisjointMut::new(&mut self.listed),
            indices: DisjointMut::new(&mut self.indices),
            poses: DisjointMut::new(&mut self.poses),
            states: DisjointMut::new(&mut self.states),
            before: DisjointMut::new(&mut self.before),
            motions: DisjointMut::new(&mut self.motions),
            shares: DisjointMut::new(&mut self.shares),
            islands: DisjointMut::new(&mut self.islands),
        }
    }

    fn load_members(
        &mut self,
        order: &[RigidBodyHandle],
        members: Range<usize>,
        around: &Around<'_>,
        h: Real,
        tasks: Tasks<'_>,
    ) {
        let places = self.places();
        tasks.par_for(members.len(), BODIES_PER_TASK, |range| {
            for position in members.start + range.start..members.start + range.end {
                if let Some(later) = order.get(position + TURNS_AHEAD) {
                    around.bodies.prefetch(later.into_raw_parts().0);
                }
                let handle = order[position];
                // SAFETY: the order names each body once, and places are as many as bodies and one.
                unsafe {
                    let place = match around.bodies.get_mut(handle.0) {
                        Some(body) => Place::of(body, handle, around, h),
                        None => Place::NOBODY,
                    };
                    places.fill(position + 1, handle.into_raw_parts().0, place);
                }
            }
        });
    }
}

/// What bodies are loaded from.
struct Around<'a> {
    bodies: SharedArena<'a, RigidBody>,
    multibodies: &'a SolverMultibodies,
    gravity: Vector,
    params: &'a IntegrationParameters,
}

/// What [`SolverBodies`] knows of one body.
struct Place {
    /// [`READ_ONLY`] unless constraints may move the body; none for nobody, who is not found by a slot.
    flags: Option<u32>,
    pose: BodyPose,
    state: BodyState,
    motion: Motion,
    share: Real,
    island: u32,
}

impl Place {
    const NOBODY: Self = Self {
        flags: None,
        pose: BodyPose::WORLD,
        state: BodyState::AT_REST,
        motion: Motion::AT_REST,
        share: 1.0,
        island: NONE,
    };

    /// `h` is the substep with which the body is solved.
    fn of(body: &mut RigidBody, handle: RigidBodyHandle, around: &Around<'_>, h: Real) -> Self {
        if around.multibodies.moves(handle.into_raw_parts().0) {
            return Self::NOBODY;
        }
        if body.body_type == RigidBodyType::KinematicPositionBased {
            let velocity = body.velocity_to_next_position(around.params.inv_dt());
            (body.linvel, body.angvel) = (velocity.linvel, velocity.angvel);
        }
        let share = if body.substep > h { h / body.substep } else { 1.0 };
        body.substep = h;
        let motion = if body.is_dynamic() {
            Motion::of(body, around.gravity, h)
        } else {
            Motion { rotation: body.pose.rotation, ..Motion::AT_REST }
        };
        let mprops = &body.mprops;
        let (inv_mass, inv_inertia) = (mprops.inv_mass, &mprops.inv_inertia);
        // Colours keep constraints apart at bodies with an island, and at no others.
        let writable = body.link.island != NONE;
        Self {
            flags: Some(if writable { 0 } else { READ_ONLY }),
            pose: BodyPose::new(body.pose.rotation, mprops.world_com, inv_mass, inv_inertia),
            state: BodyState::new(body.linvel, body.angvel),
            motion,
            share,
            island: body.link.island,
        }
    }
}

/// The places of all bodies, to be filled by several threads.
pub(super) struct Places<'a> {
    listed: DisjointMut<'a, u32>,
    indices: DisjointMut<'a, u32>,
    poses: DisjointMut<'a, BodyPose>,
    pub states: DisjointMut<'a, BodyState>,
    pub before: DisjointMut<'a, BodyState>,
    pub motions: DisjointMut<'a, Motion>,
    shares: DisjointMut<'a, Real>,
    islands: DisjointMut<'a, u32>,
}

impl Places<'_> {
    /// Fills the place with an index; the body stands in `slot`.
    ///
    /// # Safety
    /// The index must be one of a place, and nobody else may use this place or slot meanwhile.
    unsafe fn fill(&self, index: usize, slot: u32, place: Place) {
        // SAFETY: the caller's promise; a known body's slot has an index.
        unsafe {
            *self.listed.get_mut(index) = if place.flags.is_some() { slot } else { NONE };
            if let Some(flags) = place.flags {
                *self.indices.get_mut(slot as usize) = index as u32 | flags;
            }
            *self.poses.get_mut(index) = place.pose;
            *self.states.get_mut(index) = place.state;
            *self.before.get_mut(index) = place.state;
            *self.motions.get_mut(index) = place.motion;
            *self.shares.get_mut(index) = place.share;
            *self.islands.get_mut(index) = place.island;
        }
    }
}
