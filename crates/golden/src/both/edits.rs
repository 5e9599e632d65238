//! A world that the user edits all the time.

use super::super::dim::{about, cuboid, shapes, vec};
use super::super::rapier::prelude::*;
use super::Act;

/// Bodies that are removed and inserted again, disabled, moved, put to sleep, and change their types, shapes
/// and masses.
pub fn turnover(world: &mut PhysicsWorld) -> Act {
    world.insert_collider(cuboid(20.0, 0.5, 8.0), None);
    let shapes = shapes();
    let mut living: Vec<RigidBodyHandle> = (0..60).map(|k| drop_one(world, &shapes, k)).collect();
    Box::new(move |world, step, fold| {
        let at = step * 7 % living.len();
        match step % 9 {
            0 => {
                let removed = world.remove_body(living[at]);
                fold.number(removed.map_or(-1.0, |body| f64::from(body.mass())));
                living[at] = drop_one(world, &shapes, step);
            }
            1 => world.bodies[living[at]].set_enabled(step % 2 == 0),
            2 => world.bodies[living[at]].set_translation(vec(0.1 * at as Real, 6.0, 0.0), true),
            3 => world.bodies[living[at]].sleep(),
            4 => {
                let kinds = [RigidBodyType::KinematicVelocityBased, RigidBodyType::Dynamic];
                world.bodies[living[at]].set_body_type(kinds[step / 9 % 2], true);
            }
            5 => world.bodies[living[at]].add_force(vec(0.0, 5.0, 1.0), true),
            6 => {
                let collider = world.bodies[living[at]].colliders()[0];
                world.colliders[collider].set_shape(SharedShape::ball(0.25));
            }
            7 => world.bodies[living[at]].apply_torque_impulse(about(0.1, 0.2, 0.3), true),
            _ => world.gravity = vec(0.0, -9.81 + 0.01 * step as Real, 0.0),
        }
    })
}

fn drop_one(world: &mut PhysicsWorld, shapes: &[ColliderBuilder], k: usize) -> RigidBodyHandle {
    let at = vec((k % 9) as Real - 4.0, 1.5 + 0.2 * (k % 31) as Real, (k % 4) as Real * 0.5);
    let body =
        RigidBodyBuilder::dynamic().translation(at).rotation(about(0.2, 0.1, 0.3 * k as Real));
    world.insert(body, shapes[k % shapes.len()].clone()).0
}
