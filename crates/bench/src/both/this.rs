//! This engine.

use super::ours::prelude::*;
use super::overlap::deepest_overlap;
use super::template::Template;
use crate::engine::{Engine, Stats};

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
        let moving = bodies.iter().filter(|body| body.is_dynamic());
        stats.kinetic_energy = moving.map(|body| f64::from(body.kinetic_energy())).sum();
        let poses: Vec<Pose> = bodies.iter().map(|body| *body.position()).collect();
        stats.overlap = deepest_overlap(self.template, &poses);
        stats
    }
}
