//! Time per step of 1,000 and 10,000 awake bodies, with the plugin and in the engine alone.
//!
//! The first argument is the number of repetitions. Each number is the mean over the steps of the minimum
//! over the repetitions.

use bevy::app::{RunFixedMainLoop, RunFixedMainLoopSystems};
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use rapier3d_bevy::rapier::math as engine;
use rapier3d_bevy::rapier::prelude::{ColliderBuilder, PhysicsWorld as Engine, RigidBodyBuilder};
use std::time::{Duration, Instant};

/// Measured steps.
const STEPS: usize = 60;
/// Bodies above each other.
const LAYERS: usize = 10;
const HALF_EXTENT: Scalar = 0.5;

fn main() {
    let repetitions = std::env::args().nth(1).map_or(1, |count| count.parse().expect("a number"));
    println!("milliseconds per step     engine    step  prepare  write back  interpolate");
    for scene in [DRIFTING, TOWERS] {
        for count in [1_000, 10_000] {
            let [alone, laps] = scene.measure(count, repetitions);
            let title = format!("{count} {}", scene.name);
            let [interpolate, prepare, step, write_back] = [1, 2, 3, 4].map(|lap| laps[lap]);
            print!("{title:<24}{:8.3}{step:8.3}", alone[STEP]);
            println!("{prepare:9.3}{write_back:12.3}{interpolate:13.3}");
        }
    }
}

/// Boxes in a lattice.
struct Scene {
    name: &'static str,
    spacing: f32,
    velocity: Velocity,
    gravity: Vector,
}

/// Boxes without contacts.
const DRIFTING: Scene = Scene {
    name: "drifting",
    spacing: 2.0,
    velocity: Velocity { linear: Vector::X, angular: Vector::Y },
    gravity: Vector::ZERO,
};

/// Towers, whose boxes are too young to sleep.
const TOWERS: Scene = Scene {
    name: "in towers of 10",
    spacing: 1.0625,
    velocity: Velocity { linear: Vector::ZERO, angular: Vector::ZERO },
    gravity: Vector::new(0.0, -9.81, 0.0),
};

/// Mean milliseconds of each lap of a frame.
type Laps = [f64; LAPS];

impl Scene {
    /// The times of the engine alone, and those with the plugin.
    fn measure(&self, count: usize, repetitions: usize) -> [Laps; 2] {
        let mut minima = [[[Duration::MAX; LAPS]; STEPS]; 2];
        for _ in 0..repetitions {
            let (mut app, mut engine) = (self.app(count), self.engine(count));
            for step in 0..STEPS {
                let mut alone = [Duration::ZERO; LAPS];
                let start = Instant::now();
                engine.step();
                alone[STEP] = start.elapsed();
                let laps = frame(&mut app);
                for (minima, laps) in minima.iter_mut().zip([alone, laps]) {
                    for (minimum, lap) in minima[step].iter_mut().zip(laps) {
                        *minimum = lap.min(*minimum);
                    }
                }
            }
            let physics = app.world().resource::<PhysicsWorld>();
            assert_eq!(physics.engine.hash(), engine.hash());
            assert_eq!(engine.active_bodies().len(), count);
        }
        minima.map(|steps| {
            core::array::from_fn(|lap| {
                let sum: Duration = steps.iter().map(|laps| laps[lap]).sum();
                sum.as_secs_f64() * 1.0e3 / STEPS as f64
            })
        })
    }

    fn places(&self, count: usize) -> impl Iterator<Item = Vec3> {
        let side = count.div_ceil(LAYERS).isqrt();
        let spacing = self.spacing;
        (0..count).map(move |i| {
            let (column, layer) = (i / LAYERS, i % LAYERS);
            let cell = [(column % side) as f32, 0.5 + layer as f32, (column / side) as f32];
            Vec3::from_array(cell) * spacing
        })
    }

    /// An app after its first step, whose frames last one step.
    fn app(&self, count: usize) -> App {
        let mut app = App::new();
        app.add_plugins((MinimalPlugins, TransformPlugin))
            .add_plugins(PhysicsPlugin::default().with_gravity(self.gravity))
            .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs(1) / 64));
        add_marks(&mut app);
        let world = app.world_mut();
        world.spawn(Collider::halfspace(Vector::Y));
        for place in self.places(count) {
            let collider = Collider::cuboid(HALF_EXTENT, HALF_EXTENT, HALF_EXTENT);
            let transform = Transform::from_translation(place);
            world.spawn((RigidBody::Dynamic, collider, self.velocity, transform));
        }
        app.finish();
        // The first frame has no duration.
        app.update();
        app.update();
        app
    }

    /// The engine's world after its first step.
    fn engine(&self, count: usize) -> Engine {
        let vector = |vector: Vector| engine::Vector::from_array(vector.to_array());
        let mut world = Engine::new();
        world.gravity = vector(self.gravity);
        world.integration_parameters.dt = 1.0 / 64.0;
        let bodies: Vec<_> = self
            .places(count)
            .map(|place| {
                let place = engine::Vector::from_array(place.to_array().map(Scalar::from));
                let body = RigidBodyBuilder::dynamic().translation(place);
                let body = body.linvel(vector(self.velocity.linear));
                world.insert_body(body.angvel(vector(self.velocity.angular)))
            })
            .collect();
        world.insert_collider(ColliderBuilder::halfspace(engine::Vector::Y), None);
        for body in bodies {
            let collider = ColliderBuilder::cuboid(HALF_EXTENT, HALF_EXTENT, HALF_EXTENT);
            world.insert_collider(collider, Some(body));
        }
        world.step();
        world
    }
}

/// Parts of a frame: all that is not the plugin's, and the stages of the plugin.
const LAPS: usize = 5;
const OTHER: usize = 0;
const INTERPOLATE: usize = 1;
const PREPARE: usize = 2;
const STEP: usize = 3;
const WRITE_BACK: usize = 4;

#[derive(Resource)]
struct Clock {
    last: Instant,
    laps: [Duration; LAPS],
}

/// Adds the time since the last mark to a lap.
fn mark<const LAP: usize>(mut clock: ResMut<Clock>) {
    let now = Instant::now();
    let time = now - clock.last;
    clock.laps[LAP] += time;
    clock.last = now;
}

fn add_marks(app: &mut App) {
    use PhysicsSystems::{Interpolate, Prepare, Report, Restore, Step, WriteBack};
    let restore = (mark::<OTHER>.before(Restore), mark::<INTERPOLATE>.after(Restore));
    let step = (
        mark::<OTHER>.before(Prepare),
        mark::<PREPARE>.after(Prepare).before(Step),
        mark::<STEP>.after(Step).before(WriteBack),
        mark::<WRITE_BACK>.after(Report),
    );
    let interpolate = (mark::<OTHER>.before(Interpolate), mark::<INTERPOLATE>.after(Interpolate));
    let after = RunFixedMainLoopSystems::AfterFixedMainLoop;
    app.insert_resource(Clock { last: Instant::now(), laps: [Duration::ZERO; LAPS] })
        .add_systems(FixedFirst, restore)
        .add_systems(FixedPostUpdate, step)
        .add_systems(RunFixedMainLoop, interpolate.in_set(after));
}

/// The times of a frame with one step.
fn frame(app: &mut App) -> [Duration; LAPS] {
    app.world_mut().resource_mut::<Clock>().laps = [Duration::ZERO; LAPS];
    app.update();
    app.world().resource::<Clock>().laps
}
