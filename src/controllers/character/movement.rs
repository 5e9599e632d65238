//! Result of a move: the translation, the ground, and the collisions.

use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::{RigidBody, RigidBodySet, RigidBodyType};
use crate::model::collider::{ColliderHandle, ColliderSet};
use parry::query::ShapeCastHit;

/// The admissible part of a move.
#[derive(Copy, Clone, PartialEq, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct EffectiveCharacterMovement {
    /// The translation to apply, in world space. Exactly zero if no motion is necessary.
    pub translation: Vector,
    /// Whether the character stands on something at the end. It never does while the desired translation is
    /// upwards.
    pub grounded: bool,
    /// Whether the character slid down a slope that is too steep to stand on.
    pub is_sliding_down_slope: bool,
    /// The ground, if the character is [`grounded`](Self::grounded).
    pub ground: Option<CharacterGround>,
}

/// The ground under a character.
#[derive(Copy, Clone, PartialEq, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct CharacterGround {
    /// The collider.
    pub collider: ColliderHandle,
    /// The unit normal there, in world space, from the ground to the character.
    pub normal: Vector,
    /// The ground point in world space: below the origin of the character's shape, in the plane that it
    /// touches.
    pub point: Vector,
}

impl CharacterGround {
    fn body<'a>(&self, bodies: &'a RigidBodySet, colliders: &ColliderSet) -> Option<&'a RigidBody> {
        bodies.get(colliders.get(self.collider)?.parent()?)
    }

    /// The velocity of the ground at [`Self::point`], in world space (length/s). Zero if the ground has no
    /// body, or was removed.
    ///
    /// The engine does not apply it. For a jump, add it to the initial velocity of the character. To carry
    /// the character along with the ground, use [`Self::displacement`].
    pub fn velocity(&self, bodies: &RigidBodySet, colliders: &ColliderSet) -> Vector {
        self.body(bodies, colliders).map_or(Vector::ZERO, |body| body.velocity_at_point(self.point))
    }

    /// Displacement by the ground in the next step, in world space. Add it to
    /// [`EffectiveCharacterMovement::translation`].
    ///
    /// ```
    /// use rapier3d::prelude::*;
    ///
    /// let mut world = PhysicsWorld::new();
    /// let lift = RigidBodyBuilder::kinematic_velocity_based().linvel(vector![0.0, 3.0, 0.0]);
    /// let (lift, _) = world.insert(lift, ColliderBuilder::cuboid(2.0, 0.5, 2.0));
    /// let body = RigidBodyBuilder::kinematic_position_based().translation(vector![0.0, 1.5, 0.0]);
    /// let (player, collider) = world.insert(body, ColliderBuilder::capsule_y(0.6, 0.3));
    /// world.step();
    ///
    /// let controller = KinematicCharacterController::default();
    /// let dt = world.integration_parameters.dt;
    /// for _ in 0..60 {
    ///     let movement = controller.move_shape(
    ///         dt,
    ///         &world.query_pipeline_with_filter(QueryFilter::default().exclude_rigid_body(player)),
    ///         world.colliders[collider].shape(),
    ///         world.colliders[collider].position(),
    ///         vector![0.0, -9.81, 0.0] * dt,
    ///         |_| (),
    ///     );
    ///     let ride = |ground: CharacterGround| ground.displacement(&world.bodies, &world.colliders, dt);
    ///     let ride = movement.ground.map_or(Vector::ZERO, ride);
    ///     let next = world.bodies[player].translation() + movement.translation + ride;
    ///     world.bodies[player].set_next_kinematic_translation(next);
    ///     world.step();
    /// }
    /// let [feet, floor] = [(player, -0.9), (lift, 0.5)].map(|(body, y)| world.bodies[body].translation().y + y);
    /// assert!((feet - floor - 0.018).abs() < 1.0e-3, "at the offset, still");
    /// ```
    ///
    /// This is the displacement of [`Self::point`] with the body. For position-based kinematic bodies it
    /// follows from the next position, so set that first. For others it follows from the velocity including
    /// rotation, so that a character stays on a turntable. The next move detects obstacles on that path, and
    /// pushes the character back. The result is zero if the ground has no body, was removed, or if `dt` is
    /// not finite.
    pub fn displacement(&self, bodies: &RigidBodySet, colliders: &ColliderSet, dt: Real) -> Vector {
        let Some(body) = self.body(bodies, colliders) else { return Vector::ZERO };
        let next = match body.body_type() {
            RigidBodyType::KinematicPositionBased => *body.next_position(),
            RigidBodyType::Fixed => return Vector::ZERO,
            _ => body.predict_position_using_velocity(dt),
        };
        if next == *body.position() {
            return Vector::ZERO;
        }
        next * (body.position().inverse() * self.point) - self.point
    }
}

/// A collision of a character with an obstacle.
#[derive(Copy, Clone, Debug)]
pub struct CharacterCollision {
    /// The collider of the obstacle.
    pub handle: ColliderHandle,
    /// Pose of the character at that time.
    pub character_pos: Pose,
    /// Translation so far, in world space.
    pub translation_applied: Vector,
    /// The remaining desired translation, in world space.
    pub translation_remaining: Vector,
    /// The contact point. Side 1 is the collider, in world space; side 2 is the character, in the frame of
    /// its shape. The time of impact is 0, because the character is at the contact.
    pub hit: ShapeCastHit,
}

impl CharacterCollision {
    /// The unit normal in world space, from the obstacle to the character.
    pub fn normal(&self) -> Vector {
        self.hit.normal1
    }

    /// The contact point on the character's surface, in world space.
    pub fn point(&self) -> Vector {
        self.character_pos * self.hit.witness2
    }
}
