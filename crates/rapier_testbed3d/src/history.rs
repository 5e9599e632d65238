//! The last seconds as copies of the scene.

use crate::scene::Scene;
use std::collections::VecDeque;

/// Steps between two copies.
const STRIDE: usize = 6;
/// Largest number of copies.
const COUNT_MAX: usize = 120;
/// Smallest number of copies, of however large a scene.
const COUNT_MIN: usize = 8;
/// Estimated bytes of a copy for a body, and the bytes that all copies may take.
const BYTES_PER_BODY: usize = 6_000;
const BYTES_MAX: usize = 500_000_000;

/// Copies of a scene, oldest first.
#[derive(Default)]
pub(crate) struct History {
    copies: VecDeque<Scene>,
    /// A dropped copy, whose memory the next one reuses.
    spare: Option<Scene>,
}

impl History {
    /// Saves the scene if a copy is due.
    pub(crate) fn after_step(&mut self, scene: &Scene) {
        if scene.steps_taken.is_multiple_of(STRIDE) {
            self.save(scene);
        }
    }

    /// Saves the scene.
    pub(crate) fn save(&mut self, scene: &Scene) {
        let bytes = BYTES_PER_BODY * scene.world.bodies.len().max(1);
        while self.copies.len() >= (BYTES_MAX / bytes).clamp(COUNT_MIN, COUNT_MAX) {
            self.spare = self.copies.pop_front();
        }
        let copy = match self.spare.take() {
            Some(mut spare) => {
                spare.clone_from(scene);
                spare
            }
            None => scene.clone(),
        };
        self.copies.push_back(copy);
    }

    /// Drops all copies.
    pub(crate) fn clear(&mut self) {
        self.copies.clear();
    }

    /// Number of copies.
    pub(crate) fn len(&self) -> usize {
        self.copies.len()
    }

    /// A copy by its position.
    pub(crate) fn get(&self, position: usize) -> Option<&Scene> {
        self.copies.get(position)
    }

    /// Drops the copies behind a position.
    pub(crate) fn truncate(&mut self, position: usize) {
        self.copies.truncate(position + 1);
    }
}
