//! Contact pairs in the representation of Rapier 0.32.

use super::{ColliderHandle, TrackedContact};
use crate::dynamics::RigidBodyHandle;
use crate::math::{Real, TangentImpulse, Vector};

bitflags::bitflags! {
    /// Constraints that the solver makes of a manifold.
    #[derive(Copy, Clone, PartialEq, Eq, Debug)]
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    pub struct SolverFlags: u32 {
        /// Impulses that keep the bodies apart.
        const COMPUTE_IMPULSES = 1;
    }
}

impl Default for SolverFlags {
    fn default() -> Self {
        Self::COMPUTE_IMPULSES
    }
}

/// Impulses of a contact point.
#[derive(Copy, Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactData {
    /// Normal impulse of the last step.
    pub impulse: Real,
    /// Friction impulse of the last substep. The sum over the points of a manifold is its friction without
    /// the torsional part.
    pub tangent_impulse: TangentImpulse<Real>,
    /// Normal impulse of the last substep.
    pub warmstart_impulse: Real,
    /// Friction impulse of the last substep.
    pub warmstart_tangent_impulse: TangentImpulse<Real>,
    /// Torsional impulse of the last substep.
    #[cfg(feature = "dim3")]
    pub warmstart_twist_impulse: Real,
}

/// A contact point.
pub type Contact = TrackedContact<ContactData>;
/// Contact points with one normal.
pub type ContactManifold = crate::parry::query::ContactManifold<ContactManifoldData, ContactData>;

/// A contact point in world space, as the solver reads it.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SolverContact {
    /// The point midway between the two surfaces, in world space.
    pub point: Vector,
    /// Distance of the surfaces; negative if they overlap.
    pub dist: Real,
    /// Friction coefficient.
    pub friction: Real,
    /// Restitution coefficient.
    pub restitution: Real,
    /// Target velocity of friction.
    pub tangent_velocity: Vector,
    /// Normal impulse of the last substep.
    pub warmstart_impulse: Real,
    /// Friction impulse of the last substep.
    pub warmstart_tangent_impulse: TangentImpulse<Real>,
    /// Torsional impulse of the last substep.
    pub warmstart_twist_impulse: Real,
    /// 1 if the point has no impulse of an earlier step, otherwise 0.
    pub is_new: Real,
    /// Index of the point in its manifold.
    pub contact_id: [u32; 1],
}

impl SolverContact {
    /// 1 if the point bounces in this step, otherwise 0.
    pub fn is_bouncy(&self) -> Real {
        let bounces =
            if self.is_new != 0.0 { self.restitution > 0.0 } else { self.restitution >= 1.0 };
        Real::from(u8::from(bounces))
    }
}

/// The solver's data of a manifold.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactManifoldData {
    /// Body of the first collider.
    pub rigid_body1: Option<RigidBodyHandle>,
    /// Body of the second collider.
    pub rigid_body2: Option<RigidBodyHandle>,
    /// Constraints of the manifold.
    pub solver_flags: SolverFlags,
    /// Unit normal in world space, from the first collider to the second.
    pub normal: Vector,
    /// The points, in world space.
    pub solver_contacts: Vec<SolverContact>,
    /// Dominance group of the first body less that of the second.
    pub relative_dominance: i16,
    /// Number that a hook stores from step to step.
    pub user_data: u32,
}

impl Default for ContactManifoldData {
    fn default() -> Self {
        Self {
            rigid_body1: None,
            rigid_body2: None,
            solver_flags: SolverFlags::empty(),
            normal: Vector::ZERO,
            solver_contacts: Vec::new(),
            relative_dominance: 0,
            user_data: 0,
        }
    }
}

impl ContactManifoldData {
    /// Number of points that the solver handles.
    pub fn num_active_contacts(&self) -> usize {
        self.solver_contacts.len()
    }
}

/// Sums over the points of a manifold.
pub trait ContactManifoldExt {
    /// Sum of the normal impulses of the last step.
    fn total_impulse(&self) -> Real;
}

impl ContactManifoldExt for ContactManifold {
    fn total_impulse(&self) -> Real {
        self.points.iter().map(|point| point.data.impulse).sum()
    }
}

/// Two colliders whose boxes overlap, and their contacts.
#[derive(Clone)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactPair {
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// The contacts: one manifold for each pair of convex parts.
    pub manifolds: Vec<ContactManifold>,
}

impl Default for ContactPair {
    fn default() -> Self {
        let none = ColliderHandle::invalid();
        Self { collider1: none, collider2: none, manifolds: Vec::new() }
    }
}

impl ContactPair {
    /// A pair with these manifolds.
    pub(crate) fn from_manifolds(
        [collider1, collider2]: [ColliderHandle; 2],
        manifolds: Vec<ContactManifold>,
    ) -> Self {
        Self { collider1, collider2, manifolds }
    }

    /// One manifold for each pair of convex parts.
    pub(crate) fn manifolds(&self) -> &[ContactManifold] {
        &self.manifolds
    }

    /// Returns whether the solver handles any contact.
    pub fn has_any_active_contact(&self) -> bool {
        self.manifolds.iter().any(|manifold| !manifold.data.solver_contacts.is_empty())
    }

    /// Removes all manifolds.
    pub fn clear(&mut self) {
        self.manifolds.clear();
    }

    /// Sum of the normal impulses of the last step.
    pub fn total_impulse(&self) -> Vector {
        self.manifolds.iter().map(|manifold| manifold.data.normal * manifold.total_impulse()).sum()
    }

    /// Sum of the magnitudes of the normal impulses of the last step.
    pub fn total_impulse_magnitude(&self) -> Real {
        self.manifolds.iter().map(ContactManifoldExt::total_impulse).sum()
    }

    /// The largest impulse of a manifold, and its direction.
    pub fn max_impulse(&self) -> (Real, Vector) {
        let impulses = self.manifolds.iter().map(|it| (it.total_impulse(), it.data.normal));
        let none = (0.0, Vector::ZERO);
        impulses.fold(none, |largest, next| if next.0 > largest.0 { next } else { largest })
    }

    /// The contact with the largest overlap, and its manifold.
    pub fn find_deepest_contact(&self) -> Option<(&ContactManifold, &Contact)> {
        let points = self.manifolds.iter().filter_map(|it| Some((it, it.find_deepest_contact()?)));
        points.min_by(|(_, one), (_, other)| one.dist.total_cmp(&other.dist))
    }
}
