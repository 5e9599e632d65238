//! What is asked of all engines of this kind in the same words: compiled once beside this engine's file, once beside its file in
//! double precision and once beside Rapier's, each of which calls its engine `engine` and its way between the numbers `numbers`.

use super::super::overlap::deepest_overlap;
use super::super::separation::largest_separation;
use super::super::template::Template;
use super::super::vector_of;
use super::engine::parry::query::ShapeCastOptions;
use super::engine::prelude::*;
use super::numbers;
use crate::engine::{Counts, Probes, Stats};

/// How many of the rays, or of the balls that are sent along them, hit something.
pub fn count_hits(world: &PhysicsWorld, probes: &Probes, radius: Option<f32>) -> usize {
    let PhysicsWorld { broad_phase, narrow_phase, bodies, colliders, .. } = world;
    let dispatcher = narrow_phase.query_dispatcher();
    let all = QueryFilter::default();
    let queries = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, all);
    let ball = radius.map(|radius| Ball::new(radius.into()));
    let reach = Real::from(probes.reach);
    let options = ShapeCastOptions::with_max_time_of_impact(reach);
    let ways = probes.origins.iter().zip(&probes.directions);
    let hits = ways.filter(|&(&origin, &direction)| {
        let [origin, direction] = [origin, direction].map(|v| numbers::vector(vector_of(v)));
        match &ball {
            None => queries.cast_ray(&Ray::new(origin, direction), reach, true).is_some(),
            Some(ball) => {
                let start = Pose::from_translation(origin);
                queries.cast_shape(&start, direction, ball, options).is_some()
            }
        }
    });
    hits.count()
}

/// The counts but for those of contacts.
pub fn count_bodies(world: &PhysicsWorld) -> Counts {
    let mut counts = Counts {
        bodies: world.bodies.len(),
        substeps: world.integration_parameters.num_solver_iterations,
        ..Counts::default()
    };
    let awake = |(_, body): &(_, &RigidBody)| body.is_dynamic() && !body.is_sleeping();
    counts.awake = world.bodies.iter().filter(awake).count();
    counts
}

/// What there is to measure, given the bodies in the order of the template's.
pub fn measure(
    template: &Template,
    world: &PhysicsWorld,
    bodies: &[RigidBodyHandle],
    counts: Counts,
) -> Stats {
    let bodies = || bodies.iter().map(|&handle| &world.bodies[handle]);
    let moving = bodies().filter(|body| body.is_dynamic());
    let poses: Vec<_> = bodies().map(|body| numbers::pose_back(body.position())).collect();
    Stats {
        counts,
        kinetic_energy: moving.map(|body| f64::from(body.kinetic_energy())).sum(),
        overlap: deepest_overlap(template, &poses),
        separation: largest_separation(template, &poses),
    }
}
