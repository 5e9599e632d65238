//! A world that runs in an engine with this engine's interface. The file is compiled three times: for this
//! engine, for its double precision, and for Rapier. Each parent module binds the names `engine` (the crate)
//! and `numbers` (the conversions), and defines `count_contacts`, because the engines store contacts
//! differently.

use super::super::overlap::overlap;
use super::super::separation::largest_separation;
use super::super::template::Template;
use super::super::vector_of;
use super::engine::parry::query::ShapeCastOptions;
use super::engine::prelude::*;
use super::{count_contacts, numbers, saving};
use crate::engine::{Counts, Engine, Probes, Stats};
use std::borrow::Cow;

/// World in the engine.
pub struct Running<'t> {
    /// Template of the world.
    pub template: &'t Template,
    /// The world in its present state.
    pub world: PhysicsWorld,
    /// Bodies, in the template's order.
    pub bodies: Cow<'t, [RigidBodyHandle]>,
}

impl Engine for Running<'_> {
    fn step(&mut self) {
        self.world.step();
    }

    fn counts(&self) -> Counts {
        let awake = |(_, body): &(_, &RigidBody)| body.is_dynamic() && !body.is_sleeping();
        let mut counts = Counts {
            bodies: self.world.bodies.len(),
            awake: self.world.bodies.iter().filter(awake).count(),
            substeps: self.world.integration_parameters.num_solver_iterations,
            ..Counts::default()
        };
        count_contacts(&self.world, &mut counts);
        counts
    }

    fn stats(&self) -> Stats {
        let bodies = || self.bodies.iter().map(|&handle| &self.world.bodies[handle]);
        let moving = bodies().filter(|body| body.is_dynamic());
        let poses: Vec<_> = bodies().map(|body| numbers::pose_back(body.position())).collect();
        Stats {
            counts: self.counts(),
            kinetic_energy: moving.map(|body| f64::from(body.kinetic_energy())).sum(),
            overlap: overlap(self.template, &poses),
            separation: largest_separation(self.template, &poses),
        }
    }

    fn save(&self) -> Option<Vec<u8>> {
        saving::save(&self.world)
    }

    fn load(&self, bytes: &[u8]) -> bool {
        saving::load(bytes)
    }

    fn save_and_return(&mut self) -> Option<f64> {
        saving::save_and_return(&mut self.world)
    }

    fn cast(&self, probes: &Probes, radius: Option<f32>) -> Option<usize> {
        let PhysicsWorld { broad_phase, narrow_phase, bodies, colliders, .. } = &self.world;
        let dispatcher = narrow_phase.query_dispatcher();
        let all = QueryFilter::default();
        let queries = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, all);
        let ball = radius.map(|radius| Ball::new(radius.into()));
        let reach = Real::from(probes.reach);
        let options = ShapeCastOptions::with_max_time_of_impact(reach);
        let rays = probes.origins.iter().zip(&probes.directions);
        let hits = rays.filter(|&(&origin, &direction)| {
            let [origin, direction] = [origin, direction].map(|v| numbers::vector(vector_of(v)));
            match &ball {
                None => queries.cast_ray(&Ray::new(origin, direction), reach, true).is_some(),
                Some(ball) => {
                    let start = Pose::from_translation(origin);
                    queries.cast_shape(&start, direction, ball, options).is_some()
                }
            }
        });
        Some(hits.count())
    }
}
