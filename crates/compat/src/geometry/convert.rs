//! Conversion of contact pairs from the engine's representation, and of edits back to it.

use super::{
    Contact, ContactData, ContactManifold, ContactManifoldData, ContactPair, SolverContact,
    SolverFlags,
};
use crate::math::{Real, TangentImpulse, Vector};
use engine::pipeline::ContactModificationContext;

/// A pair of the engine in upstream's representation.
pub fn to_pair(pair: &engine::geometry::ContactPair) -> ContactPair {
    let manifolds = pair.manifolds.iter().map(to_manifold).collect();
    ContactPair::from_manifolds([pair.collider1, pair.collider2], manifolds)
}

/// A manifold of the engine in upstream's representation. Its points are in the frames of the colliders, so
/// no part has a pose of its own.
pub fn to_manifold(manifold: &engine::geometry::ContactManifold) -> ContactManifold {
    let data = &manifold.data;
    let mut converted = ContactManifold::new();
    let mut solver_contacts = Vec::with_capacity(data.points.len());
    for (index, point) in data.points.iter().enumerate() {
        let friction = data.friction_impulse(index);
        converted.points.push(to_contact(point, data.normal, friction));
        solver_contacts.push(to_solver_contact(data, index));
    }
    converted.local_n1 = manifold.local_n1;
    converted.local_n2 = manifold.local_n2;
    converted.subshape1 = manifold.subshape1;
    converted.subshape2 = manifold.subshape2;
    converted.data = ContactManifoldData {
        rigid_body1: data.rigid_body1,
        rigid_body2: data.rigid_body2,
        solver_flags: SolverFlags::from_bits_truncate(data.solver_flags.bits()),
        normal: data.normal,
        solver_contacts,
        #[cfg(rapier036)]
        friction: data.friction,
        #[cfg(rapier036)]
        restitution: data.restitution,
        relative_dominance: data.relative_dominance,
        user_data: data.user_data,
    };
    converted
}

fn to_contact(point: &engine::geometry::Contact, normal: Vector, friction: Vector) -> Contact {
    let mut contact =
        Contact::new(point.local_p1, point.local_p2, point.fid1, point.fid2, point.dist);
    contact.data = ContactData {
        impulse: point.impulse,
        tangent_impulse: tangent_impulse(normal, friction),
        warmstart_impulse: point.warmstart_impulse,
        warmstart_tangent_impulse: tangent_impulse(normal, friction),
        #[cfg(feature = "dim3")]
        warmstart_twist_impulse: 0.0,
        #[cfg(all(feature = "dim3", rapier036))]
        warmstart_tangent_world: friction,
        #[cfg(rapier036)]
        solver_dp1: Vector::ZERO,
        #[cfg(rapier036)]
        solver_dp2: Vector::ZERO,
    };
    contact
}

#[cfg(not(rapier036))]
fn to_solver_contact(data: &engine::geometry::ContactManifoldData, index: usize) -> SolverContact {
    let point = &data.points[index];
    SolverContact {
        point: point.point,
        dist: point.dist,
        friction: data.friction,
        restitution: data.restitution,
        tangent_velocity: data.tangent_velocity,
        warmstart_impulse: point.warmstart_impulse,
        warmstart_tangent_impulse: tangent_impulse(data.normal, data.friction_impulse(index)),
        warmstart_twist_impulse: 0.0,
        is_new: Real::from(u8::from(point.warmstart_impulse == 0.0)),
        contact_id: [index as u32],
    }
}

#[cfg(rapier036)]
fn to_solver_contact(data: &engine::geometry::ContactManifoldData, index: usize) -> SolverContact {
    let point = &data.points[index];
    let half = data.normal * (point.dist * 0.5);
    let is_new = point.warmstart_impulse == 0.0;
    SolverContact {
        anchor1: point.point - half,
        anchor2: point.point + half,
        dist: point.dist,
        tangent_velocity: data.tangent_velocity,
        contact_id: [index as u32 | if is_new { super::NEW_CONTACT_BIT } else { 0 }],
    }
}

/// The components of a friction impulse along two unit tangents of a contact.
#[cfg(feature = "dim3")]
fn tangent_impulse(normal: Vector, impulse: Vector) -> TangentImpulse<Real> {
    let (tangent1, tangent2) = normal.any_orthonormal_pair();
    TangentImpulse::new(impulse.dot(tangent1), impulse.dot(tangent2))
}

/// The component of a friction impulse along the unit tangent of a contact.
#[cfg(feature = "dim2")]
fn tangent_impulse(normal: Vector, impulse: Vector) -> TangentImpulse<Real> {
    TangentImpulse::new(impulse.dot(normal.perp()))
}

/// Index of a point in its manifold.
fn index_of(contact: &SolverContact) -> usize {
    #[cfg(rapier036)]
    return contact.contact_indices()[0] as usize;
    #[cfg(not(rapier036))]
    return contact.contact_id[0] as usize;
}

/// Writes the contacts that a hook left, friction and restitution back to the engine.
///
/// The engine has one material per manifold, and one tangent velocity: that of the first remaining contact. A
/// manifold without contacts exerts no impulse in this step, and its user data persists.
pub fn write_back(
    engine: &mut ContactModificationContext<'_>,
    contacts: &[SolverContact],
    material: Option<(Real, Real)>,
    user_data: u32,
) {
    engine.set_user_data(user_data);
    let (Some(first), Some((friction, restitution))) = (contacts.first(), material) else {
        let flags = engine::geometry::SolverFlags::COMPUTE_RIGID_IMPULSES;
        return engine.set_solver_flags(engine.solver_flags() - flags);
    };
    let mut index = 0;
    engine.retain_contacts(|_| {
        index += 1;
        contacts.iter().any(|contact| index_of(contact) == index - 1)
    });
    if friction != engine.friction() {
        engine.set_friction(friction);
    }
    if restitution != engine.restitution() {
        engine.set_restitution(restitution);
    }
    if first.tangent_velocity != engine.tangent_velocity() {
        engine.set_tangent_velocity(first.tangent_velocity);
    }
}
