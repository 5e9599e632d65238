//! Bevy without a window or renderer, for the examples of bevy_rapier: a fixed number of updates, and one line of measurements.
//!
//! Each example gets the line `use headless::DefaultPlugins;`, which shadows the name of Bevy's prelude. The executor has one
//! thread, and every update advances the clock by 1/60 s, so that two runs of an example differ by the physics only.

use std::time::{Duration, Instant};

use bevy::app::{AppExit, PluginGroupBuilder, PluginsState, TaskPoolPlugin};
use bevy::asset::AssetPlugin;
use bevy::diagnostic::FrameCountPlugin;
use bevy::gizmos::GizmoPlugin;
use bevy::image::ImagePlugin;
use bevy::input::InputPlugin;
use bevy::mesh::MeshPlugin;
use bevy::prelude::*;
use bevy::scene::ScenePlugin;
use bevy::time::{TimePlugin, TimeUpdateStrategy};
use bevy::window::WindowPlugin;

use crate::physics::plugin::PhysicsSet;
use crate::physics::plugin::context::{RapierContextSimulation, RapierRigidBodySet};

/// Number of updates, unless the example exits earlier or the variable `UPDATES` sets another number.
const UPDATES: usize = 360;

/// The plugins of Bevy that the examples need, and the measurement.
pub struct DefaultPlugins;

impl PluginGroup for DefaultPlugins {
    fn build(self) -> PluginGroupBuilder {
        PluginGroupBuilder::start::<Self>()
            .add(TaskPoolPlugin::default())
            .add(FrameCountPlugin)
            .add(TimePlugin)
            .add(TransformPlugin)
            .add(InputPlugin)
            .add(WindowPlugin::default())
            .add(AssetPlugin::default())
            .add(ImagePlugin::default())
            .add(MeshPlugin)
            .add(ScenePlugin)
            .add(GizmoPlugin)
            .add(Measurement)
    }
}

/// Runs and measures the app.
struct Measurement;

impl Plugin for Measurement {
    fn build(&self, app: &mut App) {
        // Messages of `info!` and `warn!` are compared between the runs, so they have no time and no colour.
        tracing_subscriber::fmt().without_time().with_ansi(false).with_max_level(tracing_subscriber::filter::LevelFilter::INFO).init();
        app.insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs_f64(1.0 / 60.0)))
            .init_resource::<Record>()
            .add_systems(
                PostUpdate,
                (
                    start.after(PhysicsSet::SyncBackend).before(PhysicsSet::StepSimulation),
                    stop.after(PhysicsSet::StepSimulation).before(PhysicsSet::Writeback),
                    count.after(PhysicsSet::Writeback),
                ),
            )
            .set_runner(run);
    }
}

/// Times of the steps, and the state of the physics after each.
#[derive(Resource, Default)]
struct Record {
    started: Option<Instant>,
    /// Time of each step, s.
    times: Vec<f64>,
    /// Pairs with active contacts after each step.
    pairs: Vec<usize>,
    /// Bodies after the last step.
    bodies: usize,
    /// Dynamic bodies that do not sleep after the last step.
    awake: usize,
}

fn start(mut record: ResMut<Record>) {
    record.started = Some(Instant::now());
}

fn stop(mut record: ResMut<Record>) {
    if let Some(started) = record.started.take() {
        record.times.push(started.elapsed().as_secs_f64());
    }
}

fn count(mut record: ResMut<Record>, contexts: Query<(&RapierContextSimulation, &RapierRigidBodySet)>) {
    let active = |simulation: &RapierContextSimulation| simulation.narrow_phase.contact_pairs().filter(|pair| pair.has_any_active_contact()).count();
    record.pairs.push(contexts.iter().map(|(simulation, _)| active(simulation)).sum());
    record.bodies = contexts.iter().map(|(_, set)| set.bodies.len()).sum();
    record.awake = contexts.iter().flat_map(|(_, set)| set.bodies.iter()).filter(|(_, body)| body.is_dynamic() && !body.is_sleeping()).count();
}

/// Updates the app, and prints the record as the last line.
fn run(mut app: App) -> AppExit {
    while app.plugins_state() == PluginsState::Adding {
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    app.finish();
    app.cleanup();
    let updates = std::env::var("UPDATES").ok().and_then(|text| text.parse().ok()).unwrap_or(UPDATES);
    let mut exit = None;
    for _ in 0..updates {
        app.update();
        exit = app.should_exit();
        if exit.is_some() {
            break;
        }
    }
    print(app.world().resource::<Record>());
    exit.unwrap_or(AppExit::Success)
}

fn print(record: &Record) {
    let mut times = record.times.clone();
    times.sort_by(f64::total_cmp);
    let steps = times.len();
    let median = times.get(steps / 2).copied().unwrap_or(0.0);
    let mean = times.iter().sum::<f64>() / steps.max(1) as f64;
    let pairs = record.pairs.iter().sum::<usize>() as f64 / record.pairs.len().max(1) as f64;
    println!(
        "measured steps={steps} median={median:.9} mean={mean:.9} pairs={} pairs_mean={pairs:.1} bodies={} awake={}",
        record.pairs.last().copied().unwrap_or(0),
        record.bodies,
        record.awake
    );
}
