//! The pairs of one kind that one collider would have to bear, and which of them are left out.

use crate::model::collider::ColliderHandle;

/// Two colliders, the one with the lower slot first.
pub(super) type HandlePair = (ColliderHandle, ColliderHandle);

/// How far away the slot of the other one is.
pub(super) type Remoteness = u32;

/// The pairs with the nearest slots, so many as one may bear. Of thousands only these are ever kept.
#[derive(Default)]
pub(super) struct Borne {
    pairs: Vec<(Remoteness, HandlePair)>,
    most: usize,
    /// From which remoteness on a pair is certainly left out.
    limit: Option<Remoteness>,
}

impl Borne {
    /// Starts with none.
    pub fn clear(&mut self, most: usize) {
        self.pairs.clear();
        (self.most, self.limit) = (most, None);
    }

    /// Would a pair so remote certainly be left out?
    #[inline]
    pub fn leaves_out(&self, remoteness: Remoteness) -> bool {
        self.limit.is_some_and(|limit| remoteness >= limit)
    }

    /// Adds a pair. When there are twice as many as may be, the remote half goes.
    #[inline]
    pub fn push(&mut self, remoteness: Remoteness, pair: HandlePair) {
        self.pairs.push((remoteness, pair));
        if self.pairs.len() > self.most.saturating_mul(2) {
            self.drop_remote();
        }
    }

    /// Drops what is too much, and puts the rest into order if anything ever was. Returns whether it was.
    pub fn settle(&mut self) -> bool {
        if self.pairs.len() > self.most {
            self.drop_remote();
        }
        let was_full = self.limit.is_some();
        if was_full {
            self.pairs.sort_unstable();
        }
        was_full
    }

    /// What is left.
    pub fn pairs(&self) -> impl Iterator<Item = HandlePair> {
        self.pairs.iter().map(|&(_, pair)| pair)
    }

    fn drop_remote(&mut self) {
        let (_, &mut (limit, _), _) = self.pairs.select_nth_unstable(self.most);
        self.pairs.truncate(self.most);
        self.limit = Some(limit);
    }
}
