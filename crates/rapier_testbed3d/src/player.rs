//! A scene that runs: pace, pause, single steps, history.

use crate::camera::OrbitCamera;
use crate::history::History;
use crate::pointer::Grip;
use crate::rapier::prelude::*;
use crate::scene::Scene;
use std::cell::Cell;
use std::time::{Duration, Instant};

/// Longest time that a frame may spend on steps; a scene that needs more runs slower than real time.
const BUDGET: Duration = Duration::from_millis(24);
/// Longest delay that is caught up, in seconds.
const CATCH_UP: f64 = 0.1;

/// Builds a scene, with a camera where its view is not sufficient.
pub(crate) type Build = std::sync::Arc<dyn Fn() -> (Scene, Option<OrbitCamera>) + Send + Sync>;

/// A running scene.
pub(crate) struct Player {
    build: Build,
    pub scene: Scene,
    pub history: History,
    /// Position in the history that is shown instead of the present.
    pub rewound: Option<usize>,
    /// Number of changes to the world beside its steps.
    changes: usize,
    hash: Cell<Option<(Moment, u64)>>,
}

/// A shown state: position in the history, steps taken, changes.
type Moment = (Option<usize>, usize, usize);

impl Player {
    /// A player from the start of its scene, and the camera of the scene.
    pub(crate) fn new(build: Build) -> (Self, Option<OrbitCamera>) {
        let (scene, camera) = build();
        let mut history = History::default();
        history.save(&scene);
        let hash = Cell::new(None);
        (Self { build, scene, history, rewound: None, changes: 0, hash }, camera)
    }

    /// A player of the same scene, from its start.
    pub(crate) fn twin(&self) -> Self {
        Self::new(self.build.clone()).0
    }

    /// Builds the scene anew and keeps the parameters.
    pub(crate) fn restart(&mut self) {
        let parameters = self.scene.world.integration_parameters;
        self.scene = (self.build)().0;
        self.scene.world.integration_parameters = parameters;
        self.history.clear();
        self.history.save(&self.scene);
        self.rewound = None;
        self.changes += 1;
    }

    /// The scene that is shown: the present, or a moment of the history.
    pub(crate) fn shown(&self) -> &Scene {
        self.rewound.and_then(|position| self.history.get(position)).unwrap_or(&self.scene)
    }

    /// Makes the shown moment the present.
    pub(crate) fn resume(&mut self) {
        let Some(position) = self.rewound.take() else { return };
        self.changes += 1;
        if let Some(moment) = self.history.get(position) {
            self.scene.clone_from(moment);
            self.history.truncate(position);
        }
    }

    /// Takes one step, with the pull of the pointer.
    pub(crate) fn step(&mut self, grip: Option<&Grip>) {
        self.resume();
        if let Some(grip) = grip {
            grip.pull(&mut self.scene.world);
        }
        self.scene.step();
        self.history.after_step(&self.scene);
    }

    /// The world of the present, for the pointer and the panels.
    pub(crate) fn world_mut(&mut self) -> &mut PhysicsWorld {
        self.resume();
        self.changes += 1;
        &mut self.scene.world
    }

    /// The hash of the shown world, which the first call for a moment computes: the bar shows it in each
    /// frame.
    pub(crate) fn hash(&self) -> u64 {
        let shown = self.shown();
        let moment = (self.rewound, shown.steps_taken, self.changes);
        let known = self.hash.get().filter(|(known, _)| *known == moment);
        let (_, hash) = known.unwrap_or_else(|| (moment, shown.world.hash()));
        self.hash.set(Some((moment, hash)));
        hash
    }
}

/// The pace: how many steps a frame takes.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Pace {
    pub running: bool,
    /// Simulated seconds for a second of real time.
    pub speed: f64,
    /// Steps to take while paused.
    pub single_steps: usize,
    owed: f64,
}

impl Default for Pace {
    fn default() -> Self {
        Self { running: true, speed: 1.0, single_steps: 0, owed: 0.0 }
    }
}

impl Pace {
    /// Returns whether the next frame takes steps.
    pub(crate) fn is_due(&self) -> bool {
        self.running || self.single_steps > 0
    }

    /// Runs steps for a frame that took `elapsed` seconds; `step` returns the length of the step. Returns
    /// the number of steps.
    pub(crate) fn run(&mut self, elapsed: f64, mut step: impl FnMut() -> f64) -> usize {
        if !self.running {
            let count = std::mem::take(&mut self.single_steps);
            (0..count).for_each(|_| {
                step();
            });
            return count;
        }
        self.owed = (self.owed + elapsed * self.speed).min(CATCH_UP * self.speed.max(1.0));
        let start = Instant::now();
        let mut count = 0;
        while self.owed > 0.0 && (count == 0 || start.elapsed() < BUDGET) {
            let length = step();
            count += 1;
            // A step without a length would repeat for ever.
            self.owed -= if length > 0.0 { length } else { self.owed };
        }
        count
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn falling() -> Build {
        std::sync::Arc::new(|| {
            let mut world = PhysicsWorld::new();
            world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
            (Scene::new(world, drawing::View::flat()), None)
        })
    }

    /// A scene that goes back and runs again arrives at the same bits.
    #[test]
    fn the_past_repeats() {
        let (mut player, _) = Player::new(falling());
        (0..60).for_each(|_| player.step(None));
        let hash = player.scene.world.hash();
        player.rewound = Some(4);
        assert_eq!(player.shown().steps_taken, 24);
        (0..36).for_each(|_| player.step(None));
        assert_eq!((player.scene.steps_taken, player.scene.world.hash()), (60, hash));
    }

    #[test]
    fn the_hash_is_that_of_the_shown_moment() {
        let (mut player, _) = Player::new(falling());
        (0..12).for_each(|_| player.step(None));
        let present = player.hash();
        assert_eq!(present, player.scene.world.hash());
        player.world_mut().gravity = Vector::ZERO;
        let (body, _) = player.scene.world.bodies.iter().next().expect("there is one");
        player.world_mut().bodies[body].set_linvel(Vector::X, true);
        assert_eq!(player.hash(), player.scene.world.hash());
        // The copy of the same step lacks the change.
        player.rewound = Some(2);
        assert_eq!(player.shown().steps_taken, 12);
        assert_eq!(player.hash(), present);
    }

    #[test]
    fn a_restart_keeps_the_parameters() {
        let (mut player, _) = Player::new(falling());
        player.scene.world.integration_parameters.num_solver_iterations = 9;
        player.step(None);
        player.restart();
        assert_eq!(player.scene.steps_taken, 0);
        assert_eq!(player.scene.world.integration_parameters.num_solver_iterations, 9);
    }

    #[test]
    fn the_pace_is_that_of_the_clock() {
        let mut pace = Pace { speed: 0.5, ..Pace::default() };
        let steps: usize = (0..60).map(|_| pace.run(1.0 / 60.0, || 1.0 / 60.0)).sum();
        assert!((29..=31).contains(&steps), "{steps} steps in a second at half speed");
        pace.running = false;
        pace.single_steps = 2;
        assert_eq!(pace.run(1.0, || 1.0 / 60.0), 2);
        assert_eq!(pace.run(1.0, || 1.0 / 60.0), 0);
    }
}
