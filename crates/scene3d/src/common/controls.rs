//! Control of a scene by keys.

use crate::rapier::prelude::*;
use std::cell::Cell;
use std::rc::Rc;

/// Direction that the viewer chooses with keys, for the script of a scene. Copies share the direction.
#[derive(Clone, Debug)]
pub struct Controls {
    /// Sentence about the effect of the keys.
    pub sentence: &'static str,
    direction: Rc<Cell<Option<[Real; 2]>>>,
}

impl Controls {
    /// Controls that no key has touched yet.
    pub fn new(sentence: &'static str) -> Self {
        Self { sentence, direction: Rc::default() }
    }

    /// Returns right and up, each from -1 to 1. `None` before the first key: the scene drives itself.
    pub fn direction(&self) -> Option<[Real; 2]> {
        self.direction.get()
    }

    /// Sets right and up. Without a key the direction is zero, and an untouched scene drives itself.
    pub fn set(&self, direction: [Real; 2]) {
        if direction != [0.0; 2] || self.direction().is_some() {
            self.direction.set(Some(direction));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_released_key_stops_and_an_untouched_scene_drives_itself() {
        let controls = Controls::new("Arrow keys do nothing.");
        controls.set([0.0; 2]);
        assert_eq!(controls.direction(), None);
        controls.clone().set([1.0, 0.0]);
        assert_eq!(controls.direction(), Some([1.0, 0.0]));
        controls.set([0.0; 2]);
        assert_eq!(controls.direction(), Some([0.0; 2]));
    }
}
