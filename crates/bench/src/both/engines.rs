//! The engines that run a template, and the scenes as templates.

use super::ours::prelude::*;
use super::template::{Rules, Template};
use super::{double, examples, rapier, start_box, this, three};
use crate::catalog::Scene;
use crate::clock::Clock;
use crate::engine::{Engine, Kind, Unsupported};

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
            build: Box::new(|| Box::new(Template::new(Rules::default(), || (info.build)().world))),
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
        world.physics_pipeline.counters.enable();
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
        ("  ccd", stages.ccd_time.time_ms()),
        ("  finalize bodies", stages.update_time.time_ms()),
    ]
}
