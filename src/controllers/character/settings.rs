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
    /// its width. It is measured from the character's position below the step. So the character steps over a
    /// pole or a fence if the space behind is free.
    pub min_width: CharacterLength,
    /// Whether the character also steps onto dynamic bodies. Otherwise they are walls.
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
/// `v` is the speed of the desired translation perpendicular to the up direction, and θ the angle of the
/// slope.
#[derive(Copy, Clone, PartialEq, Eq, Debug, Default, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum CharacterSlopeSpeed {
    /// `v` along the surface: the same path length takes the same time everywhere. This is the default, and
    /// the usual meaning of a walking speed.
    #[default]
    Constant,
    /// `v` in the horizontal projection: `v / cos θ` along the surface. For platformers with jumps measured
    /// in tiles.
    Horizontal,
    /// `v · cos θ` along the surface: the component of the desired translation along it, which is slower on
    /// slopes. Other controllers use this speed; select it for a game that was tuned for it.
    Projected,
}

/// A controller that moves a shape like a walking character: up slopes and steps, along walls, down with
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
/// It contains settings only, so one controller can move many characters. The controller never rotates the
/// shape. A move is computed within one call, in the current world. Moving obstacles, such as a lift, are at
/// their pose of the last step, and
/// [`EffectiveCharacterMovement::ground`](super::EffectiveCharacterMovement::ground) returns the data to
/// carry the character along.
///
/// With an invalid setting the character does not move, and the log contains a warning. A zero up direction,
/// a negative or infinite length, and a NaN angle are invalid.
#[derive(Copy, Clone, PartialEq, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct KinematicCharacterController {
    /// The up direction, in world space, of any length.
    pub up: Vector,
    /// The gap between the character and all obstacles; relative to its height. It allows for rounding and
    /// for approaching obstacles, so it should not be much smaller than a hundredth of the character.
    pub offset: CharacterLength,
    /// Whether the character slides along obstacles. Otherwise it stops there, but still walks on floors.
    pub slide: bool,
    /// Settings for steps. `None` by default.
    pub autostep: Option<CharacterAutostep>,
    /// The steepest slope that the character can walk up (rad, from level ground). Steeper slopes are walls.
    /// 45° by default.
    pub max_slope_climb_angle: Real,
    /// The smallest slope angle (rad, from level ground) at which the downward component of the desired
    /// translation makes the character slide. On smaller slopes it stands. 45° by default.
    pub min_slope_slide_angle: Real,
    /// Distance below the feet within which the character moves down to a floor after it has left another;
    /// relative to its height. It keeps the character on the ground on the way down slopes and stairs: the
    /// edges and risers of steps up to this height support shapes with a round bottom. A fifth by default.
    /// Disabled while the desired translation is upwards.
    pub snap_to_ground: Option<CharacterLength>,
    /// Tolerance of a gap around [`Self::offset`] (length units). Smaller corrections are skipped, so that
    /// the character does not tremble. The effective tolerance is at least the rounding error and at most a
    /// quarter of the offset.
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
