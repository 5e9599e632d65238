//! Connects scenes to the gallery.

use super::draw::draw;
use super::scene::{Scene, SceneInfo};
use crate::rapier::prelude::*;
use gallery::{Entry, Pen, SceneRun, StageTimes, Stats, View};

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
        let counters = &self.world.physics_pipeline.counters;
        StageTimes {
            total: counters.step_time.time(),
            broad_phase: counters.cd.broad_phase_time.time(),
            narrow_phase: counters.cd.narrow_phase_time.time(),
            solver: counters.stages.solver_time.time(),
        }
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

    fn draw(&self, pen: &mut dyn Pen) {
        draw(self, pen);
    }

    fn view(&self) -> View {
        self.view
    }
}

/// How far two colliders overlap that should not.
fn overlap(pair: &ContactPair) -> f64 {
    let solid = pair
        .manifolds
        .iter()
        .filter(|m| m.data.solver_flags.contains(SolverFlags::COMPUTE_RIGID_IMPULSES));
    solid.flat_map(|m| &m.data).map(|contact| -f64::from(contact.dist)).fold(0.0, f64::max)
}
