//! The search for the nearest: best first, through both trees.

use super::view::QueryView;
use crate::dim::math::Real;
use crate::model::collider::{Collider, ColliderHandle};
use core::cell::RefCell;
use parry::partitioning::BvhNode;

/// What was found, and how far away it is.
struct Best<T> {
    distance: Real,
    found: Option<(ColliderHandle, T)>,
}

impl<T> Best<T> {
    /// Can nothing at this slot be better? Of what is at no distance, only what stands at a lower slot is: the crowd in
    /// which a shape begins need not be looked at one by one.
    fn beats_all_at(&self, slot: u32) -> bool {
        let best = self.found.as_ref().map(|(handle, _)| handle.into_raw_parts().0);
        self.distance <= 0.0 && best.is_some_and(|best| best < slot)
    }

    /// Takes what is nearer, or as near and at a lower slot.
    fn offer(&mut self, distance: Real, handle: ColliderHandle, what: T) {
        let slot = |handle: ColliderHandle| handle.into_raw_parts().0;
        let is_better = match &self.found {
            None => distance <= self.distance,
            Some((best, _)) => (distance, slot(handle)) < (self.distance, slot(*best)),
        };
        if is_better {
            *self = Self { distance, found: Some((handle, what)) };
        }
    }
}

impl QueryView<'_> {
    /// The nearest of the colliders that are meant, no farther away than `limit`.
    ///
    /// `to_box` says how near anything in a box can be (infinite: nothing in it matters), given how far away the
    /// best so far is; `to_collider` how far away a collider is, and what else is to be known of it. It is not told what
    /// is known already: what a shape answers may depend on the limit in its last bit, and no answer may depend on the
    /// tree.
    pub(super) fn nearest<T>(
        &self,
        limit: Real,
        to_box: impl Fn(&BvhNode, Real) -> Real,
        to_collider: impl Fn(&Collider) -> Option<(Real, T)>,
    ) -> Option<(ColliderHandle, T)> {
        // Infinity is what nothing is nearer than, for the tree.
        let limit = limit.min(0.5 * Real::MAX);
        let best = RefCell::new(Best { distance: limit, found: None });
        for tree in self.trees() {
            let reach = best.borrow().distance;
            tree.find_best(
                reach.next_up(),
                // The tree goes where it is strictly better; what is as good must be looked at, too.
                |node, reach| to_box(node, reach).min(Real::MAX).next_down(),
                |slot, _| {
                    if best.borrow().beats_all_at(slot) {
                        return None;
                    }
                    let (handle, collider) = self.candidate(slot)?;
                    let (distance, what) = to_collider(collider)?;
                    best.borrow_mut().offer(distance, handle, what);
                    Some(distance)
                },
            );
        }
        best.into_inner().found
    }
}
