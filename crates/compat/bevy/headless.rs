//! Bevy without a window or renderer, for the examples of bevy_rapier: a fixed number of updates, and one
//! line of measurements.
//!
//! Each example gets the line `use headless::DefaultPlugins;`, which shadows the name of Bevy's prelude.
//! The executor has one thread, and every update advances the clock by 1/60 s, so that two runs of an
//! example differ by the physics only.

use std::time::Duration;

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
use cpu_time::ThreadTime;
use tracing_subscriber::filter::LevelFilter;

use crate::physics::plugin::PhysicsSet;
use crate::physics::plugin::context::{RapierContextSimulation, RapierRigidBodySet};

/// Number of updates, unless the example exits earlier or the variable `UPDATES` sets another number.
const UPDATES: usize = 360;

/// Contacts nearer than this touch, in units of length: the prediction distance of Rapier 0.32. The
/// engine's own is ten times as far, so its numbers of active contacts are not comparable.
const TOUCHING_DISTANCE_MAX: f32 = 0.002;

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
        // Messages of `info!` and `warn!` are compared between the runs, so they have no time and no
        // colour.
        tracing_subscriber::fmt()
            .without_time()
            .with_ansi(false)
            .with_max_level(LevelFilter::INFO)
            .init();
        app.insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs_f64(
            1.0 / 60.0,
        )))
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
    /// Time of the thread on the processor when the step began.
    started: Option<Duration>,
    /// Time of each step on the processor, s. Other programs on the machine do not add to it.
    times: Vec<f64>,
    /// Pairs with active contacts after the last step.
    active: usize,
    /// Pairs that touch after the last step.
    touching: usize,
    /// Pairs that touch, summed over the steps.
    touching_total: usize,
    /// Bodies after the last step.
    bodies: usize,
}

fn start(mut record: ResMut<Record>) {
    record.started = Some(ThreadTime::now().as_duration());
}

fn stop(mut record: ResMut<Record>) {
    if let Some(started) = record.started.take() {
        let time = ThreadTime::now().as_duration().saturating_sub(started);
        record.times.push(time.as_secs_f64());
    }
}

fn count(
    mut record: ResMut<Record>,
    contexts: Query<(&RapierContextSimulation, &RapierRigidBodySet)>,
) {
    let (mut active, mut touching) = (0, 0);
    for (simulation, _) in &contexts {
        let distance = TOUCHING_DISTANCE_MAX * simulation.integration_parameters.length_unit;
        for pair in simulation.narrow_phase.contact_pairs() {
            let mut contacts = pair.manifolds.iter().flat_map(|one| &one.data.solver_contacts);
            active += usize::from(pair.has_any_active_contact());
            touching += usize::from(contacts.any(|contact| contact.dist < distance));
        }
    }
    record.active = active;
    record.touching = touching;
    record.touching_total += touching;
    record.bodies = contexts.iter().map(|(_, set)| set.bodies.len()).sum();
}

/// Updates the app, and prints the record as the last line.
fn run(mut app: App) -> AppExit {
    while app.plugins_state() == PluginsState::Adding {
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    app.finish();
    app.cleanup();
    let updates =
        std::env::var("UPDATES").ok().and_then(|text| text.parse().ok()).unwrap_or(UPDATES);
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
    let mean = |total: f64| total / steps.max(1) as f64;
    println!(
        "measured steps={steps} median={median:.9} mean={:.9} active={} touching={} touching_mean={:.1} bodies={}",
        mean(times.iter().sum()),
        record.active,
        record.touching,
        mean(record.touching_total as f64),
        record.bodies,
    );
}
