//! The recorder of a world's steps and edits.

use super::error::RecordingError;
use super::frame::{Edits, Frame, Opening, write_frame, write_opening};
use crate::api::snapshot::snapshot_delta;
use crate::api::world::PhysicsWorld;
use crate::model::event::EventHandler;
use crate::model::hooks::PhysicsHooks;

/// A recorder of a run: a first snapshot, all edits, and the hashes after every step.
///
/// Step the world with [`Self::step`] instead of its own method. Edit the world in any way between the steps.
/// The recorder saves the world twice per step, which takes about as long as several steps. Use it to find a
/// defect, and to report the defect as one file.
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut world = PhysicsWorld::new();
/// let (ball, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
/// let mut recorder = Recorder::new(&world, "a ball that is pushed")?;
/// for k in 0..20 {
///     if k == 10 {
///         world.bodies[ball].apply_impulse(vector![1.0, 0.0, 0.0], true);
///     }
///     recorder.step(&mut world)?;
/// }
/// let file = recorder.into_bytes();
///
/// // Elsewhere:
/// let mut replay = Replay::new(&file)?;
/// while let Replayed::Step = replay.step()? {}
/// assert_eq!(replay.world().hash(), world.hash());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Recorder {
    bytes: Vec<u8>,
    /// The world after the last step.
    last: Vec<u8>,
    /// The world before the next one. Kept for its memory.
    next: Vec<u8>,
    steps: usize,
    with_stages: bool,
    /// The error that ended the recording.
    failure: Option<RecordingError>,
}

impl Recorder {
    /// Begins a recording of a world. The title describes it.
    ///
    /// # Errors
    /// If the world cannot be saved, because a collider has a user-defined shape.
    pub fn new(world: &PhysicsWorld, title: &str) -> Result<Self, RecordingError> {
        let snapshot = world.to_snapshot()?;
        let engine = env!("CARGO_PKG_VERSION").to_string();
        let opening = Opening { title: title.to_string(), engine, snapshot };
        let bytes = write_opening(&opening);
        let last = opening.snapshot;
        Ok(Self { bytes, last, next: Vec::new(), steps: 0, with_stages: false, failure: None })
    }

    /// Records hashes after every stage of a step, too. A divergence then names the stage.
    #[must_use]
    pub fn with_stage_hashes(mut self) -> Self {
        self.with_stages = true;
        self
    }

    /// Number of steps recorded.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Records the edits since the last step, steps the world, and records the hashes.
    ///
    /// # Errors
    /// If the world cannot be saved. The recording then ends before this step. This call and all later ones
    /// step the world nevertheless, and return the same error.
    pub fn step(&mut self, world: &mut PhysicsWorld) -> Result<(), RecordingError> {
        self.step_with_events(world, &(), &())
    }

    /// The same as [`Self::step`], with hooks and events. Hooks are not recorded: a replay needs the same
    /// ones.
    ///
    /// # Errors
    /// If the world cannot be saved. The recording then ends before this step. This call and all later ones
    /// step the world nevertheless, and return the same error.
    pub fn step_with_events(
        &mut self,
        world: &mut PhysicsWorld,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) -> Result<(), RecordingError> {
        let edits = self.failure.clone().map_or_else(|| self.find_edits(world), Err);
        world.physics_pipeline.set_stage_hashes(self.with_stages);
        world.step_with_events(hooks, events);
        let recorded = edits.and_then(|edits| self.append(world, edits));
        self.failure = recorded.clone().err();
        recorded
    }

    /// Records the world after a step.
    fn append(&mut self, world: &PhysicsWorld, edits: Option<Edits>) -> Result<(), RecordingError> {
        world.write_snapshot(&mut self.last)?;
        write_frame(&Frame::of(world, edits), &mut self.bytes);
        self.steps += 1;
        Ok(())
    }

    fn find_edits(&mut self, world: &PhysicsWorld) -> Result<Option<Edits>, RecordingError> {
        world.write_snapshot(&mut self.next)?;
        let is_edited = self.next != self.last;
        Ok(is_edited.then(|| snapshot_delta(&self.last, &self.next)).transpose()?.map(Edits))
    }

    /// The recording so far.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The recording.
    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }
}
