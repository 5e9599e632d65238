//! Queries of single colliders and shapes.
//!
//! A subject is a collider of a world with its own pose, or a shape (the world is 0) with a pose in the
//! scratch block. Places 8 and 9 hold the pose of the first subject, 10 and 11 that of the second.

use crate::fault::{Fault, Kind, non_negative};
use crate::memory::{self, put_number, put_vector, vector};
use crate::query::{cast_options, limit, put_ray_hit, put_shape_hit, ray};
use crate::rapier::geometry::{NarrowPhase, SharedShape};
use crate::rapier::math::{Pose, Real};
use crate::rapier::parry::query::{QueryDispatcher, Unsupported};
use crate::rapier::pipeline::cast_ray_on_shape;
use crate::registry::collider;
use crate::shape::shape;

/// The places of the poses of shapes.
const POSES: [usize; 2] = [8, 10];

fn subject(world: u32, number: f64, place: usize) -> Result<(SharedShape, Pose), Fault> {
    if world == 0 {
        return Ok((shape(number as u32)?, memory::pose(place)?));
    }
    let collider = collider(world, number)?;
    Ok((collider.shared_shape().clone(), *collider.position()))
}

/// The result of a query of two shapes. The engine's dispatcher supports every pair.
fn ask<T>(query: impl Fn(&dyn QueryDispatcher) -> Result<T, Unsupported>) -> Result<T, Fault> {
    query(NarrowPhase::new().query_dispatcher()).map_err(|_| {
        Fault::new(Kind::WrongShape, "the query does not support these two shapes".to_string())
    })
}

exports! {
    /// Returns whether a point is inside.
    fn subject_contains_point(world: u32, number: f64) -> bool {
        let (shape, pose) = subject(world, number, POSES[0])?;
        shape.contains_point(&pose, vector(0, "point")?)
    }

    /// Writes the nearest point. Returns whether the point is inside.
    fn subject_project_point(world: u32, number: f64, solid: u32) -> bool {
        let (shape, pose) = subject(world, number, POSES[0])?;
        let projection = shape.project_point(&pose, vector(0, "point")?, solid != 0);
        put_vector(0, projection.point);
        projection.is_inside
    }

    /// Returns whether a ray hits.
    fn subject_intersects_ray(world: u32, number: f64, max: f64) -> bool {
        let (shape, pose) = subject(world, number, POSES[0])?;
        cast_ray_on_shape(&*shape, &pose, &ray()?, limit("maxToi", max)?, true).is_some()
    }

    /// The time until a ray hits, or -1.
    fn subject_cast_ray(world: u32, number: f64, max: f64, solid: u32) -> f64 {
        let (shape, pose) = subject(world, number, POSES[0])?;
        let hit = cast_ray_on_shape(&*shape, &pose, &ray()?, limit("maxToi", max)?, solid != 0);
        hit.map_or(-1.0, |hit| f64::from(hit.time_of_impact))
    }

    /// Writes normal, feature and time of the hit of a ray. Returns whether it hits.
    fn subject_cast_ray_and_get_normal(world: u32, number: f64, max: f64, solid: u32) -> bool {
        let (shape, pose) = subject(world, number, POSES[0])?;
        let hit = cast_ray_on_shape(&*shape, &pose, &ray()?, limit("maxToi", max)?, solid != 0);
        hit.inspect(put_ray_hit).is_some()
    }

    /// Returns whether two subjects touch.
    fn subjects_intersect(world1: u32, number1: f64, world2: u32, number2: f64) -> bool {
        let (shape1, pose1) = subject(world1, number1, POSES[0])?;
        let (shape2, pose2) = subject(world2, number2, POSES[1])?;
        let pose12 = pose1.inv_mul(&pose2);
        ask(|query| query.intersection_test(&pose12, &*shape1, &*shape2))?.intersecting
    }

    /// Writes the contact of two subjects: two points, two normals, the distance. Returns whether they are
    /// near.
    fn subjects_contact(world1: u32, number1: f64, world2: u32, number2: f64, prediction: f64) -> bool {
        let (shape1, pose1) = subject(world1, number1, POSES[0])?;
        let (shape2, pose2) = subject(world2, number2, POSES[1])?;
        let prediction = non_negative("prediction", prediction)? as Real;
        let pose12 = pose1.inv_mul(&pose2);
        let contact = ask(|query| query.contact(&pose12, &*shape1, &*shape2, prediction))?;
        if let Some(mut contact) = contact {
            contact.transform_by_mut(&pose1, &pose2);
            put_vector(0, contact.point1);
            put_vector(1, contact.point2);
            put_vector(2, contact.normal1);
            put_vector(3, contact.normal2);
            put_number(4, 0, contact.dist);
        }
        contact.is_some()
    }

    /// Writes the hit of two subjects that move with the velocities in places 0 and 1. Returns whether there
    /// is one.
    fn subjects_cast(world1: u32, number1: f64, world2: u32, number2: f64, target: f64, max: f64, stop: u32) -> bool {
        let (shape1, pose1) = subject(world1, number1, POSES[0])?;
        let (shape2, pose2) = subject(world2, number2, POSES[1])?;
        let (velocity1, velocity2) = (vector(0, "the first velocity")?, vector(1, "the second velocity")?);
        let options = cast_options(target, max, stop)?;
        let pose12 = pose1.inv_mul(&pose2);
        let velocity12 = pose1.rotation.inverse() * (velocity2 - velocity1);
        let hit = ask(|query| query.cast_shapes(&pose12, velocity12, &*shape1, &*shape2, options))?;
        hit.inspect(put_shape_hit).is_some()
    }
}
