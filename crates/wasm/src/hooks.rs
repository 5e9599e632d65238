//! Hooks: JavaScript filters pairs and changes contacts during a step.

use crate::handle::{Handle, optional};
use crate::host;
use crate::memory::{number, put_number, put_vector, vector};
use crate::rapier::dynamics::RigidBodySet;
use crate::rapier::geometry::{ColliderSet, SolverFlags};
use crate::rapier::pipeline::{ContactModificationContext, PairFilterContext, PhysicsHooks};
use crate::registry::LentSets;
use core::cell::Cell;
use core::ptr::null;

/// The kinds of hooks, also the bits of the present ones.
const CONTACT: u32 = 0;
const INTERSECTION: u32 = 1;
const MODIFICATION: u32 = 2;

/// The bits of the result for contacts. The result of a modification is 0 if the hook threw: the contacts are
/// unchanged.
const KEEP_CONTACTS: u32 = 1;
const COMPUTE_IMPULSES: u32 = 2;
const WRITTEN: u32 = 4;

/// The hooks of JavaScript.
pub struct Hooks<'a> {
    present: u32,
    sets: &'a Cell<LentSets>,
}

// SAFETY: a world with hooks is stepped by one thread (`threads::choose`).
unsafe impl Send for Hooks<'_> {}
// SAFETY: as above.
unsafe impl Sync for Hooks<'_> {}

impl<'a> Hooks<'a> {
    /// Hooks, some of which are present. The sets are stored while one runs.
    pub fn new(present: u32, sets: &'a Cell<LentSets>) -> Self {
        Self { present, sets }
    }

    fn has(&self, kind: u32) -> bool {
        self.present & (1 << kind) != 0
    }

    /// Runs a hook with read access to the sets.
    fn lend<R>(
        &self,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        hook: impl FnOnce() -> R,
    ) -> R {
        self.sets.set((bodies, colliders));
        let result = hook();
        self.sets.set((null(), null()));
        result
    }

    /// Calls a filter for a pair. Returns its result.
    fn filter(&self, kind: u32, pair: &PairFilterContext<'_>) -> u32 {
        let (collider1, collider2) = (pair.collider1.to_number(), pair.collider2.to_number());
        let (body1, body2) = (optional(pair.rigid_body1), optional(pair.rigid_body2));
        self.lend(pair.bodies, pair.colliders, || {
            host::hook(kind, collider1, collider2, body1, body2)
        })
    }
}

impl PhysicsHooks for Hooks<'_> {
    fn contact_pair_flags(&self, context: &PairFilterContext<'_>) -> Option<SolverFlags> {
        if !self.has(CONTACT) {
            return Some(SolverFlags::default());
        }
        let answer = self.filter(CONTACT, context);
        let computes = answer & COMPUTE_IMPULSES != 0;
        let flags = if computes { SolverFlags::default() } else { SolverFlags::empty() };
        (answer & KEEP_CONTACTS != 0).then_some(flags)
    }

    fn filter_intersection_pair(&self, context: &PairFilterContext<'_>) -> bool {
        !self.has(INTERSECTION) || self.filter(INTERSECTION, context) != 0
    }

    fn modify_solver_contact(&self, context: &mut ContactModificationContext<'_>) {
        if !self.has(MODIFICATION) {
            return;
        }
        put_vector(0, context.normal());
        put_vector(1, context.tangent_velocity());
        put_number(2, 0, context.friction());
        put_number(2, 1, context.restitution());
        // A number of 32 bits does not fit into a float of 32 bits: two halves do.
        put_number(2, 2, (context.user_data() & 0xffff) as _);
        put_number(2, 3, (context.user_data() >> 16) as _);
        put_number(3, 0, context.contacts().len() as _);
        let (collider1, collider2) = (context.collider1.to_number(), context.collider2.to_number());
        let (body1, body2) = (optional(context.rigid_body1), optional(context.rigid_body2));
        let answer = self.lend(context.bodies, context.colliders, || {
            host::hook(MODIFICATION, collider1, collider2, body1, body2)
        });
        if answer & WRITTEN == 0 {
            return;
        }
        // The engine rejects invalid numbers; vectors are checked here.
        if let Ok(velocity) = vector(1, "tangentVelocity") {
            context.set_tangent_velocity(velocity);
        }
        context.set_friction(number(2, 0));
        context.set_restitution(number(2, 1));
        context.set_user_data(number(2, 2) as u32 | ((number(2, 3) as u32) << 16));
        if answer & KEEP_CONTACTS == 0 {
            context.clear_contacts();
        }
        if answer & COMPUTE_IMPULSES == 0 {
            context.set_solver_flags(SolverFlags::empty());
        }
    }
}
