//! Tests of the trees.

use crate::base::random::Random;
use crate::collide::time_of_impact;
use crate::dim::collide::samples;
use crate::dim::math::{DIM, Pose, Real, Vector};
use crate::model::collider::{ColliderBuilder, ColliderHandle, ColliderSet};
use crate::query::{QueryFilter, QueryPipeline};
use parry::query::Ray;

fn direction(random: &mut Random) -> Vector {
    let mut dir = samples::vector(random, 2.0);
    if random.below(4) == 0 {
        dir[random.below(DIM)] = 0.0;
    }
    if dir == Vector::ZERO { Vector::X } else { dir }
}

/// Equal to the last bit: the tree omits colliders that cannot be hit.
#[test]
fn trees_change_no_bit() {
    let (mut random, mut colliders, mut hits) = (Random(8), ColliderSet::new(), 0);
    for index in 0..400 {
        let shape = samples::shape(index % samples::KINDS, &mut random, 1.0);
        // Some in the very same places, so that they are equally near.
        let pose = if index % 5 == 0 { Pose::IDENTITY } else { samples::pose(&mut random, 8.0) };
        colliders.insert(ColliderBuilder::new(shape).position(pose));
    }
    let mut queries = QueryPipeline::new();
    queries.update(&colliders);
    for round in 0..3000 {
        let ray = Ray::new(samples::vector(&mut random, 10.0), direction(&mut random));
        let (limit, solid) = (random.within(0.0, 10.0), round % 2 == 0);
        let mut best: Option<(ColliderHandle, Real)> = None;
        for (handle, collider) in colliders.iter() {
            let time = time_of_impact(collider.shape(), collider.position(), &ray, limit, solid);
            if let Some(time) = time
                && best.is_none_or(|(_, nearest)| time < nearest)
            {
                best = Some((handle, time));
            }
        }
        hits += usize::from(best.is_some());
        let found = queries.cast_ray(&colliders, &ray, limit, solid, QueryFilter::default());
        assert_eq!(found, best, "round {round}: {ray:?}");
    }
    assert!(hits > 500, "{hits}");
}
