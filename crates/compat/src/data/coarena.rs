//! Data beside an arena.

use super::Index;

/// Data of the elements of another arena, by their indices.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Coarena<T> {
    /// Generation and data of each slot.
    slots: Vec<(u32, T)>,
}

/// The generation of slots without data.
const ABSENT: u32 = u32::MAX;

impl<T> Coarena<T> {
    /// An empty coarena.
    pub fn new() -> Self {
        Self { slots: Vec::new() }
    }

    /// Reserves memory for more elements.
    pub fn reserve(&mut self, additional: usize) {
        self.slots.reserve(additional);
    }

    /// All data with the indices of their elements, in the order of the slots.
    pub fn iter(&self) -> impl Iterator<Item = (Index, &T)> {
        (0..)
            .zip(&self.slots)
            .filter(|(_, (generation, _))| *generation != ABSENT)
            .map(|(slot, (generation, data))| (Index::from_raw_parts(slot, *generation), data))
    }

    /// The data of a slot, of any generation.
    pub fn get_unknown_gen(&self, slot: u32) -> Option<&T> {
        self.slots.get(slot as usize).map(|(_, data)| data)
    }

    /// Mutable access to the data of a slot, of any generation.
    pub fn get_mut_unknown_gen(&mut self, slot: u32) -> Option<&mut T> {
        self.slots.get_mut(slot as usize).map(|(_, data)| data)
    }

    /// The data of an element.
    pub fn get(&self, index: Index) -> Option<&T> {
        let (slot, generation) = index.into_raw_parts();
        let (current, data) = self.slots.get(slot as usize)?;
        (*current == generation).then_some(data)
    }

    /// Mutable access to the data of an element.
    pub fn get_mut(&mut self, index: Index) -> Option<&mut T> {
        let (slot, generation) = index.into_raw_parts();
        let (current, data) = self.slots.get_mut(slot as usize)?;
        (*current == generation).then_some(data)
    }

    /// Removes the data of an element. `removed_value` takes its place.
    pub fn remove(&mut self, index: Index, removed_value: T) -> Option<T> {
        let (slot, generation) = index.into_raw_parts();
        let (current, data) = self.slots.get_mut(slot as usize)?;
        if *current != generation {
            return None;
        }
        *current = ABSENT;
        Some(core::mem::replace(data, removed_value))
    }
}

impl<T: Clone> Coarena<T> {
    /// Sets the data of an element.
    pub fn insert(&mut self, index: Index, value: T)
    where
        T: Default,
    {
        let (slot, generation) = index.into_raw_parts();
        self.grow(slot, T::default());
        self.slots[slot as usize] = (generation, value);
    }

    /// The data of an element; `default` if it has none yet.
    pub fn ensure_element_exist(&mut self, index: Index, default: T) -> &mut T {
        let (slot, generation) = index.into_raw_parts();
        self.grow(slot, default.clone());
        let place = &mut self.slots[slot as usize];
        if place.0 != generation {
            *place = (generation, default);
        }
        &mut place.1
    }

    /// The data of two elements; `default` for one that has none yet.
    ///
    /// # Panics
    /// If both elements have the same slot.
    pub fn ensure_pair_exists(
        &mut self,
        index1: Index,
        index2: Index,
        default: T,
    ) -> (&mut T, &mut T) {
        self.ensure_element_exist(index1, default.clone());
        self.ensure_element_exist(index2, default);
        let slots = [index1, index2].map(|index| index.into_raw_parts().0 as usize);
        let [(_, first), (_, second)] =
            self.slots.get_disjoint_mut(slots).expect("two elements with different slots");
        (first, second)
    }

    fn grow(&mut self, slot: u32, default: T) {
        if self.slots.len() <= slot as usize {
            self.slots.resize(slot as usize + 1, (ABSENT, default));
        }
    }
}
