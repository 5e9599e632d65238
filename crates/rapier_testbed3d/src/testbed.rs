//! The interface for programs with worlds of their own: names that existing examples call.

use crate::camera::OrbitCamera;
use crate::rapier::prelude::*;
use crate::scene::{BodyColors, Scene};
use drawing::{Color, View};
use std::rc::Rc;
use std::sync::mpsc::{Receiver, channel};

/// Called after each step.
type Callback =
    Box<dyn FnMut(Option<&mut TestbedGraphics>, &mut PhysicsWorld, &PhysicsEvents, &RunState)>;

/// Events of the last step.
pub struct PhysicsEvents {
    /// Colliders that began or stopped to touch.
    pub collision_events: Receiver<CollisionEvent>,
    /// Contacts with a force of at least the threshold of a collider.
    pub contact_force_events: Receiver<ContactForceEvent>,
}

/// The state of the run.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct RunState {
    /// Number of steps taken.
    pub timestep_id: usize,
    /// Simulated seconds.
    pub time: f32,
}

/// Colours of bodies, for callbacks.
#[derive(Default)]
pub struct TestbedGraphics {
    colors: BodyColors,
}

impl TestbedGraphics {
    /// Sets the colour of a body: red, green and blue from 0 to 1.
    pub fn set_body_color(&mut self, body: RigidBodyHandle, [red, green, blue]: [f32; 3]) {
        self.colors.insert(body, Color { red, green, blue, opacity: 1.0 });
    }
}

/// A world under construction, and its view.
pub struct Testbed {
    world: PhysicsWorld,
    hooks: Option<Rc<dyn PhysicsHooks>>,
    callbacks: Vec<Callback>,
    graphics: TestbedGraphics,
    pub(crate) camera: Option<OrbitCamera>,
}

impl Testbed {
    pub(crate) fn new() -> Self {
        Self {
            world: PhysicsWorld::new(),
            hooks: None,
            callbacks: Vec::new(),
            graphics: TestbedGraphics::default(),
            camera: None,
        }
    }

    /// Shows these bodies, colliders and joints.
    pub fn set_world(
        &mut self,
        bodies: RigidBodySet,
        colliders: ColliderSet,
        impulse_joints: ImpulseJointSet,
        multibody_joints: MultibodyJointSet,
    ) {
        let gravity = self.world.gravity;
        self.set_world_with_params(
            bodies,
            colliders,
            impulse_joints,
            multibody_joints,
            gravity,
            (),
        );
    }

    /// Shows these bodies, colliders and joints, with a gravity and hooks.
    pub fn set_world_with_params(
        &mut self,
        bodies: RigidBodySet,
        colliders: ColliderSet,
        impulse_joints: ImpulseJointSet,
        multibody_joints: MultibodyJointSet,
        gravity: Vector,
        hooks: impl PhysicsHooks + 'static,
    ) {
        let integration_parameters = self.world.integration_parameters;
        self.world = PhysicsWorld {
            gravity,
            integration_parameters,
            bodies,
            colliders,
            impulse_joints,
            multibody_joints,
            ..PhysicsWorld::new()
        };
        self.hooks = Some(Rc::new(hooks));
    }

    /// Shows a whole world.
    pub fn set_physics_world(&mut self, world: PhysicsWorld) {
        self.world = world;
    }

    /// The parameters of the step.
    pub fn integration_parameters_mut(&mut self) -> &mut IntegrationParameters {
        &mut self.world.integration_parameters
    }

    /// Sets the colour of a body: red, green and blue from 0 to 1.
    pub fn set_initial_body_color(&mut self, body: RigidBodyHandle, color: [f32; 3]) {
        self.graphics.set_body_color(body, color);
    }

    /// Runs a function after each step. The slider of the time restores the world and the colours, and
    /// leaves the variables of the function as they are.
    pub fn add_callback(
        &mut self,
        callback: impl FnMut(Option<&mut TestbedGraphics>, &mut PhysicsWorld, &PhysicsEvents, &RunState)
        + 'static,
    ) {
        self.callbacks.push(Box::new(callback));
    }

    /// The scene, with the chosen camera.
    pub(crate) fn into_scene(self) -> (Scene, Option<OrbitCamera>) {
        let Self { world, hooks, mut callbacks, graphics, camera } = self;
        let view = if DIM == 2 { View::flat() } else { View::orbit(30.0, 22.0) };
        let (send_collision, collision_events) = channel();
        let (send_force, contact_force_events) = channel();
        let events = PhysicsEvents { collision_events, contact_force_events };
        let mut scene = Scene::new(world, view).observe(move |world, colors, step, steps, time| {
            let state = RunState { timestep_id: steps, time: time as f32 };
            let mut graphics = TestbedGraphics { colors: std::mem::take(colors) };
            // The closure owns both ends of each channel, so no event is lost.
            step.collisions.iter().for_each(|event| _ = send_collision.send(*event));
            step.contact_forces.iter().for_each(|event| _ = send_force.send(*event));
            for callback in &mut callbacks {
                callback(Some(&mut graphics), world, &events, &state);
            }
            // Events that no callback read must not pile up.
            events.collision_events.try_iter().for_each(drop);
            events.contact_force_events.try_iter().for_each(drop);
            *colors = graphics.colors;
        });
        scene.body_colors = graphics.colors;
        if let Some(hooks) = hooks {
            scene = scene.shared_hooks(hooks);
        }
        (scene, camera)
    }
}
