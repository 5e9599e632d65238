//! Grounds of many parts, and controllers that walk and drive on them.

use super::super::dim::{cuboid, drive, grounds, shapes, vec};
use super::super::rapier::control::*;
use super::super::rapier::prelude::*;
use super::{Act, fold_vector, undisturbed};

/// Shapes of all kinds that roll and slide over a height field, a mesh, voxels and a box.
pub fn terrain(world: &mut PhysicsWorld) -> Act {
    let shapes = shapes();
    for (k, ground) in grounds().into_iter().enumerate() {
        let at = vec(18.0 * k as Real, 0.0, 0.0);
        world.insert(RigidBodyBuilder::fixed().translation(at), ground);
        for (n, shape) in shapes.iter().enumerate() {
            let place = at + vec(1.1 * n as Real - 6.0, 2.5, 0.3 * n as Real - 1.5);
            let body = RigidBodyBuilder::dynamic().translation(place).linvel(vec(1.0, 0.0, -0.5));
            world.insert(body, shape.clone().restitution(0.2));
        }
    }
    undisturbed()
}

/// A character that climbs over boxes, a vehicle, and a body that a PID controller holds.
pub fn walkers(world: &mut PhysicsWorld) -> Act {
    world.insert_collider(cuboid(20.0, 0.5, 8.0), None);
    for k in 0..12_u8 {
        let at = vec(Real::from(k) - 3.0, 0.7, 0.1 * Real::from(k) - 2.5);
        world.insert(RigidBodyBuilder::dynamic().translation(at), cuboid(0.3, 0.15, 0.3));
    }
    let body = RigidBodyBuilder::kinematic_position_based().translation(vec(-5.0, 1.5, -2.0));
    let (player, collider) = world.insert(body, ColliderBuilder::capsule_y(0.5, 0.3));
    let held = RigidBodyBuilder::dynamic().translation(vec(0.0, 5.0, 2.0));
    let (held, _) = world.insert(held, ColliderBuilder::ball(0.3));
    let mut pid = PidController::default();
    let controller = KinematicCharacterController {
        autostep: Some(CharacterAutostep::default()),
        ..KinematicCharacterController::default()
    };
    let mut drive = drive(world);
    Box::new(move |world, step, fold| {
        let dt = world.integration_parameters.dt;
        let filter = QueryFilter::default().exclude_rigid_body(player);
        let movement = controller.move_shape(
            dt,
            &world.query_pipeline_with_filter(filter),
            world.colliders[collider].shape(),
            world.colliders[collider].position(),
            vec(1.5, -3.0, 0.3 * ((step / 50) as Real - 2.0)) * dt,
            |_| (),
        );
        fold_vector(fold, movement.translation);
        let next = world.bodies[player].translation() + movement.translation;
        world.bodies[player].set_next_kinematic_translation(next);
        let target = Pose::from_translation(vec(2.0, 4.0, 1.0));
        let correction =
            pid.rigid_body_correction(dt, &world.bodies[held], target, RigidBodyVelocity::zero());
        let velocity = world.bodies[held].vels() + correction;
        world.bodies[held].set_vels(velocity, true);
        drive(world, step);
    })
}
