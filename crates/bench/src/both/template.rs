//! A scene built by this engine, for running here or transcription into another engine.

use super::ours::prelude::*;
use super::{small_worlds, worlds};
use crate::growth::world::World;
use crate::small::Small;
use std::collections::HashMap;

/// Length of a step for all engines (s).
pub const DT: f32 = 1.0 / 60.0;
/// Substeps of a step for all engines.
pub const SUBSTEPS: usize = 4;

/// Rules that are off in contests.
#[derive(Copy, Clone, Default)]
pub struct Rules {
    /// Whether bodies may sleep if the scene allows it.
    pub may_sleep: bool,
    /// Whether engines detect collisions continuously, each as far as its defaults do.
    pub is_continuous: bool,
}

/// Scene that is built but not yet run.
pub struct Template {
    /// Builds the scene.
    build: Box<dyn Fn() -> PhysicsWorld>,
    pub rules: Rules,
    /// The built world.
    pub world: PhysicsWorld,
    /// Bodies, in the order of their transcription.
    pub bodies: Vec<RigidBodyHandle>,
    /// Joints, each with the positions of its bodies in that order.
    pub joints: Vec<([usize; 2], GenericJoint)>,
}

impl Template {
    /// Builds a scene.
    pub fn new(rules: Rules, build: impl Fn() -> PhysicsWorld + 'static) -> Self {
        let world = build();
        let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
        let positions: HashMap<_, _> = bodies.iter().copied().zip(0..).collect();
        let joints = world.impulse_joints();
        let joints = joints.map(|(_, joint)| {
            ([joint.body1(), joint.body2()].map(|body| positions[&body]), joint.data)
        });
        let joints = joints.collect();
        Self { build: Box::new(build), rules, world, bodies, joints }
    }

    /// Builds a growing world.
    pub fn grown(world: World) -> Self {
        let may_sleep = matches!(world, World::Sleeping { .. });
        Self::new(Rules { may_sleep, ..Rules::default() }, move || worlds::build(world))
    }

    /// Builds a world of few bodies.
    pub fn small(world: Small) -> Self {
        let rules = Rules { is_continuous: true, ..Rules::default() };
        Self::new(rules, move || small_worlds::build(world))
    }

    /// Builds the scene again, with the rules that all engines follow.
    pub fn fresh_world(&self) -> PhysicsWorld {
        let mut world = (self.build)();
        world.integration_parameters.dt = DT;
        world.integration_parameters.num_solver_iterations = SUBSTEPS;
        world.integration_parameters.max_ccd_substeps = usize::from(self.rules.is_continuous);
        for (_, body) in world.bodies.iter_mut() {
            if !self.lets_sleep(body) {
                *body.activation_mut() = RigidBodyActivation::cannot_sleep();
            }
        }
        world
    }

    /// Returns whether this body of the template may fall asleep.
    pub fn lets_sleep(&self, body: &RigidBody) -> bool {
        self.rules.may_sleep && body.activation().normalized_linear_threshold >= 0.0
    }

    /// Returns each body with its colliders, in order.
    pub fn parts(&self) -> impl Iterator<Item = (&RigidBody, impl Iterator<Item = &Collider>)> {
        self.bodies.iter().map(|&handle| {
            let body = &self.world.bodies[handle];
            (body, body.colliders().iter().map(|&collider| &self.world.colliders[collider]))
        })
    }

    /// Returns the colliders without a body.
    pub fn loose_colliders(&self) -> impl Iterator<Item = &Collider> {
        self.world.colliders.iter().map(|(_, collider)| collider).filter(|c| c.parent().is_none())
    }
}
