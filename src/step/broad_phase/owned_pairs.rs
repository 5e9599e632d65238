//! The new pairs of one kind that one collider owns, limited to a maximum.

use crate::model::collider::ColliderHandle;

/// Two colliders, the one with the lower slot first.
pub(super) type HandlePair = (ColliderHandle, ColliderHandle);

/// Distance of the two slots.
pub(super) type SlotDistance = u32;

/// The pairs with the smallest slot distance, up to the limit of the owner. Only these are kept, of possibly
/// thousands.
#[derive(Default)]
pub(super) struct OwnedPairs {
    pairs: Vec<(SlotDistance, HandlePair)>,
    most: usize,
    /// Slot distance from which on a pair is dropped.
    limit: Option<SlotDistance>,
}

impl OwnedPairs {
    /// Starts with none.
    pub fn clear(&mut self, most: usize) {
        self.pairs.clear();
        (self.most, self.limit) = (most, None);
    }

    /// Returns whether a pair at this slot distance is certainly dropped.
    #[inline]
    pub fn leaves_out(&self, slot_distance: SlotDistance) -> bool {
        self.limit.is_some_and(|limit| slot_distance >= limit)
    }

    /// Adds a pair. At twice the limit, the half with the larger slot distances is dropped.
    #[inline]
    pub fn push(&mut self, slot_distance: SlotDistance, pair: HandlePair) {
        self.pairs.push((slot_distance, pair));
        if self.pairs.len() > self.most.saturating_mul(2) {
            self.drop_distant();
        }
    }

    /// Lower bound of their number: dropped ones beyond the limit are not counted.
    pub fn len(&self) -> usize {
        self.pairs.len() + usize::from(self.limit.is_some())
    }

    /// The pairs with the smallest slot distances, at most `places`. They are sorted only if there are more.
    pub fn nearest(&mut self, places: usize) -> impl Iterator<Item = HandlePair> {
        if self.len() > places {
            self.pairs.sort_unstable();
        }
        self.pairs.iter().map(|&(_, pair)| pair).take(places)
    }

    fn drop_distant(&mut self) {
        let (_, &mut (limit, _), _) = self.pairs.select_nth_unstable(self.most);
        self.pairs.truncate(self.most);
        self.limit = Some(limit);
    }
}
