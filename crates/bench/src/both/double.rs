//! This engine in double precision.

#[path = "common.rs"]
mod common;
#[path = "contacts.rs"]
mod contacts;
#[path = "transcribe.rs"]
mod transcribe;

use super::double_engine as engine;
use super::template::Template;
use super::wide as numbers;
use crate::engine::{Counts, Engine, Probes, Stats, Unsupported};
use engine::prelude::*;

/// A world in this engine's crate for double precision.
pub struct Double<'t> {
    template: &'t Template,
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
}

impl<'t> Double<'t> {
    /// The scene at its start.
    pub fn new(template: &'t Template) -> Result<Self, Unsupported> {
        let (world, bodies) = transcribe::world(template)?;
        Ok(Self { template, world, bodies })
    }
}

impl Engine for Double<'_> {
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
        common::measure(self.template, &self.world, &self.bodies, self.counts())
    }
}
