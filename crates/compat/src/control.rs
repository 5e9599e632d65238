//! Characters, vehicles and controllers.

use crate::geometry::Shape;
use crate::math::{Pose, Real, Vector};
use crate::pipeline::{QueryPipeline, QueryPipelineMut};
pub use engine::control::{
    CharacterAutostep, CharacterCollision, CharacterLength, EffectiveCharacterMovement,
    PdController, PdErrors, PidController,
};

/// The controller of a character that a program moves.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct KinematicCharacterController {
    /// The direction that is up.
    pub up: Vector,
    /// Distance between the character and its surroundings.
    pub offset: CharacterLength,
    /// Whether the character slides along obstacles.
    pub slide: bool,
    /// Steps that the character climbs.
    pub autostep: Option<CharacterAutostep>,
    /// Steepest slope that the character climbs (rad).
    pub max_slope_climb_angle: Real,
    /// Flattest slope that the character slides down (rad).
    pub min_slope_slide_angle: Real,
    /// Distance to the ground within which the character is put onto it.
    pub snap_to_ground: Option<CharacterLength>,
    /// Displacement along the normals of obstacles.
    pub normal_nudge_factor: Real,
}

impl Default for KinematicCharacterController {
    fn default() -> Self {
        let own = engine::control::KinematicCharacterController::default();
        Self {
            up: own.up,
            offset: own.offset,
            slide: own.slide,
            autostep: own.autostep,
            max_slope_climb_angle: own.max_slope_climb_angle,
            min_slope_slide_angle: own.min_slope_slide_angle,
            snap_to_ground: own.snap_to_ground,
            normal_nudge_factor: own.normal_nudge_factor,
        }
    }
}

impl KinematicCharacterController {
    fn to_engine(self) -> engine::control::KinematicCharacterController {
        engine::control::KinematicCharacterController {
            up: self.up,
            offset: self.offset,
            slide: self.slide,
            autostep: self.autostep,
            max_slope_climb_angle: self.max_slope_climb_angle,
            min_slope_slide_angle: self.min_slope_slide_angle,
            snap_to_ground: self.snap_to_ground,
            normal_nudge_factor: self.normal_nudge_factor,
            ..engine::control::KinematicCharacterController::default()
        }
    }

    /// The movement of a character with the desired translation `desired_translation`.
    pub fn move_shape(
        &self,
        dt: Real,
        queries: &QueryPipeline<'_>,
        character_shape: &dyn Shape,
        character_pos: &Pose,
        desired_translation: Vector,
        events: impl FnMut(CharacterCollision),
    ) -> EffectiveCharacterMovement {
        self.to_engine().move_shape(
            dt,
            &queries.view(),
            character_shape,
            character_pos,
            desired_translation,
            events,
        )
    }

    /// Pushes the bodies that a character touched.
    pub fn solve_character_collision_impulses<'a>(
        &self,
        dt: Real,
        queries: &mut QueryPipelineMut<'_>,
        character_shape: &dyn Shape,
        character_mass: Real,
        collisions: impl IntoIterator<Item = &'a CharacterCollision>,
    ) {
        self.to_engine().solve_character_collision_impulses(
            dt,
            &mut queries.as_engine(),
            character_shape,
            character_mass,
            collisions,
        );
    }
}

#[cfg(feature = "dim3")]
pub use vehicle::{DynamicRayCastVehicleController, Wheel, WheelTuning};

#[cfg(feature = "dim3")]
mod vehicle {
    use crate::dynamics::RigidBodyHandle;
    use crate::math::Real;
    use crate::pipeline::QueryPipelineMut;
    use crate::wrapper::forward;
    pub use engine::control::{Wheel, WheelTuning};

    /// A vehicle whose wheels are rays.
    #[derive(Clone, Debug)]
    pub struct DynamicRayCastVehicleController(engine::control::DynamicRayCastVehicleController);

    forward!(DynamicRayCastVehicleController, engine::control::DynamicRayCastVehicleController);

    impl DynamicRayCastVehicleController {
        /// A vehicle without wheels.
        pub fn new(chassis: RigidBodyHandle) -> Self {
            Self(engine::control::DynamicRayCastVehicleController::new(chassis))
        }

        /// Applies the forces of the wheels to the chassis.
        pub fn update_vehicle(&mut self, dt: Real, mut queries: QueryPipelineMut<'_>) {
            self.0.update_vehicle(dt, queries.as_engine());
        }
    }
}
