//! The scenes, and the loop that runs them.

mod edits;
mod ground;
mod joints;
mod kinematics;
mod piles;
mod queries;
mod timing;

use super::rapier::prelude::*;
use crate::{Fold, Run, Settings};
use std::sync::Mutex;

pub use timing::pile;

/// All scenes under their names.
pub const SCENES: [(&str, Run); 10] = [
    ("heap", |settings| run(settings, 200, piles::heap)),
    ("pyramid", |settings| run(settings, 150, piles::pyramid)),
    ("joints", |settings| run(settings, 200, joints::impulse_joints)),
    ("trees", |settings| run(settings, 150, joints::trees)),
    ("bullets", |settings| run(settings, 150, kinematics::bullets)),
    ("carriers", |settings| run(settings, 200, kinematics::carriers)),
    ("turnover", |settings| run(settings, 250, edits::turnover)),
    ("queries", |settings| run(settings, 150, queries::spawner)),
    ("ground", |settings| run(settings, 200, ground::terrain)),
    ("walkers", |settings| run(settings, 200, ground::walkers)),
];

/// Actions of a scene before each step. The hash includes all values that a scene reads from the world.
type Act = Box<dyn FnMut(&mut PhysicsWorld, usize, &mut Fold)>;

/// The hashes of events.
#[derive(Default)]
struct Events(Mutex<Fold>);

impl Events {
    fn fold(&self, words: [u64; 3]) {
        let mut fold = self.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        words.into_iter().for_each(|word| fold.word(word));
    }
}

impl EventHandler for Events {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        let [first, second] = [event.collider1(), event.collider2()].map(word_of);
        self.fold([u64::from(event.started()), first, second]);
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        event: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        let force = f64::from(event.total_force_magnitude).to_bits();
        self.fold([force, word_of(event.collider1), word_of(event.collider2)]);
    }

    fn handle_joint_break_event(&self, event: &JointBreakEvent, _: &RigidBodySet) {
        let (slot, generation) = event.joint.into_raw_parts();
        self.fold([2, u64::from(slot), u64::from(generation)]);
    }
}

fn word_of(collider: ColliderHandle) -> u64 {
    let (slot, generation) = collider.into_raw_parts();
    u64::from(slot) << 32 | u64::from(generation)
}

/// Folds the components of a vector in.
fn fold_vector(fold: &mut Fold, vector: Vector) {
    vector.to_array().into_iter().for_each(|number| fold.number(f64::from(number)));
}

/// Runs a scene and returns the hash of its states and events.
fn run(settings: Settings, steps: usize, build: fn(&mut PhysicsWorld) -> Act) -> u64 {
    let mut world = PhysicsWorld::new();
    world.physics_pipeline.set_wide_instructions(settings.wide);
    if let Some(threads) = Some(settings.threads).filter(|&threads| threads > 0) {
        let threads =
            Threads::new(threads).unwrap_or_else(|error| panic!("{threads} threads: {error}"));
        world.physics_pipeline.set_threads(threads);
    }
    let (mut fold, events) = (Fold::default(), Events::default());
    let mut act = build(&mut world);
    for step in 0..steps {
        act(&mut world, step, &mut fold);
        world.step_with_events(&(), &events);
        fold.word(world.hash());
    }
    let events = events.0.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    fold.word(events.value());
    fold.value()
}

/// Returns the action of a scene without external actions.
fn undisturbed() -> Act {
    Box::new(|_, _, _| ())
}
