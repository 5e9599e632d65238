//! Edit marks: whether a record that was handed out for changing is still the one that it was.
//!
//! A `&mut` to a body or collider allows more than its setters: the user may assign a copy, or swap two of them, of one world or of two. The record
//! brings along where *it* stood, and which partners it had. So a record that is handed out gets a [unique number](crate::base::unique), and the set
//! stores the number with its note of the edit. The next step takes a record whose number is another as new. Attaching a collider edits two sets: it
//! renews the numbers, so that an older copy of the record differs, too.

use crate::base::unique::unique_number;

/// The mark of a record. It means nothing once the step has taken in the note.
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

    /// Returns whether a record is the one of the note at a position.
    pub fn is_of(&self, mark: EditMark, note: usize) -> bool {
        // Marks are not saved.
        mark.number == self.0.get(note).copied().unwrap_or(0)
    }

    /// Returns whether a record is the one of its note.
    pub fn knows(&self, mark: EditMark) -> bool {
        self.is_of(mark, mark.note as usize)
    }

    /// All notes were taken in.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::{EditMark, EditMarks};

    #[test]
    fn marks_of_other_records_and_older_copies_are_not_known() {
        let (mut one, mut two) = (EditMarks::default(), EditMarks::default());
        let [first, second] = [one.mark(0), one.mark(1)];
        assert!(one.is_of(first, 0) && !one.is_of(first, 1) && one.knows(second));
        let foreign = two.mark(0);
        assert!(!one.knows(foreign) && two.knows(foreign) && !one.knows(EditMark::default()));
        let mut newer = first;
        one.renew(&mut newer);
        assert!(one.knows(newer) && !one.knows(first));
        one.clear();
        assert!(one.knows(EditMark::default()), "loaded records have no number");
    }
}
