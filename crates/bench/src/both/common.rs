//! What is asked of both engines in the same words: compiled once beside this engine's file and once beside Rapier's, each of
//! which calls its engine `engine`.

use super::super::overlap::deepest_overlap;
use super::super::separation::largest_separation;
use super::super::template::Template;
use super::super::vector_of;
use super::engine::parry::query::ShapeCastOptions;
use super::engine::prelude::*;
use crate::engine::{Probes, Stats};

/// How many of the rays, or of the balls that are sent along them, hit something.
pub fn count_hits(world: &PhysicsWorld, probes: &Probes, radius: Option<f32>) -> usize {
    let PhysicsWorld { broad_phase, narrow_phase, bodies, colliders, .. } = world;
    let dispatcher = narrow_phase.query_dispatcher();
    let all = QueryFilter::default();
    let queries = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, all);
    let ball = radius.map(Ball::new);
    let options = ShapeCastOptions::with_max_time_of_impact(probes.reach);
    let ways = probes.origins.iter().zip(&probes.directions);
    let hits = ways.filter(|&(&origin, &direction)| {
        let (origin, direction) = (vector_of(origin), vector_of(direction));
        match &ball {
            None => queries.cast_ray(&Ray::new(origin, direction), probes.reach, true).is_some(),
            Some(ball) => {
                let start = Pose::from_translation(origin);
                queries.cast_shape(&start, direction, ball, options).is_some()
            }
        }
    });
    hits.count()
}

/// Adds what is to be said of the bodies, which come in the order of the template's.
pub fn note_bodies(template: &Template, bodies: &[&RigidBody], stats: &mut Stats) {
    let moving = bodies.iter().filter(|body| body.is_dynamic());
    stats.kinetic_energy = moving.map(|body| f64::from(body.kinetic_energy())).sum();
    let poses: Vec<Pose> = bodies.iter().map(|body| *body.position()).collect();
    stats.overlap = deepest_overlap(template, &poses);
    stats.separation = largest_separation(template, &poses);
}
