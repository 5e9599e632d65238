//! A scene: a world, and its events beside physics.

use super::controls::Controls;
use super::draw::Artist;
use super::events::StepEvents;
use super::law::Law;
use crate::rapier::prelude::*;
use crate::shapes::point;
use drawing::Color;
use gallery::{Category, View};
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// A scene in the list.
#[derive(Copy, Clone)]
pub struct SceneInfo {
    /// Lower-case words joined by underscores.
    pub name: &'static str,
    /// One sentence about the visible motion.
    pub description: &'static str,
    /// Purpose of the scene.
    pub category: Category,
    /// Number of steps before the visible motion begins.
    pub steps: usize,
    /// Bounds of its bodies.
    pub law: Law,
    /// File with its source, as a path in the repository.
    pub source: &'static str,
    /// Builds the scene in its usual size.
    pub build: fn() -> Scene,
}

/// Changes the world before each step; the number counts the steps taken. A copy of a script continues on
/// its own.
pub trait Script: 'static {
    /// Changes the world.
    fn run(&mut self, world: &mut PhysicsWorld, steps_taken: usize);

    /// A copy with the same state.
    fn copy(&self) -> Box<dyn Script>;
}

impl<F: FnMut(&mut PhysicsWorld, usize) + Clone + 'static> Script for F {
    fn run(&mut self, world: &mut PhysicsWorld, steps_taken: usize) {
        self(world, steps_taken);
    }

    fn copy(&self) -> Box<dyn Script> {
        Box::new(self.clone())
    }
}

/// Colours by body.
pub type BodyColors = HashMap<RigidBodyHandle, Color>;

/// Reacts to the events of each step.
type Reaction = Rc<dyn Fn(&mut PhysicsWorld, &StepEvents)>;

/// Reads the world after each step.
type Observer = Rc<RefCell<dyn FnMut(&mut PhysicsWorld, &mut BodyColors, &StepEvents, usize, f64)>>;

/// A world with all that belongs to it.
pub struct Scene {
    /// The world.
    pub world: PhysicsWorld,
    /// Initial view.
    pub view: View,
    /// Number of steps taken.
    pub steps_taken: usize,
    /// Simulated time (s): the sum of the steps, each with the `dt` of its moment.
    pub time: f64,
    /// Length of the drawn free axes of joints; `None` draws none.
    pub joint_axes: Option<Real>,
    /// Texts and their positions.
    pub labels: Vec<(Vector, &'static str)>,
    /// Keys that control the scene.
    pub controls: Option<Controls>,
    /// Colours of bodies that are not those of the palette.
    pub body_colors: BodyColors,
    /// Keeps the meshes of shapes from picture to picture.
    pub(super) artist: Artist,
    observer: Option<Observer>,
    script: Option<Box<dyn Script>>,
    hooks: Rc<dyn PhysicsHooks>,
    reaction: Option<Reaction>,
}

/// Copies the world and the script, which continue bit for bit as the original does. The copy shares hooks
/// and the reaction, which have no state of their own, and the observer with its state.
impl Clone for Scene {
    fn clone(&self) -> Self {
        Self { world: self.world.clone(), ..self.without_world() }
    }

    /// Reuses the memory of the target's world.
    fn clone_from(&mut self, source: &Self) {
        let mut world = std::mem::take(&mut self.world);
        world.clone_from(&source.world);
        let artist = std::mem::take(&mut self.artist);
        *self = Self { world, artist, ..source.without_world() };
    }
}

impl Scene {
    /// A copy with an empty world.
    fn without_world(&self) -> Self {
        Self {
            world: PhysicsWorld::new(),
            view: self.view,
            steps_taken: self.steps_taken,
            time: self.time,
            joint_axes: self.joint_axes,
            labels: self.labels.clone(),
            controls: self.controls.clone(),
            body_colors: self.body_colors.clone(),
            artist: Artist::default(),
            observer: self.observer.clone(),
            script: self.script.as_ref().map(|script| script.copy()),
            hooks: self.hooks.clone(),
            reaction: self.reaction.clone(),
        }
    }

    /// A scene in which nothing happens but physics.
    pub fn new(world: PhysicsWorld, view: View) -> Self {
        Self {
            world,
            view,
            steps_taken: 0,
            time: 0.0,
            joint_axes: None,
            labels: Vec::new(),
            controls: None,
            body_colors: BodyColors::new(),
            artist: Artist::default(),
            observer: None,
            script: None,
            hooks: Rc::new(()),
            reaction: None,
        }
    }

    /// Sets the view to the box with these two opposite corners, instead of all moving bodies.
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
    pub fn script(
        mut self,
        script: impl FnMut(&mut PhysicsWorld, usize) + Clone + 'static,
    ) -> Self {
        self.script = Some(Box::new(script));
        self
    }

    /// Runs a function after each step, with its events, the number of steps taken and the simulated
    /// time (s). Copies of the scene share the function.
    pub fn observe(
        mut self,
        observer: impl FnMut(&mut PhysicsWorld, &mut BodyColors, &StepEvents, usize, f64) + 'static,
    ) -> Self {
        self.observer = Some(Rc::new(RefCell::new(observer)));
        self
    }

    /// Lets keys control the scene, whose script reads the direction.
    pub fn controlled(mut self, controls: Controls) -> Self {
        self.controls = Some(controls);
        self
    }

    /// Lets hooks take part in each step.
    pub fn hooks(self, hooks: impl PhysicsHooks + 'static) -> Self {
        self.shared_hooks(Rc::new(hooks))
    }

    /// Lets hooks with other owners take part in each step.
    pub fn shared_hooks(mut self, hooks: Rc<dyn PhysicsHooks>) -> Self {
        self.hooks = hooks;
        self
    }

    /// Changes the world after each step as its events demand. Without a state of its own, a reaction
    /// repeats after a return to an earlier copy.
    pub fn react(mut self, reaction: impl Fn(&mut PhysicsWorld, &StepEvents) + 'static) -> Self {
        self.reaction = Some(Rc::new(reaction));
        self
    }

    /// Runs the script, takes a step whose stages are timed, then runs the reaction to its events.
    pub fn step(&mut self) {
        self.world.physics_pipeline.counters.enable();
        self.step_by(|world, hooks, events| world.step_with_events(hooks, events));
    }

    /// The same as [`Self::step`], with another function that steps the world: a recorder's.
    pub fn step_by<T>(
        &mut self,
        step: impl FnOnce(&mut PhysicsWorld, &dyn PhysicsHooks, &dyn EventHandler) -> T,
    ) -> T {
        if let Some(script) = &mut self.script {
            script.run(&mut self.world, self.steps_taken);
        }
        self.steps_taken += 1;
        self.time += f64::from(self.world.integration_parameters.dt);
        let (world, hooks) = (&mut self.world, self.hooks.as_ref());
        let (result, events) = StepEvents::collect(|log| step(world, hooks, log));
        if let Some(react) = &self.reaction {
            react(&mut self.world, &events);
        }
        if let Some(observer) = &self.observer {
            let mut observe = observer.borrow_mut();
            observe(&mut self.world, &mut self.body_colors, &events, self.steps_taken, self.time);
        }
        result
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
