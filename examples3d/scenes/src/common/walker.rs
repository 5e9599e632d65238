//! Character that walks to and fro, moved by a character controller.

use crate::rapier::control::*;
use crate::rapier::prelude::*;

/// Character with its controller and its motion.
#[derive(Clone)]
pub struct Walker {
    body: RigidBodyHandle,
    collider: ColliderHandle,
    controller: KinematicCharacterController,
    /// Desired level velocity (length/s).
    velocity: Vector,
    /// Range of x. The character reverses at its ends.
    range: [Real; 2],
    /// Vertical velocity of the fall (length/s).
    fall: Real,
}

impl Walker {
    /// Creates a capsule of height 1.2 at `foot`, which walks at a speed and reverses at the ends of a range
    /// of x.
    pub fn new(world: &mut PhysicsWorld, foot: Vector, speed: Real, range: [Real; 2]) -> Self {
        let place = foot + Vector::Y * 0.65;
        let body = RigidBodyBuilder::kinematic_position_based().translation(place);
        let (body, collider) = world.insert(body, ColliderBuilder::capsule_y(0.35, 0.25));
        let controller = KinematicCharacterController {
            autostep: Some(CharacterAutostep {
                min_width: CharacterLength::Absolute(0.2),
                ..CharacterAutostep::default()
            }),
            ..KinematicCharacterController::default()
        };
        Self { body, collider, controller, velocity: Vector::X * speed, range, fall: 0.0 }
    }

    /// Sets the level velocity of a character that no longer reverses.
    pub fn steer(&mut self, velocity: Vector) {
        (self.velocity, self.range) = (velocity, [-Real::INFINITY, Real::INFINITY]);
    }

    /// Sets the next position. To be called before the step of the world.
    pub fn walk(&mut self, world: &mut PhysicsWorld) {
        let dt = world.integration_parameters.dt;
        let place = world.bodies[self.body].translation();
        if (self.velocity.x < 0.0 && place.x < self.range[0])
            || (self.velocity.x > 0.0 && place.x > self.range[1])
        {
            self.velocity = -self.velocity;
        }
        self.fall += world.gravity.y * dt;
        let desired = (self.velocity + Vector::Y * self.fall) * dt;
        let shape = world.colliders[self.collider].shared_shape().clone();
        let filter = QueryFilter::default().exclude_rigid_body(self.body);
        let mut met = Vec::new();
        let movement = self.controller.move_shape(
            dt,
            &world.query_pipeline_with_filter(filter),
            &*shape,
            world.colliders[self.collider].position(),
            desired,
            |collision| met.push(collision),
        );
        let mut queries = world.query_pipeline_mut(filter);
        self.controller.solve_character_collision_impulses(dt, &mut queries, &*shape, 60.0, &met);

        if movement.grounded {
            self.fall = 0.0;
        }
        let ride = movement.ground.map_or(Vector::ZERO, |ground| {
            ground.displacement(&world.bodies, &world.colliders, dt)
        });
        let next = place + movement.translation + ride;
        world.bodies[self.body].set_next_kinematic_translation(next);
    }
}
