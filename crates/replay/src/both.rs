//! Recording and replaying in one dimension: `rapier` is the engine, `examples` the gallery.

use super::examples::{self, Scene};
use super::rapier::prelude::*;
use crate::{Failure, Request, Summary};
use gallery::Progress;

/// The number of dimensions.
const DIMENSION: u8 = DIM as u8;

fn refused(error: RecordingError) -> Failure {
    match error {
        RecordingError::Snapshot(SnapshotError::Dimension { .. }) => Failure::OtherDimension,
        error => Failure::Recording(error.to_string()),
    }
}

/// Records a scene of the gallery.
///
/// # Errors
/// The scene does not exist, or its world cannot be saved.
pub fn record(request: &Request<'_>) -> Result<Vec<u8>, Failure> {
    let Request { scene, steps, stages } = *request;
    let info = examples::find(scene)
        .ok_or_else(|| Failure::NoScene { scene: scene.to_string(), dimension: DIMENSION })?;
    let steps = steps.unwrap_or(info.steps);
    let mut scene = (info.build)();
    let title = title_of(info.name);
    let mut recorder = Recorder::new(&scene.world, &title).map_err(refused)?;
    if stages {
        recorder = recorder.with_stage_hashes();
    }
    let mut progress = Progress::new(&title, title.len(), steps);
    for done in 0..steps {
        progress.advance(done);
        scene
            .step_by(|world, hooks, events| recorder.step_with_events(world, hooks, events))
            .map_err(refused)?;
    }
    progress.clear();
    Ok(recorder.into_bytes())
}

fn title_of(scene: &str) -> String {
    format!("{DIMENSION}d/{scene}")
}

/// Returns the scene of a recording, with the hooks that the replay needs.
fn scene_of(title: &str) -> Option<Scene> {
    let info = examples::SCENES.iter().find(|info| title_of(info.name) == title)?;
    Some((info.build)())
}

/// Replays a recording to its end.
///
/// # Errors
/// The replay diverges, or the data is not a recording of this dimension.
pub fn play(recording: &[u8]) -> Result<Summary, Failure> {
    let mut replay = Replay::new(recording).map_err(refused)?;
    let title = replay.title().to_string();
    let scene = scene_of(&title);
    let hooks = scene.as_ref().map_or(&() as &dyn PhysicsHooks, Scene::step_hooks);
    let mut edited = Vec::new();
    let mut progress = Progress::new(&title, title.len(), replay.steps_left());
    while Replayed::Step == replay.step_with_events(hooks, &()).map_err(failed)? {
        if replay.was_edited() {
            edited.push(replay.steps() - 1);
        }
        progress.advance(replay.steps());
    }
    progress.clear();
    let world = replay.world();
    Ok(Summary {
        title,
        dimension: DIMENSION,
        engine: replay.engine_version().to_string(),
        bodies: world.bodies.len(),
        colliders: world.colliders.len(),
        steps: replay.steps(),
        edited,
        hash: world.hash(),
    })
}

fn failed(error: ReplayError) -> Failure {
    match error {
        ReplayError::Recording(error) => refused(error),
        error => Failure::Diverged(error.to_string()),
    }
}

/// Compares two recordings, of any dimension.
///
/// # Errors
/// The recordings differ, or one of them is not a recording.
pub fn compare(one: &[u8], two: &[u8]) -> Result<(), Failure> {
    match compare_recordings(one, two).map_err(refused)? {
        Some(difference) => Err(Failure::Differ(difference.to_string())),
        None => Ok(()),
    }
}
