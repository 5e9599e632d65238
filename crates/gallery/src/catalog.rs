//! A scene in the list of a gallery, and the run that the entry starts.

use drawing::{Drawing, View};
use std::time::Duration;

/// The kind of a scene.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Category {
    /// Bodies, forces, materials.
    Basics,
    /// The shapes of colliders, and terrains.
    Shapes,
    /// Joints, motors, mechanisms.
    Joints,
    /// Characters and vehicles.
    Controllers,
    /// Rays, casts, sensors.
    Queries,
    /// Events, hooks, edits while the world runs.
    Events,
    /// Large scenes, which show the speed of the engine.
    Stress,
    /// Inputs that are hard for a solver.
    Robustness,
    /// Scenes that once went wrong.
    PastBugs,
}

impl Category {
    /// All of them, in the order of lists.
    pub const ALL: [Self; 9] = [
        Self::Basics,
        Self::Shapes,
        Self::Joints,
        Self::Controllers,
        Self::Queries,
        Self::Events,
        Self::Stress,
        Self::Robustness,
        Self::PastBugs,
    ];

    /// The heading of its scenes in a list.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Basics => "Basics",
            Self::Shapes => "Shapes",
            Self::Joints => "Joints",
            Self::Controllers => "Controllers",
            Self::Queries => "Queries",
            Self::Events => "Events and hooks",
            Self::Stress => "Stress tests",
            Self::Robustness => "Robustness",
            Self::PastBugs => "Past bugs",
        }
    }
}

/// A scene in the list.
pub struct Entry {
    /// The name by which the command line calls it: lower-case words joined by underscores.
    pub name: &'static str,
    /// One sentence that says what there is to see.
    pub description: &'static str,
    /// The kind of the scene.
    pub category: Category,
    /// How many steps it takes unless the user says otherwise.
    pub steps: usize,
    /// Builds the scene.
    pub start: Box<dyn Fn() -> Box<dyn SceneRun>>,
}

/// A scene that is running.
pub trait SceneRun {
    /// Advances by one time step and says where the time went.
    fn step(&mut self) -> StageTimes;

    /// Counts what there is now. Not part of the time measured.
    fn stats(&self) -> Stats;

    /// Draws the current state.
    fn draw(&mut self) -> Drawing;

    /// From where to look at it.
    fn view(&self) -> View;
}

/// What a scene holds at one moment.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Stats {
    /// Bodies, of all types.
    pub bodies: usize,
    /// Points at which two colliders touch.
    pub contacts: usize,
    /// How far the two most overlapping colliders overlap (length units); 0 if none do.
    pub penetration: f64,
}

/// Where the time of a step went.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct StageTimes {
    /// The whole step.
    pub total: Duration,
    /// Finding pairs of colliders that are near each other.
    pub broad_phase: Duration,
    /// Computing where they touch.
    pub narrow_phase: Duration,
    /// Solving for velocities and moving the bodies.
    pub solver: Duration,
}

impl std::ops::AddAssign for StageTimes {
    fn add_assign(&mut self, other: Self) {
        self.total += other.total;
        self.broad_phase += other.broad_phase;
        self.narrow_phase += other.narrow_phase;
        self.solver += other.solver;
    }
}

impl StageTimes {
    /// Percentages of the total: broad phase, narrow phase, solver, and all the rest.
    pub(crate) fn shares(&self) -> [f64; 4] {
        let total = self.total.as_secs_f64();
        if total <= 0.0 {
            return [0.0; 4];
        }
        let percent = |part: Duration| part.as_secs_f64() / total * 100.0;
        let parts = [percent(self.broad_phase), percent(self.narrow_phase), percent(self.solver)];
        let rest = (100.0 - parts.iter().sum::<f64>()).max(0.0);
        [parts[0], parts[1], parts[2], rest]
    }
}
