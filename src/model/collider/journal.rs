//! Journal of changed colliders, for users that cache data per collider, such as the trees of queries.

use crate::base::unique::unique_number;

/// Smallest number of stored entries, independent of the number of colliders.
const ENTRIES_MIN: usize = 1024;

/// Number of entries per collider. A reader that is farther behind visits all colliders, which is less work
/// than to read more entries.
const ENTRIES_PER_COLLIDER: usize = 2;

/// The slots of colliders in the order of their insertion, removal, mutable access, or change of their box in
/// the trees.
#[derive(Debug)]
pub(crate) struct Journal {
    /// Identifies the journal; copies of a set have other ids.
    id: u64,
    /// The number of the first entry that is kept.
    first: u64,
    slots: Vec<u32>,
}

/// Position of a reader.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Bookmark {
    journal: u64,
    next: u64,
}

impl Journal {
    /// Notes a change. `count` is the number of colliders.
    pub fn note(&mut self, slot: u32, count: usize) {
        if self.slots.len() >= ENTRIES_MIN + ENTRIES_PER_COLLIDER * count {
            self.first += self.slots.len() as u64;
            self.slots.clear();
        }
        self.slots.push(slot);
    }

    /// The changes since a bookmark was set; `None` if they are no longer stored, or the bookmark belongs to
    /// another journal. Then anything may have changed.
    pub fn since(&self, bookmark: Bookmark) -> Option<&[u32]> {
        let read = bookmark.next.checked_sub(self.first)?;
        if bookmark.journal == self.id { self.slots.get(read as usize..) } else { None }
    }

    /// The bookmark at the end of the journal.
    pub fn end(&self) -> Bookmark {
        Bookmark { journal: self.id, next: self.first + self.slots.len() as u64 }
    }
}

impl Default for Journal {
    fn default() -> Self {
        // Zero is never assigned, so that the default bookmark is always too old.
        Self { id: unique_number(), first: 0, slots: Vec::new() }
    }
}

/// A copy has a separate history.
impl Clone for Journal {
    fn clone(&self) -> Self {
        Self::default()
    }

    fn clone_from(&mut self, _: &Self) {
        self.id = unique_number();
        self.first = 0;
        self.slots.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::{Bookmark, ENTRIES_MIN, Journal};

    #[test]
    fn readers_get_each_change_after_their_bookmark() {
        let mut journal = Journal::default();
        assert_eq!(journal.since(Bookmark::default()), None);
        let start = journal.end();
        assert_eq!(journal.since(start), Some(&[][..]));
        journal.note(3, 1);
        journal.note(3, 1);
        let middle = journal.end();
        journal.note(5, 1);
        assert_eq!(journal.since(start), Some(&[3, 3, 5][..]));
        assert_eq!(journal.since(middle), Some(&[5][..]));
    }

    #[test]
    fn bookmarks_before_the_first_entry_are_outdated() {
        let mut journal = Journal::default();
        let start = journal.end();
        for slot in 0..=ENTRIES_MIN as u32 {
            journal.note(slot, 0);
        }
        assert_eq!(journal.since(start), None);
        let end = journal.end();
        journal.note(7, 0);
        assert_eq!(journal.since(end), Some(&[7][..]));
    }

    #[test]
    fn bookmarks_of_other_journals_are_refused() {
        let mut journal = Journal::default();
        journal.note(1, 1);
        let copy = journal.clone();
        assert_eq!(copy.since(journal.end()), None);
        assert_eq!(journal.since(copy.end()), None);
    }
}
