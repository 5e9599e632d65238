//! Stack of pending nodes.

/// Inline capacity: sufficient for all trees except adversarial ones.
const INLINE_CAPACITY: usize = 64;

/// Last in, first out. Without allocation while it is short.
pub struct Stack<T> {
    first: [T; INLINE_CAPACITY],
    len: usize,
    rest: Vec<T>,
}

impl<T: Copy> Stack<T> {
    /// Empty. `filler` is the value of unused elements.
    #[inline(always)]
    pub fn new(filler: T) -> Self {
        Self { first: [filler; INLINE_CAPACITY], len: 0, rest: Vec::new() }
    }

    #[inline(always)]
    pub fn push(&mut self, entry: T) {
        match self.first.get_mut(self.len) {
            Some(place) => {
                *place = entry;
                self.len += 1;
            }
            None => self.rest.push(entry),
        }
    }

    #[inline(always)]
    pub fn pop(&mut self) -> Option<T> {
        if self.len < INLINE_CAPACITY || self.rest.is_empty() {
            self.len = self.len.checked_sub(1)?;
            return Some(self.first[self.len]);
        }
        self.rest.pop()
    }
}

#[cfg(test)]
mod tests {
    use super::{INLINE_CAPACITY, Stack};

    #[test]
    fn the_last_item_leaves_first_beyond_the_capacity() {
        let (mut stack, mut plain) = (Stack::new(0), Vec::new());
        for round in 0..5 {
            for entry in 0..(INLINE_CAPACITY / 2 + 3 * round) {
                stack.push(entry);
                plain.push(entry);
            }
            for _ in 0..INLINE_CAPACITY / 4 {
                assert_eq!(stack.pop(), plain.pop());
            }
        }
        while let Some(entry) = plain.pop() {
            assert_eq!(stack.pop(), Some(entry));
        }
        assert_eq!(stack.pop(), None);
    }
}
