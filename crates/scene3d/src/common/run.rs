//! Connects scenes to the gallery.

use super::scene::{Scene, SceneInfo};
use crate::rapier::prelude::*;
use drawing::{Drawing, View};
use gallery::{Entry, SceneRun, StageTimes, Stats};

/// The gallery's entries for these scenes.
pub fn entries(scenes: &[SceneInfo]) -> Vec<Entry> {
    scenes
        .iter()
        .map(|info| {
            let build = info.build;
            Entry {
                name: info.name,
                description: info.description,
                category: info.category,
                steps: info.steps,
                start: Box::new(move || Box::new(build())),
            }
        })
        .collect()
}

impl SceneRun for Scene {
    fn step(&mut self) -> StageTimes {
        Scene::step(self);
        measured(&self.world)
    }

    fn stats(&self) -> Stats {
        let mut stats = Stats { bodies: self.world.bodies.len(), ..Stats::default() };
        for (_, _, pair) in self.world.narrow_phase.contact_pairs() {
            if pair.has_any_active_contact {
                stats.contacts += 1;
                stats.penetration = stats.penetration.max(overlap(pair));
            }
        }
        stats
    }

    fn draw(&mut self) -> Drawing {
        let mut artist = std::mem::take(&mut self.artist);
        let drawing = artist.draw(self);
        self.artist = artist;
        drawing
    }

    fn view(&self) -> View {
        self.view
    }
}

/// Times of the stages of the last step.
fn measured(world: &PhysicsWorld) -> StageTimes {
    let counters = &world.physics_pipeline.counters;
    StageTimes {
        total: counters.step_time.time(),
        broad_phase: counters.cd.broad_phase_time.time(),
        narrow_phase: counters.cd.narrow_phase_time.time(),
        solver: counters.stages.solver_time.time(),
    }
}

/// Depth of the deepest overlap of two colliders that must not overlap.
fn overlap(pair: &ContactPair) -> f64 {
    let solid = pair
        .manifolds
        .iter()
        .filter(|m| m.data.solver_flags.contains(SolverFlags::COMPUTE_RIGID_IMPULSES));
    solid.flat_map(|m| &m.data).map(|contact| -f64::from(contact.dist)).fold(0.0, f64::max)
}
