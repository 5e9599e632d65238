//! The forms in which the two versions of Rapier differ.

use rapier::prelude::*;
use std::sync::mpsc::Sender;

#[cfg(not(rapier036))]
mod form {
    use rapier::prelude::*;

    pub fn manifolds(pair: &ContactPair) -> &[ContactManifold] {
        &pair.manifolds
    }

    pub fn contacts<'a>(
        context: &'a mut ContactModificationContext<'_>,
    ) -> &'a mut Vec<SolverContact> {
        context.solver_contacts
    }

    pub fn user_data<'a>(context: &'a mut ContactModificationContext<'_>) -> &'a mut u32 {
        context.user_data
    }

    pub fn stored_contacts(context: &ContactModificationContext<'_>) -> usize {
        context.manifold.data.solver_contacts.len()
    }

    pub fn set_friction(context: &mut ContactModificationContext<'_>, friction: Real) {
        context.solver_contacts.iter_mut().for_each(|contact| contact.friction = friction);
    }

    pub fn point(contact: &SolverContact) -> Vector {
        contact.point
    }

    pub fn friction(manifold: &ContactManifold) -> Real {
        manifold.data.solver_contacts[0].friction
    }

    pub const COMPUTE_IMPULSES: SolverFlags = SolverFlags::COMPUTE_IMPULSES;
}

#[cfg(rapier036)]
mod form {
    use rapier::prelude::*;

    pub fn manifolds(pair: &ContactPair) -> &[ContactManifold] {
        let PairContacts::Rigid(rigid) = &pair.contacts else { panic!("soft contacts") };
        assert_eq!(rigid.manifolds.len(), pair.manifolds().len());
        pair.manifolds()
    }

    pub fn contacts<'a>(
        context: &'a mut ContactModificationContext<'_>,
    ) -> &'a mut Vec<SolverContact> {
        context.rigid_mut().expect("rigid contacts").solver_contacts
    }

    pub fn user_data<'a>(context: &'a mut ContactModificationContext<'_>) -> &'a mut u32 {
        context.rigid_mut().expect("rigid contacts").user_data
    }

    pub fn stored_contacts(context: &ContactModificationContext<'_>) -> usize {
        context.rigid().expect("rigid contacts").manifold.data.solver_contacts.len()
    }

    pub fn set_friction(context: &mut ContactModificationContext<'_>, friction: Real) {
        *context.rigid_mut().expect("rigid contacts").friction = friction;
    }

    pub fn point(contact: &SolverContact) -> Vector {
        (contact.anchor1 + contact.anchor2) * 0.5
    }

    pub fn friction(manifold: &ContactManifold) -> Real {
        manifold.data.friction
    }

    pub const COMPUTE_IMPULSES: SolverFlags = SolverFlags::COMPUTE_RIGID_IMPULSES;
}

pub use form::*;

/// A collector with one channel for each kind of event.
pub fn collector(
    collisions: Sender<CollisionEvent>,
    forces: Sender<ContactForceEvent>,
) -> ChannelEventCollector {
    #[cfg(rapier036)]
    return ChannelEventCollector::new(collisions, forces, std::sync::mpsc::channel().0);
    #[cfg(not(rapier036))]
    return ChannelEventCollector::new(collisions, forces);
}
