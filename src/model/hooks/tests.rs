//! Input validation of the modification context, and the states of a one-way platform.

use super::ContactModificationContext;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodySet;
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::{Contact, ContactManifold, SolverFlags};
use parry::shape::PackedFeatureId;

/// Runs a hook on a manifold with one point.
fn hook(manifold: &mut ContactManifold, work: impl FnOnce(&mut ContactModificationContext)) {
    let (bodies, colliders) = (RigidBodySet::new(), ColliderSet::new());
    work(&mut ContactModificationContext {
        bodies: &bodies,
        colliders: &colliders,
        rigid_body1: None,
        rigid_body2: None,
        collider1: ColliderHandle::invalid(),
        collider2: ColliderHandle::invalid(),
        manifold,
    });
}

/// The next manifold of the narrow phase, with the same user data.
fn touch(manifold: &mut ContactManifold, local_n1: Vector, dist: Real) {
    let (zero, feature) = (Vector::ZERO, PackedFeatureId::UNKNOWN);
    manifold.local_n1 = local_n1;
    manifold.data.solver_flags = SolverFlags::default();
    manifold.data.points.clear();
    manifold.data.points.push(Contact::new(zero, zero, feature, feature, dist));
}

/// Returns whether a platform that is solid from above keeps this contact.
fn holds(manifold: &mut ContactManifold, local_n1: Vector, dist: Real) -> bool {
    touch(manifold, local_n1, dist);
    hook(manifold, |context| context.update_as_oneway_platform(Vector::Y * 2.0, 0.3));
    assert_eq!(manifold.contacts().len(), 1, "user data goes with the last point");
    manifold.data.solver_flags.contains(SolverFlags::COMPUTE_RIGID_IMPULSES)
}

#[test]
fn platform_lets_through_from_below_until_apart() {
    let manifold = &mut ContactManifold::default();
    assert!(!holds(manifold, -Vector::Y, -0.1), "comes from below");
    assert!(!holds(manifold, Vector::X, -0.1), "is inside");
    assert!(!holds(manifold, Vector::Y, -0.1), "almost through");
    assert!(holds(manifold, Vector::Y, 0.01), "above");
    assert!(holds(manifold, Vector::Y, -0.02), "rests on it");
    assert!(!holds(manifold, Vector::X, -0.02), "slides off its edge");
}

#[test]
fn platform_holds_from_above_at_once() {
    let manifold = &mut ContactManifold::default();
    assert!(holds(manifold, Vector::Y, -0.1));
}

#[test]
fn platform_without_direction_is_solid() {
    let manifold = &mut ContactManifold::default();
    for direction in [Vector::ZERO, Vector::Y * Real::NAN] {
        touch(manifold, -Vector::Y, -0.1);
        hook(manifold, |context| context.update_as_oneway_platform(direction, 0.3));
        assert_eq!(manifold.data.solver_flags, SolverFlags::default());
        assert_eq!(manifold.data.user_data, 0);
    }
}

#[test]
fn unsolvable_coefficients_are_refused() {
    let manifold = &mut ContactManifold::default();
    hook(manifold, |context| {
        context.set_friction(0.5);
        context.set_restitution(0.25);
        context.set_tangent_velocity(Vector::X);
        for bad in [-1.0, Real::NAN, Real::INFINITY] {
            context.set_friction(bad);
            context.set_restitution(bad);
        }
        context.set_tangent_velocity(Vector::X * Real::INFINITY);
        assert_eq!((context.friction(), context.restitution()), (0.5, 0.25));
        assert_eq!(context.tangent_velocity(), Vector::X);
    });
}

#[test]
fn points_can_be_dropped_one_by_one() {
    let manifold = &mut ContactManifold::default();
    touch(manifold, Vector::Y, -0.1);
    let far = Contact { dist: 0.1, ..manifold.data.points[0] };
    manifold.data.points.push(far);
    hook(manifold, |context| context.retain_contacts(|contact| contact.dist < 0.0));
    assert_eq!(manifold.contacts().len(), 1);
    assert_eq!(manifold.contacts()[0].dist, -0.1);
}
