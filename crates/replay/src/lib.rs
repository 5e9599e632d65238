//! # Replay — runs as files
//!
//! Records a scene of the galleries, replays a recording and compares every hash, compares two recordings,
//! and prints the summary of a recording. The program (`src/main.rs`) reads the command line; the rest is
//! here, compiled once per dimension.

#![expect(clippy::duplicate_mod, reason = "`both.rs` is compiled once against each dimension")]

mod failure;
pub mod flat;
pub mod solid;

pub use failure::Failure;

use std::fmt;

/// Scene and options of a recording.
#[derive(Clone, Debug)]
pub struct Request<'a> {
    /// The scene's name in its gallery.
    pub scene: &'a str,
    /// Number of steps; `None` selects the gallery's number.
    pub steps: Option<usize>,
    /// Whether the hashes after every stage are recorded as well.
    pub stages: bool,
}

/// Summary of a recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// Title of the recorded scene.
    pub title: String,
    /// The number of dimensions.
    pub dimension: u8,
    /// Version of the engine that wrote it.
    pub engine: String,
    /// Number of bodies after the last step.
    pub bodies: usize,
    /// Number of colliders after the last step.
    pub colliders: usize,
    /// Number of steps.
    pub steps: usize,
    /// Steps with edits before them.
    pub edited: Vec<usize>,
    /// The hash of the world after the last step.
    pub hash: u64,
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { title, dimension, engine, bodies, colliders, steps, edited, hash } = self;
        writeln!(f, "title      {title}")?;
        writeln!(f, "engine     {engine}, {dimension}D")?;
        writeln!(f, "world      {bodies} bodies, {colliders} colliders after the last step")?;
        writeln!(f, "steps      {steps}, {} of them after edits", edited.len())?;
        if let [first, ..] = edited[..] {
            writeln!(f, "first edit in front of step {first}")?;
        }
        write!(f, "hash       {hash:016x} after the last step")
    }
}

/// Replays a recording of either dimension.
///
/// # Errors
/// The replay diverges, or the data is not a recording.
pub fn play(recording: &[u8]) -> Result<Summary, Failure> {
    match solid::play(recording) {
        Err(Failure::OtherDimension) => flat::play(recording),
        result => result,
    }
}
