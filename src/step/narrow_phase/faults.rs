//! Contacts with values that are not finite.
//!
//! Hooks and materials may have any number, and normals of extreme shapes may not be finite. The body is not
//! disabled for that: the pair omits the value.

use super::update::Worker;
use crate::base::measure::{MODERATE_MAX, is_point};
use crate::base::pool::Pool;
use crate::model::body::QuarantineCause;
use crate::model::contact::{ContactManifold, SolverFlags};
use crate::model::event::QuarantineEvent;

/// Removes unusable numbers from a manifold, and returns the cause.
///
/// A large friction coefficient does no harm: it bounds a finite force.
pub(super) fn leave_out(manifold: &mut ContactManifold) -> Option<QuarantineCause> {
    let data = &mut manifold.data;
    let normal = data.normal;
    if let Some(point) =
        data.points.iter().find(|point| !(is_point(normal) && point.dist.is_finite()))
    {
        let dist = point.dist;
        data.solver_flags.remove(SolverFlags::COMPUTE_RIGID_IMPULSES);
        return Some(QuarantineCause::Contact { normal, dist });
    }
    if data.restitution > MODERATE_MAX {
        let restitution = core::mem::take(&mut data.restitution);
        return Some(QuarantineCause::Restitution(restitution));
    }
    if data.tangent_velocity.abs().max_element() > MODERATE_MAX {
        let velocity = core::mem::take(&mut data.tangent_velocity);
        return Some(QuarantineCause::TangentVelocity(velocity));
    }
    None
}

/// Reports the found pairs in the order of their colliders: the result is independent of the threads that
/// found them.
pub(super) fn report(workers: &mut Pool<Worker>, events: &mut Vec<QuarantineEvent>) {
    let mut found = Vec::new();
    workers.for_each(|worker| found.append(&mut worker.faults));
    found.sort_by_key(|(colliders, _)| colliders.map(|handle| handle.into_raw_parts()));
    // Some pairs are computed twice, and some have several manifolds: one event is enough.
    found.dedup_by_key(|(colliders, _)| *colliders);
    for ([collider1, collider2], cause) in found {
        log::warn!("a contact of {collider1:?} and {collider2:?} is invalid: {cause}");
        events.push(QuarantineEvent::Contact { collider1, collider2, cause });
    }
}
