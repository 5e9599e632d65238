//! The contacts of the last step.

use crate::fault::Fault;
use crate::handle::Handle;
use crate::memory::{put_integers, put_list, put_number, put_vector};
use crate::rapier::geometry::{ColliderHandle, ContactManifold, ContactPair};
use crate::rapier::math::{Real, Vector};
use crate::registry::read;

/// The pair of two colliders, and whether it has them in the other order.
fn pair(
    world: u32,
    handle1: f64,
    handle2: f64,
) -> Result<Option<(&'static ContactPair, bool)>, Fault> {
    let [first, second] = [handle1, handle2].map(ColliderHandle::of_number);
    let pair = read(world)?.contact_pair(first, second);
    Ok(pair.map(|pair| (pair, pair.collider1 != first)))
}

/// A manifold of a pair.
fn manifold(
    world: u32,
    handles: [f64; 2],
    index: usize,
) -> Result<&'static ContactManifold, Fault> {
    let manifold =
        pair(world, handles[0], handles[1])?.and_then(|(pair, _)| pair.manifolds.get(index));
    manifold.ok_or_else(|| Fault::invalid(format_args!("the pair has no contact manifold {index}")))
}

/// Unit vectors across a normal.
#[cfg(feature = "dim2")]
fn tangents(normal: Vector) -> [Vector; 1] {
    [Vector::new(-normal.y, normal.x)]
}

/// Unit vectors across a normal.
#[cfg(not(feature = "dim2"))]
fn tangents(normal: Vector) -> [Vector; 2] {
    let (first, second) = normal.any_orthonormal_pair();
    [first, second]
}

exports! {
    /// Lists the colliders that have contact pairs with a collider.
    fn contacts_with(world: u32, handle: f64) -> u32 {
        let collider = ColliderHandle::of_number(handle);
        put_list(read(world)?.contact_pairs_with(collider).map(|pair| {
            let other = if pair.collider1 == collider { pair.collider2 } else { pair.collider1 };
            other.to_number()
        }))
    }

    /// Lists the colliders that have intersection pairs with a collider.
    fn intersections_with(world: u32, handle: f64) -> u32 {
        let collider = ColliderHandle::of_number(handle);
        put_list(read(world)?.intersection_pairs_with(collider).filter(|(_, _, intersecting)| *intersecting).map(
            |(first, second, _)| if first == collider { second.to_number() } else { first.to_number() },
        ))
    }

    /// Returns whether two colliders, one of them a sensor, intersect.
    fn intersection_exists(world: u32, handle1: f64, handle2: f64) -> bool {
        let [first, second] = [handle1, handle2].map(ColliderHandle::of_number);
        read(world)?.intersection_pair(first, second).unwrap_or(false)
    }

    /// The number of manifolds of a pair. The integers contain whether the pair has the colliders in the
    /// other order.
    fn manifold_count(world: u32, handle1: f64, handle2: f64) -> usize {
        let pair = pair(world, handle1, handle2)?;
        put_integers([u32::from(pair.is_some_and(|(_, is_flipped)| is_flipped))]);
        pair.map_or(0, |(pair, _)| pair.manifolds.len())
    }

    /// Writes a manifold: normal, local normals, then friction, restitution and the numbers of contacts and
    /// solver contacts. The integers are the sub-shapes.
    fn manifold_read(world: u32, handle1: f64, handle2: f64, index: usize) {
        let manifold = manifold(world, [handle1, handle2], index)?;
        put_vector(0, manifold.data.normal);
        put_vector(1, manifold.local_n1);
        put_vector(2, manifold.local_n2);
        put_number(3, 0, manifold.data.friction);
        put_number(3, 1, manifold.data.restitution);
        put_number(3, 2, manifold.contacts().len() as Real);
        put_number(3, 3, manifold.data.solver_contacts().len() as Real);
        put_vector(4, manifold.data.tangent_velocity);
        put_integers([manifold.subshape1, manifold.subshape2]);
    }

    /// Writes a contact: local points, then distance, impulse and tangent impulses, then the point in world
    /// space. The integers are the features.
    fn manifold_contact(world: u32, handle1: f64, handle2: f64, index: usize, point: usize) -> bool {
        let manifold = manifold(world, [handle1, handle2], index)?;
        let contact = manifold.contacts().get(point);
        if let Some(contact) = contact {
            put_vector(0, contact.local_p1);
            put_vector(1, contact.local_p2);
            put_number(2, 0, contact.dist);
            put_number(2, 1, contact.impulse);
            let friction = manifold.data.friction_impulse(point);
            for (axis, tangent) in tangents(manifold.data.normal).into_iter().enumerate() {
                put_number(2, 2 + axis, friction.dot(tangent));
            }
            put_vector(3, contact.point);
            put_integers([contact.fid1.0, contact.fid2.0]);
        }
        contact.is_some()
    }
}
