//! Pairs of colliders whose boxes overlap, from the first overlap to the last.

use super::anchor_frame::AnchorFrame;
use super::lanes::ContactLanes;
use super::manifold::ContactManifold;
use super::store::Pair;
use super::triangle_cache::TriangleCache;
use crate::base::in_place::clone_in_place;
use crate::base::wide::prefetch;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::ColliderHandle;
use smallvec::SmallVec;

/// Two colliders that are close enough to touch, and their contact manifolds.
///
/// A pair exists as long as the colliders' fat AABBs overlap. Its manifolds persist from step to step: they
/// carry the impulses with which the next step starts.
#[derive(Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactPair {
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// The contacts; one manifold for each pair of convex parts.
    pub manifolds: SmallVec<[ContactManifold; 1]>,
    /// Whether the solver handled any contact in the last step.
    pub has_any_active_contact: bool,

    /// Whether the pair was reported as started and not yet as stopped.
    pub(crate) start_event_emitted: bool,
    /// Whether the pair is part of the structure, so that its bodies share an island.
    pub(crate) attached: bool,
    /// Pose of the second collider in the frame of the first when the manifolds were computed.
    pub(crate) pose12: Pose,
    /// World orientation of the bodies when the contact points were transformed.
    pub(crate) anchor_frame: AnchorFrame,
    /// Triangles of a mesh near the other collider, while neither shape changes. Only the running time
    /// depends on it.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(crate) triangle_cache: Option<Box<TriangleCache>>,
}

clone_in_place!(ContactPair {
    collider1,
    collider2,
    manifolds,
    has_any_active_contact,
    start_event_emitted,
    attached,
    pose12,
    anchor_frame,
    triangle_cache
});

impl Default for ContactPair {
    fn default() -> Self {
        Self::new(ColliderHandle::invalid(), ColliderHandle::invalid())
    }
}

impl ContactPair {
    /// A new pair without results.
    pub(crate) fn new(collider1: ColliderHandle, collider2: ColliderHandle) -> Self {
        Self {
            collider1,
            collider2,
            manifolds: SmallVec::new(),
            has_any_active_contact: false,
            start_event_emitted: false,
            attached: false,
            pose12: Pose::IDENTITY,
            anchor_frame: AnchorFrame::NOWHERE,
            triangle_cache: None,
        }
    }

    /// Returns whether any contact is close enough that the solver handled it in the last step: the field of
    /// the same name.
    pub fn has_any_active_contact(&self) -> bool {
        self.has_any_active_contact
    }

    /// Returns whether the two touch (within the prediction distance).
    pub(crate) fn is_touching(&self) -> bool {
        !self.manifolds.is_empty()
    }

    /// Returns whether all numbers can be computed with.
    pub(crate) fn is_sound(&self) -> bool {
        self.pose12.is_finite()
            && self.anchor_frame.is_sound()
            && self.manifolds.iter().all(ContactManifold::is_sound)
    }

    /// Sum of the normal impulses of all contacts on the second body during the last step, in world space
    /// (without friction).
    pub fn total_impulse(&self) -> Vector {
        self.manifolds.iter().map(|m| m.data.normal * m.impulse()).sum()
    }

    /// Sum of the magnitudes of all normal impulses during the last step.
    pub fn total_impulse_magnitude(&self) -> Real {
        self.manifolds.iter().map(ContactManifold::impulse).sum()
    }

    /// The largest normal impulse of one contact during the last step, and its direction in world space. Zero
    /// without contacts.
    pub fn max_impulse(&self) -> (Real, Vector) {
        let mut result = (0.0, Vector::ZERO);
        for manifold in &self.manifolds {
            for contact in &manifold.data {
                if contact.impulse > result.0 {
                    result = (contact.impulse, manifold.data.normal);
                }
            }
        }
        result
    }

    /// The deepest contact as (normal, point, depth), in world space as of the last step. `None` if there is
    /// no contact. The unit normal points from the first collider to the second. The point is midway between
    /// the two surfaces, and the depth is the overlap (negative: the distance).
    pub fn find_deepest_contact(&self) -> Option<(Vector, Vector, Real)> {
        let manifold = self
            .manifolds
            .iter()
            .filter(|m| !m.contacts().is_empty())
            .min_by(|a, b| a.deepest_dist().total_cmp(&b.deepest_dist()))?;
        let contact = manifold.find_deepest_contact()?;
        Some((manifold.data.normal, contact.point, -contact.dist))
    }
}

/// Two colliders, at least one of them a sensor, whose boxes overlap.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct IntersectionPair {
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// Whether the shapes intersect.
    pub intersecting: bool,
    /// Whether the pair was reported as started and not yet as stopped.
    pub(crate) start_event_emitted: bool,
}

impl IntersectionPair {
    /// A new pair without results.
    pub(crate) fn new(collider1: ColliderHandle, collider2: ColliderHandle) -> Self {
        Self { collider1, collider2, intersecting: false, start_event_emitted: false }
    }
}

impl Pair for ContactPair {
    fn colliders(&self) -> [ColliderHandle; 2] {
        [self.collider1, self.collider2]
    }

    fn began(&self) -> bool {
        self.start_event_emitted
    }

    fn prefetch_report(&self, lanes: &ContactLanes) {
        lanes.prefetch(self);
    }

    #[inline]
    fn prefetch_address(&self) {
        if let Some(triangle_cache) = self.triangle_cache.as_deref() {
            prefetch(triangle_cache);
        }
    }

    #[inline]
    fn prefetch_content(&self) {
        if let Some(triangle_cache) = self.triangle_cache.as_deref() {
            triangle_cache.prefetch();
        }
    }
}

impl Pair for IntersectionPair {
    fn colliders(&self) -> [ColliderHandle; 2] {
        [self.collider1, self.collider2]
    }

    fn began(&self) -> bool {
        self.start_event_emitted
    }
}
