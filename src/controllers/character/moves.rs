//! The public methods of the controller.

use super::hooks::{CharacterHooks, HookContext};
use super::movement::{CharacterCollision, EffectiveCharacterMovement};
use super::mover::Mover;
use super::obstacles::Obstacles;
use super::resolved::ResolvedSettings;
use super::settings::KinematicCharacterController;
use crate::base::measure::is_point;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::check::checked_pose;
use crate::query::QueryView;
use parry::shape::Shape;

impl KinematicCharacterController {
    /// Computes the admissible part of `desired_translation` of a shape within `dt` seconds.
    ///
    /// * `queries`: the world without the colliders that the character ignores. Exclude its own body:
    ///   `world.query_pipeline_with_filter(QueryFilter::default().exclude_rigid_body(player))`. Sensors are
    ///   always ignored.
    /// * `character_shape`, `character_pos`: usually those of the character's collider.
    /// * `desired_translation`: in world space (length units). It needs a downward part, such as that of
    ///   gravity, or the character does not fall. An upward part is a jump.
    /// * `events` receives each obstacle once for each collider and direction; see
    ///   [`Self::solve_character_collision_impulses`].
    ///
    /// The world stays unchanged: the user applies the
    /// [`translation`](EffectiveCharacterMovement::translation), to a kinematic body by
    /// [`set_next_kinematic_translation`](crate::dynamics::RigidBody::set_next_kinematic_translation).
    ///
    /// Invalid numbers result in no movement, and the log contains a warning: a non-finite translation or
    /// pose, a `dt` that is not positive, invalid settings.
    pub fn move_shape(
        &self,
        dt: Real,
        queries: &QueryView<'_>,
        character_shape: &dyn Shape,
        character_pos: &Pose,
        desired_translation: Vector,
        mut events: impl FnMut(CharacterCollision),
    ) -> EffectiveCharacterMovement {
        let Some(initial) =
            self.start_of_move(dt, character_shape, character_pos, desired_translation)
        else {
            return EffectiveCharacterMovement::default();
        };
        let obstacles = Obstacles::new(*queries, character_shape, None);
        Mover::new(initial.settings, obstacles, initial.start, &mut events).run(desired_translation)
    }

    /// [`Self::move_shape`] for a character that is subject to the world's hooks.
    ///
    /// The hooks are called as in the narrow phase, for the
    /// [`ActiveHooks`](crate::model::collider::ActiveHooks) of the obstacle and of the character's collider.
    /// `contact_pair_flags`, and with it `filter_contact_pair`, decides about the pair.
    /// `modify_solver_contact` receives each manifold and may change it. The character passes an obstacle if
    /// the filter refuses the pair, if the modified manifold has no points, or if either clears
    /// [`COMPUTE_RIGID_IMPULSES`](crate::model::contact::SolverFlags::COMPUTE_RIGID_IMPULSES). The obstacle
    /// is always the first collider, the character the second. Solver groups apply where
    /// `modify_solver_contact` is called.
    ///
    /// ```
    /// use rapier3d::prelude::*;
    ///
    /// /// Everything with hooks is a platform that holds from above only.
    /// struct OneWay;
    ///
    /// impl PhysicsHooks for OneWay {
    ///     fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
    ///         context.update_as_oneway_platform(Vector::Y, 0.2);
    ///     }
    /// }
    ///
    /// let mut world = PhysicsWorld::new();
    /// let platform = ColliderBuilder::cuboid(2.0, 0.1, 2.0)
    ///     .translation(vector![0.0, 3.0, 0.0])
    ///     .active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
    /// world.insert_collider(platform, None);
    /// let body = RigidBodyBuilder::kinematic_position_based().translation(vector![0.0, 1.0, 0.0]);
    /// let (player, character) = world.insert(body, ColliderBuilder::capsule_y(0.6, 0.3));
    ///
    /// let controller = KinematicCharacterController::default();
    /// let dt = world.integration_parameters.dt;
    /// let mut contacts = CharacterContacts::new(); // kept from call to call
    /// let (mut velocity, mut grounded) = (10.0, false); // a jump
    /// for _ in 0..120 {
    ///     world.step();
    ///     velocity = if grounded { 0.0 } else { velocity } - 9.81 * dt;
    ///     let movement = controller.move_shape_with_hooks(
    ///         dt,
    ///         &world.query_pipeline_with_filter(QueryFilter::default().exclude_rigid_body(player)),
    ///         world.colliders[character].shape(),
    ///         world.colliders[character].position(),
    ///         Vector::Y * velocity * dt,
    ///         CharacterHooks {
    ///             hooks: &OneWay,
    ///             bodies: &world.bodies,
    ///             character,
    ///             contacts: &mut contacts,
    ///         },
    ///         |_| (),
    ///     );
    ///     grounded = movement.grounded;
    ///     let next = world.bodies[player].translation() + movement.translation;
    ///     world.bodies[player].set_next_kinematic_translation(next);
    /// }
    /// world.step();
    /// assert!(grounded, "it stands on the platform that it jumped through");
    /// assert!((world.bodies[player].translation().y - 4.0).abs() < 0.03);
    /// ```
    #[expect(clippy::too_many_arguments, reason = "those of `move_shape`, and the hooks")]
    pub fn move_shape_with_hooks(
        &self,
        dt: Real,
        queries: &QueryView<'_>,
        character_shape: &dyn Shape,
        character_pos: &Pose,
        desired_translation: Vector,
        hooks: CharacterHooks<'_>,
        mut events: impl FnMut(CharacterCollision),
    ) -> EffectiveCharacterMovement {
        let Some(initial) =
            self.start_of_move(dt, character_shape, character_pos, desired_translation)
        else {
            return EffectiveCharacterMovement::default();
        };
        let hook_context = HookContext::new(hooks, queries.colliders);
        let obstacles = Obstacles::new(*queries, character_shape, Some(hook_context));
        let mut mover = Mover::new(initial.settings, obstacles, initial.start, &mut events);
        let movement = mover.run(desired_translation);
        if let Some(hook_context) = mover.obstacles.hook_context {
            hook_context.finish();
        }
        movement
    }

    /// Validates the input; `None`, with a warning, if it is invalid.
    fn start_of_move(
        &self,
        dt: Real,
        shape: &dyn Shape,
        pose: &Pose,
        desired: Vector,
    ) -> Option<MoveStart> {
        if !(dt > 0.0 && dt.is_finite()) {
            log::warn!(
                "the time step {dt} of a character is not a positive number: the character does not move"
            );
            return None;
        }
        let Some(start) = checked_pose(*pose).filter(|_| is_point(desired)) else {
            log::warn!(
                "the pose {pose:?} or the translation {desired:?} of a character is not finite: the character does not move"
            );
            return None;
        };
        let settings = ResolvedSettings::of(self, shape, &start);
        if settings.is_none() {
            log::warn!(
                "the settings {self:?} or the size of a character are invalid: the character does not move"
            );
        }
        Some(MoveStart { settings: settings?, start })
    }
}

/// Start of a move.
struct MoveStart {
    settings: ResolvedSettings,
    start: Pose,
}
