//! This engine.

use super::ours::prelude::*;
use super::overlap::deepest_overlap;
use super::template::Template;
use super::vector_of;
use crate::engine::{Engine, Probes, Stats};

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
        let PhysicsWorld { broad_phase, narrow_phase, bodies, colliders, .. } = &self.world;
        let dispatcher = narrow_phase.query_dispatcher();
        let all = QueryFilter::default();
        let queries = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, all);
        let ball = radius.map(Ball::new);
        let options = ShapeCastOptions::with_max_time_of_impact(probes.reach);
        let hits =
            probes.origins.iter().zip(&probes.directions).filter(|&(&origin, &direction)| {
                let (origin, direction) = (vector_of(origin), vector_of(direction));
                match &ball {
                    None => {
                        queries.cast_ray(&Ray::new(origin, direction), probes.reach, true).is_some()
                    }
                    Some(ball) => {
                        let start = Pose::from_translation(origin);
                        queries.cast_shape(&start, direction, ball, options).is_some()
                    }
                }
            });
        Some(hits.count())
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
