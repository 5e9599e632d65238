//! A generational arena with handles.
//!
//! Slots are reused, last freed first. Each reuse raises the slot's generation, so that a handle to an
//! earlier element finds nothing. Iteration is in slot order: it depends on the order of insertions and
//! removals alone, never on addresses.

use super::disjoint::DisjointMut;
use super::fault::{Fault, ensure};
use super::in_place::clone_in_place;
use super::loading::{Loaded, check_when_loaded};
use super::wide::prefetch_front;

/// The slot of an element of an arena, and the generation of the slot.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Index {
    index: u32,
    generation: u32,
}

impl Default for Index {
    fn default() -> Self {
        Self::INVALID
    }
}

impl Index {
    /// An index that no arena ever hands out.
    pub const INVALID: Self = Self { index: u32::MAX, generation: u32::MAX };

    /// Puts an index together again from [`Self::into_raw_parts`].
    pub const fn from_raw_parts(index: u32, generation: u32) -> Self {
        Self { index, generation }
    }

    /// The slot and its generation.
    pub const fn into_raw_parts(self) -> (u32, u32) {
        (self.index, self.generation)
    }

    /// The slot alone.
    pub const fn slot(self) -> usize {
        self.index as usize
    }
}

#[derive(Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
// With a separate tag the generation is in front: every access reads it, and the front of the value.
#[repr(u32)]
enum Slot<T> {
    Free { generation: u32, next: Option<u32> },
    Taken { generation: u32, value: T },
}

impl<T: Clone> Clone for Slot<T> {
    fn clone(&self) -> Self {
        match self {
            Self::Free { generation, next } => Self::Free { generation: *generation, next: *next },
            Self::Taken { generation, value } => {
                Self::Taken { generation: *generation, value: value.clone() }
            }
        }
    }

    fn clone_from(&mut self, source: &Self) {
        match (self, source) {
            (
                Self::Taken { generation, value },
                Self::Taken { generation: source_generation, value: source },
            ) => {
                *generation = *source_generation;
                value.clone_from(source);
            }
            (slot, source) => *slot = source.clone(),
        }
    }
}

/// A list with holes, whose elements are found by generational [`Index`].
#[derive(Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
pub struct Arena<T> {
    slots: Vec<Slot<T>>,
    first_free: Option<u32>,
    len: usize,
}

clone_in_place!(Arena<T> { slots, first_free, len });

check_when_loaded!(Arena<T>, T: Sized);

/// The free slots form a list that contains each of them once.
impl<T> Loaded for Arena<T> {
    fn check_loaded(&self) -> Result<(), Fault> {
        let is_free = |slot: &&Slot<T>| matches!(slot, Slot::Free { .. });
        let free = self.slots.iter().filter(is_free).count();
        ensure!(self.slots.len() < u32::MAX as usize, "an arena has {} slots", self.slots.len());
        ensure!(self.len == self.slots.len() - free, "an arena of {} elements", self.len);
        let (mut next, mut listed) = (self.first_free, 0);
        while let Some(index) = next {
            let Some(Slot::Free { next: after, .. }) = self.slots.get(index as usize) else {
                return Err(Fault::new(format_args!("slot {index} of an arena is not free")));
            };
            // A list that is longer than there are free slots contains one of them twice.
            listed += 1;
            ensure!(listed <= free, "the free slots of an arena form a loop at {index}");
            next = *after;
        }
        ensure!(listed == free, "{listed} of {free} free slots of an arena are listed");
        Ok(())
    }
}

impl<T> Default for Arena<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T> Arena<T> {
    /// An empty arena.
    pub const fn new() -> Self {
        Self { slots: Vec::new(), first_free: None, len: 0 }
    }

    /// An empty arena with the given `capacity`, unless there is not enough memory.
    pub fn with_capacity(capacity: usize) -> Self {
        let mut arena = Self::new();
        // The capacity is a hint: a failed allocation has no effect until the elements are inserted.
        let _ = arena.slots.try_reserve_exact(capacity);
        arena
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Returns whether the arena is empty.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Number of slots, taken or free: every slot number is below it.
    pub fn slot_count(&self) -> usize {
        self.slots.len()
    }

    /// Adds an element and returns its index.
    ///
    /// # Panics
    /// At 2³² - 1 elements, more than memory holds.
    #[expect(clippy::expect_used, reason = "no memory holds so many")]
    pub fn insert(&mut self, value: T) -> Index {
        self.len += 1;
        if let Some(index) = self.first_free
            && let Some(slot) = self.slots.get_mut(index as usize)
            && let Slot::Free { next, generation } = *slot
        {
            self.first_free = next;
            *slot = Slot::Taken { generation, value };
            return Index { index, generation };
        }
        let index = u32::try_from(self.slots.len()).expect("an arena holds at most 2^32 - 1 slots");
        assert_ne!(index, u32::MAX, "an arena holds at most 2^32 - 1 slots");
        self.slots.push(Slot::Taken { generation: 0, value });
        Index { index, generation: 0 }
    }

    /// Takes an element out; `None` if the index is stale or foreign.
    pub fn remove(&mut self, index: Index) -> Option<T> {
        let slot = self.slots.get_mut(index.slot())?;
        match slot {
            Slot::Taken { generation, .. } if *generation == index.generation => {}
            _ => return None,
        }
        // u32::MAX is the generation of the invalid index: skip it when the counter wraps.
        let generation = match index.generation.wrapping_add(1) {
            u32::MAX => 0,
            next => next,
        };
        let free = Slot::Free { next: self.first_free, generation };
        self.first_free = Some(index.index);
        self.len -= 1;
        match core::mem::replace(slot, free) {
            Slot::Taken { value, .. } => Some(value),
            Slot::Free { .. } => None,
        }
    }

    /// Returns whether the index refers to an element.
    pub fn contains(&self, index: Index) -> bool {
        self.get(index).is_some()
    }

    /// The element at an index; `None` if the index is stale or foreign.
    #[inline]
    pub fn get(&self, index: Index) -> Option<&T> {
        match self.slots.get(index.slot()) {
            Some(Slot::Taken { generation, value }) if *generation == index.generation => {
                Some(value)
            }
            _ => None,
        }
    }

    /// The element at an index; `None` if the index is stale or foreign.
    #[inline]
    pub fn get_mut(&mut self, index: Index) -> Option<&mut T> {
        match self.slots.get_mut(index.slot()) {
            Some(Slot::Taken { generation, value }) if *generation == index.generation => {
                Some(value)
            }
            _ => None,
        }
    }

    /// Two elements at once; `None` for each stale index, and for the second one if both are the same.
    pub fn get2_mut(&mut self, a: Index, b: Index) -> (Option<&mut T>, Option<&mut T>) {
        if a.index == b.index {
            return if self.contains(a) {
                (self.get_mut(a), None)
            } else {
                (None, self.get_mut(b))
            };
        }
        let of = |slot: &'_ mut Slot<T>, index: Index| match slot {
            Slot::Taken { generation, value } if *generation == index.generation => {
                Some(value as *mut T)
            }
            _ => None,
        };
        let pa = self.slots.get_mut(a.slot()).and_then(|slot| of(slot, a));
        let pb = self.slots.get_mut(b.slot()).and_then(|slot| of(slot, b));
        // SAFETY: the slots differ, so the two references do not overlap, and both borrow `self`.
        unsafe { (pa.map(|p| &mut *p), pb.map(|p| &mut *p)) }
    }

    /// The element of a slot, with its index.
    #[inline]
    pub fn at_slot(&self, slot: u32) -> Option<(Index, &T)> {
        match self.slots.get(slot as usize) {
            Some(Slot::Taken { generation, value }) => {
                Some((Index { index: slot, generation: *generation }, value))
            }
            _ => None,
        }
    }

    /// The element of a slot, with its index.
    #[inline]
    pub fn at_slot_mut(&mut self, slot: u32) -> Option<(Index, &mut T)> {
        match self.slots.get_mut(slot as usize) {
            Some(Slot::Taken { generation, value }) => {
                Some((Index { index: slot, generation: *generation }, value))
            }
            _ => None,
        }
    }

    /// Gives several threads write access to elements.
    pub fn share(&mut self) -> SharedArena<'_, T> {
        SharedArena { slots: DisjointMut::new(&mut self.slots) }
    }

    /// Prefetches the first bytes of an element.
    #[inline(always)]
    pub fn prefetch_front(&self, slot: u32, bytes: usize) {
        if let Some(slot) = self.slots.get(slot as usize) {
            prefetch_front(slot, bytes + size_of::<Slot<T>>() - size_of::<T>());
        }
    }

    /// All elements in slot order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (Index, &T)> {
        self.slots.iter().enumerate().filter_map(|(index, slot)| match slot {
            Slot::Taken { generation, value } => {
                Some((Index { index: index as u32, generation: *generation }, value))
            }
            Slot::Free { .. } => None,
        })
    }

    /// All elements in slot order.
    pub fn iter_mut(&mut self) -> impl DoubleEndedIterator<Item = (Index, &mut T)> {
        self.slots.iter_mut().enumerate().filter_map(|(index, slot)| match slot {
            Slot::Taken { generation, value } => {
                Some((Index { index: index as u32, generation: *generation }, value))
            }
            Slot::Free { .. } => None,
        })
    }
}

/// An arena whose elements can be borrowed one by one, by several threads.
pub struct SharedArena<'a, T> {
    slots: DisjointMut<'a, Slot<T>>,
}

impl<'a, T> SharedArena<'a, T> {
    /// The element at an index, for writing; `None` if the index is stale or foreign.
    ///
    /// # Safety
    /// The caller has exclusive access to the slot while the reference lives.
    #[inline]
    pub unsafe fn get_mut(&self, index: Index) -> Option<&'a mut T> {
        if index.slot() >= self.slots.len() {
            return None;
        }
        // SAFETY: in range, and the caller owns the slot exclusively.
        match unsafe { self.slots.get_mut(index.slot()) } {
            Slot::Taken { generation, value } if *generation == index.generation => Some(value),
            _ => None,
        }
    }

    /// Prefetches the first bytes of an element.
    #[inline(always)]
    pub fn prefetch_front(&self, slot: u32, bytes: usize) {
        self.slots.prefetch_front(slot as usize, bytes + size_of::<Slot<T>>() - size_of::<T>());
    }
}
