//! Best-first search for the nearest collider, through all trees.

use super::view::QueryView;
use crate::base::bvh::{Probe, nearest};
use crate::dim::math::Real;
use crate::model::collider::{Collider, ColliderHandle};

/// The result and its distance.
struct Best<T> {
    /// Lower bound of the distance.
    least: Real,
    distance: Real,
    found: Option<(ColliderHandle, T)>,
}

fn slot(handle: ColliderHandle) -> u32 {
    handle.into_raw_parts().0
}

impl<T> Best<T> {
    /// Returns whether the collider at this slot cannot be better. At the smallest possible distance only a
    /// lower slot is better: the crowd in which a shape begins need not be searched one by one.
    fn beats_all_at(&self, other: u32) -> bool {
        self.distance <= self.least
            && self.found.as_ref().is_some_and(|(best, _)| slot(*best) < other)
    }

    /// Stores a result that is nearer, or equally near and at a lower slot.
    fn offer(&mut self, distance: Real, handle: ColliderHandle, what: T) {
        let is_better = match &self.found {
            None => distance <= self.distance,
            Some((best, _)) => (distance, slot(handle)) < (self.distance, slot(*best)),
        };
        if is_better {
            *self = Self { distance, found: Some((handle, what)), ..*self };
        }
    }
}

impl QueryView<'_> {
    /// The nearest of the filtered colliders, no farther away than the second of `limits`. The first limit is
    /// the smallest possible distance.
    ///
    /// `probe` returns a lower bound of the distance for a box; `to_collider` the distance of a collider and
    /// its result. It does not receive the current limit, on which the last bit of a shape's result may
    /// depend. No result may depend on the tree.
    pub(super) fn nearest<T>(
        &self,
        [least, limit]: [Real; 2],
        probe: &impl Probe,
        to_collider: impl Fn(&Collider) -> Option<(Real, T)>,
    ) -> Option<(ColliderHandle, T)> {
        // Empty lanes have infinite distances.
        let mut best = Best { least, distance: limit.min(0.5 * Real::MAX), found: None };
        for tree in self.trees() {
            let reach = best.distance;
            let prepare = |slot| self.colliders.prefetch(slot);
            nearest(tree, probe, reach, prepare, |slot| {
                if !best.beats_all_at(slot)
                    && let Some((handle, collider)) = self.candidate(slot)
                    && let Some((distance, what)) = to_collider(collider)
                {
                    best.offer(distance, handle, what);
                }
                best.distance
            });
        }
        best.found
    }
}
