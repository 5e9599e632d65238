//! Characters: kinematic bodies that walk.

use super::body::Body;
use super::collider::Collider;
use super::garbage::traverse;
use super::numbers::{coordinates, finite, non_negative, vector, vector_out};
use super::options::Options;
use super::rapier::control::{
    CharacterAutostep, CharacterCollision, CharacterLength, EffectiveCharacterMovement,
    KinematicCharacterController,
};
use super::rapier::dynamics::{RigidBodyHandle, RigidBodyType};
use super::rapier::geometry::{ColliderHandle, SharedShape};
use super::rapier::math::{Pose, Real, Vector};
use super::rapier::pipeline::{PhysicsWorld, QueryFilter};
use super::world::{State, World};
use crate::errors::{invalid, stale};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The settings of a walking character. One controller can move many characters.
#[pyclass(frozen, module = "rapier")]
pub struct CharacterController {
    settings: KinematicCharacterController,
}

/// The result of a move.
#[pyclass(frozen, module = "rapier")]
pub struct CharacterMovement {
    world: Py<World>,
    movement: EffectiveCharacterMovement,
    collisions: Vec<ColliderHandle>,
}

fn settings(options: &Options<'_>) -> PyResult<KinematicCharacterController> {
    let mut settings = KinematicCharacterController::default();
    if let Some(up) = options.any("up")? {
        let up_vector = vector("up", &up)?.try_normalize();
        settings.up = up_vector
            .ok_or_else(|| invalid(format!("up is {up}, but must have a length greater than 0")))?;
    }
    if let Some(offset) = options.take("offset")? {
        settings.offset = CharacterLength::Absolute(non_negative("offset", offset)?);
    }
    settings.slide = options.take("slide")?.unwrap_or(settings.slide);
    if let Some(height) = options.take("step_height")? {
        let default = CharacterAutostep::default();
        let min_width = match options.take("step_width")? {
            Some(width) => CharacterLength::Absolute(non_negative("step_width", width)?),
            None => default.min_width,
        };
        settings.autostep = Some(CharacterAutostep {
            max_height: CharacterLength::Absolute(non_negative("step_height", height)?),
            min_width,
            ..default
        });
    }
    if let Some(angle) = options.take("max_slope_climb")? {
        settings.max_slope_climb_angle = non_negative("max_slope_climb", angle)?;
    }
    if let Some(angle) = options.take("min_slope_slide")? {
        settings.min_slope_slide_angle = non_negative("min_slope_slide", angle)?;
    }
    if let Some(distance) = options.take("snap_to_ground")? {
        settings.snap_to_ground =
            Some(CharacterLength::Absolute(non_negative("snap_to_ground", distance)?));
    }
    Ok(settings)
}

impl CharacterController {
    /// Moves a character in its world.
    fn walk(
        &self,
        state: &mut State,
        walk: Walk,
    ) -> Result<(EffectiveCharacterMovement, Vec<CharacterCollision>), Refusal> {
        let (queries, world) = state.queries();
        let dt = world.integration_parameters.dt;
        let (shape, start) = shape_of(world, walk.body)?;
        let filter = QueryFilter::default().exclude_rigid_body(walk.body);
        let mut collisions = Vec::new();
        let mut movement = self.settings.move_shape(
            dt,
            &queries.view(&world.colliders, filter),
            &*shape,
            &start,
            walk.translation,
            |collision| collisions.push(collision),
        );
        if let Some(mass) = walk.mass {
            let mut queries = queries.view_mut(&mut world.bodies, &world.colliders, filter);
            self.settings.solve_character_collision_impulses(
                dt,
                &mut queries,
                &*shape,
                mass,
                &collisions,
            );
        }
        if let Some(ground) = movement.ground {
            movement.translation += ground.displacement(&world.bodies, &world.colliders, dt);
        }
        let body = &mut world.bodies[walk.body];
        body.set_next_kinematic_translation(body.translation() + movement.translation);
        Ok((movement, collisions))
    }
}

/// The arguments of a move: the body, the desired translation, and the mass with which the character
/// pushes.
struct Walk {
    body: RigidBodyHandle,
    translation: Vector,
    mass: Option<Real>,
}

/// Reasons why a body cannot walk.
enum Refusal {
    Removed,
    Kind,
    NoCollider,
}

impl From<Refusal> for PyErr {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Removed => stale("body"),
            Refusal::Kind => invalid("a character must be a kinematic_position body"),
            Refusal::NoCollider => invalid("a character must have a collider"),
        }
    }
}

/// The shape of a character and its pose.
fn shape_of(world: &PhysicsWorld, handle: RigidBodyHandle) -> Result<(SharedShape, Pose), Refusal> {
    let body = world.bodies.get(handle).ok_or(Refusal::Removed)?;
    if body.body_type() != RigidBodyType::KinematicPositionBased {
        return Err(Refusal::Kind);
    }
    let collider = body.colliders().first().and_then(|&handle| world.colliders.get(handle));
    let collider = collider.ok_or(Refusal::NoCollider)?;
    Ok((collider.shared_shape().clone(), *collider.position()))
}

#[pymethods]
impl CharacterController {
    /// CharacterController(*, up=y, offset=None, slide=True, step_height=None, step_width=None,
    /// max_slope_climb=π/4, min_slope_slide=π/4, snap_to_ground=None)
    ///
    /// up: direction. offset: gap to all obstacles (m), by default 1 % of the height. slide:
    /// whether the character slides along obstacles.
    /// step_height: largest height of a step (m), by default no steps. step_width: free depth
    /// behind its edge (m), by default half of the width.
    /// max_slope_climb: steepest slope that it climbs (rad). min_slope_slide: flattest slope on
    /// which it slides down (rad).
    /// snap_to_ground: distance below the feet within which it follows the ground (m), by default a
    /// fifth of the height.
    #[new]
    #[pyo3(signature = (**options))]
    fn new(options: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let options = Options::new("CharacterController", options)?;
        let settings = settings(&options)?;
        options.finish()?;
        Ok(Self { settings })
    }

    /// Moves a "kinematic_position" body with a collider during the next step by as much of a
    /// translation (m, world) as the obstacles admit.
    ///
    /// The translation needs a downward part, such as that of gravity, or the character does not
    /// fall. The ground carries the character along.
    /// mass: with which it pushes dynamic bodies (kg), by default it pushes none.
    #[pyo3(name = "move", signature = (body, translation, *, mass=None))]
    fn move_body(
        &self,
        py: Python<'_>,
        body: &Body,
        translation: &Bound<'_, PyAny>,
        mass: Option<f64>,
    ) -> PyResult<CharacterMovement> {
        let translation = coordinates("translation", translation)?;
        let mass = mass.map(|mass| finite("mass", mass)).transpose()?;
        if let Some(mass) = mass.filter(|mass| *mass <= 0.0) {
            return Err(invalid(format!("mass is {mass}, but must be greater than 0")));
        }
        let walk = Walk { body: body.handle, translation, mass };
        let moved = body.world.get().detached(py, |state| self.walk(state, walk))?;
        let (movement, collisions) = moved?;
        let collisions = collisions.iter().map(|collision| collision.handle).collect();
        Ok(CharacterMovement { world: body.world.clone_ref(py), movement, collisions })
    }
}

traverse!(CharacterMovement, movement => movement.world);

#[pymethods]
impl CharacterMovement {
    /// The translation during the next step (m, world), with that of the ground.
    #[getter]
    fn translation<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Real>> {
        vector_out(py, self.movement.translation)
    }

    /// Whether the character stands on the ground at the end.
    #[getter]
    fn grounded(&self) -> bool {
        self.movement.grounded
    }

    /// Whether the character slid down a slope that is too steep to stand on.
    #[getter]
    fn sliding(&self) -> bool {
        self.movement.is_sliding_down_slope
    }

    /// The collider on which it stands, or None.
    #[getter]
    fn ground(&self, py: Python<'_>) -> Option<Collider> {
        self.movement
            .ground
            .map(|ground| Collider { world: self.world.clone_ref(py), handle: ground.collider })
    }

    /// Unit normal of the ground (world), or None.
    #[getter]
    fn ground_normal<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<Real>>> {
        self.movement.ground.map(|ground| vector_out(py, ground.normal))
    }

    /// The obstacles.
    #[getter]
    fn collisions(&self, py: Python<'_>) -> Vec<Collider> {
        self.collisions
            .iter()
            .map(|&handle| Collider { world: self.world.clone_ref(py), handle })
            .collect()
    }

    fn __repr__(&self) -> String {
        format!(
            "<CharacterMovement: {}, {}>",
            self.movement.translation,
            if self.movement.grounded { "grounded" } else { "in the air" }
        )
    }
}
