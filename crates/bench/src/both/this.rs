//! This engine.

#[path = "common.rs"]
mod common;
#[path = "contacts.rs"]
mod contacts;

use super::ours as engine;
use super::same as numbers;
use super::template::Template;
use crate::engine::{Counts, Engine, Probes, Stats};
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
        Some(common::count_hits(&self.world, probes, radius))
    }

    fn counts(&self) -> Counts {
        let mut counts = common::count_bodies(&self.world);
        contacts::count_contacts(&self.world, &mut counts);
        counts
    }

    fn stats(&self) -> Stats {
        common::measure(self.template, &self.world, &self.template.bodies, self.counts())
    }
}
