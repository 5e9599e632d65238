//! The replay of a recording.

use super::error::{Divergence, RecordingError, ReplayError};
use super::frame::{Frame, Opening, read_frame, read_opening};
use crate::api::snapshot::apply_snapshot_delta;
use crate::api::world::PhysicsWorld;
use crate::model::event::EventHandler;
use crate::model::hooks::PhysicsHooks;

/// Result of a replay.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Replayed {
    /// The replay took a step, and the world has the recorded hash.
    Step,
    /// The recording is at its end.
    End,
}

/// A replay of a [recording](super::Recorder), which compares the hash of every step.
pub struct Replay<'a> {
    opening: Opening,
    /// The frames that follow.
    frames: &'a [u8],
    world: PhysicsWorld,
    steps: usize,
    /// Whether the last frame contained edits.
    edited: bool,
}

impl<'a> Replay<'a> {
    /// Prepares the world of the first step.
    ///
    /// # Errors
    /// If the data is not a recording of this engine, or is damaged.
    pub fn new(recording: &'a [u8]) -> Result<Self, RecordingError> {
        let (opening, frames) = read_opening(recording)?;
        let world = PhysicsWorld::from_snapshot(&opening.snapshot)?;
        Ok(Self { opening, frames, world, steps: 0, edited: false })
    }

    /// The recorder's description.
    pub fn title(&self) -> &str {
        &self.opening.title
    }

    /// The version of the engine that made the recording.
    pub fn engine_version(&self) -> &str {
        &self.opening.engine
    }

    /// The world in its current state.
    pub fn world(&self) -> &PhysicsWorld {
        &self.world
    }

    /// Number of steps taken.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Number of remaining steps. For a truncated file, only complete steps count.
    pub fn steps_left(&self) -> usize {
        let (mut frames, mut steps) = (self.frames, 0);
        while let Ok((_, rest)) = read_frame(frames, steps) {
            frames = rest;
            steps += 1;
        }
        steps
    }

    /// Returns whether the recording has edits before the last step.
    pub fn was_edited(&self) -> bool {
        self.edited
    }

    /// Applies the recorded edits, takes the next step, and compares the hashes.
    ///
    /// # Errors
    /// If the world differs from the recorded one, or if the recording is damaged. A different world keeps
    /// its state after the step.
    pub fn step(&mut self) -> Result<Replayed, ReplayError> {
        self.step_with_events(&(), &())
    }

    /// The same as [`Self::step`], with the hooks of the recorded run.
    ///
    /// # Errors
    /// If the world differs from the recorded one, or if the recording is damaged. A different world keeps
    /// its state after the step.
    pub fn step_with_events(
        &mut self,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) -> Result<Replayed, ReplayError> {
        if self.frames.is_empty() {
            return Ok(Replayed::End);
        }
        let (frame, rest) = read_frame(self.frames, self.steps)?;
        self.apply_edits(&frame)?;
        self.world.physics_pipeline.set_stage_hashes(!frame.stages.is_empty());
        self.world.step_with_events(hooks, events);
        self.compare(&frame)?;
        self.frames = rest;
        self.steps += 1;
        Ok(Replayed::Step)
    }

    fn apply_edits(&mut self, frame: &Frame) -> Result<(), ReplayError> {
        self.edited = frame.edits.is_some();
        if let Some(edits) = &frame.edits {
            let edited = apply_snapshot_delta(&self.world.to_snapshot()?, &edits.0)?;
            self.world = PhysicsWorld::from_snapshot(&edited)?;
        }
        Ok(())
    }

    fn compare(&self, frame: &Frame) -> Result<(), ReplayError> {
        let found = self.world.hash();
        if found == frame.hash {
            return Ok(());
        }
        let stages = frame.stages.iter().zip(self.world.physics_pipeline.stage_hashes());
        let stage = stages.into_iter().find(|(recorded, found)| recorded != found);
        Err(ReplayError::Diverged(Divergence {
            step: self.steps,
            stage: stage.map(|(recorded, _)| recorded.0),
            body: frame.first_difference(&self.world),
            expected: frame.hash,
            found,
        }))
    }
}
