//! A list with holes, whose elements have generational indices.

pub use engine::data::Index;

/// A list with holes. A removed element leaves a hole, which a later element fills with another generation.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Arena<T> {
    /// Generation and element of each slot.
    slots: Vec<(u32, Option<T>)>,
    /// The holes. The last one is filled first.
    holes: Vec<u32>,
}

/// Owning iterator of an arena.
pub type IntoIter<T> = std::vec::IntoIter<(Index, T)>;
/// Iterator that empties an arena.
pub type Drain<'a, T> = std::vec::IntoIter<(Index, T)>;
/// Iterator of an arena.
pub type Iter<'a, T> = std::vec::IntoIter<(Index, &'a T)>;
/// Mutable iterator of an arena.
pub type IterMut<'a, T> = std::vec::IntoIter<(Index, &'a mut T)>;

impl<T> Default for Arena<T> {
    fn default() -> Self {
        Self { slots: Vec::new(), holes: Vec::new() }
    }
}

impl<T> Arena<T> {
    /// An empty arena.
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty arena with space for `capacity` elements.
    pub fn with_capacity(capacity: usize) -> Self {
        Self { slots: Vec::with_capacity(capacity), holes: Vec::new() }
    }

    /// Removes all elements.
    pub fn clear(&mut self) {
        self.drain();
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.slots.len() - self.holes.len()
    }

    /// Returns whether the arena is empty.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of elements for which memory is reserved.
    pub fn capacity(&self) -> usize {
        self.slots.capacity()
    }

    /// Reserves memory for more elements.
    pub fn reserve(&mut self, additional_capacity: usize) {
        self.slots.reserve(additional_capacity);
    }

    /// Inserts an element.
    pub fn insert(&mut self, value: T) -> Index {
        self.insert_with(|_| value)
    }

    /// Inserts an element that depends on its index.
    pub fn insert_with(&mut self, create: impl FnOnce(Index) -> T) -> Index {
        let slot = self.holes.pop().unwrap_or_else(|| {
            self.slots.push((0, None));
            self.slots.len() as u32 - 1
        });
        let (generation, element) = &mut self.slots[slot as usize];
        let index = Index::from_raw_parts(slot, *generation);
        *element = Some(create(index));
        index
    }

    /// Inserts an element if no memory must be allocated; otherwise returns it.
    pub fn try_insert(&mut self, value: T) -> Result<Index, T> {
        if self.has_space() { Ok(self.insert(value)) } else { Err(value) }
    }

    /// Inserts an element that depends on its index if no memory must be allocated.
    pub fn try_insert_with<F: FnOnce(Index) -> T>(&mut self, create: F) -> Result<Index, F> {
        if self.has_space() { Ok(self.insert_with(create)) } else { Err(create) }
    }

    fn has_space(&self) -> bool {
        !self.holes.is_empty() || self.slots.len() < self.slots.capacity()
    }

    /// Removes an element. `None` if the index is stale.
    pub fn remove(&mut self, index: Index) -> Option<T> {
        let (slot, generation) = index.into_raw_parts();
        let (current, element) = self.slots.get_mut(slot as usize)?;
        let removed = if *current == generation { element.take() } else { None }?;
        *current = current.wrapping_add(1);
        self.holes.push(slot);
        Some(removed)
    }

    /// Removes all elements for which the predicate returns `false`.
    pub fn retain(&mut self, mut predicate: impl FnMut(Index, &mut T) -> bool) {
        let rejected: Vec<_> =
            self.iter_mut().filter_map(|(at, it)| (!predicate(at, it)).then_some(at)).collect();
        for index in rejected {
            self.remove(index);
        }
    }

    /// Removes all elements, in the order of their slots.
    pub fn drain(&mut self) -> Drain<'_, T> {
        let indices: Vec<_> = self.iter().map(|(index, _)| index).collect();
        let removed = indices.into_iter().filter_map(|index| Some((index, self.remove(index)?)));
        removed.collect::<Vec<_>>().into_iter()
    }

    /// Returns whether the index is that of an element.
    pub fn contains(&self, index: Index) -> bool {
        self.get(index).is_some()
    }

    /// An element. `None` if the index is stale.
    pub fn get(&self, index: Index) -> Option<&T> {
        let (element, current) = self.get_unknown_gen(index.into_raw_parts().0)?;
        (current == index).then_some(element)
    }

    /// Mutable access to an element. `None` if the index is stale.
    pub fn get_mut(&mut self, index: Index) -> Option<&mut T> {
        let (element, current) = self.get_unknown_gen_mut(index.into_raw_parts().0)?;
        (current == index).then_some(element)
    }

    /// Mutable access to two elements. `None` for a stale index.
    ///
    /// # Panics
    /// If both indices are equal.
    pub fn get2_mut(&mut self, index1: Index, index2: Index) -> (Option<&mut T>, Option<&mut T>) {
        assert!(index1 != index2, "both elements have the index {index1:?}");
        let (mut first, mut second) = (None, None);
        for (index, element) in self.iter_mut() {
            if index == index1 {
                first = Some(element);
            } else if index == index2 {
                second = Some(element);
            }
        }
        (first, second)
    }

    /// The element in a slot, with its index.
    pub fn get_unknown_gen(&self, slot: u32) -> Option<(&T, Index)> {
        let (generation, element) = self.slots.get(slot as usize)?;
        Some((element.as_ref()?, Index::from_raw_parts(slot, *generation)))
    }

    /// Mutable access to the element in a slot, with its index.
    pub fn get_unknown_gen_mut(&mut self, slot: u32) -> Option<(&mut T, Index)> {
        let (generation, element) = self.slots.get_mut(slot as usize)?;
        Some((element.as_mut()?, Index::from_raw_parts(slot, *generation)))
    }

    /// All elements, in the order of their slots.
    pub fn iter(&self) -> Iter<'_, T> {
        let slots = (0..).zip(&self.slots).filter_map(|(slot, (generation, element))| {
            Some((Index::from_raw_parts(slot, *generation), element.as_ref()?))
        });
        slots.collect::<Vec<_>>().into_iter()
    }

    /// All elements, mutably, in the order of their slots.
    pub fn iter_mut(&mut self) -> IterMut<'_, T> {
        let slots = (0..).zip(&mut self.slots).filter_map(|(slot, (generation, element))| {
            Some((Index::from_raw_parts(slot, *generation), element.as_mut()?))
        });
        slots.collect::<Vec<_>>().into_iter()
    }
}

impl<T> core::ops::Index<Index> for Arena<T> {
    type Output = T;

    fn index(&self, index: Index) -> &T {
        self.get(index).unwrap_or_else(|| panic!("no element has the index {index:?}"))
    }
}

impl<T> core::ops::IndexMut<Index> for Arena<T> {
    fn index_mut(&mut self, index: Index) -> &mut T {
        self.get_mut(index).unwrap_or_else(|| panic!("no element has the index {index:?}"))
    }
}

impl<T> Extend<T> for Arena<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, values: I) {
        values.into_iter().for_each(|value| {
            self.insert(value);
        });
    }
}

impl<T> FromIterator<T> for Arena<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        let mut arena = Self::new();
        arena.extend(values);
        arena
    }
}

impl<T> IntoIterator for Arena<T> {
    type Item = (Index, T);
    type IntoIter = IntoIter<T>;

    fn into_iter(mut self) -> IntoIter<T> {
        self.drain()
    }
}

impl<'a, T> IntoIterator for &'a Arena<T> {
    type Item = (Index, &'a T);
    type IntoIter = Iter<'a, T>;

    fn into_iter(self) -> Iter<'a, T> {
        self.iter()
    }
}

impl<'a, T> IntoIterator for &'a mut Arena<T> {
    type Item = (Index, &'a mut T);
    type IntoIter = IterMut<'a, T>;

    fn into_iter(self) -> IterMut<'a, T> {
        self.iter_mut()
    }
}
