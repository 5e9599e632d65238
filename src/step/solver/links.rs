//! The links of awake multibodies, by the slots of their bodies.
//!
//! Links have no solver state, and multibodies solve the joints and contacts of links. The modules of
//! bodies, joints and contacts read this register to skip them, and do not depend on multibodies.

use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::frozen::Frozen;
use crate::model::island::NONE;
use crate::model::multibody::{Multibody, MultibodyJointSet};

/// The multibody of each link that the solver moves.
#[derive(Default)]
pub(super) struct Links {
    /// By body slot: the position of the multibody in its set, or [`NONE`]. Roots without degrees of freedom
    /// have none: they are ordinary bodies for the solver.
    owners: Vec<u32>,
    /// The slots of links, to be cleared by the next step.
    listed: Vec<u32>,
}

impl Links {
    /// Registers the links of all multibodies that are awake and act.
    pub fn register(&mut self, set: &mut Frozen<'_, MultibodyJointSet>, bodies: &RigidBodySet) {
        for slot in self.listed.drain(..) {
            self.owners[slot as usize] = NONE;
        }
        for owner in 0..set.index_bound() {
            let Some(index) = set.index_at(owner) else { continue };
            let Some(multibody) = set.get_multibody(index) else { continue };
            if !is_awake(multibody, bodies) {
                continue;
            }
            if acts(multibody, bodies) {
                self.register_tree(owner, multibody, bodies);
            } else if multibody.links.iter().any(|link| !bodies.contains(link.body)) {
                set.note(index);
            }
        }
    }

    fn register_tree(&mut self, owner: u32, multibody: &Multibody, bodies: &RigidBodySet) {
        let is_moved =
            |body: &_| bodies.get(*body).is_some_and(|body: &RigidBody| body.is_dynamic());
        for body in multibody.links.iter().map(|link| link.body).filter(is_moved) {
            let slot = body.into_raw_parts().0;
            if slot as usize >= self.owners.len() {
                self.owners.resize(slot as usize + 1, NONE);
            }
            debug_assert_eq!(self.owners[slot as usize], NONE, "a body is one link");
            self.owners[slot as usize] = owner;
            self.listed.push(slot);
        }
    }

    /// Returns whether no multibody moves a body.
    pub fn is_empty(&self) -> bool {
        self.listed.is_empty()
    }

    /// The multibody that moves the body in a slot.
    pub fn owner(&self, slot: u32) -> Option<u32> {
        self.owners.get(slot as usize).copied().filter(|&owner| owner != NONE)
    }

    /// Returns whether a multibody moves the body in a slot.
    pub fn moves(&self, slot: u32) -> bool {
        self.owner(slot).is_some()
    }

    /// Returns whether a multibody moves one of two bodies.
    pub fn moves_one_of(&self, slots: [u32; 2]) -> bool {
        slots.into_iter().any(|slot| self.moves(slot))
    }
}

/// Returns whether one of its links is awake.
fn is_awake(multibody: &Multibody, bodies: &RigidBodySet) -> bool {
    let moves = |body: &RigidBody| body.is_dynamic() && body.link.awake != NONE;
    multibody.links.iter().any(|link| bodies.get(link.body).is_some_and(moves))
}

/// Returns whether the multibody acts.
fn acts(multibody: &Multibody, bodies: &RigidBodySet) -> bool {
    multibody.acts(|body| {
        let body = bodies.get(body).filter(|body| body.is_enabled())?;
        Some(body.is_dynamic())
    })
}
