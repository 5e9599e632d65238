//! A world with all handles that were ever created in it, for random operations.

use super::dim::Vehicle;
use super::event_checker::EventChecker;
use super::groups::OTHERS;
use super::isolated_bodies::IsolatedBodies;
use super::rapier::prelude::*;
use super::values::{some_real, some_vector};
use super::world_copy::WorldCopy;
use crate::choices::Choices;

/// Largest number of bodies.
pub const BODIES_MAX: usize = 30;
pub const COLLIDERS_MAX: usize = 70;
pub const JOINTS_MAX: usize = 30;

/// World with all handles that were ever created in it.
pub struct Play<'a> {
    pub choices: Choices<'a>,
    pub world: PhysicsWorld,
    pub bodies: Vec<RigidBodyHandle>,
    pub colliders: Vec<ColliderHandle>,
    pub joints: Vec<ImpulseJointHandle>,
    pub links: Vec<MultibodyJointHandle>,
    /// Removed bodies, for later insertion.
    pub removed: Vec<RigidBody>,
    /// Earlier state of the world.
    pub copy: Option<WorldCopy>,
    pub isolated_bodies: IsolatedBodies,
    pub event_checker: EventChecker,
    pub vehicle: Vehicle,
    pub pid: PidController,
    pub queries: QueryPipeline,
}

impl<'a> Play<'a> {
    pub fn new(choices: Choices<'a>) -> Self {
        let mut world = PhysicsWorld::new();
        let ground = ColliderBuilder::halfspace(Vector::Y)
            .active_events(ActiveEvents::all())
            .collision_groups(OTHERS);
        let ground = world.insert_collider(ground, None);
        let isolated_bodies = IsolatedBodies::new(&mut world);
        Self {
            choices,
            world,
            bodies: vec![RigidBodyHandle::invalid()],
            colliders: vec![ground],
            joints: vec![ImpulseJointHandle::invalid()],
            links: vec![MultibodyJointHandle::invalid()],
            removed: Vec::new(),
            copy: None,
            isolated_bodies,
            event_checker: EventChecker::default(),
            vehicle: Vehicle::default(),
            pid: PidController::default(),
            queries: QueryPipeline::new(),
        }
    }

    /// Returns any body handle except an isolated body's: usually of an existing body, sometimes a stale or
    /// foreign one.
    pub fn body(&mut self) -> RigidBodyHandle {
        let handle = if self.choices.once_in(30) {
            let (slot, generation) = (self.choices.below(70) as u32, self.choices.below(4) as u32);
            RigidBodyHandle::from_raw_parts(slot, generation)
        } else {
            recent(&self.bodies, &mut self.choices)
        };
        self.choices.print(|| format!("    {handle:?}"));
        if self.isolated_bodies.bodies.contains(&handle) {
            RigidBodyHandle::invalid()
        } else {
            handle
        }
    }

    /// Returns any collider handle except an isolated body's.
    pub fn collider(&mut self) -> ColliderHandle {
        let handle = if self.choices.once_in(30) {
            let (slot, generation) = (self.choices.below(70) as u32, self.choices.below(4) as u32);
            ColliderHandle::from_raw_parts(slot, generation)
        } else {
            recent(&self.colliders, &mut self.choices)
        };
        self.choices.print(|| format!("    {handle:?}"));
        let is_isolated = self.isolated_bodies.colliders.contains(&handle);
        if is_isolated { ColliderHandle::invalid() } else { handle }
    }

    /// Returns any joint handle.
    pub fn joint(&mut self) -> ImpulseJointHandle {
        recent(&self.joints, &mut self.choices)
    }

    /// Returns any handle of a multibody joint.
    pub fn link(&mut self) -> MultibodyJointHandle {
        recent(&self.links, &mut self.choices)
    }

    /// Changes gravity or a parameter of the world.
    pub fn change_parameters(&mut self) {
        let choices = &mut self.choices;
        let params = &mut self.world.integration_parameters;
        match choices.below(10) {
            0 => self.world.gravity = some_vector(choices, 20.0),
            1 => params.dt = choices.pick(&[1.0 / 60.0, 0.0, 1.0e-9, 0.5, 10.0]),
            2 => params.dt = some_real(choices),
            3 => params.num_solver_iterations = choices.below(9),
            4 => params.num_internal_pgs_iterations = choices.below(4),
            5 => params.num_additional_friction_iterations = choices.below(4),
            6 => params.max_ccd_substeps = choices.below(4),
            7 => params.length_unit = some_real(choices),
            8 => {
                params.friction_model =
                    choices.pick(&[FrictionModel::Standard, FrictionModel::Coulomb])
            }
            _ => change_softness(params, choices),
        }
    }

    /// Restores default parameters and gravity, so that the next steps have effects.
    pub fn reset_parameters(&mut self) {
        self.world.integration_parameters = IntegrationParameters::default();
        self.world.gravity = Vector::Y * -9.81;
    }
}

fn change_softness(params: &mut IntegrationParameters, choices: &mut Choices<'_>) {
    let value = some_real(choices);
    match choices.below(12) {
        0 => params.erp = value,
        1 => params.damping_ratio = value,
        2 => params.joint_erp = value,
        3 => params.joint_damping_ratio = value,
        4 => params.allowed_linear_error = value,
        5 => params.normalized_prediction_distance = value,
        6 => params.normalized_max_corrective_velocity = value,
        7 => params.normalized_max_linear_velocity = value,
        8 => params.normalized_contact_recycle_distance = value,
        9 => params.warmstart_coefficient = value,
        10 => params.min_ccd_dt = value,
        _ => params.ccd_on_penetration = choices.coin(),
    }
}

/// Returns one of the last handles.
fn recent<T: Copy>(handles: &[T], choices: &mut Choices<'_>) -> T {
    let first = handles.len().saturating_sub(40);
    handles[first + choices.below(handles.len() - first)]
}
