//! Settings of a character.

use super::length::CharacterLength;
use crate::dim::math::{Real, Vector};

/// Settings for steps.
#[derive(Copy, Clone, PartialEq, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct CharacterAutostep {
    /// Largest height of a step; relative to the character's height.
    pub max_height: CharacterLength,
    /// Free depth of a step, in the direction of the motion, that the character needs to step up; relative to
    /// its width. Measured from where it stands below, so a pole or the rim of a fence is stepped over if
    /// what is behind is free.
    pub min_width: CharacterLength,
    /// Whether the character also steps onto dynamic bodies. If not, they are walls.
    pub include_dynamic_bodies: bool,
}

impl Default for CharacterAutostep {
    /// A quarter of the height, half of the width, dynamic bodies included.
    fn default() -> Self {
        Self {
            max_height: CharacterLength::Relative(0.25),
            min_width: CharacterLength::Relative(0.5),
            include_dynamic_bodies: true,
        }
    }
}

/// Speed of a character on walkable slopes.
///
/// `v` is the speed that the wished translation has across the up direction, θ the angle of the slope.
#[derive(Copy, Clone, PartialEq, Eq, Debug, Default, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum CharacterSlopeSpeed {
    /// `v` along the surface, so walking takes the same time for the same path length everywhere. The
    /// default: a walking speed usually means this.
    #[default]
    Constant,
    /// `v` on the map: `v / cos θ` along the surface. For platformers with jumps measured in tiles.
    Horizontal,
    /// `v · cos θ` along the surface: the component of the desired translation along it. Slower on slopes, as
    /// a sliding body's velocity is that is cut off at the surface. Other controllers do this; take it where
    /// a game was tuned for it.
    Projected,
}

/// Moves a shape through the world like a walking character: up slopes and steps, along walls, down with
/// gravity.
///
/// ```
/// use rapier3d::prelude::*;
///
/// let mut world = PhysicsWorld::new();
/// world.insert_collider(ColliderBuilder::cuboid(50.0, 0.5, 50.0), None);
/// let body = RigidBodyBuilder::kinematic_position_based().translation(vector![0.0, 1.5, 0.0]);
/// let (player, collider) = world.insert(body, ColliderBuilder::capsule_y(0.6, 0.3));
/// world.step();
///
/// let controller = KinematicCharacterController::default();
/// let dt = world.integration_parameters.dt;
/// for _ in 0..60 {
///     let filter = QueryFilter::default().exclude_rigid_body(player);
///     let movement = controller.move_shape(
///         dt,
///         &world.query_pipeline_with_filter(filter),
///         world.colliders[collider].shape(),
///         world.colliders[collider].position(),
///         vector![2.0, -9.81, 0.0] * dt, // 2 m/s ahead, and down
///         |_| (),
///     );
///     assert!(movement.grounded);
///     let body = &mut world.bodies[player];
///     let next = body.translation() + movement.translation;
///     body.set_next_kinematic_translation(next);
///     world.step();
/// }
/// assert!((world.bodies[player].translation().x - 2.0).abs() < 1.0e-3);
/// ```
///
/// It holds settings only, so one controller can move a crowd. The shape does not turn; turning it is up to
/// the user. Everything happens within one call, in the current world. Moving obstacles, such as a lift, are
/// at their pose of the last step, and
/// [`EffectiveCharacterMovement::ground`](super::EffectiveCharacterMovement::ground) returns the data to ride
/// them.
///
/// With an invalid setting (no up direction, a negative or infinite length, an angle that is no number) the
/// character does not move, with a warning in the log.
#[derive(Copy, Clone, PartialEq, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct KinematicCharacterController {
    /// The up direction, in world space. Need not have unit length.
    pub up: Vector,
    /// The gap that the character keeps to everything; relative to its height. It allows for rounding and for
    /// approaching obstacles, so it should not be much smaller than a hundredth of the character.
    pub offset: CharacterLength,
    /// Whether the character slides along obstacles. If not, it stops there; gravity still does not keep it
    /// from walking on a floor.
    pub slide: bool,
    /// Settings for steps. `None` by default.
    pub autostep: Option<CharacterAutostep>,
    /// The steepest slope that the character can walk up (rad, from level ground). Steeper ones are walls.
    /// 45° by default.
    pub max_slope_climb_angle: Real,
    /// The smallest slope angle at which the downward component of the desired translation makes the
    /// character slide (rad, from level ground): on smaller ones it stands. 45° by default.
    pub min_slope_slide_angle: Real,
    /// Distance below the feet within which the character is pulled down to a floor after it has walked off
    /// another; relative to its height. Keeps it on the ground on its path down slopes and stairs. A fifth by
    /// default. Disabled while the desired translation is upwards.
    pub snap_to_ground: Option<CharacterLength>,
    /// Tolerance of a gap around [`Self::offset`] (length units). The character does not move for less, so
    /// that it does not tremble. Never taken for less than what rounding does, nor for more than a quarter of
    /// the offset.
    pub normal_nudge_factor: Real,
    /// Speed of the character on slopes.
    pub slope_speed: CharacterSlopeSpeed,
}

impl Default for KinematicCharacterController {
    fn default() -> Self {
        let eighth_turn = core::f64::consts::FRAC_PI_4 as Real;
        Self {
            up: Vector::Y,
            offset: CharacterLength::Relative(0.01),
            slide: true,
            autostep: None,
            max_slope_climb_angle: eighth_turn,
            min_slope_slide_angle: eighth_turn,
            snap_to_ground: Some(CharacterLength::Relative(0.2)),
            normal_nudge_factor: 1.0e-4,
            slope_speed: CharacterSlopeSpeed::Constant,
        }
    }
}
