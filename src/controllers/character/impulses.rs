//! Impulses of a character on dynamic bodies.
//!
//! Each collision is treated as a perfectly inelastic one of a point of the mass `m` at the character's
//! velocity with the body, without friction. Let `v` be the velocity of approach along the unit normal `n`,
//! and `k = 1/mᵦ + (r × n)·I⁻¹(r × n)` the body's response to a unit impulse there. The impulse after which
//! both continue together is
//!
//! ```text
//! j = v / (1/m + k)  <=  m v
//! ```
//!
//! (D. Baraff 1997, "Physically Based Modeling: Rigid Body Simulation", with restitution 0.)

use super::movement::CharacterCollision;
use super::settings::KinematicCharacterController;
use crate::controllers::QueryPipelineMut;
use crate::dim::math::{Real, Vector, ang_dot, mul_inertia, torque};
use crate::model::body::RigidBody;
use parry::shape::Shape;

impl KinematicCharacterController {
    /// Applies impulses to the dynamic bodies of the collisions. They are the impulses of a body of mass
    /// `character_mass`, with the velocity of the character's remaining translation over `dt` (s).
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// # let mut world = PhysicsWorld::new();
    /// # world.gravity = Vector::ZERO;
    /// # let start = RigidBodyBuilder::dynamic().translation(vector![0.9, 0.0, 0.0]);
    /// # let (crate_handle, _) = world.insert(start, ColliderBuilder::cuboid(0.5, 0.5, 0.5));
    /// # world.step();
    /// # let (shape, pose) = (SharedShape::ball(0.3), Pose::IDENTITY);
    /// # let (dt, desired) = (1.0 / 60.0, vector![0.1, 0.0, 0.0]);
    /// let controller = KinematicCharacterController::default();
    /// let mut collisions = Vec::new();
    /// let queries = world.query_pipeline();
    /// controller.move_shape(dt, &queries, &*shape, &pose, desired, |collision| collisions.push(collision));
    /// let mut queries = world.query_pipeline_mut(QueryFilter::default());
    /// controller.solve_character_collision_impulses(dt, &mut queries, &*shape, 80.0, &collisions);
    /// assert!(world.bodies[crate_handle].linvel().x > 0.1);
    /// ```
    ///
    /// No impulse is larger than `character_mass` times the velocity of approach, so a light character does
    /// not push a truck. No body gets faster than the character at the contact. Pushed bodies wake. Colliders
    /// that the filter of the queries excludes get no impulse. The shape is unused, because collisions
    /// contain their positions.
    ///
    /// A mass or a `dt` that is not positive results in no impulses, and the log contains a warning.
    pub fn solve_character_collision_impulses<'a>(
        &self,
        dt: Real,
        queries: &mut QueryPipelineMut<'_>,
        _character_shape: &dyn Shape,
        character_mass: Real,
        collisions: impl IntoIterator<Item = &'a CharacterCollision>,
    ) {
        let is_positive = |value: Real| value > 0.0 && value.is_finite();
        if !is_positive(dt) || !is_positive(character_mass) {
            log::warn!(
                "the character mass {character_mass} or the time step {dt} is not a positive number: no impulse is applied"
            );
            return;
        }
        for collision in collisions {
            push(collision, queries, dt, character_mass);
        }
    }
}

/// Pushes the body of one collision, if it can be pushed.
fn push(collision: &CharacterCollision, queries: &mut QueryPipelineMut<'_>, dt: Real, mass: Real) {
    let handle = collision.handle;
    let collider = queries.colliders.get(handle).filter(|met| queries.filter.test(handle, met));
    let velocity = collision.translation_remaining / dt;
    let is_pushed = |body: &RigidBody| body.is_dynamic() && velocity.is_finite();
    if let Some(parent) = collider.and_then(|collider| collider.parent())
        && queries.bodies.get(parent).is_some_and(is_pushed)
        && let Some(body) = queries.bodies.get_mut(parent)
    {
        let (normal, point) = (-collision.normal(), collision.point());
        let impulse = inelastic_impulse(body, point, normal, velocity, mass);
        body.apply_impulse_at_point(normal * impulse, point, impulse > 0.0);
    }
}

/// The impulse along `normal` (into the body) after which the body and a point of this mass and velocity no
/// longer approach each other.
fn inelastic_impulse(
    body: &RigidBody,
    point: Vector,
    normal: Vector,
    velocity: Vector,
    mass: Real,
) -> Real {
    let approach = (velocity - body.velocity_at_point(point)).dot(normal);
    if approach <= 0.0 {
        return 0.0;
    }
    let turn = torque(point - body.mprops.world_com, normal);
    let response = normal.dot(body.mprops.inv_mass * normal)
        + ang_dot(turn, mul_inertia(&body.mprops.inv_inertia, turn));
    approach / (1.0 / mass + response)
}
