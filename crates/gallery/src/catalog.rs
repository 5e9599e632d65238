//! A scene in the list of a gallery, and its run.

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
    /// Large scenes, which measure the speed of the engine.
    Stress,
    /// Inputs that are hard for a solver.
    Robustness,
    /// Regression scenes of past bugs.
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
    /// Name on the command line: lower-case words joined by underscores.
    pub name: &'static str,
    /// One sentence that describes the scene.
    pub description: &'static str,
    /// The kind of the scene.
    pub category: Category,
    /// Default number of steps.
    pub steps: usize,
    /// Builds the scene.
    pub start: Box<dyn Fn() -> Box<dyn SceneRun>>,
}

/// A scene that is running.
pub trait SceneRun {
    /// Advances by one time step and returns the times of its stages.
    fn step(&mut self) -> StageTimes;

    /// Returns counts of the present state. The time is not measured.
    fn stats(&self) -> Stats;

    /// Draws the current state.
    fn draw(&mut self) -> Drawing;

    /// Returns the viewing direction.
    fn view(&self) -> View;
}

/// Counts of a scene at one moment.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Stats {
    /// Bodies, of all types.
    pub bodies: usize,
    /// Points at which two colliders touch.
    pub contacts: usize,
    /// Largest penetration of two colliders (length units); 0 without overlap.
    pub penetration: f64,
}

/// Times of a step's stages.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct StageTimes {
    /// The whole step.
    pub total: Duration,
    /// Detection of nearby pairs of colliders.
    pub broad_phase: Duration,
    /// Computation of contacts.
    pub narrow_phase: Duration,
    /// Solution of velocities and integration of positions.
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
    /// Returns percentages of the total: broad phase, narrow phase, solver, and the rest.
    pub(crate) fn percentages(&self) -> [f64; 4] {
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
