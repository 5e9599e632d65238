//! A world that grows at the results of queries.

use super::super::dim::{about, cuboid, shapes, vec};
use super::super::rapier::prelude::*;
use super::{Act, fold_vector, word_of};
use crate::Fold;

/// Inserts new bodies at hits of rays and shapes, and at projections of points.
pub fn spawner(world: &mut PhysicsWorld) -> Act {
    world.insert_collider(cuboid(20.0, 0.5, 8.0), None);
    let shapes = shapes();
    for (k, shape) in shapes.iter().enumerate() {
        let at = vec(k as Real - 4.0, 1.5, 0.1 * k as Real);
        world.insert(RigidBodyBuilder::dynamic().translation(at), shape.clone());
    }
    Box::new(move |world, step, fold| {
        let angle = 0.13 * step as Real;
        let from = Pose::new(vec(0.0, 8.0, 0.0), about(0.3, 0.0, angle));
        let direction = from.rotation * vec(0.0, -1.0, 0.0);
        let found = [
            ray(world, Ray::new(from.translation, direction), fold),
            shape(world, &from, direction, shapes[step % shapes.len()].clone(), fold),
            projection(world, from.translation + direction * 3.0, fold),
        ];
        let place = found.into_iter().flatten().next().filter(|_| step % 4 == 0);
        if let Some(place) = place {
            let body = RigidBodyBuilder::dynamic().translation(place + vec(0.0, 1.0, 0.0));
            world.insert(body, shapes[step % shapes.len()].clone());
        }
    })
}

fn ray(world: &PhysicsWorld, ray: Ray, fold: &mut Fold) -> Option<Vector> {
    let (collider, hit) =
        world.cast_ray_and_get_normal(&ray, 50.0, true, QueryFilter::default())?;
    fold.word(word_of(collider));
    fold_vector(fold, hit.normal);
    let place = ray.point_at(hit.time_of_impact);
    fold_vector(fold, place);
    Some(place)
}

fn shape(
    world: &PhysicsWorld,
    from: &Pose,
    direction: Vector,
    shape: ColliderBuilder,
    fold: &mut Fold,
) -> Option<Vector> {
    let (options, filter) = (ShapeCastOptions::default(), QueryFilter::default());
    let (collider, hit) = world.cast_shape(from, direction, &*shape.shape, options, filter)?;
    fold.word(word_of(collider));
    fold_vector(fold, hit.normal1);
    fold_vector(fold, hit.witness1);
    Some(from.translation + direction * hit.time_of_impact)
}

fn projection(world: &PhysicsWorld, point: Vector, fold: &mut Fold) -> Option<Vector> {
    let (collider, projection) = world.project_point(point, 20.0, false, QueryFilter::default())?;
    fold.word(word_of(collider));
    fold_vector(fold, projection.point);
    Some(projection.point)
}
