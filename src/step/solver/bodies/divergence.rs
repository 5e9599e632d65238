//! Divergence check: tests whether all states are storable before the first one is stored.
//!
//! A sum that overflows is infinite or NaN, and that spreads: one pass later, all touching bodies
//! have no finite state either. Such a state never becomes finite again. One check after all passes, before
//! the first body is stored, is therefore sufficient.
//!
//! The check is cheap: it compares each number of the states with [`MODERATE_MAX`], in memory order. If a
//! number is larger, or a body is so far away that a moderate motion could leave the world, each body is
//! checked.

use super::SolverBodies;
use super::store::outcome;
use crate::base::measure::MODERATE_MAX;
use crate::base::tasks::Tasks;
use crate::dim::state::BodyState;
use crate::model::body::{RigidBody, RigidBodySet, RigidBodyType, RigidBodyVelocity};
use crate::step::notes::Diverged;
use crate::step::solver::groups::Groups;
use crate::step::solver::links::Links;
use core::sync::atomic::{AtomicBool, Ordering};

/// Number of states per parallel task (a microsecond or two).
const STATES_PER_TASK: usize = 1024;

impl SolverBodies {
    /// Returns whether the velocities and displacements of all moved bodies are moderate.
    pub fn are_moderate(&self, tasks: Tasks<'_>) -> bool {
        let is_moderate = AtomicBool::new(true);
        for members in self.moving.clone() {
            let states = &self.states[members];
            tasks.par_for(states.len(), STATES_PER_TASK, |range| {
                if !BodyState::are_within(&states[range], MODERATE_MAX) {
                    is_moderate.store(false, Ordering::Relaxed);
                }
            });
        }
        is_moderate.into_inner()
    }

    /// Lists the bodies that were moved and cannot be stored.
    pub fn find_diverged(
        &self,
        groups: &Groups,
        links: &Links,
        world: &RigidBodySet,
        diverged: &mut Vec<Diverged>,
    ) {
        for index in self.moving.clone().into_iter().flatten() {
            let handle = groups.order()[index - 1];
            let Some(body) = world.get(handle) else { continue };
            if links.moves(handle.into_raw_parts().0) || self.can_be_stored(index, body) {
                continue;
            }
            let (linvel, angvel) = self.states[index].velocity();
            let velocity = RigidBodyVelocity::new(linvel, angvel);
            diverged.push(Diverged { body: handle, velocity, is_link: false });
        }
    }

    fn can_be_stored(&self, index: usize, body: &RigidBody) -> bool {
        let (state, motion) = (&self.states[index], &self.motions[index]);
        let (linvel, angvel) = state.velocity();
        match body.body_type {
            RigidBodyType::KinematicPositionBased => {
                RigidBodyVelocity::new(linvel, angvel).is_usable()
            }
            _ => outcome(body, state, motion).is_some(),
        }
    }
}
