//! Checks that the views of a store agree.

use super::{Pair, PairId, PairStore, Place, slot};
use crate::base::fault::{Fault, ensure};
use crate::base::loading::{Loaded, check_when_loaded};

check_when_loaded!(PairStore<P>, P: Pair);

/// The views agree.
impl<P: Pair> Loaded for PairStore<P> {
    fn check_loaded(&self) -> Result<(), Fault> {
        self.check_ids()?;
        self.check_views()
    }
}

impl<P: Pair> PairStore<P> {
    /// Checks that the lists of colliders are those of the pairs.
    pub fn check_views(&self) -> Result<(), Fault> {
        let is_gone =
            |id: PairId| self.pairs.get(id as usize).is_none_or(|pair| pair.get().is_none());
        let gone = self.awake.iter().chain(self.strong.iter()).find(|&id| is_gone(id));
        ensure!(gone.is_none(), "pair {gone:?} is awake or strong, and gone");
        let asleep = self.reporting.iter().find(|&id| !self.is_awake(id));
        ensure!(asleep.is_none(), "pair {asleep:?} reports and sleeps");
        ensure!(self.iter().count() == self.len(), "{} pairs are counted", self.len());
        let living = self.pairs.iter().enumerate();
        let living = living.filter_map(|(id, pair)| Some((id as PairId, pair.get().as_ref()?)));
        let mut listed = 0;
        for (id, pair) in living {
            self.check_place(id, pair)?;
            listed += 2;
        }
        let lengths = self.of_collider.iter().map(|list| [list.ids.len(), list.slots.len()]);
        let sums = lengths.fold([0, 0], |sum, lengths| [sum[0] + lengths[0], sum[1] + lengths[1]]);
        ensure!(sums == [listed; 2], "colliders list {sums:?} pairs of {listed}");
        Ok(())
    }

    fn check_ids(&self) -> Result<(), Fault> {
        let bound = self.pairs.len();
        let lengths = [self.states.len(), self.places.len()];
        ensure!(lengths == [bound; 2], "{bound} pairs have {lengths:?} states and places");
        let sets = [&self.awake, &self.strong, &self.reporting];
        let are_below = sets.map(|set| set.is_below(bound));
        ensure!(are_below == [true; 3], "awake, strong, reporting below {bound}: {are_below:?}");
        let mut is_free = vec![false; bound];
        for &id in &self.free {
            let free = is_free.get_mut(id as usize);
            let was_free = free.map(|free| core::mem::replace(free, true));
            ensure!(
                was_free == Some(false),
                "pair {id} of {bound} is in the free list twice, or does not exist"
            );
        }
        for (id, pair) in self.pairs.iter().enumerate() {
            let (is_living, has_place) = (pair.get().is_some(), self.places[id] != Place::NOWHERE);
            ensure!(is_living == has_place, "pair {id} has a place: {has_place}");
            ensure!(is_living != is_free[id], "pair {id} is free: {}", is_free[id]);
        }
        Ok(())
    }

    fn check_place(&self, id: PairId, pair: &P) -> Result<(), Fault> {
        let Place { slots, positions } = self.places[id as usize];
        ensure!(slots == pair.colliders().map(slot), "pair {id} is filed under {slots:?}");
        ensure!(slots[0] != slots[1], "pair {id} is one collider, {}", slots[0]);
        for side in 0..2 {
            let (list, position) = (self.of_collider.get(slots[side] as usize), positions[side]);
            let entry = list.and_then(|list| {
                Some((*list.ids.get(position as usize)?, *list.slots.get(position as usize)?))
            });
            let expected = Some((id, slots[1 - side]));
            ensure!(entry == expected, "collider {} lists {entry:?} as pair {id}", slots[side]);
        }
        ensure!(self.find(pair.colliders()) == Some(id), "two pairs of {slots:?}: {id} is one");
        Ok(())
    }
}
