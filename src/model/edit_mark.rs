//! Edit marks: detection of records that were replaced through a `&mut`.
//!
//! A `&mut` to a body or collider allows more than its setters. The user may assign a copy, or swap two of
//! them, of one world or of two. The record contains *its own* position in the lists, and its partners. A
//! record that is handed out therefore gets a [unique number](crate::base::unique), and the set stores the
//! number with its note of the edit. The next step treats a record with another number as new. Attaching a
//! collider edits two sets: it renews the numbers, so that an older copy of the record differs, too.
//!
//! A removed record leaves its set before the step compares it with its note. Its removal therefore retires
//! its number. A note whose record is gone and whose number is not retired belongs to a record that was
//! replaced first. The removed one had other partners. A copy that was made before any edit has no number at
//! all, so nothing else distinguishes it.

use crate::base::hash::FastHashMap;
use crate::base::unique::unique_number;

/// The number of a note whose own record was removed. No record has this number.
const NUMBER_RETIRED: u64 = u64::MAX;

/// The mark of a record. It is meaningless once the step has applied the note.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct EditMark {
    number: u64,
    /// The position of the note.
    note: u32,
}

/// By note: the number of the record.
#[derive(Clone, Debug, Default)]
pub(crate) struct EditMarks(Vec<u64>);

impl EditMarks {
    /// The new mark of a record whose note is at a position.
    pub fn mark(&mut self, note: usize) -> EditMark {
        if note >= self.0.len() {
            self.0.resize(note + 1, 0);
        }
        self.0[note] = unique_number();
        EditMark { number: self.0[note], note: note as u32 }
    }

    /// Gives a record another number, unless it is not the one that was noted.
    pub fn renew(&mut self, mark: &mut EditMark) {
        if let Some(number) = self.0.get_mut(mark.note as usize)
            && *number == mark.number
        {
            *number = unique_number();
            mark.number = *number;
        }
    }

    /// The record of a mark is removed. Nothing happens if it is not the one of its note.
    pub fn retire(&mut self, mark: EditMark) {
        if let Some(number) = self.0.get_mut(mark.note as usize)
            && *number == mark.number
        {
            *number = NUMBER_RETIRED;
        }
    }

    /// Returns whether the record that was removed, of the note at a position, was the one of the note.
    /// Loaded notes have no numbers: their records are compared with the other sets when the world is
    /// checked.
    pub fn was_of(&self, note: usize) -> bool {
        self.0.get(note).is_none_or(|&number| number == NUMBER_RETIRED || number == 0)
    }

    /// Returns whether a record is the one of the note at a position.
    pub fn is_of(&self, mark: EditMark, note: usize) -> bool {
        // Marks are not saved.
        mark.number == self.0.get(note).copied().unwrap_or(0)
    }

    /// Returns whether a record is the one of its note.
    pub fn matches_note(&self, mark: EditMark) -> bool {
        self.is_of(mark, mark.note as usize)
    }

    /// Marks all notes as applied.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}

/// The position of the first note of each record, by the raw parts of its handle. A record that was replaced
/// may have left a second note.
pub(crate) fn first_notes(
    handles: impl Iterator<Item = (u32, u32)>,
) -> FastHashMap<(u32, u32), usize> {
    let mut notes = FastHashMap::default();
    for (note, handle) in handles.enumerate() {
        notes.entry(handle).or_insert(note);
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::{EditMark, EditMarks};

    #[test]
    fn marks_of_other_records_and_older_copies_do_not_match() {
        let (mut one, mut two) = (EditMarks::default(), EditMarks::default());
        let [first, second] = [one.mark(0), one.mark(1)];
        assert!(one.is_of(first, 0) && !one.is_of(first, 1) && one.matches_note(second));
        let foreign = two.mark(0);
        assert!(
            !one.matches_note(foreign)
                && two.matches_note(foreign)
                && !one.matches_note(EditMark::default())
        );
        let mut newer = first;
        one.renew(&mut newer);
        assert!(one.matches_note(newer) && !one.matches_note(first));
        one.retire(first);
        assert!(!one.was_of(0), "an older copy was removed");
        one.retire(newer);
        assert!(one.was_of(0) && !one.was_of(1) && !one.matches_note(newer));
        one.clear();
        assert!(one.matches_note(EditMark::default()), "loaded records have no number");
    }
}
