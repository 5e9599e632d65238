//! Contact pairs in the representation of Rapier 0.36.

use super::{ColliderHandle, TrackedContact};
use crate::dynamics::{RigidBodyHandle, RigidBodySet, SoftPairContacts};
use crate::math::{Real, TangentImpulse, Vector};

bitflags::bitflags! {
    /// Constraints that the solver makes of a manifold.
    #[derive(Copy, Clone, PartialEq, Eq, Debug)]
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    pub struct SolverFlags: u32 {
        /// Impulses that keep the bodies apart.
        const COMPUTE_RIGID_IMPULSES = 1;
    }
}

impl Default for SolverFlags {
    fn default() -> Self {
        Self::COMPUTE_RIGID_IMPULSES
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
    /// Friction impulse of the last substep, in world space.
    #[cfg(feature = "dim3")]
    pub warmstart_tangent_world: Vector,
    /// Zero: the engine keeps it elsewhere.
    pub solver_dp1: Vector,
    /// Zero: the engine keeps it elsewhere.
    pub solver_dp2: Vector,
}

/// A contact point.
pub type Contact = TrackedContact<ContactData>;
/// Contact points with one normal.
pub type ContactManifold = crate::parry::query::ContactManifold<ContactManifoldData, ContactData>;

/// Index of a contact point in its manifold. [`NEW_CONTACT_BIT`] marks a new point.
pub type ContactId = u32;
/// Mark of a point without an impulse of an earlier step.
pub const NEW_CONTACT_BIT: ContactId = 1 << 31;
/// The contacts of a manifold that are solved.
pub type SolverContacts = Vec<SolverContact>;

/// A contact point as the solver reads it.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SolverContact {
    /// The point on the first surface, in world space.
    pub anchor1: Vector,
    /// The point on the second surface, in world space.
    pub anchor2: Vector,
    /// Distance of the surfaces; negative if they overlap.
    pub dist: Real,
    /// Target velocity of friction.
    pub tangent_velocity: Vector,
    /// Index of the point in its manifold.
    pub contact_id: [ContactId; 1],
}

impl SolverContact {
    /// The index of the point, without the mark of new points.
    pub fn contact_indices(&self) -> [ContactId; 1] {
        self.contact_id.map(|id| id & !NEW_CONTACT_BIT)
    }

    /// Returns whether the point has no impulse of an earlier step.
    pub fn is_new(&self) -> bool {
        self.contact_id[0] & NEW_CONTACT_BIT != 0
    }
}

/// 1 if a point of this restitution bounces in a step, otherwise 0.
pub fn is_bouncy(restitution: Real, is_new: bool) -> Real {
    let bounces = if is_new { restitution > 0.0 } else { restitution >= 1.0 };
    Real::from(u8::from(bounces))
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
    pub solver_contacts: SolverContacts,
    /// Friction coefficient.
    pub friction: Real,
    /// Restitution coefficient.
    pub restitution: Real,
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
            friction: 0.0,
            restitution: 0.0,
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

    /// The points on both surfaces, in world space.
    pub fn solver_contact_world_points(
        &self,
        contact: &SolverContact,
        _bodies: &RigidBodySet,
    ) -> (Vector, Vector) {
        (contact.anchor1, contact.anchor2)
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
    /// The contacts.
    pub contacts: PairContacts,
    /// Whether the force of the pair reached its threshold in this step, and not in the step before.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(crate) force_started: bool,
}

/// The contacts of a pair.
#[derive(Clone)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum PairContacts {
    /// Contacts of rigid bodies.
    Rigid(RigidPairContacts),
    /// Contacts of a soft body: the engine makes none.
    Soft {
        /// Whether the pair touches.
        touching: bool,
        /// The contacts.
        #[cfg_attr(feature = "serde-serialize", serde(skip))]
        candidates: Box<SoftPairContacts>,
    },
}

/// Contacts of rigid bodies.
#[derive(Clone, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct RigidPairContacts {
    /// One manifold for each pair of convex parts.
    pub manifolds: Vec<ContactManifold>,
    /// Empty: the engine merges no manifolds.
    pub solver_clusters: Vec<ContactManifold>,
}

impl RigidPairContacts {
    /// The manifolds that are solved.
    pub fn solver_manifolds(&self) -> &[ContactManifold] {
        &self.manifolds
    }

    /// Returns whether the solver handles any contact.
    pub fn has_any_active_contact(&self) -> bool {
        self.manifolds.iter().any(|manifold| !manifold.data.solver_contacts.is_empty())
    }
}

impl Default for ContactPair {
    fn default() -> Self {
        let none = ColliderHandle::invalid();
        Self::from_manifolds([none, none], Vec::new())
    }
}

impl ContactPair {
    /// A pair with these manifolds.
    pub(crate) fn from_manifolds(
        [collider1, collider2]: [ColliderHandle; 2],
        manifolds: Vec<ContactManifold>,
    ) -> Self {
        let rigid = RigidPairContacts { manifolds, solver_clusters: Vec::new() };
        let contacts = PairContacts::Rigid(rigid);
        Self { collider1, collider2, contacts, force_started: false }
    }

    /// The contacts of rigid bodies.
    pub fn rigid(&self) -> Option<&RigidPairContacts> {
        match &self.contacts {
            PairContacts::Rigid(rigid) => Some(rigid),
            PairContacts::Soft { .. } => None,
        }
    }

    /// The contacts of a soft body: none.
    pub fn soft(&self) -> Option<&SoftPairContacts> {
        match &self.contacts {
            PairContacts::Rigid(_) => None,
            PairContacts::Soft { candidates, .. } => Some(candidates),
        }
    }

    /// One manifold for each pair of convex parts.
    pub fn manifolds(&self) -> &[ContactManifold] {
        self.rigid().map_or(&[], |rigid| &rigid.manifolds)
    }

    /// The manifolds that are solved.
    pub fn solver_manifolds(&self) -> &[ContactManifold] {
        self.manifolds()
    }

    /// Returns whether the solver handles any contact.
    pub fn has_any_active_contact(&self) -> bool {
        self.manifolds().iter().any(|manifold| !manifold.data.solver_contacts.is_empty())
    }

    /// Removes all manifolds.
    pub fn clear(&mut self) {
        self.contacts = PairContacts::Rigid(RigidPairContacts::default());
    }

    /// Sum of the normal impulses of the last step.
    pub fn total_impulse(&self) -> Vector {
        self.manifolds()
            .iter()
            .map(|manifold| manifold.data.normal * manifold.total_impulse())
            .sum()
    }

    /// Sum of the magnitudes of the normal impulses of the last step.
    pub fn total_impulse_magnitude(&self) -> Real {
        self.manifolds().iter().map(ContactManifoldExt::total_impulse).sum()
    }

    /// The largest impulse of a manifold, and its direction.
    pub fn max_impulse(&self) -> (Real, Vector) {
        let impulses = self.manifolds().iter().map(|it| (it.total_impulse(), it.data.normal));
        let none = (0.0, Vector::ZERO);
        impulses.fold(none, |largest, next| if next.0 > largest.0 { next } else { largest })
    }

    /// The contact with the largest overlap, and its manifold.
    pub fn find_deepest_contact(&self) -> Option<(&ContactManifold, &Contact)> {
        let points =
            self.manifolds().iter().filter_map(|it| Some((it, it.find_deepest_contact()?)));
        points.min_by(|(_, one), (_, other)| one.dist.total_cmp(&other.dist))
    }
}
