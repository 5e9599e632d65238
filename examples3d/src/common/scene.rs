//! A scene: a world, and what happens to it beside physics.

use crate::rapier::prelude::*;
use crate::solid::point;
use gallery::{Category, View};

/// A scene in the list.
#[derive(Copy, Clone)]
pub struct SceneInfo {
    /// Lower-case words joined by underscores.
    pub name: &'static str,
    /// One sentence that says what there is to see.
    pub description: &'static str,
    /// What the scene is for.
    pub category: Category,
    /// After how many steps there is something to see.
    pub steps: usize,
    /// Builds the scene in its usual size.
    pub build: fn() -> Scene,
}

/// What a scene does to its world before each step, given how many steps have been taken.
pub type Script = Box<dyn FnMut(&mut PhysicsWorld, usize)>;

/// A world with all that belongs to it.
pub struct Scene {
    /// The world.
    pub world: PhysicsWorld,
    /// From where to look at it.
    pub view: View,
    /// Number of steps taken.
    pub steps_taken: usize,
    /// How long the free axes of joints are drawn; `None`: they are not.
    pub joint_axes: Option<Real>,
    /// What is written where.
    pub labels: Vec<(Vector, &'static str)>,
    script: Option<Script>,
    hooks: Box<dyn PhysicsHooks>,
    events: Box<dyn EventHandler>,
}

impl Scene {
    /// A scene in which nothing happens but physics.
    pub fn new(world: PhysicsWorld, view: View) -> Self {
        Self {
            world,
            view,
            steps_taken: 0,
            joint_axes: None,
            labels: Vec::new(),
            script: None,
            hooks: Box::new(()),
            events: Box::new(()),
        }
    }

    /// Looks at the box with these two opposite corners, rather than at all that moves.
    pub fn focusing(mut self, min: Vector, max: Vector) -> Self {
        self.view = self.view.focus(point(min), point(max));
        self
    }

    /// Draws joints on top of everything, and their free axes so long.
    pub fn showing_joints(mut self, length: Real) -> Self {
        self.joint_axes = Some(length);
        self
    }

    /// Writes a word or two into the picture, with their middle at a place.
    pub fn label(mut self, at: Vector, text: &'static str) -> Self {
        self.labels.push((at, text));
        self
    }

    /// Does something to the world before each step.
    pub fn script(mut self, script: impl FnMut(&mut PhysicsWorld, usize) + 'static) -> Self {
        self.script = Some(Box::new(script));
        self
    }

    /// Lets hooks take part in each step.
    pub fn hooks(mut self, hooks: impl PhysicsHooks + 'static) -> Self {
        self.hooks = Box::new(hooks);
        self
    }

    /// Sends the events of each step somewhere.
    pub fn events(mut self, events: impl EventHandler + 'static) -> Self {
        self.events = Box::new(events);
        self
    }

    /// Runs the script, then takes a step.
    pub fn step(&mut self) {
        self.step_by(|world, hooks, events| world.step_with_events(hooks, events));
    }

    /// The same as [`Self::step`], with another function that steps the world: a recorder's.
    pub fn step_by<T>(
        &mut self,
        step: impl FnOnce(&mut PhysicsWorld, &dyn PhysicsHooks, &dyn EventHandler) -> T,
    ) -> T {
        if let Some(script) = &mut self.script {
            script(&mut self.world, self.steps_taken);
        }
        self.steps_taken += 1;
        step(&mut self.world, self.hooks.as_ref(), self.events.as_ref())
    }

    /// The hooks that take part in each step.
    pub fn step_hooks(&self) -> &dyn PhysicsHooks {
        self.hooks.as_ref()
    }

    /// Takes several steps.
    pub fn run(&mut self, steps: usize) {
        (0..steps).for_each(|_| self.step());
    }
}
