//! A scene built by this engine, for running here or transcription into another engine.

use super::ours::prelude::*;
use super::{double, examples, rapier, start_box, this, three, worlds};
use crate::catalog::Scene;
use crate::clock::Clock;
use crate::engine::{Engine, Kind, Unsupported};
use crate::growth::World;
use std::collections::HashMap;

/// Length of a step for all engines (s).
pub const DT: f32 = 1.0 / 60.0;
/// Substeps of a step for all engines.
pub const SUBSTEPS: usize = 4;

/// Scene that is built but not yet run.
pub struct Template {
    /// Builds the scene.
    build: Box<dyn Fn() -> PhysicsWorld>,
    /// Whether bodies may sleep if the scene allows it.
    pub may_sleep: bool,
    /// The built world.
    pub world: PhysicsWorld,
    /// Bodies, in the order of their transcription.
    pub bodies: Vec<RigidBodyHandle>,
    /// Joints, each with the positions of its bodies in that order.
    pub joints: Vec<([usize; 2], GenericJoint)>,
}

impl Template {
    /// Builds a scene.
    fn new(may_sleep: bool, build: impl Fn() -> PhysicsWorld + 'static) -> Self {
        let world = build();
        let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
        let positions: HashMap<_, _> = bodies.iter().copied().zip(0..).collect();
        let joints = world.impulse_joints();
        let joints = joints.map(|(_, joint)| {
            ([joint.body1(), joint.body2()].map(|body| positions[&body]), joint.data)
        });
        let joints = joints.collect();
        Self { build: Box::new(build), may_sleep, world, bodies, joints }
    }

    /// Builds a growing world.
    pub fn grown(world: World) -> Self {
        Self::new(matches!(world, World::Sleeping { .. }), move || worlds::build(world))
    }

    /// Builds the scene again, with the rules that all engines follow.
    pub fn fresh_world(&self) -> PhysicsWorld {
        let mut world = (self.build)();
        world.integration_parameters.dt = DT;
        world.integration_parameters.num_solver_iterations = SUBSTEPS;
        world.integration_parameters.max_ccd_substeps = 0;
        for (_, body) in world.bodies.iter_mut() {
            if !self.lets_sleep(body) {
                *body.activation_mut() = RigidBodyActivation::cannot_sleep();
            }
        }
        world
    }

    /// Returns whether this body of the template may fall asleep.
    pub fn lets_sleep(&self, body: &RigidBody) -> bool {
        self.may_sleep && body.activation().normalized_linear_threshold >= 0.0
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

/// Returns the scenes of the gallery with these names. The flag of a name marks a default scene.
pub fn catalog(dimension: &'static str, names: &[(&str, bool)]) -> Vec<Scene> {
    let infos = names
        .iter()
        .filter_map(|(name, by_default)| examples::find(name).map(|info| (info, *by_default)));
    infos
        .map(|(info, by_default)| Scene {
            name: info.name,
            dimension,
            steps: info.steps,
            by_default,
            build: Box::new(|| Box::new(Template::new(false, || (info.build)().world))),
        })
        .collect()
}

impl crate::engine::Template for Template {
    fn dynamic_bodies(&self) -> usize {
        self.world.bodies.iter().filter(|(_, body)| body.is_dynamic()).count()
    }

    fn region(&self) -> [[f32; 3]; 2] {
        let mut around = Aabb::new_invalid();
        for (_, collider) in self.world.colliders.iter() {
            let parent = collider.parent().map(|parent| &self.world.bodies[parent]);
            if parent.is_some_and(RigidBody::is_dynamic) {
                around.merge(&collider.compute_aabb());
            }
        }
        [three(around.mins), three(around.maxs)]
    }

    fn start(&self, kind: Kind, threads: usize) -> Result<Box<dyn Engine + '_>, Unsupported> {
        match kind {
            Kind::This => Ok(Box::new(this::start(self))),
            Kind::Rapier => Ok(Box::new(rapier::start(self)?)),
            Kind::Double => Ok(Box::new(double::start(self)?)),
            Kind::Box => start_box(self, threads),
        }
    }

    fn profile(&self, steps: usize, after_step: &mut dyn FnMut(usize)) -> Vec<(&'static str, f64)> {
        let mut world = self.fresh_world();
        // The profile has no peers beside it, and includes the CCD stage.
        world.integration_parameters.max_ccd_substeps = 1;
        let mut sums: Vec<(&'static str, f64)> = Vec::new();
        let mut on_processors = 0.0;
        for done in 1..=steps {
            let clock = Clock::start_processor();
            world.step();
            on_processors += clock.milliseconds();
            for (index, (name, milliseconds)) in stages(&world).into_iter().enumerate() {
                match sums.get_mut(index) {
                    Some((_, sum)) => *sum += milliseconds,
                    None => sums.push((name, milliseconds)),
                }
            }
            after_step(done);
        }
        sums.push(("on processors", on_processors));
        sums.iter_mut().for_each(|(_, sum)| *sum /= steps as f64);
        sums
    }
}

/// Returns the times of the stages of the last step (ms). Indented stages are parts of the stage above.
fn stages(world: &PhysicsWorld) -> [(&'static str, f64); 11] {
    let counters = &world.physics_pipeline.counters;
    let (stages, solver) = (&counters.stages, &counters.solver);
    [
        ("step", counters.step_time.time_ms()),
        ("  user changes", stages.user_changes.time_ms()),
        ("  broad phase", counters.cd.broad_phase_time.time_ms()),
        ("  narrow phase", counters.cd.narrow_phase_time.time_ms()),
        ("  islands", stages.island_construction_time.time_ms()),
        ("  solver", stages.solver_time.time_ms()),
        ("    assembly", solver.velocity_assembly_time.time_ms()),
        ("    substeps", solver.velocity_resolution_time.time_ms()),
        ("    write back", solver.velocity_writeback_time.time_ms()),
        ("  continuous", stages.ccd_time.time_ms()),
        ("  advance", stages.update_time.time_ms()),
    ]
}
