//! Calls of the user's hooks for the contacts of a character, as in the narrow phase.

use crate::dim::math::{Pose, Vector};
use crate::model::body::RigidBodySet;
use crate::model::collider::{
    ActiveHooks, CoefficientCombineRule, Collider, ColliderHandle, ColliderSet,
};
use crate::model::contact::{ContactManifold, SolverFlags};
use crate::model::hooks::{
    ContactModificationContext, PairFilterContext, PhysicsHooks, lets_solver_push,
};
use core::cell::RefCell;

/// State of the hooks for the contacts of one character: the
/// [`user_data`](ContactModificationContext::user_data) of each touching contact.
///
/// One-way platforms need it, so that a character that jumps through a platform is not stopped while inside.
/// Keep one value for each character between calls.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct CharacterContacts {
    entries: Vec<Entry>,
}

#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
struct Entry {
    obstacle: ColliderHandle,
    subshapes: [u32; 2],
    user_data: u32,
    /// Whether the two touched during the last call.
    is_current: bool,
}

impl CharacterContacts {
    /// Empty state.
    pub fn new() -> Self {
        Self::default()
    }

    fn find(&mut self, obstacle: ColliderHandle, subshapes: [u32; 2]) -> Option<&mut Entry> {
        self.entries.iter_mut().find(|e| e.obstacle == obstacle && e.subshapes == subshapes)
    }

    fn user_data_of(&mut self, obstacle: ColliderHandle, subshapes: [u32; 2]) -> u32 {
        self.find(obstacle, subshapes).map_or(0, |entry| entry.user_data)
    }

    fn set_user_data(&mut self, obstacle: ColliderHandle, subshapes: [u32; 2], user_data: u32) {
        match self.find(obstacle, subshapes) {
            Some(entry) => (entry.user_data, entry.is_current) = (user_data, true),
            None => self.entries.push(Entry { obstacle, subshapes, user_data, is_current: true }),
        }
    }

    /// Marks the start of a call.
    pub(super) fn begin(&mut self) {
        self.entries.iter_mut().for_each(|entry| entry.is_current = false);
    }

    /// Marks the end of a call, and removes contacts that did not touch during it.
    pub(super) fn end(&mut self) {
        self.entries.retain(|entry| entry.is_current);
    }
}

/// The hooks of a world, for a character: see
/// [`move_shape_with_hooks`](super::KinematicCharacterController::move_shape_with_hooks).
pub struct CharacterHooks<'a> {
    /// The user's hooks.
    pub hooks: &'a dyn PhysicsHooks,
    /// All bodies.
    pub bodies: &'a RigidBodySet,
    /// The collider that represents the character in the world.
    pub character: ColliderHandle,
    /// State of the hooks for this character's contacts.
    pub contacts: &'a mut CharacterContacts,
}

impl core::fmt::Debug for CharacterHooks<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("CharacterHooks").field("character", &self.character).finish_non_exhaustive()
    }
}

/// The hooks during a call.
pub(super) struct HookContext<'a> {
    hooks: &'a dyn PhysicsHooks,
    bodies: &'a RigidBodySet,
    colliders: &'a ColliderSet,
    handle: ColliderHandle,
    character: Option<&'a Collider>,
    contacts: RefCell<&'a mut CharacterContacts>,
}

impl<'a> HookContext<'a> {
    pub fn new(character_hooks: CharacterHooks<'a>, colliders: &'a ColliderSet) -> Self {
        character_hooks.contacts.begin();
        Self {
            hooks: character_hooks.hooks,
            bodies: character_hooks.bodies,
            colliders,
            handle: character_hooks.character,
            character: colliders.get(character_hooks.character),
            contacts: RefCell::new(character_hooks.contacts),
        }
    }

    pub fn finish(self) {
        self.contacts.into_inner().end();
    }

    fn has_hooks(&self, obstacle: &Collider, hooks: ActiveHooks) -> bool {
        let own = self.character.map_or(ActiveHooks::empty(), Collider::active_hooks);
        (obstacle.active_hooks() | own).contains(hooks)
    }

    /// Returns whether the filter lets the obstacle stop the character. Flags without impulses let the
    /// character pass, as a refusal does.
    pub fn lets_meet(&self, handle: ColliderHandle, obstacle: &Collider) -> bool {
        if !self.has_hooks(obstacle, ActiveHooks::FILTER_CONTACT_PAIRS) {
            return true;
        }
        let pair = PairFilterContext {
            bodies: self.bodies,
            colliders: self.colliders,
            collider1: handle,
            collider2: self.handle,
            rigid_body1: obstacle.parent(),
            rigid_body2: self.character.and_then(Collider::parent),
        };
        lets_solver_push(self.hooks, &pair)
    }

    /// Returns whether the hooks may change contacts with this obstacle.
    fn modifies(&self, obstacle: &Collider) -> bool {
        self.has_hooks(obstacle, ActiveHooks::MODIFY_SOLVER_CONTACTS)
    }

    /// Passes a manifold to the hooks. Returns whether it keeps the two apart.
    pub fn is_solid(
        &self,
        handle: ColliderHandle,
        obstacle: &Collider,
        manifold: &mut ContactManifold,
        pose: &Pose,
    ) -> bool {
        if !self.modifies(obstacle) {
            return true;
        }
        let subshapes = [manifold.subshape1, manifold.subshape2];
        self.complete(manifold, obstacle, pose);
        manifold.data.user_data = self.contacts.borrow_mut().user_data_of(handle, subshapes);
        self.hooks.modify_solver_contact(&mut ContactModificationContext {
            bodies: self.bodies,
            colliders: self.colliders,
            rigid_body1: obstacle.parent(),
            rigid_body2: self.character.and_then(Collider::parent),
            collider1: handle,
            collider2: self.handle,
            manifold,
        });
        let user_data = manifold.data.user_data;
        if !manifold.contacts().is_empty() {
            self.contacts.borrow_mut().set_user_data(handle, subshapes, user_data);
        }
        manifold.is_solved()
    }

    /// Completes a manifold with the data for hooks.
    fn complete(&self, manifold: &mut ContactManifold, obstacle: &Collider, pose: &Pose) {
        let rotation = obstacle.position().rotation;
        let data = &mut manifold.data;
        data.rigid_body1 = obstacle.parent();
        data.rigid_body2 = self.character.and_then(Collider::parent);
        data.normal = rotation * manifold.local_n1;
        data.tangent_velocity = Vector::ZERO;
        for contact in &mut data.points {
            let on_obstacle = obstacle.position() * contact.local_p1;
            contact.point = (on_obstacle + pose * contact.local_p2) * 0.5;
        }
        let own = self.character.unwrap_or(obstacle);
        let (m1, m2) = (obstacle.material(), own.material());
        let combine = CoefficientCombineRule::combined;
        data.friction =
            combine(m1.friction, m1.friction_combine_rule, m2.friction, m2.friction_combine_rule);
        data.restitution = combine(
            m1.restitution,
            m1.restitution_combine_rule,
            m2.restitution,
            m2.restitution_combine_rule,
        );
        data.solver_flags = if obstacle.solver_groups().test(own.solver_groups()) {
            SolverFlags::COMPUTE_RIGID_IMPULSES
        } else {
            SolverFlags::empty()
        };
    }
}
