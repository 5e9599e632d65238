//! Rapier from its published crates.
//!
//! Its defaults are what its authors recommend and what its own benchmarks use: 4 solver iterations,
//! contact recycling and clustering, friction in the relax pass only. Geometry, mathematics and the
//! numbers of the collision groups are the same types as ours, so shapes are shared.

#[path = "common.rs"]
mod common;
#[path = "transcribe.rs"]
mod transcribe;

use super::peer as engine;
use super::same as numbers;
use super::template::Template;
use crate::engine::{Counts, Engine, Probes, Stats, Unsupported};
use engine::prelude::*;

/// A world in Rapier.
pub struct Rapier<'t> {
    template: &'t Template,
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
}

impl<'t> Rapier<'t> {
    /// The scene at its start.
    pub fn new(template: &'t Template) -> Result<Self, Unsupported> {
        let (world, bodies) = transcribe::world(template)?;
        Ok(Self { template, world, bodies })
    }
}

impl Engine for Rapier<'_> {
    fn step(&mut self) {
        self.world.step();
    }

    fn cast(&self, probes: &Probes, radius: Option<f32>) -> Option<usize> {
        Some(common::count_hits(&self.world, probes, radius))
    }

    fn counts(&self) -> Counts {
        let mut counts = common::count_bodies(&self.world);
        for pair in self.world.contact_pairs().filter(|pair| pair.has_any_active_contact()) {
            counts.pairs += 1;
            counts.points +=
                pair.manifolds().iter().map(|m| m.data.num_active_contacts()).sum::<usize>();
        }
        counts
    }

    fn stats(&self) -> Stats {
        common::measure(self.template, &self.world, &self.bodies, self.counts())
    }
}
