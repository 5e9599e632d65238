//! This engine.

#[path = "common.rs"]
mod common;

use super::ours as engine;
use super::template::Template;
use crate::engine::{Engine, Probes, Stats};
use common::{count_hits, note_bodies};
use engine::prelude::*;

/// A world in this engine.
pub struct This<'t> {
    template: &'t Template,
    world: PhysicsWorld,
}

impl<'t> This<'t> {
    /// The scene at its start.
    pub fn new(template: &'t Template) -> Self {
        Self { template, world: template.fresh_world() }
    }
}

impl Engine for This<'_> {
    fn step(&mut self) {
        self.world.step();
    }

    fn cast(&self, probes: &Probes, radius: Option<f32>) -> Option<usize> {
        Some(count_hits(&self.world, probes, radius))
    }

    fn stats(&self) -> Stats {
        let mut stats = Stats::default();
        let pairs = self.world.contact_pairs().map(|(_, _, pair)| pair);
        for pair in pairs.filter(|pair| pair.has_any_active_contact) {
            stats.pairs += 1;
            stats.points +=
                pair.manifolds.iter().map(|m| m.data.num_active_contacts()).sum::<usize>();
        }
        let bodies: Vec<&RigidBody> =
            self.template.bodies.iter().map(|&handle| &self.world.bodies[handle]).collect();
        note_bodies(self.template, &bodies, &mut stats);
        stats
    }
}
