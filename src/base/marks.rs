//! Marks on small numbers that are cleared all at once.

/// A set of `u32`s that is cleared in constant time: a mark is valid in the generation in which it was made.
/// Needs four bytes for each number up to the largest that was ever in it.
#[derive(Clone, Debug)]
pub struct Marks {
    /// Never 0, the value of unmarked elements.
    generation: u32,
    /// By number: the last generation in which it was marked.
    marked: Vec<u32>,
}

impl Default for Marks {
    fn default() -> Self {
        Self { generation: 1, marked: Vec::new() }
    }
}

impl Marks {
    /// Removes all marks.
    pub fn clear(&mut self) {
        self.generation = self.generation.wrapping_add(1);
        if self.generation == 0 {
            // After four billion generations old marks would be valid again.
            self.marked.fill(0);
            self.generation = 1;
        }
    }

    /// Marks a number.
    pub fn mark(&mut self, number: u32) {
        let index = number as usize;
        if index >= self.marked.len() {
            self.marked.resize((index + 1).next_power_of_two(), 0);
        }
        self.marked[index] = self.generation;
    }

    /// Returns whether the number is marked.
    #[inline(always)]
    pub fn has(&self, number: u32) -> bool {
        self.marked.get(number as usize) == Some(&self.generation)
    }
}

#[cfg(test)]
mod tests {
    use super::Marks;

    #[test]
    fn marks_are_taken_off_at_once() {
        let mut marks = Marks::default();
        marks.mark(3);
        marks.mark(70);
        assert!(marks.has(3) && marks.has(70) && !marks.has(4) && !marks.has(1000));
        marks.clear();
        assert!(!marks.has(3) && !marks.has(70));
        marks.generation = u32::MAX;
        marks.mark(5);
        marks.clear();
        assert!(!marks.has(3) && !marks.has(5), "old marks count again");
    }
}
